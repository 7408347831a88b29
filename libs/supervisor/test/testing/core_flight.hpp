// SPDX-License-Identifier: Apache-2.0
// A supervisor with a real executive, a functional layer that takes random times, and a planner
// that makes something up. Checks the laws of the supervisor as it goes.
#pragma once

#include <deque>
#include <map>
#include <set>

#include "skein/executive/executive.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/foundation/random.hpp"
#include "testing/core_harness.hpp"

namespace skein::supervisor::testing {

/// Makes plans up: what a goal becomes hangs on its number.
class MadeUpPlanner {
 public:
  explicit MadeUpPlanner(std::uint64_t seed) : random_(seed) {}

  DeliberationResult answer(const DeliberationRequest& request) {
    return std::visit([this](const auto& one) { return DeliberationResult(make(one)); }, request);
  }

 private:
  InsertionOutcome make(const InsertionRequest& request) {
    if (random_.chance(0.15)) return refused("no way");
    std::vector<mission::HighLevelTask> order = request.planned;
    order.insert(random_.chance(0.5) ? order.begin() : order.end(), request.added.begin(),
                 request.added.end());
    InsertionOutcome outcome;
    outcome.plan = plan(request.base.situation, order);
    outcome.order = std::move(order);
    return outcome;
  }
  RepairOutcome make(const RepairRequest& request) {
    RepairOutcome outcome;
    if (random_.chance(0.1)) {
      outcome.before = {"replan: no way"};
      return outcome;
    }
    std::vector<mission::HighLevelTask> order = request.remaining;
    const bool refine = request.refine_failed && random_.chance(0.7);
    outcome.served = refine ? RepairStep::kRefine : RepairStep::kDrop;
    if (request.failed && refine) {
      order.insert(order.begin() + static_cast<std::ptrdiff_t>(request.failed_at), *request.failed);
    } else if (request.failed) {
      outcome.dropped.push_back({request.failed->id, "dropped"});
    }
    outcome.plan = plan(request.base.situation, order);
    outcome.order = std::move(order);
    return outcome;
  }

  mission::ElementaryPlan plan(const Situation& from,
                               const std::vector<mission::HighLevelTask>& order) {
    next_ = from.next_id.value();
    motion_ = from.motion.after;
    airborne_ = from.airborne;
    mission::ElementaryPlan result;
    for (const auto& goal : order) refine(goal, result.tasks);
    return result;
  }
  TaskOf motion(const char* type, GoalId goal) {
    TaskOf task(next_++, type, goal.value());
    if (motion_ && motion_->kind == mission::DependenceKind::kEnded)
      task.after(motion_->task.value());
    if (motion_ && motion_->kind == mission::DependenceKind::kOver)
      task.over(motion_->task.value());
    motion_ = mission::Dependence{mission::DependenceKind::kEnded, TaskId{next_ - 1}};
    return task;
  }
  void refine(const mission::HighLevelTask& goal, std::vector<mission::ElementaryTask>& tasks) {
    const auto kind = static_cast<int>(std::get<double>(goal.arguments[0]));
    if (!airborne_) tasks.push_back(motion("takeoff", goal.id).takes(4, 6));
    airborne_ = true;
    const double x = random_.uniform(-500, 500);
    tasks.push_back(
        motion("goto", goal.id).takes(20, 40).energy(0.02).way({{x, 0, 40}, {x, 200, 40}}));
    if (kind == 1) {
      const std::uint64_t wait = next_;
      tasks.push_back(motion("wait", goal.id).takes(20, 20));
      tasks.push_back(TaskOf(next_++, "takeshot", goal.id.value())
                          .device("camera")
                          .during(wait)
                          .stopped_by(wait));
    } else if (kind == 2) {
      tasks.push_back(motion("wait", goal.id).until_orders());
      motion_->kind = mission::DependenceKind::kOver;
    } else if (kind == 3) {
      tasks.push_back(motion("land", goal.id).takes(4, 6));
      airborne_ = false;
    }
  }

  Random random_;
  std::uint64_t next_ = 1;
  std::optional<mission::Dependence> motion_;
  bool airborne_ = false;
};

class Flight {
 public:
  explicit Flight(std::uint64_t seed)
      : random_(seed), planner_(seed + 1), supervisor_(config_for_tests()) {
    give(Engage{true, "start"});
  }

  /// One random thing that people or the world do.
  void disturb() {
    const double what = random_.uniform();
    if (what < 0.35) return add();
    if (what < 0.45) return cancel();
    if (what < 0.55) return change_degree();
    if (what < 0.65) return close_air();
    if (what < 0.75) return abort_something();
    if (what < 0.80) return fly_for_another();
    state_.energy = random_.chance(0.1) ? 0.12 : 1;
    see_vehicle(random_.chance(0.2));
  }
  /// Time passes, with all that is due in it.
  void run(double seconds) {
    const MissionTime until = now_ + Duration::seconds(seconds);
    while (const auto next = next_date()) {
      if (*next > until) break;
      step(*next);
    }
    now_ = until;
  }
  /// Everybody leaves it alone until nothing more happens.
  void settle() {
    state_.energy = 1;
    for (int i = 0; i < 60; ++i) {
      see_vehicle(false);
      run(60);
    }
  }
  /// Broken laws, in words.
  std::vector<std::string> broken() const { return broken_; }
  void check_rest() {
    const auto& report = supervisor_.report();
    for (const auto& goal : report.goals) {
      const bool has_tasks =
          std::any_of(report.tasks.begin(), report.tasks.end(),
                      [&](const auto& one) { return one.task.origin == goal.id; });
      const bool fine = is_settled(goal.state) || goal.state == GoalState::kHandedOver ||
                        (goal.state != GoalState::kReceived && has_tasks);
      if (!fine)
        broken_.push_back("goal " + to_text(goal.id) + " is left " +
                          std::string(to_text(goal.state)));
      const bool open = goal.state == GoalState::kUnderWay || goal.state == GoalState::kPlanned;
      if (open && !may_be_open(goal.id))
        broken_.push_back("goal " + to_text(goal.id) + " is stuck");
    }
  }

 private:
  struct Coming {
    std::uint64_t number;
    std::variant<executive::FunctionalStatus, JobFinished> what;
  };

  // ---- time ----
  std::optional<MissionTime> next_date() const {
    std::optional<MissionTime> next = earliest(executive_.next_wakeup(), supervisor_.next_wakeup());
    if (!coming_.empty()) next = earliest(next, coming_.begin()->first);
    return next;
  }
  void step(MissionTime date) {
    now_ = std::max(now_, date);
    if (++steps_ > 200000) broken_.push_back("it never rests");
    if (steps_ > 200000) coming_.clear();
    if (!coming_.empty() && coming_.begin()->first <= now_) {
      const Coming one = coming_.begin()->second;
      coming_.erase(coming_.begin());
      std::visit(Overloaded{[this](const executive::FunctionalStatus& s) { status(s); },
                            [this](const JobFinished& job) { give(job); }},
                 one.what);
    } else {
      execute(executive::Tick{});
      give(Tick{});
    }
    check_air();
  }
  void later(double seconds, std::variant<executive::FunctionalStatus, JobFinished> what) {
    coming_.emplace(now_ + Duration::seconds(seconds), Coming{0, std::move(what)});
  }

  // ---- supervisor and executive, first in first out ----
  void give(const Input& input) {
    inputs_.push_back(input);
    if (busy_) return;
    busy_ = true;
    while (!inputs_.empty()) {
      const Input next = inputs_.front();
      inputs_.pop_front();
      for (const Effect& effect : supervisor_.handle(next, now_)) {
        std::visit([this](const auto& one) { carry_out(one); }, effect);
      }
    }
    busy_ = false;
  }
  template <class Other>
  void carry_out(const Other&) {}
  void carry_out(const StartDeliberation& job) {
    later(random_.uniform(0.05, 4), JobFinished{job.job, planner_.answer(*job.request)});
  }
  void carry_out(const Notice& notice) {
    if (notice.text.find("in the air") != std::string::npos) said_ = true;
  }
  void carry_out(const HandedOver& held) { held_ = held.tasks; }
  void carry_out(const ToExecutive& sent) {
    if (const auto* start = std::get_if<executive::Start>(&sent.input)) check_start(*start);
    execute(sent.input);
  }
  void check_start(const executive::Start& start) {
    if (!ids_.insert(start.task.id).second) {
      broken_.push_back("id " + to_text(start.task.id) + " given twice");
    }
    for (const auto* formula : {&start.task.preconditions, &start.task.exit}) {
      for (const auto& clause : *formula) {
        for (const auto& literal : clause) {
          const auto* named = std::get_if<executive::TaskInState>(&literal.condition);
          if (named != nullptr && !executive_.find(named->task)) {
            broken_.push_back("task " + to_text(start.task.id) + " waits of unknown " +
                              to_text(named->task));
          }
        }
      }
    }
  }
  void execute(const executive::Input& input) {
    for (const executive::Effect& effect : executive_.handle(input, now_)) {
      std::visit(Overloaded{[this](const executive::TaskEvent& e) { give(TaskSeen{e}); },
                            [this](const executive::Reply& r) { give(RequestAnswered{r}); },
                            [this](const executive::Dispatch& d) { dispatch(d.id); },
                            [this](const executive::Interrupt& i) { interrupt(i.id); },
                            [](const auto&) {}},
                 effect);
    }
  }

  // ---- functional layer ----
  static bool moves(const std::string& type) {
    return type == "takeoff" || type == "goto" || type == "wait" || type == "land";
  }
  void dispatch(TaskId id) {
    const std::string type = executive_.find(id)->type;
    const auto ours = [](TaskId task) { return task < TaskId{1'000'000'000}; };
    for (const auto& one : executive_.tasks()) {
      if (one.id == id || !ours(id) || !ours(one.id) || active_.count(one.id) == 0) continue;
      if (moves(type) && moves(one.type)) {
        broken_.push_back("task " + to_text(id) + " moves while " + to_text(one.id) + " does");
      }
    }
    active_.insert(id);
    later(random_.uniform(0.05, 0.5), executive::FunctionalStatus{id, TaskState::kRunning, ""});
    if (type == "takeshot" || (type == "wait" && open_wait(id))) return;
    const bool fails = random_.chance(0.06);
    later(random_.uniform(3, 60),
          executive::FunctionalStatus{id, fails ? TaskState::kAborted : TaskState::kEnded, ""});
  }
  bool open_wait(TaskId id) const {
    for (const auto& one : supervisor_.report().tasks) {
      if (one.task.id == id) return one.task.open_ended;
    }
    return true;
  }
  void interrupt(TaskId id) {
    later(random_.uniform(0.05, 2), executive::FunctionalStatus{id, TaskState::kAborted, ""});
  }
  void status(const executive::FunctionalStatus& one) {
    if (active_.count(one.id) == 0) return;
    if (one.state != TaskState::kRunning) active_.erase(one.id);
    const std::string type = executive_.find(one.id)->type;
    const bool was = state_.airborne;
    if (one.state == TaskState::kEnded && type == "takeoff") state_.airborne = true;
    if (one.state == TaskState::kEnded && type == "land") state_.airborne = false;
    execute(one);
    if (state_.airborne != was) give(VehicleSeen{state_, {}});
  }

  // ---- disturbances ----
  void add() {
    mission::UnitMission mission = a_mission(++missions_, {});
    for (std::uint64_t i = 0; i <= random_.below(3); ++i) {
      mission.tasks.push_back(a_goal(++goals_, static_cast<double>(random_.below(4))));
    }
    if (random_.chance(0.2)) mission.placement = mission::Placement::kFirst;
    mission.interrupt = random_.chance(0.5);
    give(AddMission{mission});
  }
  void cancel() {
    mission::CancelGoals goals;
    goals.interrupt = random_.chance(0.6);
    if (random_.chance(0.7)) goals.goals.push_back(GoalId{1 + random_.below(goals_ + 1)});
    give(CancelMission{goals, "operator"});
  }
  void change_degree() {
    if (supervisor_.engaged()) return give(Disengage{"degree 3"});
    for (const auto& held : held_) {
      if (random_.chance(0.2) && ids_.insert(held.task.id).second) {
        execute(executive::Start{held.task, executive::InsertionMode::kNut});
      }
    }
    Engage engage{random_.chance(0.8), "degree 4", std::vector<TaskId>()};
    for (const auto& one : executive_.tasks())
      if (!executive::is_terminal(one.state)) engage.in_executive->push_back(one.id);
    give(engage);
  }
  void close_air() {
    mission::ChangeWorld change;
    const double x = random_.uniform(-500, 500);
    change.volume = {"v", {{x, 50}, {x + 80, 50}, {x + 80, 90}, {x, 90}}, 0, 100, {}};
    change.remove = random_.chance(0.3);
    give(WorldChanged{change});
  }
  void abort_something() {
    std::vector<TaskId> open;
    for (const auto& one : executive_.tasks()) {
      if (!is_terminal(one.state)) open.push_back(one.id);
    }
    if (!open.empty()) execute(executive::Abort{open[random_.below(open.size())]});
  }
  void fly_for_another() {
    executive::Task task;
    task.id = TaskId{++others_};
    task.type = "goto";
    execute(executive::Start{task, random_.chance(0.5) ? executive::InsertionMode::kVut
                                                       : executive::InsertionMode::kNut});
  }
  void see_vehicle(bool broken) {
    give(VehicleSeen{state_,
                     broken ? std::vector<std::string>{"camera"} : std::vector<std::string>{}});
    check_air();
  }

  // ---- laws ----
  void check_air() {
    const auto tasks = executive_.tasks();
    bool open = false, goes_on = false;
    for (const auto& one : tasks) {
      open = open || !is_terminal(one.state);
      goes_on = goes_on || (!is_terminal(one.state) && one.state != TaskState::kAborting);
    }
    if (goes_on) said_ = false;
    if (state_.airborne && supervisor_.engaged() && !open && !said_) {
      broken_.push_back("in the air without a task at " + to_text(now_));
    }
  }
  // With the executive and still going on, or behind what is.
  bool may_be_open(GoalId) const {
    const auto tasks = executive_.tasks();
    return !supervisor_.engaged() || std::any_of(tasks.begin(), tasks.end(), [](const auto& one) {
      return is_active(one.state) && one.type == "wait";
    });
  }

  Random random_;
  MadeUpPlanner planner_;
  Supervisor supervisor_;
  executive::Executive executive_{[] {
    executive::Config config;
    config.name = "karma";
    return config;
  }()};
  MissionTime now_;
  world::VehicleState state_;
  std::multimap<MissionTime, Coming> coming_;
  std::deque<Input> inputs_;
  bool busy_ = false, said_ = false;
  int steps_ = 0;
  std::set<TaskId> ids_, active_;
  std::vector<mission::HeldTask> held_;
  std::uint64_t missions_ = 0, goals_ = 0, others_ = 2'000'000'000;
  std::vector<std::string> broken_;
};

}  // namespace skein::supervisor::testing
