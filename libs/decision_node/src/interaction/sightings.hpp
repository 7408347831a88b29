// SPDX-License-Identifier: Apache-2.0
// Known positions of this UAV, its partners, and the objects and places of a joint task.
#pragma once

#include <map>
#include <string>

#include "interaction/joint.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/world/telemetry.hpp"
#include "skein/world/world.hpp"

namespace skein::decision_node {

interaction::Position position_of(const world::Vector3& v);
world::Vector3 vector_of(const interaction::Position& p);

class Sightings {
 public:
  explicit Sightings(std::string self) : self_(std::move(self)) {}

  void see(const world::Telemetry& telemetry) { seen_[telemetry.uav] = telemetry; }
  /// A position of an object, moving or at rest.
  void see(const mission::KnownPlace& place);
  /// This UAV's telemetry; null before the first.
  const world::Telemetry* own() const;
  /// An observer of UAVs and objects at the positions and times at which they were last seen, and
  /// of unnamed points of the arguments and places of the world, which count as seen at `now`.
  /// Lifetime: refers to all parameters and to this object.
  interaction::Observer observer(const Arguments& arguments, const world::World& world,
                                 MissionTime now) const;

 private:
  std::string self_;
  std::map<std::string, world::Telemetry> seen_;
  std::map<std::string, interaction::Sighting> objects_;
};

}  // namespace skein::decision_node
