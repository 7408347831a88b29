// SPDX-License-Identifier: Apache-2.0
// Where this UAV, its partners and the places of a joint task are, as far as is known.
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
  /// An object that moves, or one of which it is said from now on where it stays.
  void see(const mission::KnownPlace& place);
  /// Null before it was told.
  const world::Telemetry* own() const;
  /// UAVs and objects as they were seen, of when they were seen; points of the arguments that have
  /// no name, and places of the world, as of `now`: they are where they are said to be until
  /// something else is said. Lifetime: refers to all of these.
  interaction::Observer observer(const Arguments& arguments, const world::World& world,
                                 MissionTime now) const;

 private:
  std::string self_;
  std::map<std::string, world::Telemetry> seen_;
  std::map<std::string, interaction::Sighting> objects_;
};

}  // namespace skein::decision_node
