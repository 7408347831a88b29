// SPDX-License-Identifier: Apache-2.0
// Makes paths flyable: turns no tighter than the turn radius, climbs no steeper than the rates.
#pragma once

#include <functional>
#include <optional>

#include "skein/refiners/flight.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

/// The corners of the path, and the free space.
struct FlyableQuery {
  Way corners;                                     ///< at least two points, finite
  std::optional<double> heading_from, heading_to;  ///< [rad]
  double speed = 0;                                ///< [m/s]; 0: cruise
  /// Whether the straight segment is free; empty: always. Arcs deviate from their chords by up to
  /// `tolerance`, so obstacles must be grown by as much in this test.
  std::function<bool(const world::Vector3&, const world::Vector3&)> is_free;
  double tolerance = 0.5;  ///< of the chords of an arc [m], > 0
  /// Allows any corner to be left out where another path is free and shorter.
  bool shortest = false;
  /// Polled; after it has returned true, every segment counts as blocked. Empty: no time limit.
  std::function<bool()> time_is_up = {};
};

/// For a hovering vehicle: the unchanged corners. It turns on the spot, and flies a leg steeper
/// than its rates at less speed, a vertical leg at no horizontal speed (flight.hpp accounts for
/// that).
///
/// For other vehicles: a sampled path of arcs of the turn radius and straight lines, with the given
/// headings at the ends. Each corner is cut inside, flown over, or passed outside; if corners are
/// too close for the turns, or none of these is free, some may be left out, and points beside the
/// legs flown over instead. Climbs and descents are no steeper than the rates permit at that speed;
/// where the path is too short for them turns are added, whole circles and as much of a further one
/// as it takes. Among the free paths found, about the shortest is returned. The ends are kept
/// exactly.
///
/// Refused: an invalid query (kBadQuery); a blocked leg of a hovering vehicle (kBlocked); no
/// flyable path found near the corners (kBeyondVehicle), which does not prove that none exists.
/// Cost: bounded; at most some 300,000 calls of is_free, usually a few hundred per corner. Source:
/// spec 4.2 (curvature-bounded paths).
Result<Way, Refusal> make_flyable(const FlyableQuery& query, const world::VehicleModel& vehicle);

/// Lowest height above a place at which the air is probably free [m].
using Floor = std::function<double(const world::Vector2&)>;

/// A flyable path made shorter by passing its places lower, down to the floor, so that less has to
/// be climbed and turned; the path itself where none shorter is found. Keeps the ends and the
/// headings that the query asks for; the query's corners do not count. For vehicles that cannot
/// hover. Cost: at most 600,000 calls of is_free.
Way lowered(const Way& way, const FlyableQuery& query, const world::VehicleModel& vehicle,
            const Floor& floor);

/// Whether no turn of the path is sharper than the turn radius permits, and no leg steeper than the
/// rates; for checks. A turn may be at most that of an arc sampled with `tolerance` [m]: half the
/// angle of each of the two chords that meet there. Always true for finite paths of a hovering
/// vehicle.
bool is_flyable(const Way& way, const world::VehicleModel& vehicle, double speed, double tolerance);

}  // namespace skein::refiners
