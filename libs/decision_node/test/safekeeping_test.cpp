// SPDX-License-Identifier: Apache-2.0
// What a UAV does by itself: out of contact, left in the air, in air that closes, short of energy.
// Source: T II.1.2, spec 1.2, 2.6.
#include <gmock/gmock.h>

#include <cmath>

#include "testing/kept_uav.hpp"

namespace skein::decision_node {
namespace {

using testing::closed;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::goto_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kDue;
using testing::KeptUav;
using testing::KeptUavSetup;
using testing::kLost;
using ::testing::Not;
using testing::of;
using testing::start_of;
using testing::takeoff_of;
using world::Vector3;

/// On a goto, out of contact since 10 s.
KeptUav under_way_and_lost(const KeptUavSetup& setup) {
  KeptUav uav(setup);
  uav.flies_at({50, 0, 50});
  uav.command(goto_of(12, {400, 0, 50}));
  uav.loses_the_ground(kLost);
  uav.news();
  return uav;
}

// ---- out of contact ----

TEST(OutOfContact, HoldStopsWhatFliesAndWaits) {
  KeptUav uav = under_way_and_lost(of(ContactPolicy::kHold));

  uav.at(kDue - 1);
  EXPECT_THAT(uav.news(), IsEmpty());
  uav.at(kDue);

  EXPECT_THAT(uav.news(), ElementsAre("policy hold", "interrupt goto", "dispatch wait"));
  EXPECT_THAT(uav.under_way(), ElementsAre("wait"));
}

TEST(OutOfContact, ReturnFliesHomeAndLandsOnlyThen) {
  KeptUav uav = under_way_and_lost(of(ContactPolicy::kReturn));

  uav.at(kDue);
  EXPECT_THAT(uav.news(), ElementsAre("policy return", "interrupt goto", "dispatch goto"));
  const std::vector<double> way = uav.last_way();
  EXPECT_THAT(std::vector<double>(way.end() - 3, way.end()), ElementsAre(0, 0, 50));

  uav.flies_at({0, 0, 50});
  uav.ends("goto");
  EXPECT_THAT(uav.news(), ElementsAre("dispatch land"));
}

TEST(OutOfContact, ItWaitsUntilTheVehicleHasStopped) {
  KeptUav uav = under_way_and_lost(of(ContactPolicy::kHold));
  uav.brakes_slowly();

  uav.at(kDue);
  EXPECT_THAT(uav.news(), ElementsAre("policy hold", "interrupt goto"));

  uav.stops();
  EXPECT_THAT(uav.news(), ElementsAre("dispatch wait"));
}

TEST(OutOfContact, WhatTheGroundStationFliesItselfIsInterruptedFirst) {
  KeptUav uav(of(ContactPolicy::kHold, 1));
  uav.flies_at({50, 0, 50});
  uav.give(ElementaryRequest{{functional::Verb::kDispatch,
                              functional::TaskId(7),
                              "goto",
                              {{"waypoints", "", {400, 0, 50}}}}});
  uav.loses_the_ground(kLost);
  uav.brakes_slowly();
  uav.news();

  uav.at(kDue);
  EXPECT_THAT(uav.news(), ElementsAre("policy hold", "interrupt goto"));

  uav.stops();
  EXPECT_THAT(uav.news(), ElementsAre("dispatch wait"));
}

TEST(OutOfContact, AVehicleOnTheGroundStaysThere) {
  KeptUav uav(of(ContactPolicy::kReturn));
  uav.give(Contact{KeptUav::kGround, true, false});

  uav.at(kDue);

  EXPECT_THAT(uav.news(), ElementsAre("policy return"));
}

// Its takeoff was given before, and waited for something else.
TEST(OutOfContact, OneThatTakesOffAfterThePolicyWasDueFollowsItThen) {
  KeptUav uav(of(ContactPolicy::kHold));
  uav.command(takeoff_of(5, 50));
  uav.give(Contact{KeptUav::kGround, true, false});
  uav.at(30);
  uav.news();

  uav.flies_at({0, 0, 50});
  EXPECT_THAT(uav.news(), IsEmpty()) << "the takeoff is under way";
  uav.ends("takeoff");
  uav.at(61);

  EXPECT_THAT(uav.news(), ElementsAre("policy hold", "dispatch wait"));
}

TEST(OutOfContact, WhatIsOwedIsForgivenWhenTheGroundIsHeardAgain) {
  KeptUav uav(of(ContactPolicy::kHold));
  uav.command(takeoff_of(5, 50));
  uav.give(Contact{KeptUav::kGround, true, false});
  uav.at(30);
  uav.give(Contact{KeptUav::kGround, true, true});
  uav.news();

  uav.flies_at({0, 0, 50});
  uav.ends("takeoff");
  uav.at(61);

  EXPECT_THAT(uav.news(), IsEmpty());
}

TEST(OutOfContact, OneThatDrivesComesHomeWithoutLanding) {
  KeptUavSetup setup = of(ContactPolicy::kReturn);
  setup.drives = true;
  KeptUav uav(setup);
  uav.flies_at({100, 0, 0});
  uav.give(Contact{KeptUav::kGround, true, false});

  uav.at(30);
  EXPECT_THAT(uav.news(), ElementsAre("policy return", "dispatch goto"));
  uav.ends("goto");

  EXPECT_THAT(uav.news(), IsEmpty());
}

bool leads_through(const std::vector<double>& way, const Vector3& middle, double half) {
  for (std::size_t i = 0; i < way.size(); i += 3)
    if (std::abs(way[i] - middle.x()) < half && std::abs(way[i + 1] - middle.y()) < half)
      return true;
  return false;
}

TEST(OutOfContact, TheWayHomeGoesAroundClosedAir) {
  KeptUavSetup setup = of(ContactPolicy::kReturn);
  setup.volumes = {closed("wall", {150, 0, 0}, 40)};
  KeptUav uav(setup);
  uav.flies_at({300, 0, 50});
  uav.give(Contact{KeptUav::kGround, true, false});

  uav.at(30);

  ASSERT_THAT(uav.under_way(), ElementsAre("goto"));
  const std::vector<double>& way = uav.last_way();
  ASSERT_GT(way.size(), 3U) << "not straight home";
  EXPECT_FALSE(leads_through(way, {150, 0, 0}, 40));
}

// The ground station is heard again, and tells it.
TEST(OutOfContact, TheWayHomeGoesAroundAirThatClosesAheadMeanwhile) {
  KeptUav uav(of(ContactPolicy::kReturn));
  uav.flies_at({380, 0, 50});
  uav.give(Contact{KeptUav::kGround, true, false});
  uav.at(30);
  uav.flies_at({300, 0, 50});
  uav.news();

  uav.command(mission::ChangeWorld{closed("behind", {380, 0, 0}, 20)});
  uav.at(40);
  EXPECT_THAT(uav.news(), IsEmpty()) << "it has left that";
  uav.command(mission::ChangeWorld{closed("wall", {150, 0, 0}, 40)});
  uav.at(41);

  EXPECT_THAT(
      uav.news(),
      ElementsAre("policy return: the air on its way home is closed (volume 'wall'): around it",
                  "interrupt goto", "dispatch goto"));
  EXPECT_GT(uav.last_way().size(), 3U) << "not straight home";
  EXPECT_FALSE(leads_through(uav.last_way(), {150, 0, 0}, 40));
  uav.ends("goto");
  EXPECT_THAT(uav.news(), ElementsAre("dispatch land"));
}

/// On its way home from `from`, the air around its pad is closed that far away [m].
std::vector<std::string> when_home_closes(KeptUav& uav, const world::Vector3& from, double radius) {
  uav.flies_at(from);
  uav.give(Contact{KeptUav::kGround, true, false});
  uav.at(30);
  uav.news();
  uav.command(mission::ChangeWorld{closed("home", {0, 0, 0}, radius)});
  uav.at(40);
  uav.at(41);
  return uav.news();
}

// Found by random missions (--anything 984201): one came home into smoke that it knew of.
TEST(OutOfContact, WhereTheAirOverItsPadIsClosedItComesDownOnTheNearestGroundThatServes) {
  KeptUav uav(of(ContactPolicy::kReturn));

  const auto news = when_home_closes(uav, {300, 0, 50}, 60);

  EXPECT_THAT(
      news,
      ElementsAre("policy return: the air on its way home is closed (volume 'home'): around it",
                  "notice: its pad does not serve to land on: it comes down on the nearest ground "
                  "that does",
                  "interrupt goto", "dispatch goto"));
  const std::vector<double> way = uav.last_way();
  const double from_pad = std::hypot(way.at(way.size() - 3), way.at(way.size() - 2));
  EXPECT_GT(from_pad, 60);
  EXPECT_LT(from_pad, 150);
  uav.ends("goto");
  EXPECT_THAT(uav.news(), ElementsAre("dispatch land"));
}

TEST(OutOfContact, WhereNoGroundNearServesItSaysSoAndComesHomeAllTheSame) {
  KeptUav uav(of(ContactPolicy::kReturn));

  EXPECT_THAT(when_home_closes(uav, {900, 0, 50}, 700),
              ElementsAre("notice: the air on its way home is closed (volume 'home'): there is no "
                          "way around it"));
}

// Tasks made by a restarted node at another millisecond have other numbers.
TEST(OutOfContact, OwnTasksAreNumberedByTheMillisecond) {
  KeptUav uav = under_way_and_lost(of(ContactPolicy::kHold));

  uav.at(kDue);

  EXPECT_EQ(uav.last_id(), functional::kFirstOwnId.value() + 40'000);
}

TEST(OutOfContact, ATaskOfTheGroundsThatMovesTheVehicleTakesThePlaceOfAnOwnOne) {
  KeptUav uav = under_way_and_lost(of(ContactPolicy::kReturn));
  uav.at(kDue);
  uav.give(Contact{KeptUav::kGround, true, true});
  uav.news();

  uav.command(goto_of(13, {200, 0, 50}));

  EXPECT_THAT(uav.news(), ElementsAre("interrupt goto", "dispatch goto"));
  uav.flies_at({200, 0, 50});
  uav.ends("goto");
  EXPECT_THAT(uav.news(), Not(Contains("dispatch land"))) << "that was to follow the way home";
}

// What waited for the vehicle to stop would begin together with what takes its place.
TEST(OutOfContact, AWayHomeThatHasNotBegunIsWithdrawnForAHold) {
  KeptUav uav = under_way_and_lost(of(ContactPolicy::kReturn));
  uav.brakes_slowly();
  uav.at(kDue);
  uav.give(Contact{KeptUav::kGround, true, true});
  uav.news();

  uav.command(mission::ChangeDegree{3, true});
  uav.stops();

  EXPECT_THAT(uav.news(), ElementsAre("dispatch wait"));
}

// ---- a landing that the vehicle gives up ----

TEST(LastLanding, ThatTheVehicleGivesUpIsTriedAgainWithGrowingPauses) {
  KeptUav uav = under_way_and_lost(of(ContactPolicy::kReturn));
  uav.at(kDue);
  uav.flies_at({0, 0, 50});
  uav.ends("goto");

  double now = kDue;
  for (const double pause : {10, 20, 40, 60, 60}) {
    uav.news();
    uav.gives_up("land", "an obstacle");
    EXPECT_THAT(uav.news(),
                ElementsAre(HasSubstr("the vehicle gave its landing up (an obstacle); once more")));
    uav.at(now + pause - 0.1);
    EXPECT_THAT(uav.under_way(), IsEmpty()) << pause;
    uav.at(now += pause);
    EXPECT_THAT(uav.news(), Contains("policy return: it has not come down: once more"));
    if (uav.under_way() == std::vector<std::string>{"goto"}) uav.ends("goto");
    EXPECT_THAT(uav.under_way(), ElementsAre("land")) << pause;
  }
}

TEST(LastLanding, ThatIsInterruptedForAnotherTaskIsNotTriedAgain) {
  KeptUav uav = under_way_and_lost(of(ContactPolicy::kReturn));
  uav.at(kDue);
  uav.flies_at({0, 0, 50});
  uav.ends("goto");
  uav.give(Contact{KeptUav::kGround, true, true});
  uav.command(goto_of(13, {200, 0, 50}));
  uav.news();

  uav.flies_at({200, 0, 50});
  uav.ends("goto");
  uav.at(kDue + 100);

  EXPECT_THAT(uav.news(), IsEmpty());
}

// ---- a hold ----

TEST(Hold, EndsWhenTheEnergyLastsNoLongerThanToComeHome) {
  KeptUav uav = under_way_and_lost(of(ContactPolicy::kHold));
  uav.at(kDue);
  uav.news();

  uav.flies_at({100, 0, 50}, 0.5);
  EXPECT_THAT(uav.news(), IsEmpty());
  uav.flies_at({100, 0, 50}, 0.11);

  EXPECT_THAT(uav.news(),
              ElementsAre("policy return: held until the energy lasts no longer than to come home",
                          "interrupt wait", "dispatch goto"));
}

TEST(Hold, LeavesAirThatClosesAroundItAndHoldsBeside) {
  KeptUavSetup setup = of(ContactPolicy::kHold);
  setup.volumes = {closed("smoke", {100, 0, 0}, 50, 300)};
  KeptUav uav = under_way_and_lost(setup);
  uav.at(kDue);
  uav.at(200);
  EXPECT_THAT(uav.under_way(), ElementsAre("wait"));
  uav.news();

  uav.at(245);  // a minute before it closes

  EXPECT_THAT(uav.news(),
              ElementsAre("policy hold: the air around it is closed (volume 'smoke'): it leaves",
                          "interrupt wait", "dispatch goto"));
  const std::vector<double> way = uav.last_way();
  const Vector3 beside(way[way.size() - 3], way[way.size() - 2], way.back());
  EXPECT_TRUE(std::abs(beside.x() - 100) > 50 || std::abs(beside.y()) > 50);

  uav.flies_at({120, 10, 50});
  EXPECT_THAT(uav.news(), IsEmpty()) << "it is on its way out";
  uav.flies_at(beside);
  uav.ends("goto");
  EXPECT_THAT(uav.news(), ElementsAre("dispatch wait"));
}

// The way out still waits for the vehicle to stop when the energy runs short.
TEST(Hold, AWayOutThatHasNotBegunIsWithdrawnForTheWayHome) {
  KeptUavSetup setup = of(ContactPolicy::kHold);
  setup.volumes = {closed("smoke", {100, 0, 0}, 50, 300)};
  KeptUav uav = under_way_and_lost(setup);
  uav.at(kDue);
  uav.brakes_slowly();
  uav.at(245);
  uav.flies_at({100, 0, 50}, 0.11);
  uav.news();

  uav.stops();
  EXPECT_THAT(uav.news(), ElementsAre("dispatch goto"));
  uav.flies_at({0, 0, 50}, 0.105);
  uav.ends("goto");

  EXPECT_THAT(uav.news(), ElementsAre("dispatch land"));
}

}  // namespace
}  // namespace skein::decision_node
