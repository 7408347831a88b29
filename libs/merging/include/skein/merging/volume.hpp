// SPDX-License-Identifier: Apache-2.0
// Pieces of air that somebody has for himself.
#pragma once

#include <vector>

#include "skein/world/geometry.hpp"
#include "skein/world/volume.hpp"

namespace skein::merging {

/// The air within `radius` level of a straight line, between two heights: an upright prism over a
/// stadium. Where both ends are one, a cylinder. It is had from when it is granted until its owner
/// says that he has left it; it has no dates.
struct Volume {
  world::Vector2 from = world::Vector2::Zero();  ///< [m] ENU
  world::Vector2 to = world::Vector2::Zero();
  double radius = 0;   ///< [m], > 0
  double floor = 0;    ///< [m] ENU z
  double ceiling = 0;  ///< [m] ENU z, > floor
  bool operator==(const Volume&) const = default;
};
using Volumes = std::vector<Volume>;

/// They have air in common; touching is none. Exact. Cost: constant.
bool overlap(const Volume& one, const Volume& other);
/// Any of the one and any of the other. Cost: O(product).
bool overlap(const Volumes& some, const Volumes& others);

/// All of `inner` is in `outer`, as far as their lines tell: no false yes. Cost: constant.
bool contains(const Volume& outer, const Volume& inner);

/// As air that is closed to others: the prism around all that is nearer to `volume` than `wider`
/// [m] level and `higher` [m] in height, with corners at the ends. At most 4 % of its radius too
/// wide.
world::Volume closed_around(const Volume& volume, double wider, double higher);

}  // namespace skein::merging
