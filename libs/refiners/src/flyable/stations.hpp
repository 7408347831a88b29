// SPDX-License-Identifier: Apache-2.0
// Where, and under which heading, a vehicle that cannot hover may pass the corners of a way.
#pragma once

#include <vector>

#include "flyable/leg.hpp"
#include "skein/refiners/flyable.hpp"

namespace skein::refiners {

/// The stations that may stand for one corner, or for a point on a leg.
struct StationLayer {
  std::vector<Station> stations;
  std::size_t corner = 0;  ///< the one it stands for, or that follows it
};

/// One layer per corner, the first and last with the headings asked for. `wide`: more stations per
/// corner, and layers beside the middles of long legs.
std::vector<StationLayer> stations_of(const FlyableQuery& query, double radius, bool wide);

}  // namespace skein::refiners
