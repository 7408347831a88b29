// SPDX-License-Identifier: Apache-2.0
#include "player.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace skein::replay_tool {
namespace {

const MissionTime kUntil = MissionTime::seconds(100);

TEST(Player, PlaysAtItsSpeedAndHaltsAtTheEnd) {
  Player player(kUntil, 10);

  player.advance(Duration::seconds(3));
  EXPECT_EQ(player.at(), MissionTime::seconds(30));
  EXPECT_TRUE(player.playing());

  player.advance(Duration::seconds(60));
  EXPECT_EQ(player.at(), kUntil);
  EXPECT_FALSE(player.playing());
}

TEST(Player, StandsStillWhileItIsHalted) {
  Player player(kUntil, 10);
  EXPECT_FALSE(player.carry_out({false, std::nullopt, std::nullopt}));

  player.advance(Duration::seconds(3));

  EXPECT_EQ(player.at(), MissionTime());
}

TEST(Player, SaysWhetherTimeWentBack) {
  Player player(kUntil, 1);

  EXPECT_FALSE(player.carry_out({std::nullopt, std::nullopt, MissionTime::seconds(50)}));
  EXPECT_FALSE(player.carry_out({std::nullopt, std::nullopt, MissionTime::seconds(50)}));
  EXPECT_TRUE(player.carry_out({std::nullopt, std::nullopt, MissionTime::seconds(49)}));
}

TEST(Player, GoesNoFurtherThanTheEnd) {
  Player player(kUntil, 1);

  (void)player.carry_out({std::nullopt, std::nullopt, MissionTime::seconds(5000)});

  EXPECT_EQ(player.at(), kUntil);
}

RC_GTEST_PROP(PlayerLaw, ManyShortTurnsComeWhereOneLongTurnDoes, ()) {
  const auto turns = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 200));
  Player many(MissionTime::seconds(1'000'000), 7), one(MissionTime::seconds(1'000'000), 7);
  Duration all;
  for (const int turn : turns) {
    many.advance(Duration::milliseconds(turn));
    all = all + Duration::milliseconds(turn);
  }
  one.advance(all);
  RC_ASSERT(many.at() == one.at());
}

TEST(Wish, IsReadFromThePagesRequest) {
  const auto wish = wish_of(R"([{"playback": {"playing": false, "speed": 20, "at": 12.5}}])");

  ASSERT_TRUE(wish.has_value());
  EXPECT_EQ(wish->playing, false);
  EXPECT_EQ(wish->speed, 20);
  EXPECT_EQ(wish->at, MissionTime::seconds(12.5));
}

TEST(Wish, AnythingElseIsRefusedWithWhatWasExpected) {
  for (const char* actions :
       {"", "{}", "[]", "[1]", R"([{"take_in_hand": {"uav": "marvin"}}])",
        R"([{"playback": {"at": "noon"}}])", R"([{"playback": {"at": -1}}])",
        R"([{"playback": {"speed": 0}}])", R"([{"playback": {"speed": 1e9}}])",
        R"([{"playback": {"backwards": true}}])", R"([{"playback": {}}, {"playback": {}}])"}) {
    const auto wish = wish_of(actions);
    ASSERT_FALSE(wish.has_value()) << actions;
    EXPECT_NE(wish.error().why.find("playback"), std::string::npos) << actions;
  }
}

}  // namespace
}  // namespace skein::replay_tool
