// SPDX-License-Identifier: Apache-2.0
// The functional layer of one UAV, through the simulator.
#include "unit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "skein/world/steering.hpp"
#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::a_config;
using testing::altitude;
using testing::device;
using testing::Flight;
using testing::model_of;
using testing::way;
using world::Vector2;
using world::Vector3;

TEST(Unit, ATaskRunsThenEnds) {
  Flight flight(a_config());

  flight.take_off("marvin", 1, 40);

  EXPECT_EQ(flight.history(1), "running ended");
  EXPECT_NEAR(flight.state("marvin").position.z(), 40,
              world::reaching_distance(model_of("marvin"), {}));
  EXPECT_TRUE(flight.state("marvin").airborne);
}

TEST(Unit, AWholeSortieOfEachVehicle) {
  for (const std::string name : {"marvin", "heliv", "karma"}) {
    SimulatorConfig config = a_config({name});
    config.wind = {0.6, 2, 0.5};
    Flight flight(std::move(config));
    const Vector3 there(400, 200, 60);

    flight.take_off(name, 1, 60);
    flight.dispatch(name, 2, "goto", way({{200, -100, 60}, there}));
    ASSERT_TRUE(flight.run_to_end_of(2)) << name;
    const double missed = (flight.state(name).position - there).head<2>().norm();
    flight.dispatch(name, 3, "land");
    ASSERT_TRUE(flight.run_to_end_of(3)) << name;

    EXPECT_EQ(flight.history(2), "running ended") << flight.reason(2);
    EXPECT_EQ(flight.history(3), "running ended") << flight.reason(3);
    EXPECT_LE(missed, world::reaching_distance(model_of(name), {0.6, 2, 0.5})) << name;
    EXPECT_FALSE(flight.state(name).airborne);
    EXPECT_EQ(flight.state(name).activity, "on the ground");
  }
}

functional::Parameters looking_for(double seconds) {
  return device("visible").add("duration", seconds);
}

TEST(Unit, APerceptionHoldsTheVehicleForItsTimeAndLooks) {
  for (const std::string name : {"marvin", "heliv"}) {
    Flight flight(a_config({name}));
    flight.take_off(name, 1, 40);
    const Vector3 before = flight.state(name).position;

    flight.dispatch(name, 2, "perceive", looking_for(20));
    flight.run_for(10);
    flight.dispatch(name, 3, "goto", way({{500, 0, 40}}));
    EXPECT_EQ(flight.history(3), "aborted");
    EXPECT_EQ(flight.reason(3), "motion task 2 is still active");
    EXPECT_EQ(flight.state(name).activity, "perceive, hold");
    ASSERT_TRUE(flight.run_to_end_of(2));

    EXPECT_EQ(flight.history(2), "running ended");
    const auto statuses = flight.statuses(2);
    EXPECT_NEAR((statuses[1].at - statuses[0].at).to_seconds(), 20, 0.2);
    EXPECT_LE((flight.state(name).position - before).norm(), 5);
    EXPECT_GE(flight.all<PerceptionOut>().size(), 10U);
    flight.dispatch(name, 4, "goto", way({{100, 0, 40}}));
    EXPECT_TRUE(flight.run_to_end_of(4));
    EXPECT_EQ(flight.history(4), "running ended");
  }
}

TEST(Unit, MonitoringLastsUntilItIsInterruptedAndIsAbortedOnce) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);

  flight.dispatch("marvin", 2, "monitor", device("visible"));
  flight.run_for(120);
  EXPECT_EQ(flight.history(2), "running");
  flight.interrupt("marvin", 2);
  flight.run_for(5);

  EXPECT_EQ(flight.history(2), "running aborted");
  EXPECT_EQ(flight.reason(2), "interrupted");
  flight.dispatch("marvin", 3, "takeshot", device("visible"));
  EXPECT_EQ(flight.history(3), "running");
}

TEST(Unit, APerceptionAndAPictureAlongTheWayDoNotShareADevice) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);

  flight.dispatch("marvin", 2, "takeshot", device("visible"));
  flight.dispatch("marvin", 3, "perceive", looking_for(20));

  EXPECT_EQ(flight.reason(3), "device 'visible' is in use by task 2");
  flight.interrupt("marvin", 2);
  flight.dispatch("marvin", 4, "perceive", looking_for(20));
  flight.run_for(1);
  EXPECT_EQ(flight.history(4), "running");
}

TEST(Unit, APerceptionWhoseDeviceFailsIsAbortedAndLetsTheVehicleGo) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);
  flight.dispatch("marvin", 2, "perceive", looking_for(60));
  flight.run_for(5);

  flight.give(Fault{"marvin", FaultKind::kSensor, "visible"});

  EXPECT_EQ(flight.history(2), "running aborted");
  EXPECT_EQ(flight.reason(2), "device 'visible' has failed");
  flight.dispatch("marvin", 3, "land");
  EXPECT_TRUE(flight.run_to_end_of(3));
  EXPECT_EQ(flight.history(3), "running ended");
}

RC_GTEST_PROP(Unit, ArrivesWithinToleranceInAnyWindWithAllItsErrors, ()) {
  const std::string name = *rc::gen::element<std::string>("marvin", "heliv", "karma");
  SimulatorConfig config = a_config({name});
  config.wind = {*rc::gen::inRange(-3, 4) * 1.0, *rc::gen::inRange(0, 6) * 1.0, 0.5};
  config.seed = *rc::gen::arbitrary<std::uint64_t>();
  const world::Wind wind = config.wind;
  Flight flight(std::move(config));
  flight.take_off(name, 1, 60);

  for (std::uint64_t task = 2; task < 5; ++task) {
    const Vector3 there(*rc::gen::inRange(-300, 300), *rc::gen::inRange(-300, 300),
                        *rc::gen::inRange(20, 120));
    flight.dispatch(name, task, "goto", way({there}));
    RC_ASSERT(flight.run_to_end_of(task, 900));
    RC_ASSERT(flight.history(task) == "running ended");
    const Vector3 missed = flight.state(name).position - there;
    const double tolerance = world::reaching_distance(model_of(name), wind) + 1e-9;
    RC_ASSERT(missed.head<2>().norm() <= tolerance);
    RC_ASSERT(std::abs(missed.z()) <= tolerance);
  }
}

TEST(Unit, LandingIsNearWhereItWasAsked) {
  for (const std::string name : {"marvin", "heliv", "karma"}) {
    Flight flight(a_config({name}));
    flight.take_off(name, 1, 40);
    flight.dispatch(name, 2, "goto", way({{150, 100, 40}}));
    flight.run_to_end_of(2);

    flight.dispatch(name, 3, "land");
    flight.run_to_end_of(3);

    const world::VehicleModel model = model_of(name);
    const double off = (flight.state(name).position.head<2>() - Vector2(150, 100)).norm();
    EXPECT_LE(off, world::reaching_distance(model, {}) + 1.3 * model.orbit_radius) << name;
  }
}

TEST(Unit, RefusalsAreAbortsWithAReason) {
  Flight flight(a_config());

  flight.dispatch("marvin", 1, "goto", way({{100, 0, 40}}));

  EXPECT_EQ(flight.history(1), "aborted");
  EXPECT_EQ(flight.reason(1), "goto before takeoff: the vehicle is on the ground");
}

TEST(Unit, TwoMotionTasksNeverRunTogether) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);

  flight.dispatch("marvin", 2, "goto", way({{500, 0, 40}}));
  flight.dispatch("marvin", 3, "wait");
  flight.run_for(5);

  EXPECT_EQ(flight.history(2), "running");
  EXPECT_EQ(flight.history(3), "aborted");
  EXPECT_EQ(flight.reason(3), "motion task 2 is still active");
}

TEST(Unit, TakeshotRunsBesideMotion) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);

  flight.dispatch("marvin", 2, "goto", way({{500, 0, 40}}));
  flight.dispatch("marvin", 3, "takeshot", device("visible"));
  flight.dispatch("marvin", 4, "takeshot", device("visible"));
  flight.run_for(5);

  EXPECT_EQ(flight.history(2), "running");
  EXPECT_EQ(flight.history(3), "running");
  EXPECT_EQ(flight.reason(4), "device 'visible' is in use by task 3");
  EXPECT_GE(flight.all<PerceptionOut>().size(), 5u);
}

TEST(Unit, AnInterruptIsConfirmedOnceItHasStopped) {
  for (const std::string name : {"marvin", "heliv"}) {
    Flight flight(a_config({name}));
    flight.take_off(name, 1, 40);
    flight.dispatch(name, 2, "goto", way({{900, 0, 40}}));
    flight.run_for(30);
    ASSERT_GT(flight.state(name).velocity.norm(), 5) << name;

    const double asked = flight.now();
    flight.interrupt(name, 2);
    EXPECT_EQ(flight.history(2), "running") << "it still moves";
    ASSERT_TRUE(flight.run_to_end_of(2, 60));

    EXPECT_EQ(flight.history(2), "running aborted");
    EXPECT_EQ(flight.reason(2), "interrupted");
    EXPECT_LT(flight.state(name).velocity.norm(), 0.5) << name;
    EXPECT_GT(flight.now() - asked, 3) << name;
    EXPECT_LT(flight.now() - asked, 20) << name;
  }
}

TEST(Unit, AnInterruptedBlimpCirclesLevel) {
  Flight flight(a_config({"karma"}));
  flight.take_off("karma", 1, 60);
  flight.dispatch("karma", 2, "goto", way({{900, 0, 120}}));
  flight.run_for(20);

  flight.interrupt("karma", 2);
  ASSERT_TRUE(flight.run_to_end_of(2, 60));
  const Vector2 there = flight.state("karma").position.head<2>();
  flight.run_for(300);

  EXPECT_EQ(flight.state("karma").activity, "orbit");
  EXPECT_LT((flight.state("karma").position.head<2>() - there).norm(), 150);
}

TEST(Unit, AnInterruptedWaitDoesNotMoveTheCircle) {
  Flight flight(a_config({"karma"}));
  flight.take_off("karma", 1, 60);
  const Vector2 centre = a_config({"karma"}).vehicles[0].start;

  for (std::uint64_t task = 2; task < 6; ++task) {
    flight.dispatch("karma", task, "wait");
    flight.run_for(33);
    flight.interrupt("karma", task);
    ASSERT_TRUE(flight.run_to_end_of(task, 10));
  }

  const world::VehicleModel model = model_of("karma");
  const double radius = (flight.state("karma").position.head<2>() - centre).norm();
  EXPECT_NEAR(radius, model.orbit_radius, world::reaching_distance(model, {}));
}

TEST(Unit, EveryInterruptIsAnswered) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);

  flight.interrupt("marvin", 1);
  EXPECT_EQ(flight.history(1), "running ended ended") << "told again how it was";
  flight.interrupt("marvin", 99);
  EXPECT_EQ(flight.reason(99), "no such task here");
}

TEST(Unit, ARequestThatComesTwiceIsAnsweredNotDoneTwice) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);
  flight.dispatch("marvin", 2, "goto", way({{100, 0, 40}}));
  flight.dispatch("marvin", 2, "goto", way({{100, 0, 40}}));
  EXPECT_EQ(flight.history(2), "running running");
  ASSERT_TRUE(flight.run_to_end_of(2));

  flight.dispatch("marvin", 2, "goto", way({{100, 0, 40}}));
  flight.run_for(1);

  EXPECT_EQ(flight.history(2), "running running ended ended");
  EXPECT_EQ(flight.state("marvin").activity, "hold");
}

TEST(Unit, ATakeoffInterruptedOnTheWayUpHoldsThere) {
  Flight flight(a_config());
  flight.dispatch("marvin", 1, "takeoff", altitude(100));
  flight.run_for(10);

  flight.interrupt("marvin", 1);
  ASSERT_TRUE(flight.run_to_end_of(1, 30));
  const double height = flight.state("marvin").position.z();
  flight.run_for(30);

  EXPECT_EQ(flight.history(1), "running aborted");
  EXPECT_GT(height, 10);
  EXPECT_LT(height, 60);
  EXPECT_NEAR(flight.state("marvin").position.z(), height, 2);
}

TEST(Unit, ALandingInterruptedTooLowLands) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 10);
  flight.dispatch("marvin", 2, "land");
  while (flight.state("marvin").position.z() > 1.5) flight.run_for(0.1);

  flight.interrupt("marvin", 2);
  ASSERT_TRUE(flight.run_to_end_of(2, 60));

  EXPECT_EQ(flight.history(2), "running aborted");
  EXPECT_EQ(flight.reason(2), "interrupted too low to stop the landing: landed");
  EXPECT_FALSE(flight.state("marvin").airborne);
}

TEST(Unit, ALandingInterruptedHighHolds) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 60);
  flight.dispatch("marvin", 2, "land");
  flight.run_for(5);

  flight.interrupt("marvin", 2);
  ASSERT_TRUE(flight.run_to_end_of(2, 60));

  EXPECT_EQ(flight.reason(2), "interrupted");
  EXPECT_TRUE(flight.state("marvin").airborne);
}

TEST(Unit, APilotTakesTimeToReact) {
  Flight flight(a_config({"heliv"}));

  flight.dispatch("heliv", 1, "takeoff", altitude(40));

  EXPECT_EQ(flight.history(1), "") << "the pilot has not reacted yet";
  flight.run_for(0.2);
  EXPECT_EQ(flight.history(1), "");
  flight.run_for(5);
  EXPECT_EQ(flight.history(1), "running");
}

TEST(Unit, AnInterruptBeforeThePilotReactsAborts) {
  Flight flight(a_config({"heliv"}));
  flight.dispatch("heliv", 1, "takeoff", altitude(40));

  flight.interrupt("heliv", 1);
  ASSERT_TRUE(flight.run_to_end_of(1, 30));
  flight.run_for(5);

  EXPECT_EQ(flight.statuses(1).back().status.state, TaskState::kAborted);
}

TEST(Unit, ATeleoperatedHoldWandersMoreThanAnAutonomousOne) {
  const auto wandering = [](const std::string& name) {
    Flight flight(a_config({name}));
    flight.take_off(name, 1, 40);
    flight.run_for(20);
    const Vector2 meant = a_config({name}).vehicles[0].start;
    double most = 0;
    for (int i = 0; i < 300; ++i) {
      flight.run_for(1);
      most = std::max(most, (flight.state(name).position.head<2>() - meant).norm());
    }
    return most;
  };

  EXPECT_LT(wandering("marvin"), 1.5);
  EXPECT_GT(wandering("heliv"), 2);
}

TEST(Unit, AWaitEndsAfterItsDurationOrNever) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);

  flight.dispatch("marvin", 2, "wait", functional::Parameters().add("duration", 30));
  EXPECT_EQ(flight.state("marvin").activity, "hold");
  flight.run_for(29);
  EXPECT_EQ(flight.history(2), "running");
  EXPECT_EQ(flight.state("marvin").activity, "wait, hold");
  flight.run_for(1.2);
  EXPECT_EQ(flight.history(2), "running ended");

  flight.dispatch("marvin", 3, "wait");
  flight.run_for(600);
  EXPECT_EQ(flight.history(3), "running");
}

TEST(Unit, AnInterruptedWaitIsConfirmedSoon) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);
  flight.dispatch("marvin", 2, "wait");
  flight.run_for(30);

  flight.interrupt("marvin", 2);
  ASSERT_TRUE(flight.run_to_end_of(2, 10));

  EXPECT_EQ(flight.history(2), "running aborted");
}

TEST(Unit, AnEngineFailureAbortsEverythingAndItSinks) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);
  flight.dispatch("marvin", 2, "goto", way({{500, 0, 40}}));
  flight.dispatch("marvin", 3, "takeshot", device("visible"));
  flight.run_for(5);

  flight.give(Fault{"marvin", FaultKind::kEngine});
  flight.run_for(60);
  flight.dispatch("marvin", 4, "takeoff", altitude(40));

  EXPECT_EQ(flight.reason(2), "engine failure");
  EXPECT_EQ(flight.reason(3), "engine failure");
  EXPECT_EQ(flight.reason(4), "engine failure");
  EXPECT_FALSE(flight.state("marvin").airborne);
  EXPECT_EQ(flight.state("marvin").activity, "engine failure");
}

TEST(Unit, ASensorFailureAbortsItsTaskOnly) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);
  flight.dispatch("marvin", 2, "goto", way({{500, 0, 40}}));
  flight.dispatch("marvin", 3, "takeshot", device("visible"));

  flight.give(Fault{"marvin", FaultKind::kSensor, "visible"});

  EXPECT_EQ(flight.history(2), "running");
  EXPECT_EQ(flight.reason(3), "device 'visible' has failed");
}

TEST(Unit, EmptyTanksEndTheFlight) {
  SimulatorConfig config = a_config();
  config.vehicles[0].energy = 0.1;
  Flight flight(std::move(config));
  flight.take_off("marvin", 1, 40);
  flight.dispatch("marvin", 2, "wait");

  flight.run_for(600);

  EXPECT_EQ(flight.history(2), "running aborted");
  EXPECT_EQ(flight.reason(2), "energy used up");
  EXPECT_FALSE(flight.state("marvin").airborne);
  EXPECT_EQ(flight.state("marvin").energy, 0);
}

TEST(Unit, EnergyOnlyDecreases) {
  Flight flight(a_config({"marvin", "karma"}));
  flight.take_off("marvin", 1, 40);
  flight.take_off("karma", 1, 60);
  flight.run_for(60);

  std::map<std::string, double> last;
  for (const Telemetry& telemetry : flight.all<Telemetry>()) {
    const auto [entry, first] = last.try_emplace(telemetry.uav, 1);
    EXPECT_LE(telemetry.state.energy, entry->second);
    entry->second = telemetry.state.energy;
  }
  EXPECT_LT(last["marvin"], 1);
}

}  // namespace
}  // namespace skein::sim
