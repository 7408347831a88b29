// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/capabilities.hpp"

#include <algorithm>

#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/foundation/shortest_text.hpp"
#include "skein/interaction/describe.hpp"

namespace skein::interaction {

namespace {

bool stands(double figure, const Requirement::Bound& bound) {
  switch (bound.relation) {
    case Relation::kLess:
      return figure < bound.value;
    case Relation::kAtMost:
      return figure <= bound.value;
    case Relation::kEqual:
      return figure == bound.value;
    case Relation::kAtLeast:
      return figure >= bound.value;
    case Relation::kGreater:
      return figure > bound.value;
  }
  return false;
}

bool meets(const Requirement& requirement, const Capabilities& capabilities) {
  const auto found = capabilities.find(requirement.capability);
  if (found == capabilities.end()) return false;
  return std::visit(
      Overloaded{[](std::monostate) { return true; },
                 [&](const std::string& value) { return found->second.values.count(value) > 0; },
                 [&](const Requirement::Bound& bound) {
                   return found->second.figure && stands(*found->second.figure, bound);
                 }},
      requirement.value);
}

}  // namespace

Capabilities capabilities_of(const world::VehicleModel& vehicle, double energy) {
  Capabilities all;
  if (vehicle.hovers) all["hovering"] = {};
  all["relay"] = {};  // every node has the radio
  all["radio"].values.insert("relay");
  all["speed"].figure = vehicle.max_speed;
  all["ceiling"].figure = vehicle.ceiling;
  for (const world::SensorModel& sensor : vehicle.sensors) {
    all["camera"].values.insert(sensor.device);
    all[sensor.device + "-range"].figure = sensor.range;
  }
  if (vehicle.energy.capacity > 0 && vehicle.energy.hover_power > 0) {
    const double left = std::max(0.0, energy - vehicle.energy.reserve);
    all["endurance"].figure = left * vehicle.energy.capacity / vehicle.energy.hover_power;
  }
  for (const auto& [name, figure] : vehicle.abilities) all[name].figure = figure;
  return all;
}

std::vector<Requirement> unmet(const std::vector<Requirement>& requirements,
                               const Capabilities& capabilities) {
  std::vector<Requirement> missing;
  for (const Requirement& one : requirements) {
    if (!meets(one, capabilities)) missing.push_back(one);
  }
  return missing;
}

std::string lacking(const std::vector<Requirement>& requirements,
                    const Capabilities& capabilities) {
  std::vector<std::string> all;
  for (const Requirement& one : unmet(requirements, capabilities)) {
    const auto has = capabilities.find(one.capability);
    const bool has_figure = has != capabilities.end() && has->second.figure;
    all.push_back(describe(one) +
                  (has_figure ? " (it has " + shortest_text(*has->second.figure) + ")" : ""));
  }
  return all.empty() ? "" : "it lacks " + joined(all, ", ");
}

}  // namespace skein::interaction
