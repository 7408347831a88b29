// SPDX-License-Identifier: Apache-2.0
// What a task goes through, and what that asks of the world. Source: T III.1.1, III.2.3, spec 2.6.
#include <utility>

#include "core.hpp"

namespace skein::executive {

// Every transition passes here: the fact changes, then who depends on it is queued.
void Executive::Core::set_state(Slot slot, TaskState state, const std::string& reason) {
  TaskRecord& record = plan_[slot];
  const bool was_aborting = record.state == TaskState::kAborting;
  record.reason = reason;
  timers_.drop(record.id);
  plan_.set_state(slot, state);
  outbox_.event(record);
  conditions_.task_changed(slot);
  if (state == TaskState::kEnded) background_.left(config_.types.of(record.type).leaves);
  if (is_terminal(state)) retire(slot, was_aborting);
}

// What a terminal task held is given back.
void Executive::Core::retire(Slot slot, bool was_aborting) {
  TaskRecord& record = plan_[slot];
  const TaskId id = record.id;
  resources_.release(id, record.resources);
  conditions_.detach(slot, Role::kPreconditions);
  conditions_.detach(slot, Role::kExit);
  urgents_.leave(record);
  if (record.synchronisation) retire_synchronisation(record);
  urgents_.over(id, plan_);
  if (record.background) retire_background(slot, was_aborting);
}

// What partners were told stays true of one that ended, and is taken back otherwise.
void Executive::Core::retire_synchronisation(const TaskRecord& record) {
  const Synchronisation& synchronisation = *record.synchronisation;
  if (record.state == TaskState::kEnded) return synchroniser_.finish(record.id, synchronisation);
  for (const std::string& name : synchroniser_.withdraw(record.id, synchronisation)) {
    outbox_.add(SendSync{synchronisation.id, name, SyncWord::kWithdrawn});
  }
}

// A transition that nobody is told of; those whose conditions name the task see it aborted.
void Executive::Core::let_go(Slot slot) {
  TaskRecord& record = plan_[slot];
  const TaskId id = record.id;
  outbox_.let_go(id);
  if (record.urgent) urgents_.let_go(id);
  timers_.drop(id);
  // The partners are not told: who has the task now is there for them.
  if (record.synchronisation) synchroniser_.forget(id, *record.synchronisation);
  plan_.set_state(slot, TaskState::kAborted);
  conditions_.task_changed(slot);
  retire(slot, false);
  plan_.remove(slot);
  plan_.readmit(id);
}

void Executive::Core::expect_answer(TaskRecord& record) {
  if (!config_.functional_timeout || record.joint || record.synchronisation) return;
  timers_.set(Timer{now_ + *config_.functional_timeout, Timer::Kind::kTimeout, record.id});
}

// Who performs them keeps the dispatch behind the interruption.
void Executive::Core::make_way_for(const TaskRecord& task) {
  for (const TaskId id : resources_.users_of(task.resources)) {
    const Slot user = *plan_.find(id);
    if (plan_[user].idle && plan_[user].state != TaskState::kAborting)
      interrupt(user, "gives way to task " + to_text(task.id));
  }
}

// scheduled    Π satisfied, or urgent and free to go    started (synchronise: at once running)
void Executive::Core::dispatch(Slot slot) {
  TaskRecord& record = plan_[slot];
  if (record.uses(motion_) && background_.task() != record.id) {
    end_background("displaced by task " + to_text(record.id));
  }
  make_way_for(record);
  urgents_.leave(record);
  conditions_.detach(slot, Role::kPreconditions);
  resources_.acquire(record.id, record.resources);
  set_state(slot, TaskState::kStarted);
  if (record.synchronisation) return run_synchronisation(slot);
  outbox_.add(Dispatch{record.id, record.joint});
  expect_answer(record);
}

// started    at once                  running
// running    nobody to wait for       ended
void Executive::Core::run_synchronisation(Slot slot) {
  const TaskRecord& record = plan_[slot];
  const Synchronisation& synchronisation = *record.synchronisation;
  set_state(slot, TaskState::kRunning);
  const bool done = synchroniser_.begin(record.id, synchronisation, now_);
  say(synchronisation, done && config_.sync_validity ? SyncWord::kDone : SyncWord::kThere);
  if (done) {
    if (synchroniser_.met_before(synchronisation))
      outbox_.notice("task " + to_text(record.id) + ": synchronisation " +
                     std::to_string(synchronisation.id) +
                     " is over already, and is not waited for again");
    set_state(slot, TaskState::kEnded);
  } else if (config_.sync_validity) {
    say_again_later(slot);
  }
}

void Executive::Core::say(const Synchronisation& synchronisation, SyncWord word) {
  for (const std::string& name : synchroniser_.targets(synchronisation)) {
    outbox_.add(SendSync{synchronisation.id, name, word});
  }
}

// Half of the validity, so that one lost message does not make a partner disappear. Who tells
// nobody needs no reminder.
void Executive::Core::say_again_later(Slot slot) {
  TaskRecord& record = plan_[slot];
  if (synchroniser_.targets(*record.synchronisation).empty()) return;
  const Duration half = Duration::nanoseconds(config_.sync_validity->count() / 2);
  timers_.set(Timer{now_ + half, Timer::Kind::kSyncAgain, record.id});
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
  outbox_.add(Interrupt{record.id, record.joint});
  expect_answer(record);
}

}  // namespace skein::executive
