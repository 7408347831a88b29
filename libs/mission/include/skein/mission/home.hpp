// SPDX-License-Identifier: Apache-2.0
// The place that each UAV has of its own.
#pragma once

#include <string_view>

namespace skein::mission {

/// Whether a name of a place, in whatever case, means where the UAV that reads it took off and
/// lands (`home`; `zero` in the seeds of the domain). No place of a scenario may have it: it would
/// be the home of all.
bool means_home(std::string_view place);

}  // namespace skein::mission
