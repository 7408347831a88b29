// SPDX-License-Identifier: Apache-2.0
// Who waits in the air with little energy: how long, what it flies unasked, and for whom it leaves.
#include "merging/short_energy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "skein/elementary/parameter_reader.hpp"
#include "skein/supervisor/way_home.hpp"
#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using ::testing::Contains;
using testing::give_sweep;
using testing::goto_of;
using testing::MergedTeam;
using ::testing::Not;
using world::Vector3;

std::vector<std::string> air_of(const std::vector<AirNoted>& notes) {
  std::vector<std::string> result;
  for (const AirNoted& one : notes) result.push_back(one.state);
  return result;
}

/// 100 m high, 60 m over the height of its way home, which is 200 m long.
struct HighUp {
  HighUp() {
    config.model = testing::quick_helicopter();
    config.model.descent_rate = 1;
    config.model.energy.hover_power = config.model.energy.cruise_power = 500;
    config.terrain = MergedTeam::level_ground();
    knowledge.vehicle = config.model;
    knowledge.home = {200, 0, 0};
    knowledge.altitude = 40;
    situation.state.position = {0, 0, 100};
    situation.state.airborne = true;
    situation.rest = situation.state.position;
  }

  /// As it got out of the way upwards (aside), or was asked to fly from there.
  Airways home(bool aside) const {
    AirwaySituation there = situation;
    there.aside = aside;
    functional::Request request;
    request.id = functional::TaskId(7);
    request.type = "goto";
    request.parameters.add(elementary::points_parameter("waypoints", {{200, 0, 40}}));
    return airways_of(request, false, config, there).value();
  }

  double least(const Airway& way) const {
    return supervisor::least_to_come_home(knowledge, world, {}, way.way->points());
  }

  /// How high its way is half way home.
  static double half_way(const Airway& way) {
    double height = 0;
    for (const Vector3& point : way.way->points())
      if (point.x() <= 100) height = point.z();
    return height;
  }

  MergingConfig config;
  supervisor::Knowledge knowledge;
  world::World world{{}, *MergedTeam::level_ground(), {}, {}, {}, {}, {}, {}, {}};
  AirwaySituation situation;
};

// Found by random missions (--mixed --merged 1002106): it got out of the way 51 m upwards, flew
// level and then straight down, and landed 0.3 % below its reserve.
TEST(ShortEnergy, WhatIsFlownUnaskedIsTheLeastCostlyOfTheWays) {
  const HighUp one;
  const Airways ways = one.home(true);
  ASSERT_GT(HighUp::half_way(ways.front()), 90) << "it was to come down at the end";
  const ShortEnergy energy(one.knowledge, one.world, {});
  const Airway& flown = energy.least_costly(ways);
  EXPECT_LT(HighUp::half_way(flown), 90);
  EXPECT_LT(one.least(flown), one.least(ways.front()) - 0.005);
}

TEST(ShortEnergy, LastsUntilTheWayItselfAndTheLandingTakeAllOfIt) {
  HighUp one;
  const ShortEnergy energy(one.knowledge, one.world, {});
  const Airways level{one.home(true).front()};
  const double straight_home =
      supervisor::least_to_come_home(one.knowledge, one.world, {}, one.situation.state.position);
  const double needed = one.least(level.front());
  ASSERT_GT(needed, straight_home + 0.005);
  one.situation.state.energy = needed + 0.001;
  EXPECT_TRUE(energy.lasts_longer(level, one.situation.state));
  one.situation.state.energy = needed - 0.001;
  EXPECT_FALSE(energy.lasts_longer(level, one.situation.state));
}

TEST(ShortEnergy, LastsAsLongAsOneOfTheWaysIsWithinIt) {
  HighUp one;
  const Airways ways = one.home(true);
  const ShortEnergy energy(one.knowledge, one.world, {});
  one.situation.state.energy = one.least(energy.least_costly(ways)) + 0.001;
  ASSERT_LT(one.situation.state.energy, one.least(ways.front()));
  EXPECT_TRUE(energy.lasts_longer(ways, one.situation.state));
}

// Found by random missions (--anything --deaths 1002112): with all of the margin it came down ten
// seconds after it was there, through the circle of one that was leaving.
TEST(ShortEnergy, OverItsHomeHalfOfTheMarginIsEnoughToComeDown) {
  HighUp one;
  one.situation.state.position = {200, 0, 40};
  functional::Request land;
  land.id = functional::TaskId(8);
  land.type = "land";
  const Airways ways = airways_of(land, false, one.config, one.situation).value();
  const ShortEnergy energy(one.knowledge, one.world, {});
  const double all =
      supervisor::least_to_come_home(one.knowledge, one.world, {}, one.situation.state.position);
  one.situation.state.energy = all - 0.009;
  EXPECT_TRUE(energy.lasts_longer(ways, one.situation.state));
  one.situation.state.energy = all - 0.011;
  EXPECT_FALSE(energy.lasts_longer(ways, one.situation.state));
}

TEST(ShortEnergy, WhoseEnergyDoesNotLastToGetOutOfTheWayStays) {
  MergedTeam team({{"marvin", {-100, 0, 40}}, {"heliv", {100, 0, 40}}}, 4);
  team.drain("heliv", 0.109);
  give_sweep(team, "marvin", goto_of(7, {100, 0, 40}));
  give_sweep(team, "heliv", goto_of(7, {-100, 0, 40}));
  team.run(9);
  EXPECT_THAT(air_of(team.notes("heliv")), Not(Contains("aside")));
  EXPECT_THAT(air_of(team.notes("marvin")), Contains("aside"));
}

// Found by random missions (--anything --deaths 1002112): a blimp waited for 16 min to land, and
// circled over another's pad, which flew unasked through its circle then. Marvin stays.
TEST(ShortEnergy, WhoCannotLandForLongMakesRoomForAnotherThatIsToLand) {
  MergedTeam team({{"marvin", {96, 0, 15}}, {"heliv", {100, 0, 40}}, {"karma", {104, 0, 80}}}, 3);
  team.command("heliv", testing::start_of(7, "land"));
  team.run(70);
  EXPECT_THAT(air_of(team.notes("heliv")), Not(Contains("aside"))) << "nobody wants its air";
  team.command("karma", testing::start_of(7, "land"));
  team.run(30);
  EXPECT_THAT(air_of(team.notes("heliv")), Contains("aside"));
  EXPECT_TRUE(team.is_over("karma", 7));
  team.run(10);
  EXPECT_THAT(team.notes("heliv").back().state, "waits") << "it came back";
}

// Found by random missions (--crossing 50130): it was to get out of the way again meanwhile, found
// no air for that, and asked to be woken at that instant for ever. Karma cannot land: nobody can.
TEST(ShortEnergy, WhoGivesWayToOneThatCannotComeAsksNotToBeWokenForEver) {
  MergedTeam team({{"marvin", {97, 0, 15}}, {"heliv", {100, 0, 40}}, {"karma", {103, 0, 80}}}, 3);
  team.command("heliv", testing::start_of(7, "land"));
  team.command("karma", testing::start_of(7, "land"));
  team.run(300);
  EXPECT_THAT(team.restless(), ::testing::IsEmpty());
  const auto notes = air_of(team.notes("heliv"));
  EXPECT_LE(std::count(notes.begin(), notes.end(), "aside"), 5) << "it goes back and forth";
}

TEST(ShortEnergy, WhoIsAboutToLandDoesSoBeforeItMakesRoom) {
  MergedTeam team({{"marvin", {96, 0, 15}}, {"heliv", {100, 0, 40}}, {"karma", {104, 0, 80}}}, 3);
  team.command("heliv", testing::start_of(7, "land"));
  team.run(2);
  team.command("karma", testing::start_of(7, "land"));
  team.run(30);
  EXPECT_THAT(air_of(team.notes("heliv")), Not(Contains("aside")));
}

}  // namespace
}  // namespace skein::decision_node
