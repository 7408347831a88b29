// SPDX-License-Identifier: Apache-2.0
// What a draft finds for an item, against every group and every gap tried one after the other.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "draft.hpp"
#include "skein/foundation/random.hpp"
#include "testing/naive_plan.hpp"

namespace skein::auction {
namespace {

using Group = std::set<std::size_t>;
using Judged = std::map<Group, Value>;

Lot random_lot(Random& random) {
  Lot lot;
  const auto count = static_cast<std::uint32_t>(3 + random.below(3));
  for (std::uint32_t n = 0; n < count; ++n) {
    RoadTask task = a_task(n).at(random.uniform(0, 100)).lasting(random.uniform(0, 20));
    if (random.chance(0.3)) task.from(random.uniform(0, 150));
    if (random.chance(0.3)) task.by(random.uniform(60, 400));
    if (random.chance(0.3)) task.members(2);
    if (random.chance(0.2)) task.pinned(static_cast<std::uint32_t>(random.below(3)));
    lot.tasks.push_back(task);
  }
  for (std::uint32_t then = 1; then < count; ++then) {
    if (random.chance(0.25)) {
      const auto first = static_cast<std::uint32_t>(random.below(then));
      lot.precedences.push_back({TaskNumber(first), TaskNumber(then)});
    }
  }
  return lot;
}

// Three members; task 0 is booked by those who must be there, the others are on sale.
struct OpenDraft {
  explicit OpenDraft(std::uint64_t seed) : random(seed, "draft oracle"), team(lot(), begins()) {
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
  Lot lot() { return random_lot(random); }
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

NaivePlan::Routes routes_of(const Draft& draft) {
  NaivePlan::Routes routes;
  for (std::size_t r = 0; r < draft.route_count(); ++r) routes.push_back(draft.tasks(r));
  return routes;
}

// Every way to put the item into the routes of a group, the best by group.
void try_gaps(const OpenDraft& world, TaskNumber item, const std::vector<std::size_t>& group,
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

Judged try_everything(const OpenDraft& world, const Draft& draft, TaskNumber item) {
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
      try_gaps(world, item, group, 0, routes_of(draft), best);
    }
  }
  return best;
}

Judged found_by(const Draft& draft, std::uint32_t item) {
  Judged found;
  for (const Placing& placing : draft.placings(item, 100)) {
    Group group;
    for (const auto& spot : placing.spots) group.insert(spot.route);
    RC_ASSERT(found.emplace(group, placing.value).second);
  }
  return found;
}

void expect_the_same(const Judged& found, const Judged& tried) {
  RC_ASSERT(found.size() == tried.size());
  for (const auto& [group, value] : tried) {
    RC_ASSERT(found.contains(group));
    RC_ASSERT(found.at(group).unsold == value.unsold);
    RC_ASSERT(std::abs(found.at(group).first - value.first) < 1e-5);
  }
}

RC_GTEST_PROP(DraftOracle, FindsTheBestGapsOfEveryGroupThatCanAndOfNoOther, (std::uint64_t seed)) {
  OpenDraft world(seed);
  Draft draft = world.draft();
  const bool sound = NaivePlan(world.team, world.booked).value(world.aim).has_value();
  if (!draft.restore() || !sound) return;

  for (std::uint32_t item = 0; item < draft.item_count(); ++item) {
    expect_the_same(found_by(draft, item), try_everything(world, draft, world.items[item]));
    const auto placings = draft.placings(item, 100);
    if (!placings.empty()) draft.place(placings[world.random.below(placings.size())]);
  }
}

RC_GTEST_PROP(DraftOracle, ItsDatesAndItsValueAreThoseOfARouteWalked, (std::uint64_t seed)) {
  OpenDraft world(seed);
  Draft draft = world.draft();
  if (!draft.restore()) return;
  for (std::uint32_t item = 0; item < draft.item_count(); ++item) {
    const auto placings = draft.placings(item, 100);
    if (!placings.empty()) draft.place(placings.front());
  }

  NaivePlan walked(world.team, routes_of(draft));
  const auto value = walked.value(world.aim);
  RC_PRE(value.has_value());  // what was booked may need more energy than there is

  RC_ASSERT(draft.value().unsold == value->unsold);
  RC_ASSERT(std::abs(draft.value().first - value->first) < 1e-9);
  RC_ASSERT(std::abs(draft.value().second - value->second) < 1e-9);
  for (const auto& route : routes_of(draft)) {
    for (const TaskNumber task : route) {
      RC_ASSERT(std::abs(draft.start(task) - walked.start(task)) < 1e-9);
    }
  }
}

}  // namespace
}  // namespace skein::auction
