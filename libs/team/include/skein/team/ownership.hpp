// SPDX-License-Identifier: Apache-2.0
// The owners of the team's tasks, for people.
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

/// One entry of the team's ledger, for people.
struct TaskStanding {
  mission::GoalId task;
  std::string statement;  ///< "perceive P1 20"
  auction::Stage stage = auction::Stage::kForSale;
  std::vector<std::string> owners;
  std::uint64_t sale = 0;
  std::string why;  ///< reason of the stage: bids, silence, who put it back and why
  bool operator==(const TaskStanding&) const = default;
};

/// Reports the entries of a ledger that changed since the last call.
class Ownership {
 public:
  explicit Ownership(Roster roster) : roster_(std::move(roster)) {}
  /// The changed entries, by task number. Cost: O(ledger) if its revision changed, else constant.
  std::vector<TaskStanding> news(const auction::Ledger& ledger);
  const std::map<mission::GoalId, TaskStanding>& known() const { return known_; }

 private:
  Roster roster_;
  std::uint64_t term_ = 0, revision_ = 0;
  std::map<mission::GoalId, TaskStanding> known_;
};

}  // namespace skein::team
