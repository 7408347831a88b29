// SPDX-License-Identifier: Apache-2.0
// Patterns, views, stays and takeoffs where air is closed for a time: it counts when it is met, and
// only then; it is waited for, on the ground rather than in the air, when that leads further.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <cmath>
#include <limits>

#include "skein/refiners/flight.hpp"
#include "testing/planned.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using namespace std::string_literals;
using mission::GoalId;
using refiners::Way;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::names_of;
using testing::planned;
using testing::PlanningLab;
using world::Vector2;
using world::Vector3;

using Names = std::vector<std::string>;

constexpr double kForEver = std::numeric_limits<double>::infinity();

world::TimeWindow window(double from, double until) {
  return {MissionTime::seconds(from),
          std::isinf(until) ? MissionTime::max() : MissionTime::seconds(until)};
}

world::Volume box(double west, double south, double east, double north, double from, double until) {
  return {"box",
          {{west, south}, {east, south}, {east, north}, {west, north}},
          0,
          500,
          window(from, until)};
}

/// At (0, 0, 40), 10 m/s fast; Z2 is x -140 to 160, y 60 to 260.
PlanningLab with(world::Volume volume) {
  PlanningLab lab;
  lab.flying_at({0, 0, 40}).first_id(1);
  lab.world.volumes.push_back(std::move(volume));
  return lab;
}

PlanningLab without() {
  PlanningLab lab;
  lab.flying_at({0, 0, 40}).first_id(1);
  return lab;
}

std::vector<Way> ways_of(const mission::ElementaryPlan& plan) {
  std::vector<Way> ways;
  for (const mission::ElementaryTask& task : plan.tasks)
    if (!task.way.empty()) ways.push_back(task.way);
  return ways;
}

// ---- what is not met does not count ----

TEST(AirWindows, ASweepThatIsOverBeforeTheAirClosesIsAsWithoutThat) {
  PlanningLab lab = with(box(-50, 100, 50, 200, 2000, kForEver)), free = without();
  lab.task(1, "perform-mapping", {"Z2"s});
  free.task(1, "perform-mapping", {"Z2"s});

  EXPECT_EQ(ways_of(planned(lab)), ways_of(planned(free)));
}

TEST(AirWindows, ADetectionThatBeginsAfterTheAirIsOpenAgainIsAsWithoutThat) {
  PlanningLab lab = with(box(-50, 100, 50, 200, 0, 30)), free = without();
  for (PlanningLab* one : {&lab, &free})
    one->task(1, "general-wait", {60.0}).task(2, "perform-detection", {"Z2"s, "P2"s, 100.0});

  EXPECT_EQ(ways_of(planned(lab)), ways_of(planned(free)));
}

TEST(AirWindows, APerceptionThatIsOverBeforeTheAirClosesIsFromTheSamePlace) {
  PlanningLab lab = with(box(-200, -200, 200, 300, 400, kForEver)), free = without();
  for (PlanningLab* one : {&lab, &free}) one->task(1, "perceive", {Vector3(100, 100, 0), 30.0});

  EXPECT_EQ(ways_of(planned(lab)), ways_of(planned(free)));
}

TEST(AirWindows, ATourBehindAWallThatOpensIsPlanned) {
  PlanningLab lab = with(box(100, -400, 130, 400, 0, 60));
  lab.world.places["near"] = Vector3(200, 0, 0);
  lab.world.places["far"] = Vector3(300, 0, 0);
  lab.task(1, "perform-tour", {Names{"far", "near"}});

  EXPECT_THAT(names_of(planned(lab)), ElementsAre("wait", "gotoxyz", "gotoxyz"));
}

TEST(AirWindows, ATourToAPlaceThatClosesLongAfterwardsIsPlanned) {
  PlanningLab lab = with(box(170, -30, 230, 30, 5000, 6000));
  lab.world.places["inside"] = Vector3(200, 0, 0);
  lab.task(1, "perform-tour", {Names{"inside"}});

  EXPECT_THAT(names_of(planned(lab)), ElementsAre("gotoxyz"));
}

TEST(AirWindows, ATourToAPlaceThatOpensWaitsForIt) {
  PlanningLab lab = with(box(170, -30, 230, 30, 0, 60));
  lab.world.places["inside"] = Vector3(200, 0, 0);
  lab.task(1, "perform-tour", {Names{"inside"}});

  EXPECT_THAT(names_of(planned(lab)), ElementsAre("wait", "gotoxyz"));
}

TEST(AirWindows, ATourIsToldThePlaceThatNeverOpens) {
  PlanningLab lab = with(box(170, -30, 230, 30, 0, kForEver));
  lab.world.places["inside"] = Vector3(200, 0, 0);
  lab.world.places["outside"] = Vector3(100, 100, 0);
  lab.task(1, "perform-tour", {Names{"outside", "inside"}});

  EXPECT_THAT(lab.reasons(), HasSubstr("stop 'inside' has no gate that is open"));
}

TEST(AirWindows, ATakeoffBeforeTheAirAboveItClosesIsPlanned) {
  PlanningLab lab = without();
  lab.situation = PlanningLab().situation;  // on the ground
  lab.world.volumes.push_back(box(-40, -40, 40, 40, 600, kForEver));
  lab.task(1, "general-gotoxyz", {Vector3(200, 0, 40)});

  EXPECT_THAT(names_of(planned(lab)), ElementsAre("takeoff", "gotoxyz"));
}

// ---- what is met is waited for ----

TEST(AirWindows, ADetectionOverAZoneThatIsClosedNowWaitsForIt) {
  PlanningLab lab = with(box(-145, 50, 165, 270, 0, 100));
  lab.task(1, "perform-detection", {"Z2"s, "P2"s, 60.0});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("wait", "gotoxyz", "gotoxyz", "takeshot"));
  EXPECT_EQ(plan.tasks[0].duration.least, Duration::seconds(100));
}

TEST(AirWindows, AMappingOfAZoneThatIsClosedInPartNowWaitsForIt) {
  PlanningLab lab = with(box(-145, 50, -40, 270, 0, 100));
  lab.task(1, "perform-mapping", {"Z2"s});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("wait", "gotoxyz", "gotoxyz", "takeshot"));
  EXPECT_EQ(plan.tasks[0].duration.least, Duration::seconds(100));
}

TEST(AirWindows, OnTheGroundTheWaitIsThere) {
  PlanningLab lab;
  lab.first_id(1);
  lab.world.volumes.push_back(box(100, -400, 130, 400, 0, 300));
  lab.task(1, "general-gotoxyz", {Vector3(200, 0, 40)});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), AnyOf(ElementsAre("wait", "takeoff", "gotoxyz"),
                                    ElementsAre("wait", "takeoff", "wait", "gotoxyz")));
  EXPECT_GE(plan.tasks[0].duration.least, Duration::seconds(290));
}

// Found by random missions (--closures --clean 2): by the time that it had waited less the climb
// the air was closed still, and the mapping was refused.
TEST(AirWindows, AMappingFromTheGroundWaitsThereUntilTheAirIsOpenWhenItHasClimbed) {
  PlanningLab lab;
  lab.first_id(1);
  lab.world.volumes.push_back(box(-145, 50, -40, 270, 0, 300));
  lab.task(1, "perform-mapping", {"Z2"s});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan),
              AnyOf(ElementsAre("wait", "takeoff", "gotoxyz", "gotoxyz", "takeshot"),
                    ElementsAre("wait", "takeoff", "wait", "gotoxyz", "gotoxyz", "takeshot")));
  EXPECT_GE(plan.tasks[0].duration.least, Duration::seconds(280));
}

// Found by random missions (--closures --clean 14): neither place could be waited for at the other.
TEST(AirWindows, ATourWhosePlacesAreNeverOpenOneAfterTheOtherIsFlownOnceBothAre) {
  PlanningLab lab;
  lab.first_id(1);
  lab.world.volumes.push_back(box(150, -50, 250, 50, 0, 131));
  lab.world.volumes.push_back(box(-50, 150, 50, 250, 60, 544));
  lab.task(1, "perform-tour", {Names{"pa", "pb"}});
  lab.world.places["pa"] = {200, 0, 0};
  lab.world.places["pb"] = {0, 200, 0};

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan),
              AnyOf(ElementsAre("wait", "wait", "takeoff", "gotoxyz", "gotoxyz"),
                    ElementsAre("wait", "wait", "takeoff", "wait", "gotoxyz", "gotoxyz")));
  const Duration on_the_ground = plan.tasks[0].duration.least + plan.tasks[1].duration.least;
  EXPECT_GE(on_the_ground, Duration::seconds(500));
}

// Found by random missions (--closures --clean 37): nobody can wait above its pad, but on it.
TEST(AirWindows, APlaceToLookFromIsWaitedForOnTheGroundWhereTheAirAboveItClosesMeanwhile) {
  PlanningLab lab;
  lab.first_id(1);
  lab.world.volumes.push_back(box(60, -400, 600, 400, 0, 200));
  lab.world.volumes.push_back(box(-40, -40, 40, 40, 150, 250));
  lab.world.places["pa"] = {300, 0, 0};
  lab.task(1, "perceive", {"pa"s, 30.0});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("wait", "wait", "takeoff", "gotoxyz", "perception"));
  EXPECT_GE(plan.tasks[0].duration.least + plan.tasks[1].duration.least, Duration::seconds(220));
}

TEST(AirWindows, ATakeoffWaitsForTheAirAboveIt) {
  PlanningLab lab;
  lab.first_id(1);
  lab.world.volumes.push_back(box(-40, -40, 40, 40, 0, 120));
  lab.task(1, "general-takeoff");

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("wait", "takeoff"));
  EXPECT_EQ(plan.tasks[0].duration.least, Duration::seconds(120));
}

TEST(AirWindows, ALookIsTakenFromAnotherSideWhenTheBestClosesMeanwhile) {
  PlanningLab free = without();
  free.task(1, "perceive", {Vector3(100, 100, 0), 60.0});
  const Vector3 best = planned(free).tasks.at(0).way.back();
  PlanningLab lab = with(box(best.x() - 15, best.y() - 15, best.x() + 15, best.y() + 15, 40, 900));
  lab.task(1, "perceive", {Vector3(100, 100, 0), 60.0});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("gotoxyz", "perception"));
  const Vector3 at = plan.tasks[0].way.back();
  EXPECT_GT((at - best).head<2>().lpNorm<Eigen::Infinity>(), 15);
}

TEST(AirWindows, AWaitWhereTheAirClosesMeanwhileIsRefused) {
  PlanningLab lab = with(box(-40, -40, 40, 40, 100, 300));
  lab.task(1, "general-wait", {200.0});

  EXPECT_FALSE(lab.plan().has_value());
  EXPECT_THAT(lab.reasons(), HasSubstr("closes before it is done there"));
}

// ---- laws of every plan ----

double length_of(const Way& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return length;
}

/// Independent of all planning: the way as straight pieces in steps of a metre, each closed from
/// when the task may begin until its vehicle may last be there: what is left of the way takes as
/// long as at its greatest speed, in calm air.
bool is_met(const world::Volume& volume, const mission::ElementaryTask& task, double fastest) {
  const bool ends = task.duration.most != Duration::max() && task.start.most != Duration::max();
  const MissionTime from = MissionTime() + task.start.least;
  double left = length_of(task.way);
  for (std::size_t i = 1; i < task.way.size(); ++i) {
    const Vector3 step = task.way[i] - task.way[i - 1];
    const int steps = 1 + static_cast<int>(step.norm());
    for (int k = 0; k <= steps; ++k) {
      const Vector3 at = task.way[i - 1] + step * k / steps;
      const Duration rest = Duration::seconds((left - step.norm() * k / steps) / fastest);
      const MissionTime until =
          ends ? MissionTime() + task.start.most + task.duration.most - rest : MissionTime::max();
      if (volume.when.overlaps({from, until}) && at.z() > volume.floor && at.z() < volume.ceiling &&
          world::contains(volume.polygon, Vector2(at.head<2>())))
        return true;
    }
    left -= step.norm();
  }
  return false;
}

mission::HighLevelTask goal_of(int which) {
  const GoalId id(7);
  switch (which) {
    case 0:
      return {id, "perform-mapping", {"Z2"s}, {}};
    case 1:
      return {id, "perform-detection", {"Z2"s, "P2"s, 60.0}, {}};
    case 2:
      return {id, "perceive", {Vector3(120, 150, 0), 40.0}, {}};
    case 3:
      return {id, "perform-monitoring", {Vector3(-100, 150, 0), 60.0}, {}};
    default:
      return {id, "general-gotoxyz", {Vector3(150, 200, 60)}, {}};
  }
}

RC_GTEST_PROP(AirWindowsLaw, NoWayOfAPlanMeetsAirThatMayBeClosedThen, ()) {
  PlanningLab lab = without();
  if (*rc::gen::arbitrary<bool>()) lab.situation = PlanningLab().situation;
  lab.first_id(1);
  const int count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i) {
    const double west = *rc::gen::inRange(-300, 200), south = *rc::gen::inRange(-50, 250);
    const double from = *rc::gen::inRange(0, 200);
    world::Volume one =
        box(west, south, west + *rc::gen::inRange(20, 200), south + *rc::gen::inRange(20, 150),
            from, from + *rc::gen::inRange(10, 300));
    one.name = "box" + std::to_string(i);
    if (world::contains(one.polygon, Vector2(0, 0))) continue;
    lab.world.volumes.push_back(one);
  }
  lab.tasks.push_back(goal_of(*rc::gen::inRange(0, 5)));

  const auto plan = lab.plan();

  RC_TAG(plan ? "planned"s : "refused"s);
  if (!plan) return;
  for (const world::Volume& volume : lab.world.volumes)
    for (const mission::ElementaryTask& task : plan->tasks)
      if (is_met(volume, task, lab.knowledge.vehicle.max_speed))
        RC_FAIL(volume.name + " is met by " + task.name + " of " + lab.taskreq());
}

RC_GTEST_PROP(AirWindowsLaw, WhatIsOverBeforeItBeginsOrClosesLongAfterChangesNothing, ()) {
  PlanningLab lab = without(), free = without();
  const double west = *rc::gen::inRange(-300, 200), south = *rc::gen::inRange(-50, 250);
  const bool past = *rc::gen::arbitrary<bool>();
  lab.world.volumes.push_back(
      box(west, south, west + 100, south + 80, past ? 0 : 20'000, past ? 50 : 30'000));
  const auto goal = goal_of(*rc::gen::inRange(0, 5));
  for (PlanningLab* one : {&lab, &free}) {
    one->tasks.push_back({GoalId(1), "general-wait", {past ? 55.0 : 1.0}, {}});
    one->tasks.push_back(goal);
  }
  if (world::contains(lab.world.volumes[0].polygon, Vector2(0, 0))) return;

  const auto plan = lab.plan(), same = free.plan();

  RC_ASSERT(plan.has_value() == same.has_value());
  if (plan) RC_ASSERT(ways_of(*plan) == ways_of(*same));
}

}  // namespace
}  // namespace skein::supervisor
