// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/scm_monitor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "skein/foundation/random.hpp"

namespace skein::interaction {
namespace {

using Finding = ScmReport::Finding;
constexpr double kPi = std::numbers::pi;

SpatialConstraint distance(const std::string& to, Relation relation, double than) {
  return {SpatialConstraint::Quantity::kDistance, {to}, relation, Term(than), 0};
}

Scm scm_of(std::vector<SpatialConstraint> constraints) {
  return {"s", {{"a", true}, {"b", true}}, std::move(constraints)};
}

/// A monitor at a place, of things that stand somewhere and were seen at some time.
class Watched {
 public:
  explicit Watched(Scm scm, ScmLimits limits = {}, std::vector<std::string> a = {"fire"})
      : monitor_("mcs", std::move(scm), {{{"a", std::move(a)}, {"b", {"inside"}}}, {}}, limits) {
    seen_["fire"] = {{0, 0, 0}, MissionTime()};
    seen_["inside"] = {{100, 0, 0}, MissionTime()};
  }

  std::optional<ScmFound> at(const Position& own, double now = 0) {
    const Observer observer = [&](const std::string& name) {
      const auto found = seen_.find(name);
      return found == seen_.end() ? std::nullopt : std::optional(found->second);
    };
    return monitor_.update(own, observer, MissionTime::seconds(now));
  }
  /// "violated", or empty if nothing changed.
  std::string found_at(const Position& own, double now = 0) {
    const auto found = at(own, now);
    return found ? std::string(to_text(found->report.finding)) : "";
  }
  std::map<std::string, Sighting>& seen() { return seen_; }
  Finding finding() const { return monitor_.finding(); }

 private:
  ScmMonitor monitor_;
  std::map<std::string, Sighting> seen_;
};

// Sensors see an object now and then; telemetry comes every second.
TEST(ScmMonitor, WhatSensorsSawCountsForLongerThanTelemetryButNotForEver) {
  Watched watched(scm_of({distance("a", Relation::kLess, 50)}));
  watched.seen()["fire"] = {{0, 0, 0}, MissionTime::seconds(100), true};

  EXPECT_EQ(watched.found_at({40, 0, 0}, 129), "");
  EXPECT_EQ(watched.found_at({40, 0, 0}, 131), "undetermined");
  watched.seen()["fire"].at = MissionTime::seconds(135);
  EXPECT_EQ(watched.found_at({40, 0, 0}, 136), "satisfied");
  watched.seen()["fire"].by_sensors = false;
  EXPECT_EQ(watched.found_at({40, 0, 0}, 141), "undetermined");
}

TEST(ScmMonitor, AViolationIsToldOnceWithWhatIsRequiredAndMeasured) {
  Watched watched(
      scm_of({distance("a", Relation::kGreater, 25), distance("a", Relation::kLess, 50)}));

  EXPECT_EQ(watched.found_at({40, 0, 0}), "") << "as it should be";
  const auto found = watched.at({60, 0, 0});
  ASSERT_TRUE(found && found->why);
  EXPECT_EQ(found->report.scm, "mcs");
  EXPECT_EQ(found->report.finding, Finding::kViolated);
  EXPECT_EQ(found->why->constraint, 1U);
  EXPECT_EQ(found->why->place, "fire");
  EXPECT_DOUBLE_EQ(found->why->measured, 60);
  EXPECT_DOUBLE_EQ(found->why->required, 50);
  EXPECT_EQ(watched.found_at({61, 0, 0}), "");
}

TEST(ScmMonitor, AViolationEndsOnlyWhenAllHoldsByTheMargin) {
  Watched watched(scm_of({distance("a", Relation::kLess, 50)}));

  EXPECT_EQ(watched.found_at({50, 0, 0}), "violated") << "not less";
  EXPECT_EQ(watched.found_at({49.5, 0, 0}), "");
  EXPECT_EQ(watched.found_at({49, 0, 0}), "satisfied");
  EXPECT_EQ(watched.found_at({49.5, 0, 0}), "");
}

TEST(ScmMonitor, ItIsUndeterminedWhenAPositionIsUnknownOrTooOld) {
  Watched watched(
      scm_of({distance("a", Relation::kLess, 50), distance("b", Relation::kLess, 500)}));

  EXPECT_EQ(watched.found_at({0, 9, 0}, 5), "");
  EXPECT_EQ(watched.found_at({0, 9, 0}, 5.1), "undetermined");
  watched.seen()["fire"].at = MissionTime::seconds(5);
  EXPECT_EQ(watched.found_at({0, 9, 0}, 5.1), "") << "the other is as old as before";
  EXPECT_EQ(watched.found_at({0, 60, 0}, 5.1), "violated") << "whatever the other would say";
  watched.seen()["inside"].at = MissionTime::seconds(5);
  EXPECT_EQ(watched.found_at({0, 9, 0}, 5.1), "satisfied");
  watched.seen().erase("inside");
  EXPECT_EQ(watched.found_at({0, 9, 0}, 5.1), "undetermined");
}

TEST(ScmMonitor, AllOthersAreOneConstraintForEach) {
  Watched watched(scm_of({distance("a", Relation::kGreater, 20)}), {}, {"karma", "heliv"});
  watched.seen()["karma"] = {{100, 0, 0}, MissionTime()};
  watched.seen()["heliv"] = {{0, 15, 0}, MissionTime()};

  const auto found = watched.at({0, 0, 0});

  ASSERT_TRUE(found && found->why);
  EXPECT_EQ(found->why->place, "heliv");
}

TEST(ScmMonitor, NobodyElseIsNearWhenThereIsNobodyElse) {
  Watched watched(scm_of({distance("a", Relation::kGreater, 20)}), {}, {});

  EXPECT_EQ(watched.found_at({0, 0, 0}), "");
}

TEST(ScmMonitor, DistancesAndDirectionsMayBeComparedWithThoseOfPlaces) {
  const std::vector<std::string> both{"a", "b"}, other{"b"};
  SpatialConstraint nearer{SpatialConstraint::Quantity::kDistance, {"a"}, Relation::kLess, both, 0};
  SpatialConstraint left{SpatialConstraint::Quantity::kAzimuth, both, Relation::kGreater, other, 0};
  Watched watched(scm_of({nearer, left}));

  EXPECT_EQ(watched.found_at({0, 99, 0}), "");
  EXPECT_EQ(watched.found_at({0, 101, 0}), "violated") << "100 m from a to b";
}

TEST(CelestialFrame, AzimuthIsCounterClockwiseFromTheSecondPoint) {
  const Position origin{10, 10, 0}, toward{10, 20, 50};

  EXPECT_NEAR(*azimuth_in(origin, toward, {10, 90, 7}), 0, 1e-12);
  EXPECT_NEAR(*azimuth_in(origin, toward, {0, 10, 7}), kPi / 2, 1e-12);
  EXPECT_NEAR(*azimuth_in(origin, toward, {20, 10, 7}), 3 * kPi / 2, 1e-12);
  EXPECT_FALSE(azimuth_in(origin, toward, {10, 10, 7})) << "straight above";
  EXPECT_FALSE(azimuth_in(origin, {10, 10, 5}, {0, 0, 0})) << "no direction of azimuth 0";
}

TEST(CelestialFrame, AltitudeIsUpwardsFromTheHorizontalPlane) {
  EXPECT_NEAR(*altitude_in({0, 0, 10}, {3, 4, 15}), kPi / 4, 1e-12);
  EXPECT_NEAR(*altitude_in({0, 0, 10}, {0, 0, 0}), -kPi / 2, 1e-12);
  EXPECT_FALSE(altitude_in({1, 2, 3}, {1, 2, 3}));
}

// An azimuth of 0 is near one of just under a whole turn.
TEST(ScmMonitor, EqualAzimuthsAreComparedAroundTheCircle) {
  SpatialConstraint ahead{
      SpatialConstraint::Quantity::kAzimuth, {"a", "b"}, Relation::kEqual, Term(0.0), 0.2};
  Watched watched(scm_of({ahead}));

  EXPECT_EQ(watched.found_at({50, -5, 0}), "");
  EXPECT_EQ(watched.found_at({50, -15, 0}), "violated");
}

// Seen 10 m from the point that gives the direction, by a few metres: no direction at all.
TEST(ScmMonitor, AnAngleAtWhatSensorsFollowIsNotViolatedByWhatItsPlaceMayBeOff) {
  SpatialConstraint ahead{
      SpatialConstraint::Quantity::kAzimuth, {"a", "b"}, Relation::kEqual, Term(0.0), 0.2};
  ScmLimits limits;
  limits.seen = 3;
  Watched watched(scm_of({ahead}), limits);
  watched.seen()["inside"].position = {10, 0, 0};

  watched.seen()["fire"].by_sensors = true;
  EXPECT_EQ(watched.found_at({30, -15, 0}), "") << "0.46 rad off, of 0.2 and 0.4";
  EXPECT_EQ(watched.found_at({30, -25, 0}), "violated");
  watched.seen()["fire"].by_sensors = false;
  EXPECT_EQ(watched.found_at({30, 0, 0}), "satisfied");
  EXPECT_EQ(watched.found_at({30, -15, 0}), "violated") << "a point that was said is no doubt";
}

RC_GTEST_PROP(ScmMonitor, WhatIsSeenAndShakesViolatesNoAngleThatHolds, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  SpatialConstraint ahead{
      SpatialConstraint::Quantity::kAzimuth, {"a", "b"}, Relation::kEqual, Term(0.0), 0.02};
  ScmLimits limits;
  limits.seen = random.uniform(1, 5);
  Watched watched(scm_of({ahead}), limits);
  watched.seen()["fire"].by_sensors = true;
  watched.seen()["inside"].position = {random.uniform(3 * limits.seen, 100), 0, 0};
  const Position own{random.uniform(4 * limits.seen, 200), 0, random.uniform(0, 50)};

  for (int i = 0; i < 60; ++i) {
    const double angle = random.uniform(0, 2 * kPi), off = random.uniform(0, limits.seen / 2);
    watched.seen()["fire"].position = {off * std::cos(angle), off * std::sin(angle), 0};
    RC_ASSERT(watched.found_at(own) == "");
  }
}

Position anywhere(Random& random) {
  return {random.uniform(-80, 80), random.uniform(-80, 80), random.uniform(-80, 80)};
}

Scm any_ring(Random& random) {
  const double near = random.uniform(5, 40);
  return scm_of({distance("a", Relation::kGreater, near),
                 distance("a", Relation::kLess, near + random.uniform(5, 60))});
}

RC_GTEST_PROP(ScmMonitor, PositionsThatShakeByLessThanHalfTheMarginChangeItOnce, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Position base = anywhere(random);
  Watched watched(any_ring(random), {4, 0.02, Duration::seconds(5)});
  int changes = 0;

  for (int i = 0; i < 60; ++i) {
    Position shaken = base;
    for (double& x : shaken) x += random.uniform(-1.1, 1.1);  // together under 2 m
    if (watched.at(shaken)) ++changes;
  }

  RC_ASSERT(changes <= 1);
}

RC_GTEST_PROP(ScmMonitor, WithoutMarginItSaysWhatIsTheCase, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const double near = random.uniform(5, 40);
  const double far = near + random.uniform(5, 60);
  Watched watched(
      scm_of({distance("a", Relation::kGreater, near), distance("a", Relation::kLess, far)}),
      {0, 0, Duration::seconds(5)});

  for (int i = 0; i < 20; ++i) {
    const Position own = anywhere(random);
    (void)watched.at(own);
    const double d = std::sqrt(own[0] * own[0] + own[1] * own[1] + own[2] * own[2]);
    RC_ASSERT((watched.finding() == Finding::kSatisfied) == (d > near && d < far));
  }
}

// Where the world's origin lies and which way it is turned is no matter.
RC_GTEST_PROP(CelestialFrame, TurningTheWorldChangesNothing, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const double turn = random.uniform(0, 2 * kPi);
  const Position shift = anywhere(random);
  const auto turned = [&](const Position& p) {
    return Position{std::cos(turn) * p[0] - std::sin(turn) * p[1] + shift[0],
                    std::sin(turn) * p[0] + std::cos(turn) * p[1] + shift[1], p[2] + shift[2]};
  };
  const Position origin = anywhere(random), toward = anywhere(random), place = anywhere(random);

  const double azimuth = *azimuth_in(origin, toward, place);
  const double again = *azimuth_in(turned(origin), turned(toward), turned(place));

  RC_ASSERT(std::abs(std::remainder(azimuth - again, 2 * kPi)) < 1e-6);
  RC_ASSERT(std::abs(*altitude_in(origin, place) - *altitude_in(turned(origin), turned(place))) <
            1e-6);
}

}  // namespace
}  // namespace skein::interaction
