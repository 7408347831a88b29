// SPDX-License-Identifier: Apache-2.0
// The five requests. Each is answered first, then takes effect. Source: T III.2.1, spec 2.3.
#include <utility>

#include "core.hpp"

namespace skein::executive {

namespace {

std::optional<std::string> not_in_plan(TaskId id) {
  return "task " + to_text(id) + " is not in the plan";
}

std::optional<std::string> refusal_of(const Start& request, const Plan& plan,
                                      const TypeTable& types) {
  const Task& task = request.task;
  if (task.id >= kFirstBackgroundId) {
    return "ids from " + to_text(kFirstBackgroundId) + " on are those of the background routine";
  }
  if (!plan.may_insert(task.id)) return "id " + to_text(task.id) + " is known already";
  if (types.of(task.type).synchronises() != task.synchronisation.has_value()) {
    return "a task has a synchronisation exactly when its type synchronises";
  }
  return std::nullopt;
}

// Π according to the mode of insertion.
Formula preconditions_of(const Start& request, const Plan& plan) {
  if (request.mode == InsertionMode::kSeq) return request.task.preconditions;
  Formula formula;
  if (request.mode == InsertionMode::kVut) return formula;
  const Modality modality =
      request.mode == InsertionMode::kDep ? Modality::kMandatory : Modality::kOptional;
  for (const TaskId id : plan.open()) {
    const TaskRecord& other = plan[*plan.find(id)];
    if (other.idle && is_active(other.state)) continue;
    formula.push_back({Literal{TaskInState{id, TaskState::kEnded}, false, modality}});
  }
  return formula;
}

std::optional<std::string> refusal_of(const UpdateConditions& request, const Plan& plan,
                                      const Conditions& conditions) {
  const std::optional<Plan::Slot> slot = plan.find(request.id);
  if (!slot || plan[*slot].background) return not_in_plan(request.id);
  const TaskRecord& record = plan[*slot];
  const std::string task = "task " + to_text(request.id);
  const std::string state(to_text(record.state));
  if (is_terminal(record.state)) return task + " is " + state;
  if (request.preconditions && record.state != TaskState::kScheduled) {
    return task + " is " + state + ": its preconditions no longer matter";
  }
  if (request.preconditions && record.urgent) return task + " is urgent: it has no preconditions";
  return conditions.incoherence(request.id,
                                request.preconditions ? &*request.preconditions : nullptr,
                                request.exit ? &*request.exit : nullptr, std::nullopt);
}

}  // namespace

// --- START ---------------------------------------------------------------------------------------

Plan::Slot Executive::Core::enter(const Task& task) {
  Task copy{task.id, task.type, task.parameters, {}, {}, task.synchronisation};
  const Slot slot = plan_.insert(std::move(copy), false);
  for (const std::string& resource : config_.types.resources_of(task.type, task.parameters)) {
    plan_[slot].resources.push_back(resources_.number_of(resource));
  }
  return slot;
}

// (new)   coherent     scheduled
// (new)   otherwise    aborted
void Executive::Core::on(const Start& request) {
  const Task& task = request.task;
  const std::optional<std::string> refusal = refusal_of(request, plan_, config_.types);
  outbox_.reply(RequestKind::kStart, task.id, refusal);
  if (refusal) return;
  background_.rest(false);
  if (!config_.types.is_declared(task.type)) {
    outbox_.notice("type '" + task.type + "' is not declared: it uses no exclusive resource");
  }
  const std::optional<MissionTime> deadline =
      task.synchronisation ? task.synchronisation->deadline : std::nullopt;
  const Formula preconditions = preconditions_of(request, plan_);
  const std::optional<std::string> incoherence =
      conditions_.incoherence(task.id, &preconditions, &task.exit, deadline);
  const Slot slot = enter(task);
  if (incoherence) return set_state(slot, TaskState::kAborted, *incoherence);
  outbox_.event(plan_[slot]);
  plan_[slot].idle = config_.idle_type == task.type && task.exit.empty() &&
                     task.parameters.find("duration") == nullptr;
  plan_[slot].urgent = request.mode == InsertionMode::kVut;
  conditions_.attach(slot, Role::kExit, task.exit, deadline);
  conditions_.attach(slot, Role::kPreconditions, preconditions, std::nullopt);
  if (request.mode == InsertionMode::kVut) make_urgent(slot);
}

// Interrupts what is incompatible and under way, and waits for it, also for what is aborting.
// Urgent ones that wait, too, it replaces if it is to.
void Executive::Core::make_urgent(Slot slot) {
  TaskRecord& urgent = plan_[slot];
  if (config_.last_urgent_counts) {
    for (const TaskId id : urgents_.in_place_of(urgent, plan_))
      set_state(*plan_.find(id), TaskState::kAborted,
                "urgent task " + to_text(urgent.id) + " takes its place");
  }
  const std::set<TaskId> blockers = resources_.users_of(urgent.resources);
  urgents_.enter(urgent, slot, blockers, urgent.uses(motion_));
  if (blockers.empty()) return;
  timers_.set(Timer{now_ + config_.urgent_wait, Timer::Kind::kUrgentWait, urgent.id});
  for (const TaskId id : blockers) {
    const Slot blocker = *plan_.find(id);
    if (plan_[blocker].state != TaskState::kAborting) {
      interrupt(blocker, "displaced by urgent task " + to_text(urgent.id));
    }
  }
}

// --- ABORT, PROCESS-MSG, SUPPRESS ----------------------------------------------------------------

// scheduled           aborted
// started, running    aborting
// otherwise           no effect
void Executive::Core::on(const Abort& request) {
  const std::optional<Slot> slot = plan_.find(request.id);
  const bool ours = slot && !plan_[*slot].background;
  outbox_.reply(RequestKind::kAbort, request.id, ours ? std::nullopt : not_in_plan(request.id));
  if (!ours) return;
  const TaskState state = plan_[*slot].state;
  if (is_terminal(state) || state == TaskState::kAborting) return;
  plan_[*slot].cause = AbortCause::kRequested;
  interrupt_or_cancel(*slot, "abort requested");
}

void Executive::Core::on(const ProcessMessage& request) {
  outbox_.reply(RequestKind::kProcessMessage, std::nullopt, std::nullopt);
  conditions_.message_received(request.message);
}

void Executive::Core::on(const Suppress& request) {
  const std::optional<Slot> slot = plan_.find(request.id);
  std::optional<std::string> refusal;
  if (!slot || plan_[*slot].background) {
    refusal = not_in_plan(request.id);
  } else if (!is_terminal(plan_[*slot].state)) {
    refusal = "task " + to_text(request.id) + " is " + std::string(to_text(plan_[*slot].state)) +
              ", not terminal";
  }
  outbox_.reply(RequestKind::kSuppress, request.id, refusal);
  if (refusal) return;
  if (const auto& synchronisation = plan_[*slot].synchronisation) {
    synchroniser_.forget(request.id, *synchronisation);
  }
  plan_.remove(*slot);
}

// --- UPDATE-COND ---------------------------------------------------------------------------------

void Executive::Core::on(const UpdateConditions& request) {
  const std::optional<std::string> refusal = refusal_of(request, plan_, conditions_);
  outbox_.reply(RequestKind::kUpdateConditions, request.id, refusal);
  if (refusal) return;
  const Slot slot = *plan_.find(request.id);
  if (request.exit) {
    plan_[slot].idle = plan_[slot].idle && request.exit->empty();
    const auto& synchronisation = plan_[slot].synchronisation;
    conditions_.attach(slot, Role::kExit, *request.exit,
                       synchronisation ? synchronisation->deadline : std::nullopt);
  }
  if (request.preconditions) {
    conditions_.attach(slot, Role::kPreconditions, *request.preconditions, std::nullopt);
  }
}

}  // namespace skein::executive
