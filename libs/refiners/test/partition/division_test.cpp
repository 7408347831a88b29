// SPDX-License-Identifier: Apache-2.0
// The laws of divide(), checked by means of this file's own.
#include "partition/division_law.hpp"

#include <gtest/gtest.h>

namespace skein::refiners {
namespace {

using testing::on_border;
using testing::random_convex;
using testing::within;
using namespace division;

TEST(Divide, GivesOneMemberTheWhole) {
  const std::vector<Polygon> parts = divide(kSquare, {{50, 50}}, {3});

  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(area_of(parts[0]), 10'000, 1e-9);
}

TEST(Divide, TakesTheSenseOfTheCornersAsItComes) {
  const Polygon clockwise(kSquare.rbegin(), kSquare.rend());

  const std::vector<Polygon> parts = divide(clockwise, {{0, 50}, {100, 50}}, {1, 3});

  EXPECT_TRUE(lawful(clockwise, {{0, 50}, {100, 50}}, {1, 3}, parts));
}

TEST(Divide, PartsStartingAtOnePointOfTheBorderAllTouchIt) {
  const std::vector<Vector2> anchors(5, Vector2(30, 0));
  const std::vector<double> shares = {1, 5, 2, 1, 1};

  EXPECT_TRUE(lawful(kSquare, anchors, shares, divide(kSquare, anchors, shares)));
}

TEST(Divide, PartsStartingAtOneCornerAllTouchIt) {
  const std::vector<Vector2> anchors(4, Vector2(0, 0));
  const std::vector<double> shares = {1, 1, 1, 1};

  EXPECT_TRUE(lawful(kSquare, anchors, shares, divide(kSquare, anchors, shares)));
}

TEST(Divide, ThreeTogetherInTheMiddleGetAFan) {
  const std::vector<Vector2> anchors(3, Vector2(50, 50));
  const std::vector<double> shares = {1, 1, 1};

  EXPECT_TRUE(lawful(kSquare, anchors, shares, divide(kSquare, anchors, shares)));
}

TEST(Divide, AnchorsOnOneLineAreAllKept) {
  const std::vector<Vector2> anchors = {{0, 50}, {25, 50}, {75, 50}, {100, 50}};
  const std::vector<double> shares = {1, 1, 1, 1};

  EXPECT_TRUE(lawful(kSquare, anchors, shares, divide(kSquare, anchors, shares)));
}

TEST(Divide, AnAnchorOutsideCountsAsTheNearestPointOfTheBorder) {
  const std::vector<Vector2> outside = {{-1000, 20}, {150, 150}, {60, 1e6}};
  const std::vector<double> shares = {1, 2, 3};

  const std::vector<Polygon> parts = divide(kSquare, outside, shares);

  EXPECT_TRUE(lawful(kSquare, {{0, 20}, {100, 100}, {60, 100}}, shares, parts));
}

TEST(Divide, OfTwoInTheMiddleTheSmallOneGivesWay) {
  const std::vector<Vector2> anchors = {{50, 50}, {52, 50}};

  const Division division = divisions(kSquare, anchors, {1, 9}, 1).front();

  EXPECT_EQ(division.anchors[0], Vector2(50, 0));
  EXPECT_EQ(division.anchors[1], anchors[1]);
  EXPECT_TRUE(lawful(kSquare, division.anchors, {1, 9}, division.parts));
}

TEST(Divide, ThinAreasAreDividedToo) {
  for (const double width : {1e-3, 1e-6, 1e-9}) {
    const Polygon thin = {{0, 0}, {1000, 0}, {1000, width}, {400, 1.2 * width}};
    const std::vector<Vector2> anchors = {{0, 0}, {500, 0}, {500, 0}, {1000, width}};

    const std::vector<Polygon> parts = divide(thin, anchors, {1, 1, 2, 3});

    for (std::size_t i = 0; i < 4; ++i) EXPECT_GE(parts[i].size(), 3U) << width;
  }
}

TEST(Divide, KeepsItsExactnessFarFromTheOrigin) {
  Polygon far = kSquare;
  for (Vector2& corner : far) corner += Vector2(3e5, -4e5);
  const std::vector<Vector2> anchors = {far[0], far[2], (far[0] + far[1]) / 2};

  EXPECT_TRUE(lawful(far, anchors, {1, 2, 4}, divide(far, anchors, {1, 2, 4})));
}

/// Anchors as `place` puts them, one in five where another is; shares over a factor `span`.
template <class Place>
Case random_case(Random& random, double span, const Place& place) {
  Case result;
  const Vector2 centre(random.uniform(-5000, 5000), random.uniform(-5000, 5000));
  const std::size_t points = random.chance(0.1) ? 100 + random.below(200) : 3 + random.below(12);
  result.area = random_convex(random, random.uniform(50, 2000), points, centre);
  const std::size_t parts = 1 + random.below(12);
  for (std::size_t i = 0; i < parts; ++i) {
    result.anchors.push_back(i > 0 && random.chance(0.2) ? result.anchors[random.below(i)]
                                                         : place(result.area));
    result.shares.push_back(std::pow(span, -random.uniform()));
  }
  return result;
}

TEST(Divide, KeepsItsLawsForAnchorsOnTheBorder) {
  Random random(1);
  for (int i = 0; i < cases(600, 4000); ++i) {
    const Case given =
        random_case(random, 5, [&](const Polygon& area) { return on_border(random, area); });

    const std::vector<Polygon> parts = divide(given.area, given.anchors, given.shares);

    ASSERT_TRUE(lawful(given.area, given.anchors, given.shares, parts)) << "case " << i;
  }
}

TEST(Divide, KeepsItsLawsForSharesFromOneToAThousand) {
  Random random(2);
  for (int i = 0; i < cases(400, 3000); ++i) {
    const Case given =
        random_case(random, 1000, [&](const Polygon& area) { return on_border(random, area); });

    const std::vector<Polygon> parts = divide(given.area, given.anchors, given.shares);

    ASSERT_TRUE(lawful(given.area, given.anchors, given.shares, parts)) << "case " << i;
  }
}

TEST(Divide, KeepsItsLawsForAnchorsAnywhere) {
  Random random(3);
  std::size_t inside = 0, kept = 0;
  for (int i = 0; i < cases(400, 3000); ++i) {
    const Case given = random_case(random, 5, [&](const Polygon& area) {
      if (random.chance(0.3)) return on_border(random, area);
      return random.chance(0.5) ? within(random, area) : Vector2(area[0] * 3 - area[1] * 2);
    });

    const Division division = divisions(given.area, given.anchors, given.shares, 1).front();

    ASSERT_TRUE(lawful(given.area, division.anchors, given.shares, division.parts)) << "case " << i;
    for (std::size_t k = 0; k < given.anchors.size(); ++k) {
      if (depth_in(given.area, given.anchors[k]) < 1e-6) continue;
      ++inside;
      kept += (division.anchors[k] - given.anchors[k]).norm() < 1e-6 ? 1U : 0U;
    }
  }
  RecordProperty("anchors_inside", static_cast<int>(inside));
  RecordProperty("anchors_kept", static_cast<int>(kept));
  EXPECT_GE(static_cast<double>(kept), 0.97 * static_cast<double>(inside));
}

TEST(Divide, AnAnchorOfTwoGivesWayOnlyWhereNoLineLeavesBothTheirShare) {
  Random random(4);
  int gave_way = 0;
  for (int i = 0; i < cases(150, 1000); ++i) {
    const Polygon area = random_convex(random, 500, 4 + random.below(8));
    const std::vector<Vector2> anchors = {within(random, area), within(random, area)};
    const std::vector<double> shares = {random.uniform(0.2, 1), random.uniform(0.2, 1)};

    const Division division = divisions(area, anchors, shares, 1).front();

    const bool kept = (division.anchors[0] - anchors[0]).norm() < 1e-6 &&
                      (division.anchors[1] - anchors[1]).norm() < 1e-6;
    gave_way += kept ? 0 : 1;
    if (!kept) {
      ASSERT_LT(best_line_for_two(area, anchors, shares), 1e-6) << "case " << i;
    }
  }
  EXPECT_GT(gave_way, 0);
}

TEST(Divide, OffersDifferentWaysTheMostCompactFirst) {
  const std::vector<Vector2> anchors = {{10, 0}, {90, 0}, {50, 100}};
  const std::vector<double> shares = {1, 1, 1};

  const std::vector<Division> ways = divisions(kSquare, anchors, shares, 8);

  EXPECT_GT(ways.size(), 3U);
  for (const Division& way : ways) EXPECT_TRUE(lawful(kSquare, anchors, shares, way.parts));
  EXPECT_EQ(ways.front().parts, divisions(kSquare, anchors, shares, 8).front().parts);
}

}  // namespace
}  // namespace skein::refiners
