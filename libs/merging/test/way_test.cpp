// SPDX-License-Identifier: Apache-2.0
// The air of a way, and what of it is left.
#include "skein/merging/way.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "skein/foundation/random.hpp"

namespace skein::merging {
namespace {

using world::Vector3;

const Margins kHovers{true, 5, 8, 3, 2, 6, 50, 50};

bool is_in(const Volumes& volumes, const Vector3& at) {
  return overlap(volumes, {{at.head<2>(), at.head<2>(), 1e-6, at.z() - 1e-6, at.z() + 1e-6}});
}

TEST(Way, LongPiecesGetWayPointsInBetween) {
  const Way way({{0, 0, 40}, {120, 0, 40}}, kHovers);
  const std::vector<Vector3>& points = way.points();
  EXPECT_EQ(points.back(), Vector3(120, 0, 40));
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_LE((points[i] - points[i - 1]).norm(), kHovers.stretch);
}

TEST(Way, HasNoWayPointsInBetweenWhereNoWindCarriesItOff) {
  Margins calm = kHovers;
  calm.steered = 1000;
  const std::vector<Vector3> corners{{0, 0, 40}, {120, 0, 40}, {120, 300, 40}};
  const Way way(corners, calm);
  EXPECT_EQ(way.way_points(), corners);
  EXPECT_EQ(way.volumes(), Way(corners, kHovers).volumes());
}

TEST(Way, ThatSlopesHasThemInAnyWind) {
  Margins calm = kHovers;
  calm.steered = 1000;
  const std::vector<Vector3> points = Way({{0, 0, 40}, {120, 0, 60}}, calm).way_points();
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[1], Vector3(40, 0, 40 + 20.0 / 3));
}

// A height that is not reached yet where the slope ends is made up for there.
TEST(Way, BesideASlopeHasThemInAnyWind) {
  Margins calm = kHovers;
  calm.steered = 1000;
  const Vector3 up(0, 0, 60), over(200, 0, 60), down(200, 0, 40);
  EXPECT_EQ(Way({{0, 0, 40}, up, over, down}, calm).way_points(),
            (std::vector<Vector3>{{0, 0, 40}, up, {50, 0, 60}, {150, 0, 60}, over, down}));
  EXPECT_EQ(Way({{0, 0, 40}, up, {40, 0, 60}, {40, 0, 40}}, calm).way_points(),
            (std::vector<Vector3>{{0, 0, 40}, up, {40, 0, 60}, {40, 0, 40}}));
}

// A point in between that lies inside the circle in which it turns is come back to.
TEST(Way, OfOneThatCannotHoverHasNoWayPointsTooNearForItsTurns) {
  world::VehicleModel blimp;
  blimp.hovers = false;
  blimp.min_turn_radius = 25;
  blimp.orbit_radius = 40;
  const Margins margins = margins_of(blimp, {}, 8);
  const std::vector<Vector3> pattern{{0, 0, 40}, {55, 0, 40}, {55, 60, 40}, {0, 99, 60}};
  EXPECT_EQ(Way(pattern, margins).way_points(), pattern);

  const std::vector<Vector3> points = Way({{0, 0, 40}, {0, 110, 60}}, margins, false).way_points();
  EXPECT_EQ(points, (std::vector<Vector3>{{0, 0, 40}, {0, 55, 50}, {0, 110, 60}}));
}

TEST(Way, IsLeftByNoMoreThanItTakesToHold) {
  const Way way({{0, 0, 40}, {120, 0, 40}}, kHovers);
  EXPECT_EQ(way.volumes()[0].radius, kHovers.hold);
  EXPECT_EQ(way.volumes()[1].radius, kHovers.way);
  EXPECT_EQ(way.volumes()[0].to.x(), 2 * kHovers.way);
}

// Two that stand beside each other and need much room are not too near to leave.
TEST(Way, IsLeftSoByWhoTakesMoreThanOnePieceForIt) {
  Margins wide = kHovers;
  wide.hold = 25;
  wide.way = 60;
  const Way way({{0, 0, 40}, {300, 0, 40}}, wide);
  const Volumes& volumes = way.volumes();
  for (const Volume& one : volumes)
    EXPECT_EQ(one.radius, one.to.x() <= 121 || one == volumes.back() ? wide.hold : wide.way);
  EXPECT_FALSE(overlap(volumes, {stay_at({0, 51, 40}, wide)}));
  EXPECT_TRUE(overlap(volumes, {stay_at({200, 51, 40}, wide)}));
}

TEST(Way, StraightUpFromWhereItHoldsTakesNoMoreThanThat) {
  const Way way({{0, 0, 40}, {0, 0, 64}, {120, 0, 64}}, kHovers);
  EXPECT_EQ(way.volumes()[0], column({0, 0}, 40, 64, kHovers));
  EXPECT_EQ(way.volumes()[1].radius, kHovers.way);
}

TEST(Way, EndsByStaying) {
  const Way way({{0, 0, 40}, {40, 0, 40}}, kHovers);
  EXPECT_EQ(way.volumes().back(), stay_at({40, 0, 40}, kHovers));
}

TEST(Way, TakesMoreHeightWhereItRisesAndBesideThat) {
  const Way way({{0, 0, 40},
                 {40, 0, 40},
                 {80, 0, 60},
                 {120, 0, 60},
                 {160, 0, 60},
                 {200, 0, 60},
                 {240, 0, 20},
                 {280, 0, 80}},
                kHovers);
  EXPECT_EQ(way.volumes()[0].floor, 38);
  EXPECT_EQ(way.volumes()[1].floor, 34);
  EXPECT_EQ(way.volumes()[2].floor, 34);
  EXPECT_EQ(way.volumes()[2].ceiling, 66);
  EXPECT_EQ(way.volumes()[3].ceiling, 66);
  EXPECT_EQ(way.volumes()[4].ceiling, 62);
}

// Found by random missions (--anything --clean 993004): halfway to its first lane, it turned back
// to a point between, came into the lane from the side, and saw 97 % of a zone.
TEST(Way, OfOneThatCannotHoverHasNoWayPointNearWhereItLeavesItsCircle) {
  world::VehicleModel plane;
  plane.hovers = false;
  plane.min_turn_radius = 35;
  plane.orbit_radius = 60;
  const Margins margins = margins_of(plane, {}, 15);
  for (const double length : {143, 250, 300, 700}) {
    const std::vector<Vector3> points = Way({{0, 0, 58}, {length, 0, 58}}, margins).way_points();
    EXPECT_GT(points[1].x(), 0.99 * margins.steered);
    for (std::size_t i = 1; i < points.size(); ++i)
      EXPECT_LE((points[i] - points[i - 1]).norm(), margins.steered);
  }
  const Way on({{0, 0, 58}, {143, 0, 58}}, margins, false);
  EXPECT_DOUBLE_EQ(on.way_points()[1].x(), 71.5) << "it flies along it already";
}

// A plane that was to sink by 1.3 m out of closed air asked for 65 m below it, and circled in
// there.
TEST(Way, TakesNoMoreHeightThanItsLowestAndHighestPlacesDo) {
  const Way way({{0, 0, 40}, {100, 0, 41}, {200, 0, 41}}, kHovers);
  for (const Volume& one : way.volumes()) {
    EXPECT_GE(one.floor, 38);
    EXPECT_LE(one.ceiling, 43);
  }
}

TEST(Way, IsLeftPieceByPieceWithOnePieceKeptBehind) {
  Way way({{0, 0, 40}, {150, 0, 40}, {150, 100, 40}}, kHovers);
  EXPECT_FALSE(way.passed({4, 2, 40}));
  EXPECT_EQ(way.left().size(), way.volumes().size());
  EXPECT_TRUE(way.passed({110, 2, 40}));
  EXPECT_EQ(way.left().size(), way.volumes().size() - 2);
  EXPECT_FALSE(is_in(way.left(), {20, 0, 40}));
  EXPECT_TRUE(is_in(way.left(), {60, 0, 40}));
}

// Twelve rounds over a zone were 98 volumes, 6 kB: no narrow radio carried that in time.
TEST(Way, AirThatItLeadsThroughAgainIsHeldOnceAndUntilTheLastTime) {
  const std::vector<Vector3> round{{60, 0, 40}, {60, 60, 40}, {0, 60, 40}, {0, 0, 40}};
  std::vector<Vector3> points{{0, 0, 40}};
  for (int i = 0; i < 5; ++i) points.insert(points.end(), round.begin(), round.end());
  const Way once({points.begin(), points.begin() + 5}, kHovers, false);
  Way way(points, kHovers, false);
  EXPECT_EQ(way.volumes(), once.volumes());
  EXPECT_TRUE(way.is_whole());

  for (std::size_t i = 1; i < points.size(); ++i) {
    ASSERT_TRUE(is_in(way.left(), (points[i - 1] + points[i]) / 2)) << i;
    way.passed(points[i]);
    ASSERT_LE(way.left().size(), once.volumes().size()) << i;
  }
  EXPECT_FALSE(way.is_whole());
  EXPECT_LT(way.left().size(), once.volumes().size());
}

TEST(Way, ABendTakenBeforeItIsReachedIsPassed) {
  Way way({{0, 0, 40}, {50, 0, 40}, {0, 5, 40}}, kHovers);
  EXPECT_TRUE(way.passed({42, 2, 40}));
}

TEST(Way, WhoCannotHoverKeepsWhatItMayTurnBackTo) {
  Margins circles = kHovers;
  circles.hovers = false;
  circles.way = 60;
  Way way({{0, 0, 40}, {500, 0, 40}, {500, 100, 40}, {0, 100, 40}}, circles);
  EXPECT_TRUE(way.passed({110, 0, 40}));
  EXPECT_EQ(way.left().size(), way.volumes().size()) << "it may turn back to where it began";
  for (double x = 160; x <= 500; x += 50) way.passed({x, 0, 40});
  EXPECT_FALSE(is_in(way.left(), {200, 0, 40}));
  EXPECT_TRUE(is_in(way.left(), {400, 0, 40}));
  EXPECT_TRUE(is_in(way.left(), {200, 100, 40})) << "not flown yet";
}

// Two bends 5 m apart, both near at 8.5 m before the first.
TEST(Way, ThePieceBeforeTwoBendsNearEachOtherIsKeptUntilTheVehicleIsOutOfIt) {
  const Vector3 before(41.5, 0, 40);
  Way way({{0, 0, 40}, {50, 0, 40}, {50, 5, 40}, {100, 5, 40}}, kHovers);
  way.passed(before);
  EXPECT_TRUE(is_in(way.left(), before));
  EXPECT_TRUE(way.passed({70, 5, 40}));
  EXPECT_FALSE(is_in(way.left(), before));
}

// Flown within its margins, seen once a second, it never leaves what is not left.
void expect_in_what_is_left(const std::vector<Vector3>& points, Random& random) {
  Way way(points, kHovers);
  const std::vector<Vector3> corners = way.points();
  double seen = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vector3 along = corners[i] - corners[i - 1];
    for (double flown = 0; flown < along.norm(); flown += 0.5) {
      const double most = i == 1 ? 3.5 : 5;  // of each of two, within hold and way
      const Vector3 off(random.uniform(-most, most), random.uniform(-most, most),
                        random.uniform(-1.5, 1.5));
      const Vector3 at = corners[i - 1] + flown / along.norm() * along + off;
      RC_ASSERT(is_in(way.left(), at));
      seen += 0.5;
      if (seen < 8) continue;
      seen = 0;
      way.passed(at);
      RC_ASSERT(is_in(way.left(), at));
    }
  }
}

RC_GTEST_PROP(WayProperty, WhoFliesItIsInWhatIsLeftOfIt, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<Vector3> points{{0, 0, 40}};
  for (std::size_t n = 1 + random.below(5); n > 0; --n) {
    points.emplace_back(random.uniform(-200, 200), random.uniform(-200, 200),
                        random.uniform(30, 60));
  }
  expect_in_what_is_left(points, random);
}

RC_GTEST_PROP(WayProperty, WhoFliesBendsNearEachOtherIsInWhatIsLeftOfThem, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<Vector3> points{{0, 0, 40}, {60, 0, 40}};
  for (std::size_t n = 1 + random.below(6); n > 0; --n) {
    const double side = random.chance(0.7) ? 12 : 60;
    points.push_back(points.back() + Vector3(random.uniform(-side, side),
                                             random.uniform(-side, side), random.uniform(-4, 4)));
  }
  expect_in_what_is_left(points, random);
}

}  // namespace
}  // namespace skein::merging
