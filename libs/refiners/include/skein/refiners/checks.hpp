// SPDX-License-Identifier: Apache-2.0
// Checks common to many queries; each returns the refusal, or nothing.
#pragma once

#include <optional>
#include <string>

#include "skein/refiners/refinement.hpp"
#include "skein/world/geometry.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

std::optional<Refusal> check_finite(const world::Vector3& point, const std::string& field);
std::optional<Refusal> check_positive(double figure, const std::string& field);
/// Checks that the vehicle's speeds, rates and radii are valid for flying a path.
std::optional<Refusal> check_vehicle(const world::VehicleModel& vehicle);
/// Checks that the polygon is simple (world::problem_of); a corner that is not finite is named by
/// its index.
std::optional<Refusal> check_polygon(const world::Polygon& polygon, const std::string& field);
/// The sensor of that name, or a refusal.
Result<const world::SensorModel*, Refusal> sensor_of(const world::VehicleModel& vehicle,
                                                     const std::string& device);

}  // namespace skein::refiners
