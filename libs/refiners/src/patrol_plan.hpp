// SPDX-License-Identifier: Apache-2.0
// A patrol as a way over the plane, for a given time.
#pragma once

#include <optional>
#include <vector>

#include "patrol_idleness.hpp"
#include "patrol_laps.hpp"
#include "skein/refiners/budget.hpp"

namespace skein::refiners {

/// Where a patrol begins, how fast and how long it goes.
struct PatrolTask {
  world::Vector2 start = world::Vector2::Zero();
  double heading = 0;
  double speed = 1;     ///< [m/s]
  double duration = 0;  ///< [s]
};

struct PlanePatrol {
  std::vector<world::Vector2> way;  ///< from the start; no longer than speed × duration
  bool complete = true;             ///< as long as that
};

/// Tries laps of several lengths, and visiting everything in turn, each over the first part of the
/// time, flies the most promising over the whole, and gives the best: that of which the worse is
/// least of mean idleness and worst risk × idleness, each against what everything in turn gives.
/// Precondition: at least one block, and every block reachable from every other and one from the
/// start.
PlanePatrol plan_patrol(const LapGround& ground, const PatrolSight& sight, const PatrolTask& task,
                        Countdown& countdown);

/// Step by step to the neighbouring cell with the steepest fall of potential, by the thesis.
/// Source: T IV.2.2.
struct GradientRule {
  double time_scale = 600;  ///< [s]
};
PlanePatrol fly_gradient(const PatrolField& field, const PatrolSpace& space,
                         const PatrolSight& sight, const PatrolTask& task, const GradientRule& rule,
                         Countdown& countdown);

/// ΔT of the thesis per cell of the field at the end of a way, updated every time another cell's
/// length has been flown, or half a footprint if that is more.
std::vector<double> fading_idleness(const PatrolField& field, const PatrolSight& sight,
                                    const std::vector<world::Vector2>& way, double speed);

}  // namespace skein::refiners
