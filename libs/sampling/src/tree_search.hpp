// SPDX-License-Identifier: Apache-2.0
// Path search by random trees, with OMPL.
#pragma once

#include <functional>
#include <optional>

#include "skein/foundation/random.hpp"
#include "skein/refiners/budget.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::sampling {

/// The space of the search. The functions are called from the thread of the search.
struct SearchSpace {
  world::Vector3 low, high;  ///< corners of the box [m]
  world::Vector3 from, to;   ///< free
  /// A random point of the box that may be free.
  std::function<world::Vector3(Random&)> any_point;
  std::function<bool(const world::Vector3&)> is_free;
  /// Whether the straight segment is free; only called for free end points.
  std::function<bool(const world::Vector3&, const world::Vector3&)> is_free_between;
};

/// The first path found by two trees that grow towards each other (RRT-Connect), not smoothed;
/// nothing if the countdown is over before. A step of the countdown is one sample.
/// Source: Kuffner & LaValle 2000.
std::optional<refiners::Way> first_way(const SearchSpace& space, Random& random,
                                       refiners::Countdown& countdown);

/// The shortest path found until the countdown is over, by RRT* on samples of the ellipsoid that
/// contains every path shorter than `length`, and later than the best one so far; nothing if none
/// is shorter. Source: Karaman & Frazzoli 2011; Gammell et al. 2014 (the ellipsoid).
std::optional<refiners::Way> shorter_way(const SearchSpace& space, double length, Random& random,
                                         refiners::Countdown& countdown);

}  // namespace skein::sampling
