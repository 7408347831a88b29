// SPDX-License-Identifier: Apache-2.0
// What goes wrong on board, and what the vehicle tells of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::a_config;
using testing::altitude;
using testing::device;
using ::testing::ElementsAre;
using testing::Flight;
using ::testing::IsEmpty;
using testing::way;

Fault slow(const std::string& uav, double factor, double seconds) {
  Fault fault{uav, FaultKind::kSlow};
  fault.factor = factor;
  fault.lasts = Duration::seconds(seconds);
  return fault;
}

Fault abort_of(const std::string& type) {
  Fault fault{"marvin", FaultKind::kAbort};
  fault.type = type;
  return fault;
}

Fault energy(double left) {
  Fault fault{"marvin", FaultKind::kEnergy};
  fault.left = left;
  return fault;
}

// Seconds that the task takes from now on; the task must end.
double time_of(Flight& flight, std::uint64_t task) {
  const double from = flight.now();
  EXPECT_TRUE(flight.run_to_end_of(task, 3000)) << task;
  EXPECT_EQ(flight.history(task), "running ended") << flight.reason(task);
  return flight.now() - from;
}

Flight in_the_air(const std::string& uav, double speed_factor = 1) {
  SimulatorConfig config = a_config({uav});
  config.vehicles[0].speed_factor = speed_factor;
  Flight flight(std::move(config));
  flight.take_off(uav, 1, 60);
  return flight;
}

double time_of_a_way(Flight& flight, const std::string& uav) {
  flight.dispatch(uav, 2, "goto", way({{600, 0, 60}}));
  return time_of(flight, 2);
}

// ---- slow ----

TEST(SlowFault, AWayTakesAsManyTimesAsLongWhileItLasts) {
  for (const std::string uav : {"marvin", "heliv", "karma"}) {
    Flight sound = in_the_air(uav), slowed = in_the_air(uav);
    slowed.give(slow(uav, 3, 2000));

    const double ratio = time_of_a_way(slowed, uav) / time_of_a_way(sound, uav);

    EXPECT_GT(ratio, 2.3) << uav;
    EXPECT_LT(ratio, 3.3) << uav;
  }
}

TEST(SlowFault, TakeoffAndLandingAreSlowToo) {
  Flight sound(a_config()), slowed(a_config());
  slowed.give(slow("marvin", 2, 2000));
  std::vector<double> times;

  for (Flight* flight : {&sound, &slowed}) {
    flight->dispatch("marvin", 1, "takeoff", altitude(60));
    times.push_back(time_of(*flight, 1));
    flight->dispatch("marvin", 2, "land");
    times.push_back(time_of(*flight, 2));
  }

  EXPECT_GT(times[2], 1.6 * times[0]);
  EXPECT_GT(times[3], 1.3 * times[1]);
}

TEST(SlowFault, EndsWithItsTime) {
  Flight sound = in_the_air("marvin"), slowed = in_the_air("marvin");
  slowed.give(slow("marvin", 10, 20));

  const double later = time_of_a_way(slowed, "marvin") - time_of_a_way(sound, "marvin");

  EXPECT_GT(later, 15);
  EXPECT_LT(later, 20);  // of twenty seconds nine tenths are lost, and what speeding up takes
}

TEST(SpeedFactor, OfAVehicleHoldsForTheWholeMission) {
  Flight plain = in_the_air("marvin"), eager = in_the_air("marvin", 1.25);

  const double ratio = time_of_a_way(eager, "marvin") / time_of_a_way(plain, "marvin");

  EXPECT_GT(ratio, 0.75);
  EXPECT_LT(ratio, 0.9);
}

TEST(SpeedFactor, ThatIsNoneIsAProblemOfTheConfiguration) {
  SimulatorConfig config = a_config();
  config.vehicles[0].speed_factor = 0;

  EXPECT_THAT(problems_of(config),
              ElementsAre("vehicle 'marvin': the speed factor must be greater than 0"));
}

RC_GTEST_PROP(SpeedFactor, NeverLiftsALimit, ()) {
  const std::string uav = *rc::gen::element<std::string>("marvin", "heliv", "karma");
  Flight flight = in_the_air(uav, *rc::gen::inRange(2, 40) / 10.0);
  const world::VehicleModel model = testing::model_of(uav);
  flight.give(slow(uav, *rc::gen::inRange(1, 9), 30));

  flight.dispatch(uav, 2, "goto", way({{300, 100, 90}, {300, -100, 40}}));
  flight.run_for(120);

  for (const Telemetry& telemetry : flight.all<Telemetry>()) {
    RC_ASSERT(telemetry.state.velocity.head<2>().norm() <= model.max_speed + 1e-9);
    RC_ASSERT(telemetry.state.velocity.z() <= model.climb_rate + 1e-9);
    RC_ASSERT(telemetry.state.velocity.z() >= -model.descent_rate - 1e-9);
  }
}

// ---- abort ----

TEST(AbortFault, AbortsTheMotionThatRunsAndTheVehicleComesToRest) {
  Flight flight = in_the_air("marvin");
  flight.dispatch("marvin", 2, "goto", way({{600, 0, 60}}));
  flight.run_for(10);

  flight.give(abort_of("goto"));
  flight.run_for(20);

  EXPECT_EQ(flight.history(2), "running aborted");
  EXPECT_EQ(flight.reason(2), "aborted by the functional layer");
  EXPECT_EQ(flight.state("marvin").activity, "hold");
  flight.dispatch("marvin", 3, "goto", way({{600, 0, 60}}));
  EXPECT_TRUE(flight.run_to_end_of(3));
  EXPECT_EQ(flight.history(3), "running ended");
}

TEST(AbortFault, AbortsOneTakeshotAndNothingElse) {
  Flight flight = in_the_air("marvin");
  flight.dispatch("marvin", 2, "goto", way({{600, 0, 60}}));
  flight.dispatch("marvin", 3, "takeshot", device("visible"));
  flight.dispatch("marvin", 4, "takeshot", device("fire-sensor"));
  flight.run_for(10);

  flight.give(abort_of("takeshot"));

  EXPECT_EQ(flight.history(2), "running");
  EXPECT_EQ(flight.reason(3), "aborted by the functional layer");
  EXPECT_EQ(flight.history(4), "running");
}

TEST(AbortFault, WaitsForTheNextOfItsTypeAndMeetsItOnce) {
  Flight flight = in_the_air("marvin");
  flight.give(abort_of("takeshot"));

  flight.dispatch("marvin", 2, "goto", way({{100, 0, 60}}));
  flight.dispatch("marvin", 3, "takeshot", device("visible"));
  flight.dispatch("marvin", 4, "takeshot", device("visible"));

  EXPECT_EQ(flight.history(2), "running");
  EXPECT_EQ(flight.history(3), "aborted");
  EXPECT_EQ(flight.reason(3), "aborted by the functional layer");
  EXPECT_EQ(flight.history(4), "running");
}

TEST(AbortFault, IsNotSpentOnATaskThatIsRefusedAnyway) {
  Flight flight = in_the_air("marvin");
  flight.give(abort_of("takeoff"));
  flight.give(abort_of("goto"));

  flight.dispatch("marvin", 2, "takeoff", altitude(40));
  flight.dispatch("marvin", 3, "goto", way({{100, 0, 60}}));
  flight.dispatch("marvin", 4, "goto", way({{100, 0, 60}}));

  EXPECT_EQ(flight.reason(2), "already in the air");
  EXPECT_EQ(flight.reason(3), "aborted by the functional layer");
  EXPECT_EQ(flight.history(4), "running");
}

TEST(AbortFault, WithATimeItMeetsWhatRunsAndEveryTaskOfItsTypeUntilThen) {
  Flight flight = in_the_air("marvin");
  flight.dispatch("marvin", 2, "takeshot", device("visible"));
  Fault fault = abort_of("takeshot");
  fault.lasts = Duration::seconds(20);
  flight.give(fault);
  EXPECT_EQ(flight.history(2), "running aborted");

  flight.dispatch("marvin", 3, "takeshot", device("visible"));
  flight.run_for(15);
  flight.dispatch("marvin", 4, "takeshot", device("visible"));
  flight.run_for(6);
  flight.dispatch("marvin", 5, "takeshot", device("visible"));

  EXPECT_EQ(flight.reason(3), "aborted by the functional layer");
  EXPECT_EQ(flight.reason(4), "aborted by the functional layer");
  EXPECT_EQ(flight.history(5), "running");
}

TEST(AbortFault, ATaskThatItMetIsNotDoneWhenItIsAskedForAgain) {
  Flight flight = in_the_air("marvin");
  flight.give(abort_of("goto"));
  flight.dispatch("marvin", 2, "goto", way({{100, 0, 60}}));

  flight.dispatch("marvin", 2, "goto", way({{100, 0, 60}}));

  EXPECT_EQ(flight.history(2), "aborted aborted");
}

// ---- energy ----

TEST(EnergyFault, LeavesWhatItSaysAndNeverMore) {
  Flight flight = in_the_air("marvin");

  flight.give(energy(0.2));
  EXPECT_EQ(flight.state("marvin").energy, 0.2);
  flight.give(energy(0.9));

  EXPECT_EQ(flight.state("marvin").energy, 0.2);
}

TEST(EnergyFault, OfNothingLeftEndsTheFlight) {
  Flight flight = in_the_air("marvin");
  flight.dispatch("marvin", 2, "wait");

  flight.give(energy(0));

  EXPECT_EQ(flight.reason(2), "energy used up");
}

// ---- a request that comes twice ----

TEST(ARequestThatComesTwice, GetsThePresentStatusAndIsDoneOnce) {
  Flight flight = in_the_air("marvin");
  flight.dispatch("marvin", 2, "goto", way({{100, 0, 60}}));
  flight.run_for(1);

  flight.dispatch("marvin", 2, "goto", way({{-100, 0, 60}}));
  const bool ended = flight.run_to_end_of(2);
  flight.dispatch("marvin", 2, "goto", way({{-100, 0, 60}}));
  flight.run_for(10);

  EXPECT_TRUE(ended);
  EXPECT_EQ(flight.history(2), "running running ended ended");
  EXPECT_NEAR(flight.state("marvin").position.x(), 100, 3);
}

// ---- what telemetry tells ----

TEST(Telemetry, TellsWhatDoesNotWork) {
  Flight flight = in_the_air("marvin");
  EXPECT_THAT(flight.all<Telemetry>().back().failed, IsEmpty());

  flight.give(Fault{"marvin", FaultKind::kSensor, "visible"});
  flight.run_for(1);
  EXPECT_THAT(flight.all<Telemetry>().back().failed, ElementsAre("visible"));

  flight.give(Fault{"marvin", FaultKind::kEngine});
  flight.run_for(1);
  EXPECT_THAT(flight.all<Telemetry>().back().failed, ElementsAre("engine", "visible"));
}

}  // namespace
}  // namespace skein::sim
