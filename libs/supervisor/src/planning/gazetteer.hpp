// SPDX-License-Identifier: Apache-2.0
// Which piece of the world a term of a domain names.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "skein/htn/term_store.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Names are found whatever the case of their letters, since the planner's symbols have none; one
/// with the same letters exactly comes first. `home` and `zero` are where the UAV lands, unless
/// the world has places of these names.
class Gazetteer {
 public:
  Gazetteer(std::shared_ptr<const Knowledge> knowledge, std::shared_ptr<const world::World> world);

  /// As that UAV of the team plans in the same world.
  Gazetteer of(const std::string& uav) const;

  /// Of a name, or of (loc X Y Z). What lies under the ground counts as on it.
  std::optional<world::Vector3> place(const htn::TermStore& store, htn::Term term) const;
  const world::Zone* zone(const std::string& name) const;
  const world::SensorModel* sensor(const std::string& device) const;

  double ground(const world::Vector3& at) const {
    return world_->terrain.elevation(at.x(), at.y());
  }
  /// True of what lies on the ground: a thing to look at, not a place to fly to.
  bool on_ground(const world::Vector3& at) const;
  /// At the usual altitude over it; of a vehicle that drives, on it.
  world::Vector3 above(const world::Vector3& at) const;
  /// The place itself if it is in the air, and the vehicle flies.
  world::Vector3 flown_to(const world::Vector3& at) const {
    return on_ground(at) || knowledge_->vehicle.ground ? above(at) : at;
  }
  /// "P1", "(10, 20, 30)": for people.
  static std::string words(const htn::TermStore& store, htn::Term place);

  const Knowledge& knowledge() const { return *knowledge_; }
  const world::World& world() const { return *world_; }

 private:
  std::optional<world::Vector3> named_place(const std::string& name) const;

  std::shared_ptr<const Knowledge> knowledge_;
  std::shared_ptr<const world::World> world_;
};

}  // namespace skein::supervisor
