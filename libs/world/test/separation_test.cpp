// SPDX-License-Identifier: Apache-2.0
#include "skein/world/separation.hpp"

#include <gtest/gtest.h>

namespace skein::world {
namespace {

VehicleModel precise_to(double spread) {
  VehicleModel model;
  model.body_radius = 1;
  model.position_precision = spread;
  return model;
}

TEST(Separation, IsHalfOfEachSizeAndTwoDeviationsOfEach) {
  const Separation both = separation_share(precise_to(0.3)) + separation_share(precise_to(2));
  EXPECT_DOUBLE_EQ(both.level, 1.6 + 5);
  EXPECT_DOUBLE_EQ(both.height, 2.3 + 4);
}

TEST(Separation, APersonWhoFliesItCounts) {
  VehicleModel flown = precise_to(0.3);
  flown.pilot = PilotModel{};
  flown.pilot->position_imprecision = 0.4;
  EXPECT_DOUBLE_EQ(separation_share(flown).level, 1 + 2 * 0.5);
}

TEST(Separation, IsKeptLevelOrInHeight) {
  const Separation both{10, 5};
  EXPECT_DOUBLE_EQ(kept_share(both, {0, 0, 40}, {6, 8, 40}), 1);
  EXPECT_DOUBLE_EQ(kept_share(both, {0, 0, 40}, {0, 0, 46}), 1.2);
  EXPECT_DOUBLE_EQ(kept_share(both, {0, 0, 40}, {5, 0, 41}), 0.5);
}

}  // namespace
}  // namespace skein::world
