// SPDX-License-Identifier: Apache-2.0
// The network of a plan, its dates, and what is said when it cannot be kept to.
#include "skein/supervisor/schedule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "testing/elementary_plans.hpp"
#include "testing/rebuilt_network.hpp"

namespace skein::supervisor {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr temporal::Ticks operator""_s(unsigned long long seconds) {
  return static_cast<temporal::Ticks>(seconds) * temporal::kTicksPerSecond;
}

Schedule planned(const Tasks& tasks) { return schedule(tasks, {}, MissionTime()); }

mission::TaskDates window(double earliest_start, double latest_start, double earliest_end,
                          double latest_end) {
  return {at(earliest_start), at(latest_start), at(earliest_end), at(latest_end)};
}

bool has_arc(const temporal::Stnu& network, const temporal::Arc& arc) {
  return std::find(network.arcs.begin(), network.arcs.end(), arc) != network.arcs.end();
}

// --- the network ---------------------------------------------------------------------------------

TEST(NetworkOf, HasTheOriginAndTwoNodesForEachTask) {
  const auto network = network_of({a_task(103, "goto").lasts(1, 2)}, {}, MissionTime());

  EXPECT_THAT(network.nodes, ElementsAre("0", "103 start", "103 end"));
  EXPECT_EQ(network.origin, 0U);
}

TEST(NetworkOf, NatureDecidesOnDurationsThatAreNotFixed) {
  const auto network =
      network_of({a_task(1, "goto").lasts(1, 2), a_task(2, "wait").lasts(20),
                  a_task(3, "synchronise").lasts(0, 30), a_task(4, "wait").open_ended()},
                 {}, MissionTime());

  EXPECT_THAT(network.contingent, ElementsAre(temporal::ContingentLink{1, 2, 1_s, 2_s},
                                              temporal::ContingentLink{5, 6, 1'000'000, 30_s}));
  EXPECT_TRUE(has_arc(network, {3, 4, 20_s, 20_s}));
  EXPECT_TRUE(has_arc(network, {7, 8, 0, temporal::kInfinite}));
}

TEST(NetworkOf, ATaskWithAStopEndsSoonAfterIt) {
  const auto network =
      network_of({a_task(1, "wait").lasts(20), a_task(2, "takeshot").running(1).stopped_by(1)}, {},
                 MissionTime());

  EXPECT_TRUE(has_arc(network, {2, 4, 0, kStopReaction.count()}));
  EXPECT_TRUE(has_arc(network, {2, 3, temporal::kMinusInfinite, 0}));
  EXPECT_TRUE(has_arc(network, {1, 3, 0, temporal::kInfinite}));
  EXPECT_THAT(network.contingent, IsEmpty());
}

TEST(NetworkOf, WhatIsOverIsOnlyItsDates) {
  Observations seen{{id(1), {at(3), at(9), false}}};

  const auto network =
      network_of({a_task(1, "goto").lasts(1, 2).ended(7).end_before(5)}, seen, at(10));

  EXPECT_THAT(network.arcs,
              ElementsAre(temporal::Arc{0, 1, 3_s, 3_s}, temporal::Arc{0, 2, 9_s, 9_s}));
  EXPECT_THAT(network.contingent, IsEmpty());
}

TEST(NetworkOf, ATaskCancelledBeforeItStartedIsAtOneDate) {
  Observations seen{{id(1), {std::nullopt, at(9), true}}};

  const auto network = network_of({a_task(1, "goto").lasts(1, 2)}, seen, at(10));

  EXPECT_TRUE(has_arc(network, {0, 1, 9_s, 9_s}));
}

TEST(NetworkOf, OfWhatIsUnderWayTheRestOfTheDurationIsLeft) {
  Observations seen{{id(1), {at(3), std::nullopt, false}}};

  const auto network = network_of({a_task(1, "goto").lasts(1, 20)}, seen, at(10));

  EXPECT_THAT(network.contingent, ElementsAre(temporal::ContingentLink{1, 2, 7_s, 20_s}));
}

TEST(NetworkOf, WhatLastsTooLongEndsAtSomeTimeFromNowOn) {
  Observations seen{{id(1), {at(3), std::nullopt, false}}};

  const auto network = network_of({a_task(1, "goto").lasts(1, 5)}, seen, at(10));

  EXPECT_THAT(network.contingent, IsEmpty());
  EXPECT_TRUE(has_arc(network, {0, 2, 10_s, temporal::kInfinite}));
}

// --- dates ---------------------------------------------------------------------------------------

// Source: spec 3.5: the starts of Karma's plan.
TEST(Schedule, ForeseesTheStartsOfKarmasPlan) {
  const Schedule result = planned(karma_plan());

  ASSERT_TRUE(result.controllable);
  const auto start = [&](std::uint64_t task) {
    const auto& dates = result.foreseen.at(id(task));
    return std::pair(dates.earliest_start, dates.latest_start);
  };
  const auto seconds = [](double a, double b) { return std::pair(at(a), at(b)); };
  EXPECT_EQ(start(100), seconds(0, 0));
  EXPECT_EQ(start(101), seconds(4, 6));
  EXPECT_EQ(start(102), seconds(5, 87));
  EXPECT_EQ(start(103), seconds(5, 87));
  EXPECT_EQ(start(104), seconds(25, 107));
  EXPECT_EQ(start(105), seconds(33, 195));
  EXPECT_EQ(start(107), seconds(333, 495));
  EXPECT_EQ(start(108), seconds(341, 593));
  EXPECT_EQ(result.foreseen.at(id(103)), window(5, 87, 25, 107));
  EXPECT_EQ(result.earliest_end, at(345));
  EXPECT_EQ(result.latest_end, at(599));
}

// Source: spec 3.5: Marvin's, who waits for Heliv for up to 30 s.
TEST(Schedule, ForeseesTheStartsOfMarvinsPlan) {
  const Schedule result = planned(marvin_plan());

  ASSERT_TRUE(result.controllable);
  EXPECT_EQ(result.foreseen.at(id(41)).latest_start, at(72));
  EXPECT_EQ(result.foreseen.at(id(43)).earliest_start, at(2.001));
  EXPECT_EQ(result.foreseen.at(id(43)).latest_start, at(102));
  EXPECT_EQ(result.foreseen.at(id(45)).latest_start, at(222));
}

TEST(Schedule, WithoutConstraintsNothingBreaksByBeingLate) {
  const Schedule result = planned(karma_plan());

  EXPECT_EQ(result.dates.at(id(104)).earliest_start, at(25));
  EXPECT_EQ(result.dates.at(id(104)).latest_start, MissionTime::max());
  EXPECT_EQ(result.dates.at(id(108)).latest_end, MissionTime::max());
}

TEST(Schedule, ADeadlineReachesBackToWhatComesBefore) {
  const Schedule result = planned(
      {a_task(1, "goto").lasts(10, 30), a_task(2, "goto").ended(1).lasts(5, 10).end_before(100)});

  ASSERT_TRUE(result.controllable);
  EXPECT_EQ(result.dates.at(id(2)), window(10, 90, 15, 100));
  EXPECT_EQ(result.dates.at(id(1)), window(0, 60, 10, 90));
}

TEST(Schedule, AnEndAfterHoldsTheStartBackForTheFastestCourse) {
  const Schedule result = planned({a_task(1, "goto").lasts(5, 10).end_after(500)});

  ASSERT_TRUE(result.controllable);
  EXPECT_EQ(result.dates.at(id(1)).earliest_start, at(495));
  EXPECT_EQ(result.foreseen.at(id(1)).latest_end, at(505));
}

TEST(Schedule, NothingStartsInThePast) {
  const Schedule result = schedule({a_task(1, "goto").lasts(5, 10)}, {}, at(50));

  EXPECT_EQ(result.foreseen.at(id(1)), window(50, 50, 55, 60));
}

TEST(Schedule, WhatFollowsAnOpenWaitHasNoLatestDate) {
  const Schedule result =
      planned({a_task(1, "wait").open_ended(), a_task(2, "goto").ended(1).lasts(1, 2)});

  EXPECT_TRUE(result.controllable);
  EXPECT_EQ(result.foreseen.at(id(1)).latest_start, at(0));
  EXPECT_EQ(result.foreseen.at(id(1)).latest_end, MissionTime::max());
  EXPECT_EQ(result.foreseen.at(id(2)).latest_start, MissionTime::max());
  EXPECT_EQ(result.earliest_end, at(1));
  EXPECT_EQ(result.latest_end, MissionTime::max());
}

TEST(Schedule, WhatIsSeenMovesWhatFollows) {
  const Tasks tasks{a_task(1, "goto").lasts(10, 30), a_task(2, "goto").ended(1).lasts(5, 10)};
  const Observations seen{{id(1), {at(0), at(12), false}}, {id(2), {at(13), std::nullopt, false}}};

  const Schedule result = schedule(tasks, seen, at(14));

  EXPECT_EQ(result.dates.at(id(1)), window(0, 0, 12, 12));
  EXPECT_EQ(result.foreseen.at(id(2)), window(13, 13, 18, 23));
}

TEST(Schedule, ATaskThatLastsTooLongDoesNotBreakThePlan) {
  const Tasks tasks{a_task(1, "goto").lasts(10, 30),
                    a_task(2, "goto").ended(1).lasts(5, 10).end_before(100)};
  const Observations seen{{id(1), {at(0), std::nullopt, false}}};

  const Schedule result = schedule(tasks, seen, at(40));

  EXPECT_TRUE(result.controllable);
  EXPECT_EQ(result.foreseen.at(id(1)).earliest_end, at(40));
  EXPECT_EQ(result.foreseen.at(id(1)).latest_end, MissionTime::max());
}

TEST(Schedule, AnUnknownDependenceIsMet) {
  EXPECT_EQ(planned({a_task(1, "goto").ended(99).lasts(5, 10)}).foreseen.at(id(1)),
            window(0, 0, 5, 10));
}

TEST(Schedule, OfNoTasksIsEmptyAndControllable) {
  const Schedule result = planned({});

  EXPECT_TRUE(result.consistent);
  EXPECT_TRUE(result.controllable);
  EXPECT_THAT(result.dates, IsEmpty());
  EXPECT_EQ(result.earliest_end, MissionTime());
}

TEST(Schedule, FiguresBeyondAllMeasureAreUnbounded) {
  mission::ElementaryTask task = a_task(1, "goto").lasts(5, 10);
  task.duration.most = Duration::max();
  task.time.start_before = MissionTime::max();
  task.time.end_after = MissionTime::nanoseconds(std::numeric_limits<std::int64_t>::min());

  const Schedule result = planned({task, a_task(2, "goto").ended(1).lasts(-5, -10)});

  EXPECT_TRUE(result.controllable);
  EXPECT_EQ(result.dates.at(id(1)).latest_start, MissionTime::max());
}

// --- conflicts -----------------------------------------------------------------------------------

TEST(Schedule, NamesTheTaskThatCannotKeepItsDeadline) {
  const Schedule result = planned({a_task(1, "goto").lasts(400, 500),
                                   a_task(2, "goto").ended(1).lasts(31, 40).end_before(400)});

  EXPECT_FALSE(result.consistent);
  EXPECT_FALSE(result.controllable);
  EXPECT_THAT(result.dates, IsEmpty());
  EXPECT_THAT(result.conflicts,
              ElementsAre(Conflict{id(2), "ends no earlier than 431 s, must end before 400 s"}));
}

TEST(Schedule, NamesTheTaskThatMayMissItsDeadline) {
  const Schedule result = planned({a_task(1, "goto").lasts(100, 500),
                                   a_task(2, "goto").ended(1).lasts(31, 40).start_before(400)});

  EXPECT_TRUE(result.consistent);
  EXPECT_FALSE(result.controllable);
  EXPECT_THAT(result.conflicts,
              ElementsAre(Conflict{id(2), "may start as late as 500 s, must start before 400 s"}));
  EXPECT_FALSE(result.dates.empty());
}

TEST(Schedule, NamesBothConstraintsThatDoNotFit) {
  const Schedule result = planned({a_task(1, "goto").lasts(10, 20).start_after(300),
                                   a_task(2, "goto").ended(1).lasts(10, 20).end_before(310)});

  EXPECT_THAT(result.conflicts,
              testing::UnorderedElementsAre(
                  Conflict{id(1), "must start after 300 s"},
                  Conflict{id(2), "ends no earlier than 320 s, must end before 310 s"}));
}

TEST(Schedule, NamesTasksThatWaitForEachOther) {
  const Schedule result =
      planned({a_task(1, "goto").ended(2).lasts(10, 20), a_task(2, "goto").ended(1).lasts(10, 20)});

  EXPECT_FALSE(result.consistent);
  EXPECT_THAT(result.conflicts,
              testing::UnorderedElementsAre(Conflict{id(1), "waits for the end of task 2"},
                                            Conflict{id(2), "waits for the end of task 1"}));
}

TEST(Schedule, ATaskThatWaitsForItselfIsInConflict) {
  EXPECT_THAT(planned({a_task(1, "goto").ended(1).lasts(10, 20)}).conflicts,
              Contains(Field(&Conflict::task, id(1))));
}

TEST(Schedule, WhatRanBesideATaskThatIsOverCannotStart) {
  const Tasks tasks{a_task(1, "wait").lasts(20), a_task(2, "takeshot").running(1).stopped_by(1)};
  const Observations seen{{id(1), {at(0), at(20), false}}};

  const Schedule result = schedule(tasks, seen, at(30));

  EXPECT_FALSE(result.consistent);
  EXPECT_THAT(result.conflicts, ElementsAre(Field(&Conflict::why, HasSubstr("task 1"))));
}

// The wait of 20 s is put off until the relay is over, or nearly so in the worst case.
TEST(Schedule, HoldsATaskBackWhoseCompanionMayComeLate) {
  const Tasks tasks{a_task(1, "joint:relay").lasts(10, 100), a_task(2, "wait").lasts(20),
                    a_task(3, "takeshot").running(2).ended(1).stopped_by(2)};

  const Schedule before = planned(tasks);
  const Schedule under_way = schedule(tasks, {{id(1), {at(5), {}, false}}}, at(6));

  EXPECT_TRUE(before.controllable);
  EXPECT_THAT(before.holds.at(id(2)), ElementsAre(Hold{id(1), MissionTime::max()}));
  EXPECT_THAT(under_way.holds.at(id(2)), ElementsAre(Hold{id(1), at(85.001)}));
  EXPECT_EQ(before.foreseen.at(id(2)).earliest_start, at(10));
  EXPECT_EQ(before.foreseen.at(id(2)).latest_start, at(80.001));
}

// ---- bounds after goals ----

mission::ElementaryTask of_goal(mission::ElementaryTask task, std::uint64_t goal) {
  task.origin = mission::GoalId(goal);
  return task;
}

Tasks two_goals() {
  return {of_goal(a_task(1, "goto").lasts(20, 40), 701),
          of_goal(a_task(2, "takeshot").ended(1).lasts(5, 9), 701),
          of_goal(a_task(3, "goto").ended(2).lasts(30, 50), 702)};
}

GoalBounds after_701(double least, double most) {
  GoalBounds bounds;
  bounds.of[mission::GoalId(702)] = {
      {mission::GoalId(701), false, Duration::seconds(least), Duration::seconds(most)}};
  return bounds;
}

TEST(ScheduleGoalBounds, AGoalIsPutOffUntilSoLongAfterAnother) {
  const Schedule result = schedule(two_goals(), {}, at(0), after_701(60, 90));

  EXPECT_TRUE(result.controllable);
  EXPECT_EQ(result.foreseen.at(id(3)).earliest_start, at(85));
  EXPECT_EQ(result.foreseen.at(id(3)).latest_start, at(109));
  EXPECT_THAT(result.holds.at(id(3)), Contains(Hold{executive::TaskId(), MissionTime::max()}))
      << "its date is known when the other is over, not before";
}

TEST(ScheduleGoalBounds, AGoalThatMayFollowAtOnceWaitsForTheLastTaskOfTheOther) {
  const Schedule result = schedule(two_goals(), {}, at(0), after_701(0, 90));

  EXPECT_TRUE(result.controllable);
  EXPECT_THAT(result.holds.at(id(3)), Contains(Hold{id(2), MissionTime::max()}));
}

TEST(ScheduleGoalBounds, WhatCannotFollowInTimeIsSaidWithItsFigures) {
  Tasks tasks = two_goals();
  tasks.push_back(of_goal(a_task(4, "goto").ended(3).lasts(5, 9), 703));
  GoalBounds bounds;
  bounds.of[mission::GoalId(703)] = {
      {mission::GoalId(701), false, Duration(), Duration::seconds(25)}};

  const Schedule result = schedule(tasks, {}, at(0), bounds);

  EXPECT_FALSE(result.consistent);
  EXPECT_THAT(result.conflicts,
              ElementsAre(Conflict{id(4),
                                   "starts no earlier than 55 s, must start between 0 and 25 s "
                                   "after the end of goal 701"}));
}

TEST(ScheduleGoalBounds, OfAGoalThatIsOverTheInstantCounts) {
  GoalBounds bounds = after_701(0, 25);
  bounds.over[mission::GoalId(701)] = at(100);
  const Tasks rest{of_goal(a_task(3, "goto").lasts(30, 50), 702)};

  EXPECT_TRUE(schedule(rest, {}, at(110), bounds).controllable);
  const Schedule late = schedule(rest, {}, at(130), bounds);

  EXPECT_FALSE(late.consistent);
  ASSERT_EQ(late.conflicts.size(), 1U);
  EXPECT_THAT(late.conflicts[0].why, HasSubstr("after the end of goal 701, which was at 100 s"));
}

// The wait ends with the synchronisation and the look with the wait, and these keep the bound.
TEST(ScheduleGoalBounds, WhatAnotherOfItsGoalStopsIsNotHeldBackForItsEnd) {
  GoalBounds bounds;
  bounds.of[mission::GoalId(702)] = {
      {mission::GoalId(701), true, Duration::seconds(90), Duration::max()}};
  const Tasks meets{of_goal(a_task(3, "wait").stopped_by(4), 702),
                    of_goal(a_task(4, "synchronise").running(3).lasts(0, 30), 702)};
  const Tasks looks{of_goal(a_task(3, "wait").lasts(65), 702),
                    of_goal(a_task(4, "takeshot").running(3).stopped_by(3), 702)};
  const auto free = [&](const Tasks& tasks, std::uint64_t task) {
    return schedule(tasks, {}, at(110), bounds).holds.count(id(task)) == 0;
  };

  EXPECT_TRUE(free(meets, 3)) << "while the other goal is not over";
  bounds.over[mission::GoalId(701)] = at(100);
  EXPECT_TRUE(free(meets, 3));
  EXPECT_TRUE(free(looks, 4));
  EXPECT_FALSE(free(looks, 3)) << "its end is its own: 65 s after its start";
}

TEST(ScheduleGoalBounds, OfAGoalThatIsGoneNothingIsBounded) {
  const Tasks rest{of_goal(a_task(3, "goto").lasts(30, 50), 702)};

  EXPECT_TRUE(schedule(rest, {}, at(500), after_701(0, 1)).controllable);
}

TEST(Schedule, RefusesACompanionThatNoStartBringsInTime) {
  const Schedule result =
      planned({a_task(1, "joint:relay").lasts(10, 100), a_task(2, "wait").lasts(20).start_before(5),
               a_task(3, "takeshot").running(2).ended(1).stopped_by(2)});

  EXPECT_TRUE(result.consistent);
  EXPECT_FALSE(result.controllable);
  EXPECT_FALSE(result.conflicts.empty());
}

TEST(Schedule, AcceptsACompanionWhoseOtherWaitIsAlwaysOverInTime) {
  EXPECT_TRUE(planned({a_task(1, "joint:relay").lasts(10, 19), a_task(2, "wait").lasts(20),
                       a_task(3, "takeshot").running(2).ended(1).stopped_by(2)})
                  .controllable);
  EXPECT_TRUE(
      planned({a_task(1, "joint:relay").lasts(10, 100), a_task(2, "wait").ended(1).lasts(20),
               a_task(3, "takeshot").running(2).ended(1).stopped_by(2)})
          .controllable);
}

TEST(Schedule, HoldsATaskBackForTheTimeOfItsCompanion) {
  const Schedule result = planned({a_task(2, "wait").lasts(20),
                                   a_task(3, "takeshot").running(2).start_after(30).stopped_by(2)});

  EXPECT_TRUE(result.controllable);
  EXPECT_THAT(result.holds.at(id(2)), ElementsAre(Hold{executive::TaskId(), at(10.001)}));
}

// The executive starts it when the wait is told to run, which a slow pilot says after what the wait
// may have lasted.
TEST(Schedule, ACompanionStartsWheneverAWaitThatMayEndAnyMomentIsSaidToRun) {
  const Tasks tasks = {a_task(2, "wait").lasts(1.4, 4),
                       a_task(3, "takeshot").running(2).stopped_by(2)};
  Observations seen;
  seen[id(2)].started = at(10);

  for (const double now : {10.5, 11.4, 12.0, 13.9}) {
    EXPECT_TRUE(schedule(tasks, seen, at(now)).controllable) << now;
  }
}

// Its own end_after holds the companion back to 95 s, so that the wait may not begin before 75 s.
TEST(Schedule, HoldsATaskBackForACompanionThatItsEndAfterHoldsBack) {
  const Schedule result =
      planned({a_task(2, "wait").lasts(20),
               a_task(3, "synchronise").running(2).lasts(5, 10).end_after(100)});

  EXPECT_TRUE(result.controllable);
  EXPECT_THAT(result.holds.at(id(2)), ElementsAre(Hold{executive::TaskId(), at(75.001)}));
}

}  // namespace
}  // namespace skein::supervisor
