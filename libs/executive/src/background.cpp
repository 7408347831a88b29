// SPDX-License-Identifier: Apache-2.0
#include "background.hpp"

#include "core.hpp"

namespace skein::executive {

void Background::left(functional::Leaves leaves) {
  if (leaves == functional::Leaves::kInTheAir) airborne_ = true;
  if (leaves == functional::Leaves::kOnTheGround) airborne_ = false;
}

TaskId Background::begin() {
  task_ = TaskId{kFirstBackgroundId.value() + count_++};
  return *task_;
}

void Background::over(bool pauses) {
  task_.reset();
  pauses_ = pauses;
}

// A motion task that is aborting still moves, and an urgent one is about to: the routine waits.
bool Executive::Core::dispatch_background() {
  const bool wanted = config_.background_type && background_.wanted() && !urgents_.any_to_move() &&
                      resources_.users_of(motion_).empty();
  if (!wanted) return false;
  const TaskId id = background_.begin();
  const Slot slot = plan_.insert(Task{id, *config_.background_type, {}, {}, {}, {}}, true);
  plan_[slot].resources = {motion_};
  outbox_.event(plan_[slot]);
  dispatch(slot);
  return true;
}

void Executive::Core::end_background(const std::string& reason) {
  if (!background_.task()) return;
  const Slot slot = *plan_.find(*background_.task());
  if (plan_[slot].state != TaskState::kAborting) interrupt(slot, reason);
}

void Executive::Core::retire_background(Slot slot, bool displaced) {
  background_.over(!displaced);
  if (!displaced) {
    const MissionTime retry = now_ + config_.background_retry;
    timers_.set(Timer{retry, Timer::Kind::kBackgroundRetry, plan_[slot].id});
  }
  plan_.remove(slot);
}

}  // namespace skein::executive
