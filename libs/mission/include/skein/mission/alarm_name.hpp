// SPDX-License-Identifier: Apache-2.0
// How missions name an alarm of the ground station's.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace skein::mission {

/// "alarm:1".
std::string name_of_alarm(std::uint64_t id);

/// Whether it is such a name, of an alarm that is known or not.
bool is_name_of_alarm(std::string_view name);

}  // namespace skein::mission
