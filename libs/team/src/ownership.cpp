// SPDX-License-Identifier: Apache-2.0
#include "skein/team/ownership.hpp"

#include "skein/team/global_mission.hpp"

namespace skein::team {

std::string_view to_text(auction::Stage stage) {
  switch (stage) {
    case auction::Stage::kForSale:
      return "for-sale";
    case auction::Stage::kOwned:
      return "owned";
    case auction::Stage::kGranted:
      return "granted";
    case auction::Stage::kDone:
      return "done";
    case auction::Stage::kUnsold:
      break;
  }
  return "unsold";
}

std::vector<TaskStanding> Ownership::news(const auction::Ledger& ledger) {
  std::vector<TaskStanding> news;
  if (ledger.term == term_ && ledger.revision == revision_) return news;
  term_ = ledger.term;
  revision_ = ledger.revision;
  for (const auto& [number, entry] : ledger.entries) {
    TaskStanding now;
    now.task = mission::GoalId(number.value());
    const Order* order = order_of(entry.task);
    if (order != nullptr) now.statement = to_text(order->task);
    now.stage = entry.stage;
    for (const auction::MemberNumber owner : entry.owners) {
      now.owners.push_back(roster_.name_of(owner));
    }
    now.sale = entry.sale;
    now.why = entry.why;
    const auto before = known_.find(now.task);
    if (before != known_.end() && before->second == now) continue;
    known_.insert_or_assign(now.task, now);
    news.push_back(std::move(now));
  }
  return news;
}

}  // namespace skein::team
