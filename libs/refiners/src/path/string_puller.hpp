// SPDX-License-Identifier: Apache-2.0
// Draws a way taut between its ends.
#pragma once

#include <optional>

#include "skein/refiners/budget.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// Every move keeps the way free and makes it cost less, so it can be stopped at any time. First
/// the best choice of way-points among those given; then, in rounds, corners slide along one axis
/// at a time (which is how they slide along the edges of voxels), are cut off and are left out,
/// until a round gains too little. Near blocked voxels corners stay off their faces by kInset.
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
  /// The least costly way over some of the points, in their order; each leg leaves out fewer than
  /// `reach` of them.
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
