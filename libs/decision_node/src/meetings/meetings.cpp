// SPDX-License-Identifier: Apache-2.0
#include "meetings/meetings.hpp"

#include <algorithm>

#include "core.hpp"

namespace skein::decision_node {

namespace {

using temporal::Algorithm;
using temporal::PartnerDates;

/// Dates that differ by less are the same.
constexpr Duration kSame = Duration::milliseconds(1'000);
/// Who was to have come by now is looked for again.
constexpr Duration kAgain = Duration::milliseconds(5'000);
/// Who is in reach again and has said nothing new for so long has nothing new to say; with the
/// latency of the radio, plans are consistent again within a second.
constexpr Duration kSettles = Duration::milliseconds(900);
/// A circle of waits is one when it has stood so long: then one of them gives way.
constexpr Duration kStands = Duration::milliseconds(5'000);
/// When it still stands then nobody can, and the others never come.
constexpr Duration kNever = Duration::milliseconds(30'000);

/// Between two words to one other (DIP-L). What changed meanwhile comes as one: two words that
/// answer each other around a circle become one, and it ends.
constexpr Duration kPause = Duration::milliseconds(500);

bool has(const temporal::Frontier& plan, temporal::MeetingId meeting) {
  return std::ranges::any_of(plan.meetings,
                             [&](const temporal::Meeting& one) { return one.id == meeting; });
}

bool is_in_circle(const PartnerDates& dates) {
  return dates.behind || dates.soonest == MissionTime::max();
}

bool is_same(MissionTime a, MissionTime b) { return (a > b ? a - b : b - a) < kSame; }

bool is_same(const PartnerDates& a, const PartnerDates& b) {
  const bool needed =
      a.needed.has_value() == b.needed.has_value() && (!a.needed || is_same(*a.needed, *b.needed));
  return needed && a.all_there == b.all_there && a.last == b.last && a.needed_by == b.needed_by &&
         is_same(a.soonest, b.soonest) && is_same(a.slowest, b.slowest) && a.behind == b.behind;
}

}  // namespace

Meetings::Meetings(Core& core) : core_(core), team_(core.config().uav) {}

bool Meetings::keeps_to(Algorithm algorithm) const {
  return core_.config().consistency == algorithm;
}

void Meetings::said(const temporal::Frontier& frontier) {
  if (!core_.config().consistency) return;
  if (keeps_to(Algorithm::kCip)) core_.bus().emit(SendFrontier{"", frontier});
  if (tells_all()) {
    for (const std::string& other : met_) core_.bus().emit(SendFrontier{other, frontier});
    said_ = frontier;
  }
  team_.say(eliminated(frontier));
  look();
}

// Where the ground station says when others come, they are as far as it is.
void Meetings::contact(const Contact& contact) {
  if (!core_.config().consistency || contact.ground != keeps_to(Algorithm::kCip)) return;
  if (!contact.ground) {
    if (core_.config().others.contains(contact.peer)) reach(contact.peer, contact.reachable);
    return;
  }
  for (const std::string& other : core_.config().others.names()) reach(other, contact.reachable);
}

bool Meetings::tells_all() const {
  return keeps_to(Algorithm::kDipG) || keeps_to(Algorithm::kDipM);
}

void Meetings::reach(const std::string& peer, bool reachable) {
  if (reachable && met_.insert(peer).second && tells_all() && said_)
    core_.bus().emit(SendFrontier{peer, *said_});
  if (reachable)
    back_[peer] = core_.bus().now();
  else if (back_.erase(peer) == 0)
    team_.out_of_reach(peer, core_.bus().now());
  if (keeps_to(Algorithm::kDipL)) tell_dates();
}

void Meetings::hear(const FrontierTold& told) {
  if (!core_.config().consistency || told.by_ground != keeps_to(Algorithm::kCip)) return;
  const temporal::Frontier frontier =
      keeps_to(Algorithm::kDipG) ? eliminated(told.frontier) : told.frontier;
  const bool is_back = back_.erase(told.from) != 0;
  if (is_back) team_.out_of_reach(told.from, std::nullopt);
  const auto known = team_.known().find(told.from);
  const bool same = known != team_.known().end() && known->second == frontier;
  if (same && !is_back) return;
  if (known != team_.known().end()) note_dropped(told.from, known->second, frontier);
  team_.hear(told.from, frontier);
  look();
}

void Meetings::note_dropped(const std::string& uav, const temporal::Frontier& before,
                            const temporal::Frontier& after) {
  std::map<temporal::MeetingId, MissionTime>& dropped = dropped_[uav];
  for (const temporal::Meeting& one : before.meetings)
    if (!has(after, one.id)) dropped[one.id] = core_.bus().now();
  for (const temporal::Meeting& one : after.meetings) dropped.erase(one.id);
}

// Only who sends what it plans to all says what it does not plan. Who has never planned a meeting
// has said nothing.
std::optional<MissionTime> Meetings::stays_away_since(const std::string& uav,
                                                      temporal::MeetingId meeting) const {
  if (!keeps_to(Algorithm::kDipM) && !keeps_to(Algorithm::kDipG)) return std::nullopt;
  const auto known = team_.known().find(uav);
  if (known != team_.known().end() && has(known->second, meeting)) return std::nullopt;
  const auto dropped = dropped_.find(uav);
  if (dropped == dropped_.end()) return MissionTime();
  const auto since = dropped->second.find(meeting);
  return since == dropped->second.end() ? MissionTime() : since->second;
}

// To each what changed for it.
void Meetings::tell_dates() {
  const MissionTime now = core_.bus().now();
  for (const std::string& other : met_) {
    Told& last = words_[other];
    temporal::Frontier word = team_.bounds_for(other);
    last.more = word != last.word && last.at && now < *last.at + kPause;
    if (last.more || word == last.word) continue;
    last.word = word;
    last.at = now;
    core_.bus().emit(SendFrontier{other, std::move(word)});
  }
}

void Meetings::time_passes() {
  const auto at = next_wakeup();
  if (at && *at <= core_.bus().now()) look();
}

// What is foreseen of who is late moves with the present.
std::optional<MissionTime> Meetings::next_wakeup() const {
  std::optional<MissionTime> next;
  for (const auto& [meeting, dates] : told_) {
    if (dates.last.empty() || dates.all_there || dates.soonest == MissionTime::max()) continue;
    next = earliest(next, std::max(*looked_ + kAgain, dates.soonest));
  }
  for (const auto& [peer, since] : back_) next = earliest(next, since + kSettles);
  for (const auto& [peer, last] : words_)
    if (last.more) next = earliest(next, *last.at + kPause);
  for (const auto& [meeting, since] : circles_) {
    for (const Duration patience : {kStands, kNever})
      if (*looked_ < since + patience) next = earliest(next, since + patience);
  }
  return next;
}

// What is foreseen of others in a circle is nothing, as long as it may be parted.
void Meetings::let_circles_stand(Dates& dates) {
  const MissionTime now = core_.bus().now();
  std::erase_if(circles_, [&](const auto& one) {
    const auto known = dates.find(one.first);
    return known == dates.end() || !is_in_circle(known->second);
  });
  for (auto& [meeting, one] : dates) {
    if (!is_in_circle(one)) continue;
    const MissionTime since = circles_.emplace(meeting, now).first->second;
    if (now < since + kStands) one.behind.reset();
    if (one.soonest != MissionTime::max() || now >= since + kNever) continue;
    one.last.clear();
    one.soonest = one.slowest = MissionTime();
  }
}

void Meetings::look() {
  looked_ = core_.bus().now();
  std::erase_if(back_, [&](const auto& one) {
    if (*looked_ < one.second + kSettles) return false;
    team_.out_of_reach(one.first, std::nullopt);
    return true;
  });
  if (keeps_to(Algorithm::kDipL)) tell_dates();
  Dates dates = team_.dates(core_.bus().now());
  let_circles_stand(dates);
  const bool same = std::equal(dates.begin(), dates.end(), told_.begin(), told_.end(),
                               [](const auto& a, const auto& b) {
                                 return a.first == b.first && is_same(a.second, b.second);
                               });
  if (same) return;
  note(dates);
  told_ = std::move(dates);
  core_.deliberation().partners_seen({told_});
}

void Meetings::note(const Dates& dates) {
  for (const auto& [meeting, one] : dates) {
    const auto before = told_.find(meeting);
    if (before == told_.end() || !is_same(before->second, one))
      core_.bus().emit(MeetingNoted{meeting, one});
  }
  for (const auto& [meeting, one] : told_)
    if (dates.count(meeting) == 0) core_.bus().emit(MeetingNoted{meeting, std::nullopt});
}

}  // namespace skein::decision_node
