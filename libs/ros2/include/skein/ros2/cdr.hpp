// SPDX-License-Identifier: Apache-2.0
// Messages as bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/ros2/messages.hpp"

namespace skein::ros2 {

using Bytes = std::vector<std::uint8_t>;

/// OMG CDR version 1, little-endian, behind its 4-byte header: what every middleware of ROS 2
/// writes and reads.
Bytes to_cdr(const Message& message);

/// The longest text that is taken from others [byte].
inline constexpr std::size_t kLongestText = 65'536;

/// What a std_msgs/String says, of either byte order; or why these bytes are none.
Result<std::string, Failure> text_of(std::span<const std::uint8_t> bytes);

}  // namespace skein::ros2
