// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal/team_dates.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace skein::temporal {

namespace {

using Weight = Ticks FrontierArc::*;
/// What is said is heard later than it is said: two that wait for each other never go on.
constexpr Ticks kHeard = 1;
constexpr Weight kSoonest = &FrontierArc::soonest, kSlowest = &FrontierArc::slowest,
                 kLatest = &FrontierArc::latest;

bool is_in(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

MissionTime instant_of(Ticks date) {
  return date == kInfinite ? MissionTime::max() : MissionTime::nanoseconds(date);
}

/// Who waits for himself comes later with every round.
Ticks sum(Ticks a, Ticks b) { return std::clamp(a + b, -kLargest, kLargest); }

// A date that is no other in any course.
bool is_fact(const Frontier& frontier, std::uint32_t node) {
  Ticks soonest = kMinusInfinite, latest = kInfinite;
  for (const FrontierArc& arc : frontier.arcs) {
    if (arc.from == Frontier::kOrigin && arc.to == node) soonest = arc.soonest;
    if (arc.from == node && arc.to == Frontier::kOrigin && arc.latest != kMinusInfinite)
      latest = -arc.latest;
  }
  return soonest == latest;
}

/// All frontiers in one graph, in which who receives waits for who sends.
class Whole {
 public:
  Whole(const std::map<std::string, Frontier>& known,
        const std::map<std::string, MissionTime>& unheard_since) {
    for (const auto& [agent, frontier] : known) {
      first_[agent] = nodes_;
      nodes_ += static_cast<std::uint32_t>(2 * frontier.meetings.size());
    }
    for (const auto& [agent, frontier] : known) {
      const auto unheard = unheard_since.find(agent);
      const Ticks last_word = unheard == unheard_since.end() ? kInfinite : unheard->second.count();
      for (FrontierArc arc : frontier.arcs) {
        arc.from = node(agent, arc.from);
        arc.to = node(agent, arc.to);
        arcs_.push_back({arc, &agent, last_word});
      }
      for (std::size_t i = 0; i < frontier.meetings.size(); ++i) join(known, agent, i);
    }
  }

  std::uint32_t node(const std::string& agent, std::uint32_t local) const {
    return local < 2 ? local : first_.at(agent) + local - 2;
  }
  struct Awaited {
    const std::string* agent;
    std::uint32_t arrival;
    bool there;  ///< it has come
  };
  /// Who has to come before an end.
  const std::vector<Awaited>& awaited(std::uint32_t end) const {
    static const std::vector<Awaited> kNobody;
    const auto found = awaited_.find(end);
    return found == awaited_.end() ? kNobody : found->second;
  }

  /// Earliest dates of a course. Who waits for himself never comes.
  std::vector<Ticks> earliest(Weight weight, MissionTime now) const {
    std::vector<Ticks> date(nodes_, kMinusInfinite);
    date[Frontier::kOrigin] = 0;
    date[Frontier::kPresent] = now.count();
    std::vector<bool> changed;
    for (std::uint32_t round = 0; round < nodes_; ++round) {
      changed = revise(weight, date);
      if (std::find(changed.begin(), changed.end(), true) == changed.end()) return date;
    }
    for (std::uint32_t i = 2; i < nodes_; ++i)
      if (changed[i]) date[i] = kInfinite;
    // What follows from never.
    for (std::uint32_t round = 0; round < nodes_; ++round) {
      for (const Arc& one : arcs_)
        if (one.arc.*weight != kMinusInfinite && date[one.arc.from] == kInfinite && one.arc.to >= 2)
          date[one.arc.to] = kInfinite;
    }
    return date;
  }

  /// Of those who wait in the circles that pass through an end: who gives way, and how. There is
  /// always one who has a meeting before another of a smaller number, and whoever puts these in
  /// order brings no other two out of it: so it comes to an end.
  struct Yield {
    const std::string* agent = nullptr;
    MeetingId meeting = 0, behind = 0;
    bool there = false;  ///< at the former
    /// It gives way before the other.
    bool before(const Yield& other) const {
      if (there != other.there) return other.there;
      if (*agent != *other.agent) return *agent > *other.agent;
      return std::pair(meeting, behind) < std::pair(other.meeting, other.behind);
    }
  };
  std::optional<Yield> yield_at(std::uint32_t end,
                                const std::map<std::string, Frontier>& known) const {
    std::optional<Yield> chosen;
    const std::vector<bool> after = reached_from(end);
    if (!after[end]) return chosen;
    for (const auto& [agent, frontier] : known) {
      for (const FrontierArc& arc : frontier.arcs) {
        if (!goes_on(arc) || !after[node(agent, arc.from)]) continue;
        if (!reached_from(node(agent, arc.to))[end]) continue;
        const std::size_t meeting = (arc.from - 2) / 2, behind = (arc.to - 2) / 2;
        const Yield one{&agent, frontier.meetings[meeting].id, frontier.meetings[behind].id,
                        is_fact(frontier, Frontier::arrival_of(meeting))};
        if (one.meeting > one.behind && (!chosen || one.before(*chosen))) chosen = one;
      }
    }
    return chosen;
  }

  struct Limit {
    Ticks latest = kInfinite;
    const std::string* of = nullptr;  ///< whose bound it is
  };
  /// Latest dates by what all but `self` bound from above, when all lasts longest.
  std::vector<Limit> latest(MissionTime now, const std::string& self) const {
    std::vector<Limit> limit(nodes_);
    limit[Frontier::kOrigin] = {0, nullptr};
    limit[Frontier::kPresent] = {now.count(), nullptr};
    std::vector<bool> changed;
    for (std::uint32_t round = 0; round < nodes_; ++round) {
      changed = revise(self, limit);
      if (std::find(changed.begin(), changed.end(), true) == changed.end()) return limit;
    }
    // The others contradict each other: what leads there is not for this one to mend.
    for (std::uint32_t round = 0; round < nodes_; ++round) {
      for (const Arc& one : arcs_)
        if (bounds(one, self) && changed[one.arc.to]) changed[one.arc.from] = true;
    }
    for (std::uint32_t i = 2; i < nodes_; ++i)
      if (changed[i]) limit[i] = {};
    return limit;
  }

 private:
  struct Arc {
    FrontierArc arc;
    const std::string* agent;     ///< whose; null: of a meeting
    Ticks last_word = kInfinite;  ///< of one that is not heard any more
  };

  void join(const std::map<std::string, Frontier>& known, const std::string& agent,
            std::size_t which) {
    const Meeting& meeting = known.at(agent).meetings[which];
    if (!is_in(meeting.receivers, agent)) return;
    const std::uint32_t end = node(agent, Frontier::end_of(which));
    for (const auto& [other, frontier] : known) {
      if (other == agent || !is_in(meeting.senders, other)) continue;
      for (std::size_t i = 0; i < frontier.meetings.size(); ++i) {
        if (frontier.meetings[i].id != meeting.id) continue;
        const std::uint32_t arrival = node(other, Frontier::arrival_of(i));
        arcs_.push_back({{arrival, end, kHeard, kHeard, kHeard}, nullptr});
        awaited_[end].push_back({&other, arrival, is_fact(frontier, Frontier::arrival_of(i))});
      }
    }
  }

  /// From the end of a meeting to another one.
  static bool goes_on(const FrontierArc& arc) {
    const bool from_end = arc.from >= 2 && arc.from % 2 == 1;
    const bool to_arrival = arc.to >= 2 && arc.to % 2 == 0;
    return from_end && to_arrival && arc.soonest != kMinusInfinite;
  }

  /// Itself only on a circle.
  std::vector<bool> reached_from(std::uint32_t start) const {
    std::vector<bool> reached(nodes_, false);
    std::vector<std::uint32_t> open = {start};
    while (!open.empty()) {
      const std::uint32_t node = open.back();
      open.pop_back();
      for (const Arc& one : arcs_) {
        if (one.arc.from != node || one.arc.soonest == kMinusInfinite || one.arc.to < 2) continue;
        if (!reached[one.arc.to]) open.push_back(one.arc.to);
        reached[one.arc.to] = true;
      }
    }
    return reached;
  }

  static bool bounds(const Arc& one, const std::string& self) {
    const bool own = one.agent != nullptr && *one.agent == self;
    return one.arc.*kLatest != kMinusInfinite && one.arc.from >= 2 && !own;
  }

  std::vector<bool> revise(const std::string& self, std::vector<Limit>& limit) const {
    std::vector<bool> changed(nodes_, false);
    for (const Arc& one : arcs_) {
      const FrontierArc& arc = one.arc;
      const Limit& after = limit[arc.to];
      if (!bounds(one, self) || after.latest == kInfinite) continue;
      const Ticks before = sum(after.latest, -(arc.*kLatest));
      if (before >= limit[arc.from].latest) continue;
      limit[arc.from] = {before, arc.to < 2 ? one.agent : after.of};
      changed[arc.from] = true;
    }
    return changed;
  }

  std::vector<bool> revise(Weight weight, std::vector<Ticks>& date) const {
    std::vector<bool> changed(nodes_, false);
    for (const Arc& one : arcs_) {
      const FrontierArc& arc = one.arc;
      if (arc.*weight == kMinusInfinite || date[arc.from] == kMinusInfinite || arc.to < 2) continue;
      const bool of_present = arc.from == Frontier::kPresent;
      const Ticks from = of_present ? std::min(date[arc.from], one.last_word) : date[arc.from];
      const bool never = arc.*weight == kInfinite || from == kInfinite;
      const Ticks least = never ? kInfinite : sum(from, arc.*weight);
      if (least <= date[arc.to]) continue;
      date[arc.to] = least;
      changed[arc.to] = true;
    }
    return changed;
  }

  std::uint32_t nodes_ = 2;
  std::map<std::string, std::uint32_t> first_;
  std::vector<Arc> arcs_;
  std::map<std::uint32_t, std::vector<Awaited>> awaited_;
};

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
  const std::map<std::string, Frontier> known = with_invitations(known_, self_);
  const auto own = known.find(self_);
  if (own->second.meetings.empty()) return result;
  const auto mine = known_.find(self_);
  const std::size_t planned = mine == known_.end() ? 0 : mine->second.meetings.size();
  const Whole whole(known, unheard_since_);
  const std::vector<Ticks> soonest = whole.earliest(kSoonest, now);
  const std::vector<Ticks> slowest = whole.earliest(kSlowest, now);
  const auto limits = whole.latest(now, self_);
  for (std::size_t i = 0; i < own->second.meetings.size(); ++i) {
    const Meeting& meeting = own->second.meetings[i];
    const auto& awaited = whole.awaited(whole.node(self_, Frontier::end_of(i)));
    const bool receives = is_in(meeting.receivers, self_);
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
    const auto yield = soonest[end] == kInfinite ? whole.yield_at(end, known) : std::nullopt;
    if (yield && *yield->agent == self_ && yield->meeting == meeting.id)
      dates.behind = yield->behind;
    const auto& limit = limits[whole.node(self_, Frontier::arrival_of(i))];
    const bool counted_on = i < planned;
    if (counted_on && limit.latest != kInfinite && limit.of != nullptr) {
      dates.needed = instant_of(limit.latest);
      dates.needed_by = *limit.of;
    }
    result[meeting.id] = dates;
  }
  return result;
}

}  // namespace skein::temporal
