// SPDX-License-Identifier: Apache-2.0
// The sweep of an area as planning has it, for who carries it out without a plan: roles of joint
// tasks.
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
  refiners::Way way;      ///< from where it sets out [m, ENU]
  std::size_t lanes = 0;  ///< place in the way of the first point that is swept from
  double seconds = 0;     ///< expected
  double energy = 0;      ///< expected, as a fraction of what is held when full
  double reach = 0;       ///< how far to each side of a lane it sees [m]
};

/// The way to the area and over it, as the autopilot flies it, clear of closed air. Refused, with a
/// sentence: the UAV has no such device, or the refiners find no way. Cost: that of planning a
/// mapping, some milliseconds.
Result<AreaSweep, std::string> sweep_of(const std::shared_ptr<const Knowledge>& knowledge,
                                        const std::shared_ptr<const world::World>& world,
                                        MissionTime now, const world::Vector3& from,
                                        const world::Polygon& area, const std::string& device);

/// Between two lanes of a mapping [m]; refused: no such device, or it sees nothing from there.
Result<double, std::string> swath_of(const Knowledge& knowledge, const std::string& device);
/// The same as sweep_of() flies them.
Result<double, std::string> shared_swath_of(const Knowledge& knowledge, const std::string& device);

/// Whose part of an area it is.
enum class Sweeping : std::uint8_t {
  kShared,  ///< of a role of a joint task, as sweep_of() flies it
  kOwn,     ///< of a mapping of its own: nothing is left out where it swings out behind a turn
};

/// Who sweeps a part of an area, as far as the seconds it takes depend on that.
struct PartSweeper {
  world::VehicleModel vehicle;
  double altitude = 0;                            ///< over the ground [m], > 0
  double swath = 0;                               ///< between its lanes [m], > 0
  world::Vector2 start = world::Vector2::Zero();  ///< [m, ENU], at that altitude
};

/// Seconds that sweep_of() expects of any vehicle over a part of an area [m, ENU]; nothing: it
/// finds no way. Its own pilot and sensor are not asked for: `vehicle.position_precision` is what
/// it strays.
std::optional<double> seconds_of_sweep(const PartSweeper& sweeper, const world::Polygon& part,
                                       const std::shared_ptr<const world::World>& world,
                                       Sweeping sweeping = Sweeping::kShared);

}  // namespace skein::supervisor
