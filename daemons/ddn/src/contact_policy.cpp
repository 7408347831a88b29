// SPDX-License-Identifier: Apache-2.0
// What the UAV does by itself: out of contact, or interrupted in the air.
#include <algorithm>

#include "skein/ddn/ddn_node.hpp"
#include "skein/supervisor/way_home.hpp"
#include "skein/translation/sensing.hpp"

namespace skein::ddn {

// What is planned is given up and what flies the vehicle is interrupted, so that nothing of the
// plan moves it while the ground is silent; the supervisor decides nothing more. What the ground
// itself requested (degree 1) is interrupted first.
void DdnNode::carry_out_contact_policy() {
  const bool holds = config_.contact_policy == ContactPolicy::kHold;
  const std::string policy = holds ? "hold" : "return";
  log(record("contact").with("uav", config_.uav).with("policy", policy));
  const bool deliberated = engaged();
  disengage("contact lost: " + policy);
  if (airborne_) {
    const auto passed = passed_through_;
    for (const auto& [task, type] : passed) interrupt_functional(task);
    const std::vector<executive::TaskStatus> tasks = executive_.tasks();
    for (auto task = tasks.rbegin(); task != tasks.rend(); ++task) {
      if (task->state == executive::TaskState::kScheduled) run(executive::Abort{task->id});
    }
    keep_safe(config_.contact_policy);
  }
  if (!deliberated) return;
  std::vector<mission::HeldTask> held = tasks_in_executive();
  held.insert(held.end(), handed_over_.begin(), handed_over_.end());
  handed_over_.clear();
  send_hand_over(std::move(held));
}

void DdnNode::keep_safe(ContactPolicy how) {
  safe_tasks_pending_ = how;
  start_safe_tasks();
}

void DdnNode::start_safe_tasks() {
  if (!safe_tasks_pending_ || !passed_through_.empty()) return;
  const ContactPolicy how = *safe_tasks_pending_;
  safe_tasks_pending_.reset();
  holds_ = how == ContactPolicy::kHold;
  if (holds_) {
    start_own("wait", {}, executive::InsertionMode::kVut);
    return;
  }
  start_own("goto", {{"waypoints", "", config_.home}}, executive::InsertionMode::kVut);
  start_own("land", {}, executive::InsertionMode::kNut);
}

// A hold of its own ends before the vehicle cannot come home any more; the ground may be silent, or
// have forgotten it.
void DdnNode::come_home_in_time(const wire::Telemetry& telemetry) {
  if (!holds_ || !airborne_ || !config_.knowledge) return;
  const double needed = supervisor::least_to_come_home(*config_.knowledge, *config_.world, now_,
                                                       translation::from_wire(telemetry).position);
  if (!(telemetry.energy <= needed)) return;  // of a vehicle without figures nothing is known
  log(record("contact")
          .with("uav", config_.uav)
          .with("policy", "return")
          .with("why", "held until the energy lasts no longer than to come home"));
  holds_ = false;
  keep_safe(ContactPolicy::kReturn);
}

void DdnNode::start_own(const std::string& type, executive::Parameters parameters,
                        executive::InsertionMode mode) {
  const std::int64_t milliseconds = std::max<std::int64_t>(now_.count(), 0) / 1'000'000;
  next_own_task_ =
      std::max(next_own_task_, kFirstOwnTask + static_cast<std::uint64_t>(milliseconds));
  executive::Task task;
  task.id = executive::TaskId(next_own_task_++);
  task.type = type;
  task.parameters = std::move(parameters);
  run(executive::Start{std::move(task), mode});
}

}  // namespace skein::ddn
