// SPDX-License-Identifier: Apache-2.0
// What the executive tells at one input.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "plan.hpp"
#include "skein/executive/effect.hpp"

namespace skein::executive {

/// The effects of the present input in their order. While a joint task is under way its supervisor
/// hears of the events of all other tasks. Source: T III.2.4.
class Outbox {
 public:
  void add(Effect effect) { effects_.push_back(std::move(effect)); }
  void notice(std::string text) { add(Notice{std::move(text)}); }
  /// Absent `refusal`: accepted.
  void reply(RequestKind kind, std::optional<TaskId> id, const std::optional<std::string>& refusal);
  /// The task has entered its state.
  void event(const TaskRecord& task);
  /// The task, of which no event tells so, is not under way here any more.
  void let_go(TaskId task) { joint_.erase(task); }
  Effects take() { return std::exchange(effects_, {}); }

 private:
  Effects effects_;
  std::set<TaskId> joint_;  ///< joint tasks under way
};

}  // namespace skein::executive
