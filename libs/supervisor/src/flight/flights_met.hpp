// SPDX-License-Identifier: Apache-2.0
// Does a flight, as a vehicle really flies it, come near closed air?
#pragma once

#include <cstdint>
#include <vector>

#include "flight/autopilot.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/world/volume.hpp"

namespace skein::supervisor {

/// How flights are looked at: nearer than `margin` [m] is too near; one that hovers flies so many
/// times with errors and gusts, too.
struct Closeness {
  double margin = 0;
  std::uint64_t shaken = 0;
};

/// Some flight along the way, whichever way the vehicle comes to where that begins, or its circles
/// at the end come too near; those that begin too near do not count. Of less than two points: none.
/// Cost: at most nine flights, 0.1 µs for each 0.1 s of them.
bool flights_meet(const refiners::Way& way, const std::vector<world::Volume>& volumes,
                  const world::VehicleModel& vehicle, const world::Wind& wind,
                  const Closeness& closeness);
/// Likewise, of a vehicle that begins in one of these poses.
bool flights_meet(const refiners::Way& way, const std::vector<world::Volume>& volumes,
                  const world::VehicleModel& vehicle, const world::Wind& wind,
                  const Closeness& closeness, const std::vector<Pose>& poses);

}  // namespace skein::supervisor
