// SPDX-License-Identifier: Apache-2.0
#include "schedule/dates.hpp"

#include <algorithm>
#include <array>

#include "skein/foundation/rounded_seconds.hpp"
#include "skein/functional/task_types.hpp"

namespace skein::supervisor {

namespace {

constexpr Duration kTick = Duration::milliseconds(1);
using Reliance = Meetings::Reliance;
/// From the least on.
constexpr std::array kReliances{Reliance::kOnNothing, Reliance::kOnTheirBest,
                                Reliance::kNobodysNeeds};

}  // namespace

// ---- the network ----

// What others may do to the plan breaks it only when it is certain.
void Dates::update(MissionTime now) {
  std::string risk = rely(open_views(), Reliance::kNobodysNeeds, now);
  risk_ = controllable() ? std::move(risk) : "";
  for (const auto& [id, window] : schedule().dates) {
    Entry& entry = book_.tasks.at(id);
    entry.window = window;
    entry.dates = schedule().foreseen.at(id);
  }
}

bool Dates::fits(const mission::ElementaryPlan& plan, const std::set<TaskId>& withdrawn,
                 MissionTime now) {
  std::vector<TaskView> views;
  for (const TaskId id : book_.in_hand()) {
    const Entry& entry = book_.tasks.at(id);
    if (withdrawn.count(id) == 0) views.push_back({&entry.task, entry.seen});
  }
  for (const mission::ElementaryTask& task : plan.tasks) views.push_back({&task, {}});
  std::sort(views.begin(), views.end(),
            [](const TaskView& a, const TaskView& b) { return a.task->id < b.task->id; });
  // Nobody's need that is kept to is given up for it.
  rely(std::move(views), std::max(book_.meetings.reliance, Reliance::kOnTheirBest), now);
  return controllable();
}

// Returns what breaks without any of it.
std::string Dates::rely(std::vector<TaskView> views, Reliance most, MissionTime now) {
  ++version_;
  std::string broken;
  for (const Reliance reliance : kReliances) {
    book_.meetings.reliance = reliance;
    relate(views, book_.bounds());
    network_.update(views, now);
    if (controllable() || book_.meetings.of.empty() || reliance == most) break;
    const std::vector<Conflict>& conflicts = schedule().conflicts;
    if (broken.empty() && !conflicts.empty())
      broken = "task " + to_text(conflicts.front().task) + " " + conflicts.front().why;
  }
  return broken;
}

std::string Dates::extent() const {
  const std::string first = in_seconds(schedule().earliest_end);
  if (schedule().latest_end == MissionTime::max()) return "ends from " + first + " on";
  return "ends between " + first + " and " + in_seconds(schedule().latest_end);
}

std::vector<TaskView> Dates::open_views() const {
  std::vector<TaskView> views;
  views.reserve(book_.tasks.size());
  for (const auto& [id, entry] : book_.tasks) {
    if (book_.counts(entry)) views.push_back({&entry.task, entry.seen});
  }
  return views;
}

std::vector<Hold> Dates::holds_of(TaskId task) const {
  std::vector<Hold> result;
  const auto found = schedule().holds.find(task);
  if (found == schedule().holds.end()) return result;
  for (const Hold& hold : found->second) {
    const Entry* on = book_.find(hold.on);
    const bool nameable = hold.on == TaskId() || (on != nullptr && on->given());
    result.push_back(nameable ? hold : Hold{TaskId(), MissionTime::max()});
  }
  return result;
}

// It may start sooner, or later, than the executive was told: others come at other times.
bool Dates::is_wider(const Entry& entry, MissionTime now) const {
  const mission::TimeConstraints& time = entry.task.time;
  const mission::TaskDates &told = entry.told_window, &window = entry.window;
  const bool sooner = (time.start_after || time.end_after) && told.earliest_start > now &&
                      window.earliest_start + grace_ < told.earliest_start;
  const bool later = (time.start_before || time.end_before) && !book_.is_due(entry) &&
                     told.latest_start != MissionTime::max() &&
                     told.latest_start + grace_ < window.latest_start;
  return sooner || later;
}

std::vector<TaskId> Dates::renew_holds(MissionTime now) {
  std::vector<TaskId> changed;
  if (!controllable()) return changed;
  const auto unmet = [&](std::vector<Hold> holds) {
    const auto met = [&](const Hold& hold) {
      const Entry* on = book_.find(hold.on);
      return hold.until <= now || (on != nullptr && on->over());
    };
    holds.erase(std::remove_if(holds.begin(), holds.end(), met), holds.end());
    return holds;
  };
  for (auto& [id, entry] : book_.tasks) {
    if (!entry.in_hand() || entry.seen.started || entry.by_others) continue;
    std::vector<Hold> holds = holds_of(id);
    if (unmet(holds) != unmet(entry.holds) || is_wider(entry, now)) changed.push_back(id);
    entry.holds = std::move(holds);
  }
  return changed;
}

// ---- others ----

temporal::Frontier Dates::frontier(bool all) const {
  std::map<TaskId, PlanMeeting> meetings;
  std::set<temporal::MeetingId> named;
  for (const auto& [id, entry] : book_.tasks) {
    if (!book_.counts(entry)) continue;
    const auto meeting = meeting_of(entry.task);
    if (meeting && named.insert(meeting->what.id).second) meetings.emplace(id, *meeting);
  }
  temporal::Frontier whole = network_.frontier(meetings, orders());
  return all && !fault_of(whole) ? whole : eliminated(whole);
}

// Of what it leaves nobody is told whose plan does not say when.
std::vector<PlanOrder> Dates::orders() const {
  std::vector<PlanOrder> result;
  const AirOrders& seen = book_.meetings.air;
  const auto counted = [&](const std::optional<TaskId>& id) {
    const Entry* entry = id ? book_.find(*id) : nullptr;
    return entry != nullptr && book_.counts(*entry);
  };
  if (counted(seen.waits) && !seen.for_others.empty())
    result.push_back(
        {*seen.waits, {temporal::order_of(seen.uav), seen.for_others, {seen.uav}}, true});
  const auto leaves = [&](const std::vector<std::string>& waiters, std::optional<TaskId> with) {
    for (const std::string& waiter : waiters)
      if (counted(with))
        result.push_back({*with, {temporal::order_of(waiter), {seen.uav}, {waiter}}});
  };
  leaves(seen.for_its_way, seen.flies);
  leaves(seen.for_its_place, next_motion());
  return result;
}

// The one that takes it away from where it stays.
std::optional<TaskId> Dates::next_motion() const {
  std::optional<TaskId> next;
  MissionTime at = MissionTime::max();
  for (const auto& [id, entry] : book_.tasks) {
    const bool waits = book_.meetings.air.waits == id;
    if (!book_.counts(entry) || entry.over() ||
        type_of(entry.task).motion != functional::Motion::kMoves)
      continue;
    if ((entry.seen.started && !waits) || entry.dates.earliest_start >= at) continue;
    next = id;
    at = entry.dates.earliest_start;
  }
  return next;
}

// ---- promises ----

void Dates::promise() {
  for (auto& [id, entry] : book_.tasks) {
    if (!book_.counts(entry)) continue;
    entry.promised = entry.dates;
    if (entry.told == Tardiness::kLate) entry.told = Tardiness::kInTime;
  }
}

bool Dates::keeps_promises(Duration tolerance) const {
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

// ---- what should have been seen by now ----

// Of a meeting, when the last of the others comes as they foresee it.
MissionTime Dates::end_foreseen(const Entry& entry) const {
  if (book_.meetings.air.waits == entry.task.id) {
    const auto known = book_.meetings.of.find(temporal::order_of(book_.meetings.air.uav));
    const bool dated = known != book_.meetings.of.end() && !known->second.last.empty();
    if (dated && entry.task.duration.most != Duration::max())
      return is_never(known->second.slowest) ? MissionTime::max()
                                             : known->second.slowest + entry.task.duration.most;
  }
  if (const auto& meets = entry.task.synchronisation) {
    const auto known = book_.meetings.of.find(meets->id);
    if (known != book_.meetings.of.end() && !known->second.last.empty())
      return std::max(known->second.slowest, *entry.seen.started + entry.task.duration.most);
  }
  if (entry.task.duration.most == Duration::max()) return MissionTime::max();
  return *entry.seen.started + entry.task.duration.most;
}

bool Dates::is_overdue(const Entry& entry, MissionTime now) const {
  if (ends_by_order(entry.task) || !entry.under_way() || entry.told == Tardiness::kOverdue)
    return false;
  const MissionTime end = end_foreseen(entry);
  return end != MissionTime::max() && now >= end + grace_;
}

// When a task that has not started should have: what was foreseen, or the network, says so.
MissionTime Dates::late_from(const Entry& entry) const {
  return std::min(entry.dates.latest_start + grace_, entry.window.latest_start + kTick);
}

bool Dates::is_late(const Entry& entry, MissionTime now) const {
  return book_.counts(entry) && !entry.seen.started && entry.told != Tardiness::kLate &&
         now >= late_from(entry);
}

Dates::Slips Dates::slips(MissionTime now) {
  Slips result;
  const auto add = [&](TaskId id, const char* what, MissionTime expected) {
    result.what += (result.what.empty() ? "task " : "; task ") + to_text(id) + what +
                   in_seconds(now - expected);
  };
  for (auto& [id, entry] : book_.tasks) {
    if (!is_overdue(entry, now)) continue;
    entry.told = Tardiness::kOverdue;
    add(id, " overdue by ", end_foreseen(entry));
  }
  const bool by_another = !result.what.empty();
  for (auto& [id, entry] : book_.tasks) {
    if (is_late(entry, now)) {
      entry.told = Tardiness::kLate;
      if (!by_another)
        add(id, " late by ", std::min(entry.dates.latest_start, entry.window.latest_start));
    }
    if (entry.told == Tardiness::kLate && !by_another) result.late.push_back(id);
  }
  return result;
}

void Dates::keep_told(const std::vector<TaskId>& late) {
  for (const TaskId id : late) book_.tasks.at(id).told = Tardiness::kLate;
}

std::optional<MissionTime> Dates::next_slip(MissionTime now) const {
  std::optional<MissionTime> next;
  const auto count = [&](MissionTime at) {
    if (at > now && at != MissionTime::max()) next = earliest(next, at);
  };
  for (const auto& [id, entry] : book_.tasks) {
    if (!book_.counts(entry)) continue;
    if (entry.seen.started && entry.told != Tardiness::kOverdue && !ends_by_order(entry.task)) {
      const MissionTime end = end_foreseen(entry);
      if (end != MissionTime::max()) count(end + grace_);
    }
    if (!entry.seen.started && entry.told != Tardiness::kLate) count(late_from(entry));
  }
  return next;
}

}  // namespace skein::supervisor
