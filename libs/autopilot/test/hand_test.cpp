// SPDX-License-Identifier: Apache-2.0
#include "hand.hpp"

#include <gtest/gtest.h>

#include "mav.hpp"
#include "testing/rig.hpp"

namespace skein::autopilot {
namespace {

constexpr CustomMode kGuided = 4, kLoiter = 5, kReturn = 6, kLand = 9;
Duration at(double seconds) { return Duration::seconds(seconds); }

/// A vehicle of ArduPilot's, or PX4's, by its heartbeats alone.
class HandTest : public ::testing::Test {
 protected:
  /// True when it was just taken.
  bool beat(CustomMode mode, bool armed, double seconds, std::uint8_t status = mav::kStateActive) {
    mavlink::Heartbeat heartbeat;
    heartbeat.autopilot = autopilot_;
    heartbeat.custom_mode = mode;
    heartbeat.base_mode = static_cast<std::uint8_t>((armed ? mav::kArmedFlag : 0) | flags_);
    heartbeat.system_status = status;
    picture_.hear(heartbeat, at(seconds));
    return hand_.look_at(picture_, at(seconds));
  }
  std::string taken() const { return hand_.taken().value_or(""); }

  std::uint8_t autopilot_ = mav::kArdupilot;
  std::uint8_t flags_ = mav::kManualInputFlag;  // ArduPilot sets it always
  BridgeConfig config_ = testing::Rig::config();
  Picture picture_{config_};
  Hand hand_;
};

TEST_F(HandTest, DisarmedItIsNobodysInAnyMode) {
  EXPECT_FALSE(beat(kLoiter, false, 0));
  EXPECT_EQ(taken(), "");
}

TEST_F(HandTest, ArmedInAModeThatWasNotAskedForItIsThePilots) {
  EXPECT_FALSE(beat(kGuided, true, 0));
  EXPECT_TRUE(beat(kLoiter, true, 1));
  EXPECT_EQ(taken(), "taken in hand by the pilot: LOITER");
  EXPECT_FALSE(beat(kLoiter, true, 2)) << "told once";
}

TEST_F(HandTest, TheGuidedModeGivesItBack) {
  beat(kLoiter, true, 0);
  EXPECT_FALSE(beat(kGuided, true, 1));
  EXPECT_EQ(taken(), "");
  EXPECT_TRUE(beat(kLoiter, true, 2)) << "and may be taken again";
}

TEST_F(HandTest, AModeThatWasAskedForMayTakeItsTimeToCome) {
  beat(kGuided, true, 0);
  hand_.ask_for({kLand}, at(1));

  EXPECT_FALSE(beat(kGuided, true, 2));
  EXPECT_FALSE(beat(kLand, true, 3));
  EXPECT_TRUE(beat(kGuided, true, 4.5)) << "the pilot stops the landing";
}

TEST_F(HandTest, LandingWithoutBeingAskedIsNotOurs) {
  beat(kGuided, true, 0);
  EXPECT_TRUE(beat(kLand, true, 1));
}

TEST_F(HandTest, AFailsafeIsCalledSo) {
  beat(kGuided, true, 0);
  EXPECT_TRUE(beat(kReturn, true, 1, mav::kStateCritical));
  EXPECT_EQ(taken(), "the autopilot's failsafe took over: RTL");
}

TEST_F(HandTest, ACriticalStateAloneTakesNothing) {
  EXPECT_FALSE(beat(kGuided, true, 1, mav::kStateCritical));
  EXPECT_EQ(taken(), "");
}

TEST_F(HandTest, OfPx4TheSticksCount) {
  autopilot_ = mav::kPx4;
  flags_ = 0;
  const CustomMode hold = guided_mode(Dialect::kPx4);
  EXPECT_FALSE(beat(hold, true, 0));
  flags_ = mav::kManualInputFlag;
  EXPECT_TRUE(beat(hold, true, 1));
  flags_ = 0;
  EXPECT_FALSE(beat(hold, true, 2));
  EXPECT_EQ(taken(), "");
}

TEST(Dialects, AreNamedAndRecognised) {
  for (const Dialect one : {Dialect::kPx4, Dialect::kArdupilot})
    EXPECT_EQ(dialect_from(to_text(one)), one);
  EXPECT_EQ(dialect_from("betaflight"), std::nullopt);
  EXPECT_EQ(dialect_of(mav::kPx4), Dialect::kPx4);
  EXPECT_EQ(dialect_of(mav::kNoAutopilot), std::nullopt);
  EXPECT_EQ(name_of(Dialect::kArdupilot, 4), "GUIDED");
  EXPECT_EQ(name_of(Dialect::kPx4, 0x03040000), "Hold");
  EXPECT_EQ(name_of(Dialect::kArdupilot, 99), "mode 99");
}

}  // namespace
}  // namespace skein::autopilot
