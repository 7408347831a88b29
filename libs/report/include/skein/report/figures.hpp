// SPDX-License-Identifier: Apache-2.0
// Figures of a run for a paper: SVG documents that need nothing else, dark on white. Pure
// functions.
#pragma once

#include <string>

#include "skein/report/journal.hpp"
#include "skein/report/run_info.hpp"

namespace skein::report {

/// Where all vehicles went, from above, with the places where they met. Source: M figure 6.
std::string trajectories_svg(const RunInfo& info, const Journal& journal);

/// What each vehicle did when, a row for each, and the temporal messages between them: one that all
/// heard at about the same time is one vertical bar, with a dot at its sender and a tick at who
/// heard it. Source: M figure 7.
std::string chronology_svg(const RunInfo& info, const Journal& journal);

}  // namespace skein::report
