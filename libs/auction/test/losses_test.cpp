// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/losses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::auction {
namespace {

constexpr MemberNumber kMember{3};

Losses declared(int times) {
  Losses losses;
  for (int i = 0; i < times; ++i) losses.declare(kMember, i % 2 == 0);
  return losses;
}

TEST(Losses, AMemberIsLostUntilItIsFound) {
  EXPECT_FALSE(declared(0).is_lost(kMember));
  EXPECT_TRUE(declared(1).is_lost(kMember));
  EXPECT_FALSE(declared(2).is_lost(kMember));
  EXPECT_TRUE(declared(3).is_lost(kMember));
  EXPECT_FALSE(declared(1).is_lost(MemberNumber(4)));
}

TEST(Losses, WhatIsSoAlreadyIsNotDeclaredAgain) {
  Losses losses = declared(1);
  EXPECT_FALSE(losses.declare(kMember, true));
  EXPECT_EQ(losses, declared(1));
  EXPECT_FALSE(declared(0).declare(kMember, false));
}

TEST(Losses, WhoKnowsMoreIsRightWhoeverHearsWhom) {
  for (int mine = 0; mine < 4; ++mine) {
    for (int theirs = 0; theirs < 4; ++theirs) {
      Losses losses = declared(mine);
      const bool together = losses.is_lost(kMember, declared(theirs));
      EXPECT_EQ(losses.learn(declared(theirs)), theirs > mine) << mine << " " << theirs;
      EXPECT_EQ(together, losses.is_lost(kMember));
      EXPECT_EQ(losses, declared(std::max(mine, theirs)));
    }
  }
}

}  // namespace
}  // namespace skein::auction
