// SPDX-License-Identifier: Apache-2.0
// Checks that many queries share; each gives the refusal, or nothing.
#pragma once

#include <optional>
#include <string>

#include "skein/refiners/refinement.hpp"
#include "skein/world/geometry.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

std::optional<Refusal> check_finite(const world::Vector3& point, const std::string& field);
std::optional<Refusal> check_positive(double figure, const std::string& field);
/// Speeds, rates and radii that a way can be flown with.
std::optional<Refusal> check_vehicle(const world::VehicleModel& vehicle);
/// A simple polygon, as world::problem_of has it; a corner that is not finite is named by its
/// place.
std::optional<Refusal> check_polygon(const world::Polygon& polygon, const std::string& field);
/// The sensor of that name, or why not.
Result<const world::SensorModel*, Refusal> sensor_of(const world::VehicleModel& vehicle,
                                                     const std::string& device);

}  // namespace skein::refiners
