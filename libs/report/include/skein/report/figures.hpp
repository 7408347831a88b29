// SPDX-License-Identifier: Apache-2.0
// Figures of a run for a paper: self-contained SVG documents, dark on white. Pure functions.
#pragma once

#include <string>

#include "skein/report/journal.hpp"
#include "skein/report/run_info.hpp"

namespace skein::report {

/// The tracks of all vehicles, seen from above, with the places of their synchronisations. Source:
/// M figure 6.
std::string trajectories_svg(const RunInfo& info, const Journal& journal);

/// The tasks of each vehicle over time, a row for each vehicle, and the temporal messages between
/// them: a message received by several vehicles within a second is one vertical bar, with a dot at
/// the sender and a tick at each receiver. Source: M figure 7.
std::string chronology_svg(const RunInfo& info, const Journal& journal);

}  // namespace skein::report
