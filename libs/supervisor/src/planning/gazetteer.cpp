// SPDX-License-Identifier: Apache-2.0
#include "planning/gazetteer.hpp"

#include <algorithm>
#include <cmath>

#include "planning/terms.hpp"
#include "skein/mission/home.hpp"

namespace skein::supervisor {

using htn::Term;
using htn::TermStore;
using world::Vector3;

namespace {

/// Lower than this over the ground nothing is flown to [m].
constexpr double kLowestFlight = 5;
/// Kept from the ceiling, so that it is not touched by what a vehicle wavers [m].
constexpr double kBelowCeiling = 1;

template <class Range, class Name>
auto found_by_name(const Range& range, const std::string& name, Name name_of) {
  const auto exact = std::find_if(range.begin(), range.end(),
                                  [&](const auto& one) { return name_of(one) == name; });
  if (exact != range.end()) return exact;
  return std::find_if(range.begin(), range.end(),
                      [&](const auto& one) { return same_name(name_of(one), name); });
}

}  // namespace

Gazetteer::Gazetteer(std::shared_ptr<const Knowledge> knowledge,
                     std::shared_ptr<const world::World> world)
    : knowledge_(std::move(knowledge)), world_(std::move(world)) {}

Gazetteer Gazetteer::of(const std::string& uav) const {
  auto theirs = std::make_shared<Knowledge>();
  theirs->uav = uav;
  theirs->vehicle = knowledge_->vehicle;
  theirs->home = knowledge_->home;
  theirs->altitude = knowledge_->altitude;
  for (const Partner& one : knowledge_->partners) {
    if (!same_name(one.uav, uav)) continue;
    theirs->vehicle = one.vehicle;
    theirs->home = one.home;
    theirs->altitude = one.altitude;
  }
  return {std::move(theirs), world_};
}

std::optional<Vector3> Gazetteer::place(const TermStore& store, Term term) const {
  std::optional<Vector3> at = location_of(store, term);
  if (!at) at = named_place(text_of(store, unquoted(store, term)));
  if (at) at->z() = std::max(at->z(), ground(*at));  // what lies under the ground is on it
  return at;
}

std::optional<Vector3> Gazetteer::named_place(const std::string& name) const {
  const auto found = found_by_name(world_->places, name, [](const auto& one) { return one.first; });
  if (found != world_->places.end()) return found->second;
  if (mission::means_home(name)) return knowledge_->home;
  return std::nullopt;
}

const world::Zone* Gazetteer::zone(const std::string& name) const {
  const auto found = found_by_name(world_->zones, name, [](const auto& one) { return one.name; });
  return found == world_->zones.end() ? nullptr : &*found;
}

const world::SensorModel* Gazetteer::sensor(const std::string& device) const {
  const auto& sensors = knowledge_->vehicle.sensors;
  const auto found = found_by_name(sensors, device, [](const auto& one) { return one.device; });
  return found == sensors.end() ? nullptr : &*found;
}

bool Gazetteer::on_ground(const Vector3& at) const { return at.z() - ground(at) < kLowestFlight; }

Vector3 Gazetteer::above(const Vector3& at) const {
  const double most = knowledge_->vehicle.ground ? 0 : knowledge_->vehicle.ceiling - kBelowCeiling;
  return {at.x(), at.y(), ground(at) + std::min(knowledge_->altitude, most)};
}

std::string Gazetteer::words(const TermStore& store, Term place) {
  const auto location = location_of(store, place);
  if (!location) return text_of(store, unquoted(store, place));
  const auto figure = [](double value) { return std::to_string(std::lround(value)); };
  return "(" + figure(location->x()) + ", " + figure(location->y()) + ", " + figure(location->z()) +
         ")";
}

}  // namespace skein::supervisor
