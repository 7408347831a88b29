// SPDX-License-Identifier: Apache-2.0
#include "safekeeping.hpp"

#include "core.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/supervisor/way_home.hpp"

namespace skein::decision_node {

Safekeeping::Safekeeping(Core& core)
    : core_(core), contact_(core.config().contact_policy, core.config().contact_after) {}

void Safekeeping::time_passes() {
  if (contact_.due(core_.bus().now())) carry_out_policy();
}

// What is planned, or being synchronised, is given up and what flies the vehicle is interrupted, so
// that nothing of the plan moves it while the ground is silent; the supervisor decides nothing
// more. What the ground itself requested (degree 1) is interrupted first.
void Safekeeping::carry_out_policy() {
  const ContactPolicy policy = core_.config().contact_policy;
  core_.bus().emit(PolicyCarriedOut{policy, ""});
  Deliberation& deliberation = core_.deliberation();
  const bool deliberated = deliberation.engaged();
  deliberation.disengage("contact lost: " + std::string(to_text(policy)));
  if (core_.execution().airborne()) {
    const auto passed = core_.vehicle().of_ground();
    for (const auto& [task, type] : passed) core_.interrupt(task);
    const std::vector<executive::TaskStatus> tasks = core_.execution().tasks();
    for (auto task = tasks.rbegin(); task != tasks.rend(); ++task) {
      const bool waits = task->state == executive::TaskState::kScheduled;
      const bool talks = functional::TaskTypes::shipped().of(task->type).synchronises();
      if (waits || talks) core_.execution().run(executive::Abort{task->id});
    }
    keep(policy);
  }
  if (deliberated) core_.autonomy().hand_over(core_.execution().held());
}

void Safekeeping::keep(ContactPolicy how) {
  pending_ = how;
  start_pending();
}

// An own task that still waits for what it interrupted would begin together with the new one.
void Safekeeping::start_pending() {
  if (!pending_ || !core_.vehicle().of_ground().empty()) return;
  const ContactPolicy how = *pending_;
  pending_.reset();
  for (const executive::TaskStatus& task : core_.execution().tasks()) {
    const bool waits = task.state == executive::TaskState::kScheduled;
    if (waits && is_own(task.id)) core_.execution().run(executive::Abort{task.id});
  }
  holds_ = how == ContactPolicy::kHold;
  OwnTasks& own = core_.own_tasks();
  if (holds_) return own.start("wait", {}, executive::InsertionMode::kVut);
  own.start("goto", {{"waypoints", "", core_.config().home}}, executive::InsertionMode::kVut);
  own.start("land", {}, executive::InsertionMode::kNut);
}

void Safekeeping::own_task_over() { holds_ = holds_ && !core_.own_tasks().none_open(); }

void Safekeeping::come_home_in_time(const world::Telemetry& telemetry) {
  const Config& config = core_.config();
  if (!holds_ || !core_.execution().airborne() || !config.knowledge) return;
  const double needed = supervisor::least_to_come_home(*config.knowledge, *config.world,
                                                       core_.bus().now(), telemetry.state.position);
  // Of a vehicle without figures nothing is known.
  if (!(telemetry.state.energy <= needed)) return;
  core_.bus().emit(PolicyCarriedOut{ContactPolicy::kReturn,
                                    "held until the energy lasts no longer than to come home"});
  holds_ = false;
  keep(ContactPolicy::kReturn);
}

}  // namespace skein::decision_node
