// SPDX-License-Identifier: Apache-2.0
#include "autonomy.hpp"

#include <algorithm>

#include "core.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/mission/degree.hpp"

namespace skein::decision_node {

Autonomy::Autonomy(Core& core) : core_(core), degree_(core.config().degree) {
  SKEIN_EXPECTS(degree_ >= mission::kLeastDegree && degree_ <= mission::kGreatestDegree);
  SKEIN_EXPECTS(!mission::deliberates(degree_) || core.config().knowledge != nullptr);
  SKEIN_EXPECTS(!mission::allocates(degree_) || core.config().team.has_value());
}

void Autonomy::start() {
  core_.bus().emit(DegreeChanged{degree_, "", std::nullopt});
  if (!mission::deliberates(degree_)) return;
  core_.deliberation().engage(
      supervisor::Engage{true, "start at degree " + std::to_string(degree_)});
}

void Autonomy::take(const Command& command) {
  const auto& wanted = std::get<mission::ChangeDegree>(command.request);
  if (mission::deliberates(wanted.degree) && !core_.deliberation().possible()) {
    return core_.commands().refuse(command,
                                   "no planning domain in the scenario: degree 4 cannot be had");
  }
  if (mission::allocates(wanted.degree) && !core_.team().possible()) {
    return core_.commands().refuse(command, "no team in the scenario: degree 5 cannot be had");
  }
  core_.commands().answer(command, true, "");
  change(wanted, command.asked_by);
}

// down    what runs goes on (unless interrupted); what is only planned is handed over
// up      from the executive's plan; with `resume`, from what was handed over
// same    the plan is told again; after a loss of contact, degree 4 goes on
void Autonomy::change(const mission::ChangeDegree& change, const std::string& asked_by) {
  const std::string cause = "degree " + std::to_string(change.degree) + " by " +
                            (asked_by.empty() ? "the ground" : asked_by);
  const bool will_deliberate = mission::deliberates(change.degree);
  const bool executed_here = !mission::runs_at_ground(degree_);
  if (!will_deliberate || change.interrupt) core_.deliberation().disengage(cause);
  degree_ = change.degree;
  if (change.interrupt) interrupt_everything();
  std::vector<mission::HeldTask> held = core_.execution().held();
  if (mission::runs_at_ground(degree_)) {
    // What is being interrupted is seen to its end here, as what was left with a role is, and own
    // tasks stay: they have numbers which the ground cannot give back.
    const executive::TaskId below =
        change.interrupt ? executive::TaskId(0) : functional::kFirstRoleId;
    std::erase_if(held, [&](const auto& one) { return one.task.id >= below; });
    core_.execution().let_go(below, held);
  }
  const std::vector<mission::HeldTask> planned = core_.deliberation().take_handed_over();
  held.insert(held.end(), planned.begin(), planned.end());
  core_.bus().emit(DegreeChanged{degree_, asked_by, held.size()});
  hand_over(std::move(held));
  if (will_deliberate && !core_.deliberation().engaged()) {
    engage(change.resume, cause, executed_here);
  }
}

// From degree 1 the ground gives back what its executive has; else what is not here is lost. Own
// tasks, such as a hold, have kept the UAV safe and give way.
void Autonomy::engage(bool resume, const std::string& cause, bool executed_here) {
  supervisor::Engage engage{resume, cause};
  if (executed_here) {
    std::vector<executive::TaskId>& here = engage.in_executive.emplace();
    for (const mission::HeldTask& one : core_.execution().held()) here.push_back(one.task.id);
  }
  for (const auto& [task, type] : core_.vehicle().of_ground()) engage.elsewhere.push_back(task);
  core_.deliberation().engage(engage);
  core_.own_tasks().abort_all();
}

// The highest id first, so that nothing is dispatched for want of what it waited for.
void Autonomy::interrupt_everything() {
  const auto passed = core_.vehicle().of_ground();
  for (auto one = passed.rbegin(); one != passed.rend(); ++one) core_.interrupt(one->first);
  const std::vector<mission::HeldTask> tasks = core_.execution().held();
  for (auto one = tasks.rbegin(); one != tasks.rend(); ++one) {
    core_.execution().run(executive::Abort{one->task.id});
  }
  if (core_.execution().airborne() || core_.config().drives)
    core_.safekeeping().keep(ContactPolicy::kHold);
}

void Autonomy::hand_over(std::vector<mission::HeldTask> tasks) {
  const std::vector<mission::HeldTask> planned = core_.deliberation().take_handed_over();
  tasks.insert(tasks.end(), planned.begin(), planned.end());
  std::sort(tasks.begin(), tasks.end(),
            [](const auto& a, const auto& b) { return a.task.id < b.task.id; });
  core_.bus().emit(HandedOver{{degree_, std::move(tasks), core_.deliberation().goals()}});
}

}  // namespace skein::decision_node
