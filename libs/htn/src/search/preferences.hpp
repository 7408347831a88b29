// SPDX-License-Identifier: Apache-2.0
// Preferred choices from an earlier plan, minus those that the search has already used.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "skein/htn/planner.hpp"

namespace skein::htn {

/// Each preference is used at most once along a path of the search, so that recursive tasks
/// terminate as they would without preferences.
class Preferences {
 public:
  Preferences(const std::vector<Preference>& preferences, const TermStore& store);

  bool empty() const { return groups_.empty(); }
  /// The next preference for this task; for a task with variables that of any instance. Null: none
  /// left.
  const Preference* find(Term task) const;
  /// Uses up the next preference of the task.
  void use(Term task);

  using Mark = std::uint32_t;
  Mark mark() const { return static_cast<Mark>(trail_.size()); }
  void undo(Mark mark);

  /// Whether a branch with these leaves is the preferred one. Unbound variables match anything,
  /// since the earlier plan may have bound them later.
  bool agrees(const Preference& preference, std::span<const Term> leaves) const;

 private:
  struct Group {  // of one task
    Term task;
    std::vector<const Preference*> all;
    std::uint32_t used = 0;
  };
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::uint32_t group_of(Term task) const;
  bool agree(Term left, Term right) const;

  const TermStore& store_;
  std::vector<Group> groups_;
  std::unordered_map<Term, std::uint32_t> group_of_task_;
  std::unordered_map<Term, std::vector<std::uint32_t>> groups_of_name_;
  std::vector<std::uint32_t> trail_;
};

}  // namespace skein::htn
