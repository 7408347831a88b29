// SPDX-License-Identifier: Apache-2.0
#include "timers.hpp"

#include "skein/foundation/contract.hpp"

namespace skein::executive {

void Timers::set(const Timer& timer) {
  queue_.push(timer);
  due_.insert_or_assign(timer.id, timer);
  trim();
}

void Timers::drop(TaskId id) {
  if (due_.erase(id) > 0) trim();
}

void Timers::put_off(Timer::Kind kind, MissionTime at) {
  for (auto& [id, timer] : due_) {
    if (timer.kind != kind) continue;
    timer.at = at;
    queue_.push(timer);
  }
  trim();
}

std::optional<MissionTime> Timers::next() const {
  if (queue_.empty()) return std::nullopt;
  return queue_.top().at;
}

Timer Timers::take() {
  SKEIN_EXPECTS(!queue_.empty());
  const Timer timer = queue_.top();
  queue_.pop();
  drop(timer.id);
  return timer;
}

void Timers::trim() {
  while (!queue_.empty()) {
    const auto due = due_.find(queue_.top().id);
    if (due != due_.end() && due->second == queue_.top()) return;
    queue_.pop();
  }
}

}  // namespace skein::executive
