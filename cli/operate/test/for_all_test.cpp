// SPDX-License-Identifier: Apache-2.0
#include "for_all.hpp"

#include <gtest/gtest.h>

namespace skein::operate_tool {
namespace {

Boards three_uavs() {
  Boards boards;
  boards.ground.emplace();
  boards.ground->uavs = {"marvin", "heliv", "karma"};
  boards.uavs["heliv"].holder = "ada";
  boards.uavs["karma"].holder = "bo";
  for (const auto& uav : boards.ground->uavs) boards.uavs[uav].uav = uav;
  return boards;
}

TEST(ForAll, IsAskedForByAnActionThatNamesAll) {
  EXPECT_TRUE(names_all(R"([{"take_in_hand": {"uav": "all"}}])"));
  EXPECT_FALSE(names_all(R"([{"take_in_hand": {"uav": "marvin"}}])"));
  EXPECT_FALSE(names_all(R"([{"finish": true}])"));
  EXPECT_FALSE(names_all("uav: all"));
}

TEST(ForAll, IsOneActionForEachUavAndTheOthersStay) {
  EXPECT_EQ(
      for_all(R"([{"degree": {"uav": "all", "to": 2}}, {"finish": true}])", "ada", three_uavs()),
      R"([{"degree":{"uav":"marvin","to":2}},{"degree":{"uav":"heliv","to":2}},)"
      R"({"degree":{"uav":"karma","to":2}},{"finish":true}])");
}

TEST(ForAll, GivesBackWhatTheOperatorHasAndAsksForWhatOthersHave) {
  EXPECT_EQ(for_all(R"([{"give_back": {"uav": "all"}}])", "ada", three_uavs()),
            R"([{"give_back":{"uav":"heliv"}}])");
  EXPECT_EQ(for_all(R"([{"ask": {"uav": "all"}}])", "ada", three_uavs()),
            R"([{"ask":{"uav":"karma"}}])");
}

}  // namespace
}  // namespace skein::operate_tool
