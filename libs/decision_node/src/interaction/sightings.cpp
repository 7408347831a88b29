// SPDX-License-Identifier: Apache-2.0
#include "interaction/sightings.hpp"

#include <algorithm>

namespace skein::decision_node {

interaction::Position position_of(const world::Vector3& v) { return {v.x(), v.y(), v.z()}; }
world::Vector3 vector_of(const interaction::Position& p) { return {p[0], p[1], p[2]}; }

namespace {

/// A place that was given at or below the height of the ground is on it.
interaction::Position not_under(const interaction::Position& place, const world::World& world) {
  return {place[0], place[1], std::max(place[2], world.terrain.elevation(place[0], place[1]))};
}

}  // namespace

const world::Telemetry* Sightings::own() const {
  const auto found = seen_.find(self_);
  return found == seen_.end() ? nullptr : &found->second;
}

void Sightings::see(const mission::KnownPlace& place) {
  if (!place.seen) {
    objects_.erase(place.name);
    return;
  }
  const interaction::Sighting sighting{position_of(place.at), *place.seen, true};
  const auto [known, added] = objects_.try_emplace(place.name, sighting);
  if (!added && known->second.at <= sighting.at) known->second = sighting;
}

interaction::Observer Sightings::observer(const Arguments& arguments, const world::World& world,
                                          MissionTime now) const {
  return [this, &arguments, &world,
          now](const std::string& name) -> std::optional<interaction::Sighting> {
    if (const auto uav = seen_.find(name); uav != seen_.end()) {
      return interaction::Sighting{position_of(uav->second.state.position), uav->second.at};
    }
    if (const auto point = arguments.find(name); point != arguments.end()) {
      const auto* at = std::get_if<interaction::Position>(&point->second);
      if (at != nullptr) return interaction::Sighting{not_under(*at, world), now};
    }
    if (const auto object = objects_.find(name); object != objects_.end()) {
      interaction::Sighting seen = object->second;
      seen.position = not_under(seen.position, world);
      return seen;
    }
    const auto place = world.places.find(name);
    if (place == world.places.end()) return std::nullopt;
    return interaction::Sighting{not_under(position_of(place->second), world), now};
  };
}

}  // namespace skein::decision_node
