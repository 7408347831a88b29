// SPDX-License-Identifier: Apache-2.0
// The background routine: what the vehicle does in flight when no task moves it. Source: T VI.1.3.
#include <algorithm>

#include "core.hpp"

namespace skein::executive {

bool Executive::Core::uses_motion(const TaskRecord& record) const {
  return std::find(record.resources.begin(), record.resources.end(), motion_) !=
         record.resources.end();
}

// A motion task that is aborting still moves, and an urgent one is about to: the routine waits.
bool Executive::Core::wants_background() const {
  return config_.background_type && airborne_ && !resting_ && !background_ && !background_retry_ &&
         urgent_motion_.empty() && resources_.users_of(motion_).empty();
}

void Executive::Core::dispatch_background() {
  const TaskId id{kFirstBackgroundId.value() + background_count_++};
  const Slot slot = plan_.insert(Task{id, *config_.background_type, {}, {}, {}, {}}, true);
  plan_[slot].resources = {motion_};
  background_ = id;
  announce(plan_[slot]);
  dispatch(slot);
}

void Executive::Core::displace_background(TaskId by) {
  if (background_ != by) end_background("displaced by task " + to_text(by));
}

void Executive::Core::end_background(const std::string& reason) {
  if (!background_) return;
  const Slot slot = *plan_.find(*background_);
  if (plan_[slot].state != TaskState::kAborting) interrupt(slot, reason);
}

// A routine that ended or was refused by itself is not tried again at once.
void Executive::Core::retire_background(bool displaced) {
  background_.reset();
  if (displaced) return;
  background_retry_ = now_ + config_.background_retry;
  timers_.set(Timer{*background_retry_, Timer::Kind::kBackgroundRetry, TaskId{}});
}

}  // namespace skein::executive
