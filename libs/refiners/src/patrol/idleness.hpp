// SPDX-License-Identifier: Apache-2.0
// When each cell was last perceived along a flight, and what that makes of its idleness.
#pragma once

#include <cstdint>
#include <vector>

#include "patrol/field.hpp"
#include "skein/refiners/patrol.hpp"

namespace skein::refiners {

/// Follows a flight leg by leg. Idleness is 0 while a cell is perceived and since the start before
/// it first was. Figures are exact for straight legs at an even pace, over the time from `from` on.
class IdlenessLog {
 public:
  /// The field and the sight must outlive it.
  IdlenessLog(const PatrolField& field, const PatrolSight& sight, double from);

  /// Flies straight on, from now to `until` [s].
  void fly(const world::Vector2& from, const world::Vector2& to, double until);
  double now() const { return now_; }
  /// When a cell was last perceived [s]; 0 when it never was.
  const std::vector<double>& last_seen() const { return last_; }
  /// Of the time since `from`, as if the flight ended now. Bounds are those of make_bounds.
  PatrolFigures figures() const;

 private:
  void see(std::uint32_t cell, double enter, double leave);
  /// Takes the idle time of a cell up to an instant into account.
  void close(std::uint32_t cell, double until, std::vector<double>& worst, double& weighted) const;

  const PatrolField& field_;
  const PatrolSight& sight_;
  double from_, now_ = 0;
  std::vector<double> last_, worst_;
  std::vector<bool> seen_;
  double weighted_ = 0;  ///< integral of risk × idleness [s²]
};

/// The lower bounds, and how many cells there are: with c = 2 σ v / cell² cells passed over in a
/// second, worst idleness n / c, worst risk × idleness Σr / c, mean (Σ√r)² / (2 c Σr). They are
/// those of ground without grain: a lane over cells nearly as large as the footprint can see up to
/// 1 + cell / 2σ times as many. Source: notes/geometry, section 4.
PatrolFigures make_bounds(const PatrolField& field, const PatrolSight& sight, double speed);

}  // namespace skein::refiners
