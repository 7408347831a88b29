// SPDX-License-Identifier: Apache-2.0
// The sweep of an area as the planner computes it, for callers that fly it without a plan: roles of
// joint tasks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "skein/foundation/result.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

struct AreaSweep {
  refiners::Way way;      ///< from the UAV's starting position to the last lane's end [m, ENU]
  std::size_t lanes = 0;  ///< index in `way` of the first lane's first point
  double seconds = 0;     ///< expected
  double shortest = 0, longest = 0;  ///< [s]
  double energy = 0;                 ///< expected, as a fraction of the full capacity
  double reach = 0;                  ///< how far the device sees to each side of a lane [m]
};

/// Where a sweep begins, and when, after the time of planning [s].
struct SweepStart {
  world::Vector3 from = world::Vector3::Zero();  ///< [m, ENU]
  double earliest = 0, latest = 0;
};

/// Why there is no sweep, in words; and when air that is closed for a time and in its way is open
/// again, next.
struct NoSweep {
  std::string why;
  std::optional<MissionTime> opens = {};
};

/// The way from its start to the area and over it, as the autopilot flies it, clear of air that is
/// closed now or later; if there is none, of what is closed while it is flown, when it begins up to
/// a minute late; else of what is closed when it begins: who flies it watches what closes then.
/// Refused: the UAV has no such device, or the refiners find no way. Cost: that of planning one to
/// four mappings, some milliseconds.
Result<AreaSweep, NoSweep> sweep_of(const std::shared_ptr<const Knowledge>& knowledge,
                                    const std::shared_ptr<const world::World>& world,
                                    MissionTime now, const SweepStart& start,
                                    const world::Polygon& area, const std::string& device);

/// Distance between two lanes of a mapping with the device, at the UAV's usual altitude [m].
/// Errors: no such device, or it sees no ground from that altitude.
Result<double, std::string> swath_of(const Knowledge& knowledge, const std::string& device);
/// The same for the lanes of sweep_of(), which overlap more.
Result<double, std::string> shared_swath_of(const Knowledge& knowledge, const std::string& device);

/// For what an area is swept.
enum class Sweeping : std::uint8_t {
  kShared,  ///< as a share of a joint task's area, the way sweep_of() flies it
  kOwn,     ///< as a mapping of one UAV, which is led back on its lane after each turn: no gaps
};

/// What the duration of a sweep depends on, of the UAV that flies it.
struct PartSweeper {
  world::VehicleModel vehicle;
  double altitude = 0;                            ///< over the ground [m], > 0
  double swath = 0;                               ///< distance between two lanes [m], > 0
  world::Vector2 start = world::Vector2::Zero();  ///< [m, ENU], at that altitude
};

/// Expected duration [s] of the flight of `sweeper` to `part` [m, ENU] and over it, for any
/// vehicle; absent: no way was found. The flight to the first lane is straight, and the device is
/// one that sees as far as `swath` asks for; how far the vehicle strays follows from
/// `vehicle.position_precision`.
std::optional<double> seconds_of_sweep(const PartSweeper& sweeper, const world::Polygon& part,
                                       const std::shared_ptr<const world::World>& world,
                                       Sweeping sweeping = Sweeping::kShared);

}  // namespace skein::supervisor
