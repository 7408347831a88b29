// SPDX-License-Identifier: Apache-2.0
#include "team/team_craft.hpp"

#include <algorithm>

#include "skein/foundation/joined.hpp"
#include "skein/interaction/capabilities.hpp"
#include "skein/mission/vocabulary.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::decision_node {

namespace {

using world::Vector3;

// With the sensors that work.
world::VehicleModel as_it_is(world::VehicleModel vehicle, const world::Telemetry& telemetry) {
  std::erase_if(vehicle.sensors, [&](const world::SensorModel& sensor) {
    return std::ranges::count(telemetry.failed, sensor.device) > 0;
  });
  return vehicle;
}

// Over its landing place.
Vector3 over_home(const supervisor::Knowledge& knowledge) {
  return knowledge.home + Vector3(0, 0, knowledge.altitude);
}

/// It searches or maps a zone, which is done from the air.
bool looks_over_zone(const mission::HighLevelTask& task, const mission::Vocabulary& vocabulary) {
  const auto signature = vocabulary.tasks.find(task.name);
  if (signature == vocabulary.tasks.end() || signature->second.uses.empty()) return false;
  const auto& kinds = signature->second.parameters;
  return std::find(kinds.begin(), kinds.end(), mission::ParameterKind::kZone) != kinds.end();
}

}  // namespace

std::string lacks_now(const interaction::Requirements& needs, const world::VehicleModel& vehicle,
                      const world::Telemetry& telemetry) {
  return interaction::lacking(
      needs, interaction::capabilities_of(as_it_is(vehicle, telemetry), telemetry.state.energy));
}

double TeamCraft::energy() const {
  const world::EnergyModel& model = at_.knowledge->vehicle.energy;
  return std::max(0.0, at_.telemetry.state.energy - model.reserve) * model.capacity;
}

std::optional<refiners::Gate> TeamCraft::visit(auction::TaskNumber task) const {
  const auto found = at_.visits.find(task);
  return found == at_.visits.end() ? std::nullopt : found->second;
}

Vector3 TeamCraft::begins_at() const {
  const world::VehicleState& state = at_.telemetry.state;
  return state.airborne ? state.position
                        : Vector3(state.position + Vector3(0, 0, at_.knowledge->altitude));
}

std::optional<Vector3> TeamCraft::leaves_from(auction::Stopover from) const {
  if (from.is_begin()) return begins_at();
  if (from.is_end()) return over_home(*at_.knowledge);
  const auto gate = visit(from.task());
  return gate ? std::optional(gate->exit) : std::nullopt;
}

std::optional<supervisor::StraightLeg> TeamCraft::straight(auction::Stopover from,
                                                           auction::Stopover to) const {
  const auto begin = leaves_from(from);
  std::optional<refiners::Gate> end = refiners::Gate{over_home(*at_.knowledge), {}, {}};
  if (!to.is_end()) end = visit(to.task());
  if (!begin || !end) return std::nullopt;
  return supervisor::StraightLeg{*begin, end->entry};
}

// A task without a place is done where the UAV is then: there is no flight to it.
std::optional<auction::Leg> TeamCraft::leg(auction::Stopover from, auction::Stopover to) const {
  const auto straight = this->straight(from, to);
  if (!straight) return auction::Leg{};
  const auto known = at_.detours.find({from, to});
  const auto detour = known == at_.detours.end() ? supervisor::Detour() : known->second;
  if (!detour.exists && has_to_be_there(to)) return std::nullopt;
  const world::VehicleModel& vehicle = at_.knowledge->vehicle;
  const refiners::Flight flight =
      refiners::estimate_flight({straight->from, straight->to}, vehicle, at_.world->wind);
  if (flight.duration.expected == Duration::max()) return std::nullopt;
  const double inside = to.is_end() ? 0 : visit(to.task())->inside.to_seconds();
  double seconds = (flight.duration.expected + detour.longer).to_seconds() + inside;
  if (from.is_begin() && is_begun(to)) {
    const double planned = at_.begun->way.to_seconds();
    seconds -= detour.longer.to_seconds();  // which its plan knows
    seconds = inside > 0
                  ? planned
                  : std::max(seconds * at_.begun->slower, planned);  // a sweep may be half over
  }
  const double sweep = inside * world::flight_power(vehicle, vehicle.cruise_speed, 0);
  return auction::Leg{seconds, seconds,
                      flight.energy * vehicle.energy.capacity + detour.energy + sweep};
}

bool TeamCraft::is_begun(auction::Stopover place) const {
  return at_.begun && !place.is_begin() && !place.is_end() && place.task() == at_.begun->task;
}

// A sensor may see a place from elsewhere, and who does something together agrees on other places.
bool TeamCraft::has_to_be_there(auction::Stopover place) const {
  using mission::ParameterKind;
  if (place.is_begin() || place.is_end()) return false;
  const auto order = at_.tasks.find(place.task());
  if (order == at_.tasks.end()) return false;
  const auto& known = at_.knowledge->vocabulary.tasks;
  const auto signature = known.find(order->second.name);
  if (signature == known.end() || !signature->second.uses.empty()) return false;
  const auto& kinds = signature->second.parameters;
  const auto place_alone = [](ParameterKind kind) {
    return kind != ParameterKind::kUavs && kind != ParameterKind::kSyncId &&
           kind != ParameterKind::kZone && kind != ParameterKind::kPlaces;
  };
  return std::all_of(kinds.begin(), kinds.end(), place_alone);
}

double TeamCraft::energy_of(const auction::Task& task) const {
  return task.duration * world::flight_power(at_.knowledge->vehicle, 0, 0);
}

std::optional<std::string> TeamCraft::objection(const auction::Task& task) const {
  if (const auto failed = at_.failed.find(task.number); failed != at_.failed.end()) {
    return "it tried: " + failed->second;
  }
  const auto order = at_.tasks.find(task.number);
  if (order == at_.tasks.end()) return "it was not told what that is";
  if (const auto needs = at_.needs.find(task.number); needs != at_.needs.end()) {
    const auto lacks = lacks_now(needs->second, at_.knowledge->vehicle, at_.telemetry);
    if (!lacks.empty()) return lacks;
  }
  if (at_.knowledge->vehicle.ground && looks_over_zone(order->second, at_.knowledge->vocabulary))
    return "it keeps to the ground, and looks over no zone";
  const world::VehicleModel vehicle = as_it_is(at_.knowledge->vehicle, at_.telemetry);
  mission::Surroundings around;
  for (const auto& [name, place] : at_.world->places) around.places.push_back(name);
  for (const world::Zone& zone : at_.world->zones) around.zones.push_back(zone.name);
  around.uavs = at_.knowledge->team.values();
  around.vehicle = &vehicle;
  mission::UnitMission alone;
  alone.id = mission::MissionId(1);
  alone.tasks = {order->second};
  const std::vector<std::string> problems =
      mission::problems_of(alone, at_.knowledge->vocabulary, around, at_.now);
  if (problems.empty()) return std::nullopt;
  return joined(problems, "; ");
}

}  // namespace skein::decision_node
