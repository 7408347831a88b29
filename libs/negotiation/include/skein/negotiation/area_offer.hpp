// SPDX-License-Identifier: Apache-2.0
// Offers in an area sharing, as rows: an area is divided by the capabilities of the UAVs, which
// each of them knows only of itself (annex B of the thesis).
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/negotiation/terms.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::interaction {

/// Names of parameters of a session, beside the areas: after how many divisions it is (at most one;
/// 0 without it); what the member in its text has left is shared anew, as it was after so many.
inline constexpr const char* kDivisions = "divisions";
inline constexpr const char* kAnew = "anew";
inline constexpr int kMostDivisions = 1'000'000;

/// A UAV that offers to sweep a part of an area, and its starting point.
struct Sweeper {
  world::VehicleModel vehicle;                    ///< the figures that a sweep depends on
  world::Vector2 start = world::Vector2::Zero();  ///< [m, ENU]
  double altitude = 0;                            ///< over the ground [m], > 0
  double swath = 0;                               ///< distance between two lanes [m], > 0
  double busy = 0;  ///< time until it can depart from `start` [s], >= 0
};

/// Rows `start`, `sweep` (altitude, swath, busy) and `vehicle` (its figures).
Rows offer_of(const Sweeper& sweeper);
/// The inverse of offer_of(). Errors: a row is missing, or a figure is out of range.
Result<Sweeper, std::string> sweeper_of(const Rows& offer);

/// A row with the corners x, y of a polygon [m, ENU], and its inverse.
Row row_of(const std::string& name, const world::Polygon& polygon);
world::Polygon polygon_of(const Row& row);

}  // namespace skein::interaction
