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
  /// Of the air, as far as it moves the vehicle [m/s]: lanes with and against it take longer.
  world::Vector2 wind = world::Vector2::Zero();
  /// True when a lane may be flown there; empty: everywhere.
  std::function<bool(const world::Vector2&, const world::Vector2&)> is_free;
  /// Asked before each set of lanes, of which one over many corners takes milliseconds; empty:
  /// never.
  std::function<bool()> time_is_up;
};

struct Sweep {
  double direction = 0;      ///< [0, π) [rad]
  std::vector<Pass> passes;  ///< in the local frame
  double seconds = 0;        ///< in still air, on the level
  std::size_t blocks = 0;
};

/// Nothing when no lanes were found that may be flown. One step of the countdown is one direction
/// of lanes; at least one is tried. Precondition: a simple outer polygon, holes inside it.
std::optional<Sweep> plan_sweep(const SweepTask& task, const TurnModel& model,
                                Countdown& countdown);

/// Counter-clockwise, strictly convex.
world::Polygon convex_hull(const world::Polygon& polygon);
/// True when no corner is reflex, but for rounding.
bool is_convex(const world::Polygon& polygon);
/// Along the longest straight line within a region [rad].
double longest_line(const Region& region);

}  // namespace skein::refiners
