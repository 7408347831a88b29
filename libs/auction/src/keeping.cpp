// SPDX-License-Identifier: Apache-2.0
// What the holder of the token does to the ledger.
#include <algorithm>
#include <utility>
#include <vector>

#include "for_sale.hpp"
#include "team_core.hpp"

namespace skein::auction {

namespace {

/// What its end gives bounds to.
std::vector<std::pair<TaskNumber, Delay>> bounded_after(const Ledger& ledger, TaskNumber first) {
  std::vector<std::pair<TaskNumber, Delay>> all;
  for (const Precedence& one : ledger.precedences)
    if (one.first == first && one.delay.bounds() && ledger.entries.contains(one.then))
      all.emplace_back(one.then, one.delay);
  return all;
}

}  // namespace

// The next revision; the one before stays as it was with whom has it.
Ledger& TeamMember::Core::draft() {
  auto next = std::make_shared<Ledger>(ledger());
  ++next->revision;
  next->term = disk_.term;
  disk_.ledger = next;
  changed_ = true;
  stored_ = true;
  return *next;
}

LedgerEntry& TeamMember::Core::change(TaskNumber task) {
  Ledger& next = draft();
  LedgerEntry& entry = next.entries.at(task);
  entry.revision = next.revision;
  return entry;
}

Status TeamMember::Core::status() const {
  // One of an earlier term with the same number is another.
  const std::uint64_t has = ledger().term == disk_.term ? ledger().revision : 0;
  Status status{disk_.term, has, own_.wants(now_), {}, {}, {}, losses_, bids_, {}};
  for (const GivenMission& mission : disk_.missions)
    if (!ledger().missions.contains(mission.number)) status.missions.push_back(mission);
  for (const auto& [task, sale] : disk_.done) {
    const auto entry = ledger().entries.find(task);
    if (entry == ledger().entries.end() || entry->second.stage == Stage::kDone) continue;
    status.done.push_back({{task, own_.done_under(task).value_or(sale)}, disk_.done_at.at(task)});
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

void TeamMember::Core::keep_ledger() {
  take_status(setup_.self, status());
  for (const auto& [member, news] : followers_.take_news()) take_status(member, news);
  const MissionTime since = now_ - setup_.limits.patience - setup_.limits.patience;
  if (held_since_ < since && !majority(followers_.heard_since(since))) return follow();
  const std::set<MemberNumber> here = present();
  std::erase_if(took_part_, [&](MemberNumber member) { return !here.contains(member); });
  resell();
  if (!sale_) grant();
  if (sale_) {
    if (const auto due = sale_->auctioneer.next_wakeup(); due && now_ >= *due) {
      take(sale_->auctioneer.tick(now_));
    }
  }
  if (!sale_) sell();
  commit();
  if (changed_ || now_ >= beat_at_) beat();
  changed_ = false;
}

void TeamMember::Core::take_status(MemberNumber member, const Status& status) {
  for (const GivenMission& mission : status.missions) admit(mission);
  if (Losses losses = ledger().losses; losses.learn(status.losses)) draft().losses = losses;
  end_claims(member, status);
  wants_[member] = status.wants;
}

// A mission given twice is one; so is a task.
void TeamMember::Core::admit(const GivenMission& mission) {
  if (ledger().missions.contains(mission.number)) return;
  Ledger& next = draft();
  next.missions.insert(mission.number);
  Lot alone = mission.lot;  // what it comes after may have been given before
  std::erase_if(alone.precedences,
                [&](const Precedence& p) { return ledger().entries.contains(p.first); });
  if (auto wrong = contradictions(alone); !wrong.empty()) {
    effects_.emplace_back(SaleTold{Rejected{std::move(wrong)}});
    return;
  }
  const auto bound = [&](Task& then) {
    for (const Precedence& one : mission.lot.precedences) {
      const auto first = next.entries.find(one.first);
      const bool is_done = first != next.entries.end() && first->second.stage == Stage::kDone;
      if (one.then == then.number && one.delay.bounds() && is_done)
        bound_start(then, one.delay, task_ends_.of(first->second, now_));
    }
  };
  for (const Task& task : mission.lot.tasks) {
    LedgerEntry entry;
    entry.task = task;
    bound(entry.task);
    entry.revision = next.revision;
    next.entries.emplace(task.number, std::move(entry));
  }
  next.precedences.insert(next.precedences.end(), mission.lot.precedences.begin(),
                          mission.lot.precedences.end());
}

namespace {

/// It was out of reach, and what it had been granted was sold again meanwhile: done is done.
bool is_done_by_former_owner(const LedgerEntry& entry, const Claim& claim) {
  const bool open = entry.stage == Stage::kOwned || entry.stage == Stage::kGranted;
  return open && claim.sale < entry.sale && entry.owners.size() == 1 && entry.finished.empty() &&
         entry.stopped.empty();
}

}  // namespace

void TeamMember::Core::end_claims(MemberNumber member, const Status& status) {
  const auto end = [&](const Claim& claim, std::set<MemberNumber> LedgerEntry::*where,
                       const std::string& why) {
    const auto found = ledger().entries.find(claim.task);
    if (found == ledger().entries.end()) return;
    const LedgerEntry& entry = found->second;
    const auto& owners = entry.owners;
    const bool is_owner = std::find(owners.begin(), owners.end(), member) != owners.end();
    const bool former =
        where == &LedgerEntry::finished && !is_owner && is_done_by_former_owner(entry, claim);
    if (!former && entry.sale != claim.sale) return;
    const bool open = entry.stage == Stage::kOwned || entry.stage == Stage::kGranted;
    if (!open || (!former && !is_owner)) return;
    if (entry.finished.contains(member) || entry.stopped.contains(member)) return;
    LedgerEntry& changed = change(claim.task);
    if (former) changed.owners = {member};
    (changed.*where).insert(member);
    settle(changed, why);
    if (changed.stage != Stage::kDone) return;
    const TaskEnd ended = task_ends_.of(changed, now_);
    for (const auto& [then, delay] : bounded_after(ledger(), claim.task))
      bound_start(change(then).task, delay, ended);
  };
  for (const DoneClaim& done : status.done) {
    task_ends_.said(member, done);
    end(done.claim, &LedgerEntry::finished, "");
  }
  for (std::size_t i = 0; i < status.stopped.size(); ++i) {
    const bool told = i < status.stopped_why.size() && !status.stopped_why[i].empty();
    end(status.stopped[i], &LedgerEntry::stopped, told ? ": " + status.stopped_why[i] : "");
  }
}

// Once all its owners have spoken: done, or for sale again.
void TeamMember::Core::settle(LedgerEntry& entry, const std::string& why) {
  if (entry.finished.size() + entry.stopped.size() < entry.owners.size() &&
      entry.stage == Stage::kGranted) {
    return;
  }
  if (entry.stopped.empty()) {
    entry.stage = Stage::kDone;
    entry.why = "done";
  } else {
    put_up(entry, "put back by " + names_.of(*entry.stopped.begin()) + why);
  }
}

// Everything before it is done, and all its owners want it.
bool TeamMember::Core::may_begin(const LedgerEntry& entry) const {
  const Claim claim{entry.task.number, entry.sale};
  for (const MemberNumber owner : entry.owners) {
    const auto wants = wants_.find(owner);
    if (wants == wants_.end()) return false;
    if (std::find(wants->second.begin(), wants->second.end(), claim) == wants->second.end()) {
      return false;
    }
  }
  return all_before_done(ledger(), entry);
}

// To nobody more than it may have ahead: two that wait for each other in their routes get one after
// the other.
void TeamMember::Core::grant() {
  kept_back_.forget_others_than_owned(ledger());
  GrantLoad load(ledger(), setup_.limits.ahead);
  std::vector<TaskNumber> granted;
  for (const auto& [task, entry] : ledger().entries) {
    if (entry.stage != Stage::kOwned || !entry.stopped.empty() || !may_begin(entry)) continue;
    if (load.any_full(entry.owners)) continue;
    if (!kept_back_.lets_go(entry, load, now_, setup_.limits.lease)) continue;
    load.add(entry);
    granted.push_back(task);
  }
  for (const TaskNumber task : granted) change(task).stage = Stage::kGranted;
}

// What silent members were not granted; what they were, if it may be done twice or they are lost.
void TeamMember::Core::resell() {
  std::vector<std::pair<TaskNumber, MemberNumber>> silent;
  for (const auto& [task, entry] : ledger().entries) {
    if (entry.stage != Stage::kOwned && entry.stage != Stage::kGranted) continue;
    for (const MemberNumber owner : entry.owners) {
      if (owner == setup_.self || entry.finished.contains(owner)) continue;
      const bool lost = ledger().losses.is_lost(owner);
      const bool may_run = entry.stage == Stage::kGranted && !entry.task.repeatable;
      const MissionTime heard =
          std::max(held_since_, followers_.heard(owner).value_or(held_since_));
      const bool late = now_ - heard > setup_.limits.lease;
      if (lost || (late && !may_run)) {
        silent.emplace_back(task, owner);
        break;
      }
    }
  }
  for (const auto& [task, owner] : silent) {
    put_up(change(task),
           names_.of(owner) + (ledger().losses.is_lost(owner) ? " was declared lost"
                                                              : " was silent beyond its lease"));
  }
}

}  // namespace skein::auction
