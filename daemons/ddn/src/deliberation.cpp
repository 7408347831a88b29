// SPDX-License-Identifier: Apache-2.0
// What the supervisor asks for: jobs, requests to the executive, words to the ground.
#include "skein/translation/missions.hpp"

#include "deliberation_lines.hpp"
#include "skein/ddn/ddn_node.hpp"

namespace skein::ddn {

namespace {

using translation::to_wire;

std::string joined(const std::vector<std::string>& reasons) {
  std::string text;
  for (const std::string& one : reasons) text += (text.empty() ? "" : "; ") + one;
  return text;
}

void tell_estimate(journal::Record& line, const mission::MissionEstimate& estimate) {
  line.with("placement", std::string(mission::to_text(estimate.placement)))
      .with("cost", estimate.cost)
      .with("energy", estimate.energy)
      .with("earliest_end", estimate.earliest_end.to_seconds());
  if (estimate.latest_end == MissionTime::max()) return;
  line.with("latest_end", estimate.latest_end.to_seconds());
}

}  // namespace

void DdnNode::carry_out(const supervisor::Answer& effect) {
  const auto& command = asked_supervisor_->command;
  if (command) answer(*command, effect.accepted, joined(effect.reasons));
}

void DdnNode::carry_out(const supervisor::MissionDecided& effect) {
  journal::Record line = record("answer");
  line.with("uav", config_.uav)
      .with("mission", effect.outcome.mission.value())
      .with("planned", effect.outcome.planned);
  if (!effect.outcome.reasons.empty()) line.with("why", joined(effect.outcome.reasons));
  if (effect.outcome.evaluated) line.with("evaluated", true);
  if (effect.outcome.estimate) tell_estimate(line, *effect.outcome.estimate);
  log(line);
  send_to_ground(to_wire(config_.uav, effect.outcome));
}

void DdnNode::carry_out(const supervisor::ToExecutive& effect) {
  run(ForExecutive{effect.input, true, std::nullopt});
}

void DdnNode::carry_out(const supervisor::StartDeliberation& effect) {
  const auto work = [request = effect.request](const node::TimeIsUp& time_is_up) -> std::any {
    return supervisor::deliberate(*request, time_is_up);
  };
  out_.push_back(node::StartJob{effect.job, work, config_.deliberation});
}

void DdnNode::carry_out(const supervisor::StopDeliberation& effect) {
  out_.push_back(node::StopJob{effect.job});
}

// Of the tasks of a revision, those are logged that were not so in the one before.
void DdnNode::carry_out(const supervisor::PlanChanged& effect) {
  const mission::PlanReport& report = effect.report;
  for (const mission::PlannedTask& one : report.tasks) {
    origins_.insert_or_assign(one.task.id, one.task.origin);
  }
  const wire::MissionPlan plan = to_wire(config_.uav, report);
  log(plan_line(writer(), report));
  std::map<std::uint64_t, wire::PlanEntry> logged;
  for (std::size_t i = 0; i < plan.tasks.size(); ++i) {  // in the order of the report
    const wire::PlanEntry& task = plan.tasks[i];
    const auto before = logged_plan_.find(task.id);
    if (before == logged_plan_.end() || before->second != task) {
      log(planned_line(writer(), plan.revision, task, report.tasks[i].task.parameters));
    }
    logged.emplace(task.id, task);
  }
  logged_plan_ = std::move(logged);
  send_to_ground(plan);
}

void DdnNode::carry_out(const supervisor::GoalChanged& effect) {
  log(goal_line(writer(), effect.status));
}

void DdnNode::carry_out(const supervisor::Decided& effect) {
  log(decision_line(writer(), effect.decision));
  send_to_ground(to_wire(config_.uav, effect.decision));
}

void DdnNode::carry_out(const supervisor::HandedOver& effect) { handed_over_ = effect.tasks; }

void DdnNode::carry_out(const supervisor::LoadJointTask& effect) {
  tell(supervisor::JointTaskAnswered{effect.task.id, false, {}, "no interaction manager"});
}

void DdnNode::carry_out(const supervisor::Notice& notice) {
  log(record("notice").with("uav", config_.uav).with("text", notice.text));
}

}  // namespace skein::ddn
