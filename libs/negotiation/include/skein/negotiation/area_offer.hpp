// SPDX-License-Identifier: Apache-2.0
// What members of an area sharing tell each other, as rows: annex B of the thesis has it that an
// area is divided by what each UAV can do, which only it knows.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/negotiation/terms.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::interaction {

/// Who sweeps a part of an area, and from where.
struct Sweeper {
  world::VehicleModel vehicle;                    ///< what of it a sweep depends on
  world::Vector2 start = world::Vector2::Zero();  ///< [m, ENU]
  double altitude = 0;                            ///< over the ground [m], > 0
  double swath = 0;                               ///< [m], > 0
  double busy = 0;                                ///< until it can set out from its start [s], >= 0
};

/// Rows `start`, `sweep` (altitude, swath, busy) and `vehicle` (its figures).
Rows offer_of(const Sweeper& sweeper);
/// Refused: a row is missing, or a figure makes no sense.
Result<Sweeper, std::string> sweeper_of(const Rows& offer);

/// Corners x, y of a polygon [m, ENU].
Row row_of(const std::string& name, const world::Polygon& polygon);
world::Polygon polygon_of(const Row& row);

}  // namespace skein::interaction
