// SPDX-License-Identifier: Apache-2.0
#include "for_sale.hpp"

#include <algorithm>
#include <limits>

#include "skein/auction/lateness.hpp"

namespace skein::auction {

bool all_before_done(const Ledger& ledger, const LedgerEntry& entry) {
  return std::none_of(ledger.precedences.begin(), ledger.precedences.end(), [&](const auto& p) {
    if (p.then != entry.task.number) return false;
    const auto first = ledger.entries.find(p.first);
    return first != ledger.entries.end() && first->second.stage != Stage::kDone;
  });
}

void put_up(LedgerEntry& entry, std::string why) {
  entry.stage = Stage::kForSale;
  entry.owners.clear();
  entry.finished.clear();
  entry.stopped.clear();
  entry.why = std::move(why);
}

void take_out(LedgerEntry& entry, std::string why) {
  put_up(entry, std::move(why));
  entry.stage = Stage::kUnsold;
}

Lot lot_for_sale(const Ledger& ledger, const std::set<MemberNumber>& here, MissionTime now) {
  Lot lot;
  for (const auto& [number, entry] : ledger.entries) {
    if (entry.stage == Stage::kDone || entry.stage == Stage::kUnsold) continue;
    const bool away = std::any_of(entry.owners.begin(), entry.owners.end(),
                                  [&](MemberNumber owner) { return !here.contains(owner); });
    if (away) continue;
    Task task = entry.task;
    task.earliest = std::max(0.0, task.earliest - now.to_seconds());
    task.deadline -= now.to_seconds();
    if (entry.stage == Stage::kGranted) task.deadline = std::numeric_limits<double>::infinity();
    lot.tasks.push_back(std::move(task));
  }
  const auto on_sale = [&](TaskNumber number) {
    return std::any_of(lot.tasks.begin(), lot.tasks.end(),
                       [&](const Task& task) { return task.number == number; });
  };
  for (const Precedence& p : ledger.precedences) {
    if (on_sale(p.first) && on_sale(p.then)) lot.precedences.push_back(p);
  }
  return lot;
}

Holding holding(const Ledger& ledger, const std::set<MemberNumber>& here, MemberNumber member) {
  Holding result{member, {}, 0};
  const auto route = ledger.routes.find(member);
  if (route == ledger.routes.end()) return result;
  for (const TaskNumber task : route->second) {
    const auto found = ledger.entries.find(task);
    if (found == ledger.entries.end()) continue;
    const LedgerEntry& entry = found->second;
    const auto& owners = entry.owners;
    if (std::find(owners.begin(), owners.end(), member) == owners.end()) continue;
    if (entry.stage != Stage::kOwned && entry.stage != Stage::kGranted) continue;
    const bool away = std::any_of(owners.begin(), owners.end(),
                                  [&](MemberNumber owner) { return !here.contains(owner); });
    if (away) continue;
    if (entry.stage == Stage::kOwned) {
      result.tasks.push_back(task);
      continue;
    }
    // What is granted is done first, whatever the route says, and the rest may still move.
    result.tasks.insert(result.tasks.begin() + result.fixed, task);
    ++result.fixed;
  }
  return result;
}

std::uint64_t newest_for_sale(const Ledger& ledger) {
  std::uint64_t newest = 0;
  for (const auto& [task, entry] : ledger.entries) {
    if (entry.stage == Stage::kForSale) newest = std::max(newest, entry.revision);
  }
  return newest;
}

std::vector<TaskNumber> newly_too_late(const Ledger& ledger, MissionTime now) {
  std::vector<TaskNumber> late;
  for (const auto& [task, entry] : ledger.entries) {
    const bool is_unsold = entry.stage == Stage::kUnsold;
    if ((!is_unsold && entry.stage != Stage::kForSale) || !is_too_late(entry.task, now)) continue;
    if (!is_unsold || entry.why != why_too_late(entry.task)) late.push_back(task);
  }
  return late;
}

std::vector<TaskNumber> unsold_in_time(const Ledger& ledger, MissionTime now) {
  std::vector<TaskNumber> unsold;
  for (const auto& [task, entry] : ledger.entries)
    if (entry.stage == Stage::kUnsold && !is_too_late(entry.task, now)) unsold.push_back(task);
  return unsold;
}

bool worth_selling(const Ledger& ledger, bool joined, bool again, MissionTime now) {
  if ((joined || again) && !unsold_in_time(ledger, now).empty()) return true;
  return std::any_of(ledger.entries.begin(), ledger.entries.end(), [&](const auto& each) {
    const Stage stage = each.second.stage;
    return stage == Stage::kForSale || (joined && stage == Stage::kOwned);
  });
}

}  // namespace skein::auction
