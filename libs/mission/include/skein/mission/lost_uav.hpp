// SPDX-License-Identifier: Apache-2.0
// The messages by which UAVs are told that another one is lost, or found again.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace skein::mission {

/// "lost heliv", the text of a PROCESS-MSG. Conditions of tasks may name it as any other message.
std::string lost_message(std::string_view uav);
/// The UAV that the message declares lost; absent: it is another message.
std::optional<std::string> uav_lost_in(std::string_view message);

/// "found heliv": it is not lost after all.
std::string found_message(std::string_view uav);
std::optional<std::string> uav_found_in(std::string_view message);

}  // namespace skein::mission
