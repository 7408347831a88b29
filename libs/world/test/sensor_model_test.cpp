// SPDX-License-Identifier: Apache-2.0
#include "skein/world/sensor_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace skein::world {
namespace {

const View kEast = {{10, 0, 0}, Vector3::UnitX(), 100, 0.5};

TEST(InView, IsTheConeWithinRange) {
  struct Case {
    Vector3 point;
    bool seen;
  };
  const double edge = 50 * std::tan(0.5);
  const Case cases[] = {
      {{60, 0, 0}, true},           {{60, edge - 0.01, 0}, true},  {{60, edge + 0.01, 0}, false},
      {{60, 0, edge - 0.01}, true}, {{60, 0, edge + 0.01}, false}, {{0, 0, 0}, false},
      {{109.9, 0, 0}, true},        {{110.1, 0, 0}, false},        {{10, 0, 0}, true},
  };
  for (const Case& c : cases) EXPECT_EQ(in_view(kEast, c.point), c.seen) << c.point.transpose();
}

TEST(InView, ABallIsSeenWhenItsEdgeIs) {
  const Vector3 aside = Vector3(10, 0, 0) + 50 * Vector3(std::cos(0.6), std::sin(0.6), 0);
  const double needed = 50 * std::sin(0.1);

  EXPECT_FALSE(in_view(kEast, aside, needed - 0.01));
  EXPECT_TRUE(in_view(kEast, aside, needed + 0.01));
  EXPECT_TRUE(in_view(kEast, {112, 0, 0}, 3)) << "its near side is in range";
}

TEST(InView, FromWithinABallEverythingIsSeen) {
  EXPECT_TRUE(in_view(kEast, {5, 0, 0}, 6)) << "though its centre is behind";
}

}  // namespace
}  // namespace skein::world
