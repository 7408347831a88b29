// SPDX-License-Identifier: Apache-2.0
// What others foresee of themselves in the network of a plan, and what they need to know of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "schedule/plan_network.hpp"
#include "testing/elementary_plans.hpp"

namespace skein::supervisor {
namespace {

using temporal::Frontier;
using temporal::FrontierArc;
using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::PartnerDates;
using temporal::Ticks;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr temporal::MeetingId kMeeting = 511;  // of task 2

PartnerDates coming(double soonest, double slowest) {
  PartnerDates dates;
  dates.soonest = at(soonest);
  dates.slowest = at(slowest);
  dates.last = "heliv";
  return dates;
}

using Reliance = Meetings::Reliance;

GoalBounds met(const PartnerDates& dates, Reliance reliance = Reliance::kOnNothing) {
  GoalBounds bounds;
  bounds.meetings = {{{kMeeting, dates}}, reliance};
  return bounds;
}

/// To the meeting in 10 to 20 s, and 5 s of something after it.
Tasks meeting() {
  return {a_task(1, "goto").lasts(10, 20), a_task(2, "rendezvous").ended(1).lasts(0, 30),
          a_task(3, "goto").ended(2).lasts(5)};
}
Tasks meeting_until(double seconds) {
  Tasks tasks = meeting();
  tasks.back().time.end_before = at(seconds);
  return tasks;
}

Schedule planned(const Tasks& tasks, const GoalBounds& bounds, double now = 0) {
  return schedule(tasks, {}, at(now), bounds);
}

TEST(Meeting, OfWhichNothingIsKnownTakesAsLongAsTheDomainSays) {
  EXPECT_EQ(planned(meeting(), {}).foreseen.at(id(3)).latest_start, at(50));
}

TEST(Meeting, EndsWhenTheOtherComes) {
  const Schedule result = planned(meeting(), met(coming(100, 140)));

  ASSERT_TRUE(result.controllable);
  EXPECT_EQ(result.foreseen.at(id(3)).earliest_start, at(100));
  EXPECT_EQ(result.foreseen.at(id(3)).latest_start, at(140));
}

TEST(Meeting, OfWhomComesAtAKnownDateEndsThen) {
  EXPECT_EQ(planned(meeting(), met(coming(100, 100))).foreseen.at(id(3)).latest_start, at(100.001));
}

TEST(Meeting, OfWhomComesBeforeEndsAtOnce) {
  const Schedule result = planned(meeting(), met(coming(2, 4)));

  EXPECT_EQ(result.foreseen.at(id(3)).latest_start, at(20.001));
}

TEST(Meeting, ThatTheOtherMayComeTooLateToBreaksAPromiseAndTheOtherIsNamed) {
  const Schedule result = planned(meeting_until(120), met(coming(100, 140)));

  EXPECT_TRUE(result.consistent);
  EXPECT_FALSE(result.controllable);
  ASSERT_FALSE(result.conflicts.empty());
  EXPECT_EQ(result.conflicts.front().task, id(3));
  EXPECT_EQ(result.conflicts.front().why,
            "may end as late as 145 s, must end before 120 s; 'heliv' comes between 100 s and 140 "
            "s");
}

TEST(Meeting, IsHopedForAsLongAsItMayGoWell) {
  const GoalBounds hopeful = met(coming(100, 140), Reliance::kOnTheirBest);
  EXPECT_TRUE(planned(meeting_until(120), hopeful).controllable);
  EXPECT_FALSE(planned(meeting_until(104), hopeful).consistent);
}

TEST(Meeting, HasAnotherNeedItThere) {
  PartnerDates dates = coming(2, 4);
  dates.needed = at(15);
  dates.needed_by = "heliv";

  const Schedule result = planned(meeting(), met(dates));

  EXPECT_FALSE(result.controllable);
  EXPECT_THAT(result.conflicts.front().why,
              HasSubstr("must start before 15 s, which 'heliv' needs"));
  EXPECT_FALSE(planned(meeting(), met(dates, Reliance::kOnTheirBest)).controllable);
  EXPECT_TRUE(planned(meeting(), met(dates, Reliance::kNobodysNeeds)).controllable);

  dates.needed = at(50);
  EXPECT_EQ(planned(meeting(), met(dates)).dates.at(id(1)).latest_start, at(30));
}

TEST(Meeting, WithOneOfWhomNoFigureIsKnownHasNoEnd) {
  PartnerDates dates = coming(100, 0);
  dates.slowest = MissionTime::max();

  const Schedule result = planned(meeting(), met(dates));

  EXPECT_TRUE(result.controllable);
  EXPECT_EQ(result.foreseen.at(id(3)).earliest_start, at(100));
  EXPECT_EQ(result.foreseen.at(id(3)).latest_start, MissionTime::max());
}

TEST(Meeting, WithOneWhoWaitsInTurnNeverEnds) {
  PartnerDates dates;
  dates.soonest = dates.slowest = MissionTime::max();
  dates.last = "heliv";

  EXPECT_TRUE(planned(meeting(), met(dates)).controllable);
  EXPECT_THAT(planned(meeting_until(120), met(dates)).conflicts.front().why,
              HasSubstr("'heliv' waits for it in turn, so that neither ever comes"));
}

TEST(Meeting, WithOneWhoIsLateEndsAtSomeTimeFromNowOn) {
  const Schedule result = planned(meeting(), met(coming(100, 140)), 150);

  EXPECT_EQ(result.foreseen.at(id(3)).earliest_start, at(160.001));
  EXPECT_EQ(result.foreseen.at(id(3)).latest_start, MissionTime::max());
}

TEST(Meeting, WithOneWhoIsThereWaitsForHimNoMore) {
  PartnerDates dates = coming(7, 7);
  dates.all_there = true;

  EXPECT_EQ(planned(meeting(), met(dates)).foreseen.at(id(3)).latest_start, at(21));
}

// It would end at once when the other is there.
TEST(Meeting, WhoseEndHasToWaitForADateBeginsThen) {
  Tasks tasks = meeting();
  tasks[1].time.end_after = at(90);
  PartnerDates dates = coming(7, 7);
  dates.all_there = true;

  EXPECT_EQ(planned(tasks, met(dates)).foreseen.at(id(2)).earliest_start, at(89.999));
}

// Pseudo-random changes of who comes when, tasks that come and go, time that passes.
TEST(Meeting, TheNetworkThatLivesIsTheOneMadeAnew) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    PlanNetwork alive;
    Tasks tasks = meeting_until(400);
    MissionTime now;
    GoalBounds bounds;
    for (int step = 0; step < 12; ++step) {
      now = now + Duration::seconds(static_cast<double>(random.below(20)));
      const double soonest = static_cast<double>(random.below(200));
      PartnerDates dates = coming(soonest, soonest + static_cast<double>(random.below(300)));
      if (random.below(4) == 0) dates.needed = at(static_cast<double>(random.below(400)));
      dates.all_there = random.below(6) == 0;
      if (random.below(5) == 0) dates.last.clear();
      bounds = random.below(5) == 0 ? GoalBounds() : met(dates, Reliance(random.below(3)));
      if (random.below(4) == 0) tasks = random.below(2) == 0 ? meeting() : meeting_until(300);
      if (random.below(4) == 0) tasks.pop_back();
      std::vector<TaskView> views;
      for (const mission::ElementaryTask& task : tasks) views.push_back({&task, {}});
      relate(views, bounds);

      alive.update(views, now);

      const Schedule anew = schedule(tasks, {}, now, bounds);
      const Schedule& found = alive.schedule();
      ASSERT_EQ(found.controllable, anew.controllable) << "seed " << seed << ", step " << step;
      ASSERT_EQ(found.dates, anew.dates) << "seed " << seed << ", step " << step;
      ASSERT_EQ(found.foreseen, anew.foreseen) << "seed " << seed << ", step " << step;
      if (tasks.size() < 2) tasks = meeting();
    }
  }
}

// ---- what others need to know ----

Frontier frontier_of(const Tasks& tasks, const GoalBounds& bounds = {}) {
  std::vector<TaskView> views;
  for (const mission::ElementaryTask& task : tasks) views.push_back({&task, {}});
  relate(views, bounds);
  PlanNetwork network;
  network.update(views, MissionTime());
  return network.frontier({{id(2), {kMeeting, {"heliv", "karma"}, {"heliv", "karma"}}}});
}

Ticks seconds(double s) { return Duration::seconds(s).count(); }

TEST(AFrontierOfAPlan, IsWhenItComesAndHowSoonItGoesOn) {
  const Frontier frontier = frontier_of(meeting());

  EXPECT_THAT(frontier.arcs,
              ElementsAre(FrontierArc{1, 2, seconds(10), seconds(20), seconds(20)},
                          FrontierArc{2, 3, seconds(0.001), seconds(0.001), seconds(0.001)}));
}

TEST(AFrontierOfAPlan, SaysByWhenItIsToBeDone) {
  const Frontier frontier = frontier_of(meeting_until(100));

  EXPECT_THAT(frontier.arcs,
              ::testing::Contains(FrontierArc{3, 0, kMinusInfinite, kMinusInfinite, -seconds(95)}));
}

TEST(AFrontierOfAPlan, DoesNotSayWhatOthersSaid) {
  PartnerDates dates = coming(300, 400);
  dates.needed = at(60);

  EXPECT_EQ(frontier_of(meeting(), met(dates)), frontier_of(meeting()));
}

TEST(AFrontierOfAPlan, WithoutMeetingsSaysNothing) {
  PlanNetwork network;
  const Tasks tasks = meeting();
  std::vector<TaskView> views;
  for (const mission::ElementaryTask& task : tasks) views.push_back({&task, {}});
  network.update(views, MissionTime());

  EXPECT_THAT(network.frontier({}).arcs, IsEmpty());
}

TEST(AFrontierOfAPlan, BehindWhatHasNoEndHasNoLatestArrival) {
  Tasks tasks = meeting();
  tasks.front() = a_task(1, "wait").lasts(10, 20).open_ended();

  EXPECT_THAT(frontier_of(tasks).arcs,
              ::testing::Contains(FrontierArc{1, 2, seconds(10), kInfinite, seconds(10)}));
}

}  // namespace
}  // namespace skein::supervisor
