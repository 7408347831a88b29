// SPDX-License-Identifier: Apache-2.0
// A patrol as a plane path of a given duration.
#pragma once

#include <functional>
#include <vector>

#include "patrol/idleness.hpp"
#include "patrol/laps.hpp"
#include "skein/refiners/budget.hpp"

namespace skein::refiners {

/// Start, speed and duration of a patrol.
struct PatrolTask {
  world::Vector2 start = world::Vector2::Zero();
  double heading = 0;
  double speed = 1;     ///< [m/s]
  double duration = 0;  ///< [s]
  std::uint64_t seed = 1;
};

struct PlanePatrol {
  std::vector<world::Vector2> way;  ///< from the start; no longer than speed × duration
  bool complete = true;             ///< whether it lasts for the whole duration
};
/// Called for every patrol that is better than those before: longer, or complete and with less
/// idleness. With a deadline also for parts of the first patrol, each about twice as long as the
/// last.
using TakePatrol = std::function<void(const PlanePatrol&)>;

/// Visits all blocks in turn, repeatedly.
void fly_in_turn(const LapGround& ground, const PatrolSight& sight, const PatrolTask& task,
                 Countdown& countdown, const TakePatrol& take);

/// Tries laps of several lengths, and all blocks in turn, each over the first part of the time, and
/// plans the most promising over the whole. Criterion: the larger of mean idleness and worst risk ×
/// idleness, each relative to that of visiting all blocks in turn. Precondition: at least one
/// block, every block reachable from every other, and one from the start.
void plan_patrol(const LapGround& ground, const PatrolSight& sight, const PatrolTask& task,
                 Countdown& countdown, const TakePatrol& take);

/// Gradient rule of the thesis: step to the neighbouring cell with the steepest fall of potential.
/// Source: T IV.2.2.
struct GradientRule {
  double time_scale = 600;  ///< [s]
};
/// The input of the gradient rule. All must outlive the flight.
struct GradientGround {
  const PatrolField& field;
  const PatrolSpace& space;
  const PatrolSight& sight;
};
void fly_gradient(const GradientGround& ground, const PatrolTask& task, const GradientRule& rule,
                  Countdown& countdown, const TakePatrol& take);

/// ΔT of the thesis per cell of the field at the end of a path, updated after each cell's length
/// flown (or half a footprint, if that is more). Computed backwards from the end, until the rest
/// contributes less than 1 ms. Empty: the deadline of the sight passed more than some 20 ms before
/// the computation was done.
std::vector<double> fading_idleness(const PatrolField& field, const PatrolSight& sight,
                                    const std::vector<world::Vector2>& way, double speed);

}  // namespace skein::refiners
