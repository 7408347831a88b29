// SPDX-License-Identifier: Apache-2.0
// Objects that move, followed by what sensors tell of them.
#include "skein/ground_station/object_tracking.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "skein/foundation/random.hpp"

namespace skein::ground_station {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using world::Perception;
using world::Vector3;

ObjectSpec front() { return {"fire-front", "fire", {90, 40, 0}, 50, 0.5}; }

Perception look(double at, const std::vector<Vector3>& seen, double spread = 2,
                const std::string& kind = "fire") {
  Perception perception;
  perception.uav = "uav1";
  perception.device = "visible";
  perception.at = MissionTime::seconds(at);
  for (const Vector3& one : seen) perception.detections.push_back({kind, one, spread, 0.9});
  return perception;
}

/// Where it is thought to be, twice.
void found(ObjectTracking& tracking) {
  tracking.handle(look(0, {{90, 40, 0}}));
  tracking.handle(look(0, {{90, 40, 0}}));
}

TEST(ObjectTracking, IsSilentUntilTheObjectIsSeen) {
  ObjectTracking tracking({front()});

  EXPECT_THAT(tracking.handle(look(1, {})), IsEmpty());
  EXPECT_THAT(tracking.handle(look(2, {{95, 40, 0}}, 2, "smoke")), IsEmpty());
  EXPECT_THAT(tracking.handle(look(3, {{200, 40, 0}})), IsEmpty()) << "too far from where it is";
}

// A look of the same device from 40 m above the place where the object is thought to be.
Perception look_from_above(double at, const std::vector<Vector3>& seen, double range = 250) {
  Perception perception = look(at, seen);
  perception.viewpoint = {90, 40, 40};
  perception.direction = {0, 0, -1};
  perception.range = range;
  perception.aperture = 0.9;
  return perception;
}

// Two that are 42 s and 15 m apart agree, by how far the object may have moved meanwhile.
TEST(ObjectTracking, WhatTheDeviceThatSawItOnceSeesNoMoreWasAFalseAlarm) {
  const auto told_after = [](int looks, double range, const std::string& device) {
    ObjectTracking tracking({front()});
    tracking.handle(look_from_above(0, {{90, 40, 0}}));
    for (int i = 1; i <= looks; ++i) {
      Perception nothing = look_from_above(i, {}, range);
      nothing.device = device;
      tracking.handle(nothing);
    }
    return tracking.handle(look_from_above(42, {{105, 40, 0}}));
  };

  EXPECT_THAT(told_after(2, 250, "visible"), SizeIs(1));
  EXPECT_THAT(told_after(3, 250, "visible"), IsEmpty());
  EXPECT_THAT(told_after(40, 30, "visible"), SizeIs(1)) << "it does not see so far";
  EXPECT_THAT(told_after(40, 250, "ir"), SizeIs(1)) << "one that may not see fires at all";
}

TEST(ObjectTracking, TellsWhereItWasAndWhen) {
  ObjectTracking tracking({front()});
  tracking.handle(look(7, {{95, 42, 1}}, 3));

  const auto told = tracking.handle(look(7, {{95, 42, 1}}, 3));

  ASSERT_THAT(told, SizeIs(1));
  EXPECT_EQ(told[0].name, "fire-front");
  EXPECT_EQ(told[0].kind, "fire");
  EXPECT_EQ(told[0].position, Vector3(95, 42, 1));
  EXPECT_NEAR(told[0].spread, 3 / std::sqrt(2), 1e-9);
  EXPECT_EQ(told[0].seen, MissionTime::seconds(7));
}

// A sensor may see what is not there, now and then (random missions over fires, 30001: one false
// alarm sent two UAVs elsewhere).
TEST(ObjectTracking, OneSightingAloneIsNotBelieved) {
  ObjectTracking tracking({front()});

  EXPECT_THAT(tracking.handle(look(1, {{60, 40, 0}})), IsEmpty());
  EXPECT_THAT(tracking.handle(look(2, {{95, 40, 0}})), IsEmpty()) << "they do not agree";
  EXPECT_THAT(tracking.handle(look(3, {})), IsEmpty());
  const auto told = tracking.handle(look(4, {{96, 40, 0}}));

  ASSERT_THAT(told, SizeIs(1));
  EXPECT_NEAR(told[0].position.x(), 95.5, 0.5) << "the first has no part in it";
}

// Once it is followed, others of its kind do not take its name.
TEST(ObjectTracking, WhatIsSeenElsewhereDoesNotBeginItAnew) {
  ObjectTracking tracking({front()});
  found(tracking);

  EXPECT_THAT(tracking.handle(look(3, {{60, 40, 0}})), IsEmpty());
  EXPECT_THAT(tracking.handle(look(4, {{60, 40, 0}})), IsEmpty());
  EXPECT_THAT(tracking.handle(look(5, {{90, 40, 0}})), SizeIs(1));
}

TEST(ObjectTracking, TellsNotMoreOftenThanOnceASecondOfLooks) {
  ObjectTracking tracking({front()});
  std::vector<double> told;
  for (int i = 0; i < 30; ++i)
    for (const ObjectSeen& one : tracking.handle(look(0.1 * i, {{90, 40, 0}})))
      told.push_back(one.seen.to_seconds());

  EXPECT_THAT(told, SizeIs(3));
}

TEST(ObjectTracking, OfSeveralInALookTheNearestIsIt) {
  ObjectTracking tracking({front()});
  found(tracking);

  const auto told = tracking.handle(look(2, {{99, 40, 0}, {91, 40, 0}}));

  ASSERT_THAT(told, SizeIs(1));
  EXPECT_LT(told[0].position.x(), 91.1);
}

TEST(ObjectTracking, WhatItCannotHaveGotToIsNotIt) {
  ObjectTracking tracking({front()});
  found(tracking);

  EXPECT_THAT(tracking.handle(look(2, {{120, 40, 0}})), IsEmpty());
  EXPECT_THAT(tracking.handle(look(1000, {{120, 40, 0}})), SizeIs(1)) << "after so long it can";
}

// Looks overtake each other where they come by different ways.
TEST(ObjectTracking, ALookThatComesLateMovesNothingBackInTime) {
  ObjectTracking tracking({front()});
  found(tracking);
  tracking.handle(look(20, {{96, 40, 0}}));

  tracking.handle(look(1, {{90, 40, 0}}));
  const auto told = tracking.handle(look(21, {{96, 40, 0}}));

  ASSERT_THAT(told, SizeIs(1));
  EXPECT_EQ(told[0].seen, MissionTime::seconds(21));
  EXPECT_GT(told[0].position.x(), 93);
}

TEST(ObjectTracking, FiguresThatAreNotFiniteAreDisregarded) {
  ObjectTracking tracking({front()});
  const double nan = std::numeric_limits<double>::quiet_NaN();

  EXPECT_THAT(tracking.handle(look(1, {{nan, 40, 0}})), IsEmpty());
  EXPECT_THAT(tracking.handle(look(1, {{90, 40, 0}}, nan)), IsEmpty());
}

// Against what it was drawn from: a walk seen with errors. The estimate is off by as much as it
// says, and by less than single looks are.
RC_GTEST_PROP(ObjectTracking, IsAsFarOffAsItSays, (std::uint64_t seed)) {
  Random random(seed);
  ObjectTracking tracking({front()});
  Vector3 truth(90, 40, 0);
  double squares = 0, expected = 0;
  int count = 0;
  for (int i = 0; i < 400; ++i) {
    truth += 0.5 * Vector3(random.normal(), random.normal(), 0);
    const Vector3 seen = truth + 4 * Vector3(random.normal(), random.normal(), 0);
    for (const ObjectSeen& one : tracking.handle(look(i, {seen}, 4))) {
      squares += (one.position - truth).head<2>().squaredNorm() / 2;
      expected += one.spread * one.spread;
      ++count;
    }
  }
  RC_ASSERT(count > 390);
  RC_ASSERT(std::sqrt(squares / count) < 2 * std::sqrt(expected / count));
  RC_ASSERT(std::sqrt(squares / count) < 4 * 0.75);
}

}  // namespace
}  // namespace skein::ground_station
