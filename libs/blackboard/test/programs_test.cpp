// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/programs.hpp"

#include <gtest/gtest.h>

namespace skein::blackboard {
namespace {

TEST(Programs, AreKnownFromTheirDiscoveryUntilTheyAreGone) {
  Programs programs;
  EXPECT_EQ(programs.description_of("marvin"), std::nullopt);
  programs.found("1", "marvin", "skein");
  programs.found("2", "karma", "");
  EXPECT_EQ(programs.description_of("marvin"), "skein");
  EXPECT_EQ(programs.description_of("karma"), "");
  programs.gone("1");
  EXPECT_EQ(programs.description_of("marvin"), std::nullopt);
  EXPECT_EQ(programs.description_of("karma"), "");
}

TEST(Programs, ThatWereStartedAgainAreWhatTheySayNow) {
  Programs programs;
  programs.found("9", "marvin", "before");
  programs.found("1", "marvin", "now");
  EXPECT_EQ(programs.description_of("marvin"), "now");
  programs.found("9", "marvin", "said again");
  EXPECT_EQ(programs.description_of("marvin"), "now");
  programs.gone("9");
  EXPECT_EQ(programs.description_of("marvin"), "now");
}

// A stranger's word must not keep a mission from starting.
TEST(Programs, WithKeysCountOnceTheyAreProved) {
  Programs programs;
  programs.found("1", "marvin", "known");
  programs.found("2", "marvin", "forged", false);
  EXPECT_EQ(programs.description_of("marvin"), "known");
  programs.found("3", "marvin", "new", false);
  programs.found("3", "marvin", "forged");
  programs.proved("3");
  programs.proved("4");
  EXPECT_EQ(programs.description_of("marvin"), "new");
}

}  // namespace
}  // namespace skein::blackboard
