// SPDX-License-Identifier: Apache-2.0
// A closed walk improved as a whole by simulated annealing.
#pragma once

#include <cstdint>

#include "patrol/cycle.hpp"
#include "patrol/walk_graph.hpp"

namespace skein::refiners {

/// How a walk is annealed, in the measure of the goal: 1 is what the goals allow.
struct Cooling {
  double from = 6e-4, to = 8e-6;          ///< temperatures, falling by a constant factor
  std::uint64_t changes_a_place = 12000;  ///< so many changes are tried for each place
  std::size_t visits_a_place = 4;         ///< in the mean; longer walks are not tried
  bool looks_elsewhere = false;           ///< as in WalkMeasure
  std::uint64_t seed = 1;
};

/// Begins with every place in turn and tries small changes of random places of the walk: corners
/// cut the other way, detours left out and put in, parts turned round and moved. What makes it
/// better is taken, what makes it worse sometimes, ever seldomer. What is too long for the goal of
/// the worst counts little at first and more and more. A walk that visits every place; nothing when
/// the time is up before there is one that is whole. A step of the countdown is 64 changes tried.
/// Cost: some 0.2 µs a change, 0.6 s for 256 places.
Walk annealed_walk(const WalkGraph& graph, const CycleGoal& goal, double speed,
                   const Cooling& cooling, const CycleTime& time);

}  // namespace skein::refiners
