// SPDX-License-Identifier: Apache-2.0
// A bridge and a vehicle on one link, in virtual time.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "skein/autopilot/bridge.hpp"
#include "skein/foundation/random.hpp"
#include "skein/world/vehicle_model_reader.hpp"
#include "vehicle/mavlink_vehicle.hpp"

namespace skein::autopilot::testing {

using functional::TaskId;
using functional::TaskState;

inline world::VehicleModel marvin() {
  const std::string path = SKEIN_SOURCE_DIR "/scenarios/comets/models/marvin.yaml";
  std::ifstream in(path);
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  return world::read_vehicle_model(text, path).value();
}

/// Ground at 120 m with a hill in the north, where the geoid is 47 m above the ellipsoid.
inline world::Terrain ground() {
  world::TerrainSpec spec;
  spec.west = spec.south = -1000;
  spec.east = spec.north = 1000;
  spec.base = 120;
  spec.hills.push_back({{0, 500}, 60, 200});
  return world::Terrain(spec);
}

/// What the link does to datagrams, both ways.
struct Trouble {
  double loss = 0;          ///< probability
  std::size_t garbage = 0;  ///< most bytes before each
};

class Rig {
 public:
  explicit Rig(Dialect dialect = Dialect::kArdupilot, Trouble trouble = {})
      : bridge_(config()), vehicle_(vehicle_config(dialect)), trouble_(trouble) {}

  static BridgeConfig config() {
    return {.uav = "heliv", .model = marvin(), .terrain = ground(), .origin = {37.3, -6, 150}};
  }
  static MavlinkVehicleConfig vehicle_config(Dialect dialect) {
    MavlinkVehicleConfig config{.model = marvin(), .terrain = ground(), .origin = {37.3, -6, 150}};
    config.dialect = dialect;
    return config;
  }

  MavlinkVehicle& vehicle() { return vehicle_; }
  Bridge& bridge() { return bridge_; }
  Duration now() const { return now_; }

  void give(const Input& input) { collect(bridge_.handle(input, now_)); }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 10 + 0.5); ++i) step();
  }
  /// As soon as the condition holds; fails the test when it does not within so many seconds.
  template <class Condition>
  void until(const std::string& what, Condition condition, double seconds = 120) {
    for (int i = 0; i < static_cast<int>(seconds * 10); ++i) {
      if (condition()) return;
      step();
    }
    ADD_FAILURE() << "not within " << seconds << " s: " << what;
  }

  std::uint64_t dispatch(const std::string& type, functional::Parameters parameters = {}) {
    give(functional::Request{functional::Verb::kDispatch, TaskId(++last_), type,
                             std::move(parameters)});
    return last_;
  }
  void interrupt(std::uint64_t task) {
    give(functional::Request{functional::Verb::kInterrupt, TaskId(task)});
  }
  /// Stands ready, takes off to 30 m.
  void take_off() {
    until(
        "ready", [&] { return bridge_.is_ready(); }, 20);
    const auto task = dispatch("takeoff", functional::Parameters().add("altitude", 30));
    until("up", [&] { return last_of(task) == "ended "; });
  }
  /// Flies away and is on its way.
  std::uint64_t fly_away() {
    const auto task =
        dispatch("goto", functional::Parameters().add("waypoints", {300, 0, 150, 300, 100, 150}));
    until("on its way", [&] { return vehicle_.state().velocity.norm() > 5; });
    return task;
  }

  /// "running ", "aborted the reason"; empty: nothing was told.
  std::string last_of(std::uint64_t task) const {
    const auto all = told(task);
    return all.empty() ? "" : all.back();
  }
  std::vector<std::string> told(std::uint64_t task) const {
    std::vector<std::string> all;
    for (const functional::Status& one : statuses_) {
      if (one.id == TaskId(task)) all.push_back(std::string(to_text(one.state)) + " " + one.reason);
    }
    return all;
  }
  const std::vector<std::string>& notices() const { return notices_; }
  const std::vector<world::Perception>& perceptions() const { return perceptions_; }
  const std::vector<world::Telemetry>& telemetry() const { return telemetry_; }
  std::vector<functional::Status> take_statuses() { return std::exchange(news_, {}); }

  void step() {
    now_ = now_ + Bridge::kPeriod;
    for (const mavlink::Bytes& bytes : vehicle_.step(now_)) {
      if (auto left = carried(bytes)) give(Heard{std::move(*left)});
    }
    give(Tick{});
  }
  void set_trouble(Trouble trouble) { trouble_ = trouble; }

 private:
  std::optional<mavlink::Bytes> carried(const mavlink::Bytes& bytes) {
    if (random_.chance(trouble_.loss)) return std::nullopt;
    mavlink::Bytes spoilt;
    const auto count = trouble_.garbage == 0 ? 0 : random_.below(trouble_.garbage);
    for (std::uint64_t i = 0; i < count; ++i)
      spoilt.push_back(static_cast<std::uint8_t>(random_.bits()));
    spoilt.insert(spoilt.end(), bytes.begin(), bytes.end());
    return spoilt;
  }
  void collect(std::vector<Effect> effects) {
    for (Effect& effect : effects) {
      if (auto* sent = std::get_if<Transmit>(&effect)) {
        if (auto left = carried(sent->bytes)) vehicle_.hear(*left);
      } else if (auto* status = std::get_if<functional::Status>(&effect)) {
        statuses_.push_back(*status);
        news_.push_back(*status);
      } else if (auto* notice = std::get_if<Notice>(&effect)) {
        notices_.push_back(notice->text);
      } else if (auto* look = std::get_if<world::Perception>(&effect)) {
        perceptions_.push_back(*look);
      } else if (auto* telemetry = std::get_if<world::Telemetry>(&effect)) {
        telemetry->at = MissionTime() + now_;
        telemetry_.push_back(*telemetry);
      }
    }
  }

  Bridge bridge_;
  MavlinkVehicle vehicle_;
  Trouble trouble_;
  Random random_{7};
  Duration now_{};
  std::uint64_t last_ = 0;
  std::vector<functional::Status> statuses_, news_;
  std::vector<std::string> notices_;
  std::vector<world::Perception> perceptions_;
  std::vector<world::Telemetry> telemetry_;
};

}  // namespace skein::autopilot::testing
