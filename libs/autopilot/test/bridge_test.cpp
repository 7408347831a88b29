// SPDX-License-Identifier: Apache-2.0
#include "skein/autopilot/bridge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mav.hpp"
#include "testing/any_message.hpp"
#include "testing/rig.hpp"

namespace skein::autopilot {
namespace {

using functional::Parameters;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Rig;
using ::testing::SizeIs;
using ::testing::StartsWith;

constexpr CustomMode kPosition = 3U << 16U;  // PX4
constexpr CustomMode kLoiter = 5;            // ArduPilot

class EachDialect : public ::testing::TestWithParam<Dialect> {};
INSTANTIATE_TEST_SUITE_P(Dialects, EachDialect,
                         ::testing::Values(Dialect::kPx4, Dialect::kArdupilot),
                         [](const auto& one) { return std::string(to_text(one.param)); });

TEST_P(EachDialect, TakesOffToTheHeightOverTheGroundThatWasAskedFor) {
  Rig rig(GetParam());
  rig.take_off();

  EXPECT_NEAR(rig.vehicle().state().position.z(), 150, 2);
  EXPECT_THAT(rig.told(1), ElementsAre("running ", "ended "));
}

TEST_P(EachDialect, FliesThroughItsWayPointsAndStaysAtTheLast) {
  Rig rig(GetParam());
  rig.take_off();
  const auto way = rig.dispatch(
      "goto", Parameters().add("waypoints", {80, 0, 150, 80, 60, 170}).add("speed", 6));
  double nearest = 1e9;
  rig.until("there", [&] {
    const auto& at = rig.vehicle().state().position;
    nearest = std::min(nearest, (at - world::Vector3(80, 0, 150)).norm());
    EXPECT_LT(rig.vehicle().state().velocity.head<2>().norm(), 6.5);
    return rig.last_of(way) == "ended ";
  });
  rig.run(10);

  EXPECT_LT(nearest, 4);
  EXPECT_LT((rig.vehicle().state().position - world::Vector3(80, 60, 170)).norm(), 3);
}

TEST_P(EachDialect, LandsAndIsDisarmed) {
  Rig rig(GetParam());
  rig.take_off();
  const auto landing = rig.dispatch("land");
  rig.until("down", [&] { return rig.last_of(landing) == "ended "; });
  rig.run(3);

  EXPECT_FALSE(rig.vehicle().state().airborne);
  EXPECT_FALSE(rig.vehicle().is_armed());
  EXPECT_EQ(rig.telemetry().back().state.activity, "on the ground");
  rig.take_off();
}

TEST_P(EachDialect, AnInterruptedWayEndsWhereItCanStop) {
  Rig rig(GetParam());
  rig.take_off();
  const auto way = rig.fly_away();
  const auto at = rig.vehicle().state().position;
  rig.interrupt(way);
  rig.until("at rest", [&] { return rig.last_of(way) == "aborted interrupted"; });

  EXPECT_LT((rig.vehicle().state().position - at).norm(), 45);
  EXPECT_LT(rig.vehicle().state().velocity.norm(), 0.5);
}

TEST_P(EachDialect, ThePilotWinsAndThePlanIsTold) {
  Rig rig(GetParam());
  rig.take_off();
  const auto way = rig.fly_away();
  const auto look = rig.dispatch("takeshot", Parameters().add("device", "visible"));
  const bool is_px4 = GetParam() == Dialect::kPx4;
  rig.vehicle().set_mode(is_px4 ? kPosition : kLoiter);
  rig.run(1.5);

  const std::string taken =
      std::string("taken in hand by the pilot: ") + (is_px4 ? "Position" : "LOITER");
  EXPECT_EQ(rig.last_of(way), "aborted " + taken);
  EXPECT_EQ(rig.last_of(look), "aborted " + taken);
  EXPECT_THAT(rig.notices(), Contains(taken));
  EXPECT_EQ(rig.telemetry().back().state.activity, taken);

  const int commands = rig.vehicle().count(mav::kDoReposition);
  const auto again = rig.dispatch("goto", Parameters().add("waypoints", {0, 0, 150}));
  const auto landing = rig.dispatch("land");
  rig.run(10);
  EXPECT_EQ(rig.last_of(again), "aborted " + taken);
  EXPECT_EQ(rig.last_of(landing), "aborted " + taken);
  EXPECT_EQ(rig.vehicle().count(mav::kDoReposition), commands) << "the pilot is not fought";
  EXPECT_FALSE(rig.vehicle().heard_sticks());

  rig.vehicle().set_mode(guided_mode(GetParam()));
  rig.run(2);
  EXPECT_THAT(rig.notices(), Contains("the vehicle may be asked for tasks again"));
  const auto third = rig.dispatch("goto", Parameters().add("waypoints", {0, 0, 150}));
  rig.until("there", [&] { return rig.last_of(third) == "ended "; });
}

TEST_P(EachDialect, AFailsafeIsToldAsOne) {
  Rig rig(GetParam());
  rig.take_off();
  const auto way = rig.fly_away();
  rig.vehicle().begin_failsafe();
  rig.run(1.5);

  EXPECT_THAT(rig.last_of(way), StartsWith("aborted the autopilot's failsafe took over: R"));
  EXPECT_THAT(rig.notices(), Contains("the autopilot says that its state is critical"));
  rig.until("home and down", [&] { return !rig.vehicle().is_armed(); });
  EXPECT_LT(rig.vehicle().state().position.head<2>().norm(), 5);
}

TEST_P(EachDialect, AVehicleInFlightIsFlownOnByABridgeThatWasStartedAnew) {
  Rig rig(GetParam());
  rig.take_off();
  rig.bridge() = Bridge(Rig::config());
  rig.until(
      "ready", [&] { return rig.bridge().is_ready(); }, 20);
  rig.run(2);

  const auto way = rig.dispatch("goto", Parameters().add("waypoints", {50, 0, 150}));
  rig.until("there", [&] { return rig.last_of(way) == "ended "; });
  EXPECT_LT((rig.vehicle().state().position - world::Vector3(50, 0, 150)).norm(), 3);
}

TEST(Bridge, BeforeAnAutopilotIsHeardTasksAreRefused) {
  Rig rig;
  rig.vehicle().be_silent(true);
  rig.run(3);
  const auto task = rig.dispatch("takeoff", Parameters().add("altitude", 30));

  EXPECT_EQ(rig.last_of(task), "aborted no autopilot is heard");
  EXPECT_THAT(rig.telemetry(), IsEmpty());
}

TEST(Bridge, SaysThatItLivesOnceASecond) {
  Bridge bridge(Rig::config());
  int beats = 0;
  for (int i = 0; i < 100; ++i) {
    for (const Effect& one :
         bridge.handle(Tick{}, Duration::milliseconds(100) + Duration::seconds(i / 10.0)))
      beats += std::holds_alternative<Transmit>(one) ? 1 : 0;
  }
  EXPECT_EQ(beats, 10);
}

TEST(Bridge, WhenTheAutopilotFallsSilentTasksAreAborted) {
  Rig rig;
  rig.take_off();
  const auto way = rig.fly_away();
  rig.vehicle().be_silent(true);
  rig.run(3.5);
  EXPECT_EQ(rig.last_of(way), "running ");
  rig.run(2);
  EXPECT_EQ(rig.last_of(way), "aborted the autopilot is not heard any more");
  const auto told = rig.telemetry().size();
  rig.run(5);
  EXPECT_EQ(rig.telemetry().size(), told) << "nothing is known of it";

  rig.vehicle().be_silent(false);
  rig.run(3);
  EXPECT_GT(rig.telemetry().size(), told);
}

TEST(Bridge, ALateHeartbeatIsNoLostLink) {
  Rig rig;
  rig.take_off();
  const auto way = rig.fly_away();
  rig.vehicle().be_silent(true);
  rig.run(3);
  rig.vehicle().be_silent(false);
  rig.run(5);

  EXPECT_EQ(rig.last_of(way), "running ");
}

TEST(Bridge, AnAutopilotThatDoesNotAnswerIsSaid) {
  Rig rig;
  rig.until("ready", [&] { return rig.bridge().is_ready(); });
  rig.run(2);
  rig.vehicle().be_mute(true);
  const auto task = rig.dispatch("takeoff", Parameters().add("altitude", 30));
  rig.run(5);

  EXPECT_EQ(rig.last_of(task), "aborted the autopilot did not answer DO_SET_MODE");
}

TEST(Bridge, ARefusedTakeoffIsToldWithWhatWasRefused) {
  Rig rig;
  rig.until("ready", [&] { return rig.bridge().is_ready(); });
  rig.vehicle().refuse(mav::kComponentArmDisarm, 2);
  const auto task = rig.dispatch("takeoff", Parameters().add("altitude", 30));
  rig.run(5);

  EXPECT_EQ(rig.last_of(task), "aborted the autopilot answered COMPONENT_ARM_DISARM by 'denied'");
  EXPECT_FALSE(rig.vehicle().state().airborne);
}

TEST(Bridge, AVehicleThatIsDisarmedBeforeItRoseIsSaid) {
  Rig rig;
  rig.until("ready", [&] { return rig.bridge().is_ready(); });
  const auto task = rig.dispatch("takeoff", Parameters().add("altitude", 30));
  rig.until("running", [&] { return rig.last_of(task) == "running "; });
  rig.vehicle().set_armed(false);
  rig.run(12);

  EXPECT_EQ(rig.last_of(task), "aborted the vehicle was disarmed");
}

TEST(Bridge, ATakeoffThatIsInterruptedBeforeItRoseIsNotBegun) {
  Rig rig;
  rig.until("ready", [&] { return rig.bridge().is_ready(); });
  rig.run(2);
  const auto task = rig.dispatch("takeoff", Parameters().add("altitude", 30));
  rig.interrupt(task);
  rig.run(10);

  EXPECT_THAT(rig.told(task), ElementsAre("aborted interrupted"));
  EXPECT_FALSE(rig.vehicle().is_armed());
}

TEST(Bridge, ALandingNearlyDoneIsDone) {
  Rig rig;
  rig.take_off();
  const auto landing = rig.dispatch("land");
  rig.until("low", [&] { return rig.vehicle().state().position.z() < 122; });
  rig.interrupt(landing);
  rig.until("down", [&] { return !rig.vehicle().state().airborne; });
  rig.run(3);

  EXPECT_EQ(rig.last_of(landing), "aborted interrupted too low to stop the landing: landed");
}

TEST(Bridge, ALandingThatIsInterruptedHighStops) {
  Rig rig;
  rig.take_off();
  const auto landing = rig.dispatch("land");
  rig.until("sinking", [&] { return rig.vehicle().state().position.z() < 145; });
  rig.interrupt(landing);
  rig.until("at rest", [&] { return rig.last_of(landing) == "aborted interrupted"; });

  EXPECT_TRUE(rig.vehicle().state().airborne);
  EXPECT_EQ(rig.vehicle().mode(), guided_mode(Dialect::kArdupilot));
}

TEST(Bridge, TheBatteryIsWhatTheVehicleSays) {
  Rig rig;
  rig.until("ready", [&] { return rig.bridge().is_ready(); });
  rig.vehicle().set_battery(9);
  rig.run(5);
  EXPECT_EQ(rig.telemetry().back().state.energy, 0.09);

  const auto task = rig.dispatch("takeoff", Parameters().add("altitude", 250));
  EXPECT_THAT(rig.last_of(task), HasSubstr("energy too low"));
}

TEST(Bridge, APictureIsALookThatDetectedNothing) {
  Rig rig;
  rig.take_off();
  const auto shots = rig.dispatch(
      "takeshot",
      Parameters().add("device", "visible").add("target", {50, 0, 120}).add("shots", 3));
  rig.until("seen", [&] { return rig.last_of(shots) == "ended "; });

  EXPECT_EQ(rig.vehicle().pictures(), 3);
  ASSERT_THAT(rig.perceptions(), SizeIs(3));
  EXPECT_EQ(rig.perceptions()[0].device, "visible");
  EXPECT_THAT(rig.perceptions()[0].detections, IsEmpty());
  EXPECT_GT(rig.perceptions()[0].direction.x(), 0.5) << "towards the target";
}

TEST(Bridge, ACameraThatDoesNotTakeThePictureAbortsTheLook) {
  Rig rig;
  rig.take_off();
  rig.vehicle().refuse(mav::kDoDigicamControl, 3);
  const auto look = rig.dispatch("monitor", Parameters().add("device", "visible"));
  rig.run(2);

  EXPECT_EQ(rig.last_of(look),
            "aborted no picture was taken: the autopilot answered DO_DIGICAM_CONTROL by "
            "'unsupported'");
  EXPECT_THAT(rig.perceptions(), IsEmpty());
  const auto way = rig.dispatch("goto", Parameters().add("waypoints", {20, 0, 150}));
  rig.until("free again", [&] { return rig.last_of(way) == "ended "; });
}

TEST(Bridge, TasksOutliveASilentDecisionNodeForTwoMinutes) {
  Rig rig;
  rig.take_off();
  const auto wait = rig.dispatch("wait");
  rig.give(ContactLost{true, false});
  rig.run(119);
  EXPECT_EQ(rig.last_of(wait), "running ");
  rig.run(2);
  EXPECT_EQ(rig.last_of(wait), "aborted contact with the decision node lost");
}

TEST(Bridge, ADecisionNodeThatForgotEverythingLeavesTheVehicleWhereItIs) {
  Rig rig;
  rig.take_off();
  const auto way = rig.fly_away();
  rig.give(ContactLost{false, true});
  EXPECT_EQ(rig.last_of(way), "aborted the decision node has forgotten it");
  rig.run(10);
  EXPECT_LT(rig.vehicle().state().velocity.norm(), 0.5);
}

TEST(Bridge, AnAutopilotThatWasStartedAnewIsAskedAgainForItsMessages) {
  Rig rig;
  rig.until("ready", [&] { return rig.bridge().is_ready(); });
  rig.run(2);
  rig.vehicle().forget_messages();
  rig.run(5);
  EXPECT_FALSE(rig.bridge().is_ready());
  rig.run(10);
  EXPECT_TRUE(rig.bridge().is_ready());
}

TEST(Bridge, WarningsOfTheAutopilotArePassedOn) {
  Rig rig;
  rig.until("ready", [&] { return rig.bridge().is_ready(); });
  rig.vehicle().say("PreArm: Compass not calibrated");
  rig.run(0.5);
  EXPECT_THAT(rig.notices(), Contains("the autopilot says: PreArm: Compass not calibrated"));
}

TEST(Bridge, OtherSystemsOnTheLinkAreNotItsVehicle) {
  Rig rig;
  rig.until("ready", [&] { return rig.bridge().is_ready(); });
  mavlink::GlobalPositionInt elsewhere;
  elsewhere.lat = elsewhere.lon = 1;
  rig.run(2);
  const auto before = rig.telemetry().back().state.position;
  rig.give(
      Heard{mavlink::to_bytes(mavlink::to_frame(mavlink::Heartbeat{4, 2, 3, 0, 4, 3}, {7, 1}, 0))});
  rig.give(Heard{mavlink::to_bytes(mavlink::to_frame(elsewhere, {7, 1}, 1))});
  rig.run(2);

  EXPECT_LT((rig.telemetry().back().state.position - before).norm(), 0.1);
  EXPECT_THAT(rig.notices(), Contains("system 7 is on the link too: --system-id chooses"));
}

RC_GTEST_PROP(Bridge, WhateverItIsToldItHoldsToTheContract, ()) {
  Rig rig;
  rig.run(3);
  std::uint64_t asked = 0;
  const int count = *rc::gen::inRange(1, 60);
  for (int i = 0; i < count; ++i) {
    const mavlink::Address from{1, 1};
    rig.give(Heard{mavlink::to_bytes(mavlink::to_frame(mavlink::any_message(), from, 0))});
    rig.give(Heard{*rc::gen::arbitrary<mavlink::Bytes>()});
    const std::string type =
        *rc::gen::element<std::string>("takeoff", "goto", "land", "wait", "monitor");
    Parameters parameters;
    if (type == "takeoff") parameters.add("altitude", 30);
    if (type == "goto") parameters.add("waypoints", {50, 0, 150});
    if (type == "monitor") parameters.add("device", "visible");
    asked = rig.dispatch(type, parameters);
    if (*rc::gen::arbitrary<bool>()) rig.interrupt(*rc::gen::inRange<std::uint64_t>(1, asked + 1));
    rig.run(0.5);
  }
  rig.give(ContactLost{false, true});
  rig.run(60);

  for (std::uint64_t task = 1; task <= asked; ++task) {
    const auto told = rig.told(task);
    RC_ASSERT(!told.empty());
    RC_ASSERT(told.back().starts_with("ended") || told.back().starts_with("aborted "));
  }
  RC_ASSERT(!rig.vehicle().heard_sticks());
}

TEST(Bridge, AGroundStationIsNoVehicle) {
  Bridge bridge(Rig::config());
  const mavlink::Heartbeat station{0, mav::kTypeGroundStation, mav::kNoAutopilot, 0, 4, 3};
  const auto effects = bridge.handle(
      Heard{mavlink::to_bytes(mavlink::to_frame(station, {255, 190}, 0))}, Duration::seconds(1));
  for (const Effect& one : effects) EXPECT_FALSE(std::holds_alternative<Notice>(one));
}

}  // namespace
}  // namespace skein::autopilot
