// SPDX-License-Identifier: Apache-2.0
// What is seen moves the dates of the plan: absorbed, shifted, or a contingency.
#include <algorithm>

#include "core.hpp"
#include "skein/foundation/rounded_seconds.hpp"
#include "skein/supervisor/commitment.hpp"

namespace skein::supervisor {

namespace {

constexpr Duration kTick = Duration::milliseconds(1);

}  // namespace

void Supervisor::Core::reschedule() {
  network_.update(open_views(), now_);
  for (const auto& [id, window] : schedule().dates) {
    Entry& entry = book_.tasks.at(id);
    entry.window = window;
    entry.dates = schedule().foreseen.at(id);
  }
  tell_holds();
}

std::vector<TaskView> Supervisor::Core::open_views() const {
  std::vector<TaskView> views;
  views.reserve(book_.tasks.size());
  for (const auto& [id, entry] : book_.tasks) {
    if (book_.counts(entry)) views.push_back({&entry.task, entry.seen});
  }
  relate(views, book_.bounds());
  return views;
}

std::vector<Hold> Supervisor::Core::holds_of(TaskId task) const {
  std::vector<Hold> result;
  const auto found = schedule().holds.find(task);
  if (found == schedule().holds.end()) return result;
  for (const Hold& hold : found->second) {
    const Entry* on = book_.find(hold.on);
    const bool nameable = hold.on == TaskId() || (on != nullptr && on->given);
    result.push_back(nameable ? hold : Hold{TaskId(), MissionTime::max()});
  }
  return result;
}

// What the executive has and has not started is held back as the network says now. It is not told
// of what holds nothing back any more: it may be starting the task at this very instant.
void Supervisor::Core::tell_holds() {
  if (!schedule().controllable) return;
  const auto unmet = [&](std::vector<Hold> holds) {
    const auto met = [&](const Hold& hold) {
      const Entry* on = book_.find(hold.on);
      return hold.until <= now_ || (on != nullptr && on->over());
    };
    holds.erase(std::remove_if(holds.begin(), holds.end(), met), holds.end());
    return holds;
  };
  for (auto& [id, entry] : book_.tasks) {
    if (!entry.in_hand() || entry.seen.started || entry.by_others) continue;
    std::vector<Hold> holds = holds_of(id);
    const bool same = unmet(holds) == unmet(entry.holds);
    entry.holds = std::move(holds);
    if (same) continue;
    send_preconditions(entry);
  }
}

void Supervisor::Core::send_preconditions(const Entry& entry) {
  executive::Start start =
      to_start(as_given(entry.task), entry.window, book_.ending_by_order(), entry.holds);
  send(executive::UpdateConditions{entry.task.id, std::move(start.task.preconditions),
                                   std::nullopt});
}

void Supervisor::Core::promise() {
  for (auto& [id, entry] : book_.tasks) {
    if (!book_.counts(entry)) continue;
    entry.promised = entry.dates;
    entry.late = false;
  }
}

bool Supervisor::Core::keeps_promises(Duration tolerance) const {
  return std::all_of(book_.tasks.begin(), book_.tasks.end(), [&](const auto& one) {
    const Entry& entry = one.second;
    if (!book_.counts(entry)) return true;
    const mission::TaskDates &now = entry.dates, &then = entry.promised;
    const bool start =
        entry.seen.started || (now.earliest_start + tolerance >= then.earliest_start &&
                               now.latest_start <= then.latest_start + tolerance);
    return start && now.latest_end <= then.latest_end + tolerance;
  });
}

// The first two rungs. Source: spec 6.2 (6).
void Supervisor::Core::absorb_or_shift(const std::string& cause) {
  if (!schedule().controllable) return check_network(cause);
  if (keeps_promises(Duration())) {
    return decide({"6 repair: absorb", cause, plan_text(), "the promised dates hold", now_});
  }
  promise();
  decide({"6 repair: shift", cause, plan_text(), extent(), now_});
}

// The dates after something was seen; what breaks the network is a contingency.
void Supervisor::Core::check_network(const std::string& cause) {
  reschedule();
  if (repairing()) return;
  if (schedule().controllable) {
    if (!keeps_promises(config_.grace)) absorb_or_shift(cause);
    return;
  }
  if (schedule().conflicts.empty()) return;
  const Conflict conflict = schedule().conflicts.front();
  const std::string what = cause + "; task " + to_text(conflict.task) + " " + conflict.why;
  if (const Entry* entry = book_.find(conflict.task); entry != nullptr) {
    fail_goal(entry->task.origin, what);
  }
}

// ---- what should have been seen by now ----

bool Supervisor::Core::is_overdue(const Entry& entry) const {
  const bool nature = !ends_by_order(entry.task) && entry.task.duration.most != Duration::max();
  return nature && entry.under_way() && !entry.overdue &&
         now_ >= *entry.seen.started + entry.task.duration.most + config_.grace;
}

// When a task that has not started should have: what was foreseen, or the network, says so.
MissionTime Supervisor::Core::late_from(const Entry& entry) const {
  return std::min(entry.dates.latest_start + config_.grace, entry.window.latest_start + kTick);
}

bool Supervisor::Core::is_late(const Entry& entry) const {
  return book_.counts(entry) && !entry.seen.started && !entry.late && now_ >= late_from(entry);
}

void Supervisor::Core::watch() {
  std::string cause;
  const auto add = [&](TaskId id, const char* what, MissionTime expected) {
    cause +=
        (cause.empty() ? "task " : "; task ") + to_text(id) + what + in_seconds(now_ - expected);
  };
  for (auto& [id, entry] : book_.tasks) {
    if (!is_overdue(entry)) continue;
    entry.overdue = true;
    add(id, " overdue by ", *entry.seen.started + entry.task.duration.most);
  }
  const bool by_another = !cause.empty();
  for (auto& [id, entry] : book_.tasks) {
    if (!is_late(entry)) continue;
    entry.late = true;
    if (!by_another)
      add(id, " late by ", std::min(entry.dates.latest_start, entry.window.latest_start));
  }
  if (cause.empty() || repairing()) return;
  std::vector<TaskId> told;
  for (const auto& [id, entry] : book_.tasks) {
    if (entry.late && !by_another) told.push_back(id);
  }
  reschedule();
  absorb_or_shift(cause);
  for (const TaskId id : told) book_.find(id)->late = true;
}

}  // namespace skein::supervisor
