// SPDX-License-Identifier: Apache-2.0
// What is believed of the vehicle and of the world around it.
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

/// As it was told, and as it was felt. A world that was given away never changes: what is learnt
/// makes another, with the next revision. Lifetime: refers to the knowledge.
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

  /// Of a place or of the ground. Returns how far that place is from where it was believed [m]; 0
  /// where nothing was.
  double learn(const mission::ChangeWorld& change);
  /// Closes or opens a volume of air.
  void close(const mission::ChangeWorld& change);
  /// A task that ends in the air, or on the ground, has ended.
  void see_end(const executive::TaskEvent& event, MissionTime now);
  /// Returns the devices that worked so far.
  std::set<std::string> see(const world::VehicleState& state,
                            const std::vector<std::string>& failed, MissionTime now);
  /// Plans from now on reckon with the wind that is felt, once it is known to be another: then it
  /// is returned.
  std::optional<world::Wind> feel_wind();

 private:
  void take(std::shared_ptr<const world::World> changed);

  const Knowledge& knowledge_;
  std::shared_ptr<const world::World> world_;
  std::uint64_t revision_ = 0;
  world::VehicleState vehicle_;
  WindEstimator wind_;
  std::set<std::string> broken_;
  MissionTime grounded_until_;  ///< a state that says otherwise is older than the landing
};

}  // namespace skein::supervisor
