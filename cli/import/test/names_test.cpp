// SPDX-License-Identifier: Apache-2.0
#include "names.hpp"

#include <gtest/gtest.h>

namespace skein::import_tool {
namespace {

TEST(PlainName, KeepsWhatScenariosTakeAndPartsTheRestByOneDash) {
  EXPECT_EQ(plain_name("Danger area (north)"), "Danger-area-north");
  EXPECT_EQ(plain_name("  a_1.b  "), "a_1-b");
  EXPECT_EQ(plain_name("Z\xc3\xbcrich"), "Z-rich");
}

TEST(PlainName, OfWhatHasNoLettersNothingIsLeft) {
  EXPECT_EQ(plain_name("***"), "");
  EXPECT_EQ(plain_name(""), "");
  EXPECT_EQ(plain_name("NULL"), "");
}

TEST(PlainName, IsThirtyTwoLettersLongAtMost) {
  EXPECT_EQ(plain_name(std::string(100, 'a')), std::string(32, 'a'));
}

TEST(Names, ATakenOneGetsANumber) {
  Names names;
  names.reserve("pad");

  EXPECT_EQ(names.make("pad", "place"), "pad-2");
  EXPECT_EQ(names.make("pad", "place"), "pad-3");
  EXPECT_EQ(names.make("", "place"), "place");
  EXPECT_EQ(names.make("?", "place"), "place-2");
}

// Found by a map with a place "Home": the scenario that was made of it was refused.
TEST(Names, WhatEachUavCallsItsHomeGetsANumberInWhateverCase) {
  Names names;
  EXPECT_EQ(names.make("home", "place"), "home-2");
  EXPECT_EQ(names.make("Home", "place"), "Home-2");
  EXPECT_EQ(names.make("ZERO", "place"), "ZERO-2");
  EXPECT_EQ(names.make("homestead", "place"), "homestead");
}

}  // namespace
}  // namespace skein::import_tool
