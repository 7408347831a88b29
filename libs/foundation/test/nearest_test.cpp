// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/nearest.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

TEST(NearestName, FindsTheNameThatWasMeant) {
  EXPECT_EQ(nearest_name("marvn", {"karma", "marvin", "heliv"}), "marvin");
  EXPECT_EQ(nearest_name("helvi", {"karma", "marvin", "heliv"}), "heliv");
  EXPECT_EQ(nearest_name("KARMA", {"karma", "marvin"}), "karma");
}

TEST(NearestName, SaysNothingWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("zeppelin", {"karma", "marvin"}), "");
  EXPECT_EQ(nearest_name("x", {}), "");
}

TEST(NearestName, IsAskedForAtTheEndOfAMessage) {
  EXPECT_EQ("no UAV 'helvi'" + did_you_mean(nearest_name("helvi", {"karma", "heliv"})),
            "no UAV 'helvi'; did you mean 'heliv'?");
  EXPECT_EQ("no UAV 'x'" + did_you_mean(nearest_name("x", {})), "no UAV 'x'");
}

TEST(NearestName, TheFirstAmongEqualsWins) { EXPECT_EQ(nearest_name("ab", {"ax", "ay"}), "ax"); }

}  // namespace
}  // namespace skein
