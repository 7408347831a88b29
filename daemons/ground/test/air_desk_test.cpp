// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/air_desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/translation/merging.hpp"

namespace skein::ground {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class AirTeam {
 public:
  explicit AirTeam(bool first_life = true) {
    desk_.hear(node::Started{1'795'956'592'855'706'682, first_life}, MissionTime::seconds(0.5));
  }

  node::Effects asks(const std::string& uav, std::uint64_t request, double x) {
    const merging::Volume air{{x, 0}, {x + 50, 0}, 5, 30, 50};
    return tells(uav, {request, {{}, request, {air}, {}}, 0, false, true});
  }
  node::Effects tells(const std::string& uav, const merging::Message& message) {
    const auto from = roster_.find(uav)->number;
    return desk_.hear(node::Received{from, translation::to_wire(message)}, MissionTime::seconds(1))
        .value();
  }
  merging::Message sent(const node::Effects& effects, const std::string& to) const {
    const auto& send = std::get<node::Send>(effects.at(0));
    EXPECT_EQ(send.to, roster_.find(to)->number);
    return translation::from_wire(std::get<wire::MergeMessage>(send.sample)).value();
  }

 private:
  node::Roster roster_{{"marvin", "heliv", "karma"}};
  AirDesk desk_{roster_, {"marvin", "heliv"}};
};

// Found over DDS (--mixed 6004), where the first incarnation is of the clock on the wall: it
// answered nobody until all had spoken to it.
TEST(AirDesk, InItsFirstLifeItHasForgottenNothingWhateverItsIncarnation) {
  AirTeam team;
  EXPECT_TRUE(team.sent(team.asks("heliv", 7, 0), "heliv").granted);
}

TEST(AirDesk, AnswersWhoAsksForAirThatNobodyHas) {
  AirTeam team;
  const merging::Message answer = team.sent(team.asks("heliv", 7, 0), "heliv");
  EXPECT_EQ(answer.answered, 7U);
  EXPECT_TRUE(answer.granted);
}

TEST(AirDesk, WhatItPromisedOneItRefusesAnotherAndSaysWhoHasIt) {
  AirTeam team;
  team.asks("heliv", 7, 0);
  const merging::Message answer = team.sent(team.asks("marvin", 9, 20), "marvin");
  EXPECT_FALSE(answer.granted);
  EXPECT_THAT(answer.claim.waits_for, ElementsAre("heliv"));
}

TEST(AirDesk, PassesOnWhatOneHasToWhoWaitsForItAndAsks) {
  AirTeam team;
  const merging::Volume air{{0, 0}, {50, 0}, 5, 30, 50};
  team.tells("heliv", {7, {{air}, 0, {}, {}}, 0, false, false});
  const merging::Message word =
      team.sent(team.tells("marvin", {9, {{}, 0, {air}, {"heliv"}}, 0, false, true}), "marvin");
  EXPECT_EQ(word.of, "heliv");
  EXPECT_EQ(word.number, 7U);
  EXPECT_THAT(word.claim.held, ElementsAre(air));

  const node::Effects later = team.tells("heliv", {8, {{}, 0, {}, {}}, 0, false, false});
  EXPECT_THAT(team.sent(later, "marvin").claim.held, IsEmpty()) << "and whenever it changes";
}

TEST(AirDesk, WhoDoesNotMergeIsNotAnswered) {
  EXPECT_THAT(AirTeam().asks("karma", 7, 0), IsEmpty());
}

TEST(AirDesk, WhoOnlyTellsIsNotAnswered) {
  EXPECT_THAT(AirTeam().tells("heliv", {1, {{}, 0, {}, {}}, 0, false, false}), IsEmpty());
}

TEST(AirDesk, AStationThatMayHaveForgottenPromisesNothing) {
  EXPECT_THAT(AirTeam(false).asks("heliv", 7, 0), IsEmpty());
}

TEST(AirDesk, OtherSamplesAreForOthers) {
  node::Roster roster({"marvin"});
  AirDesk desk(roster, {"marvin"});
  EXPECT_FALSE(desk.hear(node::Wakeup{}, {}).has_value());
  EXPECT_FALSE(desk.hear(node::Received{roster.find("marvin")->number, wire::Telemetry{}}, {}));
}

}  // namespace
}  // namespace skein::ground
