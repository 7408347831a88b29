// SPDX-License-Identifier: Apache-2.0
// Air that is closed for a time: it blocks only ways that would meet it; it is flown around or
// waited for, whichever leads there earlier.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "skein/world/crossing.hpp"
#include "testing/planned.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using namespace std::string_literals;
using ::testing::ElementsAre;
using testing::names_of;
using testing::planned;
using testing::PlanningLab;
using world::Vector3;

constexpr double kFar = 390;

/// A wall at x 100 to 130, from `south` to `north`, from the ground to above every ceiling, closed
/// for a time; the vehicle is at (0, 0, 40), 10 m/s fast.
PlanningLab with_wall(double from, double until, double south, double north) {
  PlanningLab lab;
  lab.flying_at({0, 0, 40}).first_id(1);
  lab.world.volumes.push_back({"wall",
                               {{100, south}, {130, south}, {130, north}, {100, north}},
                               0,
                               500,
                               {MissionTime::seconds(from), MissionTime::seconds(until)}});
  return lab;
}

TEST(ClosedForATime, AWallThatIsOpenAgainBeforeItIsMetIsFlownThrough) {
  PlanningLab lab = with_wall(0, 30, -60, 60);
  lab.task(1, "general-wait", {35.0}).task(2, "general-gotoxyz", {Vector3(200, 0, 40)});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("wait", "gotoxyz"));
  EXPECT_EQ(plan.tasks[1].way.size(), 2U) << "straight";
}

TEST(ClosedForATime, AWallThatIsClosedOnlyAfterItWasPassedIsFlownThrough) {
  PlanningLab lab = with_wall(300, 400, -60, 60);
  lab.task(1, "general-gotoxyz", {Vector3(200, 0, 40)});

  EXPECT_EQ(planned(lab).tasks.at(0).way.size(), 2U);
}

TEST(ClosedForATime, AWallThatClosesWhileItMayBePassedIsFlownAround) {
  PlanningLab lab = with_wall(12, 400, -60, 60);
  lab.task(1, "general-gotoxyz", {Vector3(200, 0, 40)});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("gotoxyz"));
  EXPECT_FALSE(crosses(lab.world.volumes[0], 0, plan.tasks[0].way));
}

TEST(ClosedForATime, AWayAroundIsTakenWhenItIsShorterThanTheWait) {
  PlanningLab lab = with_wall(0, 200, -60, 60);
  lab.task(1, "general-gotoxyz", {Vector3(200, 0, 40)});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("gotoxyz"));
  EXPECT_FALSE(crosses(lab.world.volumes[0], 0, plan.tasks[0].way));
}

TEST(ClosedForATime, AWaitIsTakenWhenItIsShorterThanTheWayAround) {
  PlanningLab lab = with_wall(0, 20, -kFar, kFar - 60);
  lab.task(1, "general-gotoxyz", {Vector3(200, 0, 40)});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("wait", "gotoxyz"));
  EXPECT_EQ(plan.tasks[0].duration.least, Duration::seconds(20));
  EXPECT_EQ(plan.tasks[1].way.size(), 2U);
}

TEST(ClosedForATime, AWallWithoutAWayAroundIsWaitedFor) {
  PlanningLab lab = with_wall(0, 500, -400, 400);
  lab.task(1, "general-gotoxyz", {Vector3(200, 0, 40)});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("wait", "gotoxyz"));
  EXPECT_EQ(plan.tasks[0].duration.least, Duration::seconds(500));
}

TEST(ClosedForATime, APerceptionBehindAWallWithoutAWayAroundWaitsForIt) {
  PlanningLab lab = with_wall(0, 100, -400, 400);
  lab.task(1, "perceive", {Vector3(200, 0, 40), 30.0});

  EXPECT_THAT(names_of(planned(lab)), ElementsAre("wait", "gotoxyz", "perception"));
}

TEST(ClosedForATime, ADeadlineThatTheWaitWouldBreakIsSaid) {
  PlanningLab lab = with_wall(0, 500, -400, 400);
  mission::TimeConstraints time;
  time.end_before = MissionTime::seconds(300);
  lab.task(1, "general-gotoxyz", {Vector3(200, 0, 40)}, time);

  EXPECT_THAT(lab.reasons(), ::testing::HasSubstr("must end before 300 s"));
}

TEST(ClosedForATime, AWallForEverIsNotWaitedFor) {
  PlanningLab lab = with_wall(0, 1, -400, 400);
  lab.world.volumes[0].when = {};
  lab.task(1, "general-gotoxyz", {Vector3(200, 0, 40)});

  EXPECT_FALSE(lab.plan().has_value());
}

TEST(ClosedForATime, NobodyWaitsInAirThatWillBeClosed) {
  PlanningLab lab = with_wall(0, 100, -400, 400);
  lab.world.volumes.push_back({"here",
                               {{-30, -30}, {30, -30}, {30, 30}, {-30, 30}},
                               0,
                               500,
                               {MissionTime::seconds(50), MissionTime::max()}});
  lab.task(1, "general-gotoxyz", {Vector3(200, 0, 40)});

  EXPECT_FALSE(lab.plan().has_value());
}

}  // namespace
}  // namespace skein::supervisor
