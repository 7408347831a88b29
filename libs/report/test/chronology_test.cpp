// SPDX-License-Identifier: Apache-2.0
#include "story/chronology.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>

#include "builders.hpp"

namespace skein::report {
namespace {

using testing::stamp;
using testing::task;
using testing::telemetry;

TEST(Tell, AnEmptyRunLastsOneSecond) {
  const Chronology c = tell({}, {});

  EXPECT_EQ(c.time, (Span{0, 1}));
  EXPECT_TRUE(c.uavs.empty());
  EXPECT_TRUE(c.tasks.empty());
}

TEST(Tell, TimeCoversEveryRecord) {
  Journal j;
  j.phases = {{stamp(-3), "before"}};
  j.others = {{stamp(120), "weather"}};

  EXPECT_EQ(tell({}, j).time, (Span{-3, 120}));
}

TEST(Tell, UavsOfTheScenarioComeFirstAndInItsOrder) {
  RunInfo info;
  info.uavs = {{"marvin", "heli", 3}, {"heliv", "heli", 2}};
  Journal j;
  j.telemetry = {telemetry(1, "stranger", {}), telemetry(1, "heliv", {})};

  const Chronology c = tell(info, j);

  ASSERT_EQ(c.uavs.size(), 3U);
  EXPECT_EQ(c.uavs[0].name, "marvin");
  EXPECT_EQ(c.uavs[0].degree, 3);
  EXPECT_EQ(c.uavs[1].track.size(), 1U);
  EXPECT_EQ(c.uavs[2].name, "stranger");
  EXPECT_FALSE(c.uavs[2].degree);
  EXPECT_EQ(c.uav_index("stranger"), 2U);
  EXPECT_FALSE(c.uav_index("nobody"));
}

TEST(Tell, ATasksStatesBecomeAdjoiningSegments) {
  Journal j;
  j.tasks = {task(1, "m", 7, TaskState::kScheduled), task(3, "m", 7, TaskState::kStarted),
             task(4, "m", 7, TaskState::kRunning), task(9, "m", 7, TaskState::kEnded)};

  const Chronology c = tell({}, j);

  ASSERT_EQ(c.tasks.size(), 1U);
  const TaskBar& bar = c.tasks[0];
  EXPECT_EQ(bar.span, (Span{1, 9}));
  EXPECT_EQ(bar.outcome, TaskState::kEnded);
  ASSERT_EQ(bar.segments.size(), 3U);
  EXPECT_EQ(bar.segments[0].span, (Span{1, 3}));
  EXPECT_EQ(bar.segments[1].span, (Span{3, 4}));
  EXPECT_EQ(bar.segments[2].span, (Span{4, 9}));
  EXPECT_EQ(bar.active(), (Span{3, 9}));
  EXPECT_EQ(bar.first(TaskState::kRunning), 4);
  EXPECT_FALSE(bar.first(TaskState::kAborting));
}

TEST(Tell, ATaskWithoutEndLastsUntilTheEndOfTheLog) {
  Journal j;
  j.tasks = {task(1, "m", 7, TaskState::kRunning)};
  j.phases = {{stamp(50), "last"}};

  const Chronology c = tell({}, j);

  EXPECT_EQ(c.tasks.at(0).span, (Span{1, 50}));
  EXPECT_FALSE(c.tasks[0].outcome);
}

TEST(Tell, RepeatedStatesAreOne) {
  Journal j;
  j.tasks = {task(1, "m", 7, TaskState::kRunning), task(2, "m", 7, TaskState::kRunning),
             task(9, "m", 7, TaskState::kEnded), task(9.1, "m", 7, TaskState::kEnded)};

  const Chronology c = tell({}, j);

  ASSERT_EQ(c.tasks.size(), 1U);
  EXPECT_EQ(c.tasks[0].segments.size(), 1U);
  EXPECT_EQ(c.tasks[0].span, (Span{1, 9}));
}

TEST(Tell, AnIdUsedAgainIsAnotherTask) {
  Journal j;
  j.tasks = {task(1, "m", 7, TaskState::kRunning), task(2, "m", 7, TaskState::kAborted, "lost"),
             task(5, "m", 7, TaskState::kRunning), task(6, "m", 7, TaskState::kEnded)};

  const Chronology c = tell({}, j);

  ASSERT_EQ(c.tasks.size(), 2U);
  EXPECT_EQ(c.tasks[0].reason, "lost");
  EXPECT_EQ(c.tasks[1].outcome, TaskState::kEnded);
}

TEST(Tell, ATaskAbortedAtOnceHasNoSegment) {
  Journal j;
  j.tasks = {task(4, "m", 7, TaskState::kAborted, "incoherent")};

  const Chronology c = tell({}, j);

  ASSERT_EQ(c.tasks.size(), 1U);
  EXPECT_TRUE(c.tasks[0].segments.empty());
  EXPECT_EQ(c.tasks[0].outcome, TaskState::kAborted);
  EXPECT_FALSE(c.tasks[0].active());
}

TEST(Tell, TheSameIdOfTwoUavsIsTwoTasks) {
  Journal j;
  j.tasks = {task(1, "b", 7, TaskState::kRunning), task(2, "a", 7, TaskState::kRunning)};

  const Chronology c = tell({}, j);

  ASSERT_EQ(c.tasks.size(), 2U);
  EXPECT_EQ(c.tasks[0].uav, 0U);
  EXPECT_EQ(c.tasks[1].uav, 1U);
}

TEST(Tell, APhaseLastsUntilTheNext) {
  Journal j;
  j.phases = {{stamp(0), "A"}, {stamp(5), "A"}, {stamp(10), "B"}, {stamp(30), "C"}};

  const Chronology c = tell({}, j);

  ASSERT_EQ(c.phases.size(), 3U);
  EXPECT_EQ(c.phases[0].span, (Span{0, 10}));
  EXPECT_EQ(c.phases[1].span, (Span{10, 30}));
  EXPECT_EQ(c.phases[2].span, (Span{30, 30}));
}

TEST(Tell, AnAlarmKeepsItsLastEstimateAndAllItsSteps) {
  Journal j;
  j.alarms = {{stamp(5), 1, AlarmState::kRaised, {1, 1, 0}, 0.5},
              {stamp(6), 1, AlarmState::kRaised, {2, 2, 0}, 0.6},
              {stamp(9), 1, AlarmState::kConfirmed, {3, 3, 0}, 0.9},
              {stamp(9), 2, AlarmState::kRaised, {7, 7, 0}, 0.4}};

  const Chronology c = tell({}, j);

  ASSERT_EQ(c.alarms.size(), 2U);
  EXPECT_EQ(c.alarms[0].position, (Position{3, 3, 0}));
  ASSERT_EQ(c.alarms[0].steps.size(), 2U);
  EXPECT_EQ(c.alarms[0].steps[1], (std::pair{9.0, AlarmState::kConfirmed}));
}

TEST(Tell, OnlyRealChangesOfDegreeCount) {
  RunInfo info;
  info.uavs = {{"m", "heli", 3}};
  Journal j;
  j.degrees = {{stamp(0), "m", 3}, {stamp(5), "m", 1}, {stamp(6), "m", 1}, {stamp(8), "m", 3}};

  const Chronology c = tell(info, j);

  EXPECT_EQ(c.uavs[0].degrees, (std::vector<std::pair<double, int>>{{5, 1}, {8, 3}}));
}

TEST(Tell, OfTwoSamplesAtOneInstantTheLastCounts) {
  Journal j;
  j.telemetry = {telemetry(1, "m", {1, 0, 0}), telemetry(1, "m", {2, 0, 0}),
                 telemetry(2, "m", {3, 0, 0})};

  const Chronology c = tell({}, j);

  ASSERT_EQ(c.uavs[0].track.size(), 2U);
  EXPECT_EQ(c.uavs[0].track[0].position.x, 2);
}

TEST(Tell, ObjectsKeepTheirStatesByName) {
  Journal j;
  j.objects = {{stamp(0), "fire", "fire", {1, 1, 0}, 5, false},
               {stamp(5), "fire", "fire", {1, 1, 0}, 6, true},
               {stamp(5), "car", "vehicle", {9, 9, 0}, 2, true}};

  const Chronology c = tell({}, j);

  ASSERT_EQ(c.objects.size(), 2U);
  EXPECT_EQ(c.objects[0].states.size(), 2U);
  EXPECT_EQ(c.objects[1].type, "vehicle");
}

TEST(At, IsLinearBetweenTwoPoints) {
  const std::vector<TrackPoint> track{{0, {0, 0, 0}, 1, 0, 1.0, true},
                                      {10, {100, 50, 20}, 3, 1, 0.5, true}};

  const std::optional<TrackPoint> p = at(track, 4);

  ASSERT_TRUE(p);
  EXPECT_DOUBLE_EQ(p->position.x, 40);
  EXPECT_DOUBLE_EQ(p->position.z, 8);
  EXPECT_DOUBLE_EQ(p->energy, 0.8);
  EXPECT_DOUBLE_EQ(p->heading, 0.4);
}

TEST(At, HeadingTurnsTheShortWay) {
  const std::vector<TrackPoint> track{{0, {}, 0, 3.0, 1, true}, {1, {}, 0, -3.0, 1, true}};

  EXPECT_NEAR(std::abs(std::remainder(at(track, 0.5)->heading, 2 * M_PI)), M_PI, 1e-9);
}

TEST(At, IsNothingOutsideTheTrack) {
  const std::vector<TrackPoint> track{{5, {1, 2, 3}, 0, 0, 1, true}};

  EXPECT_FALSE(at(track, 4.9));
  EXPECT_FALSE(at(track, 5.1));
  EXPECT_FALSE(at({}, 0));
  EXPECT_EQ(at(track, 5)->position, (Position{1, 2, 3}));
}

// Whatever the order of states in the log, the bars are sound.
RC_GTEST_PROP(Tell, SegmentsAlwaysAdjoinWithinTheirBar, ()) {
  const auto steps = *rc::gen::container<std::vector<std::tuple<int, int, int>>>(
      rc::gen::tuple(rc::gen::inRange(0, 100), rc::gen::inRange(0, 4), rc::gen::inRange(0, 6)));
  Journal j;
  for (const auto& [t, id, state] : steps) {
    j.tasks.push_back(task(t, "m", id, static_cast<TaskState>(state)));
  }
  sort_by_time(j);

  const Chronology c = tell({}, j);

  for (const TaskBar& bar : c.tasks) {
    RC_ASSERT(bar.span.from <= bar.span.to && bar.span.to <= c.time.to);
    for (std::size_t i = 0; i < bar.segments.size(); ++i) {
      const TaskSegment& s = bar.segments[i];
      RC_ASSERT(s.state != TaskState::kEnded && s.state != TaskState::kAborted);
      RC_ASSERT(s.span.from == (i == 0 ? bar.span.from : bar.segments[i - 1].span.to));
    }
    if (!bar.segments.empty()) RC_ASSERT(bar.segments.back().span.to == bar.span.to);
  }
}

}  // namespace
}  // namespace skein::report
