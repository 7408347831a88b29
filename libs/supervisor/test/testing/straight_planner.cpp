// SPDX-License-Identifier: Apache-2.0
#include "testing/straight_planner.hpp"

namespace skein::supervisor::testing {
namespace {

using mission::ElementaryTask;
using mission::HighLevelTask;
using mission::ParameterKind;
using world::Vector3;

constexpr double kSpeed = 10, kEnergyOfMetre = 1e-4;

/// Builds a plan task after task.
class Course {
 public:
  explicit Course(const PlanningRequest& request)
      : request_(request),
        at_(request.situation.position),
        airborne_(request.situation.airborne),
        next_(request.situation.next_id.value()) {
    plan_.origin = request.situation.origin;
    if (request.situation.motion.after) last_ = request.situation.motion.after->task;
    least_ = request.situation.motion.free.least.to_seconds();
    most_ = request.situation.motion.free.most.to_seconds();
  }

  bool airborne() const { return airborne_; }
  const Vector3& at() const { return at_; }

  void fly(const HighLevelTask& goal, const Vector3& to) {
    const double metres = (to - at_).norm();
    ElementaryTask& task = add(goal, "goto", metres / kSpeed, 1.2 * metres / kSpeed);
    task.way = {at_, to};
    task.energy = metres * kEnergyOfMetre;
    task.cost = metres / kSpeed;
    at_ = to;
  }
  void stay(const HighLevelTask& goal, double seconds, bool open_ended = false) {
    ElementaryTask& task = add(goal, "wait", seconds, seconds);
    task.open_ended = open_ended;
    task.cost = seconds;
  }
  void take_off(const HighLevelTask& goal) {
    add(goal, "takeoff", 5, 5);
    at_.z() = 40;
    airborne_ = true;
  }
  void land(const HighLevelTask& goal) {
    add(goal, "land", 5, 5);
    airborne_ = false;
  }
  mission::ElementaryPlan take() {
    for (const ElementaryTask& task : plan_.tasks) {
      plan_.cost += task.cost;
      plan_.energy += task.energy;
    }
    return std::move(plan_);
  }

 private:
  ElementaryTask& add(const HighLevelTask& goal, const char* type, double least, double most) {
    ElementaryTask task;
    task.id = executive::TaskId(next_++);
    task.type = type;
    if (last_) task.dependences = {{mission::DependenceKind::kEnded, *last_}};
    // Late enough for its own bounds.
    for (const auto& [bound, lasts] :
         {std::pair(goal.time.start_after, 0.0), std::pair(goal.time.end_after, least)}) {
      if (!bound) continue;
      const double from = (*bound - request_.situation.origin).to_seconds() - lasts;
      least_ = std::max(least_, from);
      most_ = std::max(most_, from);
    }
    task.start = {Duration::seconds(least_), Duration::seconds(most_)};
    task.duration = {Duration::seconds(least), Duration::seconds(most)};
    task.time = goal.time;
    task.origin = goal.id;
    least_ += least;
    most_ += most;
    last_ = task.id;
    plan_.tasks.push_back(std::move(task));
    return plan_.tasks.back();
  }

  const PlanningRequest& request_;
  Vector3 at_;
  bool airborne_;
  std::uint64_t next_;
  double least_ = 0, most_ = 0;
  std::optional<executive::TaskId> last_;
  mission::ElementaryPlan plan_;
};

/// Why it cannot be done; empty when it was.
std::string do_goal(const HighLevelTask& goal, const PlanningRequest& request, Course& course,
                    const std::set<std::string>& blocked) {
  if (goal.name == "take-off") {
    if (!course.airborne()) course.take_off(goal);
    return {};
  }
  if (goal.name == "land") {
    if (!course.airborne()) return {};
    course.fly(goal, {0, 0, 40});
    course.land(goal);
    return {};
  }
  if (!course.airborne()) return "on the ground";
  if (goal.name == "await-orders") course.stay(goal, 0, true);
  if (goal.name == "map") course.fly(goal, {200, 0, 40});
  if (goal.name == "stay") {
    const auto range = mission::duration_range_of(goal.arguments[0]);
    course.stay(goal, range ? range->most : std::get<double>(goal.arguments[0]));
  }
  const bool shared = goal.name == "meet" || goal.name == "join";
  if (goal.name != "visit" && !shared) return {};
  const auto& name = std::get<std::string>(goal.arguments[shared ? 1 : 0]);
  if (blocked.contains(name)) return name + " is closed";
  if (goal.name == "visit" && request.situation.broken.contains("camera")) return "no camera works";
  const Vector3& place = request.world->places.at(name);
  course.fly(goal, {place.x(), place.y(), 40});
  course.stay(goal, 10);
  return {};
}

}  // namespace

Result<mission::ElementaryPlan, PlanningFailure> StraightPlanner::plan(
    const PlanningRequest& request) {
  requested.push_back(ids(request.tasks));
  Course course(request);
  for (const HighLevelTask& goal : request.tasks) {
    const std::string problem = do_goal(goal, request, course, blocked);
    if (!problem.empty())
      return tl::unexpected<PlanningFailure>(PlanningFailure{goal.id, {problem}});
  }
  return course.take();
}

namespace {

world::World flat_world() {
  world::TerrainSpec ground;
  ground.west = ground.south = -2000;
  ground.east = ground.north = 2000;
  return {.origin = {},
          .terrain = world::Terrain(ground),
          .wind = {},
          .airspace = {},
          .volumes = {},
          .ground = {},
          .radio = {},
          .zones = {},
          .places = {}};
}

}  // namespace

InsertionLab::InsertionLab() : world(flat_world()) {
  world.airspace = {.origin = {-2000, -2000, 0}, .voxel = 25, .size = {160, 160, 8}};
  world::VehicleModel& model = knowledge.vehicle;
  model.name = "helicopter";
  model.cruise_speed = 10;
  model.max_speed = 15;
  model.climb_rate = model.descent_rate = 4;
  model.acceleration = 2;
  model.yaw_rate = 1;
  model.ceiling = 500;
  model.energy.capacity = 5e6;
  model.energy.hover_power = 1000;
  model.energy.cruise_power = 1200;
  const auto declare = [&](const std::string& name, std::vector<ParameterKind> kinds) {
    knowledge.vocabulary.tasks[name] = {name, std::move(kinds), {}};
  };
  declare("take-off", {});
  declare("land", {});
  declare("visit", {ParameterKind::kPlace});
  declare("stay", {ParameterKind::kDuration});
  declare("meet", {ParameterKind::kSyncId, ParameterKind::kPlace});
  declare("join", {ParameterKind::kUavs, ParameterKind::kPlace});
  declare("map", {ParameterKind::kZone});
  declare("tour", {ParameterKind::kPlaces});
  declare("await-orders", {});
}

InsertionLab& InsertionLab::place(const std::string& name, double x, double y) {
  world.places[name] = {x, y, 0};
  return *this;
}
InsertionLab& InsertionLab::flying() {
  situation.airborne = true;
  situation.position = {0, 0, 40};
  return *this;
}
InsertionLab& InsertionLab::energy(double left) {
  situation.energy = left;
  return *this;
}

HighLevelTask InsertionLab::visit(std::uint64_t id, const std::string& place,
                                  mission::TimeConstraints time) {
  return {mission::GoalId(id), "visit", {place}, time};
}
HighLevelTask InsertionLab::simple(std::uint64_t id, const std::string& name) {
  return {mission::GoalId(id), name, {}, {}};
}
HighLevelTask InsertionLab::stay(std::uint64_t id, double seconds) {
  return {mission::GoalId(id), "stay", {seconds}, {}};
}
HighLevelTask InsertionLab::meet(std::uint64_t id, double sync, const std::string& place,
                                 mission::TimeConstraints time) {
  return {mission::GoalId(id), "meet", {sync, place}, time};
}
HighLevelTask InsertionLab::join(std::uint64_t id, const std::string& place,
                                 mission::TimeConstraints time) {
  return {mission::GoalId(id), "join", {std::vector<std::string>{"uav", "other"}, place}, time};
}

PlanningRequest InsertionLab::base() const {
  return {std::make_shared<const Knowledge>(knowledge),
          std::make_shared<const world::World>(world),
          situation,
          {},
          1};
}
InsertionRequest InsertionLab::insertion(Goals planned, Goals added,
                                         mission::Placement placement) const {
  return {base(), {}, std::move(planned), std::move(added), placement};
}

std::vector<std::uint64_t> ids(const Goals& goals) {
  std::vector<std::uint64_t> all;
  for (const HighLevelTask& goal : goals) all.push_back(goal.id.value());
  return all;
}
mission::TimeConstraints ends_before(double seconds) {
  mission::TimeConstraints time;
  time.end_before = MissionTime::seconds(seconds);
  return time;
}
mission::TimeConstraints starts_after(double seconds) {
  mission::TimeConstraints time;
  time.start_after = MissionTime::seconds(seconds);
  return time;
}

}  // namespace skein::supervisor::testing
