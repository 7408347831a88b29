// SPDX-License-Identifier: Apache-2.0
// Whether simulated flights along a way come near closed air or the ground.
#pragma once

#include <cstdint>
#include <vector>

#include "flight/autopilot.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/volume.hpp"

namespace skein::supervisor {

/// What counts as near, and which flights are simulated.
struct Closeness {
  double margin = 0;         ///< closer than this to a volume is too near [m]
  std::uint64_t shaken = 0;  ///< additional flights with errors and gusts, if the vehicle hovers
  double beside = 0;         ///< nothing flies further beside its way [m]; for the ground
};

/// Whether any simulated flight along the way, from any pose at its beginning, or the waiting
/// circles at its end come too near to a volume. Flights that begin too near do not count; a way of
/// fewer than two points has none. Cost: at most nine flights, 0.1 µs for each 0.1 s of them.
bool flights_meet(const refiners::Way& way, const std::vector<world::Volume>& volumes,
                  const world::VehicleModel& vehicle, const world::Wind& wind,
                  const Closeness& closeness);
/// The same for flights that begin in one of `poses`.
bool flights_meet(const refiners::Way& way, const std::vector<world::Volume>& volumes,
                  const world::VehicleModel& vehicle, const world::Wind& wind,
                  const Closeness& closeness, const std::vector<Pose>& poses);
/// Likewise, whether any comes lower than the margin over the ground, flights with errors and gusts
/// among them, whether the vehicle hovers or not. Nothing is simulated where no ground beside the
/// way is so high.
bool flights_meet_ground(const refiners::Way& way, const world::Terrain& terrain,
                         const Closeness& closeness, const world::VehicleModel& vehicle,
                         const world::Wind& wind, const std::vector<Pose>& poses);

}  // namespace skein::supervisor
