// SPDX-License-Identifier: Apache-2.0
// A node that may plan, and plans made by hand in place of its jobs.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "level_world.hpp"
#include "skein/supervisor/supervisor.hpp"
#include "skein/translation/missions.hpp"
#include "testing/bench.hpp"

namespace skein::ddn::testing {

inline world::VehicleModel a_vehicle() {
  world::VehicleModel vehicle;
  vehicle.name = "heli";
  vehicle.cruise_speed = 5;
  vehicle.max_speed = 10;
  vehicle.climb_rate = 2;
  vehicle.descent_rate = 2;
  vehicle.energy.capacity = 1e6;
  world::SensorModel camera;
  camera.device = "camera";
  vehicle.sensors.push_back(camera);
  return vehicle;
}

/// The node of "marvin", which knows the high-level tasks "fly PLACE" and "look PLACE" (with a
/// camera) and the places P1 and P2.
inline DdnConfig deliberating(int degree, ContactPolicy policy = ContactPolicy::kContinue) {
  DdnConfig config = Bench::with_policy(degree, policy);
  auto knowledge = std::make_shared<supervisor::Knowledge>();
  knowledge->uav = "marvin";
  knowledge->vehicle = a_vehicle();
  knowledge->team = {"marvin", "heliv"};
  knowledge->vocabulary.tasks["fly"] = {"fly", {mission::ParameterKind::kPlace}, {}};
  knowledge->vocabulary.tasks["look"] = {"look", {mission::ParameterKind::kPlace}, {"sight"}};
  knowledge->vocabulary.serves.emplace("camera", "sight");
  auto world = std::make_shared<world::World>(skein::testing::level_world(1000));
  world->places["P1"] = {100, 0, 40};
  world->places["P2"] = {0, 100, 40};
  config.knowledge = knowledge;
  config.world = world;
  config.first_task = executive::TaskId(100);
  return config;
}

inline wire::MissionRequest commanded(std::uint64_t number, wire::MissionRequest sample) {
  sample.header.incarnation = 1;
  sample.command = number;
  return sample;
}

/// A mission of one high-level task with the number of the mission times 100 and 1.
inline wire::MissionRequest mission_to(std::uint64_t number, std::uint64_t id,
                                       const std::string& task = "fly",
                                       const std::string& place = "P1") {
  mission::UnitMission mission;
  mission.id = mission::MissionId(id);
  mission.tasks = {{mission::GoalId(id * 100 + 1), task, {place}, {}}};
  mission.asked_by = "operator";
  return commanded(number, translation::to_wire(mission));
}

inline wire::MissionRequest cancellation(std::uint64_t number) {
  return commanded(number, translation::to_wire(mission::CancelGoals{}, "operator"));
}

inline mission::ElementaryTask planned(std::uint64_t id, const std::string& type,
                                       std::uint64_t goal, std::uint64_t after = 0) {
  mission::ElementaryTask task;
  task.id = executive::TaskId(id);
  task.type = type;
  task.name = "task-" + type;
  task.origin = mission::GoalId(goal);
  task.methods = {"fly there"};
  task.way = {{0, 0, 40}, {100, 0, 40}};
  task.duration = {Duration::seconds(20), Duration::seconds(30)};
  task.start = {Duration(), Duration::max()};
  if (after != 0) task.dependences = {{mission::DependenceKind::kEnded, executive::TaskId(after)}};
  return task;
}

/// What the job of an insertion could have made: takeoff, goto, land under three ids in a row.
inline supervisor::DeliberationResult three_tasks(std::uint64_t first, std::uint64_t goal) {
  supervisor::InsertionOutcome outcome;
  mission::ElementaryPlan plan;
  plan.tasks = {planned(first, "takeoff", goal), planned(first + 1, "goto", goal, first),
                planned(first + 2, "land", goal, first + 1)};
  outcome.plan = plan;
  outcome.order = {{mission::GoalId(goal), "fly", {std::string("P1")}, {}}};
  outcome.schedule = supervisor::schedule(plan.tasks, {}, MissionTime());
  return outcome;
}

/// The high-level task of mission 7.
inline constexpr std::uint64_t kGoal = 701;

inline std::vector<std::string> finish(Bench& bench, std::uint64_t job,
                                       const supervisor::DeliberationResult& result) {
  return bench.give(node::JobDone{job, std::any(result)});
}

/// Mission 7 is planned as takeoff 100, goto 101, land 102, and begun.
inline void plan(Bench& bench) {
  bench.give(node::Started{1, true});
  bench.hear_ground(true);
  bench.from_sim(telemetry(false));
  bench.from_ground(mission_to(1, 7));
  const std::uint64_t job = bench.jobs().at(0).id;
  finish(bench, job, three_tasks(100, kGoal));
}

// The takeoff is over, the flight is on.
inline void take_off(Bench& bench) {
  bench.from_sim(status(100, wire::TaskState::kRunning));
  bench.from_sim(status(100, wire::TaskState::kEnded));
  bench.from_sim(telemetry(true));
  bench.from_sim(status(101, wire::TaskState::kRunning));
}

inline std::string state_of_goal(const Bench& bench) {
  const std::vector<journal::Record> lines = bench.records("goal");
  return lines.empty() ? "" : std::string(lines.back().text("state"));
}

}  // namespace skein::ddn::testing
