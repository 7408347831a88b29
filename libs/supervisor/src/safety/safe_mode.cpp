// SPDX-License-Identifier: Apache-2.0
#include "safety/safe_mode.hpp"

#include <algorithm>

namespace skein::supervisor {

namespace {

constexpr Duration kPause = Duration::milliseconds(5000);  // a longer one between tasks is said

}  // namespace

SafeMode::SafeMode(Duration horizon, const Beliefs& beliefs, const Agenda& agenda,
                   Committer& committer, Outbox& out, const Book& book)
    : horizon_(horizon),
      beliefs_(beliefs),
      agenda_(agenda),
      committer_(committer),
      out_(out),
      book_(book) {}

void SafeMode::begin() {
  forget_told();
  in_the_way_.reset();
}

void SafeMode::tell(const std::string& what) {
  if (!told_) out_.notice("in the air without a task" + what + why_idle());
  told_ = true;
}

// Nobody here knows what that one waits for. What begins in this instant is not in the way.
void SafeMode::tell_what_is_in_the_way() {
  const std::optional<TaskId> first = book_.in_the_way();
  if (first != in_the_way_) {
    in_the_way_ = first;
    in_the_way_since_ = now();
    told_in_the_way_ = false;
  }
  const auto at = tells_at();
  if (!at || now() < *at) return;
  told_in_the_way_ = true;
  const auto goal = std::find_if(book_.order.begin(), book_.order.end(), [&](GoalId id) {
    const Goal& one = book_.goals.at(id);
    return one.open() && !one.queued;
  });
  if (goal == book_.order.end()) return;
  out_.notice(book_.named(*goal) + " waits for task " + to_text(*first) + " (" +
              book_.loose.at(*first).type +
              "), which was given to its executive and may not begin yet");
}

std::optional<MissionTime> SafeMode::tells_at() const {
  const bool waits = in_the_way_.has_value() && !told_in_the_way_;
  return waits ? std::optional(in_the_way_since_ + kPause) : std::nullopt;
}

void SafeMode::keep() {
  tell_what_is_in_the_way();
  if (const auto end = committer_.end_of_safe_wait(); end && *end <= now()) {
    committer_.stop_safe_waits();
  }
  const bool airborne = beliefs_.vehicle().airborne;
  if (!airborne || book_.has_occupation(now() + horizon_)) {
    const bool pauses = airborne && !book_.has_occupation(now() + kPause);
    return pauses ? tell(" for a moment: ") : forget_told();
  }
  if (!committer_.ever_gave()) return tell(": ");
  if (book_.stops_landing()) return tell(" until it has stopped landing: ");
  if (pauses()) return tell(": its safe wait was refused or aborted; ");
  hurry();
  const TaskId id = committer_.start_safe_wait();
  out_.notice("in the air with nothing to do: waits in safe mode, task " + to_text(id) + "; " +
              why_idle());
}

// What is being decided on, and what waits for that; else what became of its last goal.
std::string SafeMode::why_idle() const {
  const auto decides = what_is_decided();
  const Goal* last = nullptr;
  for (const GoalId id : book_.order) {
    const Goal& goal = book_.goals.at(id);
    if (goal.open() && decides) return *decides + "; until then " + book_.named(id) + " waits";
    if (goal.open()) return book_.named(id) + " waits: nothing of it may begin " + begins_from(id);
    if (last == nullptr || goal.settled >= last->settled) last = &goal;
  }
  if (decides) return *decides;
  if (last == nullptr) return "no mission was given to it";
  const std::string why = last->why.empty() ? "" : " (" + last->why + ")";
  return "nothing follows " + book_.named(last->task.id) + ", " +
         std::string(to_text(last->state)) + why;
}

std::optional<std::string> SafeMode::what_is_decided() const {
  if (agenda_.needed()) return "its plan is to be repaired: " + agenda_.needed()->cause;
  if (agenda_.job() && !agenda_.job()->mission)
    return "its plan is being repaired: " + agenda_.job()->need.cause;
  if (agenda_.job()) return "mission " + to_text(*agenda_.job()->mission) + " is being planned";
  if (!agenda_.pending().empty())
    return "mission " + to_text(agenda_.pending().front().id) + " is to be planned";
  return std::nullopt;
}

// "before 180 s", or "yet".
std::string SafeMode::begins_from(GoalId id) const {
  MissionTime first = MissionTime::max();
  for (const Entry* entry : book_.of(id)) {
    if (!entry->over()) first = std::min(first, entry->dates.earliest_start);
  }
  const bool dated = first > now() && first != MissionTime::max() && !committer_.is_undated(id);
  return dated ? "before " + to_text(first) + " s" : "yet";
}

}  // namespace skein::supervisor
