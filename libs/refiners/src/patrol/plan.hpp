// SPDX-License-Identifier: Apache-2.0
// A patrol as a way over the plane, for a given time.
#pragma once

#include <functional>
#include <vector>

#include "patrol/idleness.hpp"
#include "patrol/laps.hpp"
#include "skein/refiners/budget.hpp"

namespace skein::refiners {

/// Where a patrol begins, how fast and how long it goes.
struct PatrolTask {
  world::Vector2 start = world::Vector2::Zero();
  double heading = 0;
  double speed = 1;     ///< [m/s]
  double duration = 0;  ///< [s]
  std::uint64_t seed = 1;
};

struct PlanePatrol {
  std::vector<world::Vector2> way;  ///< from the start; no longer than speed × duration
  bool complete = true;             ///< as long as that
};
/// Takes every patrol that is better than those before: longer, or as long as it is to be and less
/// idle. With a deadline parts of the first one are told too, each about twice as long as the last.
using TakePatrol = std::function<void(const PlanePatrol&)>;

/// Everything in turn, again and again.
void fly_in_turn(const LapGround& ground, const PatrolSight& sight, const PatrolTask& task,
                 Countdown& countdown, const TakePatrol& take);

/// Tries laps of several lengths, and visiting everything in turn, each over the first part of the
/// time, and flies the most promising over the whole. That is best of which the worse is least of
/// mean idleness and worst risk × idleness, each against what everything in turn gives.
/// Precondition: at least one block, and every block reachable from every other and one from the
/// start.
void plan_patrol(const LapGround& ground, const PatrolSight& sight, const PatrolTask& task,
                 Countdown& countdown, const TakePatrol& take);

/// Step by step to the neighbouring cell with the steepest fall of potential, by the thesis.
/// Source: T IV.2.2.
struct GradientRule {
  double time_scale = 600;  ///< [s]
};
/// What it is flown over. All must outlive the flight.
struct GradientGround {
  const PatrolField& field;
  const PatrolSpace& space;
  const PatrolSight& sight;
};
void fly_gradient(const GradientGround& ground, const PatrolTask& task, const GradientRule& rule,
                  Countdown& countdown, const TakePatrol& take);

/// ΔT of the thesis per cell of the field at the end of a way, updated every time another cell's
/// length has been flown, or half a footprint if that is more. Reckoned from the end back to where
/// the rest weighs less than a thousandth of a second. Empty: the deadline of the sight has passed,
/// and not even some 20 ms more were enough.
std::vector<double> fading_idleness(const PatrolField& field, const PatrolSight& sight,
                                    const std::vector<world::Vector2>& way, double speed);

}  // namespace skein::refiners
