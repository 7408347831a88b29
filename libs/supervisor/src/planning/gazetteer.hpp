// SPDX-License-Identifier: Apache-2.0
// Looks up the places, zones and devices that terms of a domain name.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "skein/htn/term_store.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Names match regardless of case, since the planner's symbols ignore case; an exact match comes
/// first. `home` and `zero` are the UAV's landing place, unless the world has places of these
/// names.
class Gazetteer {
 public:
  Gazetteer(std::shared_ptr<const Knowledge> knowledge, std::shared_ptr<const world::World> world);

  /// The gazetteer of another UAV of the team in the same world.
  Gazetteer of(const std::string& uav) const;

  /// The place of a name, or of (loc X Y Z) [m, ENU]; a place under the ground is raised to it.
  std::optional<world::Vector3> place(const htn::TermStore& store, htn::Term term) const;
  const world::Zone* zone(const std::string& name) const;
  const world::SensorModel* sensor(const std::string& device) const;

  double ground(const world::Vector3& at) const {
    return world_->terrain.elevation(at.x(), at.y());
  }
  /// Whether the place is on the ground: an object to look at, not a place to fly to.
  bool on_ground(const world::Vector3& at) const;
  /// The place at usual flight altitude over `at`; for a ground vehicle, the ground there.
  world::Vector3 above(const world::Vector3& at) const;
  /// Where a motion to `at` leads: `at` itself if it is in the air and the vehicle flies, else
  /// above(at).
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
