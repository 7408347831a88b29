// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/task_board.hpp"

#include <algorithm>

namespace skein::ground_station {
namespace {

using executive::TaskId;
using executive::TaskState;

// How far along a task is; the two terminal states are equally far.
int progress(TaskState state) {
  switch (state) {
    case TaskState::kScheduled:
      return 0;
    case TaskState::kStarted:
      return 1;
    case TaskState::kRunning:
      return 2;
    case TaskState::kAborting:
      return 3;
    case TaskState::kEnded:
    case TaskState::kAborted:
      break;
  }
  return 4;
}

std::size_t bit_of(TaskState state) { return static_cast<std::size_t>(state); }

TaskOnBoard first_told(const TaskEventReceived& event, MissionTime now) {
  return {event.task, event.type, event.state, false, event.reason, now, event.at_ground};
}

}  // namespace

bool is_open(const TaskOnBoard& task) { return !task.lost && !executive::is_terminal(task.state); }

bool TaskBoard::learn(const TaskEventReceived& event, MissionTime now) {
  const auto [at, is_new] = entries_.try_emplace(event.task);
  Entry& entry = at->second;
  if (is_new) {
    entry.task = first_told(event, now);
  } else if (entry.task.lost) {
    // Only its first state shows that it was started anew, and is not late news of the former life.
    if (event.state != TaskState::kScheduled) return false;
    over_.erase({entry.task.since, event.task});
    entry = {first_told(event, now), {}};
  } else if (!is_open(entry.task)) {
    return tell(entry, event, now);  // it stays as it is, and where it is
  }
  const bool is_news = tell(entry, event, now);
  file(entry.task);
  return is_news;
}

// Precondition: the task is not lost.
bool TaskBoard::tell(Entry& entry, const TaskEventReceived& event, MissionTime now) {
  TaskOnBoard& task = entry.task;
  if (!executive::is_terminal(task.state)) task.at_ground = event.at_ground;
  if (entry.told.test(bit_of(event.state))) {
    if (task.reason.empty() && task.state == event.state) task.reason = event.reason;
    return false;
  }
  entry.told.set(bit_of(event.state));
  if (!executive::is_terminal(task.state) && progress(event.state) > progress(task.state)) {
    task.state = event.state;
    task.reason = event.reason;
    task.since = now;
  }
  return true;
}

void TaskBoard::file(const TaskOnBoard& task) {
  if (is_open(task)) {
    open_.insert(task.id);
  } else {
    open_.erase(task.id);
    over_.insert({task.since, task.id});
  }
}

std::vector<TaskId> TaskBoard::lose() {
  const auto routine = entries_.lower_bound(executive::kFirstBackgroundId);
  for (auto one = routine; one != entries_.end(); ++one) {
    open_.erase(one->first);
    over_.erase({one->second.task.since, one->first});
  }
  entries_.erase(routine, entries_.end());
  const std::vector<TaskId> lost(open_.begin(), open_.end());
  for (const TaskId id : lost) {
    TaskOnBoard& task = entries_.at(id).task;
    task.lost = true;
    file(task);
  }
  return lost;
}

const TaskOnBoard* TaskBoard::find(TaskId id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : &found->second.task;
}

bool TaskBoard::has_told(TaskId id, TaskState state) const {
  const auto found = entries_.find(id);
  return found != entries_.end() && !found->second.task.lost &&
         found->second.told.test(bit_of(state));
}

std::vector<const TaskOnBoard*> TaskBoard::last_over(std::size_t count) const {
  std::vector<const TaskOnBoard*> last;
  for (auto one = over_.begin(); one != over_.end() && last.size() < count; ++one)
    last.push_back(find(one->id));
  return last;
}

}  // namespace skein::ground_station
