// SPDX-License-Identifier: Apache-2.0
// One vehicle of the functional simulator, that is given one task after another.
#pragma once

#include <string>
#include <vector>

#include "skein/refiners/flight.hpp"
#include "skein/sim/simulator.hpp"

namespace skein::supervisor::testing {

/// What came of a task.
struct Flown {
  double seconds = -1;  ///< -1: not ended
  std::string why;
};

/// Thread rule: one thread. The world must outlive it.
class Range {
 public:
  Range(const world::World& world, const world::VehicleModel& model, std::uint64_t seed)
      : simulator_(config(world, model, seed)) {}

  Flown fly(const std::string& type, functional::Parameters parameters, double patience) {
    const functional::TaskId id(++last_);
    track_ = {position()};
    headings_ = {heading()};
    const MissionTime began = now_;
    const sim::FunctionalRequest request{
        "uav", {functional::Verb::kDispatch, id, type, std::move(parameters)}};
    auto effects = simulator_.handle(request, now_);
    while ((now_ - began).to_seconds() < patience) {
      for (const sim::Effect& one : effects) {
        const auto* told = std::get_if<sim::FunctionalStatus>(&one);
        if (told == nullptr || told->status.id != id) continue;
        if (told->status.state == functional::TaskState::kAborted) return {-1, told->status.reason};
        if (told->status.state == functional::TaskState::kEnded)
          return {(told->at - began).to_seconds(), ""};
      }
      now_ = now_ + Duration::milliseconds(100);
      effects = simulator_.handle(sim::Tick{}, now_);
      track_.push_back(position());
      headings_.push_back(heading());
    }
    return {-1, "not ended in " + std::to_string(patience) + " s"};
  }

  /// Where it was every tenth of a second of the last task.
  const std::vector<world::Vector3>& track() const { return track_; }
  const std::vector<double>& headings() const { return headings_; }
  world::Vector3 position() const { return simulator_.find_vehicle("uav")->position; }
  double heading() const { return simulator_.find_vehicle("uav")->heading; }

 private:
  static sim::SimulatorConfig config(const world::World& world, const world::VehicleModel& model,
                                     std::uint64_t seed) {
    sim::SimulatorConfig config{world.terrain};
    config.wind = world.wind;
    config.radio = world.radio;
    config.vehicles = {{"uav", model, world::Vector2::Zero(), 0, 1}};
    config.seed = seed;
    return config;
  }

  sim::Simulator simulator_;
  MissionTime now_;
  std::vector<world::Vector3> track_;
  std::vector<double> headings_;
  std::uint64_t last_ = 0;
};

inline functional::Parameters waypoints(const refiners::Way& way) {
  std::vector<double> numbers;
  for (std::size_t i = way.size() > 1 ? 1 : 0; i < way.size(); ++i)
    numbers.insert(numbers.end(), {way[i].x(), way[i].y(), way[i].z()});
  functional::Parameters parameters;
  parameters.add("waypoints", std::move(numbers));
  return parameters;
}

}  // namespace skein::supervisor::testing
