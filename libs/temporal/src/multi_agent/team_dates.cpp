// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal/team_dates.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "multi_agent/team_graph.hpp"

namespace skein::temporal {

namespace {

constexpr Weight kSoonest = &FrontierArc::soonest, kSlowest = &FrontierArc::slowest;

MissionTime instant_of(Ticks date) {
  return date == kInfinite ? MissionTime::max() : MissionTime::nanoseconds(date);
}

std::size_t others_among(const std::vector<std::string>& senders, const std::string& self) {
  return senders.size() -
         static_cast<std::size_t>(std::count(senders.begin(), senders.end(), self));
}

// What others plan to do with this one and it does not plan yet is asked about too.
std::map<std::string, Frontier> with_invitations(std::map<std::string, Frontier> known,
                                                 const std::string& self) {
  Frontier& own = known[self];
  const auto is_planned = [&](MeetingId id) {
    return std::any_of(own.meetings.begin(), own.meetings.end(),
                       [&](const Meeting& one) { return one.id == id; });
  };
  for (const auto& [agent, frontier] : known) {
    if (agent == self) continue;
    for (const Meeting& one : frontier.meetings) {
      const bool invited = is_in(one.senders, self) || is_in(one.receivers, self);
      if (invited && !is_planned(one.id)) own.meetings.push_back(one);
    }
  }
  return known;
}

}  // namespace

std::map<MeetingId, PartnerDates> TeamDates::dates(MissionTime now) const {
  std::map<MeetingId, PartnerDates> result;
  const std::map<std::string, Frontier> known =
      with_invitations(without_inner_nodes(known_), self_);
  const auto own = known.find(self_);
  if (own->second.meetings.empty()) return result;
  const auto mine = known_.find(self_);
  const std::size_t planned = mine == known_.end() ? 0 : mine->second.meetings.size();
  const TeamGraph whole(known, unheard_since_, self_);
  const TeamGraph::Since since{0, now.count()};
  const std::vector<Ticks> soonest = whole.earliest(kSoonest, since);
  const std::vector<Ticks> slowest = whole.earliest(kSlowest, since);
  const auto limits = whole.latest(self_, since);
  std::map<MeetingId, MeetingId> gives_way;
  for (std::size_t i = 0; i < own->second.meetings.size(); ++i) {
    const Meeting& meeting = own->second.meetings[i];
    const auto& awaited = whole.awaited(whole.node(self_, Frontier::end_of(i)));
    const bool receives = is_in(meeting.receivers, self_);
    if (is_order(meeting.id) && (!receives || i >= planned)) continue;
    if (receives && awaited.size() < others_among(meeting.senders, self_)) continue;
    PartnerDates dates;
    dates.all_there = receives;
    for (const auto& [agent, arrival, there] : awaited) {
      const MissionTime first = instant_of(soonest[arrival]), last = instant_of(slowest[arrival]);
      if (dates.last.empty() || last > dates.slowest) dates.last = *agent;
      dates.soonest = std::max(dates.soonest, first);
      dates.slowest = std::max(dates.slowest, last);
      dates.all_there = dates.all_there && there;
    }
    const std::uint32_t end = whole.node(self_, Frontier::end_of(i));
    const auto yield = soonest[end] == kInfinite ? whole.yield_at(end) : std::nullopt;
    if (yield && *yield->agent == self_) gives_way.emplace(yield->meeting, yield->behind);
    const auto& limit = limits[whole.node(self_, Frontier::arrival_of(i))];
    const bool counted_on = i < planned;
    if (counted_on && limit.latest != kInfinite && limit.of != nullptr) {
      dates.needed = instant_of(limit.latest);
      dates.needed_by = *limit.of;
    }
    result[meeting.id] = dates;
  }
  // It may be a meeting that the others do not plan any more.
  for (const auto& [meeting, behind] : gives_way) result[meeting].behind = behind;
  return result;
}

}  // namespace skein::temporal
