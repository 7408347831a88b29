// SPDX-License-Identifier: Apache-2.0
// Of several devices and sides the first that refiners agree to is taken.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using namespace std::string_literals;
using testing::PlanningLab;
using world::Vector3;

mission::ElementaryPlan planned(const PlanningLab& lab) {
  auto plan = lab.plan();
  if (plan) return std::move(*plan);
  ADD_FAILURE() << lab.reasons();
  return {};
}

PlanningLab flying() {
  PlanningLab lab;
  lab.flying_at({0, 0, 40}).first_id(1);
  lab.world.places["tree"] = Vector3(250, 0, 0);
  return lab;
}

PlanningLab with_marvin() {
  PlanningLab lab = flying();
  lab.vehicle(testing::vehicle_of("scenarios/comets/models/marvin.yaml"));
  return lab;
}

std::string device_of(const mission::ElementaryTask& task) {
  const auto* device = task.parameters.find("device");
  return device == nullptr ? "none" : device->text;
}

TEST(PlanningChoice, ADeviceThatDoesNotReachLeavesItToTheNext) {
  PlanningLab lab = with_marvin();
  for (auto& sensor : lab.knowledge.vehicle.sensors) sensor.range = 300;
  world::SensorModel near = lab.knowledge.vehicle.sensors.at(0);
  near.device = "mapping";
  near.range = 10;
  lab.knowledge.vehicle.sensors = {near, lab.knowledge.vehicle.sensors.at(0)};
  lab.knowledge.vehicle.sensors[1].device = "singlecam";
  lab.knowledge.vehicle.sensors[1].aperture = 0.7;
  lab.task(7, "perform-mapping", {"Z2"s});

  EXPECT_EQ(device_of(planned(lab).tasks.back()), "singlecam");
}

TEST(PlanningChoice, AnotherSideServesWhenThereIsNoWayToTheBest) {
  PlanningLab lab = with_marvin();
  lab.task(7, "perceive", {"tree"s, 30.0});
  const Vector3 best = planned(lab).tasks.at(0).way.back();
  // A shell of closed air around the best viewpoint, which itself is free.
  const auto wall = [&](double west, double south, double east, double north) {
    lab.world.volumes.push_back({"wall " + std::to_string(lab.world.volumes.size()),
                                 {{best.x() + west, best.y() + south},
                                  {best.x() + east, best.y() + south},
                                  {best.x() + east, best.y() + north},
                                  {best.x() + west, best.y() + north}},
                                 0,
                                 300,
                                 {}});
  };
  wall(-60, -60, -40, 60);
  wall(40, -60, 60, 60);
  wall(-60, 40, 60, 60);
  wall(-60, -60, 60, -40);

  const auto plan = planned(lab);

  ASSERT_FALSE(plan.tasks.empty());
  EXPECT_GT((plan.tasks[0].way.back() - best).norm(), 40);
}

}  // namespace
}  // namespace skein::supervisor
