// SPDX-License-Identifier: Apache-2.0
#include "multi_agent/team_graph.hpp"

#include <algorithm>
#include <iterator>
#include <span>

namespace skein::temporal {

namespace {

/// What is said is heard later than it is said: two that wait for each other never go on.
constexpr Ticks kHeard = 1;

const FrontierBasis* basis_in(const Frontier& frontier, std::uint32_t node) {
  for (const FrontierBasis& one : frontier.bases)
    if (one.node == node) return &one;
  return nullptr;
}

/// Those on which its earliest date rests, too.
std::span<const EndOf> certain_ends(const FrontierBasis& basis) {
  const auto order = std::find_if(basis.ends.begin(), basis.ends.end(),
                                  [](const EndOf& end) { return is_order(end.meeting); });
  return {basis.ends.begin(), order};
}

bool any(const std::vector<bool>& changed) {
  return std::find(changed.begin(), changed.end(), true) != changed.end();
}

}  // namespace

bool is_in(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Ticks sum(Ticks a, Ticks b) { return std::clamp(a + b, -kLargest, kLargest); }

bool is_fact(const Frontier& frontier, std::uint32_t node) {
  Ticks soonest = kMinusInfinite, latest = kInfinite;
  for (const FrontierArc& arc : frontier.arcs) {
    if (arc.from == Frontier::kOrigin && arc.to == node) soonest = arc.soonest;
    if (arc.from == node && arc.to == Frontier::kOrigin && arc.latest != kMinusInfinite)
      latest = -arc.latest;
  }
  return soonest == latest && soonest != kInfinite;
}

std::map<std::string, Frontier> without_inner_nodes(std::map<std::string, Frontier> known) {
  for (auto& [agent, frontier] : known) {
    const std::uint32_t kept = Frontier::arrival_of(frontier.meetings.size());
    const bool whole =
        std::any_of(frontier.arcs.begin(), frontier.arcs.end(),
                    [&](const FrontierArc& arc) { return arc.from >= kept || arc.to >= kept; });
    if (whole) frontier = eliminated(frontier);
  }
  return known;
}

TeamGraph::TeamGraph(const Known& known, const std::map<std::string, MissionTime>& unheard_since,
                     const std::string& self)
    : known_(known), self_(self) {
  for (const auto& [agent, frontier] : known_) {
    first_[agent] = nodes_;
    nodes_ += static_cast<std::uint32_t>(2 * frontier.meetings.size());
  }
  for (const auto& [agent, frontier] : known_) {
    const auto unheard = unheard_since.find(agent);
    enter(agent, frontier, unheard == unheard_since.end() ? kInfinite : unheard->second.count());
    for (std::size_t i = 0; i < frontier.meetings.size(); ++i) join(agent, i);
  }
  see_circles();
}

// Of one that is not heard any more the present is the instant of its last word.
void TeamGraph::enter(const std::string& agent, const Frontier& frontier, Ticks last_word) {
  const auto since_then = [&](Ticks weight) {
    return weight == kInfinite || weight == kMinusInfinite ? weight : sum(weight, last_word);
  };
  for (FrontierArc arc : frontier.arcs) {
    const FrontierBasis* past =
        arc.from >= 2 && arc.to < 2 ? basis_in(frontier, arc.from) : nullptr;
    arc.from = node(agent, arc.from);
    arc.to = node(agent, arc.to);
    if (arc.from == Frontier::kPresent && last_word != kInfinite) {
      arc.from = Frontier::kOrigin;
      arc.soonest = since_then(arc.soonest);
      arc.slowest = since_then(arc.slowest);
    }
    arcs_.push_back({arc, &agent, past});
  }
  for (std::size_t i = 0; i < frontier.meetings.size(); ++i) {
    end_of_[node(agent, Frontier::end_of(i))] = {agent, frontier.meetings[i].id};
    const std::uint32_t arrival = Frontier::arrival_of(i);
    if (const FrontierBasis* basis = basis_in(frontier, arrival))
      basis_[node(agent, arrival)] = basis;
  }
}

void TeamGraph::join(const std::string& agent, std::size_t which) {
  const Meeting& meeting = known_.at(agent).meetings[which];
  if (!is_in(meeting.receivers, agent)) return;
  const std::uint32_t end = node(agent, Frontier::end_of(which));
  for (const auto& [other, frontier] : known_) {
    if (other == agent || !is_in(meeting.senders, other)) continue;
    for (std::size_t i = 0; i < frontier.meetings.size(); ++i) {
      if (frontier.meetings[i].id != meeting.id) continue;
      const std::uint32_t arrival = node(other, Frontier::arrival_of(i));
      const Ticks certain = is_order(meeting.id) ? kMinusInfinite : kHeard;
      arcs_.push_back({{arrival, end, certain, kHeard, certain}, nullptr});
      awaited_[end].push_back({&other, arrival, is_fact(frontier, Frontier::arrival_of(i))});
    }
  }
}

// Who is awaited waits for the very same: never, or, where an order between ways is among what it
// waits for, without a figure.
void TeamGraph::see_circles() {
  for (const auto& [end, awaited] : awaited_) {
    const EndOf& own = end_of_.at(end);
    if (own.agent != self_ || !awaits(end, own, false)) continue;
    const bool never = !is_order(own.meeting) && awaits(end, own, true);
    const Ticks soonest = never ? kInfinite : kMinusInfinite;
    arcs_.push_back({{Frontier::kOrigin, end, soonest, kInfinite, kMinusInfinite}, nullptr});
  }
}

/// An end of the own for somebody whose arrival rests on that very end; `certainly`: its earliest
/// date does.
bool TeamGraph::awaits(std::uint32_t end, const EndOf& own, bool certainly) const {
  const std::vector<Awaited>& all = awaited(end);
  return std::any_of(all.begin(), all.end(), [&](const Awaited& one) {
    const auto basis = basis_.find(one.arrival);
    if (basis == basis_.end()) return false;
    const std::span<const EndOf> ends =
        certainly ? certain_ends(*basis->second) : std::span<const EndOf>(basis->second->ends);
    return std::find(ends.begin(), ends.end(), own) != ends.end();
  });
}

const std::vector<TeamGraph::Awaited>& TeamGraph::awaited(std::uint32_t end) const {
  static const std::vector<Awaited> kNobody;
  const auto found = awaited_.find(end);
  return found == awaited_.end() ? kNobody : found->second;
}

std::vector<Ticks> TeamGraph::earliest(Weight weight, const Since& since) const {
  std::vector<Ticks> date(nodes_, kMinusInfinite);
  date[Frontier::kOrigin] = since.origin;
  date[Frontier::kPresent] = since.present;
  std::vector<bool> changed;
  for (std::uint32_t round = 0; round < nodes_; ++round) {
    changed = revise(weight, date);
    if (!any(changed)) return date;
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

std::vector<bool> TeamGraph::revise(Weight weight, std::vector<Ticks>& date) const {
  std::vector<bool> changed(nodes_, false);
  for (const Arc& one : arcs_) {
    const FrontierArc& arc = one.arc;
    const Ticks from = date[arc.from];
    if (arc.*weight == kMinusInfinite || from == kMinusInfinite || arc.to < 2) continue;
    const bool never = arc.*weight == kInfinite || from == kInfinite;
    const Ticks least = never ? kInfinite : sum(from, arc.*weight);
    if (least <= date[arc.to]) continue;
    date[arc.to] = least;
    changed[arc.to] = true;
  }
  return changed;
}

// ---- circles ----

bool TeamGraph::Yield::before(const Yield& other) const {
  if (there != other.there) return other.there;
  if (*agent != *other.agent) return *agent > *other.agent;
  return std::pair(meeting, behind) < std::pair(other.meeting, other.behind);
}

bool TeamGraph::goes_on(const FrontierArc& arc) {
  const bool from_end = arc.from >= 2 && arc.from % 2 == 1;
  const bool to_arrival = arc.to >= 2 && arc.to % 2 == 0;
  return from_end && to_arrival && arc.soonest != kMinusInfinite;
}

/// Itself only on a circle.
std::vector<bool> TeamGraph::reached_from(std::uint32_t start, Weight weight) const {
  std::vector<bool> reached(nodes_, false);
  std::vector<std::uint32_t> open = {start};
  while (!open.empty()) {
    const std::uint32_t node = open.back();
    open.pop_back();
    for (const Arc& one : arcs_) {
      if (one.arc.from != node || one.arc.*weight == kMinusInfinite || one.arc.to < 2) continue;
      if (!reached[one.arc.to]) open.push_back(one.arc.to);
      reached[one.arc.to] = true;
    }
  }
  return reached;
}

std::optional<TeamGraph::Yield> TeamGraph::yield_at(std::uint32_t end) const {
  std::optional<Yield> chosen;
  const std::vector<bool> after = reached_from(end);
  if (!after[end]) return chosen;
  for (const auto& [agent, frontier] : known_) {
    for (const FrontierArc& arc : frontier.arcs) {
      if (!goes_on(arc) || !after[node(agent, arc.from)]) continue;
      if (!reached_from(node(agent, arc.to))[end]) continue;
      const std::size_t meeting = (arc.from - 2) / 2, behind = (arc.to - 2) / 2;
      const Yield one{&agent, frontier.meetings[meeting].id, frontier.meetings[behind].id,
                      is_fact(frontier, Frontier::arrival_of(meeting))};
      const bool waits = !is_order(one.meeting) && !is_order(one.behind);
      if (waits && one.meeting > one.behind && (!chosen || one.before(*chosen))) chosen = one;
    }
  }
  return chosen;
}

// ---- limits ----

bool TeamGraph::bounds(const Arc& one, const std::string& without) const {
  if (one.arc.latest == kMinusInfinite || one.arc.from < 2) return false;
  if (one.agent != nullptr && *one.agent == without) return false;
  if (one.past == nullptr) return true;
  return std::none_of(one.past->ends.begin(), one.past->ends.end(),
                      [&](const EndOf& end) { return end.agent == without || end.agent == self_; });
}

void TeamGraph::leave_out(const std::vector<bool>& never) {
  for (Arc& one : arcs_)
    if (never[one.arc.from] || never[one.arc.to]) one.arc.latest = kMinusInfinite;
}

std::vector<TeamGraph::Limit> TeamGraph::latest(const std::string& without,
                                                const Since& since) const {
  std::vector<Limit> limit(nodes_);
  limit[Frontier::kOrigin] = {since.origin, nullptr, 0};
  limit[Frontier::kPresent] = {since.present, nullptr, 0};
  std::vector<bool> changed;
  for (std::uint32_t round = 0; round < nodes_; ++round) {
    changed = revise(without, limit);
    if (!any(changed)) return limit;
  }
  // The others contradict each other: what leads there is not for this one to mend.
  for (std::uint32_t round = 0; round < nodes_; ++round) {
    for (const Arc& one : arcs_)
      if (bounds(one, without) && changed[one.arc.to]) changed[one.arc.from] = true;
  }
  for (std::uint32_t i = 2; i < nodes_; ++i)
    if (changed[i]) limit[i] = {};
  return limit;
}

std::vector<bool> TeamGraph::revise(const std::string& without, std::vector<Limit>& limit) const {
  std::vector<bool> changed(nodes_, false);
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    const Arc& one = arcs_[i];
    const FrontierArc& arc = one.arc;
    const Limit& after = limit[arc.to];
    if (!bounds(one, without) || after.latest == kInfinite) continue;
    const Ticks before = sum(after.latest, -arc.latest);
    if (before >= limit[arc.from].latest) continue;
    const bool others = one.past != nullptr && !one.past->ends.empty();
    const std::string* of = others ? &one.past->ends.back().agent : one.agent;
    limit[arc.from] = {before, arc.to < 2 ? of : after.of, i};
    changed[arc.from] = true;
  }
  return changed;
}

std::vector<std::string> TeamGraph::passed(const std::vector<Limit>& limits,
                                           std::uint32_t node) const {
  std::vector<std::string> agents;
  for (std::uint32_t step = 0; node >= 2 && step < nodes_; ++step) {
    const Arc& one = arcs_[limits[node].arc];
    if (one.agent != nullptr && !is_in(agents, *one.agent)) agents.push_back(*one.agent);
    if (one.past != nullptr)
      for (const EndOf& end : one.past->ends) agents.push_back(end.agent);
    node = one.arc.to;
  }
  return agents;
}

std::vector<EndOf> TeamGraph::basis_of(std::uint32_t arrival) const {
  const std::set<EndOf> certain = ends_before(arrival, &FrontierArc::soonest);
  const std::set<EndOf> all = ends_before(arrival, &FrontierArc::slowest);
  std::vector<EndOf> ends(certain.begin(), certain.end()), rest;
  std::set_difference(all.begin(), all.end(), certain.begin(), certain.end(),
                      std::back_inserter(rest));
  std::stable_partition(rest.begin(), rest.end(),
                        [](const EndOf& end) { return is_order(end.meeting); });
  if (!rest.empty() && is_order(rest.front().meeting))
    ends.insert(ends.end(), rest.begin(), rest.end());
  return ends;
}

/// From which a way in this course leads to it, and those on which what is awaited there rests.
std::set<EndOf> TeamGraph::ends_before(std::uint32_t arrival, Weight weight) const {
  const bool certainly = weight == &FrontierArc::soonest;
  std::set<EndOf> ends;
  for (const auto& [end, own] : end_of_) {
    if (own.agent != self_ || (certainly && is_order(own.meeting))) continue;
    if (!reached_from(end, weight)[arrival]) continue;
    ends.insert(own);
    for (const Awaited& one : awaited(end)) {
      const auto basis = basis_.find(one.arrival);
      if (basis == basis_.end()) continue;
      const std::span<const EndOf> its =
          certainly ? certain_ends(*basis->second) : std::span<const EndOf>(basis->second->ends);
      // An end of its own that is no more comes back in words of before: two who wait for each
      // other would hand it to and fro.
      std::copy_if(its.begin(), its.end(), std::inserter(ends, ends.end()),
                   [&](const EndOf& it) { return it.agent != self_ || has_end(it); });
    }
  }
  return ends;
}

bool TeamGraph::has_end(const EndOf& one) const {
  return std::any_of(end_of_.begin(), end_of_.end(),
                     [&](const auto& known) { return known.second == one; });
}

}  // namespace skein::temporal
