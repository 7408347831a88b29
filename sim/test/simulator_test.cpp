// SPDX-License-Identifier: Apache-2.0
#include "skein/sim/simulator.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <ctime>
#include <map>

#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::a_config;
using testing::altitude;
using testing::an_object;
using testing::at;
using testing::device;
using testing::Flight;
using testing::way;
using testing::with_hill;

/// The three vehicles of COMETS, wind, a fire and a moving vehicle, a hill, a cut.
SimulatorConfig comets(std::uint64_t seed) {
  SimulatorConfig config = a_config({"marvin", "heliv", "karma"});
  config.terrain = with_hill(300, 700, 60, 150);
  config.wind = {0.6, 2, 0.5};
  config.objects = {an_object("fire", 640, 420), an_object("hot-vehicle", 400, 100)};
  config.objects[1].waypoints = {{500, 100}};
  config.objects[1].speed = 1;
  config.cuts = {{"heliv", "ground", at(300), at(330)}};
  config.seed = seed;
  return config;
}

/// A mission for all three, with sensors running; returns the flight at its end.
void fly_mission(Flight& flight, double until) {
  std::uint64_t task = 0;
  for (const std::string name : {"marvin", "heliv", "karma"})
    flight.dispatch(name, ++task, "takeoff", altitude(60));
  flight.run_until(90);
  for (const std::string name : {"marvin", "heliv", "karma"}) {
    functional::Parameters pattern = way({{400, 200, 60},
                                          {900, 200, 60},
                                          {900, 280, 60},
                                          {400, 280, 60},
                                          {400, 360, 60},
                                          {900, 360, 60},
                                          {640, 420, 60}});
    flight.dispatch(name, ++task, "goto", pattern);
  }
  flight.dispatch("marvin", ++task, "takeshot", device("fire-sensor"));
  flight.dispatch("heliv", ++task, "takeshot", device("visible").add("target", {640, 420, 0}));
  flight.dispatch("karma", ++task, "takeshot", device("mapping"));
  flight.run_until(until);
}

TEST(Simulator, TheFirstStepTellsHowEverythingIs) {
  Flight flight(comets(1));

  EXPECT_EQ(flight.all<LinkChange>().size(), 12u) << "four nodes, six pairs, both ways";
  EXPECT_EQ(flight.all<Telemetry>().size(), 3u);
  EXPECT_EQ(flight.all<VehicleTruth>().size(), 3u);
  EXPECT_EQ(flight.all<ObjectTruth>().size(), 2u);
  for (const Telemetry& t : flight.all<Telemetry>()) {
    EXPECT_FALSE(t.state.airborne);
    EXPECT_EQ(t.state.energy, 1);
  }
}

TEST(Simulator, WakesAtEachStep) {
  Simulator simulator(a_config());
  EXPECT_EQ(simulator.next_wakeup(), at(0));

  simulator.handle(Tick{}, at(0));
  EXPECT_EQ(simulator.next_wakeup(), at(0.1));
  simulator.handle(Tick{}, at(1.05));
  EXPECT_EQ(simulator.next_wakeup(), at(1.1));
}

TEST(Simulator, TelemetryComesAtItsPeriod) {
  Flight flight(a_config());

  flight.run_until(10);

  const auto telemetry = flight.all<Telemetry>();
  ASSERT_EQ(telemetry.size(), 11u);
  for (std::size_t i = 0; i < telemetry.size(); ++i)
    EXPECT_EQ(telemetry[i].at, at(static_cast<double>(i)));
}

TEST(Simulator, OneSeedGivesOneRun) {
  Flight a(comets(7)), b(comets(7)), c(comets(8));

  for (Flight* flight : {&a, &b, &c}) fly_mission(*flight, 400);

  EXPECT_TRUE(a.log() == b.log());
  EXPECT_FALSE(a.log() == c.log());
}

TEST(Simulator, HowOftenItTicksChangesNothing) {
  Flight often(comets(7)), seldom(comets(7));
  for (Flight* flight : {&often, &seldom}) flight->dispatch("marvin", 1, "takeoff", altitude(60));

  for (int i = 1; i <= 4000; ++i) often.run_until(i * 0.03);
  seldom.run_until(120);

  EXPECT_TRUE(often.log() == seldom.log());
}

TEST(Simulator, TimeNeverGoesBack) {
  Flight flight(a_config());
  flight.run_until(10);
  flight.forget();

  flight.run_until(5);

  EXPECT_TRUE(flight.log().empty());
  EXPECT_EQ(flight.simulator().next_wakeup(), at(10.1));
}

TEST(Simulator, InputsForUnknownVehiclesDoNothing) {
  Flight flight(a_config());
  flight.forget();

  flight.dispatch("nobody", 1, "takeoff", altitude(10));
  flight.give(Fault{"nobody"});
  flight.give(ContactLost{"nobody"});

  EXPECT_TRUE(flight.log().empty());
  EXPECT_EQ(flight.simulator().find_vehicle("nobody"), nullptr);
}

TEST(Simulator, ObjectsAreToldWhenTheyChangeWhileTheyMoveAndEachPeriod) {
  SimulatorConfig config = a_config();
  config.objects = {an_object("fire", 10, 10), an_object("truck", 20, 20)};
  config.objects[0].appears = at(12.3);
  config.objects[1].waypoints = {{25, 20}};
  config.objects[1].speed = 1;
  Flight flight(std::move(config));

  flight.run_until(40);

  std::map<std::string, std::vector<double>> told;
  for (const ObjectTruth& truth : flight.all<ObjectTruth>())
    told[truth.name].push_back(truth.at.to_seconds());
  ASSERT_EQ(told["fire"].size(), 3u);
  EXPECT_NEAR(told["fire"][1], 12.3, 0.1);
  EXPECT_NEAR(told["fire"][2], 30, 0.1);
  EXPECT_GE(told["truck"].size(), 6u);
}

TEST(Simulator, AFireSpreadsWithItsWindAndIsToldWhileItDoes) {
  SimulatorConfig config = a_config();
  config.wind = {0, 4, 1};
  config.objects = {an_object("fire", 10, 10)};
  config.objects[0].radius = 2;
  config.objects[0].spread = world::FireSpread{0.1, 0.25, {}};
  config.objects[0].appears = at(5);
  Flight flight(std::move(config));

  flight.run_until(60);

  std::vector<ObjectTruth> told = flight.all<ObjectTruth>();
  std::erase_if(told, [](const ObjectTruth& one) { return !one.active; });
  ASSERT_GE(told.size(), 50U);
  const ObjectTruth& last = told.back();
  ASSERT_TRUE(last.front.has_value());
  const double age = (last.at - at(5)).to_seconds();
  EXPECT_NEAR(last.front->head().x(), 10 + 2 + 0.2 * age, 1e-6) << "twice as fast in 4 m/s";
  EXPECT_NEAR(last.position.x(), last.front->centre().x(), 1e-9);
  EXPECT_EQ(last.radius, last.front->length);
  EXPECT_LT(last.front->breadth, last.front->length);
}

TEST(Simulator, RefusesFiresThatDoNotSpreadAsFiresDo) {
  SimulatorConfig config = a_config();
  config.objects = {an_object("fire", 10, 10)};
  config.objects[0].spread = world::FireSpread{0, -1, {}};
  config.objects[0].speed = 1;

  EXPECT_EQ(
      problems_of(config),
      (std::vector<std::string>{"object 'fire': it spreads at a rate above 0, not slower in wind",
                                "object 'fire': what spreads does not go along a way"}));
}

TEST(Simulator, TheFireIsSeenByWhoFliesOverIt) {
  Flight flight(comets(3));

  fly_mission(flight, 900);

  std::map<std::string, int> seen;
  for (const PerceptionOut& out : flight.all<PerceptionOut>())
    for (const world::Detection& d : out.perception.detections)
      if ((d.position.head<2>() - world::Vector2(640, 420)).norm() < 40) ++seen[out.perception.uav];
  EXPECT_GT(seen["marvin"], 3);
  EXPECT_GT(seen["heliv"], 3);
  EXPECT_GT(seen["karma"], 1);
}

TEST(Simulator, AScriptedCutIsInTheLinks) {
  Flight flight(comets(1));
  flight.run_until(400);

  std::vector<std::pair<double, bool>> changes;
  for (const LinkChange& link : flight.all<LinkChange>())
    if (link.from == "heliv" && link.to == "ground")
      changes.emplace_back(link.at.to_seconds(), link.up);

  ASSERT_EQ(changes.size(), 3u);
  EXPECT_EQ(changes[1], (std::pair<double, bool>{300.0, false}));
  EXPECT_EQ(changes[2], (std::pair<double, bool>{330.0, true}));
}

/// The seeded property test of the whole: random missions, limits watched step by step.
RC_GTEST_PROP(Simulator, NoVehicleEverExceedsItsLimits, ()) {
  const std::string name = *rc::gen::element<std::string>("marvin", "heliv", "karma");
  SimulatorConfig config = a_config({name});
  config.terrain = with_hill(300, 300, 40, 250);
  config.wind = {*rc::gen::inRange(0, 6) * 1.0, *rc::gen::inRange(0, 5) * 1.0, 0.5};
  config.seed = *rc::gen::arbitrary<std::uint64_t>();
  const world::VehicleModel model = config.vehicles[0].model;
  const world::Terrain terrain = config.terrain;
  const double drift = model.wind_drift * (config.wind.speed + 6 * config.wind.gusts);
  Flight flight(std::move(config));
  flight.dispatch(name, 1, "takeoff", altitude(60));

  double energy = 1;
  for (std::uint64_t task = 2; task < 6; ++task) {
    for (int i = 0; i < 600; ++i) {
      flight.run_for(0.1);
      const world::VehicleState& state = flight.state(name);
      const double height =
          state.position.z() - terrain.elevation(state.position.x(), state.position.y());
      RC_ASSERT(state.velocity.head<2>().norm() <= model.max_speed + drift + 1e-9);
      RC_ASSERT(state.velocity.z() <= model.climb_rate + 1e-9);
      RC_ASSERT(state.velocity.z() >= -model.descent_rate - 1e-9);
      RC_ASSERT(height >= -1e-6);
      RC_ASSERT(height <= model.ceiling + 5);  // falling ground may leave it high for a moment
      RC_ASSERT(state.energy <= energy);
      RC_ASSERT(state.activity != "crashed");
      energy = state.energy;
    }
    flight.dispatch(name, task, "goto",
                    way({{*rc::gen::inRange(-300, 800) * 1.0, *rc::gen::inRange(-300, 800) * 1.0,
                          *rc::gen::inRange(20, 140) * 1.0}}));
  }
}

TEST(Simulator, AMissionOfThreeVehiclesCostsLittle) {
  Flight flight(comets(5));
  const std::clock_t began = std::clock();

  fly_mission(flight, 2400);

  // Measured 0.1 s on a desktop; the bound leaves room for sanitizers and loaded machines.
  EXPECT_LT(static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC, 5);
}

}  // namespace
}  // namespace skein::sim
