// SPDX-License-Identifier: Apache-2.0
// What the naive executive knows, and what that makes of formulas (spec 2.2), from scratch each
// time.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "skein/executive/task.hpp"

namespace skein::executive::testing {

class NaiveFacts {
 public:
  void task_is(TaskId id, TaskState state) { tasks_[id] = {state, false}; }
  /// The task is another executive's.
  void relinquish(TaskId id) { tasks_[id] = {TaskState::kAborted, true}; }
  void message(const std::string& text) { messages_.insert(text); }
  void time_is(MissionTime clock) { clock_ = clock; }
  MissionTime time() const { return clock_; }

  bool holds(const Formula& f) const {
    return std::all_of(f.begin(), f.end(), [&](const Clause& clause) {
      return std::any_of(clause.begin(), clause.end(), [&](const Literal& l) { return holds(l); });
    });
  }
  bool never(const Formula& f) const {
    return std::any_of(f.begin(), f.end(), [&](const Clause& clause) {
      return std::all_of(clause.begin(), clause.end(), [&](const Literal& l) {
        return hopeless(l) && l.modality == Modality::kMandatory;
      });
    });
  }
  bool exits(const Formula& f) const { return !f.empty() && holds(f); }
  bool names_only_known(TaskId self, const Formula& f) const {
    for (const Clause& clause : f) {
      for (const Literal& l : clause) {
        const auto* e = std::get_if<TaskInState>(&l.condition);
        if (e != nullptr && (e->task == self || tasks_.count(e->task) == 0)) return false;
      }
    }
    return true;
  }

  /// Precondition: names_only_known(). A relinquished task counts as aborted for ever to who names
  /// it, even if it comes back.
  Formula settled(Formula f) const {
    for (Clause& clause : f) {
      for (Literal& l : clause) {
        const auto* e = std::get_if<TaskInState>(&l.condition);
        if (e == nullptr || !tasks_.at(e->task).relinquished) continue;
        l.condition = TimeIs{MissionTime::nanoseconds(-1), e->state == TaskState::kAborted};
      }
    }
    return f;
  }

 private:
  struct Known {
    TaskState state = TaskState::kScheduled;
    bool relinquished = false;
  };

  static bool reachable(TaskState from, TaskState to) {
    static const std::map<TaskState, std::set<TaskState>> kNext = {
        {TaskState::kScheduled, {TaskState::kStarted, TaskState::kAborted}},
        {TaskState::kStarted,
         {TaskState::kRunning, TaskState::kAborting, TaskState::kEnded, TaskState::kAborted}},
        {TaskState::kRunning, {TaskState::kAborting, TaskState::kEnded, TaskState::kAborted}},
        {TaskState::kAborting, {TaskState::kAborted, TaskState::kEnded}},  // settles nothing yet
        {TaskState::kEnded, {}},
        {TaskState::kAborted, {}}};
    std::set<TaskState> seen;
    std::vector<TaskState> todo{from};
    while (!todo.empty()) {
      const TaskState one = todo.back();
      todo.pop_back();
      for (const TaskState next : kNext.at(one)) {
        if (seen.insert(next).second) todo.push_back(next);
      }
    }
    return seen.count(to) > 0;
  }
  bool satisfied(const Condition& c) const {
    if (const auto* e = std::get_if<TaskInState>(&c)) return tasks_.at(e->task).state == e->state;
    if (const auto* m = std::get_if<MessageReceived>(&c)) return messages_.count(m->message) > 0;
    const auto& t = std::get<TimeIs>(c);
    return t.passed == (clock_ >= t.instant);
  }
  bool can_become(const Condition& c) const {
    if (const auto* e = std::get_if<TaskInState>(&c)) {
      return reachable(tasks_.at(e->task).state, e->state);
    }
    if (std::get_if<MessageReceived>(&c) != nullptr) return true;
    const auto& t = std::get<TimeIs>(c);
    return t.passed || clock_ < t.instant;
  }
  bool true_for_ever(const Condition& c) const {
    if (!satisfied(c)) return false;
    if (const auto* e = std::get_if<TaskInState>(&c)) return is_terminal(e->state);
    if (std::get_if<MessageReceived>(&c) != nullptr) return true;
    return std::get<TimeIs>(c).passed;
  }
  bool hopeless(const Literal& l) const {
    if (l.negated) return true_for_ever(l.condition);
    return !satisfied(l.condition) && !can_become(l.condition);
  }
  bool holds(const Literal& l) const {
    if (hopeless(l)) return l.modality == Modality::kOptional;
    return satisfied(l.condition) != l.negated;
  }

  MissionTime clock_ = MissionTime::nanoseconds(-1);
  std::map<TaskId, Known> tasks_;
  std::set<std::string> messages_;
};

}  // namespace skein::executive::testing
