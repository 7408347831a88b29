// SPDX-License-Identifier: Apache-2.0
// The direction to sweep a region in, and the lanes in their order.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "coverage/block_order.hpp"
#include "skein/refiners/budget.hpp"
#include "skein/refiners/coverage.hpp"

namespace skein::refiners {

struct SweepTask {
  Region region;
  double swath = 0;
  SweepMode mode = SweepMode::kLeastTime;
  double direction = 0;  ///< for kGiven [rad]
  SweepEnds ends;        ///< in the local frame
  /// The part of the wind that moves the vehicle [m/s]: two lanes with and against it take longer
  /// than in still air.
  world::Vector2 wind = world::Vector2::Zero();
  /// Whether a lane is free; empty: always.
  std::function<bool(const world::Vector2&, const world::Vector2&)> is_free;
  /// Polled before each set of lanes, which takes milliseconds for many corners; empty: no limit.
  std::function<bool()> time_is_up;
};

struct Sweep {
  double direction = 0;      ///< [0, π) [rad]
  std::vector<Pass> passes;  ///< in the local frame
  double seconds = 0;        ///< in still air, on the level
  std::size_t blocks = 0;
};

/// Nothing if no free lanes were found. A step of the countdown is one direction; at least one is
/// tried. Precondition: a simple outer polygon, holes inside it.
std::optional<Sweep> plan_sweep(const SweepTask& task, const TurnModel& model,
                                Countdown& countdown);

/// Counter-clockwise, strictly convex.
world::Polygon convex_hull(const world::Polygon& polygon);
/// True when no corner is reflex, but for rounding.
bool is_convex(const world::Polygon& polygon);
/// Along the longest straight line within a region [rad].
double longest_line(const Region& region);

}  // namespace skein::refiners
