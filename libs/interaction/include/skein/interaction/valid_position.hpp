// SPDX-License-Identifier: Apache-2.0
// Where spatial constraints hold: what `valid-position()` computes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/interaction/scm_monitor.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/world.hpp"

namespace skein::interaction {

/// An SCM that is to hold, with what its places and numbers stand for.
struct ActiveScm {
  std::string id;
  Scm scm;
  ScmBinding binding;
};

/// Where one may be at all.
struct FreeAir {
  Position low{}, high{};                      ///< nothing outside this box is looked at
  std::function<bool(const Position&)> holds;  ///< pure
};
/// In the airspace's box over the terrain; from `clearance` to the vehicle's ceiling over the
/// ground; in no volume that closes from `at` on. The world must outlive it.
FreeAir free_air_of(const world::World& world, const world::VehicleModel& vehicle, double clearance,
                    MissionTime at);

struct ValidPositionQuery {
  std::vector<ActiveScm> scms;
  FreeAir air;
  Position from{};   ///< where the UAV is: nearer is better
  ScmLimits limits;  ///< a position that holds by their margins is better
  std::uint64_t seed = 1;
  std::uint64_t budget = 40'000;  ///< positions tried
};

struct ValidPosition {
  Position position{};
  bool by_margin = false;   ///< all constraints hold by the margins: none is violated soon
  std::uint64_t tried = 0;  ///< positions
};

enum class NoPosition : std::uint8_t {
  kUnknownPlace,  ///< some place is unknown or too old
  kNoneFound,     ///< within the budget: there may be one
};
struct NoValidPosition {
  NoPosition kind = NoPosition::kNoneFound;
  std::string why;
};

/// From starts all over the box that the constraints on distances leave, beginning with `from`:
/// satisfies one constraint after the other by steps at random that break none of those before,
/// each to the least violated of its neighbours; then moves the position to where all hold by the
/// margins, then nearer to `from`. One seed, one answer. Cost: budget × constraints.
/// Source: T V.4.3, spec 7.5.
Result<ValidPosition, NoValidPosition> valid_position(const ValidPositionQuery& query,
                                                      const Observer& observer, MissionTime now);

}  // namespace skein::interaction
