// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

#include "skein/translation/missions.hpp"
#include "testing/generators.hpp"

namespace skein::translation {
namespace {

using wire::Violation;

// ---- enumerations: both sides mean the same by every name ----

TEST(Plans, EveryStateOfAGoalKeepsItsNameOnTheWire) {
  for (int i = 0; i < static_cast<int>(mission::GoalState::kCount); ++i) {
    mission::GoalStatus goal;
    goal.state = static_cast<mission::GoalState>(i);

    EXPECT_EQ(wire::name_of(to_wire(goal).state), mission::to_text(goal.state));
  }
}

TEST(Plans, EveryKindOfDependenceKeepsItsNameOnTheWire) {
  for (int i = 0; i < static_cast<int>(mission::DependenceKind::kCount); ++i) {
    const auto kind = static_cast<mission::DependenceKind>(i);
    mission::PlanReport report;
    report.tasks.resize(1);
    report.tasks[0].task.dependences = {{kind, executive::TaskId(4)}};

    const wire::MissionPlan plan = to_wire("karma", report);

    EXPECT_EQ(wire::name_of(plan.tasks[0].dependences[0].kind), mission::to_text(kind));
  }
}

// ---- round trips ----

RC_GTEST_PROP(Plans, AnOutcomeComesBackAsItWas, ()) {
  mission::MissionOutcome outcome{mission::MissionId(testing::any_id()), testing::any_truth(),
                                  testing::some(testing::any_text)};
  outcome.evaluated = testing::any_truth();
  if (outcome.evaluated && outcome.planned) outcome.estimate = testing::any_estimate();

  RC_ASSERT(to_wire("karma", outcome).uav == "karma");
  RC_ASSERT(from_wire(to_wire("karma", outcome)) == outcome);
}

RC_GTEST_PROP(Plans, ADecisionComesBackAsItWas, ()) {
  const mission::Decision decision{testing::any_id(),
                                   testing::any_text(),
                                   testing::any_text(),
                                   testing::any_text(),
                                   testing::any_text(),
                                   testing::any_instant(),
                                   Duration::nanoseconds(*rc::gen::arbitrary<std::int64_t>())};

  RC_ASSERT(to_wire("karma", decision).uav == "karma");
  RC_ASSERT(from_wire(to_wire("karma", decision)) == decision);
}

RC_GTEST_PROP(Plans, AHandOverComesBackAsItWas, ()) {
  const mission::HandOver hand_over{*rc::gen::inRange(1, 5), testing::any_held_tasks(),
                                    testing::some(testing::any_goal)};

  const wire::HandOver sample = to_wire("karma", hand_over);

  RC_ASSERT(sample.uav == "karma");
  RC_ASSERT(!wire::find_violation(sample));
  RC_ASSERT(from_wire(sample) == hand_over);
}

RC_GTEST_PROP(Plans, APlanComesBackAsFarAsTheWireHasFields, ()) {
  const mission::PlanReport report = testing::any_plan_report();

  const wire::MissionPlan plan = to_wire("karma", report);

  RC_ASSERT(plan.uav == "karma");
  RC_ASSERT(!wire::find_violation(plan));
  RC_ASSERT(from_wire(plan) == report);
}

TEST(Plans, ALongWayIsSentWithFewerPointsButWholeFromEndToEnd) {
  mission::PlanReport report;
  report.tasks.resize(1);
  for (int i = 0; i < 5000; ++i) report.tasks[0].task.way.emplace_back(i, 0, 50);

  const wire::MissionPlan plan = to_wire("karma", report);

  EXPECT_EQ(wire::find_violation(plan), std::nullopt);
  const auto way = from_wire(plan)->tasks[0].task.way;
  EXPECT_GT(way.size(), 1000U);
  EXPECT_EQ(way.front().x(), 0);
  EXPECT_EQ(way.back().x(), 4999);
}

// ---- rubbish ----

struct BadPlan {
  std::string name;
  std::function<void(wire::MissionPlan&)> spoil;
  Violation violation;
};

class RubbishPlan : public ::testing::TestWithParam<BadPlan> {};

TEST_P(RubbishPlan, IsRefusedWithTheFieldAndWhy) {
  wire::MissionPlan plan;
  plan.tasks.resize(2);
  plan.tasks[0].id = 100;
  plan.tasks[1].id = 101;
  GetParam().spoil(plan);

  const auto read = from_wire(plan);

  ASSERT_FALSE(read);
  EXPECT_EQ(read.error(), GetParam().violation);
}

INSTANTIATE_TEST_SUITE_P(Plans, RubbishPlan,
                         ::testing::Values(BadPlan{"an_id_twice",
                                                   [](auto& p) { p.tasks[1].id = 100; },
                                                   {"tasks[1].id", "given twice"}},
                                           BadPlan{"half_a_point",
                                                   [](auto& p) {
                                                     p.tasks[0].way = {1, 2, 3, 4};
                                                   },
                                                   {"tasks[0].way", "not three numbers a point"}},
                                           BadPlan{
                                               "late_start",
                                               [](auto& p) { p.tasks[1].earliest_start = 1; },
                                               {"tasks[1].latest_start", "before the earliest"}},
                                           BadPlan{"late_end",
                                                   [](auto& p) { p.tasks[1].earliest_end = 1; },
                                                   {"tasks[1].latest_end", "before the earliest"}}),
                         [](const auto& one) { return one.param.name; });

struct BadHandOver {
  std::string name;
  std::function<void(wire::HandOver&)> spoil;
  Violation violation;
};

class RubbishHandOver : public ::testing::TestWithParam<BadHandOver> {};

TEST_P(RubbishHandOver, IsRefusedWithTheFieldAndWhy) {
  wire::HandOver hand_over;
  hand_over.degree = 2;
  hand_over.tasks.resize(2);
  hand_over.tasks[0].task.id = 100;
  hand_over.tasks[1].task.id = 101;
  GetParam().spoil(hand_over);

  const auto read = from_wire(hand_over);

  ASSERT_FALSE(read);
  EXPECT_EQ(read.error(), GetParam().violation);
}

INSTANTIATE_TEST_SUITE_P(
    Plans, RubbishHandOver,
    ::testing::Values(BadHandOver{"degree_zero",
                                  [](auto& h) { h.degree = 0; },
                                  {"degree", "0 is not a degree from 1 to 5"}},
                      BadHandOver{"degree_six",
                                  [](auto& h) { h.degree = 6; },
                                  {"degree", "6 is not a degree from 1 to 5"}},
                      BadHandOver{"an_id_twice",
                                  [](auto& h) { h.tasks[1].task.id = 100; },
                                  {"tasks[1].task.id", "not above the one before"}},
                      BadHandOver{"a_task_that_is_over",
                                  [](auto& h) { h.tasks[0].state = wire::TaskState::kEnded; },
                                  {"tasks[0].state", "the task is over"}}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace skein::translation
