// SPDX-License-Identifier: Apache-2.0
#include "book/progress.hpp"

#include <algorithm>

#include "skein/refiners/flight.hpp"
#include "skein/world/segment.hpp"

namespace skein::supervisor {

namespace {

using mission::Progress;
using world::Vector3;

constexpr std::size_t kLookAhead = 3;  // way-points, some of which may lie within one step

struct Span {
  MissionTime from, until;
  Duration length() const { return until > from ? until - from : Duration(); }
};

/// While it ran; nothing when it never did, or when nobody saw its end.
std::optional<Span> ran(const Entry& entry, std::optional<MissionTime> until) {
  const auto from = entry.running ? entry.running : entry.seen.started;
  const auto over = entry.seen.over ? entry.seen.over : until;
  if (!from || !over || entry.unseen) return std::nullopt;
  return Span{*from, *over};
}

/// The time that a detection is to look for, the least of a range; nothing of other tasks.
std::optional<Duration> asked_of(const mission::HighLevelTask& task) {
  if (task.name != kDetection) return std::nullopt;
  for (const mission::Argument& argument : task.arguments) {
    if (const auto range = mission::duration_range_of(argument))
      return Duration::seconds(range->least);
    if (const auto* seconds = std::get_if<double>(&argument)) return Duration::seconds(*seconds);
  }
  return std::nullopt;
}

/// Of the way's length [0 to 1], as far as that way-point.
double part_until(const std::vector<Vector3>& way, std::size_t point) {
  const auto behind = way.begin() + static_cast<std::ptrdiff_t>(std::min(point + 1, way.size()));
  const double length = refiners::length_of(way);
  return length > 0 ? refiners::length_of({way.begin(), behind}) / length : 1;
}

class Account {
 public:
  Account(const Book& book, std::optional<MissionTime> until) : book_(book), until_(until) {}

  void add(const Entry& entry) {
    const auto span = ran(entry, until_);
    if (!span) return;
    const mission::ElementaryTask& task = entry.task;
    const executive::Parameter* device = task.parameters.find("device");
    if (device != nullptr) add_look(entry, *span, device->text);
    if (task.type == "wait") done.waited = done.waited + span->length();
    if (task.synchronisation && entry.done()) done.synchronised.insert(task.synchronisation->id);
    if (!task.way.empty() && entry.done()) done.reached.push_back(task.way.back());
  }

  Progress done;

 private:
  void add_look(const Entry& entry, Span span, const std::string& device) {
    if (const Entry* with = companion_of(book_, entry)) {
      const auto other = ran(*with, until_);
      if (!other) return;
      span = {std::max(span.from, other->from), std::min(span.until, other->until)};
    }
    const Entry* along = flown_along(book_, entry);
    const Duration looked =
        along == nullptr ? span.length() : in_view(entry, *along, span.length());
    if (looked > Duration()) done.looks.push_back({device, place_of(entry), looked});
    if (along == nullptr) return;
    const auto& way = along->task.way;
    const std::size_t passed = entry.done() ? way.size() : std::min(entry.passed, way.size());
    const auto rest = way.begin() + static_cast<std::ptrdiff_t>(passed);
    done.rest = Progress::Rest{device, {rest, way.end()}};
    leave_beyond(*along);
  }

  // A patrol is as long as it takes to have its zone in view for the time that was asked for: of a
  // part of it what was seen to be in view; of what nobody saw, that much in proportion. One that
  // lasts for longer than it may has waited in its course, for its air say, and has seen no more
  // by that.
  Duration in_view(const Entry& look, const Entry& patrol, Duration lasted) {
    const auto goal = book_.goals.find(patrol.task.origin);
    const auto asked = goal == book_.goals.end() ? std::nullopt : asked_of(goal->second.task);
    const double whole = patrol.task.duration.least.to_seconds();
    if (!asked || whole <= 0) return lasted;
    const bool waited = !patrol.done() && lasted > patrol.task.duration.most;
    const double most = waited ? part_until(patrol.task.way, look.passed + 1) : 1;
    const Duration unwatched = std::max(lasted - look.watched, Duration());
    const Duration flown = std::min(unwatched, Duration::seconds(most * whole));
    const double missing = std::max(asked->to_seconds() - viewed_.to_seconds(), 0.0);
    const double share = std::min(1.0, missing / whole);
    Duration viewed = look.viewed + Duration::seconds(share * flown.to_seconds());
    if (patrol.done()) viewed = std::max(viewed, std::min(lasted, Duration::seconds(missing)));
    viewed_ = viewed_ + viewed;
    return viewed;
  }

  // A part ends where its mapping goes on.
  void leave_beyond(const Entry& lanes) {
    const auto goal = book_.goals.find(lanes.task.origin);
    if (goal == book_.goals.end() || !whole_of(goal->second.task)) return;
    if (lanes.beyond.empty()) return done.rest.reset();
    auto& way = done.rest->way;
    way.insert(way.end(), lanes.beyond.begin() + (way.empty() ? 0 : 1), lanes.beyond.end());
  }

  Vector3 place_of(const Entry& entry) const {
    return done.reached.empty() ? entry.seen_at : done.reached.back();
  }

  const Book& book_;
  std::optional<MissionTime> until_;
  Duration viewed_;  ///< by its patrols so far
};

}  // namespace

Progress progress_of(const Book& book, GoalId goal, std::optional<MissionTime> until) {
  Account account(book, until);
  const std::vector<GoalId> parts = book.parts_of(goal);
  for (const auto& [id, entry] : book.tasks) {
    const GoalId origin = entry.task.origin;
    if (origin == goal || std::find(parts.begin(), parts.end(), origin) != parts.end())
      account.add(entry);
  }
  return std::move(account.done);
}

const Entry* companion_of(const Book& book, const Entry& entry) {
  for (const mission::Dependence& on : entry.task.dependences) {
    if (on.kind == mission::DependenceKind::kRunning) return book.find(on.task);
  }
  return nullptr;
}

Duration missed_beside(const Entry& look, const Entry& companion) {
  if (companion.seen.aborted || !companion.done() || companion.unseen || look.unseen)
    return Duration();
  const Duration whole = companion.task.duration.least;
  if (!look.running || !companion.running) return whole;
  if (companion.task.type != "wait") return Duration();
  const MissionTime over =
      std::min(look.seen.over.value_or(*look.running), companion.seen.over.value_or(*look.running));
  return std::max(Duration(), whole - (over - std::max(*look.running, *companion.running)));
}

const Entry* flown_along(const Book& book, const Entry& entry) {
  if (entry.task.parameters.find("device") == nullptr) return nullptr;
  const Entry* with = companion_of(book, entry);
  return with != nullptr && with->task.way.size() > 1 ? with : nullptr;
}

std::size_t passed_after(const std::vector<Vector3>& way, std::size_t passed, const Vector3& from,
                         const Vector3& to, double reach) {
  for (std::size_t next = passed + 1; next < way.size() && next <= passed + kLookAhead; ++next) {
    if (world::to_segment(way[next], from, to) > reach) continue;
    passed = next;
  }
  return passed;
}

}  // namespace skein::supervisor
