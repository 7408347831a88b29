// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/held_plans.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

#include "skein/foundation/random.hpp"
#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::Formula;
using executive::TaskState;
using mission::HeldTask;
using testing::a_task;
using testing::abort_of;
using ::testing::ElementsAre;
using testing::id;
using testing::in_state;
using ::testing::IsEmpty;
using testing::start_of;

HeldTask after(std::uint64_t task, std::vector<std::uint64_t> others) {
  HeldTask out;
  out.task = a_task(task);
  for (const std::uint64_t other : others) {
    out.task.preconditions.push_back(in_state(other, TaskState::kEnded));
  }
  return out;
}

std::vector<std::uint64_t> ids(const std::vector<HeldTask>& tasks) {
  std::vector<std::uint64_t> out;
  for (const HeldTask& task : tasks) out.push_back(task.task.id.value());
  return out;
}

/// 11, then 12, then 13, which is stopped by the end of 12.
HeldPlans chain() {
  HeldPlans plans;
  HeldTask last = after(13, {12});
  last.task.exit = {in_state(12, TaskState::kEnded)};
  plans.hold("marvin", {after(12, {11}), last, after(11, {1})});
  return plans;
}

TEST(HeldPlans, KeepsTasksInTheOrderOfIdsByUav) {
  HeldPlans plans = chain();

  EXPECT_THAT(ids(plans.of("marvin")), ElementsAre(11, 12, 13));
  EXPECT_THAT(plans.of("heliv"), IsEmpty());
}

TEST(HeldPlans, WhatIsHandedOverLaterComesOnTop) {
  HeldPlans plans = chain();

  EXPECT_EQ(plans.hold("marvin", {after(13, {}), after(14, {})}), 4U);

  EXPECT_THAT(ids(plans.of("marvin")), ElementsAre(11, 12, 13, 14));
  EXPECT_THAT(plans.of("marvin")[2].task.preconditions, IsEmpty());
}

TEST(HeldPlans, WhatWaitedForADiscardedTaskWaitsForWhatThatWaitedFor) {
  HeldPlans plans = chain();

  const auto rest = plans.take("marvin", {id(12)});

  ASSERT_THAT(ids(rest), ElementsAre(11, 13));
  EXPECT_EQ(rest[1].task.preconditions, Formula{in_state(11, TaskState::kEnded)});
  EXPECT_EQ(rest[1].task.exit, Formula{in_state(11, TaskState::kEnded)});
  EXPECT_THAT(plans.of("marvin"), IsEmpty());
}

TEST(HeldPlans, TheTasksOfOneHighLevelTaskAreDropped) {
  HeldPlans plans;
  HeldTask first = after(11, {}), second = after(12, {11}), other = after(13, {12});
  first.origin = second.origin = mission::GoalId(700);
  other.origin = mission::GoalId(701);
  plans.hold("marvin", {first, second, other});

  EXPECT_EQ(plans.drop("marvin", mission::GoalId(700)), 2U);
  EXPECT_EQ(plans.drop("heliv", mission::GoalId(700)), 0U);

  ASSERT_THAT(ids(plans.of("marvin")), ElementsAre(13));
  EXPECT_THAT(plans.of("marvin")[0].task.preconditions, IsEmpty());
}

TEST(HeldPlans, AnAlternativeToADiscardedTaskStays) {
  HeldPlans plans;
  HeldTask either = after(13, {12});
  either.task.preconditions[0].push_back(in_state(5, TaskState::kEnded)[0]);
  plans.hold("marvin", {after(12, {}), either});

  const auto rest = plans.take("marvin", {id(12)});

  EXPECT_EQ(rest[0].task.preconditions, Formula{in_state(5, TaskState::kEnded)});
}

TEST(HeldPlans, DroppingDiscardsAll) {
  HeldPlans plans = chain();

  EXPECT_EQ(plans.drop("marvin"), 3U);
  EXPECT_EQ(plans.drop("marvin"), 0U);
  EXPECT_THAT(plans.of("marvin"), IsEmpty());
}

TEST(HeldPlans, CommandsAboutAHeldTaskEditIt) {
  HeldPlans plans = chain();
  const executive::UpdateConditions update{id(11), Formula{},
                                           Formula{in_state(2, TaskState::kEnded)}};

  const auto aborted = plans.edit("marvin", abort_of(12));
  const auto updated = plans.edit("marvin", update);
  const auto started = plans.edit("marvin", start_of(13));

  EXPECT_TRUE(aborted->accepted);
  EXPECT_EQ(aborted->dropped, 1U);
  EXPECT_TRUE(updated->accepted);
  EXPECT_FALSE(started->accepted);
  ASSERT_THAT(ids(plans.of("marvin")), ElementsAre(11, 13));
  EXPECT_THAT(plans.of("marvin")[0].task.preconditions, IsEmpty());
  EXPECT_EQ(plans.of("marvin")[0].task.exit, *update.exit);
}

TEST(HeldPlans, CommandsAboutOthersAreNoneOfItsBusiness) {
  HeldPlans plans = chain();

  EXPECT_FALSE(plans.edit("marvin", abort_of(1)));
  EXPECT_FALSE(plans.edit("heliv", abort_of(12)));
  EXPECT_FALSE(plans.edit("marvin", start_of(20)));
  EXPECT_FALSE(plans.edit("marvin", executive::ProcessMessage{"go"}));
  EXPECT_FALSE(plans.edit("marvin", mission::ChangeDegree{1, false, true}));
}

// ---- against walks through the graph of what waits for what ----

using Graph = std::map<std::uint64_t, std::set<std::uint64_t>>;

// What the task waits for when these are left out: the nearest others behind them.
void nearest(const Graph& waits, std::uint64_t task, const std::set<std::uint64_t>& left_out,
             std::set<std::uint64_t>& found) {
  for (const std::uint64_t before : waits.at(task)) {
    if (left_out.contains(before)) {
      nearest(waits, before, left_out, found);
    } else {
      found.insert(before);
    }
  }
}

std::set<std::uint64_t> waited_for(const HeldTask& task) {
  std::set<std::uint64_t> found;
  for (const executive::Clause& clause : task.task.preconditions) {
    RC_ASSERT(clause.size() == 1U);
    found.insert(std::get<executive::TaskInState>(clause[0].condition).task.value());
  }
  return found;
}

TEST(HeldPlansOracle, WhateverIsDiscardedInWhateverOrderTheRestWaitsForTheNearestThatIsLeft) {
  EXPECT_TRUE(rc::check([] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Graph waits{{1, {}}};  // 1 is over, and not held
    std::vector<std::uint64_t> discarded;
    for (std::uint64_t task = 2; task <= 9; ++task) {
      waits.try_emplace(task);
      for (std::uint64_t before = 1; before < task; ++before) {
        if (random.chance(0.4)) waits[task].insert(before);
      }
      const auto where =
          discarded.begin() + static_cast<std::ptrdiff_t>(random.below(discarded.size() + 1));
      if (random.chance(0.5)) discarded.insert(where, task);
    }
    HeldPlans plans;
    for (std::uint64_t task = 2; task <= 9; ++task) {
      plans.hold("marvin", {after(task, {waits[task].begin(), waits[task].end()})});
    }
    const std::set<std::uint64_t> left_out(discarded.begin(), discarded.end());
    for (const std::uint64_t task : discarded) {
      const auto answer = plans.edit("marvin", abort_of(task));
      RC_ASSERT(answer && answer->accepted && answer->dropped == 1U);
    }

    const auto rest = plans.of("marvin");

    RC_ASSERT(rest.size() == 8U - left_out.size());
    for (const HeldTask& task : rest) {
      std::set<std::uint64_t> expected;
      nearest(waits, task.task.id.value(), left_out, expected);
      RC_ASSERT(waited_for(task) == expected);
    }
  }));
}

}  // namespace
}  // namespace skein::ground_station
