// SPDX-License-Identifier: Apache-2.0
#include "task_ends.hpp"

#include <algorithm>
#include <limits>

namespace skein::auction {

namespace {

bool owns(const LedgerEntry& entry, MemberNumber member) {
  return std::find(entry.owners.begin(), entry.owners.end(), member) != entry.owners.end();
}

// Something else that it owns comes before that in its route.
bool has_before(const Ledger& ledger, MemberNumber member, const LedgerEntry& then,
                TaskNumber first) {
  const auto route = ledger.routes.find(member);
  if (route == ledger.routes.end()) return false;
  const auto until = std::find(route->second.begin(), route->second.end(), then.task.number);
  return std::any_of(route->second.begin(), until, [&](TaskNumber task) {
    const auto entry = ledger.entries.find(task);
    return task != first && entry != ledger.entries.end() && entry->second.stage == Stage::kOwned &&
           owns(entry->second, member);
  });
}

}  // namespace

void TaskEnds::not_before(TaskNumber task, MissionTime at) {
  auto& after = ends_[task].after;
  after = std::max(after.value_or(at), at);
}

void TaskEnds::heard(MemberNumber member, MissionTime sent, const std::vector<Claim>& done) {
  const auto last = last_.find(member);
  for (const Claim& claim : done) {
    if (!said_.emplace(member, claim).second || last == last_.end()) continue;
    not_before(claim.task, std::min(last->second, sent));
  }
  MissionTime& newest = last_[member];
  newest = std::max(newest, sent);
}

void TaskEnds::ended(TaskNumber task, MissionTime now) { not_before(task, now); }

TaskEnds::End TaskEnds::of(TaskNumber task, MissionTime now) const {
  const auto known = ends_.find(task);
  if (known == ends_.end() || known->second.by == MissionTime())
    return {known == ends_.end() ? std::nullopt : known->second.after, now};
  return known->second;
}

void bound_start(Task& then, const Delay& delay, const TaskEnds::End& first) {
  then.earliest = std::max(then.earliest, first.by.to_seconds() + delay.least);
  if (!delay.bounds_above()) return;
  const double begun =
      first.after ? first.after->to_seconds() + delay.most : first.by.to_seconds() - 1;
  then.deadline = std::min(then.deadline, begun + then.duration);
}

std::vector<const LedgerEntry*> followers(const Ledger& ledger, TaskNumber first) {
  std::vector<const LedgerEntry*> found;
  for (const Precedence& one : ledger.precedences) {
    if (one.first != first || !one.delay.bounds_above()) continue;
    const auto then = ledger.entries.find(one.then);
    if (then != ledger.entries.end() && then->second.stage == Stage::kOwned)
      found.push_back(&then->second);
  }
  return found;
}

Load granted_load(const Ledger& ledger, std::uint32_t ahead) {
  Load load;
  for (const auto& [task, entry] : ledger.entries)
    if (entry.stage == Stage::kGranted) add_grant(load, ledger, entry, ahead);
  return load;
}

void add_grant(Load& load, const Ledger& ledger, const LedgerEntry& entry, std::uint32_t ahead) {
  for (const MemberNumber owner : entry.owners)
    load[owner] += entry.finished.contains(owner) ? 0 : 1;
  for (const LedgerEntry* then : followers(ledger, entry.task.number))
    for (const MemberNumber owner : then->owners) load[owner] = std::max(load[owner], ahead);
}

bool may_be_followed(const Ledger& ledger, const LedgerEntry& first, const Load& load,
                     bool routes_count) {
  const TaskNumber number = first.task.number;
  const auto is_free = [&](const LedgerEntry* then, MemberNumber owner) {
    const auto has = load.find(owner);
    if (has != load.end() && has->second > 0) return false;
    return !routes_count || !has_before(ledger, owner, *then, number);
  };
  const auto all = followers(ledger, number);
  return std::all_of(all.begin(), all.end(), [&](const LedgerEntry* then) {
    return std::all_of(then->owners.begin(), then->owners.end(),
                       [&](MemberNumber owner) { return is_free(then, owner); });
  });
}

}  // namespace skein::auction
