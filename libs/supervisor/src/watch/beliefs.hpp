// SPDX-License-Identifier: Apache-2.0
// Beliefs about the vehicle and the world.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "flight/retreat.hpp"
#include "skein/executive/effect.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/world/vehicle_state.hpp"
#include "watch/wind_estimator.hpp"

namespace skein::supervisor {

/// Beliefs from messages and from the vehicle's own states. A world that was returned is immutable;
/// each change makes a new one with the next revision. Lifetime: refers to the knowledge.
class Beliefs {
 public:
  Beliefs(const Knowledge& knowledge, std::shared_ptr<const world::World> world);

  const Knowledge& knowledge() const { return knowledge_; }
  const world::VehicleModel& model() const { return knowledge_.vehicle; }
  const world::World& world() const { return *world_; }
  std::shared_ptr<const world::World> shared_world() const { return world_; }
  std::uint64_t revision() const { return revision_; }  ///< of the world
  const world::VehicleState& vehicle() const { return vehicle_; }
  const std::set<std::string>& broken() const { return broken_; }  ///< devices
  Retreat retreat(MissionTime now) const { return {knowledge_, *world_, now}; }
  double energy_above_reserve() const { return vehicle_.energy - model().energy.reserve; }

  /// Takes a change of a place or of the ground. Returns by how far the place moved [m]; 0 if it
  /// was unknown before.
  double learn(const mission::ChangeWorld& change);
  /// Closes or opens a volume of air.
  void close(const mission::ChangeWorld& change);
  /// A task has ended; sets `airborne` if its type ends in the air or on the ground.
  void see_end(const executive::TaskEvent& event, MissionTime now);
  /// Takes a vehicle state. Returns the devices that have newly failed.
  std::set<std::string> see(const world::VehicleState& state,
                            const std::vector<std::string>& failed, MissionTime now);
  /// Replaces the believed wind by the estimated one if they differ significantly; returns it then.
  std::optional<world::Wind> feel_wind();

 private:
  void take(std::shared_ptr<const world::World> changed);

  const Knowledge& knowledge_;
  std::shared_ptr<const world::World> world_;
  std::uint64_t revision_ = 0;
  world::VehicleState vehicle_;
  WindEstimator wind_;
  std::set<std::string> broken_;
  MissionTime grounded_until_;  ///< until then, an airborne state counts as older than the landing
};

}  // namespace skein::supervisor
