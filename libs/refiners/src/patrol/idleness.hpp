// SPDX-License-Identifier: Apache-2.0
// Last perception and idleness of each cell along a flight.
#pragma once

#include <cstdint>
#include <vector>

#include "patrol/field.hpp"
#include "skein/refiners/patrol.hpp"

namespace skein::refiners {

/// Follows a flight leg by leg. The idleness of a cell is 0 while it is perceived, and counts from
/// the start before its first perception. Figures are exact for straight legs at constant speed,
/// over the time from `from` on.
class IdlenessLog {
 public:
  /// The field and the sight must outlive this object.
  IdlenessLog(const PatrolField& field, const PatrolSight& sight, double from);

  /// Flies straight on, from now to `until` [s].
  void fly(const world::Vector2& from, const world::Vector2& to, double until);
  double now() const { return now_; }
  /// Last perception of each cell [s]; 0: never.
  const std::vector<double>& last_seen() const { return last_; }
  /// Figures of the time since `from`, for a flight that ends now; with the bounds of make_bounds.
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

/// The lower bounds of a flight of `total` seconds from its start, for the figures of its last
/// `window`; and how many cells there are. A second brings at most c = (2 σ + 1) v / cell cells
/// into view (σ in cells), as along a straight lane; at most K are in view at once. A cell has at
/// most one interval out of view more than it comes into view. With C = c + n / window: worst
/// idleness (n - K) / c, or `total` where that is less; worst risk × idleness (Σr - K) / C; mean
/// (Σ√r - K)² / (2 C Σr). Proof: docs/decisions/0008-refiners.md.
PatrolFigures make_bounds(const PatrolField& field, const PatrolSight& sight, double speed,
                          double total, double window);

}  // namespace skein::refiners
