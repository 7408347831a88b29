// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_setup/page_world.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "joint_constraints.hpp"
#include "page_grid.hpp"
#include "skein/deliberation_setup/knowledge.hpp"
#include "skein/scenario_setup/setup.hpp"

namespace skein::ground_setup {

namespace {

using Json = nlohmann::ordered_json;
using scenario::Scenario;

Json corners_of(const world::Polygon& polygon) {
  Json corners = Json::array();
  for (const world::Vector2& one : polygon) corners.push_back({one.x(), one.y()});
  return corners;
}

Json terrain_of(const world::TerrainSpec& spec) {
  const world::Terrain terrain(spec);
  const world::Grid grid = page_grid(spec);
  Json heights = Json::array();
  for (std::size_t point = 0; point < grid.size(); ++point) {
    const world::Vector2 at = grid.centre(point);
    heights.push_back(std::round(terrain.elevation(at.x(), at.y()) * 10) / 10);
  }
  return {{"west", spec.west}, {"south", spec.south},
          {"east", spec.east}, {"north", spec.north},
          {"step", grid.cell}, {"columns", grid.columns},
          {"rows", grid.rows}, {"heights", std::move(heights)}};
}

Json volume_of(const world::Volume& volume) {
  Json json{{"name", volume.name}, {"polygon", corners_of(volume.polygon)}};
  if (std::isfinite(volume.floor)) json["floor"] = volume.floor;
  if (std::isfinite(volume.ceiling)) json["ceiling"] = volume.ceiling;
  return json;
}

/// Of what its store holds: one metre at cruise speed, and what no way may use.
Json energy_of(const world::VehicleModel& model) {
  const world::EnergyModel& energy = model.energy;
  return {{"metre", energy.cruise_power / model.cruise_speed / energy.capacity},
          {"reserve", energy.reserve}};
}

Json uav_of(const scenario::UavSpec& uav, const node::Roster& roster) {
  Json sensors = Json::array();
  for (const world::SensorModel& sensor : uav.model.sensors) sensors.push_back(sensor.device);
  return {{"name", uav.name},
          {"number", roster.find(uav.name)->number.value()},
          {"model", uav.model.name},
          {"start", {uav.start.x(), uav.start.y()}},
          {"energy", energy_of(uav.model)},
          {"sensors", std::move(sensors)}};
}

Json tasks_of(const Scenario& scenario) {
  Json tasks = Json::array();
  if (!scenario.planning) return tasks;
  const auto vocabulary = deliberation_setup::vocabulary_of(scenario);
  if (!vocabulary) return tasks;
  for (const auto& [name, signature] : vocabulary->tasks) {
    Json kinds = Json::array();
    for (const mission::ParameterKind kind : signature.parameters) kinds.push_back(to_text(kind));
    tasks.push_back({{"name", name}, {"parameters", std::move(kinds)}});
  }
  return tasks;
}

}  // namespace

std::string page_world(const Scenario& scenario) {
  const node::Roster roster = scenario_setup::roster_of(scenario);
  Json uavs = Json::array(), zones = Json::array(), places = Json::array(), air = Json::array();
  for (const scenario::UavSpec& uav : scenario.uavs) uavs.push_back(uav_of(uav, roster));
  for (const world::Zone& zone : scenario.world.zones) {
    zones.push_back({{"name", zone.name}, {"polygon", corners_of(zone.polygon)}});
  }
  for (const auto& [name, at] : scenario.world.places) {
    places.push_back({{"name", name}, {"at", {at.x(), at.y(), at.z()}}});
  }
  for (const world::Volume& volume : scenario.world.volumes) air.push_back(volume_of(volume));
  const world::Vector3& ground = scenario.ground.position;
  const Json team = scenario.team ? Json(scenario.team->roster.names()) : Json::array();
  const Json joint =
      scenario.interaction ? joint_constraints(*scenario.interaction) : Json::object();
  const Json page{{"scenario", scenario.name},
                  {"ground", {ground.x(), ground.y(), ground.z()}},
                  {"terrain", terrain_of(scenario.world.terrain)},
                  {"zones", std::move(zones)},
                  {"places", std::move(places)},
                  {"air", std::move(air)},
                  {"uavs", std::move(uavs)},
                  {"team", team},
                  {"tasks", tasks_of(scenario)},
                  {"joint", joint}};
  return page.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace skein::ground_setup
