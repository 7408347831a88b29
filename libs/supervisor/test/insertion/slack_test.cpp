// SPDX-License-Identifier: Apache-2.0
// Durations that may be shorter, and bounds that would serve, with a planner of straight flights.
#include "insertion/slack.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "insertion/with.hpp"
#include "testing/straight_planner.hpp"

namespace skein::supervisor::testing {
namespace {

using mission::GoalId;
using mission::HighLevelTask;
using mission::Placement;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Lab = InsertionLab;

Lab flying() {
  Lab lab;
  lab.flying().place("A", 100, 0).place("B", 400, 0);
  return lab;
}

HighLevelTask stay(std::uint64_t id, const std::string& range, mission::TimeConstraints time = {}) {
  return {GoalId(id), "stay", {range}, time};
}

InsertionOutcome insert(Lab& lab, Goals added, const GoalBounds& bounds = {}) {
  InsertionRequest request = lab.insertion({}, std::move(added), Placement::kLast);
  request.standing.bounds = bounds;
  return insert_tasks(request, lab.straight.planner());
}

/// Those of the goals themselves.
GoalBounds bounds_of(const Goals& goals) {
  GoalBounds bounds;
  for (const HighLevelTask& goal : goals)
    if (!goal.after.empty()) bounds.of[goal.id] = goal.after;
  return bounds;
}

double given(const InsertionOutcome& outcome, std::uint64_t goal) {
  for (const mission::ElementaryTask& task : outcome.plan->tasks)
    if (task.origin == GoalId(goal) && task.type == "wait") return task.duration.least.to_seconds();
  return 0;
}

// ---- durations ----

TEST(Slack, WithRoomEnoughTheLongestDurationIsPlannedWithOnePlanOnly) {
  Lab lab = flying();

  const auto outcome = insert(lab, {stay(1, "60..120", ends_before(130))});

  ASSERT_TRUE(outcome.plan);
  EXPECT_DOUBLE_EQ(given(outcome, 1), 120);
  EXPECT_THAT(outcome.shortened, IsEmpty());
  EXPECT_THAT(lab.straight.requested, SizeIs(1));
}

TEST(Slack, WhatADeadlineLeavesNoRoomForIsTakenFromADurationThatMayBeShorter) {
  Lab lab = flying();

  const auto outcome = insert(lab, {stay(1, "60..120", ends_before(100))});

  ASSERT_TRUE(outcome.plan);
  EXPECT_GT(given(outcome, 1), 98 - Slack::kSpare);
  EXPECT_LE(given(outcome, 1), 100 - Slack::kSpare);
  ASSERT_THAT(outcome.shortened, SizeIs(1));
  EXPECT_EQ(outcome.shortened[0].given, Duration::seconds(given(outcome, 1)));
  EXPECT_THAT(to_text(outcome.shortened), HasSubstr("s of 60 to 120"));
}

TEST(Slack, NobodyGetsLessThanTheLeastAskedFor) {
  Lab lab = flying();

  const auto outcome = insert(lab, {stay(1, "60..120", ends_before(50))});

  EXPECT_FALSE(outcome.plan);
  EXPECT_THAT(outcome.reasons, ::testing::Contains(HasSubstr("60 s")));
}

TEST(Slack, AllWhoMayGiveTheSamePart) {
  Lab lab = flying();

  const auto outcome =
      insert(lab, {stay(1, "0..100"), stay(2, "50..150"), stay(3, "10..10", ends_before(210))});

  ASSERT_TRUE(outcome.plan);
  EXPECT_NEAR(given(outcome, 1), 75 - 1.5 * Slack::kSpare, 2);
  EXPECT_NEAR(given(outcome, 2), 125 - 1.5 * Slack::kSpare, 2);
  EXPECT_DOUBLE_EQ(given(outcome, 3), 10);
}

TEST(Slack, AnOrderThatShortensLessIsBetterThanOneThatCostsLess) {
  Lab lab = flying();
  HighLevelTask there = Lab::visit(3, "B", ends_before(60));

  const auto outcome = insert_tasks(lab.insertion({}, {stay(1, "1..100"), there}, Placement::kTour),
                                    lab.straight.planner());

  ASSERT_TRUE(outcome.plan);
  for (const Trial& trial : outcome.trials) EXPECT_GE(trial.shortened, total_of(outcome.shortened));
}

struct Drawn {
  Goals goals;
  std::vector<mission::DurationRange> ranges;
};

Drawn draw(int latest) {
  Drawn drawn;
  const int count = *rc::gen::inRange(1, 5);
  for (int i = 0; i < count; ++i) {
    const double least = *rc::gen::inRange(1, 60), most = least + *rc::gen::inRange(0, 90);
    mission::TimeConstraints time;
    if (*rc::gen::inRange(0, 3) == 0) time = ends_before(*rc::gen::inRange(20, latest));
    if (*rc::gen::inRange(0, 4) == 0)
      time.start_after = MissionTime::seconds(*rc::gen::inRange(0, 200));
    const auto text = [](double seconds) { return std::to_string(std::lround(seconds)); };
    drawn.goals.push_back(
        stay(static_cast<std::uint64_t>(i) + 1, text(least) + ".." + text(most), time));
    drawn.ranges.push_back({least, most});
  }
  return drawn;
}

Goals with_figures(const Drawn& drawn, double share) {
  Goals goals = drawn.goals;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const auto& range = drawn.ranges[i];
    goals[i].arguments[0] = range.most - share * (range.most - range.least);
  }
  return goals;
}

// Every share is tried by itself, a thousandth apart.
RC_GTEST_PROP(SlackLaws, TheLeastIsGivenWithWhichThereIsAPlanAndNoneMeansThatThereIsNone, ()) {
  Lab lab = flying();
  const Drawn drawn = draw(400);
  double needed = -1;
  for (int share = 0; share <= 100 && needed < 0; ++share)
    if (insert(lab, with_figures(drawn, share / 100.0)).plan) needed = share / 100.0;

  const auto outcome = insert(lab, drawn.goals);

  RC_ASSERT(outcome.plan.has_value() == (needed >= 0));
  if (!outcome.plan) return;
  RC_ASSERT(outcome.schedule.controllable);
  RC_ASSERT(outcome.shortened.empty() == (needed == 0));
  double room = 0;
  for (const auto& range : drawn.ranges) room += range.most - range.least;
  if (needed > 0) needed += Slack::kSpare * static_cast<double>(drawn.ranges.size()) / room;
  for (std::size_t i = 0; i < drawn.ranges.size(); ++i) {
    const auto& [least, most] = drawn.ranges[i];
    const double seconds = given(outcome, i + 1);
    RC_ASSERT(seconds >= least);
    // Two steps of the search, and tenths.
    RC_ASSERT(seconds >= most - (needed + 2.0 / Slack::kAll) * (most - least) - 0.1);
  }
}

// ---- bounds that would serve ----

Goals with(Goals goals, const std::vector<Relaxation>& relaxations, Duration less) {
  for (const Relaxation& one : relaxations) {
    for (HighLevelTask& goal : goals) {
      if (goal.id != one.goal) continue;
      const MissionTime at = MissionTime() + one.needed - less;
      if (one.bound == "start-before") goal.time.start_before = at;
      if (one.bound == "end-before") goal.time.end_before = at;
      for (mission::GoalBound& bound : goal.after) {
        const bool named = one.bound.find(to_text(bound.goal) + " at most") != std::string::npos;
        if (named) bound.most = one.needed - less;
      }
    }
  }
  return goals;
}

TEST(Relaxations, OfADeadlineThatCannotBeKeptSayWhichCouldBe) {
  Lab lab = flying();

  const auto outcome = insert(lab, {stay(1, "60..120"), stay(2, "40..40", ends_before(90))});

  EXPECT_FALSE(outcome.plan);
  ASSERT_THAT(outcome.relaxations, SizeIs(1));
  EXPECT_EQ(to_text(outcome.relaxations[0]), "goal 2 end-before 100 s instead of 90 s");
}

TEST(Relaxations, OfABoundAfterAGoalCountFromItsEnd) {
  Lab lab = flying();
  Goals goals = {stay(1, "20..20"), stay(2, "30..30"), stay(3, "10..10")};
  goals[2].after = {{GoalId(1), false, Duration(), Duration::seconds(5)}};

  const auto outcome = insert(lab, goals, bounds_of(goals));

  EXPECT_FALSE(outcome.plan);
  ASSERT_THAT(outcome.relaxations, SizeIs(1));
  EXPECT_EQ(to_text(outcome.relaxations[0]),
            "goal 3 start-after-goal 1 at most 30 s instead of 5 s");
}

TEST(Relaxations, AreNotProposedWhereTimeIsNotWhatIsMissing) {
  Lab lab = flying();
  lab.straight.blocked = {"B"};

  const auto outcome = insert(lab, {Lab::visit(1, "B", ends_before(5))});

  EXPECT_FALSE(outcome.plan);
  EXPECT_THAT(outcome.relaxations, IsEmpty());
}

RC_GTEST_PROP(RelaxationLaws, ArePlannedWhenTheyAreAskedForAndNoneOfThemASecondLess, ()) {
  Lab lab = flying();
  Drawn drawn = draw(100);
  Goals& goals = drawn.goals;
  for (std::size_t i = 1; i < goals.size(); ++i) {
    if (*rc::gen::inRange(0, 3) != 0) continue;
    const auto other = static_cast<std::uint64_t>(*rc::gen::inRange<std::size_t>(0, i)) + 1;
    goals[i].after = {{GoalId(other), *rc::gen::arbitrary<bool>(), Duration(),
                       Duration::seconds(*rc::gen::inRange(1, 120))}};
  }
  const auto outcome = insert(lab, goals, bounds_of(goals));
  RC_CLASSIFY(outcome.plan.has_value());
  if (outcome.plan) return;

  RC_ASSERT(!outcome.relaxations.empty());
  const Goals served = with(goals, outcome.relaxations, Duration());
  RC_ASSERT(insert(lab, served, bounds_of(served)).plan.has_value());
  for (const Relaxation& one : outcome.relaxations) {
    Goals less = served;
    less = with(std::move(less), {one}, Duration::seconds(1));
    RC_ASSERT(!insert(lab, less, bounds_of(less)).plan);
  }
}

}  // namespace
}  // namespace skein::supervisor::testing
