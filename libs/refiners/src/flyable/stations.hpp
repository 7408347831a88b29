// SPDX-License-Identifier: Apache-2.0
// Candidate positions and headings at which a vehicle that cannot hover passes the corners of a
// path.
#pragma once

#include <vector>

#include "flyable/leg.hpp"
#include "skein/refiners/flyable.hpp"

namespace skein::refiners {

/// The candidate stations for one corner, or for a point on a leg.
struct StationLayer {
  std::vector<Station> stations;
  std::size_t corner = 0;  ///< index of the corner, or of the next one after the point
};

/// One layer per corner, the first and last with the headings asked for. `wide`: more stations per
/// corner, and layers beside the middles of long legs.
std::vector<StationLayer> stations_of(const FlyableQuery& query, double radius, bool wide);

}  // namespace skein::refiners
