// SPDX-License-Identifier: Apache-2.0
#include "interaction/planned_state.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace skein::decision_node {
namespace {

using executive::TaskId;
using mission::Dependence;
using mission::DependenceKind;
using mission::PlannedTask;
using world::Vector3;

MissionTime instant(double seconds) { return MissionTime::seconds(seconds); }

PlannedTask planned(std::uint64_t id, const std::string& type, double start, double end,
                    std::optional<Vector3> to = {}, double energy = 0) {
  PlannedTask result;
  result.task.id = TaskId(id);
  result.task.type = type;
  result.task.energy = energy;
  if (to) result.task.way = {*to};
  if (id > 1) result.task.dependences = {{DependenceKind::kEnded, TaskId(id - 1)}};
  result.dates = {instant(start), instant(start), instant(end), instant(end)};
  return result;
}

class WhenTheJointTaskBegins : public ::testing::Test {
 protected:
  WhenTheJointTaskBegins() {
    plan_.tasks = {planned(1, "takeoff", 0, 20, Vector3(0, 0, 40), 0.01),
                   planned(2, "goto", 20, 120, Vector3(500, 0, 40), 0.1),
                   planned(3, "joint:watching", 200, 300),
                   planned(4, "goto", 300, 400, Vector3(0, 0, 40), 0.1)};
    vehicle_.hovers = true;
    vehicle_.energy.capacity = 1000;
    vehicle_.energy.hover_power = 1;
    seen_.energy = 0.9;
  }
  world::VehicleState then(double now, std::uint64_t task = 3) const {
    return planned_state(seen_, plan_, TaskId(task), vehicle_, instant(now));
  }

  mission::PlanReport plan_;
  world::VehicleModel vehicle_;
  world::VehicleState seen_;
};

TEST_F(WhenTheJointTaskBegins, ItIsWhereTheTasksBeforeItEnd) {
  EXPECT_EQ(then(0).position, Vector3(500, 0, 40));
  EXPECT_TRUE(then(0).airborne);
}

TEST_F(WhenTheJointTaskBegins, WhatComesBeforeItAndTheWaitForItHaveDrawnEnergy) {
  EXPECT_NEAR(then(0).energy, 0.9 - 0.01 - 0.1 - 80 * 1 / 1000.0, 1e-9);
}

TEST_F(WhenTheJointTaskBegins, OfWhatIsUnderWayOnlyTheRestCounts) {
  EXPECT_NEAR(then(70).energy, 0.9 - 0.05 - 80 * 1 / 1000.0, 1e-9);
}

TEST_F(WhenTheJointTaskBegins, WhatIsOverCountsNoMore) {
  seen_.position = Vector3(480, 10, 40);
  seen_.airborne = true;
  EXPECT_EQ(then(130).position, seen_.position);
  EXPECT_NEAR(then(130).energy, 0.9 - 70 * 1 / 1000.0, 1e-9);
}

TEST_F(WhenTheJointTaskBegins, WhatIsInThePlanForOtherGoalsIsNotBeforeIt) {
  PlannedTask other = planned(9, "goto", 300, 400, Vector3(-900, 0, 40));
  other.task.dependences = {{DependenceKind::kEnded, TaskId(4)}};
  plan_.tasks.push_back(other);
  EXPECT_EQ(then(0).position, Vector3(500, 0, 40));
}

TEST_F(WhenTheJointTaskBegins, JointTasksBeforeItAreThoseForWhichItWaits) {
  plan_.tasks.push_back(planned(5, "joint:watching", 400, 500));
  PlannedTask other = planned(9, "joint:watching", 100, 200);
  other.task.dependences = {};
  plan_.tasks.push_back(other);
  EXPECT_EQ(joint_tasks_before(plan_, TaskId(5)), std::vector<TaskId>{TaskId(3)});
  EXPECT_TRUE(joint_tasks_before(plan_, TaskId(3)).empty());
  EXPECT_TRUE(joint_tasks_before(plan_, TaskId(77)).empty()) << "the plan does not know it";
}

TEST_F(WhenTheJointTaskBegins, ATaskThatThePlanDoesNotKnowBeginsFromHere) {
  seen_.position = Vector3(7, 8, 9);
  EXPECT_EQ(then(0, 33).position, seen_.position);
  EXPECT_EQ(then(0, 33).energy, seen_.energy);
}

TEST_F(WhenTheJointTaskBegins, NobodyHasLessThanNoEnergy) {
  seen_.energy = 0.05;
  EXPECT_EQ(then(0).energy, 0);
}

TEST_F(WhenTheJointTaskBegins, APlanThatGoesRoundInACircleEndsAllTheSame) {
  plan_.tasks[0].task.dependences = {{DependenceKind::kEnded, TaskId(2)}};
  EXPECT_EQ(then(0).position, Vector3(500, 0, 40));
}

}  // namespace
}  // namespace skein::decision_node
