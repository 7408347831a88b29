// SPDX-License-Identifier: Apache-2.0
#include "sensing.hpp"

#include <rapidcheck/gtest.h>

#include <numbers>
#include <set>

#include "skein/world/ground_normal.hpp"
#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::an_object;
using testing::at;
using testing::flat;
using testing::model_of;
using testing::with_hill;
using world::Vector3;

constexpr double kPi = std::numbers::pi;

world::VehicleState over(double x, double y, double z, double heading = 0) {
  world::VehicleState state;
  state.position = {x, y, z};
  state.heading = heading;
  return state;
}

world::SensorModel a_sensor() {
  world::SensorModel sensor;
  sensor.device = "eye";
  sensor.aperture = 0.5;
  sensor.boresight_pitch = -kPi / 2;
  sensor.range = 100;
  sensor.period = Duration::milliseconds(1000);
  sensor.position_spread = 2;
  sensor.responses["fire"] = {1, 0.8, "fire"};
  return sensor;
}

TEST(Sensing, VisibilityIsGeometry) {
  struct Case {
    const char* what;
    Vector3 from;
    double x, y;
    double radius;
    bool visible;
  };
  const double reach = 50 * std::tan(0.5);  // on the ground, from 50 m up
  const std::vector<Case> cases = {
      {"straight below", {0, 0, 50}, 0, 0, 0, true},
      {"just inside the cone", {0, 0, 50}, reach - 0.1, 0, 0, true},
      {"just outside the cone", {0, 0, 50}, reach + 0.1, 0, 0, false},
      {"outside, but large enough to show its edge", {0, 0, 50}, reach + 0.1, 0, 3, true},
      {"behind", {0, 0, 50}, 0, -60, 0, false},
      {"at the limit of the range", {0, 0, 99.9}, 0, 0, 0, true},
      {"out of range", {0, 0, 100.1}, 0, 0, 0, false},
      {"out of range, but its top is not", {0, 0, 102}, 0, 0, 3, true},
  };
  for (const Case& c : cases) {
    world::WorldObject object = an_object("fire", c.x, c.y);
    object.radius = c.radius;
    const world::View view{c.from, -Vector3::UnitZ(), 100, 0.5};
    EXPECT_EQ(is_visible(view, object, at(0), flat()), c.visible) << c.what;
  }
}

TEST(Sensing, AHillHidesWhatIsBehindIt) {
  const world::Terrain terrain = with_hill(100, 0, 60, 60);
  const world::View view{
      {0, 0, 30}, (Vector3(200, 0, 0) - Vector3(0, 0, 30)).normalized(), 500, 0.5};

  EXPECT_FALSE(is_visible(view, an_object("fire", 200, 0), at(0), terrain));
  EXPECT_TRUE(is_visible(view, an_object("fire", 200, 0), at(0), flat()));
  EXPECT_TRUE(is_visible(view, an_object("fire", 60, 0), at(0), terrain)) << "the near side";
}

TEST(Sensing, WhatHasNotAppearedIsNotVisible) {
  world::WorldObject object = an_object("fire", 0, 0);
  object.appears = at(10);
  object.disappears = at(20);
  const world::View view{{0, 0, 50}, -Vector3::UnitZ(), 100, 0.5};

  EXPECT_FALSE(is_visible(view, object, at(9.9), flat()));
  EXPECT_TRUE(is_visible(view, object, at(10), flat()));
  EXPECT_FALSE(is_visible(view, object, at(20), flat()));
}

TEST(Sensing, AFixedSensorLooksWhereTheVehicleHeads) {
  world::SensorModel sensor = a_sensor();
  sensor.boresight_pitch = 0;

  const world::View view = view_of(sensor, over(0, 0, 50, kPi / 2), Vector3(100, 0, 0), 0);

  EXPECT_NEAR((view.direction - Vector3(0, 1, 0)).norm(), 0, 1e-12);
}

TEST(Sensing, AGimballedSensorLooksAtItsTarget) {
  world::SensorModel sensor = a_sensor();
  sensor.gimballed = true;
  const Vector3 target(30, -40, 0);

  const world::View view = view_of(sensor, over(0, 0, 50, 1), target, 0);

  EXPECT_NEAR((view.direction - (target - Vector3(0, 0, 50)).normalized()).norm(), 0, 1e-12);
}

TEST(Sensing, APointingErrorTurnsTheViewAside) {
  world::SensorModel sensor = a_sensor();
  sensor.gimballed = true;

  const world::View view = view_of(sensor, over(0, 0, 50), Vector3(50, 0, 50), 0.1);

  EXPECT_NEAR(std::acos(view.direction.x()), 0.1, 1e-9);
}

TEST(Sensing, DetectsAndMissesAsOftenAsTheModelSays) {
  const world::Terrain terrain = flat();
  for (const double probability : {0.0, 0.3, 0.7, 1.0}) {
    world::SensorModel sensor = a_sensor();
    sensor.responses["fire"].probability = probability;
    const std::vector<world::WorldObject> objects = {an_object("fire", 0, 0)};
    const world::View view = view_of(sensor, over(0, 0, 50), std::nullopt, 0);
    Random random(11);
    const int n = 10000;

    int seen = 0;
    for (int i = 0; i < n; ++i)
      seen += static_cast<int>(look(sensor, view, {terrain, objects}, at(i), random).size());

    // Four deviations of a binomial.
    const double deviation = std::sqrt(probability * (1 - probability) / n);
    EXPECT_NEAR(seen / static_cast<double>(n), probability, 4 * deviation + 1e-12);
  }
}

TEST(Sensing, WithoutAModelOfQualityAllThatIsInViewIsPerceivedWholly) {
  const world::Terrain terrain = with_hill(0, 0, 60, 90);
  const world::SensorModel sensor = a_sensor();
  const world::WorldObject edge = an_object("fire", 0, 0);  // its radius reaches into the range

  EXPECT_EQ(quality_of(sensor, {0, 0, 60 + 103}, edge, at(0), terrain), 1);
  EXPECT_EQ(quality_of(sensor, {0, 0, 61}, edge, at(0), terrain), 1);
  EXPECT_EQ(quality_of(sensor, {0, 0, 0}, edge, at(0), terrain), 1);
}

TEST(Sensing, TheNearestPartOfAnObjectIsWhatIsPerceived) {
  world::SensorModel sensor = a_sensor();
  sensor.quality = {20, 0.2, 0};
  world::WorldObject object = an_object("fire", 0, 0);
  object.radius = 10;

  EXPECT_DOUBLE_EQ(quality_of(sensor, {0, 0, 70}, object, at(0), flat()), 0.6);
  EXPECT_DOUBLE_EQ(quality_of(sensor, {0, 0, 110}, object, at(0), flat()), 0.2);
  EXPECT_EQ(quality_of(sensor, {0, 0, 30}, object, at(0), flat()), 1);
  EXPECT_EQ(quality_of(sensor, {0, 0, 5}, object, at(0), flat()), 1) << "from within it";
}

TEST(Sensing, WhatIsOverTheGroundIsNotInclinedAsItIs) {
  const world::Terrain terrain = with_hill(0, 0, 60, 120);
  world::SensorModel sensor = a_sensor();
  sensor.quality.incidence_power = 1;
  world::WorldObject lying = an_object("fire", 60, 0), floating = an_object("smoke", 60, 0);
  floating.height = 5;
  const Vector3 above(60, 0, 120);

  EXPECT_NEAR(quality_of(sensor, above, lying, at(0), terrain),
              world::ground_normal(terrain, 60, 0).z(), 1e-12);
  EXPECT_EQ(quality_of(sensor, above, floating, at(0), terrain), 1);
}

RC_GTEST_PROP(Sensing, APointOnTheGroundIsPerceivedAsThePlannerHasIt, ()) {
  static const world::Terrain terrain = with_hill(100, 0, 60, 200);
  const auto within = [](int low, int high) { return *rc::gen::inRange(low, high) * 0.01; };
  world::SensorModel sensor = a_sensor();
  sensor.range = 300;
  sensor.quality = {within(0, 30001), within(0, 101), within(0, 400)};
  world::WorldObject point = an_object("fire", within(-10000, 30000), within(-20000, 20000));
  point.radius = 0;
  const Vector3 there = world::position_at(point, at(0), terrain);
  const Vector3 from =
      there + within(1, 29900) * world::direction_of(within(-314, 315), within(1, 157));

  const Vector3 normal = world::ground_normal(terrain, there.x(), there.y());
  RC_ASSERT(quality_of(sensor, from, point, at(0), terrain) ==
            world::perceived_quality(sensor, from, there, normal));
}

TEST(Sensing, DetectsLessOftenWhatItPerceivesBadly) {
  const world::Terrain terrain = flat();
  world::SensorModel sensor = a_sensor();
  sensor.responses["fire"].probability = 0.8;
  sensor.quality = {0, 0, 0};
  world::WorldObject fire = an_object("fire", 0, 0);
  fire.radius = 0;
  const std::vector<world::WorldObject> objects = {fire};
  const world::View view = view_of(sensor, over(0, 0, 50), std::nullopt, 0);
  Random random(14);
  const int n = 10000;

  int seen = 0;
  for (int i = 0; i < n; ++i)
    seen += static_cast<int>(look(sensor, view, {terrain, objects}, at(i), random).size());

  EXPECT_NEAR(seen / static_cast<double>(n), 0.4, 4 * std::sqrt(0.4 * 0.6 / n));
}

TEST(Sensing, ReportedPlacesAreSpreadAsTheModelSays) {
  const world::Terrain terrain = flat();
  const world::SensorModel sensor = a_sensor();
  const std::vector<world::WorldObject> objects = {an_object("fire", 3, 4)};
  const world::View view = view_of(sensor, over(0, 0, 50), std::nullopt, 0);
  Random random(12);
  const int n = 10000;

  Vector3 sum = Vector3::Zero(), squares = Vector3::Zero();
  for (int i = 0; i < n; ++i) {
    const auto detections = look(sensor, view, {terrain, objects}, at(i), random);
    ASSERT_EQ(detections.size(), 1u);
    const Vector3 error = detections[0].position - Vector3(3, 4, 0);
    sum += error;
    squares += error.cwiseProduct(error);
  }

  EXPECT_LT((sum / n).norm(), 0.15);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(std::sqrt(squares[axis] / n), 2, 0.1);
}

TEST(Sensing, FalseAlarmsComeAtTheirRateAndInView) {
  const world::Terrain terrain = flat();
  world::SensorModel sensor = a_sensor();
  sensor.false_alarm_rate = 0.05;
  sensor.false_alarm_kind = "fire";
  sensor.false_alarm_confidence = 0.3;
  const world::View view = view_of(sensor, over(0, 0, 50), std::nullopt, 0);
  Random random(13);
  const int n = 40000;

  int alarms = 0;
  for (int i = 0; i < n; ++i)
    for (const auto& detection : look(sensor, view, {terrain, {}}, at(i), random)) {
      ++alarms;
      EXPECT_EQ(detection.kind, "fire");
      EXPECT_EQ(detection.confidence, 0.3);
      EXPECT_TRUE(world::in_view(view, detection.position, 1e-6));
      EXPECT_NEAR(detection.position.z(), 0, 1e-6) << "on the ground";
    }

  const double expected = sensor.false_alarm_rate * sensor.period.to_seconds() * n;
  EXPECT_NEAR(alarms, expected, 4 * std::sqrt(expected));
}

TEST(Sensing, AFireSensorTakesAHotVehicleForAFireACameraDoesNot) {
  const world::Terrain terrain = flat();
  const std::vector<world::WorldObject> objects = {an_object("hot-vehicle", 0, 0)};
  const auto kinds_seen = [&](const std::string& vehicle, const std::string& device) {
    const world::VehicleModel model = model_of(vehicle);
    world::SensorModel sensor = *world::find_sensor(model, device);
    sensor.false_alarm_rate = 0;
    const world::View view = view_of(sensor, over(0, 0, 50), Vector3(0, 0.1, 0), 0);
    Random random(1);
    std::set<std::string> kinds;
    for (int i = 0; i < 100; ++i)
      for (const auto& d : look(sensor, view, {terrain, objects}, at(i), random))
        kinds.insert(d.kind);
    return kinds;
  };

  EXPECT_EQ(kinds_seen("marvin", "fire-sensor"), std::set<std::string>{"fire"});
  EXPECT_EQ(kinds_seen("heliv", "visible"), std::set<std::string>{"hot-vehicle"});
}

/// About (0, 0), 20 m all around at 0 s and a metre more every 10 s.
world::WorldObject blaze() {
  world::WorldObject fire = an_object("fire", 0, 0);
  fire.radius = 20;
  fire.spread = world::FireSpread{0.1, 0, {}};
  return fire;
}

TEST(Sensing, OfAFireThatSpreadsTheFrontIsVisible) {
  const world::View down{{0, 0, 50}, -Vector3::UnitZ(), 100, 0.3};
  const world::View aside{{40, 0, 50}, -Vector3::UnitZ(), 100, 0.3};

  EXPECT_FALSE(is_visible(down, blaze(), at(0), flat())) << "what has burnt out below it";
  EXPECT_FALSE(is_visible(aside, blaze(), at(0), flat())) << "not yet there";
  EXPECT_TRUE(is_visible(aside, blaze(), at(100), flat()));
  EXPECT_FALSE(is_visible(aside, blaze(), at(1000), flat())) << "it has gone by";
}

TEST(Sensing, OfAFrontThePlaceIsDetectedThatIsNearestToWhereItLooks) {
  const world::Terrain terrain = flat();
  world::SensorModel sensor = a_sensor();
  sensor.position_spread = 0.001;
  sensor.range = 300;
  const std::vector<world::WorldObject> objects = {blaze()};
  Random random(15);
  for (const double bearing : {0.0, 1.0, 2.5, 4.0}) {
    const Vector3 toward(std::cos(bearing), std::sin(bearing), 0);
    const Vector3 from(60 * toward.x(), 60 * toward.y(), 40);
    const world::View view{from, (20 * toward - from).normalized(), 300, 0.5};

    const auto detections = look(sensor, view, {terrain, objects}, at(0), random);

    ASSERT_EQ(detections.size(), 1U) << bearing;
    EXPECT_LT((detections[0].position - 20 * toward).norm(), 3) << bearing;
    EXPECT_NEAR(detections[0].position.head<2>().norm(), 20, 0.05) << "on the front";
  }
}

TEST(Sensing, IsBlindToKindsItDoesNotKnow) {
  const world::Terrain terrain = flat();
  const std::vector<world::WorldObject> objects = {an_object("sheep", 0, 0)};
  const world::SensorModel sensor = a_sensor();
  const world::View view = view_of(sensor, over(0, 0, 50), std::nullopt, 0);
  Random random(1);

  EXPECT_TRUE(look(sensor, view, {terrain, objects}, at(0), random).empty());
}

}  // namespace
}  // namespace skein::sim
