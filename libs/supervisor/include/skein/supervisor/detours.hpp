// SPDX-License-Identifier: Apache-2.0
// By how much the ways that are flown are longer than straight flights.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// A straight flight between two places in the air [m, ENU].
struct StraightLeg {
  world::Vector3 from = world::Vector3::Zero();
  world::Vector3 to = world::Vector3::Zero();
};

/// What the way around costs, compared with the straight flight.
struct Detour {
  /// False: there is no way, and none of the air that is closed now will open by itself.
  bool exists = true;
  Duration longer;
  double energy = 0;  ///< [J]
  bool operator==(const Detour&) const = default;
};

struct DetourRequest {
  std::shared_ptr<const Knowledge> knowledge;
  std::shared_ptr<const world::World> world;
  MissionTime now;
  std::vector<StraightLeg> legs;
};

/// Whether the straight flight comes too near the ground, or to air that is closed at `now`, so
/// that there may be a detour. Always false for a ground vehicle. Cost: O(volumes +
/// terrain cells on the way).
bool goes_through(const Knowledge& knowledge, const world::World& world, MissionTime now,
                  const StraightLeg& leg);

/// The detours of the legs, in their order, by the path service that plans are made with, in the
/// air that is closed at `now`. A leg of which nothing is known (its beginning is closed, the wind
/// is too strong, its planning took all the time) has none. `time_is_up`, if given, is asked
/// between two legs and during searches: what is missing at the end of the result was not planned;
/// the first leg never is. Any thread. Cost: one airspace, and a search for each leg.
std::vector<Detour> plan_detours(const DetourRequest& request,
                                 const std::function<bool()>& time_is_up = {});

}  // namespace skein::supervisor
