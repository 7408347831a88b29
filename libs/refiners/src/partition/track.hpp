// SPDX-License-Identifier: Apache-2.0
// A way to divide an area, followed while the shares change.
#pragma once

#include <vector>

#include "partition/planner.hpp"

namespace skein::refiners::partition {

struct Track {
  Division last;
  std::vector<Ability> abilities;
  double promise = 0;  ///< when all would end if they went on as they did [s]
  bool flown = false;  ///< the best that was flown came of it
};

/// Ways to divide that are looked at.
inline constexpr std::size_t kWays = 24;
/// A spread that nobody minds.
inline constexpr double kFineSpread = 0.01;

/// Of its corners [m].
world::Vector2 middle_of(const world::Polygon& part);
/// Less when parts lie where the other's do: sum of the squares between their middles [m²].
double unlikeness(const Division& a, const Division& b);

}  // namespace skein::refiners::partition
