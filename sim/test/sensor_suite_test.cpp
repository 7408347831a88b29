// SPDX-License-Identifier: Apache-2.0
#include "sensor_suite.hpp"

#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::an_object;
using testing::at;
using testing::flat;
using testing::model_of;

/// The sensors of Marvin over a fire, and what they say.
struct Suite {
  void start(std::uint64_t id, TakeshotTask task) {
    sensors.start(TaskId(id), std::move(task), at(now), board, effects);
  }
  void run_until(double until) {
    for (; now <= until + 1e-9; now += 0.1)
      sensors.step(state, 0, {terrain, objects}, at(now), board, effects);
  }
  template <class Kind>
  std::vector<Kind> all() const {
    std::vector<Kind> found;
    for (const Effect& effect : effects)
      if (const auto* kind = std::get_if<Kind>(&effect)) found.push_back(*kind);
    return found;
  }

  world::Terrain terrain = flat();
  std::vector<world::WorldObject> objects = {an_object("fire", 0, 0)};
  world::VehicleState state = {{0, 0, 40}, {0, 0, 0}, 0, 1, true, ""};
  SensorSuite sensors{model_of("marvin"), "marvin", 1};
  StatusBoard board{"marvin"};
  std::vector<Effect> effects;
  double now = 0;
};

TakeshotTask shot_with(const std::string& device) { return {device, {}, {}, {}}; }

TEST(SensorSuite, LooksAtOnceThenEachPeriod) {
  Suite s;

  s.start(1, shot_with("visible"));
  s.run_until(4.05);

  std::vector<double> times;
  for (const auto& out : s.all<PerceptionOut>()) times.push_back(out.perception.at.to_seconds());
  ASSERT_EQ(times.size(), 5u);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(times[i], static_cast<double>(i), 0.11);
}

TEST(SensorSuite, APerceptionSaysWhereItLooked) {
  Suite s;

  s.start(1, shot_with("fire-sensor"));
  s.run_until(0);

  ASSERT_EQ(s.all<PerceptionOut>().size(), 1u);
  const world::Perception perception = s.all<PerceptionOut>()[0].perception;
  EXPECT_EQ(perception.uav, "marvin");
  EXPECT_EQ(perception.device, "fire-sensor");
  EXPECT_EQ(perception.viewpoint, world::Vector3(0, 0, 40));
  EXPECT_NEAR(perception.direction.z(), -1, 1e-9);
  EXPECT_EQ(perception.range, 120);
  EXPECT_EQ(perception.aperture, 0.8);
}

TEST(SensorSuite, EndsAfterItsShots) {
  Suite s;
  TakeshotTask task = shot_with("visible");
  task.shots = 3;

  s.start(1, task);
  s.run_until(10);

  EXPECT_EQ(s.all<PerceptionOut>().size(), 3u);
  ASSERT_EQ(s.all<FunctionalStatus>().size(), 2u);
  EXPECT_EQ(s.all<FunctionalStatus>()[1].status.state, TaskState::kEnded);
}

TEST(SensorSuite, EndsAfterItsDuration) {
  Suite s;
  TakeshotTask task = shot_with("visible");
  task.duration = Duration::seconds(2.5);

  s.start(1, task);
  s.run_until(10);

  EXPECT_EQ(s.all<PerceptionOut>().size(), 3u);
  EXPECT_NEAR(s.all<FunctionalStatus>().back().at.to_seconds(), 2.5, 0.11);
}

TEST(SensorSuite, InterruptionIsConfirmedAtOnce) {
  Suite s;
  s.start(1, shot_with("visible"));
  s.run_until(2);

  EXPECT_TRUE(s.sensors.interrupt(TaskId(1), at(2), s.board, s.effects));
  EXPECT_FALSE(s.sensors.interrupt(TaskId(1), at(2), s.board, s.effects)) << "it runs no more";

  EXPECT_EQ(s.all<FunctionalStatus>().back().status.state, TaskState::kAborted);
  EXPECT_EQ(s.all<FunctionalStatus>().back().status.reason, "interrupted");
}

TEST(SensorSuite, ADeviceRunsOneTaskDevicesRunTogether) {
  Suite s;
  s.start(1, shot_with("visible"));

  EXPECT_EQ(s.sensors.refusal("visible"), "device 'visible' is in use by task 1");
  EXPECT_EQ(s.sensors.refusal("fire-sensor"), std::nullopt);
}

TEST(SensorSuite, ABrokenDeviceAbortsItsTaskAndStaysBroken) {
  Suite s;
  s.start(1, shot_with("visible"));
  s.start(2, shot_with("fire-sensor"));

  s.sensors.break_device("visible", at(1), s.board, s.effects);

  EXPECT_EQ(s.all<FunctionalStatus>().back().status.id, TaskId(1));
  EXPECT_EQ(s.all<FunctionalStatus>().back().status.reason, "device 'visible' has failed");
  EXPECT_EQ(s.sensors.refusal("visible"), "device 'visible' has failed");
}

TEST(SensorSuite, OneDeviceDoesNotDisturbTheChancesOfAnother) {
  const auto seen_by_fire_sensor = [](bool also_visible) {
    Suite s;
    s.start(1, shot_with("fire-sensor"));
    if (also_visible) s.start(2, shot_with("visible"));
    s.run_until(30);
    std::vector<world::Perception> seen;
    for (const auto& out : s.all<PerceptionOut>())
      if (out.perception.device == "fire-sensor") seen.push_back(out.perception);
    return seen;
  };

  EXPECT_EQ(seen_by_fire_sensor(false), seen_by_fire_sensor(true));
}

TEST(SensorSuite, KnowsWhereTheFirstTargetIs) {
  Suite s;
  EXPECT_EQ(s.sensors.target(), std::nullopt);
  TakeshotTask task = shot_with("visible");
  task.target = world::Vector3(7, 8, 0);

  s.start(1, task);

  EXPECT_EQ(s.sensors.target(), world::Vector2(7, 8));
}

}  // namespace
}  // namespace skein::sim
