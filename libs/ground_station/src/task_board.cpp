// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/task_board.hpp"

#include <iterator>

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

// Of the byte of a task that was let go.
constexpr std::uint8_t kTold = 0x3F, kAtGround = 0x40, kAborted = 0x80;

std::size_t bit_of(TaskState state) { return static_cast<std::size_t>(state); }

TaskOnBoard first_told(const TaskEventReceived& event, MissionTime now) {
  return {event.task, event.type, event.state, false, event.reason, now, event.at_ground};
}

}  // namespace

bool is_open(const TaskOnBoard& task) { return !task.lost && !executive::is_terminal(task.state); }

bool TaskBoard::learn(const TaskEventReceived& event, MissionTime now) {
  if (past_byte(event.task) != 0) return learn_of_past(event, now);
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
    if (over_.size() > most_kept_) let_go_of_oldest();
  }
}

void TaskBoard::let_go_of_oldest() {
  const auto oldest = std::prev(over_.end());
  const auto entry = entries_.find(oldest->id);
  past_of(oldest->id).set(oldest->id.value(), byte_of(entry->second));
  entries_.erase(entry);
  over_.erase(oldest);
}

// What was let go stays so, but for a lost task that is started anew.
bool TaskBoard::learn_of_past(const TaskEventReceived& event, MissionTime now) {
  Entry entry = from_byte(event.task, past_byte(event.task));
  ByteBook& past = past_of(event.task);
  if (entry.task.lost) {
    if (event.state != TaskState::kScheduled) return false;
    past.set(event.task.value(), 0);
    return learn(event, now);
  }
  const bool is_news = tell(entry, event, now);
  past.set(event.task.value(), byte_of(entry));
  return is_news;
}

// Of a task that is not open: the states told, where it ran last, how it ended. One that was lost
// has no terminal state among those told.
std::uint8_t TaskBoard::byte_of(const Entry& entry) {
  auto byte = static_cast<std::uint8_t>(entry.told.to_ulong());
  if (entry.task.at_ground) byte |= kAtGround;
  if (entry.task.state == TaskState::kAborted) byte |= kAborted;
  return byte;
}

TaskBoard::Entry TaskBoard::from_byte(TaskId id, std::uint8_t byte) {
  Entry entry;
  entry.task.id = id;
  entry.told = byte & kTold;
  entry.task.at_ground = (byte & kAtGround) != 0;
  entry.task.lost =
      !entry.told.test(bit_of(TaskState::kEnded)) && !entry.told.test(bit_of(TaskState::kAborted));
  if (!entry.task.lost) {
    entry.task.state = (byte & kAborted) != 0 ? TaskState::kAborted : TaskState::kEnded;
    return entry;
  }
  for (const TaskState state : {TaskState::kStarted, TaskState::kRunning, TaskState::kAborting})
    if (entry.told.test(bit_of(state))) entry.task.state = state;
  return entry;
}

ByteBook& TaskBoard::past_of(TaskId id) {
  return id < executive::kFirstBackgroundId ? past_ : past_routine_;
}

std::uint8_t TaskBoard::past_byte(TaskId id) const {
  return (id < executive::kFirstBackgroundId ? past_ : past_routine_).of(id.value());
}

std::vector<TaskId> TaskBoard::lose() {
  const auto routine = entries_.lower_bound(executive::kFirstBackgroundId);
  for (auto one = routine; one != entries_.end(); ++one) {
    open_.erase(one->first);
    over_.erase({one->second.task.since, one->first});
  }
  entries_.erase(routine, entries_.end());
  past_routine_.clear();
  const std::vector<TaskId> lost(open_.begin(), open_.end());
  for (const TaskId id : lost) {
    TaskOnBoard& task = entries_.at(id).task;
    task.lost = true;
    file(task);
  }
  return lost;
}

std::optional<TaskOnBoard> TaskBoard::find(TaskId id) const {
  if (const TaskOnBoard* task = kept(id)) return *task;
  const std::uint8_t past = past_byte(id);
  if (past == 0) return std::nullopt;
  return from_byte(id, past).task;
}

const TaskOnBoard* TaskBoard::kept(TaskId id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : &found->second.task;
}

bool TaskBoard::has_told(TaskId id, TaskState state) const {
  const auto found = entries_.find(id);
  if (found != entries_.end())
    return !found->second.task.lost && found->second.told.test(bit_of(state));
  const std::uint8_t past = past_byte(id);
  if (past == 0) return false;
  const Entry entry = from_byte(id, past);
  return !entry.task.lost && entry.told.test(bit_of(state));
}

std::vector<const TaskOnBoard*> TaskBoard::last_over(std::size_t count) const {
  std::vector<const TaskOnBoard*> last;
  for (auto one = over_.begin(); one != over_.end() && last.size() < count; ++one)
    last.push_back(kept(one->id));
  return last;
}

}  // namespace skein::ground_station
