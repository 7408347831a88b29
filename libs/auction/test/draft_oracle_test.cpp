// SPDX-License-Identifier: Apache-2.0
// What a draft finds for an item, against every group and every gap tried one after the other.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "testing/open_draft.hpp"

namespace skein::auction {
namespace {

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

Lot delayed_lot(Random& random) {
  Lot lot = random_lot(random);
  for (std::uint32_t then = 1; then < lot.tasks.size(); ++then) {
    if (random.chance(0.4)) continue;
    const auto first = static_cast<std::uint32_t>(random.below(then));
    const double least = random.chance(0.5) ? random.uniform(0, 60) : 0;
    Delay delay{least, least + random.uniform(10, 200)};
    if (random.chance(0.3)) delay.most = Delay().most;
    lot.precedences.push_back({TaskNumber(first), TaskNumber(then), delay});
  }
  return lot;
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

/// Precedences between most tasks, and deadlines that leave little room behind them.
Lot tight_lot(Random& random) {
  Lot lot = random_lot(random);
  lot.precedences.clear();
  for (std::uint32_t n = 0; n < lot.tasks.size(); ++n) {
    if (random.chance(0.7)) lot.tasks[n].deadline = random.uniform(60, 240);
    if (n > 0 && random.chance(0.7)) {
      const auto other = static_cast<std::uint32_t>(random.below(n));
      lot.precedences.push_back({TaskNumber(n), TaskNumber(other)});
    }
  }
  return lot;
}

void expect_the_best_of_every_group(OpenDraft world) {
  Draft draft = world.draft();
  const bool sound = NaivePlan(world.team, world.booked).value(world.aim).has_value();
  if (!draft.restore() || !sound) return;

  for (std::uint32_t item = 0; item < draft.item_count(); ++item) {
    expect_the_same(found_by(draft, item),
                    try_everything(world, routes_of(draft), world.items[item]));
    const auto placings = draft.placings(item, 100);
    if (!placings.empty()) draft.place(placings[world.random.below(placings.size())]);
  }
}

RC_GTEST_PROP(DraftOracle, FindsTheBestGapsOfEveryGroupThatCanAndOfNoOther, (std::uint64_t seed)) {
  expect_the_best_of_every_group(OpenDraft(seed, random_lot));
}

RC_GTEST_PROP(DraftOracle, FindsThemWhereWhatComesAfterHasLittleTime, (std::uint64_t seed)) {
  expect_the_best_of_every_group(OpenDraft(seed, tight_lot));
}

void expect_what_a_walk_comes_to(OpenDraft world) {
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
  RC_ASSERT(std::abs(draft.value().ends - value->ends) < 1e-9);
  for (const auto& route : routes_of(draft)) {
    for (const TaskNumber task : route) {
      RC_ASSERT(std::abs(draft.start(task) - walked.start(task)) < 1e-9);
    }
  }
}

RC_GTEST_PROP(DraftOracle, ItsDatesAndItsValueAreThoseOfARouteWalked, (std::uint64_t seed)) {
  expect_what_a_walk_comes_to(OpenDraft(seed, random_lot));
}

RC_GTEST_PROP(DraftOracle, WithDelaysTooItsDatesAreThoseOfARouteWalked, (std::uint64_t seed)) {
  expect_what_a_walk_comes_to(OpenDraft(seed, delayed_lot));
}

RC_GTEST_PROP(DraftOracle, WhatItPlacesKeepsEveryDelay, (std::uint64_t seed)) {
  OpenDraft world(seed, delayed_lot);
  Draft draft = world.draft();
  if (!draft.restore()) return;
  for (std::uint32_t item = 0; item < draft.item_count(); ++item) {
    const auto placings = draft.placings(item, 100);
    if (!placings.empty()) draft.place(placings.front());
  }
  std::set<TaskNumber> placed;
  for (const auto& route : routes_of(draft)) placed.insert(route.begin(), route.end());
  for (const Precedence& one : world.team.catalogue->lot().precedences) {
    if (!placed.contains(one.first) || !placed.contains(one.then)) continue;
    const double end = draft.start(one.first) + world.team.catalogue->task(one.first).duration;
    RC_ASSERT(draft.start(one.then) >= end + one.delay.least - 1e-9);
    RC_ASSERT(draft.start(one.then) <= end + one.delay.most + 1e-9);
  }
}

}  // namespace
}  // namespace skein::auction
