// SPDX-License-Identifier: Apache-2.0
// What a member does of its own: it wants its next tasks, begins what it was granted, says what
// ended.
#include <algorithm>

#include "team_core.hpp"

namespace skein::auction {

bool TeamMember::Core::mine(const LedgerEntry& entry) const {
  return std::find(entry.owners.begin(), entry.owners.end(), setup_.self) != entry.owners.end();
}

// Under this sale, by this member.
bool TeamMember::Core::ended(const LedgerEntry& entry) const {
  return has_ended({entry.task.number, entry.sale});
}

bool TeamMember::Core::has_ended(const Claim& claim) const {
  const auto is = [&](const std::map<TaskNumber, std::uint64_t>& marks) {
    const auto mark = marks.find(claim.task);
    return mark != marks.end() && mark->second >= claim.sale;
  };
  return is(disk_.done) || is(disk_.stopped);
}

// The next of its route that wait for nothing; all of them when it has been idle for long, since
// routes that were sold in parts of the team may wait for each other.
std::vector<Claim> TeamMember::Core::wants() const {
  std::vector<Claim> wants;
  const auto route = ledger().routes.find(setup_.self);
  if (route == ledger().routes.end()) return wants;
  const bool stuck = idle_since_ && now_ - *idle_since_ > setup_.limits.lease;
  std::uint32_t ahead = 0;
  for (const TaskNumber task : route->second) {
    const auto found = ledger().entries.find(task);
    if (found == ledger().entries.end() || !mine(found->second) || ended(found->second)) continue;
    const LedgerEntry& entry = found->second;
    if (entry.stage != Stage::kOwned && entry.stage != Stage::kGranted) continue;
    if (!all_before_done(entry)) continue;
    if (ahead++ == setup_.limits.ahead && !stuck) break;
    if (entry.stage == Stage::kOwned) wants.push_back({task, entry.sale});
  }
  return wants;
}

bool TeamMember::Core::all_before_done(const LedgerEntry& entry) const {
  return std::none_of(ledger().precedences.begin(), ledger().precedences.end(), [&](const auto& p) {
    if (p.then != entry.task.number) return false;
    const auto first = ledger().entries.find(p.first);
    return first != ledger().entries.end() && first->second.stage != Stage::kDone;
  });
}

Status TeamMember::Core::status() const {
  Status status{disk_.term,     ledger().revision, wants(), {}, {},
                disk_.missions, declared_lost_,    bids_,   {}};
  for (const auto& [task, sale] : disk_.done) {
    const auto entry = ledger().entries.find(task);
    if (entry == ledger().entries.end() || entry->second.stage == Stage::kDone) continue;
    status.done.push_back({task, sale});
  }
  for (const auto& [task, sale] : disk_.stopped) {
    const auto entry = ledger().entries.find(task);
    if (entry == ledger().entries.end() || entry->second.sale != sale) continue;
    status.stopped.push_back({task, sale});
    const auto why = disk_.stopped_why.find(task);
    status.stopped_why.push_back(why == disk_.stopped_why.end() ? "" : why->second);
  }
  return status;
}

void TeamMember::Core::put_back(const TaskPutBack& back) {
  const auto entry = ledger().entries.find(back.task);
  if (entry == ledger().entries.end() || !mine(entry->second)) return;
  disk_.stopped[back.task] = entry->second.sale;
  disk_.stopped_why[back.task] = back.why;
  if (running_ && running_->task == back.task) running_.reset();
  store();
}

// A joint task that a partner gave up cannot be done any more.
void TeamMember::Core::give_up_claims() {
  for (const auto& [task, entry] : ledger().entries) {
    if (entry.stopped.empty() || !mine(entry) || ended(entry)) continue;
    if (running_ && running_->task == task) continue;  // it ends by itself
    disk_.stopped[task] = entry.sale;
    disk_.stopped_why[task] = "a partner gave it up";
    store();
  }
}

// What it was granted first, by a ledger that a majority has: partners begin in the same order.
void TeamMember::Core::work() {
  if (running_) return;
  const LedgerEntry* next = nullptr;
  for (const auto& [task, entry] : ledger().entries) {
    if (entry.stage != Stage::kGranted || !mine(entry) || ended(entry)) continue;
    if (ledger().term != disk_.term || entry.revision > committed_) continue;
    if (next == nullptr || entry.revision < next->revision) next = &entry;
  }
  if (next == nullptr) {
    if (!idle_since_) idle_since_ = now_;
    return;
  }
  idle_since_.reset();
  running_ = Claim{next->task.number, next->sale};
  disk_.started[running_->task] = running_->sale;
  store();
  effects_.emplace_back(BeginTask{*running_});
}

}  // namespace skein::auction
