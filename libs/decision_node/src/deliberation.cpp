// SPDX-License-Identifier: Apache-2.0
#include "deliberation.hpp"

#include <utility>

#include "core.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/mission/degree.hpp"

namespace skein::decision_node {

namespace {

/// What lies no farther from where plans have it than this is there for them [m].
constexpr double kMoved = 10;

std::optional<supervisor::Supervisor> supervisor_of(const Config& config) {
  if (config.knowledge == nullptr) return std::nullopt;
  SKEIN_EXPECTS(config.world != nullptr);
  SKEIN_EXPECTS(config.first_task < functional::kFirstRoleId);
  supervisor::Config result;
  result.knowledge = config.knowledge;
  result.world = config.world;
  result.horizon = config.horizon;
  result.first_id = config.first_task;
  result.tells_all = config.consistency == temporal::Algorithm::kDipG ||
                     config.consistency == temporal::Algorithm::kCip;
  return supervisor::Supervisor(std::move(result));
}

}  // namespace

Deliberation::Deliberation(Core& core) : core_(core), supervisor_(supervisor_of(core.config())) {}

// ---- what comes in ----

// What was handed over can be cancelled at any degree; the world is known for later too, since the
// degree may go up.
void Deliberation::take(const Command& command) {
  const std::string why = why_not_planned();
  std::visit(
      Overloaded{[&](const mission::UnitMission& mission) {
                   if (!why.empty()) return core_.commands().refuse(command, why);
                   tell(supervisor::AddMission{mission}, Asker{command, {}});
                 },
                 [&](const mission::CancelGoals& goals) {
                   if (!supervisor_) return core_.commands().refuse(command, why);
                   tell(supervisor::CancelMission{goals, command.asked_by}, Asker{command, {}});
                 },
                 [&](const mission::ChangeWorld& change) {
                   if (!supervisor_) return core_.commands().answer(command, true, "");
                   tell(supervisor::WorldChanged{change}, Asker{command, {}});
                 },
                 [](const auto&) {}},
      command.request);
}

std::string Deliberation::why_not_planned() const {
  if (!supervisor_) return "no planning domain in the scenario: no missions are planned on board";
  if (!mission::deliberates(core_.degree())) {
    return "degree " + std::to_string(core_.degree()) + ": missions are planned at degree 4";
  }
  if (!engaged()) {
    return "deliberation stopped when contact was lost: degree 4 is to be given again";
  }
  return "";
}

void Deliberation::task_changed(const executive::TaskEvent& event) {
  tell(supervisor::TaskSeen{event, core_.execution().gives_way(event.id)});
}

void Deliberation::vehicle_told(const world::Telemetry& telemetry) {
  tell(supervisor::VehicleSeen{telemetry.state, telemetry.failed});
}

// Plans are made with where an object that moves was when it had moved by so much, or behind a
// crest.
void Deliberation::place_told(const mission::ChangeWorld& told) {
  if (told.place && told.place->seen) {
    const auto [known, added] = planned_with_.try_emplace(told.place->name, told.place->at);
    const bool moved = added || (known->second - told.place->at).norm() >= kMoved;
    if (!moved && !(supervisor_ && supervisor_->loses_sight_of(told.place->name, told.place->at)))
      return;
    known->second = told.place->at;
  }
  tell(supervisor::WorldChanged{told});
}

void Deliberation::begin(const Started& started) {
  if (!started.first_life) tell(supervisor::LivesAgain{});
}

void Deliberation::time_passes() { tell(supervisor::Tick{}); }

std::optional<MissionTime> Deliberation::next_wakeup() const {
  return supervisor_ ? supervisor_->next_wakeup() : std::nullopt;
}

void Deliberation::disengage(const std::string& cause) {
  if (!engaged()) return;
  core_.interaction().leave_all(cause);
  tell(supervisor::Disengage{cause});
}

void Deliberation::take_for_team(const mission::UnitMission& mission) {
  tell(supervisor::AddMission{mission}, {std::nullopt, mission.id});
}

void Deliberation::cancel_for_team(mission::GoalId goal, const std::string& why) {
  mission::CancelGoals cancel;
  cancel.goals = {goal};
  tell(supervisor::CancelMission{cancel, why});
}

void Deliberation::request_answered(const executive::Reply& reply) {
  tell(supervisor::RequestAnswered{reply});
}

void Deliberation::joint_task_due(executive::TaskId task, bool interrupt) {
  if (supervisor_) return tell(supervisor::JointTaskDue{task, interrupt});
  core_.execution().run(executive::FunctionalStatus{task, executive::TaskState::kAborted,
                                                    "joint tasks need a deliberative layer"});
}

// ---- what the supervisor asks for ----

void Deliberation::tell(supervisor::Input input, Asker asker) {
  if (!supervisor_) return;
  core_.bus().post([this, input = std::move(input), asker = std::move(asker)] {
    for (const supervisor::Effect& effect : supervisor_->handle(input, core_.bus().now())) {
      std::visit([&](const auto& one) { carry_out(one, asker); }, effect);
    }
  });
}

void Deliberation::carry_out(const supervisor::Answer& effect, const Asker& asker) {
  const std::string why = joined(effect.reasons, "; ");
  if (asker.command) core_.commands().answer(*asker.command, effect.accepted, why);
  if (asker.team) core_.team().mission_answered(*asker.team, effect.accepted, why);
}

void Deliberation::carry_out(const supervisor::GoalChanged& effect, const Asker&) {
  core_.bus().emit(effect);
  core_.team().goal_changed(effect.status);
  const bool is_given_up = effect.status.state == mission::GoalState::kFailed ||
                           effect.status.state == mission::GoalState::kCancelled;
  const auto goal = is_given_up ? supervisor_->goal(effect.status.id) : std::nullopt;
  if (goal) core_.interaction().given_up(*goal, effect.status.why);
}

void Deliberation::carry_out(const supervisor::ToExecutive& effect, const Asker&) {
  core_.execution().run(effect.input, Execution::By::kSupervisor);
}

void Deliberation::carry_out(const supervisor::PlanChanged& effect, const Asker&) {
  for (const mission::PlannedTask& one : effect.report.tasks) {
    origins_.insert_or_assign(one.task.id, one.task.origin);
  }
  core_.bus().emit(effect);
}

void Deliberation::carry_out(const supervisor::HandedOver& effect, const Asker&) {
  handed_over_ = effect.tasks;
}

void Deliberation::carry_out(const supervisor::NotGivenBack& effect, const Asker&) {
  core_.bus().emit(TaskChanged{effect.event, {}});
}

void Deliberation::carry_out(const supervisor::LoadJointTask& effect, const Asker&) {
  core_.interaction().load(effect);
}

void Deliberation::carry_out(const supervisor::FrontierChanged& effect, const Asker&) {
  core_.meetings().said(effect.frontier);
}

void Deliberation::carry_out(const supervisor::Notice& effect, const Asker&) {
  core_.bus().emit(Notice{effect.text});
}

template <class Other>
void Deliberation::carry_out(const Other& effect, const Asker&) {
  core_.bus().emit(effect);
}

// ---- what it knows ----

std::vector<mission::GoalStatus> Deliberation::goals() const {
  return supervisor_ ? supervisor_->report().goals : std::vector<mission::GoalStatus>();
}

mission::GoalId Deliberation::origin_of(executive::TaskId task) const {
  const auto found = origins_.find(task);
  return found == origins_.end() ? mission::GoalId() : found->second;
}

std::vector<mission::HeldTask> Deliberation::take_handed_over() {
  return std::exchange(handed_over_, {});
}

}  // namespace skein::decision_node
