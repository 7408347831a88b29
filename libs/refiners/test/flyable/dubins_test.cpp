// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/dubins.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "skein/foundation/random.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
constexpr double kPi = std::numbers::pi;

Pose random_pose(Random& random, double extent) {
  return {{random.uniform(-extent, extent), random.uniform(-extent, extent)},
          random.uniform(-kPi, kPi)};
}

/// Drives three pieces of curvature -1, 0 or 1, by chords; independent of the curve.
Pose driven(const Pose& from, const std::array<int, 3>& turns, const std::array<double, 3>& parts,
            double radius) {
  Pose pose = from;
  for (std::size_t i = 0; i < 3; ++i) {
    const double turn = turns[i] * parts[i] / radius;
    const double chord = turns[i] == 0 ? parts[i] : 2 * radius * std::sin(std::abs(turn) / 2);
    const double along = pose.heading + turn / 2;
    pose.at += chord * Vector2(std::cos(along), std::sin(along));
    pose.heading += turn;
  }
  return pose;
}

/// The least length of the six words over a fine net of their first two pieces; the third follows
/// from the heading. No closed form is used.
double brute_force(const Pose& from, const Pose& to, double radius) {
  constexpr int kTurns = 720;
  double least = std::numeric_limits<double>::infinity();
  const auto third = [&](double heading, int turn) {
    return std::fmod(std::fmod(turn * (to.heading - heading), 2 * kPi) + 2 * kPi, 2 * kPi) * radius;
  };
  const auto consider = [&](const std::array<int, 3>& turns, double first, double second) {
    const double heading = from.heading + (turns[0] * first + turns[1] * second) / radius;
    const std::array<double, 3> parts = {first, second, third(heading, turns[2])};
    if ((driven(from, turns, parts, radius).at - to.at).norm() > 0.02 * radius) return;
    least = std::min(least, parts[0] + parts[1] + parts[2]);
  };
  for (int i = 0; i < kTurns; ++i) {
    const double first = 2 * kPi * radius * i / kTurns;
    for (const int side : {-1, 1}) {
      for (int k = 0; k < kTurns; ++k)
        consider({side, -side, side}, first, 2 * kPi * radius * k / kTurns);
      for (const int last : {-1, 1})
        for (int k = 0; k < 600; ++k) consider({side, 0, last}, first, 0.01 * radius * k);
    }
  }
  return least;
}

TEST(DubinsCurve, TurnsRoundToComeBackAHundredMetresAhead) {
  const auto curve = DubinsCurve::shortest({{0, 0}, 0}, {{100, 0}, kPi}, 30);

  EXPECT_NEAR(curve.length(), 212.858, 5e-4);
}

TEST(DubinsCurve, StaysStraightWhereThePosesAreInLine) {
  const Vector2 ahead(std::cos(0.7), std::sin(0.7));
  for (const double distance : {1e-3, 1.0, 5e4}) {
    const Vector2 start(12345.678, -9876.5);

    const auto curve = DubinsCurve::shortest({start, 0.7}, {start + distance * ahead, 0.7}, 30);

    EXPECT_NEAR(curve.length(), distance, 1e-6);
  }
}

TEST(DubinsCurve, HasNoLengthBetweenAPoseAndItself) {
  const Pose pose{{1e4, -3e4}, 2.5};

  const auto curve = DubinsCurve::shortest(pose, pose, 40);

  EXPECT_EQ(curve.length(), 0);
  EXPECT_EQ(curve.sampled(0.5).size(), 1U);
  EXPECT_EQ(curve.at(3).at, pose.at);
}

TEST(DubinsCurve, ACircleComesBackAfterAFullTurn) {
  const auto circle = DubinsCurve::circle({{5, 5}, 1}, 20, false);

  EXPECT_NEAR(circle.length(), 40 * kPi, 1e-9);
  const Vector2 centre = Vector2(5, 5) + 20 * Vector2(std::sin(1.0), -std::cos(1.0));
  for (const Vector2& point : circle.sampled(0.1)) EXPECT_NEAR((point - centre).norm(), 20, 1e-9);
  EXPECT_EQ(circle.at(1e9).at, Vector2(5, 5));
}

TEST(DubinsCurve, AnArcIsThePartOfACircle) {
  const Pose from{{5, 5}, 1};
  for (const bool left : {true, false}) {
    const auto arc = DubinsCurve::arc(from, 20, left, 1.5);
    const Pose end = arc.at(arc.length());
    const Pose other = DubinsCurve::circle(from, 20, left).at(30);

    EXPECT_NEAR(arc.length(), 30, 1e-9);
    EXPECT_LT((end.at - other.at).norm(), 1e-9);
    EXPECT_NEAR(end.heading, 1 + (left ? 1.5 : -1.5), 1e-9);
  }
}

TEST(DubinsCurve, TheLengthOfItsChordsIsKnownWithoutThem) {
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const auto curve =
        DubinsCurve::shortest(random_pose(random, 200), random_pose(random, 200), 30);
    const auto points = curve.sampled(0.5);
    double length = 0;
    for (std::size_t k = 1; k < points.size(); ++k) length += (points[k] - points[k - 1]).norm();
    EXPECT_NEAR(curve.sampled_length(0.5), length, 1e-6);
  }
}

RC_GTEST_PROP(DubinsCurve, ReachesThePoseItIsMadeFor, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const double radius = random.uniform(0.5, 80);
  const Pose from = random_pose(random, 300), to = random_pose(random, 300);

  const auto curve = DubinsCurve::shortest(from, to, radius);

  const Pose before_end = curve.at(curve.length() * (1 - 1e-9));
  RC_ASSERT((before_end.at - to.at).norm() < 1e-5);
  RC_ASSERT(std::abs(world::wrapped(before_end.heading - to.heading)) < 1e-5);
  RC_ASSERT(curve.at(0).at == from.at);
  RC_ASSERT(curve.at(-1).heading == from.heading);
}

RC_GTEST_PROP(DubinsCurve, NeverBendsMoreThanItsRadiusAllows, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const double radius = random.uniform(5, 80);
  const auto curve =
      DubinsCurve::shortest(random_pose(random, 200), random_pose(random, 200), radius);

  const double step = curve.length() / 400;
  for (int i = 0; i < 400; ++i) {
    const Pose here = curve.at(i * step), next = curve.at((i + 1) * step);
    RC_ASSERT(std::abs(world::wrapped(next.heading - here.heading)) <= step / radius + 1e-6);
    RC_ASSERT((next.at - here.at).norm() <= step + 1e-6);
  }
}

RC_GTEST_PROP(DubinsCurve, IsSampledWithinTheTolerance, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const double radius = random.uniform(5, 80), tolerance = random.uniform(0.05, 1);
  const auto curve =
      DubinsCurve::shortest(random_pose(random, 200), random_pose(random, 200), radius);

  const auto points = curve.sampled(tolerance);

  for (int i = 0; i <= 300; ++i) {
    const Vector2 on_curve = curve.at(curve.length() * i / 300).at;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const Vector2 leg = points[k + 1] - points[k];
      const double t = std::clamp((on_curve - points[k]).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (points[k] + t * leg - on_curve).norm());
    }
    RC_ASSERT(nearest <= tolerance + 1e-6);
  }
}

TEST(DubinsCurve, IsNotLongerThanAnythingABruteForceFinds) {
  Random random(4);
  for (int i = 0; i < 5; ++i) {
    const Pose from = random_pose(random, 1.5), to = random_pose(random, 1.5);

    const double length = DubinsCurve::shortest(from, to, 1).length();

    // The net accepts ends up to 0.02 off, which may save about as much on each of three pieces.
    const double least = brute_force(from, to, 1);
    EXPECT_LE(length, least + 0.12);
    EXPECT_GE(length, least - 0.12) << "shorter than any drive: it cannot reach the pose";
  }
}

TEST(ChordAngle, KeepsTheSagittaAndIsNeverMoreThanAnEighthOfATurn) {
  const double angle = chord_angle(30, 0.5);

  EXPECT_NEAR(30 * (1 - std::cos(angle / 2)), 0.5, 1e-9);
  EXPECT_EQ(chord_angle(1, 10), kPi / 4);
}

}  // namespace
}  // namespace skein::refiners
