// SPDX-License-Identifier: Apache-2.0
#include "testing/random_team.hpp"

#include <algorithm>

namespace skein::temporal::testing {

namespace {

using Weight = Ticks FrontierArc::*;
constexpr Ticks kNever = kInfinite;

bool is_in(const std::vector<std::string>& names, const std::string& name) {
  return std::count(names.begin(), names.end(), name) > 0;
}

/// Greatest distances between all nodes; on its diagonal more than nothing where a cycle asks for
/// more and more.
class Distances {
 public:
  explicit Distances(std::size_t nodes) : d_(nodes, std::vector<Ticks>(nodes, kMinusInfinite)) {}

  void add(std::size_t from, std::size_t to, Ticks weight) {
    d_[from][to] = std::max(d_[from][to], std::min(weight, kBound));
  }
  void close() {
    const std::size_t n = d_.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          if (d_[i][k] != kMinusInfinite && d_[k][j] != kMinusInfinite)
            d_[i][j] = std::max(d_[i][j], std::min(d_[i][k] + d_[k][j], kBound));
  }
  Ticks between(std::size_t from, std::size_t to) const {
    const Ticks direct = from == to ? std::max<Ticks>(d_[from][to], 0) : d_[from][to];
    for (std::size_t c = 0; c < d_.size(); ++c)
      if (d_[c][c] > 0 && reach(from, c) && reach(c, to)) return kNever;
    return direct > kBound / 2 ? kNever : direct;
  }

 private:
  static constexpr Ticks kBound = Ticks{1} << 58;
  bool reach(std::size_t from, std::size_t to) const {
    return from == to || d_[from][to] != kMinusInfinite;
  }
  std::vector<std::vector<Ticks>> d_;
};

}  // namespace

RandomTeam::RandomTeam(std::uint64_t seed, bool orders) : random_(seed) {
  const std::size_t agents = 2 + random_.below(3);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < agents; ++i) names.push_back(std::string("uav") + char('a' + i));
  const std::size_t meetings = 1 + random_.below(4);
  for (std::size_t i = 0; i < meetings; ++i) {
    Meeting meeting{500 + i, {}, {}};
    for (const std::string& name : names) {
      if (random_.below(4) != 0) meeting.senders.push_back(name);
      if (random_.below(4) != 0) meeting.receivers.push_back(name);
    }
    meetings_.push_back(meeting);
  }
  for (std::size_t i = 0; orders && i < names.size(); ++i) {
    Meeting order{order_of(names[i]), {}, {names[i]}};
    for (const std::string& name : names)
      if (name != names[i] && random_.below(3) == 0) order.senders.push_back(name);
    if (!order.senders.empty()) orders_.push_back(order);
  }
  for (const std::string& name : names) {
    plans_[name];
    heard_.emplace(name, TeamDates(name));
  }
}

std::vector<std::string> RandomTeam::agents() const {
  std::vector<std::string> names;
  for (const auto& [name, plan] : plans_) names.push_back(name);
  return names;
}

void RandomTeam::change() {
  now_ = now_ + Duration::nanoseconds(static_cast<std::int64_t>(random_.below(20)));
  for (auto& [name, plan] : plans_)
    if (plan.nodes == 0 || random_.below(2) == 0) plan = make_plan(name);
}

void RandomTeam::deliver() {
  for (auto& [to, dates] : heard_) {
    for (const auto& [from, plan] : plans_)
      from == to ? dates.say(frontier_of(plan)) : dates.hear(from, frontier_of(plan));
  }
}

// Meetings nearly in the order of their numbers, so that few wait for each other for ever.
RandomTeam::Plan RandomTeam::make_plan(const std::string& agent) {
  Plan plan;
  for (const Meeting& meeting : meetings_)
    if (random_.below(5) != 0) plan.meetings.push_back(meeting);
  if (plan.meetings.size() > 1 && random_.below(6) == 0)
    std::swap(plan.meetings.front(), plan.meetings.back());
  for (const Meeting& order : orders_) {
    if (!is_in(order.senders, agent) && !is_in(order.receivers, agent)) continue;
    const auto place = static_cast<std::ptrdiff_t>(random_.below(plan.meetings.size() + 1));
    if (random_.below(4) != 0) plan.meetings.insert(plan.meetings.begin() + place, order);
  }
  plan.nodes = Frontier::arrival_of(plan.meetings.size());
  std::uint32_t before = Frontier::kPresent;
  const auto lasts = [&](std::uint32_t from, std::uint32_t to, bool may_be_endless) {
    const Ticks least = 1 + static_cast<Ticks>(random_.below(30));
    const Ticks most = least + static_cast<Ticks>(random_.below(30));
    const bool endless = may_be_endless && random_.below(12) == 0;
    plan.links.push_back({from, to, least, endless ? kInfinite : most, endless ? least : most});
    if (!endless) plan.links.push_back({to, from, kMinusInfinite, kMinusInfinite, -most});
  };
  for (std::size_t i = 0; i < plan.meetings.size(); ++i) {
    const auto end = Frontier::end_of(i);
    for (std::size_t tasks = random_.below(3); tasks > 0; --tasks) {
      const auto start = static_cast<std::uint32_t>(plan.nodes++);
      const auto over = static_cast<std::uint32_t>(plan.nodes++);
      plan.links.push_back({before, start, 0, 0, 0});
      lasts(start, over, true);
      before = over;
    }
    take_part(plan, agent, i, before);
    if (before == end && random_.below(3) == 0)
      bound(plan, end, now_.count() + 100 + static_cast<Ticks>(random_.below(300)));
  }
  return plan;
}

// Who leaves others' air goes on; who waits for his may have another before, and goes on once the
// others have left at the latest.
void RandomTeam::take_part(Plan& plan, const std::string& agent, std::size_t meeting,
                           std::uint32_t& before) {
  const auto arrival = Frontier::arrival_of(meeting), end = Frontier::end_of(meeting);
  const Meeting& what = plan.meetings[meeting];
  plan.links.push_back({before, arrival, 0, 0, 0});
  if (!is_order(what.id)) {
    plan.links.push_back({arrival, end, 1, 1, 1});
    before = end;
  } else if (is_in(what.receivers, agent)) {
    const auto after = static_cast<std::uint32_t>(plan.nodes++);
    const auto flight = 1 + static_cast<Ticks>(random_.below(20));
    plan.links.push_back({before, after, flight, flight, flight});
    plan.links.push_back({end, after, kMinusInfinite, flight, kMinusInfinite});
    before = after;
  }
}

// Only where it can be kept by the plan alone.
void RandomTeam::bound(Plan& plan, std::uint32_t node, Ticks date) {
  std::vector<FrontierLink> links = plan.links;
  links.push_back(
      {Frontier::kOrigin, Frontier::kPresent, now_.count(), now_.count(), now_.count()});
  Distances distances(plan.nodes);
  for (const FrontierLink& link : links)
    if (link.latest != kMinusInfinite) distances.add(link.from, link.to, link.latest);
  distances.close();
  const Ticks least = distances.between(Frontier::kOrigin, node);
  if (least <= date)
    plan.links.push_back({node, Frontier::kOrigin, kMinusInfinite, kMinusInfinite, -date});
}

Frontier RandomTeam::frontier_of(const Plan& plan) const {
  return {plan.meetings,
          eliminate(plan.nodes, Frontier::arrival_of(plan.meetings.size()), plan.links)};
}

namespace {

MissionTime instant(Ticks date) {
  return date == kNever ? MissionTime::max() : MissionTime::nanoseconds(date);
}

std::optional<std::size_t> place_of(const std::vector<Meeting>& meetings, MeetingId id) {
  for (std::size_t i = 0; i < meetings.size(); ++i)
    if (meetings[i].id == id) return i;
  return std::nullopt;
}

}  // namespace

/// The networks of all, with all of their nodes, in one course; what `without` says itself left
/// out.
class RandomTeam::Whole {
 public:
  Whole(const RandomTeam& team, Weight weight, const std::string& without) : plans_(team.plans_) {
    std::size_t nodes = 2;
    for (const auto& [name, plan] : plans_) {
      first_[name] = nodes;
      nodes += plan.nodes - 2;
    }
    distances_.emplace(nodes);
    // What bounds from above leads to the origin, and ends there.
    const bool past = weight == &FrontierArc::latest;
    const Ticks now = team.now_.count();
    past ? distances_->add(1, 0, -now) : distances_->add(0, 1, now);
    for (const auto& [name, plan] : plans_) {
      for (const FrontierLink& link : plan.links)
        if (name != without && link.*weight != kMinusInfinite && !(past && link.from < 2))
          distances_->add(node(name, link.from), node(name, link.to), link.*weight);
      for (std::size_t i = 0; i < plan.meetings.size(); ++i) {
        const bool counts = !is_order(plan.meetings[i].id) || weight == &FrontierArc::slowest;
        if (counts) join(name, plan.meetings[i], i);
      }
    }
    distances_->close();
  }

  Ticks to_arrival(const std::string& name, std::size_t meeting) const {
    return distances_->between(0, node(name, Frontier::arrival_of(meeting)));
  }
  Ticks from_arrival(const std::string& name, std::size_t meeting) const {
    return distances_->between(node(name, Frontier::arrival_of(meeting)), 0);
  }

 private:
  std::size_t node(const std::string& name, std::size_t local) const {
    return local < 2 ? local : first_.at(name) + local - 2;
  }
  void join(const std::string& name, const Meeting& meeting, std::size_t which) {
    if (!is_in(meeting.receivers, name)) return;
    for (const auto& [other, its] : plans_) {
      const auto place = place_of(its.meetings, meeting.id);
      if (other == name || !is_in(meeting.senders, other) || !place) continue;
      distances_->add(node(other, Frontier::arrival_of(*place)),
                      node(name, Frontier::end_of(which)), 1);
    }
  }

  const std::map<std::string, Plan>& plans_;
  std::map<std::string, std::size_t> first_;
  std::optional<Distances> distances_;
};

// Its own, and those that only others plan with it so far.
std::vector<Meeting> RandomTeam::meetings_of(const std::string& agent) const {
  std::vector<Meeting> result = plans_.at(agent).meetings;
  for (const Meeting& meeting : meetings_) {
    const bool counted = is_in(meeting.senders, agent) || is_in(meeting.receivers, agent);
    if (!counted || place_of(result, meeting.id)) continue;
    const bool planned = std::any_of(plans_.begin(), plans_.end(), [&](const auto& one) {
      return one.first != agent && place_of(one.second.meetings, meeting.id).has_value();
    });
    if (planned) result.push_back(meeting);
  }
  return result;
}

std::map<MeetingId, OracleDates> RandomTeam::dates_of(const std::string& agent) const {
  const Whole soonest(*this, &FrontierArc::soonest, ""), slowest(*this, &FrontierArc::slowest, ""),
      latest(*this, &FrontierArc::latest, agent);
  std::map<MeetingId, OracleDates> result;
  for (const Meeting& meeting : meetings_of(agent)) {
    if (is_order(meeting.id) && !is_in(meeting.receivers, agent)) continue;
    OracleDates dates;
    bool all = true;
    for (const std::string& other : meeting.senders) {
      if (other == agent || !is_in(meeting.receivers, agent)) continue;
      const auto place = place_of(plans_.at(other).meetings, meeting.id);
      all = all && place;
      if (!place) continue;
      dates.soonest = std::max(dates.soonest, instant(soonest.to_arrival(other, *place)));
      dates.slowest = std::max(dates.slowest, instant(slowest.to_arrival(other, *place)));
    }
    if (!all) continue;
    const auto own = place_of(plans_.at(agent).meetings, meeting.id);
    const Ticks until = own ? latest.from_arrival(agent, *own) : kMinusInfinite;
    dates.contradicted = until == kNever;
    if (until != kMinusInfinite && until != kNever) dates.needed = instant(-until);
    result[meeting.id] = dates;
  }
  return result;
}

}  // namespace skein::temporal::testing
