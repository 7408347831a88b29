// SPDX-License-Identifier: Apache-2.0
// What a task goes through, and what that asks of the world. Source: T III.1.1, III.2.3, spec 2.6.
#include <utility>

#include "core.hpp"

namespace skein::executive {

void Executive::Core::announce(const TaskRecord& record) {
  TaskEvent event{record.id, record.type, record.state, record.reason};
  const std::uint32_t own = record.joint && is_active(record.state) ? 1 : 0;
  const bool others_joint = joint_active_ > own;
  effects_.push_back(event);
  if (others_joint) effects_.push_back(ForwardToSupervisor{std::move(event)});
}

// Every transition passes here: the fact changes, then who depends on it is queued.
void Executive::Core::set_state(Slot slot, TaskState state, const std::string& reason) {
  TaskRecord& record = plan_[slot];
  const bool was_active = is_active(record.state);
  const bool was_aborting = record.state == TaskState::kAborting;
  record.reason = reason;
  record.due.reset();
  plan_.set_state(slot, state);
  if (record.joint && was_active != is_active(state)) {
    was_active ? --joint_active_ : ++joint_active_;
  }
  announce(record);
  conditions_.task_changed(slot);
  if (state == TaskState::kEnded) note_flight(config_.types.of(record.type).leaves);
  if (is_terminal(state)) retire(slot, was_aborting);
}

void Executive::Core::note_flight(functional::Leaves leaves) {
  if (leaves == functional::Leaves::kInTheAir) airborne_ = true;
  if (leaves == functional::Leaves::kOnTheGround) airborne_ = false;
}

// What a terminal task held is given back.
void Executive::Core::retire(Slot slot, bool was_aborting) {
  TaskRecord& record = plan_[slot];
  const TaskId id = record.id;
  resources_.release(id, record.resources);
  conditions_.detach(slot, Role::kPreconditions);
  conditions_.detach(slot, Role::kExit);
  if (record.urgent) urgent_motion_.erase(id);
  record.urgent = false;
  if (record.synchronisation) {
    const bool ended = record.state == TaskState::kEnded;
    ended ? synchroniser_.finish(id, *record.synchronisation)
          : synchroniser_.forget(id, *record.synchronisation);
  }
  free_urgents(id);
  if (record.background) {
    retire_background(was_aborting);
    plan_.remove(slot);
  }
}

// A transition that nobody is told of; those whose conditions name the task see it aborted.
void Executive::Core::let_go(Slot slot) {
  TaskRecord& record = plan_[slot];
  const TaskId id = record.id;
  if (record.joint && is_active(record.state)) --joint_active_;
  if (record.urgent) {
    for (auto& [blocker, waiting] : waiting_for_) std::erase(waiting, id);
  }
  record.due.reset();
  plan_.set_state(slot, TaskState::kAborted);
  conditions_.task_changed(slot);
  retire(slot, false);
  plan_.remove(slot);
  plan_.readmit(id);
}

void Executive::Core::free_urgents(TaskId blocker) {
  const auto waiting = waiting_for_.find(blocker);
  if (waiting == waiting_for_.end()) return;
  for (const TaskId id : waiting->second) {
    const std::optional<Slot> slot = plan_.find(id);
    if (!slot || !plan_[*slot].urgent || plan_[*slot].blockers == 0) continue;
    if (--plan_[*slot].blockers == 0) urgent_ready_.push(id, *slot);
  }
  waiting_for_.erase(waiting);
}

bool Executive::Core::answers_functionally(const TaskRecord& record) const {
  return !record.joint && !record.synchronisation;
}

void Executive::Core::expect_answer(TaskRecord& record) {
  if (!config_.functional_timeout || !answers_functionally(record)) return;
  record.due = now_ + *config_.functional_timeout;
  timers_.set(Timer{*record.due, Timer::Kind::kTimeout, record.id});
}

// scheduled    Π satisfied, or urgent and free to go    started (synchronise: at once running)
void Executive::Core::dispatch(Slot slot) {
  TaskRecord& record = plan_[slot];
  if (uses_motion(record)) displace_background(record.id);
  if (record.urgent) urgent_motion_.erase(record.id);
  record.urgent = false;
  conditions_.detach(slot, Role::kPreconditions);
  resources_.acquire(record.id, record.resources);
  set_state(slot, TaskState::kStarted);
  if (record.synchronisation) return run_synchronisation(slot);
  effects_.push_back(Dispatch{record.id, record.joint});
  expect_answer(record);
}

// started    at once                  running
// running    nobody to wait for       ended
void Executive::Core::run_synchronisation(Slot slot) {
  const TaskRecord& record = plan_[slot];
  const Synchronisation& synchronisation = *record.synchronisation;
  set_state(slot, TaskState::kRunning);
  for (const std::string& name : synchroniser_.targets(synchronisation)) {
    effects_.push_back(SendSync{synchronisation.id, name});
  }
  if (synchroniser_.begin(record.id, synchronisation)) set_state(slot, TaskState::kEnded);
}

std::string Executive::Core::reason_of_exit(const TaskRecord& record) const {
  const bool late = record.synchronisation && record.synchronisation->deadline &&
                    *record.synchronisation->deadline <= now_;
  return late ? "the deadline has passed" : "exit conditions satisfied";
}

// scheduled           aborted
// started, running    aborting
void Executive::Core::interrupt_or_cancel(Slot slot, const std::string& reason) {
  if (plan_[slot].state == TaskState::kScheduled) {
    set_state(slot, TaskState::kAborted, reason);
  } else {
    interrupt(slot, reason);
  }
}

// started, running    aborting (synchronise: at once aborted)
void Executive::Core::interrupt(Slot slot, const std::string& reason) {
  TaskRecord& record = plan_[slot];
  set_state(slot, TaskState::kAborting, reason);
  if (record.synchronisation) return set_state(slot, TaskState::kAborted, reason);
  effects_.push_back(Interrupt{record.id, record.joint});
  expect_answer(record);
}

}  // namespace skein::executive
