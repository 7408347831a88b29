// SPDX-License-Identifier: Apache-2.0
#include "grant_load.hpp"

#include <algorithm>

#include "for_sale.hpp"

namespace skein::auction {

GrantLoad::GrantLoad(const Ledger& ledger, std::uint32_t ahead) : ledger_(ledger), ahead_(ahead) {
  for (const auto& [task, entry] : ledger_.entries)
    if (entry.stage == Stage::kGranted) add(entry);
}

void GrantLoad::add(const LedgerEntry& entry) {
  for (const MemberNumber owner : entry.owners)
    load_[owner] += entry.finished.contains(owner) ? 0 : 1;
  for (const LedgerEntry* then : followers(entry.task.number))
    for (const MemberNumber owner : then->owners) load_[owner] = std::max(load_[owner], ahead_);
}

std::uint32_t GrantLoad::of(MemberNumber member) const {
  const auto load = load_.find(member);
  return load == load_.end() ? 0 : load->second;
}

bool GrantLoad::any_full(const std::vector<MemberNumber>& members) const {
  return std::any_of(members.begin(), members.end(),
                     [this](MemberNumber member) { return of(member) >= ahead_; });
}

bool GrantLoad::may_be_followed(TaskNumber first, bool plans_count) const {
  for (const LedgerEntry* then : followers(first)) {
    const TaskNumber number = then->task.number;
    if (plans_count && then->stage == Stage::kForSale) return false;
    if (waits_for_more(number, first)) return false;
    for (const MemberNumber owner : then->owners) {
      if (of(owner) > 0) return false;
      if (plans_count && has_before(owner, number, first)) return false;
    }
  }
  return true;
}

// What is to begin within some time after this one ends.
std::vector<const LedgerEntry*> GrantLoad::followers(TaskNumber first) const {
  std::vector<const LedgerEntry*> found;
  for (const Precedence& one : ledger_.precedences) {
    if (one.first != first || !one.delay.bounds_above()) continue;
    const auto then = ledger_.entries.find(one.then);
    if (then == ledger_.entries.end()) continue;
    const Stage stage = then->second.stage;
    if (stage == Stage::kOwned || stage == Stage::kForSale) found.push_back(&then->second);
  }
  return found;
}

// It comes after something else, which may begin now and keeps nobody waiting itself: so two never
// wait for each other.
bool GrantLoad::waits_for_more(TaskNumber then, TaskNumber first) const {
  const auto is_open = [&](const Precedence& one) {
    if (one.then != then || one.first == first) return false;
    const auto other = ledger_.entries.find(one.first);
    if (other == ledger_.entries.end()) return false;
    const Stage stage = other->second.stage;
    return stage != Stage::kDone && stage != Stage::kUnsold && followers(one.first).empty() &&
           all_before_done(ledger_, other->second);
  };
  return std::any_of(ledger_.precedences.begin(), ledger_.precedences.end(), is_open);
}

// Something else that it owns comes before that in its route.
bool GrantLoad::has_before(MemberNumber member, TaskNumber then, TaskNumber first) const {
  const auto route = ledger_.routes.find(member);
  if (route == ledger_.routes.end()) return false;
  const auto until = std::find(route->second.begin(), route->second.end(), then);
  return std::any_of(route->second.begin(), until, [&](TaskNumber task) {
    const auto entry = ledger_.entries.find(task);
    if (task == first || entry == ledger_.entries.end()) return false;
    const auto& owners = entry->second.owners;
    return entry->second.stage == Stage::kOwned &&
           std::find(owners.begin(), owners.end(), member) != owners.end();
  });
}

}  // namespace skein::auction
