// SPDX-License-Identifier: Apache-2.0
// Ways that a vehicle can really fly: turns as wide as it needs, climbs as steep as it can.
#pragma once

#include <functional>
#include <optional>

#include "skein/refiners/flight.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

/// What is to be flown, and what may not be touched.
struct FlyableQuery {
  Way corners;                                     ///< at least two points, finite
  std::optional<double> heading_from, heading_to;  ///< [rad]
  double speed = 0;                                ///< [m/s]; 0: cruise
  /// True when the straight segment may be flown; empty: every one may. The arcs themselves leave
  /// their chords by up to `tolerance`: what must not be touched at all is grown by as much here.
  std::function<bool(const world::Vector3&, const world::Vector3&)> is_free;
  double tolerance = 0.5;  ///< of the chords of an arc [m], > 0
  /// Any corner may be left out, wherever another way is free and shorter.
  bool shortest = false;
  /// Asked now and then; once it says so nothing is free any more. Empty: never.
  std::function<bool()> time_is_up = {};
};

/// For a vehicle that hovers: the corners as they are. It turns on the spot, and flies a leg that
/// is steeper than it climbs at speed slower, a vertical one without any (flight.hpp counts that).
///
/// For one that cannot: a way of arcs of its turn radius and straight lines, sampled, with its
/// headings at the ends where they are given. Each corner is rounded inside, flown over, or swung
/// around outside; where corners stand too close for its turns, or none of that is free, some may
/// be left out and points beside the legs may be flown over instead. Climbs and descents are no
/// steeper than its rates allow at that speed: where the way is too short for them, it turns full
/// circles. Of what is found free, about the shortest is given. The ends are kept exactly.
///
/// Refused: a query that makes no sense (kBadQuery); a leg of a hovering vehicle that is not free
/// (kBlocked); no such way found near the corners (kBeyondVehicle), which does not prove that there
/// is none. Cost: bounded; at most some 300,000 calls of is_free, usually a few hundred per corner.
/// Source: spec 4.2 (curvature-bounded paths).
Result<Way, Refusal> make_flyable(const FlyableQuery& query, const world::VehicleModel& vehicle);

/// True when no turn along the way is sharper than the radius allows and no leg steeper than the
/// rates do; for checks. A turn is judged by what an arc sampled with `tolerance` [m] would show:
/// at most half the angle of each of the chords that meet there. Always true for finite ways of a
/// vehicle that hovers.
bool is_flyable(const Way& way, const world::VehicleModel& vehicle, double speed, double tolerance);

}  // namespace skein::refiners
