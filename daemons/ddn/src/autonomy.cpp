// SPDX-License-Identifier: Apache-2.0
// The degree of autonomy and what is handed over when it changes. Source: spec 1.2.
#include <algorithm>

#include "skein/ddn/ddn_node.hpp"
#include "skein/translation/missions.hpp"

namespace skein::ddn {

namespace {

const char* name_of(ContactPolicy policy) {
  switch (policy) {
    case ContactPolicy::kHold:
      return "hold";
    case ContactPolicy::kReturn:
      return "return";
    case ContactPolicy::kContinue:
      break;
  }
  return "continue";
}

}  // namespace

// down    what runs goes on (unless interrupted); what is only planned is handed over
// up      from the executive's plan; with `resume`, from what was handed over
// same    the plan is told again; after a loss of contact, degree 4 goes on
void DdnNode::change_degree(const mission::ChangeDegree& change, const std::string& asked_by) {
  const std::string cause = "degree " + std::to_string(change.degree) + " by " +
                            (asked_by.empty() ? "the ground" : asked_by);
  const bool deliberates = change.degree == mission::kGreatestDegree;
  const bool executed_here = degree_ > mission::kLeastDegree;
  if (!deliberates || change.interrupt) disengage(cause);
  degree_ = change.degree;
  if (change.interrupt) interrupt_everything();
  std::vector<mission::HeldTask> held = tasks_in_executive();
  if (degree_ == mission::kLeastDegree) {
    // What is being interrupted is seen to its end here, and own tasks stay.
    const std::uint64_t below = change.interrupt ? 0 : kFirstOwnTask;
    std::erase_if(held, [&](const auto& one) { return one.task.id.value() >= below; });
    let_go(executive::TaskId(below), held);
  }
  held.insert(held.end(), handed_over_.begin(), handed_over_.end());
  handed_over_.clear();
  journal::Record line = record("degree");
  line.with("uav", config_.uav).with("degree", degree_);
  if (!asked_by.empty()) line.with("by", asked_by);
  log(line.with("held", static_cast<std::int64_t>(held.size())));
  tell_degree();
  send_hand_over(std::move(held));
  if (deliberates && !engaged()) engage(change.resume, cause, executed_here);
}

// From degree 1 the ground gives back what its executive has; else what is not here is lost. Own
// tasks, such as a hold, have kept the UAV safe and give way.
void DdnNode::engage(bool resume, const std::string& cause, bool executed_here) {
  supervisor::Engage engage{resume, cause};
  if (executed_here) {
    std::vector<executive::TaskId>& here = engage.in_executive.emplace();
    for (const mission::HeldTask& one : tasks_in_executive()) here.push_back(one.task.id);
  }
  tell(engage);
  const std::set<std::uint64_t> open = own_open_;
  for (auto id = open.rbegin(); id != open.rend(); ++id) {
    run(executive::Abort{executive::TaskId(*id)});
  }
}

void DdnNode::disengage(const std::string& cause) {
  if (engaged()) tell(supervisor::Disengage{cause});
}

// The highest id first, so that nothing is dispatched for want of what it waited for.
void DdnNode::interrupt_everything() {
  const auto passed = passed_through_;
  for (auto one = passed.rbegin(); one != passed.rend(); ++one) interrupt_functional(one->first);
  const std::vector<mission::HeldTask> tasks = tasks_in_executive();
  for (auto one = tasks.rbegin(); one != tasks.rend(); ++one) run(executive::Abort{one->task.id});
  if (airborne_) keep_safe(ContactPolicy::kHold);
}

std::vector<mission::HeldTask> DdnNode::tasks_in_executive() const {
  std::vector<mission::HeldTask> held;
  for (const executive::TaskStatus& status : executive_.tasks()) {
    if (is_terminal(status.state) || status.id >= executive::kFirstBackgroundId) continue;
    const executive::TaskView view = *executive_.find(status.id);
    mission::HeldTask& one = held.emplace_back();
    one.task.id = view.id;
    one.task.type = view.type;
    one.task.parameters = view.parameters;
    one.task.preconditions = executive_.preconditions(view.id);
    one.task.exit = executive_.exit_conditions(view.id);
    if (view.synchronisation != nullptr) one.task.synchronisation = *view.synchronisation;
    one.state = view.state;
    one.in_executive = true;
    const auto origin = origins_.find(view.id);
    if (origin != origins_.end()) one.origin = origin->second;
  }
  return held;
}

// The ground's executive has them from now on, with the synchronisation messages that came here.
void DdnNode::let_go(executive::TaskId below, const std::vector<mission::HeldTask>& tasks) {
  for (const mission::HeldTask& one : tasks) {
    if (one.state == executive::TaskState::kScheduled || one.task.synchronisation) continue;
    passed_through_.emplace(one.task.id.value(), one.task.type);
  }
  run(executive::Relinquish{below});
  for (const auto& [key, message] : syncs_) {
    wire::SyncMessage again = message;
    again.header = {};
    send_to_ground(again);
  }
}

void DdnNode::tell_degree() {
  wire::AutonomyDegree sample;
  sample.uav = config_.uav;
  sample.degree = static_cast<std::uint8_t>(degree_);
  sample.contact_policy = name_of(config_.contact_policy);
  send_to_ground(sample);
}

void DdnNode::send_hand_over(std::vector<mission::HeldTask> tasks) {
  std::sort(tasks.begin(), tasks.end(),
            [](const auto& a, const auto& b) { return a.task.id < b.task.id; });
  mission::HandOver hand_over{degree_, std::move(tasks), {}};
  if (supervisor_) hand_over.goals = supervisor_->report().goals;
  send_to_ground(translation::to_wire(config_.uav, hand_over));
}

}  // namespace skein::ddn
