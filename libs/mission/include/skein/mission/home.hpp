// SPDX-License-Identifier: Apache-2.0
// The name of each UAV's own home place.
#pragma once

#include <string_view>

namespace skein::mission {

/// Whether a place name, regardless of case, means the home of the UAV that reads it, where it
/// takes off and lands (`home`; `zero` in the seeds' domain). No place of a scenario may have such
/// a name, which would mean the same place for all UAVs.
bool means_home(std::string_view place);

}  // namespace skein::mission
