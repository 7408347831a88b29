// SPDX-License-Identifier: Apache-2.0
// Checks and refusals shared by several services; private.
#pragma once

#include <optional>
#include <string>

#include "skein/refiners/refinement.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/world.hpp"

namespace skein::refiners {

/// Refuses an energy above the vehicle's full capacity less its reserve; `what` begins the
/// sentence.
std::optional<Refusal> check_energy(double energy, const world::VehicleModel& vehicle,
                                    const std::string& what);

/// "12.3": four digits, for people.
std::string rounded(double figure);
/// Up to six significant digits, as in the query.
std::string figure(double value);

/// The refusal (kBadQuery) of an invalid `field`.
Refusal bad(std::string field, std::string why);

/// Refuses an area that lies entirely outside the extent of the terrain (where heights are only
/// extrapolated from its border). Precondition: at least one corner.
std::optional<Refusal> check_in_world(const world::Polygon& area, const world::World& world,
                                      const std::string& field);

}  // namespace skein::refiners
