// SPDX-License-Identifier: Apache-2.0
#include "skein/world/vehicle_model_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace skein::world {
namespace {

using ::testing::HasSubstr;

const std::string kHelicopter = R"(model: bee
kind: helicopter
hovers: true
speed: {cruise: 8, max: 14}
climb_rate: 3
descent_rate: 2
acceleration: 2
yaw_rate: 0.8
ceiling: 300
position_precision: 0.3
wind_drift: 0.05
energy: {capacity: 6.0e6, hover: 1700, cruise: 1500, reserve: 0.1}
sensors:
  visible:
    aperture: 0.35
    pitch: -0.6
    gimballed: true
    range: 250
    period: 0.5
    position_spread: 3
    false_alarms: {rate: 0.001, kind: fire, confidence: 0.3}
    sees:
      fire: {probability: 0.9, confidence: 0.8}
      hot-vehicle: {probability: 0.7, confidence: 0.6, reported_as: fire}
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// What is wrong with a text, as the user reads it; "" if nothing.
std::string report(const std::string& text) {
  const auto model = read_vehicle_model(text, "bee.yaml");
  return model ? "" : to_text(model.error());
}

TEST(VehicleModelReader, ReadsEveryFigure) {
  const auto model = read_vehicle_model(kHelicopter, "bee.yaml");

  ASSERT_TRUE(model) << to_text(model.error());
  EXPECT_EQ(model->name, "bee");
  EXPECT_EQ(model->kind, VehicleKind::kHelicopter);
  EXPECT_TRUE(model->hovers);
  EXPECT_EQ(model->max_speed, 14);
  EXPECT_EQ(model->energy.capacity, 6e6);
  EXPECT_FALSE(model->pilot);
  ASSERT_EQ(model->sensors.size(), 1u);
  const SensorModel& sensor = model->sensors[0];
  EXPECT_EQ(sensor.device, "visible");
  EXPECT_TRUE(sensor.gimballed);
  EXPECT_EQ(sensor.period, Duration::milliseconds(500));
  EXPECT_EQ(sensor.false_alarm_kind, "fire");
  EXPECT_EQ(sensor.responses.at("fire"), (SensorResponse{0.9, 0.8, "fire"}));
  EXPECT_EQ(sensor.responses.at("hot-vehicle").reported_as, "fire");
}

TEST(VehicleModelReader, TheBodyIsAMetreUnlessItIsGiven) {
  const auto silent = read_vehicle_model(kHelicopter, "bee.yaml");
  const auto given = read_vehicle_model(kHelicopter + "body_radius: 0.6\n", "bee.yaml");

  ASSERT_TRUE(silent && given);
  EXPECT_EQ(silent->body_radius, 1);
  EXPECT_EQ(given->body_radius, 0.6);
  EXPECT_THAT(report(kHelicopter + "body_radius: 0\n"), HasSubstr("body_radius: "));
  EXPECT_THAT(report(kHelicopter + "body_radius: 101\n"), HasSubstr("body_radius: "));
}

TEST(VehicleModelReader, FurtherFiguresHaveNamesOfTheirOwn) {
  const auto model =
      read_vehicle_model(kHelicopter + "abilities: {payload: 2.5, resolution: 640}\n", "bee.yaml");
  ASSERT_TRUE(model) << to_text(model.error());
  EXPECT_EQ(model->abilities,
            (std::map<std::string, double>{{"payload", 2.5}, {"resolution", 640}}));
  for (const char* name : {"hovering", "endurance", "visible-range"})
    EXPECT_THAT(report(kHelicopter + "abilities: {" + name + ": 3}\n"),
                HasSubstr("'" + std::string(name) + "' follows from the rest of the model"));
  EXPECT_EQ(report(kHelicopter + "abilities: {ir-range: 3}\n"), "") << "it has no such sensor";
  EXPECT_THAT(report(kHelicopter + "abilities: {payload: heavy}\n"), HasSubstr("payload"));
}

TEST(VehicleModelReader, ReadsThePilot) {
  const auto model = read_vehicle_model(
      kHelicopter +
          "pilot: {reaction: 1.5, reaction_spread: 0.4, position_imprecision: 2, "
          "heading_imprecision: 0.1, attention_period: 3}\n",
      "bee.yaml");

  ASSERT_TRUE(model);
  ASSERT_TRUE(model->pilot);
  EXPECT_EQ(model->pilot->reaction, Duration::seconds(1.5));
  EXPECT_EQ(model->pilot->attention_period, Duration::seconds(3));
}

TEST(VehicleModelReader, TheModelsOfTheCometsScenarioAreSound) {
  for (const std::string name : {"marvin", "heliv", "karma"}) {
    const std::string path = SKEIN_SOURCE_DIR "/scenarios/comets/models/" + name + ".yaml";
    std::stringstream text;
    text << std::ifstream(path).rdbuf();

    const auto model = read_vehicle_model(text.str(), path);

    ASSERT_TRUE(model) << to_text(model.error());
    EXPECT_EQ(model->name, name);
    EXPECT_EQ(model->hovers, name != "karma");
    EXPECT_EQ(model->pilot.has_value(), name == "heliv");
  }
}

TEST(VehicleModelReader, UnknownKeysAreRefusedWithTheNearest) {
  EXPECT_THAT(report(replaced(kHelicopter, "climb_rate", "clim_rate")),
              HasSubstr("bee.yaml:5:12: clim_rate: unknown key 'clim_rate'"));
  EXPECT_THAT(report(replaced(kHelicopter, "gimballed", "gimbaled")),
              HasSubstr("did you mean 'gimballed'?"));
  EXPECT_THAT(report(replaced(kHelicopter, "helicopter", "helicoptre")),
              HasSubstr("did you mean 'helicopter'?"));
}

TEST(VehicleModelReader, EveryErrorIsGivenAtOnce) {
  std::string text = replaced(kHelicopter, "max: 14", "max: fast");
  text = replaced(text, "wind_drift: 0.05", "wind_drift: 1.5");
  text = replaced(text, "range: 250", "range: 0");
  text = replaced(text, "ceiling: 300\n", "");

  const auto model = read_vehicle_model(text, "bee.yaml");

  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().size(), 4u) << to_text(model.error());
  const std::string all = to_text(model.error());
  EXPECT_THAT(all, HasSubstr("bee.yaml:4:"));
  EXPECT_THAT(all, HasSubstr("speed.max"));
  EXPECT_THAT(all, HasSubstr("wind_drift"));
  EXPECT_THAT(all, HasSubstr("sensors.visible.range"));
  EXPECT_THAT(all, HasSubstr("ceiling: missing"));
}

TEST(VehicleModelReader, EachFigureHasItsRange) {
  struct Case {
    const char* path;
    const char* from;
    const char* to;
  };
  const Case cases[] = {
      {"speed.cruise", "cruise: 8", "cruise: -8"},
      {"speed.max", "max: 14", "max: 201"},
      {"climb_rate", "climb_rate: 3", "climb_rate: 0"},
      {"descent_rate", "descent_rate: 2", "descent_rate: -2"},
      {"acceleration", "acceleration: 2", "acceleration: 0"},
      {"yaw_rate", "yaw_rate: 0.8", "yaw_rate: 11"},
      {"ceiling", "ceiling: 300", "ceiling: 0"},
      {"position_precision", "position_precision: 0.3", "position_precision: -1"},
      {"wind_drift", "wind_drift: 0.05", "wind_drift: -0.05"},
      {"energy.capacity", "capacity: 6.0e6", "capacity: 0"},
      {"energy.hover", "hover: 1700", "hover: -1"},
      {"energy.reserve", "reserve: 0.1", "reserve: 1"},
      {"sensors.visible.aperture", "aperture: 0.35", "aperture: 3"},
      {"sensors.visible.pitch", "pitch: -0.6", "pitch: -60"},
      {"sensors.visible.period", "period: 0.5", "period: 0"},
      {"sensors.visible.position_spread", "position_spread: 3", "position_spread: -3"},
      {"sensors.visible.false_alarms.rate", "rate: 0.001", "rate: -0.001"},
      {"sensors.visible.sees.fire.probability", "probability: 0.9", "probability: 1.1"},
      {"sensors.visible.sees.fire.confidence", "confidence: 0.8", "confidence: 80"},
  };
  for (const Case& c : cases) {
    const auto model = read_vehicle_model(replaced(kHelicopter, c.from, c.to), "bee.yaml");

    ASSERT_FALSE(model) << c.to;
    ASSERT_EQ(model.error().size(), 1u) << to_text(model.error());
    EXPECT_EQ(model.error().all()[0].path, c.path);
    EXPECT_GT(model.error().all()[0].line, 0);
    EXPECT_NE(model.error().all()[0].expected, "");
  }
}

TEST(VehicleModelReader, FiguresThatContradictEachOtherAreRefused) {
  struct Case {
    const char* from;
    const char* to;
    const char* error;
  };
  const Case cases[] = {
      {"max: 14", "max: 7", "cruise is greater than max"},
      {"cruise: 8", "min: 3, cruise: 8", "a least speed of a vehicle that hovers"},
      {"hovers: true", "hovers: true\norbit_radius: 40", "orbit_radius of a vehicle that hovers"},
      {"hovers: true\n", "hovers: false\nmin_turn_radius: 30\norbit_radius: 30\n",
       "the orbit is too tight"},
      {"hovers: true\n", "hovers: false\nmin_turn_radius: 30\norbit_radius: 40\n",
       "needs a least speed"},
      {"hovers: true", "hovers: false", "min_turn_radius: missing"},
      {"hovers: true\n", "hovers: false\n", "yaw_rate of a vehicle that cannot hover"},
      {"model: bee", "model: ''", "an empty name"},
      {"reported_as: fire", "reported_as: ''", "reported_as is empty"},
  };
  for (const Case& c : cases)
    EXPECT_THAT(report(replaced(kHelicopter, c.from, c.to)), HasSubstr(c.error)) << c.to;
}

TEST(VehicleModelReader, AVehicleThatCannotHoverHasItsOwnFigures) {
  std::string text = replaced(kHelicopter, "hovers: true", "hovers: false");
  text = replaced(text, "kind: helicopter", "kind: blimp");
  text = replaced(text, "yaw_rate: 0.8", "min_turn_radius: 25\norbit_radius: 40");
  text = replaced(text, "cruise: 8", "min: 2, cruise: 8");

  const auto model = read_vehicle_model(text, "bee.yaml");

  ASSERT_TRUE(model) << to_text(model.error());
  EXPECT_EQ(model->kind, VehicleKind::kBlimp);
  EXPECT_FALSE(model->hovers);
  EXPECT_EQ(model->min_speed, 2);
  EXPECT_EQ(model->min_turn_radius, 25);
  EXPECT_EQ(model->orbit_radius, 40);
}

TEST(VehicleModelReader, MissingSectionsAreNamedOnce) {
  const std::string text = replaced(
      kHelicopter, "energy: {capacity: 6.0e6, hover: 1700, cruise: 1500, reserve: 0.1}\n", "");
  const auto model = read_vehicle_model(text, "bee.yaml");

  ASSERT_FALSE(model);
  ASSERT_EQ(model.error().size(), 1u) << to_text(model.error());
  EXPECT_EQ(model.error().all()[0].path, "energy");
}

TEST(VehicleModelReader, ASensorThatSeesNothingIsRefused) {
  const std::string text = kHelicopter.substr(0, kHelicopter.find("    sees:")) + "    sees: {}\n";
  EXPECT_THAT(report(text), HasSubstr("sensors.visible.sees: sees nothing"));
}

TEST(VehicleModelReader, WhatIsNoModelAtAllIsRefused) {
  EXPECT_NE(report(""), "");
  EXPECT_THAT(report("just words"), HasSubstr("not a vehicle model"));
  EXPECT_THAT(report("[1, 2]"), HasSubstr("not a vehicle model"));
  EXPECT_NE(report("model: {"), "");
  EXPECT_NE(report("model: bee"), "");
}

const std::string kRobot = R"(model: mana
kind: ground
speed: {cruise: 2.5, max: 3}
acceleration: 1.5
yaw_rate: 1.2
position_precision: 0.3
ground: {steepest: 0.2, mast: 1.5}
energy: {capacity: 1.5e6, ground: 60, cruise: 180, climb: 250, reserve: 0.1}
)";

TEST(VehicleModelReader, OneThatKeepsToTheGroundStandsAndClimbsAsTheGroundDoes) {
  const auto model = read_vehicle_model(kRobot, "mana.yaml");

  ASSERT_TRUE(model) << to_text(model.error());
  ASSERT_TRUE(model->ground.has_value());
  EXPECT_EQ(model->ground->steepest, 0.2);
  EXPECT_TRUE(model->hovers);
  EXPECT_EQ(model->ceiling, 0);
  EXPECT_EQ(model->wind_drift, 0);
  EXPECT_NEAR(model->climb_rate, 3 * std::tan(0.2), 1e-9);
  EXPECT_EQ(flight_power(*model, 0, 0), 60);
  EXPECT_EQ(flight_power(*model, 2.5, 0), 180);
  EXPECT_EQ(eye_of(*model, {1, 2, 3}), Vector3(1, 2, 4.5));
}

TEST(VehicleModelReader, WhatFliesAndWhatKeepsToTheGroundHaveNotTheSameFigures) {
  const std::string robot = report(replaced(kRobot, "yaw_rate: 1.2", "yaw_rate: 1.2\nceiling: 9"));
  const std::string hover = report(replaced(kRobot, "ground: 60", "ground: 60, hover: 90"));
  const std::string bee =
      report(replaced(kHelicopter, "ceiling: 300", "ceiling: 300\nground: {steepest: 1, mast: 1}"));

  EXPECT_THAT(robot, HasSubstr("ceiling of a vehicle that keeps to the ground"));
  EXPECT_THAT(hover, HasSubstr("hover"));
  EXPECT_THAT(bee, HasSubstr("ground of a vehicle that flies"));
}

}  // namespace
}  // namespace skein::world
