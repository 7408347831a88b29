// SPDX-License-Identifier: Apache-2.0
// A draft with tasks on sale, and every group and every gap for an item tried one after the other.
#pragma once

#include "draft.hpp"
#include "skein/foundation/random.hpp"
#include "testing/naive_plan.hpp"

namespace skein::auction {

using Group = std::set<std::size_t>;
using Judged = std::map<Group, Value>;

// Three members; task 0 is booked by those who must be there, the others are on sale.
struct OpenDraft {
  using MakeLot = Lot (*)(Random&);
  OpenDraft(std::uint64_t seed, MakeLot make)
      : random(seed, "draft oracle"), team(make(random), begins()) {
    for (RoadCraft& craft : team.crafts) {
      craft.work = random.uniform(0, 5);
      if (random.chance(0.3)) craft.joules = random.uniform(20, 400);
      if (random.chance(0.3)) craft.free = random.uniform(0, 60);
    }
    aim.equity = random.uniform();
    for (std::uint32_t n = 1; n < team.catalogue->size(); ++n) items.push_back(TaskNumber(n));
    booked.resize(3);
    const Task& first = team.catalogue->task(0U);
    const auto lead = first.pinned ? first.pinned->value() : 0;
    booked[lead].push_back(first.number);
    if (first.least_members == 2) booked[(lead + 1) % 3].push_back(first.number);
  }
  std::vector<double> begins() {
    return {random.uniform(0, 100), random.uniform(0, 100), random.uniform(0, 100)};
  }
  Draft draft() {
    Draft made(*team.catalogue, aim, items);
    for (std::uint32_t m = 0; m < 3; ++m) {
      const Call call{SaleNumber(1), 1, team.catalogue, booked[m], 0, items, 0, true};
      offers.push_back(Bidder(MemberNumber(m), team.crafts[m]).price(call));
    }
    for (std::uint32_t m = 0; m < 3; ++m) {
      BookedRoute route;
      route.member = MemberNumber(m);
      route.tasks = booked[m];
      made.add(route, &offers[m]);
    }
    return made;
  }

  Random random;
  RoadSale team;
  Aim aim;
  std::vector<TaskNumber> items;
  NaivePlan::Routes booked;
  std::vector<Offer> offers;
};

inline NaivePlan::Routes routes_of(const Draft& draft) {
  NaivePlan::Routes routes;
  for (std::size_t r = 0; r < draft.route_count(); ++r) routes.push_back(draft.tasks(r));
  return routes;
}

// Every way to put the item into the routes of a group, the best by group.
inline void try_gaps(const OpenDraft& world, TaskNumber item, const std::vector<std::size_t>& group,
                     std::size_t member, const NaivePlan::Routes& routes, Judged& best) {
  if (member == group.size()) {
    const auto value = NaivePlan(world.team, routes).value(world.aim);
    if (!value) return;
    const auto [known, is_new] = best.emplace(Group(group.begin(), group.end()), *value);
    if (!is_new && better(*value, known->second)) known->second = *value;
    return;
  }
  const auto& own = routes[group[member]];
  for (std::size_t gap = 0; gap <= own.size(); ++gap) {
    NaivePlan::Routes with = routes;
    auto& changed = with[group[member]];
    changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(gap), item);
    try_gaps(world, item, group, member + 1, with, best);
  }
}

inline Judged try_everything(const OpenDraft& world, const NaivePlan::Routes& routes,
                             TaskNumber item) {
  const Task& task = world.team.catalogue->task(item);
  Judged best;
  for (unsigned members = 1; members < 8; ++members) {
    std::vector<std::size_t> group;
    for (std::size_t m = 0; m < 3; ++m) {
      if ((members >> m & 1U) != 0) group.push_back(m);
    }
    const bool with_pinned =
        !task.pinned || std::count(group.begin(), group.end(), task.pinned->value()) > 0;
    if (group.size() == task.least_members && with_pinned) {
      try_gaps(world, item, group, 0, routes, best);
    }
  }
  return best;
}

}  // namespace skein::auction
