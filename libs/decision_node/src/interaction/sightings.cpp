// SPDX-License-Identifier: Apache-2.0
#include "interaction/sightings.hpp"

namespace skein::decision_node {

interaction::Position position_of(const world::Vector3& v) { return {v.x(), v.y(), v.z()}; }
world::Vector3 vector_of(const interaction::Position& p) { return {p[0], p[1], p[2]}; }

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
      if (at != nullptr) return interaction::Sighting{*at, now};
    }
    if (const auto object = objects_.find(name); object != objects_.end()) return object->second;
    const auto place = world.places.find(name);
    if (place == world.places.end()) return std::nullopt;
    return interaction::Sighting{position_of(place->second), now};
  };
}

}  // namespace skein::decision_node
