// SPDX-License-Identifier: Apache-2.0
// Ways through a space by random trees, grown by OMPL.
#pragma once

#include <functional>
#include <optional>

#include "skein/foundation/random.hpp"
#include "skein/refiners/budget.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::sampling {

/// Where trees grow. The functions are asked from the thread of the search.
struct SearchSpace {
  world::Vector3 low, high;  ///< corners of the box [m]
  world::Vector3 from, to;   ///< free
  /// A point of the box, wherever there may be free air.
  std::function<world::Vector3(Random&)> any_point;
  std::function<bool(const world::Vector3&)> is_free;
  /// The straight segment; only asked between free points.
  std::function<bool(const world::Vector3&, const world::Vector3&)> is_free_between;
};

/// The first way that is found, by two trees that grow towards each other (RRT-Connect), as crooked
/// as it comes; nothing when the countdown is over. Each sample is one step of it.
/// Source: Kuffner & LaValle 2000.
std::optional<refiners::Way> first_way(const SearchSpace& space, Random& random,
                                       refiners::Countdown& countdown);

/// The shortest way found until the countdown is over, by RRT* on samples of the ellipsoid that
/// holds every way shorter than `length`, and then than the best so far; nothing if none is
/// shorter. Source: Karaman & Frazzoli 2011; Gammell et al. 2014 (the ellipsoid).
std::optional<refiners::Way> shorter_way(const SearchSpace& space, double length, Random& random,
                                         refiners::Countdown& countdown);

}  // namespace skein::sampling
