// SPDX-License-Identifier: Apache-2.0
// Names as ROS 2 has them, and as its middleware mangles them.
#pragma once

#include <string>
#include <string_view>

namespace skein::ros2 {

/// One token of a topic's name: letters, digits and single underscores, no digit first. What else a
/// name has becomes underscores, so two names may give one token. Never empty.
std::string token_of(std::string_view name);

/// "skein/marvin/fix" becomes "rt/skein/marvin/fix". Source: ROS 2 design, "Topic and Service name
/// mapping to DDS".
std::string topic_of(std::string_view name);

}  // namespace skein::ros2
