// SPDX-License-Identifier: Apache-2.0
// Insertion and repair with planner, refiners and the domain of COMETS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "flight/retreat.hpp"
#include "insertion/parts.hpp"
#include "skein/foundation/random.hpp"
#include "skein/supervisor/repair.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Goals = std::vector<mission::HighLevelTask>;

/// Brute force takes a second for each; SKEIN_LAYOUTS=60 for all that were measured.
int layouts() {
  const char* asked = std::getenv("SKEIN_LAYOUTS");
  return asked != nullptr ? std::max(std::atoi(asked), 1) : 2;
}

mission::HighLevelTask shot(std::uint64_t id, const world::Vector3& at) {
  return {mission::GoalId(id), "general-combined-goto-and-takeshot", {at, 20.0}, {}};
}
mission::HighLevelTask land(std::uint64_t id) {
  return {mission::GoalId(id), "general-land", {}, {}};
}

/// In the air over home.
PlanningLab airborne_lab() {
  PlanningLab lab;
  lab.flying_at(lab.knowledge.home + world::Vector3(0, 0, lab.knowledge.altitude));
  return lab;
}

double cost_of(const PlanningLab& lab, const Goals& order) {
  PlanningRequest request = lab.request();
  request.tasks = order;
  const auto plan = plan_tasks(request);
  return plan ? plan->cost : std::numeric_limits<double>::infinity();
}

double least_cost(const PlanningLab& lab, Goals goals) {
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  const Goals last(goals.begin() + 5, goals.end());
  Goals five(goals.begin(), goals.begin() + 5);
  double least = std::numeric_limits<double>::infinity();
  std::sort(five.begin(), five.end(), by_id);
  do {
    Goals order = five;
    order.insert(order.end(), last.begin(), last.end());
    least = std::min(least, cost_of(lab, order));
  } while (std::next_permutation(five.begin(), five.end(), by_id));
  return least;
}

double inserted_one_by_one(const PlanningLab& lab, const Goals& goals) {
  InsertionRequest request{lab.request(), {}, {}, {}, mission::Placement::kBest};
  std::optional<mission::ElementaryPlan> plan;
  for (auto goal = goals.rbegin(); goal != goals.rend(); ++goal) {
    request.added = {*goal};
    InsertionOutcome outcome = insert_tasks(request);
    if (!outcome.plan) return std::numeric_limits<double>::infinity();
    request.planned = std::move(outcome.order);
    plan = std::move(outcome.plan);
  }
  return plan->cost;
}

TEST(InsertionOfScatteredTasks, OneByOneCostsAtMostThreeTenthsMoreThanTheBestOrderOfAll) {
  const PlanningLab lab = airborne_lab();
  double worst = 0, sum = 0;

  for (int layout = 0; layout < layouts(); ++layout) {
    Random random(static_cast<std::uint64_t>(layout), "layout");
    Goals goals;
    for (std::uint64_t id = 1; id <= 5; ++id)
      goals.push_back(shot(id, {random.uniform(-300, 300), random.uniform(-300, 300), 40}));
    if (layout % 2 == 0) goals.push_back(land(6));
    const double ratio = inserted_one_by_one(lab, goals) / least_cost(lab, goals);
    worst = std::max(worst, ratio);
    sum += ratio;
    EXPECT_LE(ratio, 1.3) << "layout " << layout;
  }

  std::cout << "cost of one by one to the best of all: mean " << sum / layouts() << ", worst "
            << worst << '\n';
}

// ---- a mapping in parts ----

mission::HighLevelTask mapping(std::uint64_t id) {
  return {mission::GoalId(id), "perform-mapping", {"Z2"}, {}};
}

std::vector<std::string> names_of(const Goals& order) {
  std::vector<std::string> names;
  for (const auto& goal : order) names.push_back(goal.name);
  return names;
}

/// Of a plan of these tasks alone, as it is foreseen: when the last of them is over at the latest.
MissionTime end_of(const PlanningLab& lab, const Goals& goals) {
  InsertionRequest request{lab.request(), {}, {}, goals, mission::Placement::kLast};
  return insert_tasks(request).schedule.latest_end;
}

/// Of a mapping that must be over soon and a look in the middle of it.
InsertionRequest amid_a_mapping(const PlanningLab& lab) {
  const Duration whole = end_of(lab, {mapping(1)}) - MissionTime();
  const Duration both = end_of(lab, {mapping(1), shot(2, {60, 60, 40})}) - MissionTime();
  mission::HighLevelTask look = shot(2, {60, 60, 40});
  look.time.start_after = MissionTime() + Duration::seconds(0.45 * whole.to_seconds());
  look.time.end_before = MissionTime() + Duration::seconds(0.9 * whole.to_seconds());
  mission::HighLevelTask map = mapping(1);
  map.time.end_before = MissionTime() + both + Duration::seconds(0.3 * whole.to_seconds());
  InsertionRequest request{lab.request(), {}, {map}, {look}, mission::Placement::kBest};
  request.part = mission::GoalId(900);
  return request;
}

TEST(InsertionInParts, WhatFitsNeitherBeforeNorBehindAMappingHasItsPlaceAmidIt) {
  const InsertionRequest request = amid_a_mapping(airborne_lab());

  const auto outcome = insert_tasks(request);

  ASSERT_TRUE(outcome.plan) << outcome.reasons.front();
  EXPECT_THAT(names_of(outcome.order),
              ElementsAre("map-part", "general-combined-goto-and-takeshot", "perform-mapping"));
  EXPECT_EQ(outcome.order.front().id, mission::GoalId(900));
  EXPECT_EQ(whole_of(outcome.order.front()), mission::GoalId(1));
  EXPECT_TRUE(outcome.schedule.controllable);
  EXPECT_LE(outcome.schedule.latest_end, *request.planned[0].time.end_before);
}

TEST(InsertionInParts, IsTriedOnlyBehindAllOrdersOfTheWholeAndSaysWhatItTried) {
  const auto outcome = insert_tasks(amid_a_mapping(airborne_lab()));

  bool parts = false;
  for (const Trial& trial : outcome.trials) {
    EXPECT_FALSE(parts && trial.part == 0) << "a whole order behind one in parts";
    parts = parts || trial.part > 0;
    EXPECT_TRUE(trial.part > 0 || !trial.feasible);
  }
  EXPECT_TRUE(parts);
}

TEST(InsertionInParts, WithoutANumberForThePartTheMissionIsRefused) {
  InsertionRequest request = amid_a_mapping(airborne_lab());
  request.part.reset();

  EXPECT_FALSE(insert_tasks(request).plan);
}

TEST(InsertionInParts, AMissionAskedInOneOrderHasItsLookAmidTheMapping) {
  InsertionRequest request = amid_a_mapping(airborne_lab());
  request.added = {request.planned[0], request.added[0]};
  request.added[0].time = {};
  request.added[1].time.start_after.reset();
  request.planned.clear();

  const auto outcome = insert_tasks(request);

  ASSERT_TRUE(outcome.plan) << outcome.reasons.front();
  EXPECT_THAT(names_of(outcome.order),
              ElementsAre("map-part", "general-combined-goto-and-takeshot", "perform-mapping"));
}

TEST(InsertionInParts, WhatCannotBeInTimeEvenSoIsRefusedWithReasonsOfTheGoalsAskedFor) {
  InsertionRequest request = amid_a_mapping(airborne_lab());
  request.added[0].time.start_after.reset();
  request.added[0].time.end_before = MissionTime::seconds(5);

  const auto outcome = insert_tasks(request);

  EXPECT_FALSE(outcome.plan);
  for (const Dropped& one : outcome.dropped) EXPECT_NE(one.goal, mission::GoalId(900)) << one.why;
}

TEST(InsertionInParts, APartThatIsPlannedStaysBeforeItsMappingInATour) {
  const PlanningLab lab = airborne_lab();
  const auto first = insert_tasks(amid_a_mapping(lab));
  ASSERT_TRUE(first.plan);
  Goals planned = first.order;
  for (auto& goal : planned) goal.time = {};
  InsertionRequest request{
      lab.request(), {}, planned, {shot(3, {-60, 20, 40})}, mission::Placement::kTour};

  const auto outcome = insert_tasks(request);

  ASSERT_TRUE(outcome.plan);
  const auto names = names_of(outcome.order);
  const auto part = std::find(names.begin(), names.end(), "map-part");
  EXPECT_LT(part, std::find(names.begin(), names.end(), "perform-mapping"));
}

TEST(RepairOnRealGround, AClosedGoalIsDroppedAndTheRestStays) {
  PlanningLab lab = airborne_lab();
  world::Volume closed;
  closed.name = "closed";
  closed.polygon = {{90, 90}, {130, 90}, {130, 130}, {90, 130}};
  lab.world.volumes.push_back(closed);
  RepairRequest request;
  request.base = lab.request();
  request.failed = shot(1, {110, 110, 40});
  request.remaining = {shot(2, {-100, 50, 40}), land(3)};

  const auto outcome = repair_plan(request);

  EXPECT_EQ(outcome.served, RepairStep::kDrop);
  ASSERT_TRUE(outcome.plan);
  ASSERT_EQ(outcome.dropped.size(), 1U);
  EXPECT_THAT(outcome.dropped[0].why, HasSubstr("closed"));
}

TEST(RepairOnRealGround, ShortOfEnergyTheFarthestIsLeftOutAndItStillLands) {
  PlanningLab lab = airborne_lab();
  const Goals goals = {shot(1, {50, 0, 40}), shot(2, {300, 300, 40}), land(3)};
  PlanningRequest all = lab.request();
  all.tasks = goals;
  const auto plan = plan_tasks(all);
  ASSERT_TRUE(plan);
  lab.situation.energy = lab.knowledge.vehicle.energy.reserve + kSpareEnergy + 0.9 * plan->energy;
  RepairRequest request;
  request.base = lab.request();
  request.remaining = goals;

  const auto outcome = repair_plan(request);

  EXPECT_EQ(outcome.served, RepairStep::kReplan);
  ASSERT_EQ(outcome.order.size(), 2U);
  EXPECT_EQ(outcome.order[0].id, mission::GoalId(1));
  EXPECT_EQ(outcome.order[1].id, mission::GoalId(3));
}

TEST(RepairOnRealGround, WithoutADeviceThatServesWhatNeedsItIsLeftOut) {
  PlanningLab lab = airborne_lab();
  for (const auto& sensor : lab.knowledge.vehicle.sensors)
    lab.situation.broken.insert(sensor.device);
  RepairRequest request;
  request.base = lab.request();
  request.remaining = {shot(1, {50, 0, 40}), land(3)};

  const auto outcome = repair_plan(request);

  EXPECT_EQ(outcome.served, RepairStep::kReplan);
  ASSERT_EQ(outcome.order.size(), 1U);
  EXPECT_EQ(outcome.order[0].id, mission::GoalId(3));
  EXPECT_THAT(outcome.dropped[0].why, HasSubstr("does not work"));
}

TEST(RepairOnRealGround, AnotherDeviceServesInPlaceOfABrokenOne) {
  PlanningLab lab = airborne_lab();
  world::SensorModel other = lab.knowledge.vehicle.sensors.front();
  const std::string broken = other.device;
  other.device = broken == "visible" ? "ir" : "visible";
  lab.knowledge.vehicle.sensors.push_back(other);
  lab.situation.broken = {broken};
  RepairRequest request;
  request.base = lab.request();
  request.failed = shot(1, {50, 0, 40});

  const auto outcome = repair_plan(request);

  EXPECT_EQ(outcome.served, RepairStep::kRefine);
}

}  // namespace
}  // namespace skein::supervisor::testing
