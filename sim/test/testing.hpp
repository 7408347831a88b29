// SPDX-License-Identifier: Apache-2.0
// Builders for the simulator's tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "skein/sim/simulator.hpp"
#include "skein/world/vehicle_model_reader.hpp"

namespace skein::sim::testing {

using functional::TaskId;
using functional::TaskState;

inline MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

inline world::TerrainSpec flat_spec() {
  world::TerrainSpec spec;
  spec.west = spec.south = -1000;
  spec.east = spec.north = 2000;
  return spec;
}
inline world::Terrain flat() { return world::Terrain(flat_spec()); }
inline world::Terrain with_hill(double x, double y, double height, double radius) {
  world::TerrainSpec spec = flat_spec();
  spec.hills.push_back({{x, y}, height, radius});
  return world::Terrain(spec);
}

/// A model of the COMETS scenario, from its file.
inline world::VehicleModel model_of(const std::string& name) {
  const std::string path = SKEIN_SOURCE_DIR "/scenarios/comets/models/" + name + ".yaml";
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  const auto model = world::read_vehicle_model(text.str(), path);
  if (!model) ADD_FAILURE() << to_text(model.error());
  return model ? *model : world::VehicleModel();
}

inline SimulatedVehicle a_vehicle(const std::string& name, double x = 0, double y = 0) {
  SimulatedVehicle vehicle;
  vehicle.name = name;
  vehicle.model = model_of(name);
  vehicle.start = {x, y};
  return vehicle;
}

inline world::WorldObject an_object(const std::string& kind, double x, double y) {
  world::WorldObject object;
  object.name = kind;
  object.kind = kind;
  object.position = {x, y};
  object.radius = 3;
  return object;
}

inline SimulatorConfig a_config(const std::vector<std::string>& vehicles = {"marvin"}) {
  SimulatorConfig config{flat()};
  config.radio = {5000, true, Duration::milliseconds(20), 0.01, 0.05};
  config.ground_station = {0, 0, 3};
  double y = 0;
  for (const std::string& name : vehicles) config.vehicles.push_back(a_vehicle(name, 0, y += 10));
  return config;
}

inline functional::Parameters way(const std::vector<world::Vector3>& points) {
  std::vector<double> numbers;
  for (const world::Vector3& p : points) numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
  return functional::Parameters().add("waypoints", numbers);
}
inline functional::Parameters altitude(double metres) {
  return functional::Parameters().add("altitude", metres);
}
inline functional::Parameters device(const std::string& name) {
  return functional::Parameters().add("device", name);
}

/// A simulator with its log, driven as a decision node would drive it.
class Flight {
 public:
  explicit Flight(SimulatorConfig config) : simulator_(std::move(config)) { run_until(0); }

  void give(const Input& input) { append(simulator_.handle(input, at(now_))); }
  void dispatch(const std::string& uav, std::uint64_t task, const std::string& type,
                functional::Parameters parameters = {}) {
    give(FunctionalRequest{
        uav, {functional::Verb::kDispatch, TaskId(task), type, std::move(parameters)}});
  }
  void interrupt(const std::string& uav, std::uint64_t task) {
    give(FunctionalRequest{uav, {functional::Verb::kInterrupt, TaskId(task)}});
  }
  void run_until(double seconds) {
    now_ = seconds;
    append(simulator_.handle(Tick{}, at(now_)));
  }
  void run_for(double seconds) { run_until(now_ + seconds); }
  /// Steps until the task is terminal; false if it is not after `limit` seconds.
  bool run_to_end_of(std::uint64_t task, double limit = 600) {
    for (const double until = now_ + limit; now_ < until;) {
      if (terminal(task)) return true;
      run_for(0.1);
    }
    return terminal(task);
  }
  /// Takes off and waits for it; the task id is used up.
  void take_off(const std::string& uav, std::uint64_t task, double metres) {
    dispatch(uav, task, "takeoff", altitude(metres));
    EXPECT_TRUE(run_to_end_of(task)) << "no end of the takeoff of " << uav;
  }

  std::vector<FunctionalStatus> statuses(std::uint64_t task) const {
    std::vector<FunctionalStatus> found;
    for (const auto& told : all<FunctionalStatus>())
      if (told.status.id == TaskId(task)) found.push_back(told);
    return found;
  }
  /// "running ended", "running aborted", …
  std::string history(std::uint64_t task) const {
    std::string text;
    for (const auto& status : statuses(task))
      text += (text.empty() ? "" : " ") + std::string(to_text(status.status.state));
    return text;
  }
  std::string reason(std::uint64_t task) const {
    const auto found = statuses(task);
    return found.empty() ? "" : found.back().status.reason;
  }
  bool terminal(std::uint64_t task) const {
    const auto found = statuses(task);
    return !found.empty() && found.back().status.state != TaskState::kRunning;
  }
  template <class Kind>
  std::vector<Kind> all() const {
    std::vector<Kind> found;
    for (const Effect& effect : log_)
      if (const auto* kind = std::get_if<Kind>(&effect)) found.push_back(*kind);
    return found;
  }
  const world::VehicleState& state(const std::string& uav) const {
    return *simulator_.find_vehicle(uav);
  }
  const std::vector<Effect>& log() const { return log_; }
  void forget() { log_.clear(); }
  double now() const { return now_; }
  Simulator& simulator() { return simulator_; }

 private:
  void append(std::vector<Effect> effects) {
    log_.insert(log_.end(), effects.begin(), effects.end());
  }

  Simulator simulator_;
  std::vector<Effect> log_;
  double now_ = 0;
};

}  // namespace skein::sim::testing
