// SPDX-License-Identifier: Apache-2.0
// Cycles in which some blocks are visited more often than others, to be flown repeatedly.
#pragma once

#include <vector>

#include "patrol/laps.hpp"
#include "skein/refiners/budget.hpp"

namespace skein::refiners {

/// Reference values of idleness: at these figures each of the two criteria counts 1.
struct CycleGoal {
  double mean_idleness = 1;        ///< weighted by risk [s], > 0
  double worst_risk_idleness = 1;  ///< [s], > 0
};

/// Bounds of the search; a step is one evaluated cycle.
struct CycleTime {
  Countdown& countdown;
  Deadline& deadline;
};

/// `times` rounds over all blocks as one cycle, improved by local search: visits are removed from
/// some rounds and inserted elsewhere, parts reversed and moved, as long as idleness decreases.
/// Unlike laps planned one by one, each change is evaluated on the whole cycle. Every block is
/// visited at least once. When the time is up, returns the result so far.
/// Cost: O(visits × blocks) for each of some twenty passes: 0.1 s for twice 256 blocks.
std::vector<Visit> weighted_cycle(const LapGround& ground, const CycleGoal& goal, std::size_t times,
                                  const CycleTime& time);

/// The same search from a given cycle. Precondition: it visits every block.
std::vector<Visit> improved_cycle(const LapGround& ground, const CycleGoal& goal,
                                  std::vector<Visit> cycle, const CycleTime& time);

}  // namespace skein::refiners
