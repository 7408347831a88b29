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

// ---- joint tasks ----

/// To a joint task with heliv in 10 to 20 s, a minute of it, and 5 s of something after it.
Tasks gathering() {
  Tasks tasks{a_task(1, "goto").lasts(10, 20), a_task(2, "joint:watch").ended(1).lasts(60),
              a_task(3, "goto").ended(2).lasts(5)};
  tasks[1].gathering = mission::Gathering{kMeeting, {"heliv", "karma"}};
  return tasks;
}

TEST(AGathering, BeginsNoSoonerThanTheOtherCan) {
  const Schedule result = planned(gathering(), met(coming(100, 140)));

  EXPECT_TRUE(result.controllable);
  EXPECT_EQ(result.foreseen.at(id(2)).earliest_start, at(100));
  EXPECT_EQ(result.foreseen.at(id(2)).latest_start, at(100));
  EXPECT_EQ(result.foreseen.at(id(3)).earliest_start, at(160));
}

TEST(AGathering, WithOneWhoWaitsThereBeginsWhenThisOneCan) {
  EXPECT_EQ(planned(gathering(), met(coming(3, 5))).foreseen.at(id(2)).latest_start, at(20));
}

TEST(AGathering, BreaksAPromiseForWhichTheOtherIsTooLate) {
  Tasks tasks = gathering();
  tasks.back().time.end_before = at(120);

  const Schedule result = planned(tasks, met(coming(100, 140), Reliance::kNobodysNeeds));

  ASSERT_FALSE(result.consistent);
  EXPECT_EQ(result.conflicts.front().why,
            "ends no earlier than 165 s, must end before 120 s; 'heliv' comes from 100 s on");
}

// Who cannot keep to what was agreed asks for another date.
TEST(AGathering, ThatWasAgreedUponBeginsWhenThatWasAgreed) {
  Tasks tasks = gathering();
  tasks[1].gathering->agreed = true;
  tasks[1].time.start_after = at(60);

  EXPECT_EQ(planned(tasks, met(coming(100, 140))).foreseen.at(id(2)).earliest_start, at(60));
}

TEST(AGathering, HasTheOtherNeedItThere) {
  PartnerDates dates = coming(2, 4);
  dates.needed = at(50);
  dates.needed_by = "heliv";
  EXPECT_EQ(planned(gathering(), met(dates)).dates.at(id(2)).latest_start, at(50));

  dates.needed = at(15);
  EXPECT_THAT(planned(gathering(), met(dates)).conflicts.front().why,
              HasSubstr("must start before 15 s, which 'heliv' needs"));
  EXPECT_TRUE(planned(gathering(), met(dates, Reliance::kNobodysNeeds)).controllable);
}

TEST(AGathering, OfWhomIsNotKnownToComeIsLeftToAgreement) {
  PartnerDates dates;
  dates.soonest = dates.slowest = MissionTime::max();
  dates.last = "heliv";

  EXPECT_EQ(planned(gathering(), met(dates)).foreseen, planned(gathering(), {}).foreseen);
}

// Pseudo-random changes of who comes when, tasks that come and go, time that passes.
TEST(Meeting, TheNetworkThatLivesIsTheOneMadeAnew) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    PlanNetwork alive;
    const bool joint = seed % 2 == 0;
    const auto until = [joint](double seconds) {
      if (!joint) return meeting_until(seconds);
      Tasks tasks = gathering();
      tasks.back().time.end_before = at(seconds);
      return tasks;
    };
    Tasks tasks = until(400);
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
      if (random.below(4) == 0) tasks = until(random.below(2) == 0 ? 100'000 : 300);
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
      if (tasks.size() < 2) tasks = until(100'000);
    }
  }
}

// ---- orders between ways ----

const temporal::MeetingId kOrder = temporal::order_of("marvin");

/// Task 1 was started at 0, and waits for heliv to leave its air.
GoalBounds waiting_for_air(const PartnerDates& leaving) {
  GoalBounds bounds;
  bounds.meetings.of = {{kOrder, leaving}};
  bounds.meetings.air.uav = "marvin";
  bounds.meetings.air.waits = id(1);
  return bounds;
}
const Observations kStarted{{id(1), {at(0), std::nullopt}}};

TEST(AMotionThatWaitsForItsAir, FliesAtTheLatestWhenTheOtherHasLeft) {
  const Tasks tasks{a_task(1, "goto").lasts(10, 20), a_task(2, "land").ended(1).lasts(5)};
  const Schedule result = schedule(tasks, kStarted, at(30), waiting_for_air(coming(100, 140)));

  ASSERT_TRUE(result.controllable);
  EXPECT_EQ(result.foreseen.at(id(2)).earliest_start, at(40));
  EXPECT_EQ(result.foreseen.at(id(2)).latest_start, at(160));
}

TEST(AMotionThatWaitsForItsAir, ForOneOfWhomNothingIsKnownHasNoEnd) {
  const Tasks tasks{a_task(1, "goto").lasts(10, 20), a_task(2, "land").ended(1).lasts(5)};
  PartnerDates never = coming(100, 0);
  never.slowest = MissionTime::max();

  const Schedule result = schedule(tasks, kStarted, at(30), waiting_for_air(never));
  EXPECT_TRUE(result.controllable);
  EXPECT_EQ(result.foreseen.at(id(2)).latest_start, MissionTime::max());
}

TEST(AMotionThatWaitsForItsAir, MakesAPromiseBehindItALateOneAndNamesForWhom) {
  Tasks tasks{a_task(1, "goto").lasts(10, 20), a_task(2, "land").ended(1).lasts(5)};
  tasks.back().time.end_before = at(150);
  const Schedule result = schedule(tasks, kStarted, at(30), waiting_for_air(coming(100, 140)));

  EXPECT_FALSE(result.controllable);
  ASSERT_FALSE(result.conflicts.empty());
  EXPECT_THAT(result.conflicts.front().why, HasSubstr("'heliv' leaves its air between 30 s and "));
}

TEST(AMotionThatWaitsForItsAir, IsAsAnyOtherOnceItFlies) {
  const Tasks tasks{a_task(1, "goto").lasts(10, 20), a_task(2, "land").ended(1).lasts(5)};
  GoalBounds flies = waiting_for_air(coming(100, 140));
  flies.meetings.air.waits.reset();

  EXPECT_EQ(schedule(tasks, kStarted, at(15), flies).foreseen.at(id(2)).latest_start, at(20));
}

// ---- what others need to know ----

Frontier frontier_of(const Tasks& tasks, const GoalBounds& bounds = {},
                     const Observations& seen = {}, double now = 0) {
  std::vector<TaskView> views;
  for (const mission::ElementaryTask& task : tasks) {
    const auto known = seen.find(task.id);
    views.push_back({&task, known == seen.end() ? Observation() : known->second});
  }
  relate(views, bounds);
  PlanNetwork network;
  network.update(views, at(now));
  return eliminated(network.frontier({{id(2), *meeting_of(tasks[1])}}));
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

TEST(AFrontierOfAPlan, SaysWhenItIsReadyForAJointTask) {
  const Frontier frontier = frontier_of(gathering());

  EXPECT_THAT(frontier.arcs, ::testing::UnorderedElementsAre(
                                 FrontierArc{1, 2, seconds(10), seconds(20), seconds(20)},
                                 FrontierArc{1, 3, seconds(10), seconds(20), seconds(20)},
                                 FrontierArc{2, 3, 0, 0, 0}));
}

TEST(AFrontierOfAPlan, IsReadySinceWhatCameBeforeIsOver) {
  const Observations seen{{id(1), {at(0), at(12)}}};

  const Frontier frontier = frontier_of(gathering(), {}, seen, 40);

  EXPECT_THAT(
      frontier.arcs,
      ::testing::IsSupersetOf({FrontierArc{0, 2, seconds(12), seconds(12), seconds(12)},
                               FrontierArc{2, 0, kMinusInfinite, kMinusInfinite, -seconds(12)}}));
}

TEST(AFrontierOfAPlan, OfWhomHasBegunBoundsNobodyWhoIsStillToCome) {
  const Observations seen{{id(1), {at(0), at(12)}}, {id(2), {at(30), std::nullopt}}};

  const Frontier frontier = frontier_of(gathering(), {}, seen, 40);

  EXPECT_THAT(frontier.arcs,
              ::testing::Contains(FrontierArc{0, 2, seconds(30), seconds(30), seconds(30)}));
  for (const FrontierArc& arc : frontier.arcs) EXPECT_FALSE(arc.from == 3 && arc.to == 0);
}

// Who is ready waits for that date with all the others.
TEST(AFrontierOfAPlan, IsReadyBeforeTheDateThatWasAgreed) {
  Tasks tasks = gathering();
  tasks[1].time.start_after = at(300);

  const Frontier frontier = frontier_of(tasks);

  EXPECT_THAT(frontier.arcs,
              ::testing::Contains(FrontierArc{1, 2, seconds(10), seconds(20), seconds(20)}));
  EXPECT_THAT(frontier.arcs,
              ::testing::Contains(FrontierArc{0, 3, seconds(300), seconds(300), seconds(300)}));
}

TEST(AFrontierOfAPlan, DoesNotSayWhatOthersSaid) {
  PartnerDates dates = coming(300, 400);
  dates.needed = at(60);

  EXPECT_EQ(frontier_of(meeting(), met(dates)), frontier_of(meeting()));
  EXPECT_EQ(frontier_of(gathering(), met(dates)), frontier_of(gathering()));
}

/// Of such a plan, which comes to its meeting behind the motion; `heliv` waits for its place.
Frontier frontier_with_orders(const GoalBounds& bounds, const std::vector<PlanOrder>& orders) {
  const Tasks tasks = meeting();
  std::vector<TaskView> views;
  for (const mission::ElementaryTask& task : tasks)
    views.push_back({&task, task.id == id(1) ? kStarted.at(id(1)) : Observation()});
  relate(views, bounds);
  PlanNetwork network;
  network.update(views, at(30));
  return eliminated(network.frontier({{id(2), *meeting_of(tasks[1])}}, orders));
}

TEST(AFrontierOfAPlan, SaysWhatFollowsWhenItHasItsAir) {
  const PlanOrder waits{id(1), {kOrder, {"heliv"}, {"marvin"}}, true};
  const Frontier frontier = frontier_with_orders(waiting_for_air(coming(100, 140)), {waits});

  ASSERT_EQ(frontier.meetings.size(), 2U);
  EXPECT_THAT(frontier.arcs,
              ::testing::Contains(FrontierArc{5, 2, kMinusInfinite, seconds(20), kMinusInfinite}))
      << "not before it has flown for as long as that takes";
  EXPECT_THAT(frontier.arcs,
              ::testing::Contains(FrontierArc{1, 2, seconds(10), seconds(10), seconds(10)}));
}

TEST(AFrontierOfAPlan, SaysWhenAnothersAirIsLeft) {
  const PlanOrder leaves{id(3), {temporal::order_of("heliv"), {"marvin"}, {"heliv"}}};
  const Frontier frontier = frontier_with_orders({}, {leaves});

  EXPECT_THAT(frontier.arcs,
              ::testing::Contains(FrontierArc{3, 4, seconds(5), seconds(5), seconds(5)}))
      << "after the meeting and the motion behind it";
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
