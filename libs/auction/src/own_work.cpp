// SPDX-License-Identifier: Apache-2.0
#include "own_work.hpp"

#include <algorithm>
#include <limits>

#include "for_sale.hpp"

namespace skein::auction {

bool OwnWork::mine(const LedgerEntry& entry) const {
  return std::find(entry.owners.begin(), entry.owners.end(), self_) != entry.owners.end();
}

bool OwnWork::ended(const LedgerEntry& entry) const {
  return has_ended({entry.task.number, entry.sale});
}

bool OwnWork::has_ended(const Claim& claim) const {
  const auto done = done_under(claim.task);
  const auto stopped = disk_.stopped.find(claim.task);
  return (done && *done >= claim.sale) ||
         (stopped != disk_.stopped.end() && stopped->second >= claim.sale);
}

// All of them when it has waited for long, since routes that were sold in parts of the team may
// wait for each other.
std::vector<Claim> OwnWork::wants(MissionTime now) const {
  const bool stuck = waits_since_ && now - *waits_since_ > limits_.lease;
  return next_of_route(stuck ? std::numeric_limits<std::uint32_t>::max() : limits_.ahead);
}

// Those of the next `most` of its route that wait for nothing and have no grant.
std::vector<Claim> OwnWork::next_of_route(std::uint32_t most) const {
  std::vector<Claim> wants;
  const auto route = ledger().routes.find(self_);
  if (route == ledger().routes.end()) return wants;
  std::uint32_t ahead = 0;
  for (const TaskNumber task : route->second) {
    const auto found = ledger().entries.find(task);
    if (found == ledger().entries.end() || !mine(found->second) || ended(found->second)) continue;
    const LedgerEntry& entry = found->second;
    if (entry.stage != Stage::kOwned && entry.stage != Stage::kGranted) continue;
    if (!all_before_done(ledger(), entry)) continue;
    if (ahead++ == most) break;
    if (entry.stage == Stage::kOwned) wants.push_back({task, entry.sale});
  }
  return wants;
}

std::optional<std::uint64_t> OwnWork::done_under(TaskNumber task) const {
  const auto done = disk_.done.find(task);
  if (done == disk_.done.end()) return std::nullopt;
  return std::max(done->second, sale_to_itself_alone(task));
}

// While it was silent, say: what it is at, or has done, is what it was sold again.
std::uint64_t OwnWork::sale_to_itself_alone(TaskNumber task) const {
  const auto found = ledger().entries.find(task);
  if (found == ledger().entries.end()) return 0;
  const LedgerEntry& entry = found->second;
  return entry.owners.size() == 1 && mine(entry) ? entry.sale : 0;
}

bool OwnWork::done(TaskNumber task, MissionTime now) {
  if (!running_ || running_->task != task) return false;
  disk_.done[task] = running_->sale;
  disk_.done_at[task] = now;
  running_.reset();
  return true;
}

bool OwnWork::put_back(const TaskPutBack& back) {
  const auto entry = ledger().entries.find(back.task);
  const bool owned = entry != ledger().entries.end() && mine(entry->second);
  const bool runs = running_ && running_->task == back.task;
  if (!owned && !runs) return false;
  disk_.stopped[back.task] = owned ? entry->second.sale : running_->sale;
  disk_.stopped_why[back.task] = back.why;
  if (runs) running_.reset();
  return true;
}

bool OwnWork::give_up_claims() {
  bool gives_up = false;
  for (const auto& [task, entry] : ledger().entries) {
    if (entry.stopped.empty() || !mine(entry) || ended(entry)) continue;
    if (running_ && running_->task == task) continue;  // it ends by itself
    disk_.stopped[task] = entry.sale;
    disk_.stopped_why[task] = "a partner gave it up";
    gives_up = true;
  }
  return gives_up;
}

std::optional<Claim> OwnWork::begin_next(std::uint64_t committed, MissionTime now) {
  if (running_) return std::nullopt;
  const LedgerEntry* next = nullptr;
  for (const auto& [task, entry] : ledger().entries) {
    if (entry.stage != Stage::kGranted || !mine(entry) || ended(entry)) continue;
    if (ledger().term != disk_.term || entry.revision > committed) continue;
    if (next == nullptr || entry.revision < next->revision) next = &entry;
  }
  if (next == nullptr) {
    if (next_of_route(limits_.ahead).empty())
      waits_since_.reset();
    else if (!waits_since_)
      waits_since_ = now;
    return std::nullopt;
  }
  waits_since_.reset();
  running_ = Claim{next->task.number, next->sale};
  disk_.started[running_->task] = running_->sale;
  return running_;
}

}  // namespace skein::auction
