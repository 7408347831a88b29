// SPDX-License-Identifier: Apache-2.0
// A scenario played by daemons over DDS, to be judged.
#pragma once

#include "skein/storm_tool/judge.hpp"

namespace skein::storm_tool {

/// Starts the daemons beside this program and waits for the end of the mission, as `skein run`
/// does. A run that fails breaks the law "crash". Precondition: `options.over_dds_at` is set, the
/// scenario of `one` is valid.
Verdict judged_over_dds(const Case& one, const JudgeOptions& options);

}  // namespace skein::storm_tool
