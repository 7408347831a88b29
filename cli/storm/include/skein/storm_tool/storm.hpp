// SPDX-License-Identifier: Apache-2.0
// `skein storm`: seeded missions in which things go wrong, judged by laws that know no plan.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "skein/storm_tool/judge.hpp"

namespace skein::storm_tool {

struct StormOptions {
  std::vector<std::string> scenarios;  ///< files; none: missions drawn at random
  std::string seeds = "1..100";        ///< A..B: one run each, of each scenario
  /// Where scenarios that break a law are kept, small; empty: nowhere.
  std::string save = "out/storm";
  bool shrink = true;
  bool list_laws = false;
  bool json = false, quiet = false;
  bool on_terminal = false;  ///< progress is one line that is written over
  std::string models;        ///< folder scenarios/ of Skein, for missions drawn; empty: found
  JudgeOptions judge;
};

/// Each scenario is played once as it is, and then once a seed with troubles drawn from it: daemons
/// that die and come back, cuts and losses of the radio, faults of vehicles and devices, planning
/// that takes long. Of each law that a run breaks the scenario is kept, as small as it could be
/// made. Exit codes: 0 no law was broken, 1 some, 2 wrong input.
int storm(const StormOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::storm_tool
