// SPDX-License-Identifier: Apache-2.0
// Where an item of a draft could go.
#include <algorithm>
#include <bit>
#include <limits>

#include "draft.hpp"

namespace skein::auction {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostPartners = 10;   // of a joint task, looked at
constexpr std::size_t kMostTogether = 512;  // combinations of gaps of one group

bool no_way(const Leg& leg) { return leg.seconds >= kNoWay.seconds; }

// Gaps of each of `members` so that their combinations stay few.
std::size_t gaps_each(std::size_t members) {
  std::size_t each = 1;
  const auto combinations = [members](std::size_t n) {
    std::size_t product = 1;
    for (std::size_t i = 0; i < members; ++i) product *= n;
    return product;
  };
  while (each < 64 && combinations(each + 1) <= kMostTogether) ++each;
  return each;
}

bool by_value(const Placing& one, const Placing& other) { return better(one.value, other.value); }

}  // namespace

Leg Draft::way_in(const Route& route, std::uint32_t item, std::size_t position) const {
  const std::size_t width = route.base.size() + 1;
  if (position == 0) return route.in[item * width];
  const Stop& before = route.stops[position - 1];
  if (before.gap >= 0) return route.in[item * width + static_cast<std::size_t>(before.gap) + 1];
  return route.between.empty() ? kNoWay : route.between[before.node * items_.size() + item];
}

Leg Draft::way_out(const Route& route, std::uint32_t item, std::size_t position) const {
  const std::size_t width = route.base.size() + 1;
  if (position == route.stops.size()) return route.out[item * width + width - 1];
  const Stop& next = route.stops[position];
  if (next.gap >= 0) return route.out[item * width + static_cast<std::size_t>(next.gap)];
  return route.between.empty() ? kNoWay : route.between[item * items_.size() + next.node];
}

Leg Draft::leg_at(const Route& route, std::size_t position) const {
  if (route.stops.empty()) return {};
  return position < route.stops.size() ? route.stops[position].leg : route.home;
}

std::vector<Draft::Gap> Draft::gaps(std::uint32_t item, std::uint32_t r) const {
  const Route& route = routes_[r];
  std::vector<Gap> gaps;
  if (!route.called || !route.willing[item]) return gaps;
  for (std::uint32_t p = 0; p <= route.stops.size(); ++p) {
    const Leg in = way_in(route, item, p);
    const Leg out = way_out(route, item, p);
    if (no_way(in) || no_way(out)) continue;
    const Leg old = leg_at(route, p);
    const double taken = route.item_energy[item] + in.energy + out.energy - old.energy;
    if (route.spent + taken > route.energy) continue;
    Gap gap{{r, p}, route.free_from + in.seconds, in.seconds, out.seconds, out.seconds,
            kNever, in.cost + out.cost - old.cost};
    if (p > 0) {
      const Node& before = nodes_[route.stops[p - 1].node];
      gap.arrival = before.start + task_of(before).duration + in.seconds;
    }
    if (p < route.stops.size()) {
      const Node& next = nodes_[route.stops[p].node];
      gap.rest += task_of(next).duration + next.tail;
      gap.by = next.latest - out.seconds;
    }
    gaps.push_back(gap);
  }
  return gaps;
}

// What the whole comes to with the item in these gaps. None: it cannot be there.
std::optional<Value> Draft::judge(std::uint32_t item, std::span<const Gap> group) const {
  const Node& node = nodes_[item];
  const Task& task = task_of(node);
  double start = task.earliest, rest = 0, by = task.deadline, cost = cost_, way = 0;
  for (const Gap& gap : group) {
    way = std::max(way, gap.in);
    start = std::max(start, gap.arrival);
    rest = std::max(rest, gap.rest);
    by = std::min(by, gap.by);
    cost += gap.cost;
  }
  for (const Arc& b : node.before) {
    const Node& first = nodes_[b.node];
    if (!first.placed) continue;
    start = std::max(start, begins_after(b, way));
    by = std::min(by, first.latest + task_of(first).duration + b.delay.most + task.duration);
  }
  for (const Arc& a : node.after) {
    const Node& next = nodes_[a.node];
    if (!next.placed) continue;
    const double apart = a.delay.bounds() ? a.delay.least + way_to(a.node, group) : 0;
    start = std::max(start, next.start - a.delay.most - task.duration);
    rest = std::max(rest, apart + task_of(next).duration + next.tail);
    by = std::min(by, next.latest - apart);
  }
  const double end = start + task.duration;
  if (end > by || (catalogue_->coupled() && circular(item, group))) return std::nullopt;
  return value_of(aim_, unsold_ - 1, cost, std::max(end_, end + rest));
}

void Draft::Best::consider(const std::optional<Value>& judged, std::span<const Gap> group) {
  if (!judged || (found && !better(*judged, value))) return;
  found = true;
  value = *judged;
  gaps.assign(group.begin(), group.end());
}

Placing Draft::Best::placing(std::uint32_t item) const {
  Placing placing{item, {}, value};
  for (const Gap& gap : gaps) placing.spots.push_back(gap.spot);
  return placing;
}

// Whether something that would come after the item is waited for by something before it.
bool Draft::circular(std::uint32_t item, std::span<const Gap> group) const {
  std::vector<std::uint32_t> open, before;
  for (const Gap& gap : group) {
    const auto& stops = routes_[gap.spot.route].stops;
    if (gap.spot.position > 0) before.push_back(stops[gap.spot.position - 1].node);
    if (gap.spot.position < stops.size()) open.push_back(stops[gap.spot.position].node);
  }
  for (const Arc& b : nodes_[item].before) {
    if (nodes_[b.node].placed) before.push_back(b.node);
  }
  for (const Arc& a : nodes_[item].after) {
    if (nodes_[a.node].placed) open.push_back(a.node);
  }
  std::uint32_t last = 0;
  for (const std::uint32_t b : before) last = std::max(last, nodes_[b].rank);
  std::vector<bool> seen(nodes_.size());
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    if (before.empty() || nodes_[n].rank > last || seen[n]) continue;
    seen[n] = true;
    if (std::find(before.begin(), before.end(), n) != before.end()) return true;
    for (const auto& [r, p] : nodes_[n].spots) {
      if (p + 1 < routes_[r].stops.size()) open.push_back(routes_[r].stops[p + 1].node);
    }
    for (const Arc& a : nodes_[n].after) {
      if (nodes_[a.node].placed) open.push_back(a.node);
    }
  }
  return false;
}

std::vector<Placing> Draft::single_placings(std::uint32_t item) const {
  const Task& task = task_of(nodes_[item]);
  std::vector<Placing> placings;
  for (std::uint32_t r = 0; r < routes_.size(); ++r) {
    if (task.pinned && *task.pinned != routes_[r].member) continue;
    Best best;
    for (const Gap& gap : gaps(item, r)) {
      const std::span<const Gap> alone(&gap, 1);
      best.consider(judge(item, alone), alone);
    }
    if (best.found) placings.push_back(best.placing(item));
  }
  return placings;
}

// All ways to put together one gap of each member of a group.
void Draft::combine(std::uint32_t item, const std::vector<std::vector<Gap>>& gaps,
                    std::vector<Gap>& chosen, Best& best) const {
  if (chosen.size() == gaps.size()) {
    best.consider(judge(item, chosen), chosen);
    return;
  }
  for (const Gap& gap : gaps[chosen.size()]) {
    chosen.push_back(gap);
    combine(item, gaps, chosen, best);
    chosen.pop_back();
  }
}

// Groups that suffice and of which nobody could be left out.
std::vector<Placing> Draft::joint_placings(std::uint32_t item) const {
  const Task& task = task_of(nodes_[item]);
  std::vector<std::vector<Gap>> partners;
  for (std::uint32_t r = 0; r < routes_.size(); ++r) {
    auto own = gaps(item, r);
    if (own.empty()) continue;
    const auto sooner = [](const Gap& a, const Gap& b) {
      return a.arrival + a.rest < b.arrival + b.rest;
    };
    std::stable_sort(own.begin(), own.end(), sooner);
    partners.push_back(std::move(own));
  }
  std::stable_sort(partners.begin(), partners.end(), [](const auto& a, const auto& b) {
    return a.front().arrival < b.front().arrival;
  });
  if (partners.size() > kMostPartners) partners.resize(kMostPartners);
  std::vector<Placing> placings;
  for (std::uint32_t group = 1; group < (1U << partners.size()); ++group) {
    const auto count = static_cast<std::size_t>(std::popcount(group));
    if (!suffices(task, group, partners)) continue;
    std::vector<std::vector<Gap>> gaps;
    for (std::size_t i = 0; i < partners.size(); ++i) {
      if ((group >> i & 1U) == 0) continue;
      gaps.push_back(partners[i]);
      gaps.back().resize(std::min(gaps.back().size(), gaps_each(count)));
    }
    std::vector<Gap> chosen;
    Best best;
    combine(item, gaps, chosen, best);
    if (best.found) placings.push_back(best.placing(item));
  }
  return placings;
}

bool Draft::suffices(const Task& task, std::uint32_t group,
                     const std::vector<std::vector<Gap>>& partners) const {
  const auto count = static_cast<std::uint32_t>(std::popcount(group));
  const std::uint32_t least = std::max(1U, task.least_members);
  if (count < least || count > least + static_cast<std::uint32_t>(std::popcount(task.needs)))
    return false;
  const auto covered = [&](std::uint32_t members) {
    Abilities all = 0;
    bool pinned = !task.pinned;
    for (std::size_t i = 0; i < partners.size(); ++i) {
      if ((members >> i & 1U) == 0) continue;
      const Route& route = routes_[partners[i].front().spot.route];
      all |= route.abilities;
      pinned = pinned || route.member == *task.pinned;
    }
    return pinned && (task.needs & ~all) == 0;
  };
  if (!covered(group)) return false;
  for (std::size_t i = 0; i < partners.size() && count > least; ++i) {
    if ((group >> i & 1U) != 0 && covered(group & ~(1U << i))) return false;
  }
  return true;
}

std::vector<Placing> Draft::placings(std::uint32_t item, std::size_t most) const {
  const Task& task = task_of(nodes_[item]);
  const bool alone = task.least_members <= 1 && std::popcount(task.needs) <= 1;
  std::vector<Placing> all = alone ? single_placings(item) : joint_placings(item);
  std::stable_sort(all.begin(), all.end(), by_value);
  if (all.size() > most) all.resize(most);
  return all;
}

}  // namespace skein::auction
