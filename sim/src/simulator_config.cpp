// SPDX-License-Identifier: Apache-2.0
#include "skein/sim/simulator_config.hpp"

#include <cmath>
#include <set>
#include <utility>

namespace skein::sim {
namespace {

using Problems = std::vector<std::string>;

bool is_fraction(double x) { return x >= 0 && x <= 1; }

void check_vehicles(const SimulatorConfig& config, Problems& problems) {
  std::set<std::string> names = {kGroundNode};
  for (const SimulatedVehicle& vehicle : config.vehicles) {
    const std::string which = "vehicle '" + vehicle.name + "'";
    if (vehicle.name.empty()) problems.emplace_back("a vehicle has no name");
    if (!names.insert(vehicle.name).second) problems.push_back(which + ": the name is taken");
    if (!vehicle.start.allFinite() ||
        !config.terrain.contains(vehicle.start.x(), vehicle.start.y()))
      problems.push_back(which + " starts outside the terrain");
    if (!std::isfinite(vehicle.heading)) problems.push_back(which + ": the heading is no number");
    if (!is_fraction(vehicle.energy))
      problems.push_back(which + ": energy at the start is not between 0 and 1");
    if (!(vehicle.speed_factor > 0) || !std::isfinite(vehicle.speed_factor))
      problems.push_back(which + ": the speed factor must be greater than 0");
  }
}

void check_models(const SimulatorConfig& config, Problems& problems) {
  for (const SimulatedVehicle& vehicle : config.vehicles) {
    const world::VehicleModel& model = vehicle.model;
    const bool moves = model.cruise_speed > 0 && model.max_speed >= model.cruise_speed &&
                       model.climb_rate > 0 && model.descent_rate > 0 && model.acceleration > 0 &&
                       (model.ceiling > 0 || model.ground) && model.energy.capacity > 0;
    const bool turns = model.hovers ? model.yaw_rate > 0
                                    : model.min_turn_radius > 0 && model.min_speed > 0 &&
                                          model.orbit_radius >= 1.1 * model.min_turn_radius;
    bool looks = !model.pilot || model.pilot->attention_period > Duration();
    for (const world::SensorModel& sensor : model.sensors)
      looks = looks && sensor.period > Duration() && sensor.range > 0 && sensor.aperture > 0;
    if (!moves || !turns || !looks)
      problems.push_back("vehicle '" + vehicle.name + "': its model '" + model.name +
                         "' has figures that must be greater than 0");
  }
}

void check_objects(const SimulatorConfig& config, Problems& problems) {
  std::set<std::string> names;
  for (const world::WorldObject& object : config.objects) {
    const std::string which = "object '" + object.name + "'";
    if (!names.insert(object.name).second) problems.push_back(which + ": the name is taken");
    if (!object.position.allFinite() ||
        !config.terrain.contains(object.position.x(), object.position.y()))
      problems.push_back(which + " is outside the terrain");
    if (!(object.radius >= 0) || !(object.height >= 0) || !(object.speed >= 0))
      problems.push_back(which + ": radius, height and speed must not be negative");
    if (object.spread && (!(object.spread->rate > 0) || !(object.spread->gain >= 0)))
      problems.push_back(which + ": it spreads at a rate above 0, not slower in wind");
    if (object.spread && object.speed > 0)
      problems.push_back(which + ": what spreads does not go along a way");
  }
}

void check_radio(const SimulatorConfig& config, Problems& problems) {
  std::set<std::string> nodes = {kGroundNode};
  for (const SimulatedVehicle& vehicle : config.vehicles) nodes.insert(vehicle.name);
  for (std::string& problem : world::problems_of(config.radio))
    problems.push_back(std::move(problem));
  for (const RadioCut& cut : config.cuts) {
    for (const std::string& node : {cut.a, cut.b})
      if (nodes.count(node) == 0) problems.push_back("radio cut: unknown node '" + node + "'");
    if (cut.a == cut.b) problems.push_back("radio cut: '" + cut.a + "' and itself");
    if (cut.until <= cut.from) problems.emplace_back("radio cut: it ends before it begins");
  }
}

void check_figures(const SimulatorConfig& config, Problems& problems) {
  for (const Duration period :
       {config.step, config.telemetry_period, config.radio_period, config.object_period})
    if (period <= Duration()) problems.emplace_back("periods must be greater than 0");
  if (!config.ground_station.allFinite())
    problems.emplace_back("the position of the ground station is no position");
  const bool wind = std::isfinite(config.wind.toward) && config.wind.speed >= 0 &&
                    config.wind.gusts >= 0 && std::isfinite(config.wind.speed) &&
                    std::isfinite(config.wind.gusts);
  if (!wind) problems.emplace_back("wind: speed and gusts must be finite and not negative");
}

}  // namespace

std::vector<std::string> problems_of(const SimulatorConfig& config) {
  Problems problems;
  check_vehicles(config, problems);
  check_models(config, problems);
  check_objects(config, problems);
  check_radio(config, problems);
  check_figures(config, problems);
  return problems;
}

}  // namespace skein::sim
