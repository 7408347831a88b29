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
  const auto is = [&](const std::map<TaskNumber, std::uint64_t>& marks) {
    const auto mark = marks.find(entry.task.number);
    return mark != marks.end() && mark->second >= entry.sale;
  };
  return is(disk_.done) || is(disk_.stopped);
}

std::vector<Claim> TeamMember::Core::wants() const {
  std::vector<Claim> wants;
  const auto route = ledger().routes.find(setup_.self);
  if (route == ledger().routes.end()) return wants;
  std::uint32_t ahead = 0;
  for (const TaskNumber task : route->second) {
    const auto found = ledger().entries.find(task);
    if (found == ledger().entries.end() || !mine(found->second) || ended(found->second)) continue;
    if (found->second.stage != Stage::kOwned && found->second.stage != Stage::kGranted) continue;
    if (ahead++ == setup_.limits.ahead) break;
    if (found->second.stage == Stage::kOwned) wants.push_back({task, found->second.sale});
  }
  return wants;
}

Status TeamMember::Core::status() const {
  Status status{disk_.term, ledger().revision, wants(), {}, {}, disk_.missions, declared_lost_};
  for (const auto& [task, sale] : disk_.done) {
    const auto entry = ledger().entries.find(task);
    if (entry == ledger().entries.end() || entry->second.stage == Stage::kDone) continue;
    status.done.push_back({task, sale});
  }
  for (const auto& [task, sale] : disk_.stopped) {
    const auto entry = ledger().entries.find(task);
    if (entry == ledger().entries.end() || entry->second.sale != sale) continue;
    status.stopped.push_back({task, sale});
  }
  return status;
}

// A joint task that a partner gave up cannot be done any more.
void TeamMember::Core::give_up_claims() {
  for (const auto& [task, entry] : ledger().entries) {
    if (entry.stopped.empty() || !mine(entry) || ended(entry)) continue;
    if (running_ && running_->task == task) continue;  // it ends by itself
    disk_.stopped[task] = entry.sale;
    store();
  }
}

// The first of its route that it was granted, by a ledger that a majority has.
void TeamMember::Core::work() {
  if (running_) return;
  const auto route = ledger().routes.find(setup_.self);
  if (route == ledger().routes.end() || ledger().term != disk_.term) return;
  for (const TaskNumber task : route->second) {
    const auto found = ledger().entries.find(task);
    if (found == ledger().entries.end() || !mine(found->second) || ended(found->second)) continue;
    if (found->second.stage != Stage::kGranted || found->second.revision > committed_) continue;
    running_ = Claim{task, found->second.sale};
    disk_.started[task] = running_->sale;
    store();
    effects_.emplace_back(BeginTask{*running_});
    return;
  }
}

}  // namespace skein::auction
