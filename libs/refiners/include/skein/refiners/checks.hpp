// SPDX-License-Identifier: Apache-2.0
// Checks that many queries share; each gives the refusal, or nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "skein/refiners/refinement.hpp"
#include "skein/world/geometry.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

/// Checking that edges do not cross takes the square of it.
inline constexpr std::size_t kMostCorners = 2000;

std::optional<Refusal> check_finite(const world::Vector3& point, const std::string& field);
std::optional<Refusal> check_positive(double figure, const std::string& field);
/// Speeds, rates and radii that a way can be flown with.
std::optional<Refusal> check_vehicle(const world::VehicleModel& vehicle);
/// Finite corners, at least three, an area, no edges that cross or touch.
std::optional<Refusal> check_polygon(const world::Polygon& polygon, const std::string& field);
/// The sensor of that name, or why not.
Result<const world::SensorModel*, Refusal> sensor_of(const world::VehicleModel& vehicle,
                                                     const std::string& device);

}  // namespace skein::refiners
