// SPDX-License-Identifier: Apache-2.0
// Volumes overlap where samples of the air say so.
#include "skein/merging/volume.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace skein::merging {
namespace {

using world::Vector2;

Volume disc(double x, double y, double radius, double floor = 0, double ceiling = 10) {
  return {{x, y}, {x, y}, radius, floor, ceiling};
}

TEST(Volume, DiscsOverlapWhenTheyAreNearerThanBothRadii) {
  EXPECT_TRUE(overlap(disc(0, 0, 3), disc(4.9, 0, 2)));
  EXPECT_FALSE(overlap(disc(0, 0, 3), disc(5, 0, 2)));
}

TEST(Volume, OneAboveTheOtherHasAirOfItsOwn) {
  EXPECT_FALSE(overlap(disc(0, 0, 3, 0, 10), disc(0, 0, 3, 10, 20)));
  EXPECT_TRUE(overlap(disc(0, 0, 3, 0, 10.1), disc(0, 0, 3, 10, 20)));
}

TEST(Volume, WaysThatCrossOverlapThoughTheirEndsAreFarApart) {
  const Volume east{{-100, 0}, {100, 0}, 1, 0, 10}, north{{0, -100}, {0, 100}, 1, 0, 10};
  EXPECT_TRUE(overlap(east, north));
}

TEST(Volume, WaysAlongEachOtherOverlapByTheirDistance) {
  const Volume one{{0, 0}, {100, 0}, 2, 0, 10};
  EXPECT_TRUE(overlap(one, {{50, 3.9}, {150, 3.9}, 2, 0, 10}));
  EXPECT_FALSE(overlap(one, {{50, 4.1}, {150, 4.1}, 2, 0, 10}));
}

Volume any_volume() {
  const auto metres = [](int most) { return *rc::gen::inRange(-most, most) / 4.0; };
  const Vector2 from(metres(120), metres(120));
  const Vector2 to = *rc::gen::inRange(0, 4) == 0 ? from : Vector2(metres(120), metres(120));
  const double floor = metres(40);
  return {from, to, 0.5 + *rc::gen::inRange(0, 40) / 4.0, floor,
          floor + 1 + *rc::gen::inRange(0, 40) / 4.0};
}

// By points along both lines, so a little too far.
double sampled_distance(const Volume& one, const Volume& other) {
  constexpr int kParts = 150;
  double least = 1e9;
  for (int i = 0; i <= kParts; ++i) {
    const Vector2 a = one.from + i / double(kParts) * (one.to - one.from);
    for (int j = 0; j <= kParts; ++j) {
      const Vector2 b = other.from + j / double(kParts) * (other.to - other.from);
      least = std::min(least, (a - b).norm());
    }
  }
  return least;
}

RC_GTEST_PROP(VolumeProperty, OverlapIsWhatSamplesSay, ()) {
  const Volume one = any_volume(), other = any_volume();
  const double spare = ((one.to - one.from).norm() + (other.to - other.from).norm()) / 150;
  const double sampled = sampled_distance(one, other), reach = one.radius + other.radius;
  const bool in_height = one.floor < other.ceiling && other.floor < one.ceiling;
  if (!in_height || sampled - spare >= reach) RC_ASSERT(!overlap(one, other));
  if (in_height && sampled < reach) RC_ASSERT(overlap(one, other));
  RC_ASSERT(overlap(one, other) == overlap(other, one));
}

// Whatever is no nearer than it is made wider, with a little for the corners, is not in it.
RC_GTEST_PROP(VolumeProperty, WhatIsClosedAroundItHasAllThatIsNearAndHardlyMore, ()) {
  const Volume volume = any_volume();
  const double wider = *rc::gen::inRange(0, 60) / 4.0;
  const world::Volume closed = closed_around(volume, wider, 2.5);
  RC_ASSERT(closed.floor == volume.floor - 2.5);
  RC_ASSERT(closed.ceiling == volume.ceiling + 2.5);
  const Vector2 at(*rc::gen::inRange(-300, 300) / 4.0, *rc::gen::inRange(-300, 300) / 4.0);
  const double off = sampled_distance(volume, {at, at, 1, 0, 1});
  const double spare = (volume.to - volume.from).norm() / 150, reach = volume.radius + wider;
  if (off < reach - 1e-6) RC_ASSERT(world::contains(closed.polygon, at));
  if (off - spare > 1.04 * reach) RC_ASSERT(!world::contains(closed.polygon, at));
}

RC_GTEST_PROP(VolumeProperty, ManyOverlapWhenTwoDo, ()) {
  const Volumes some{any_volume(), any_volume()}, others{any_volume(), any_volume()};
  bool any = false;
  for (const Volume& one : some) {
    for (const Volume& other : others) any = any || overlap(one, other);
  }
  RC_ASSERT(overlap(some, others) == any);
}

}  // namespace
}  // namespace skein::merging
