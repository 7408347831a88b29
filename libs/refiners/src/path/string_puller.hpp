// SPDX-License-Identifier: Apache-2.0
// Pulls a path straight between its ends.
#pragma once

#include <optional>

#include "skein/refiners/budget.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// Every move keeps the path free and reduces its cost, so it can be stopped at any time. First the
/// best subset of the given way-points; then, in rounds, corners are moved along one axis at a time
/// (so that they slide along the edges of voxels), cut off and removed, until a round gains too
/// little. Corners keep a distance of kInset from faces of blocked voxels.
class StringPuller {
 public:
  /// Distance from the faces of blocked voxels [voxels].
  static constexpr double kInset = 1e-3;

  StringPuller(const world::Airspace& airspace, const Budget& budget)
      : airspace_(airspace),
        budget_(budget),
        even_(airspace.least_cost() == airspace.greatest_cost()),
        rate_(airspace.least_cost() * world::Airspace::kCostStep) {}

  Way pulled(Way way) const;
  /// Of a free way [m × cost].
  double cost(const Way& way) const;

 private:
  std::optional<double> cost(const world::Vector3& a, const world::Vector3& b) const;
  double leg_cost(const world::Vector3& a, const world::Vector3& b) const;
  /// The least costly path over a subset of the points, in their order; each leg skips fewer than
  /// `reach` points.
  Way best_choice(const Way& way, std::size_t reach) const;
  double slide_corners(Way& way) const;
  double slide(Way& way, std::size_t corner, Eigen::Index axis) const;
  double try_at(Way& way, std::size_t corner, const world::Vector3& place) const;
  double slide_toward(Way& way, std::size_t corner, Eigen::Index axis, double goal) const;
  double cut_corners(Way& way) const;

  const world::Airspace& airspace_;
  const Budget& budget_;
  bool even_;    // one crossing cost everywhere
  double rate_;  // the least
};

}  // namespace skein::refiners
