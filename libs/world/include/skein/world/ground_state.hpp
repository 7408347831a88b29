// SPDX-License-Identifier: Apache-2.0
// What is known of each cell of the ground: its burning risk, whether it was mapped, fires.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/world/grid.hpp"

namespace skein::world {

enum class CellState : std::uint8_t { kQuiet, kAlarm, kFire };

/// Source: spec 4.1 (terrain), T IV.2.2. A value type.
struct GroundState {
  Grid grid;
  std::vector<double> risk;      ///< burning risk, [0, 1], one per cell; empty: 0.5 everywhere
  std::vector<bool> mapped;      ///< one per cell; empty: nothing is
  std::vector<CellState> state;  ///< one per cell; empty: all quiet
  bool operator==(const GroundState&) const = default;

  /// The risk where a point is; 0 outside the grid (nothing is asked of it there).
  double risk_at(const Vector2& point) const {
    const auto cell = grid.at(point);
    if (!cell) return 0;
    return risk.empty() ? 0.5 : risk[*cell];
  }
};

}  // namespace skein::world
