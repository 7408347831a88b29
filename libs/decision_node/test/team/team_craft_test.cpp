// SPDX-License-Identifier: Apache-2.0
// What a UAV bids with: straight flights, its energy, and why it would not.
#include "team/team_craft.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "level_world.hpp"

namespace skein::decision_node {
namespace {

using auction::Stopover;
using auction::TaskNumber;
using ::testing::HasSubstr;

// 5 m/s; 100 W whatever it does; flies 40 m over level ground, home at the origin.
Vantage vantage() {
  auto knowledge = std::make_shared<supervisor::Knowledge>();
  knowledge->uav = "marvin";
  world::VehicleModel& vehicle = knowledge->vehicle;
  vehicle.cruise_speed = 5;
  vehicle.max_speed = 10;
  vehicle.climb_rate = vehicle.descent_rate = 2;
  vehicle.energy = {1e6, 100, 100, 100, 0, 0.1};
  world::SensorModel camera;
  camera.device = "camera";
  vehicle.sensors.push_back(camera);
  knowledge->vocabulary.tasks["look"] = {"look", {mission::ParameterKind::kPlace}, {"sight"}};
  knowledge->vocabulary.serves.emplace("camera", "sight");
  auto world = std::make_shared<world::World>(skein::testing::level_world(1000));
  world->places["P1"] = {100, 0, 0};
  Vantage at;
  at.knowledge = knowledge;
  at.world = world;
  for (const std::uint32_t number : {1U, 2U}) {
    mission::HighLevelTask task;
    task.id = mission::GoalId(number);
    task.name = "look";
    task.arguments = {std::string("P1")};
    at.tasks.emplace(TaskNumber(number), task);
  }
  at.visits[TaskNumber(1)] = refiners::Gate{{100, 0, 40}, {100, 0, 40}, {}};
  at.visits[TaskNumber(2)] = refiners::Gate{{200, 0, 40}, {300, 0, 40}, Duration::seconds(30)};
  return at;
}

auction::Task task(std::uint32_t number) {
  auction::Task one;
  one.number = TaskNumber(number);
  one.duration = 20;
  return one;
}

Stopover to(std::uint32_t number) { return Stopover::of(TaskNumber(number)); }

TEST(TeamCraft, DoesNotBidForWhatItLacksSomethingForAndSaysWhat) {
  using interaction::Requirement;
  const auto objection = [](const interaction::Requirements& needs, bool fails = false) {
    Vantage at = vantage();
    at.telemetry.state.energy = 0.5;
    if (fails) at.telemetry.failed = {"camera"};
    at.needs.emplace(TaskNumber(1), needs);
    return TeamCraft(at).objection(task(1)).value_or("");
  };
  const auto endurance = [](double least) {
    return Requirement{"endurance", Requirement::Bound{interaction::Relation::kAtLeast, least}};
  };

  EXPECT_EQ(objection({{"camera", "camera"}, endurance(4000)}), "");
  EXPECT_EQ(objection({endurance(4001)}), "it lacks endurance ≥ 4001 (it has 4000)");
  EXPECT_EQ(objection({{"camera", "camera"}}, true), "it lacks camera: camera");
}

// A sweep of 30 s in which it has 10 s to go before the 20 s of the task itself.
TEST(TeamCraft, OfWhatItHasBegunItsPlanSaysWhatIsLeft) {
  Vantage at = vantage();
  at.begun = Vantage::Begun{TaskNumber(2), Duration::seconds(10.0)};
  EXPECT_DOUBLE_EQ(TeamCraft(at).leg(Stopover::begin(), to(2))->seconds, 10);
  EXPECT_EQ(TeamCraft(at).leg(Stopover::begin(), to(1))->seconds,
            TeamCraft(vantage()).leg(Stopover::begin(), to(1))->seconds);
}

TEST(TeamCraft, APlanThatShouldBeOverDoesNotMoveTheUavThere) {
  Vantage at = vantage();
  const auto straight = TeamCraft(at).leg(Stopover::begin(), to(1))->seconds;
  at.begun = Vantage::Begun{TaskNumber(1), Duration()};
  EXPECT_EQ(TeamCraft(at).leg(Stopover::begin(), to(1))->seconds, straight);
  at.begun->way = Duration::seconds(100.0);
  EXPECT_DOUBLE_EQ(TeamCraft(at).leg(Stopover::begin(), to(1))->seconds, 100);
}

TEST(TeamCraft, WhoIsBehindReckonsWhatIsLeftOfItsWayAtTheSpeedThatItFlies) {
  Vantage at = vantage();
  const auto straight = TeamCraft(at).leg(Stopover::begin(), to(1))->seconds;
  at.begun = Vantage::Begun{TaskNumber(1), Duration(), 4};
  EXPECT_DOUBLE_EQ(TeamCraft(at).leg(Stopover::begin(), to(1))->seconds, 4 * straight);
}

TEST(TeamCraft, AWayTakesAsLongAsAStraightFlightAtCruiseSpeedAndDrawsItsEnergy) {
  const auto leg = TeamCraft(vantage()).leg(Stopover::begin(), to(1));

  ASSERT_TRUE(leg.has_value());
  EXPECT_NEAR(leg->seconds, 20, 0.1);
  EXPECT_EQ(leg->cost, leg->seconds);
  EXPECT_NEAR(leg->energy, 2000, 20);
}

TEST(TeamCraft, InTheAirItBeginsWhereItIs) {
  Vantage at = vantage();
  at.telemetry.state.airborne = true;
  at.telemetry.state.position = {50, 0, 40};

  EXPECT_NEAR(TeamCraft(at).leg(Stopover::begin(), to(1))->seconds, 10, 0.1);
}

TEST(TeamCraft, ASweepCountsOnTheWayToItAndTheNextWayBeginsWhereItEnds) {
  const TeamCraft craft(vantage());

  EXPECT_NEAR(craft.leg(to(1), to(2))->seconds, 20 + 30, 0.1);
  EXPECT_NEAR(craft.leg(to(2), to(1))->seconds, 40, 0.1);
}

TEST(TeamCraft, APlanEndsAtHome) {
  EXPECT_NEAR(TeamCraft(vantage()).leg(to(2), Stopover::end())->seconds, 60, 0.1);
}

TEST(TeamCraft, WhatHasNoPlaceIsDoneWhereItIs) {
  Vantage at = vantage();
  at.visits[TaskNumber(1)] = std::nullopt;

  EXPECT_EQ(TeamCraft(at).leg(Stopover::begin(), to(1))->seconds, 0);
}

TEST(TeamCraft, ThereIsNoWayAgainstAWindThatIsFasterThanTheVehicle) {
  Vantage at = vantage();
  auto knowledge = std::make_shared<supervisor::Knowledge>(*at.knowledge);
  knowledge->vehicle.wind_drift = 1;
  at.knowledge = knowledge;
  auto world = std::make_shared<world::World>(*at.world);
  world->wind.speed = 12;
  world->wind.toward = 3.14159265;
  at.world = world;

  EXPECT_EQ(TeamCraft(at).leg(Stopover::begin(), to(1)), std::nullopt);
}

TEST(TeamCraft, ItsEnergyIsWhatIsLeftAboveTheReserve) {
  Vantage at = vantage();
  at.telemetry.state.energy = 0.5;
  EXPECT_NEAR(TeamCraft(at).energy(), 0.4e6, 1);
  at.telemetry.state.energy = 0.05;
  EXPECT_EQ(TeamCraft(at).energy(), 0);
  EXPECT_NEAR(TeamCraft(at).energy_of(task(1)), 2000, 20);
}

TEST(TeamCraft, ItObjectsToWhatItHasNoDeviceFor) {
  Vantage at = vantage();
  EXPECT_EQ(TeamCraft(at).objection(task(1)), std::nullopt);
  at.telemetry.failed = {"camera"};

  EXPECT_THAT(TeamCraft(at).objection(task(1)).value_or(""), HasSubstr("sight"));
}

// Found by random missions (--anything --clean 1002013): a robot was sold the search of a zone, and
// put it back eleven minutes later, when it came to it.
TEST(TeamCraft, WhoKeepsToTheGroundObjectsToWhatLooksOverZones) {
  using mission::ParameterKind;
  const auto objection = [](bool ground, const std::vector<std::string>& uses) {
    Vantage at = vantage();
    auto knowledge = std::make_shared<supervisor::Knowledge>(*at.knowledge);
    if (ground) knowledge->vehicle.ground.emplace();
    knowledge->vocabulary.tasks["search"] = {"search", {ParameterKind::kZone}, uses};
    at.knowledge = knowledge;
    auto world = std::make_shared<world::World>(*at.world);
    world->zones.push_back({"Z1", {{0, 0}, {100, 0}, {100, 100}}});
    at.world = world;
    at.tasks.at(TaskNumber(1)).name = "search";
    at.tasks.at(TaskNumber(1)).arguments = {std::string("Z1")};
    return TeamCraft(at).objection(task(1)).value_or("");
  };
  EXPECT_EQ(objection(true, {"sight"}), "it keeps to the ground, and looks over no zone");
  EXPECT_EQ(objection(false, {"sight"}), "");
  EXPECT_EQ(objection(true, {}), "") << "it may take a part in what others do there";
}

TEST(TeamCraft, ItObjectsToWhatItTriedToWhatItWasNotToldAndToUnknownPlaces) {
  Vantage at = vantage();
  at.failed[TaskNumber(1)] = "no way there";
  at.tasks.at(TaskNumber(2)).arguments = {std::string("nowhere")};

  EXPECT_EQ(TeamCraft(at).objection(task(1)), "it tried: no way there");
  EXPECT_THAT(TeamCraft(at).objection(task(2)).value_or(""), HasSubstr("nowhere"));
  EXPECT_EQ(TeamCraft(at).objection(task(3)), "it was not told what that is");
}

TEST(TeamCraft, WhatItHasOfItsOwnComesFirst) {
  Vantage at = vantage();
  at.busy = Duration::seconds(40);
  EXPECT_EQ(TeamCraft(at).free_from(), 40);
}

}  // namespace
}  // namespace skein::decision_node
