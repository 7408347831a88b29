// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/history.hpp"

#include <algorithm>

namespace skein::laws {

bool Execution::is_motion() const {
  return type == "takeoff" || type == "goto" || type == "land" || type == "wait";
}

bool Goal::settled() const {
  return state() == "achieved" || state() == "failed" || state() == "cancelled";
}

std::optional<double> Goal::when(std::string_view wanted) const {
  for (auto it = changes.rbegin(); it != changes.rend(); ++it) {
    if (it->state == wanted) return it->at;
  }
  return std::nullopt;
}

int Uav::degree(double instant) const {
  int degree = spec->degree;
  for (const auto& [from, value] : degrees) {
    if (from <= instant) degree = value;
  }
  return degree;
}

bool Uav::deliberates(double from, double until) const {
  if (degree(from) < 4) return false;
  return std::none_of(degrees.begin(), degrees.end(), [&](const auto& change) {
    return change.first > from && change.first <= until && change.second < 4;
  });
}

std::optional<Sample> Uav::at(double instant) const {
  const auto next = std::lower_bound(samples.begin(), samples.end(), instant,
                                     [](const Sample& sample, double t) { return sample.at < t; });
  if (next == samples.end()) return std::nullopt;
  if (next == samples.begin()) {
    if (next->at > instant) return std::nullopt;
    return *next;
  }
  const Sample& before = *std::prev(next);
  const double part = (instant - before.at) / (next->at - before.at);
  Sample result = before;
  result.at = instant;
  result.position += part * (next->position - before.position);
  result.velocity += part * (next->velocity - before.velocity);
  result.heading += part * world::wrapped(next->heading - before.heading);
  result.energy += part * (next->energy - before.energy);
  return result;
}

bool Uav::is_out(const Sample& sample) const {
  constexpr double kStands = 0.2;  // [m/s]
  return sample.airborne || (spec->model.ground && sample.velocity.head<2>().norm() > kStands);
}

std::int64_t Uav::goal_of_task(std::int64_t task) const {
  const auto found = goal_of.find(task);
  return found == goal_of.end() ? 0 : found->second;
}

std::vector<const Activity*> Uav::activities_of(std::int64_t goal) const {
  std::vector<const Activity*> result;
  for (const Activity& activity : activities) {
    if (goal_of_task(activity.task) == goal) result.push_back(&activity);
  }
  return result;
}

bool Uav::had_fault(std::string_view what, double until) const {
  return std::any_of(faults.begin(), faults.end(), [&](const auto& fault) {
    return fault.first <= until && fault.second.rfind(what, 0) == 0;
  });
}

std::optional<world::Vector3> History::place(const mission::Argument& argument, double at) const {
  if (const auto* point = std::get_if<world::Vector3>(&argument)) return *point;
  const auto* name = std::get_if<std::string>(&argument);
  if (name == nullptr) return std::nullopt;
  const auto alarm = alarms.find(*name);
  if (alarm != alarms.end()) {
    const auto after = alarm->second.upper_bound(at);
    return after == alarm->second.begin() ? after->second : std::prev(after)->second;
  }
  const auto told =
      std::find_if(objects_told.rbegin(), objects_told.rend(),
                   [&](const ObjectTold& one) { return one.name == *name && one.told <= at; });
  if (told != objects_told.rend()) return told->position;
  const auto found = scenario->world.places.find(*name);
  if (found == scenario->world.places.end()) return std::nullopt;
  return found->second;
}

std::vector<world::Vector3> History::places(const Uav& uav, const mission::Argument& argument,
                                            double from, double until) const {
  std::optional<world::Vector3> before = place(argument, was_told_of(uav, argument) ? from : until);
  std::vector<world::Vector3> meanwhile;
  for (const PlaceKnown& told : uav.places_known) {
    if (mission::Argument(told.name) != argument || told.at > until) continue;
    if (told.at <= from) before = told.position;
    if (told.at > from) meanwhile.push_back(told.position);
  }
  if (before) meanwhile.push_back(*before);
  return meanwhile;
}

bool History::was_told_of(const Uav& uav, const mission::Argument& argument) const {
  return std::ranges::any_of(uav.places_known, [&](const PlaceKnown& told) {
    return mission::Argument(told.name) == argument;
  });
}

bool History::is_alarm(const mission::Argument& argument) const {
  const auto* name = std::get_if<std::string>(&argument);
  return name != nullptr && alarms.count(*name) != 0;
}

bool History::is_followed(const mission::Argument& argument) const {
  const auto* name = std::get_if<std::string>(&argument);
  return name != nullptr && std::any_of(objects_told.begin(), objects_told.end(),
                                        [&](const ObjectTold& one) { return one.name == *name; });
}

bool History::in_the_air(const world::Vector3& at) const {
  constexpr double kOverGround = 5;
  return at.z() - terrain.elevation(at.x(), at.y()) >= kOverGround;
}

const world::Zone* History::zone(const mission::Argument& argument) const {
  const auto* name = std::get_if<std::string>(&argument);
  if (name == nullptr) return nullptr;
  for (const world::Zone& zone : scenario->world.zones) {
    if (zone.name == *name) return &zone;
  }
  return nullptr;
}

bool History::was_away(const std::string& node, double from, double until) const {
  const auto found = away.find(node);
  return found != away.end() && std::ranges::any_of(found->second, [&](const auto& while_away) {
           return while_away.first <= until && while_away.second >= from;
         });
}

std::optional<double> History::lost_since(const std::string& uav, double at) const {
  const auto found = lost.find(uav);
  if (found == lost.end()) return std::nullopt;
  for (const auto& [from, until] : found->second)
    if (from <= at && at < until) return from;
  return std::nullopt;
}

bool History::was_killed(const std::string& node) const {
  return dead.contains(node) && !resumed.contains(node);
}

}  // namespace skein::laws
