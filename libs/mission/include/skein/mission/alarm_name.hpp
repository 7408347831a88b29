// SPDX-License-Identifier: Apache-2.0
// Names of the ground station's alarms in missions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace skein::mission {

/// "alarm:1".
std::string name_of_alarm(std::uint64_t id);

/// Whether `name` has the form of such a name; the alarm need not exist.
bool is_name_of_alarm(std::string_view name);

}  // namespace skein::mission
