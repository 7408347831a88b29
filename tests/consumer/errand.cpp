// SPDX-License-Identifier: Apache-2.0
// Skein's libraries without its daemons: a plan found by the planner is carried out by the
// executive, its times are kept by a temporal network, and its way is that of the refiners.
#include <iostream>

#include "skein/executive/executive.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/htn/planner.hpp"
#include "skein/refiners/path.hpp"
#include "skein/temporal/stn_engine.hpp"
#include "skein/world/world_builder.hpp"
#include "skein/world/world_reader.hpp"

using skein::MissionTime;

namespace {

constexpr const char* kWorld = R"(
origin: {latitude: 40, longitude: -8, altitude: 100}
terrain: {west: -200, south: -200, east: 200, north: 200, cell: 20}
airspace: {floor: 0, ceiling: 200, voxel: 20})";

constexpr const char* kDomain = R"(
(defdomain errand (
  (:operator (!takeoff ?u) ((on-ground ?u)) ((on-ground ?u)) ((in-air ?u)))
  (:operator (!goto ?u ?p) ((in-air ?u)) () ((at ?u ?p)))
  (:method (visit ?u ?p) ((on-ground ?u)) (:ordered (!takeoff ?u) (!goto ?u ?p)) ()
           ((!goto ?u ?p)))))
(defproblem errand errand ((on-ground karma)) ((visit karma p1))))";

std::vector<std::string> planned() {
  using namespace skein::htn;
  TermStore store;
  Definitions definitions;
  skein::Diagnostics errors, warnings;
  read_definitions({"errand.lisp", kDomain}, store, {}, definitions, errors, warnings);
  const Functions host;
  const auto domain =
      Domain::compile(definitions.domains.at(0), definitions.functions, host, store, errors);
  std::vector<std::string> steps;
  if (!domain) return steps;
  const Outcome outcome = plan(*domain, make_problem(definitions.problems.at(0), store), {});
  for (const Plan& one : outcome.plans)
    for (const Step& step : one.steps) steps.push_back(store.to_text(step.action));
  return steps;
}

/// Each task after the end of the one before; what is dispatched runs and ends at once.
int carried_out(const std::vector<std::string>& steps) {
  using namespace skein::executive;
  Executive executive({.name = "karma"});
  std::uint64_t id = 0;
  for (const std::string& step : steps) {
    Task task{.id = TaskId(++id), .type = step.substr(2, step.find(' ') - 2)};
    if (id > 1)
      task.preconditions = {{{.condition = TaskInState{TaskId(id - 1), TaskState::kEnded}}}};
    executive.handle(Start{task}, {});
  }
  for (const TaskStatus& task : executive.tasks()) {
    executive.handle(FunctionalStatus{task.id, TaskState::kRunning, {}}, MissionTime::seconds(1));
    executive.handle(FunctionalStatus{task.id, TaskState::kEnded, {}}, MissionTime::seconds(2));
  }
  int ended = 0;
  for (const TaskStatus& task : executive.tasks()) ended += task.state == TaskState::kEnded;
  return ended;
}

double latest_end(double most) {
  using namespace skein::temporal;
  const Ticks second = kTicksPerSecond;
  const Stn network{
      .nodes = {"v0", "begin", "end"},
      .arcs = {{0, 1, 5 * second, 10 * second}, {1, 2, 0, static_cast<Ticks>(most) * second}}};
  const auto engine = StnEngine::make(network);
  return engine && engine->consistent()
             ? static_cast<double>(engine->latest(2)) / static_cast<double>(second)
             : -1;
}

double way_length() {
  skein::world::VehicleModel helicopter;
  helicopter.cruise_speed = helicopter.max_speed = 8;
  helicopter.climb_rate = helicopter.descent_rate = 2;
  helicopter.acceleration = 1;
  helicopter.yaw_rate = 1;
  helicopter.ceiling = 200;
  helicopter.energy.capacity = 500'000;  // [J]
  const auto file = skein::world::read_world_file(kWorld, "here");
  if (!file) std::cerr << to_text(file.error());
  if (!file) return -1;
  const auto world = skein::world::build_world(*file);
  if (!world) std::cerr << to_text(world.error());
  if (!world) return -1;
  const auto path = skein::refiners::refine(
      skein::refiners::PathQuery{.vehicle = helicopter, .from = {0, 0, 50}, .to = {120, 50, 50}},
      {.world = *world, .budget = {}});
  if (!path) std::cerr << path.error().field << ": " << path.error().why << '\n';
  return path ? path->task.length : -1;
}

}  // namespace

int main() {
  const std::vector<std::string> steps = planned();
  for (const std::string& step : steps) std::cout << step << '\n';
  const double length = way_length();
  const double end = latest_end(length / 8 + 1);
  const int ended = carried_out(steps);
  std::cout << "way " << length << " m, latest end " << end << " s, " << ended << " tasks ended\n";
  return steps.size() == 2 && length > 0 && end > 0 && ended == 2 ? 0 : 1;
}
