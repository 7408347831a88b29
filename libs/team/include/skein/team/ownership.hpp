// SPDX-License-Identifier: Apache-2.0
// Who has what, as people are told it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "skein/mission/high_level_task.hpp"
#include "skein/team/roster.hpp"

namespace skein::team {

/// "for-sale", "owned", "granted", "done", "unsold".
std::string_view to_text(auction::Stage stage);

/// One line of the team's book.
struct TaskStanding {
  mission::GoalId task;
  std::string statement;  ///< "perceive P1 20"
  auction::Stage stage = auction::Stage::kForSale;
  std::vector<std::string> owners;
  std::uint64_t sale = 0;
  std::string why;  ///< of the stage: bids, silence, who put it back and why
  bool operator==(const TaskStanding&) const = default;
};

/// Tells what of a ledger is not as it was told last.
class Ownership {
 public:
  explicit Ownership(Roster roster) : roster_(std::move(roster)) {}
  /// In the order of the tasks' numbers. Cost: the ledger, when its revision is another.
  std::vector<TaskStanding> news(const auction::Ledger& ledger);
  const std::map<mission::GoalId, TaskStanding>& known() const { return known_; }

 private:
  Roster roster_;
  std::uint64_t term_ = 0, revision_ = 0;
  std::map<mission::GoalId, TaskStanding> known_;
};

}  // namespace skein::team
