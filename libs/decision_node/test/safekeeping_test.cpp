// SPDX-License-Identifier: Apache-2.0
// What a UAV does by itself: out of contact, left in the air, in air that closes, short of energy.
// Source: T II.1.2, spec 1.2, 2.6.
#include <gmock/gmock.h>

#include "testing/kept_uav.hpp"

namespace skein::decision_node {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using testing::goto_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::KeptUav;
using testing::KeptUavSetup;
using ::testing::Not;
using testing::start_of;
using testing::takeoff_of;
using world::Vector3;

constexpr double kLost = 10, kDue = 40;

KeptUavSetup of(ContactPolicy policy, int degree = 3) {
  KeptUavSetup setup;
  setup.policy = policy;
  setup.degree = degree;
  return setup;
}

world::Volume closed(const std::string& name, const Vector3& middle, double half, double from = 0) {
  const double x = middle.x(), y = middle.y();
  world::Volume volume;
  volume.name = name;
  volume.polygon = {
      {x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
  volume.when.from = MissionTime::seconds(from);
  return volume;
}

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

TEST(OutOfContact, WhereThereIsNoWayAroundItSaysSoAndComesHomeAllTheSame) {
  KeptUav uav(of(ContactPolicy::kReturn));
  uav.flies_at({300, 0, 50});
  uav.give(Contact{KeptUav::kGround, true, false});
  uav.at(30);
  uav.news();

  uav.command(mission::ChangeWorld{closed("home", {0, 0, 0}, 60)});
  uav.at(40);
  uav.at(41);

  EXPECT_THAT(uav.news(),
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

// ---- left in the air ----

/// At degree 4, its deliberation stopped by a loss of contact that is over, and its hold ended by
/// an operator who then did nothing more.
KeptUav left_alone(const std::vector<world::Volume>& volumes = {}, int degree = 4) {
  KeptUavSetup setup = of(ContactPolicy::kHold, degree);
  setup.volumes = volumes;
  KeptUav uav(setup);
  uav.loses_the_ground(kLost);
  uav.at(kDue);
  uav.give(Contact{KeptUav::kGround, true, true});
  uav.command(goto_of(13, {100, 0, 50}));
  uav.ends("goto");
  uav.news();
  return uav;
}

TEST(LeftInTheAir, ComesHomeOnceItsEnergyLastsNoLongerThanThat) {
  KeptUav uav = left_alone();

  uav.at(100);
  uav.flies_at({100, 0, 50}, 0.5);
  EXPECT_THAT(uav.news(), IsEmpty());
  uav.at(200);
  uav.flies_at({100, 0, 50}, 0.11);
  uav.at(206);

  EXPECT_THAT(uav.news(),
              ElementsAre("notice: its energy lasts no longer than to come home",
                          "policy return: left in the air without a task, and its deliberation "
                          "was stopped",
                          "dispatch goto"));
}

TEST(LeftInTheAir, BelowDegreeFourItOnlySaysSoOnceAFlight) {
  KeptUav uav = left_alone({}, 3);

  for (double now = 100; now < 130; now += 6) {
    uav.flies_at({100, 0, 50}, 0.11);
    uav.at(now);
  }
  EXPECT_THAT(uav.news(), ElementsAre("notice: its energy lasts no longer than to come home"));

  uav.flies_at({0, 0, 0}, 0.11);
  uav.flies_at({100, 0, 50}, 0.11);
  uav.at(140);
  EXPECT_THAT(uav.news(), ElementsAre("notice: its energy lasts no longer than to come home"));
}

TEST(LeftInTheAir, WhileATaskOfAnOperatorIsUnderWayItOnlySaysSo) {
  KeptUav uav = left_alone();
  uav.command(start_of(14, "wait"));
  uav.news();

  uav.flies_at({100, 0, 50}, 0.11);
  uav.at(100);

  EXPECT_THAT(uav.news(), ElementsAre("notice: its energy lasts no longer than to come home"));
}

TEST(LeftInTheAir, LeavesAirThatClosesAroundIt) {
  KeptUav uav = left_alone({closed("smoke", {100, 0, 0}, 50, 300)});
  uav.at(200);
  EXPECT_THAT(uav.news(), IsEmpty());

  uav.at(245);

  EXPECT_THAT(uav.news(),
              ElementsAre("policy hold: the air around it is closed (volume 'smoke'): it leaves",
                          "dispatch goto"));
}

TEST(LeftInTheAir, WhileItDeliberatesItsSupervisorLeavesClosedAir) {
  KeptUavSetup setup = of(ContactPolicy::kHold, 4);
  setup.volumes = {closed("smoke", {100, 0, 0}, 50, 300)};
  KeptUav uav(setup);
  uav.flies_at({100, 0, 50});
  uav.news();

  uav.at(245);

  EXPECT_THAT(uav.news(), Not(Contains(HasSubstr("policy"))));
}

const std::string kInSmoke = "notice: it is in air that is closed or about to be (volume 'smoke')";

TEST(LeftInTheAir, BelowDegreeFourItTellsItsOperatorOfClosedAirAndStays) {
  KeptUav uav = left_alone({closed("smoke", {100, 0, 0}, 50, 300)}, 3);

  uav.at(235);
  EXPECT_THAT(uav.news(), IsEmpty());
  uav.at(245);
  EXPECT_THAT(uav.news(), ElementsAre(kInSmoke));
  for (const double later : {265.0, 290.0, 310.0}) uav.at(later);
  EXPECT_THAT(uav.news(), IsEmpty()) << "once is enough";
}

TEST(LeftInTheAir, UnderATaskOfAnOperatorItTellsThemOfClosedAir) {
  KeptUav uav = left_alone({closed("smoke", {100, 0, 0}, 50, 300)});
  uav.command(start_of(14, "wait"));
  uav.news();

  uav.at(245);

  EXPECT_THAT(uav.news(), ElementsAre(kInSmoke));
}

TEST(InAnOperatorsHand, OnlyWhoWasOutOfClosedAirForAWhileTellsOfItAgain) {
  KeptUav uav = left_alone({closed("smoke", {100, 0, 0}, 50)}, 3);
  const Vector3 in{100, 0, 50}, out{300, 0, 50};
  const auto seen = [&](double seconds, const Vector3& at) {
    uav.flies_at(at);
    uav.at(seconds);
    return uav.news();
  };
  seen(100, in);

  EXPECT_THAT(seen(110, out), IsEmpty());
  EXPECT_THAT(seen(115, in), IsEmpty()) << "wavers on the border";
  EXPECT_THAT(seen(120, out), IsEmpty());
  EXPECT_THAT(seen(150, out), IsEmpty());
  EXPECT_THAT(seen(155, in), ElementsAre(kInSmoke));
}

TEST(InAnOperatorsHand, OneThatDrivesTellsOfClosedAirToo) {
  KeptUavSetup setup = of(ContactPolicy::kHold);
  setup.drives = true;
  setup.volumes = {closed("smoke", {100, 0, 0}, 50)};
  KeptUav robot(setup);

  robot.flies_at({100, 0, 0});

  EXPECT_THAT(robot.news(), ElementsAre(kInSmoke));
}

TEST(InAnOperatorsHand, AllVolumesAroundAreNamed) {
  KeptUav uav = left_alone({closed("smoke", {100, 0, 0}, 50, 300), closed("far", {300, 0, 0}, 50),
                            closed("storm", {90, 0, 0}, 60, 300)},
                           3);

  uav.at(245);

  EXPECT_THAT(uav.news(), ElementsAre(kInSmoke, HasSubstr("'storm'")));
}

}  // namespace
}  // namespace skein::decision_node
