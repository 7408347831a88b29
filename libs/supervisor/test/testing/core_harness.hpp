// SPDX-License-Identifier: Apache-2.0
// A supervisor under test: short ways to write goals, tasks and plans, and to read its effects.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "level_world.hpp"
#include "skein/supervisor/supervisor.hpp"

namespace skein::supervisor::testing {

using executive::TaskId;
using executive::TaskState;
using mission::GoalId;
using mission::GoalState;

inline MissionTime at(double s) { return MissionTime::seconds(s); }
inline Duration secs(double s) { return Duration::seconds(s); }

// ---- goals and missions ----

inline mission::HighLevelTask a_goal(std::uint64_t id, double number = 1) {
  return {GoalId{id}, "go", {number}, {}};
}
inline mission::UnitMission a_mission(std::uint64_t id, const std::vector<std::uint64_t>& goals) {
  mission::UnitMission result;
  result.id = mission::MissionId{id};
  result.asked_by = "test";
  for (const std::uint64_t goal : goals) result.tasks.push_back(a_goal(goal));
  return result;
}

// ---- tasks ----

class TaskOf {
 public:
  TaskOf(std::uint64_t id, std::string type, std::uint64_t origin) {
    task_.id = TaskId{id};
    task_.type = std::move(type);
    task_.origin = GoalId{origin};
    task_.duration = {Duration::seconds(10), Duration::seconds(20)};
  }
  TaskOf& after(std::uint64_t id) { return on(mission::DependenceKind::kEnded, id); }
  TaskOf& over(std::uint64_t id) { return on(mission::DependenceKind::kOver, id); }
  TaskOf& during(std::uint64_t id) { return on(mission::DependenceKind::kRunning, id); }
  TaskOf& stopped_by(std::uint64_t id) {
    task_.stop.push_back({mission::DependenceKind::kEnded, TaskId{id}});
    task_.duration = {};
    return *this;
  }
  TaskOf& takes(double least, double most) {
    task_.duration = {Duration::seconds(least), Duration::seconds(most)};
    return *this;
  }
  TaskOf& until_orders() {
    task_.open_ended = true;
    task_.duration = {Duration(), Duration::max()};
    return *this;
  }
  TaskOf& device(const std::string& name) {
    task_.parameters.add({"device", name, {}});
    return *this;
  }
  TaskOf& target(const world::Vector3& at) {
    task_.parameters.add({"target", "", {at.x(), at.y(), at.z()}});
    return *this;
  }
  TaskOf& way(std::vector<world::Vector3> points) {
    task_.way = std::move(points);
    return *this;
  }
  TaskOf& energy(double fraction) {
    task_.energy = fraction;
    return *this;
  }
  TaskOf& starts_after(double s) {
    task_.time.start_after = MissionTime::seconds(s);
    return *this;
  }
  TaskOf& ends_before(double s) {
    task_.time.end_before = MissionTime::seconds(s);
    return *this;
  }
  operator mission::ElementaryTask() const { return task_; }  // NOLINT: reads as a task

 private:
  TaskOf& on(mission::DependenceKind kind, std::uint64_t id) {
    task_.dependences.push_back({kind, TaskId{id}});
    return *this;
  }
  mission::ElementaryTask task_;
};

inline mission::ElementaryPlan plan_of(std::vector<mission::ElementaryTask> tasks) {
  mission::ElementaryPlan plan;
  plan.tasks = std::move(tasks);
  return plan;
}

// ---- results ----

inline std::vector<mission::HighLevelTask> goals_of(const std::vector<std::uint64_t>& ids) {
  std::vector<mission::HighLevelTask> result;
  for (const std::uint64_t id : ids) result.push_back(a_goal(id));
  return result;
}
inline InsertionOutcome inserted(const std::vector<std::uint64_t>& order,
                                 std::vector<mission::ElementaryTask> tasks) {
  InsertionOutcome outcome;
  outcome.plan = plan_of(std::move(tasks));
  outcome.order = goals_of(order);
  outcome.chosen = mission::Placement::kTour;
  return outcome;
}
inline InsertionOutcome refused(std::string why) {
  InsertionOutcome outcome;
  outcome.reasons = {std::move(why)};
  return outcome;
}
inline RepairOutcome repaired(RepairStep step, const std::vector<std::uint64_t>& order,
                              std::vector<mission::ElementaryTask> tasks) {
  RepairOutcome outcome;
  outcome.served = step;
  outcome.plan = plan_of(std::move(tasks));
  outcome.order = goals_of(order);
  return outcome;
}

// ---- the supervisor ----

inline Config config_for_tests() {
  auto knowledge = std::make_shared<Knowledge>();
  knowledge->uav = "karma";
  knowledge->team = {"karma"};
  knowledge->vehicle.energy.reserve = 0.1;
  knowledge->vehicle.body_radius = 1;
  world::SensorModel camera;
  camera.device = "camera";
  knowledge->vehicle.sensors = {camera};
  knowledge->vocabulary.tasks["go"] = {"go", {mission::ParameterKind::kNumber}, {}};
  knowledge->vocabulary.tasks["look"] = {"look", {mission::ParameterKind::kNumber}, {"detection"}};
  knowledge->vocabulary.serves.emplace("camera", "detection");
  Config config;
  config.knowledge = knowledge;
  config.world = std::make_shared<world::World>(skein::testing::level_world(100));
  config.first_id = TaskId{100};
  return config;
}

/// Each call is one input at `now`; `last` are its effects.
class Desk {
 public:
  explicit Desk(Config config = config_for_tests()) : supervisor(std::move(config)) {}
  static Desk engaged(Config config = config_for_tests()) {
    Desk desk(std::move(config));
    desk.give(Engage{true, "degree 4"});
    return desk;
  }

  Desk& at(double s) {
    now = MissionTime::seconds(s);
    return *this;
  }
  const Effects& give(const Input& input) {
    last = supervisor.handle(input, now);
    for (const Effect& effect : last) {
      if (const auto* job = std::get_if<StartDeliberation>(&effect)) {
        job_id = job->job;
        request = job->request;
      }
      all.push_back(effect);
    }
    return last;
  }
  const Effects& add(mission::UnitMission mission) { return give(AddMission{std::move(mission)}); }
  const Effects& finish(DeliberationResult result) {
    return give(JobFinished{job_id, std::move(result)});
  }
  const Effects& seen(std::uint64_t id, TaskState state, const std::string& why = {},
                      const std::string& type = "goto") {
    return give(TaskSeen{{TaskId{id}, type, state, why}});
  }
  const Effects& runs(std::uint64_t id) {
    give(TaskSeen{{TaskId{id}, type_of(id), TaskState::kStarted, {}}});
    return give(TaskSeen{{TaskId{id}, type_of(id), TaskState::kRunning, {}}});
  }
  const Effects& ends(std::uint64_t id) {
    return give(TaskSeen{{TaskId{id}, type_of(id), TaskState::kEnded, {}}});
  }
  const Effects& aborted(std::uint64_t id, const std::string& why = "engine trouble",
                         executive::AbortCause cause = executive::AbortCause::kOther) {
    return give(TaskSeen{{TaskId{id}, type_of(id), TaskState::kAborted, why, cause}});
  }
  /// After an ABORT at the executive.
  const Effects& aborting_as_asked(std::uint64_t id) { return told(id, TaskState::kAborting); }
  const Effects& aborted_as_asked(std::uint64_t id) { return told(id, TaskState::kAborted); }
  const Effects& told(std::uint64_t id, TaskState state) {
    return give(TaskSeen{
        {TaskId{id}, type_of(id), state, "abort requested", executive::AbortCause::kRequested}});
  }
  const Effects& flies(world::Vector3 position = {0, 0, 40}, double energy = 1,
                       std::vector<std::string> failed = {}) {
    world::VehicleState state;
    state.position = std::move(position);
    state.airborne = true;
    state.energy = energy;
    return give(VehicleSeen{state, std::move(failed)});
  }

  // What the last call did, as words.
  std::vector<std::string> requests() const { return requests_in(last); }
  std::vector<std::string> decisions() const {
    std::vector<std::string> words;
    for (const auto& one : of<Decided>()) words.push_back(one.decision.applied);
    return words;
  }
  std::vector<std::string> goals() const {
    std::vector<std::string> words;
    for (const auto& one : of<GoalChanged>()) {
      words.push_back(to_text(one.status.id) + " " + std::string(to_text(one.status.state)));
    }
    return words;
  }
  template <class One>
  std::vector<One> of() const {
    std::vector<One> result;
    for (const Effect& effect : last) {
      if (const auto* one = std::get_if<One>(&effect)) result.push_back(*one);
    }
    return result;
  }
  bool job_started() const { return !of<StartDeliberation>().empty(); }
  std::vector<std::string> notices() const {
    std::vector<std::string> words;
    for (const auto& one : of<Notice>()) words.push_back(one.text);
    return words;
  }
  std::string state_of(std::uint64_t goal) const {
    for (const auto& one : supervisor.report().goals) {
      if (one.id == GoalId{goal}) return std::string(to_text(one.state));
    }
    return "unknown";
  }
  std::string why_of(std::uint64_t goal) const {
    for (const auto& one : supervisor.report().goals) {
      if (one.id == GoalId{goal}) return one.why;
    }
    return {};
  }
  const InsertionRequest& insertion() const { return std::get<InsertionRequest>(*request); }
  const RepairRequest& repair() const { return std::get<RepairRequest>(*request); }

  static std::vector<std::string> requests_in(const Effects& effects) {
    std::vector<std::string> words;
    for (const Effect& effect : effects) {
      const auto* sent = std::get_if<ToExecutive>(&effect);
      if (sent == nullptr) continue;
      if (const auto* start = std::get_if<executive::Start>(&sent->input)) {
        words.push_back("START " + to_text(start->task.id));
      } else if (const auto* abort = std::get_if<executive::Abort>(&sent->input)) {
        words.push_back("ABORT " + to_text(abort->id));
      } else if (const auto* update = std::get_if<executive::UpdateConditions>(&sent->input)) {
        words.push_back("UPDATE " + to_text(update->id));
      } else if (const auto* status = std::get_if<executive::FunctionalStatus>(&sent->input)) {
        words.push_back("STATUS " + to_text(status->id));
      }
    }
    return words;
  }
  std::optional<executive::Start> started(std::uint64_t id) const {
    for (const Effect& effect : all) {
      const auto* sent = std::get_if<ToExecutive>(&effect);
      if (sent == nullptr) continue;
      const auto* start = std::get_if<executive::Start>(&sent->input);
      if (start != nullptr && start->task.id == TaskId{id}) return *start;
    }
    return std::nullopt;
  }

  Supervisor supervisor;
  MissionTime now;
  Effects last, all;
  std::uint64_t job_id = 0;
  std::shared_ptr<const DeliberationRequest> request;

 private:
  std::string type_of(std::uint64_t id) const {
    for (const auto& one : supervisor.report().tasks) {
      if (one.task.id == TaskId{id}) return one.task.type;
    }
    const auto start = started(id);
    return start ? start->task.type : "goto";
  }
};

/// In the air, on the way of 701 (goto 101), 702 (goto 102) planned behind it.
inline Desk flying(Config config = config_for_tests()) {
  Desk desk = Desk::engaged(std::move(config));
  desk.add(a_mission(1, {701, 702}));
  desk.finish(inserted({701, 702}, {TaskOf(100, "takeoff", 701).takes(4, 6),
                                    TaskOf(101, "goto", 701)
                                        .after(100)
                                        .takes(100, 120)
                                        .energy(0.2)
                                        .way({{0, 0, 40}, {500, 0, 40}}),
                                    TaskOf(102, "goto", 702)
                                        .after(101)
                                        .takes(50, 60)
                                        .energy(0.1)
                                        .way({{500, 0, 40}, {500, 500, 40}})}));
  desk.runs(100);
  desk.at(5).ends(100);
  desk.runs(101);
  desk.flies();
  return desk;
}

}  // namespace skein::supervisor::testing
