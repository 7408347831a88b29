// SPDX-License-Identifier: Apache-2.0
// A round in which some blocks are visited more often than others, to be flown again and again.
#pragma once

#include <vector>

#include "patrol/laps.hpp"
#include "skein/refiners/budget.hpp"

namespace skein::refiners {

/// What idleness is measured by: at these figures each of the two counts 1.
struct CycleGoal {
  double mean_idleness = 1;        ///< weighted by risk [s], > 0
  double worst_risk_idleness = 1;  ///< [s], > 0
};

/// How long is searched: a step is a round judged.
struct CycleTime {
  Countdown& countdown;
  Deadline& deadline;
};

/// The whole round, several times over, improved by local search: pieces of lanes are left out of
/// some of the times and put in elsewhere, parts turned round and moved, as long as it makes the
/// idleness less. Unlike laps that are planned one by one, it sees what a change does to every
/// visit before and after. Every block is visited at least once. Ends as it is when the time is up.
/// Cost: O(visits × blocks) for each of some twenty passes: 0.1 s for twice 256 blocks.
std::vector<Visit> weighted_cycle(const LapGround& ground, const CycleGoal& goal, std::size_t times,
                                  const CycleTime& time);

/// The same search from a round that is there already. Precondition: it visits every block.
std::vector<Visit> improved_cycle(const LapGround& ground, const CycleGoal& goal,
                                  std::vector<Visit> cycle, const CycleTime& time);

}  // namespace skein::refiners
