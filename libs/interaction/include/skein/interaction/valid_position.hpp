// SPDX-License-Identifier: Apache-2.0
// The function `valid-position()`: a position where spatial constraints hold.
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

/// An SCM that must hold, with its binding.
struct ActiveScm {
  std::string id;
  Scm scm;
  ScmBinding binding;
};

/// The positions that are permitted at all.
struct FreeAir {
  Position low{}, high{};                      ///< box of the search [m, ENU]
  std::function<bool(const Position&)> holds;  ///< whether a position is permitted; pure
};
/// Positions in the airspace's box over the terrain, between `clearance` and the vehicle's ceiling
/// over the ground, and neither in nor beside a volume that is closed at some time from `at` on: as
/// far from it as ways there keep (the vehicle's radius) and 1 m. The world must outlive the
/// result.
FreeAir free_air_of(const world::World& world, const world::VehicleModel& vehicle, double clearance,
                    MissionTime at);

struct ValidPositionQuery {
  std::vector<ActiveScm> scms;
  FreeAir air;
  Position from{};   ///< position of the UAV; results near it are preferred
  ScmLimits limits;  ///< results that satisfy the SCMs by these margins are preferred
  std::uint64_t seed = 1;
  std::uint64_t budget = 40'000;  ///< positions tried
};

struct ValidPosition {
  Position position{};
  bool by_margin = false;   ///< all constraints hold by the margins of the limits
  std::uint64_t tried = 0;  ///< positions
};

enum class NoPosition : std::uint8_t {
  kUnknownPlace,  ///< some place is unknown or too old
  kNoneFound,     ///< none was found within the budget; there may be one
};
struct NoValidPosition {
  NoPosition kind = NoPosition::kNoneFound;
  std::string why;
};

/// Local search with restarts over the box that the distance constraints leave, the first one from
/// `from`. Satisfies one constraint after the other by random steps that keep the earlier ones,
/// each step to the least violated neighbour; then moves to a position where all hold by the
/// margins, then nearer to `from`. Deterministic for a seed. Cost: budget × constraints. Source: T
/// V.4.3, spec 7.5.
Result<ValidPosition, NoValidPosition> valid_position(const ValidPositionQuery& query,
                                                      const Observer& observer, MissionTime now);

}  // namespace skein::interaction
