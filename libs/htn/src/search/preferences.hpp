// SPDX-License-Identifier: Apache-2.0
// What an earlier plan chose for its tasks, as far as the search has not used it up.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "skein/htn/planner.hpp"

namespace skein::htn {

/// Each preference serves one accomplishment along one path of the search, so that a task that
/// calls itself ends as it would without preferences.
class Preferences {
 public:
  Preferences(const std::vector<Preference>& preferences, const TermStore& store);

  bool empty() const { return groups_.empty(); }
  /// The next for this task; a task with variables takes that of any instance. Null: none left.
  const Preference* find(Term task) const;
  /// The task is being accomplished.
  void use(Term task);

  using Mark = std::uint32_t;
  Mark mark() const { return static_cast<Mark>(trail_.size()); }
  void undo(Mark mark);

  /// Whether a branch with these leaves is the one preferred. Variables agree with everything:
  /// what the earlier plan bound later counts as equal.
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
