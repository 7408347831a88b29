// SPDX-License-Identifier: Apache-2.0
// What the refusals of several services have in common; private.
#pragma once

#include <optional>
#include <string>

#include "skein/refiners/refinement.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

/// The refusal of what would use more than the vehicle holds above its reserve; `what` begins the
/// sentence.
std::optional<Refusal> check_energy(double energy, const world::VehicleModel& vehicle,
                                    const std::string& what);

/// "12.3"
std::string rounded(double figure);

}  // namespace skein::refiners
