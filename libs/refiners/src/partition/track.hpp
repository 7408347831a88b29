// SPDX-License-Identifier: Apache-2.0
// A scheme of division, followed while the shares change.
#pragma once

#include <vector>

#include "partition/planner.hpp"

namespace skein::refiners::partition {

struct Track {
  Division last;
  std::vector<Ability> abilities;
  double promise = 0;  ///< extrapolated common finish [s]
  bool flown = false;  ///< the best division by real flight is of this track
};

/// Number of schemes that are tried.
inline constexpr std::size_t kWays = 24;
/// A spread of finishes that is good enough.
inline constexpr double kFineSpread = 0.01;

/// Mean of the part's corners [m].
world::Vector2 middle_of(const world::Polygon& part);
/// Dissimilarity of two divisions: sum of the squared distances of their parts' middles [m²].
double unlikeness(const Division& a, const Division& b);

}  // namespace skein::refiners::partition
