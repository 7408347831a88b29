// SPDX-License-Identifier: Apache-2.0
// Volumes of air that a member reserves.
#pragma once

#include <vector>

#include "skein/world/geometry.hpp"
#include "skein/world/volume.hpp"

namespace skein::merging {

/// The air within the horizontal distance `radius` of a straight line, between two heights: an
/// upright prism over a stadium, or a cylinder where `from` equals `to`. It has no dates: it is
/// reserved from the grant until its owner says that it has left.
struct Volume {
  world::Vector2 from = world::Vector2::Zero();  ///< [m] ENU
  world::Vector2 to = world::Vector2::Zero();
  double radius = 0;   ///< [m], > 0
  double floor = 0;    ///< [m] ENU z
  double ceiling = 0;  ///< [m] ENU z, > floor
  bool operator==(const Volume&) const = default;
};
using Volumes = std::vector<Volume>;

/// Whether two volumes have interior points in common; touching does not count. Exact. Constant
/// cost.
bool overlap(const Volume& one, const Volume& other);
/// Whether any of `some` overlaps any of `others`. Cost: O(product).
bool overlap(const Volumes& some, const Volumes& others);

/// True only if all of `inner` is in `outer`; may be false although it is. Constant cost.
bool contains(const Volume& outer, const Volume& inner);

/// The volume as a no-fly polygon for others: encloses all points within `wider` [m] horizontally
/// and `higher` [m] vertically of `volume`. At most 4 % of the radius too wide.
world::Volume closed_around(const Volume& volume, double wider, double higher);

}  // namespace skein::merging
