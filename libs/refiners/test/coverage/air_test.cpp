// SPDX-License-Identifier: Apache-2.0
// What a sweep has to do with the ground, the air and bad queries.
#include <gtest/gtest.h>

#include <limits>

#include "coverage/checks.hpp"
#include "skein/refiners/flyable.hpp"
#include "testing/builders.hpp"
#include "testing/coverage_cases.hpp"

namespace skein::refiners {
namespace {

using testing::covered;
using testing::fixed_wing;
using testing::helicopter;
using testing::rectangle;
using world::Vector2;
using world::Vector3;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

CoverageQuery plain_query() {
  CoverageQuery query;
  query.vehicle = helicopter();
  query.area = rectangle(-200, -150, 200, 150);
  query.swath = 40;
  query.altitude = 60;
  return query;
}

world::World hilly_world(double height, double radius) {
  world::World world = testing::level_world();
  world::TerrainSpec spec = world.terrain.spec();
  spec.hills = {{{0, 0}, height, radius}, {{150, 120}, height / 2, radius / 2}};
  world.terrain = world::Terrain(spec);
  return world;
}

world::Volume zone(const world::Polygon& polygon, double floor = -1e9, double ceiling = 1e9) {
  world::Volume volume;
  volume.name = "tower";
  volume.polygon = polygon;
  volume.floor = floor;
  volume.ceiling = ceiling;
  return volume;
}

double least_height(const Way& way, const world::Terrain& terrain) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
    for (int k = 0; k <= 50; ++k) {
      const Vector3 at = way[i] + (way[i + 1] - way[i]) * (k / 50.0);
      least = std::min(least, at.z() - terrain.elevation(at.x(), at.y()));
    }
  return least;
}

Refusal refusal_of(const CoverageQuery& query, const world::World& world) {
  const auto outcome = refine(query, Setting{world, {}, 1, nullptr});
  EXPECT_FALSE(outcome) << "it was accepted";
  return outcome ? Refusal{} : outcome.error();
}

TEST(CoverageAir, FollowsTheGroundWithinAQuarterOfTheAltitudeAndItsClimbs) {
  const world::World world = hilly_world(60, 300);
  const Setting setting{world, {}, 1, nullptr};

  for (const auto& vehicle : {helicopter(), fixed_wing()}) {
    CoverageQuery query = plain_query();
    query.vehicle = vehicle;
    const auto refined = refine(query, setting);

    ASSERT_TRUE(refined) << refined.error().why;
    EXPECT_GE(least_height(refined->task.way, world.terrain), 0.7 * query.altitude);
    for (std::size_t i = 0; i + 1 < refined->task.way.size(); ++i) {
      const Vector3 step = refined->task.way[i + 1] - refined->task.way[i];
      const double rate = step.z() / step.head<2>().norm() * vehicle.cruise_speed;
      EXPECT_LE(rate, vehicle.climb_rate + 1e-6);
      EXPECT_GE(rate, -vehicle.descent_rate - 1e-6);
    }
  }
}

TEST(CoverageAir, ClimbsFromTheGroundOnTheWayOrOnTheSpot) {
  const world::World world = testing::level_world();
  const Setting setting{world, {}, 1, nullptr};
  CoverageQuery query = plain_query();
  query.start = query.end = Vector3(-700, -150, 0);

  const auto far = refine(query, setting);
  query.start = query.end = Vector3(-205, -150, 0);
  const auto near = refine(query, setting);

  ASSERT_TRUE(far && near);
  EXPECT_EQ(far->task.way[1].z(), 60) << "all the way to the first lane to climb in";
  EXPECT_GT((far->task.way[1] - far->task.way[0]).head<2>().norm(), 400);
  EXPECT_EQ(near->task.way[1].head<2>(), near->task.way[0].head<2>()) << "upright";
  EXPECT_EQ(near->task.way.back(), *query.end);
}

TEST(CoverageAir, OneThatCannotHoverClimbsInCirclesWhereTheWayIsTooShort) {
  const world::World world = testing::level_world();
  CoverageQuery query = plain_query();
  query.vehicle = fixed_wing();
  query.start = Vector3(-210, -150, 0);
  query.end = Vector3(210, 150, 0);

  const auto refined = refine(query, Setting{world, {}, 1, nullptr});

  ASSERT_TRUE(refined) << refined.error().why;
  EXPECT_TRUE(is_flyable(refined->task.way, query.vehicle, query.vehicle.cruise_speed, 0.5));
}

TEST(CoverageAir, RefusesWhatIsAboveTheCeiling) {
  CoverageQuery query = plain_query();
  query.altitude = 600;

  EXPECT_EQ(refusal_of(query, testing::level_world()).kind, RefusalKind::kBeyondVehicle);

  query.vehicle = testing::fixed_wing();
  query.altitude = 60;
  query.vehicle.ceiling = 70;
  EXPECT_EQ(refusal_of(query, hilly_world(300, 200)).kind, RefusalKind::kBeyondVehicle)
      << "it cannot sink as fast as the hill does";
}

TEST(CoverageAir, OneThatHoversFliesSlowerWhereItCouldNotSinkAsFastAsTheHillDoes) {
  CoverageQuery query = plain_query();
  query.altitude = 60;
  const double at_speed = refine(query, {.world = hilly_world(300, 200), .budget = {}})->cost;
  query.vehicle.ceiling = 70;

  const auto refined = refine(query, {.world = hilly_world(300, 200), .budget = {}});

  ASSERT_TRUE(refined) << refined.error().why;
  EXPECT_GT(refined->cost, at_speed);
}

TEST(CoverageAir, RefusesWhatTakesMoreEnergyThanItHolds) {
  CoverageQuery query = plain_query();
  query.vehicle.energy.capacity = 1e5;

  const Refusal refusal = refusal_of(query, testing::level_world());

  EXPECT_EQ(refusal.kind, RefusalKind::kBeyondVehicle);
  EXPECT_NE(refusal.why.find("energy"), std::string::npos);
}

TEST(CoverageAir, RefusesAnAreaUnderANoFlyVolumeAndNamesIt) {
  world::World world = testing::level_world();
  world.volumes = {zone(rectangle(-50, -50, 50, 50))};

  const Refusal refusal = refusal_of(plain_query(), world);

  EXPECT_EQ(refusal.kind, RefusalKind::kBlocked);
  EXPECT_NE(refusal.why.find("tower"), std::string::npos);
}

TEST(CoverageAir, VolumesAboveBelowBesideOrPastDoNotMatter) {
  world::World world = testing::level_world();
  const double plain = refine(plain_query(), Setting{world, {}, 1, nullptr})->cost;
  world::Volume past = zone(rectangle(-50, -50, 50, 50));
  past.when.until = MissionTime::seconds(100);
  world.volumes = {zone(rectangle(-50, -50, 50, 50), 61), zone(rectangle(-50, -50, 50, 50), 0, 59),
                   zone(rectangle(200, -150, 300, 150)), past};
  CoverageQuery query = plain_query();
  query.depart = MissionTime::seconds(100);

  const auto refined = refine(query, Setting{world, {}, 1, nullptr});

  ASSERT_TRUE(refined) << refined.error().why;
  EXPECT_DOUBLE_EQ(refined->cost, plain);
}

TEST(CoverageAir, SweepsAroundAVolumeThatIsCutOut) {
  world::World world = testing::level_world();
  const world::Volume tower = zone(rectangle(-30, -20, 30, 20));
  world.volumes = {tower};
  for (const auto& vehicle : {helicopter(), fixed_wing()}) {
    CoverageQuery query = plain_query();
    query.vehicle = vehicle;
    query.holes = {rectangle(-60, -50, 60, 50)};
    query.start = Vector3(-300, 0, 60);

    const auto refined = refine(query, Setting{world, {}, 1, nullptr});

    if (!refined && !vehicle.hovers) {  // its turns may find no room: then it must say so
      EXPECT_EQ(refined.error().kind, RefusalKind::kBlocked);
      EXPECT_NE(refined.error().why.find("tower"), std::string::npos);
      continue;
    }
    ASSERT_TRUE(refined) << refined.error().why;
    EXPECT_GE(covered(query, refined->task), 0.999);
    for (std::size_t i = 0; i + 1 < refined->task.way.size(); ++i)
      EXPECT_FALSE(enters(refined->task.way[i], refined->task.way[i + 1], tower)) << i;
  }
}

TEST(CoverageAir, TheWindCostsTimeAndWidensTheInterval) {
  world::World world = testing::level_world();
  world.wind.speed = 4;
  CoverageQuery query = plain_query();
  query.vehicle.wind_drift = 0.5;
  const auto calm = refine(query, Setting{testing::level_world(), {}, 1, nullptr});

  const auto windy = refine(query, Setting{world, {}, 1, nullptr});

  ASSERT_TRUE(windy && calm);
  EXPECT_GT(windy->duration.expected, calm->duration.expected);
  EXPECT_GT(windy->duration.most, windy->duration.expected);
  EXPECT_LT(windy->duration.least, windy->duration.expected);
}

TEST(CoverageAir, InTheWindLeastTimeIsStillWithinOnePercentOfEveryDegree) {
  world::World world = testing::level_world();
  Random random(41);

  for (int i = 0; i < 12; ++i) {
    world.wind.speed = random.uniform(0, 12);
    world.wind.toward = random.uniform(0, 6);
    CoverageQuery query = plain_query();
    query.area = testing::random_convex(random);
    query.vehicle = i % 2 == 0 ? helicopter() : fixed_wing();
    query.vehicle.wind_drift = 0.4;
    query.vehicle.energy.capacity = 1e12;
    const Setting setting{world, {}, 1, nullptr};
    const double cost = refine(query, setting)->cost;
    query.mode = SweepMode::kGiven;
    for (int degree = 0; degree < 180; ++degree) {
      query.direction = degree * std::numbers::pi / 180;
      ASSERT_LE(cost, 1.01 * refine(query, setting)->cost) << "case " << i << " at " << degree;
    }
  }
}

TEST(CoverageAir, RefusesAWindThatItCannotFlyAgainst) {
  world::World world = testing::level_world();
  world.wind.speed = 30;
  CoverageQuery query = plain_query();
  query.vehicle.wind_drift = 0.5;

  EXPECT_EQ(refusal_of(query, world).kind, RefusalKind::kBeyondVehicle);
}

struct BadQuery {
  const char* name;
  void (*spoil)(CoverageQuery&);
  RefusalKind kind;
  const char* field;
};

class BadCoverage : public ::testing::TestWithParam<BadQuery> {};

TEST_P(BadCoverage, IsRefusedWithTheFieldNamed) {
  CoverageQuery query = plain_query();
  GetParam().spoil(query);

  const Refusal refusal = refusal_of(query, testing::level_world());

  EXPECT_EQ(refusal.kind, GetParam().kind);
  EXPECT_EQ(refusal.field, GetParam().field);
  EXPECT_FALSE(refusal.why.empty());
}

const BadQuery kBad[] = {
    {"no_swath", [](CoverageQuery& q) { q.swath = 0; }, RefusalKind::kBadQuery, "swath"},
    {"negative_swath", [](CoverageQuery& q) { q.swath = -4; }, RefusalKind::kBadQuery, "swath"},
    {"nan_swath", [](CoverageQuery& q) { q.swath = kNaN; }, RefusalKind::kBadQuery, "swath"},
    {"tiny_swath", [](CoverageQuery& q) { q.swath = 1e-6; }, RefusalKind::kBadQuery, "swath"},
    {"no_altitude", [](CoverageQuery& q) { q.altitude = 0; }, RefusalKind::kBadQuery, "altitude"},
    {"nan_direction",
     [](CoverageQuery& q) {
       q.mode = SweepMode::kGiven;
       q.direction = kNaN;
     },
     RefusalKind::kBadQuery, "direction"},
    {"negative_speed", [](CoverageQuery& q) { q.speed = -1; }, RefusalKind::kBadQuery, "speed"},
    {"nan_speed", [](CoverageQuery& q) { q.speed = kNaN; }, RefusalKind::kBadQuery, "speed"},
    {"too_fast", [](CoverageQuery& q) { q.speed = 99; }, RefusalKind::kBeyondVehicle, "speed"},
    {"too_slow",
     [](CoverageQuery& q) {
       q.vehicle = fixed_wing();
       q.speed = 1;
     },
     RefusalKind::kBeyondVehicle, "speed"},
    {"two_corners",
     [](CoverageQuery& q) {
       q.area = {{0, 0}, {1, 0}};
     },
     RefusalKind::kBadQuery, "area"},
    {"crossed",
     [](CoverageQuery& q) {
       q.area = {{0, 0}, {100, 100}, {100, 0}, {0, 100}};
     },
     RefusalKind::kBadQuery, "area"},
    {"no_area",
     [](CoverageQuery& q) {
       q.area = {{0, 0}, {50, 0}, {100, 0}};
     },
     RefusalKind::kBadQuery, "area"},
    {"hole_outside", [](CoverageQuery& q) { q.holes = {rectangle(500, 500, 600, 600)}; },
     RefusalKind::kBadQuery, "holes.0"},
    {"hole_across", [](CoverageQuery& q) { q.holes = {rectangle(150, 0, 300, 50)}; },
     RefusalKind::kBadQuery, "holes.0"},
    {"holes_that_meet",
     [](CoverageQuery& q) {
       q.holes = {rectangle(0, 0, 50, 50), rectangle(40, 40, 80, 80)};
     },
     RefusalKind::kBadQuery, "holes.1"},
    {"hole_in_hole",
     [](CoverageQuery& q) {
       q.holes = {rectangle(0, 0, 50, 50), rectangle(10, 10, 20, 20)};
     },
     RefusalKind::kBadQuery, "holes.1"},
    {"nan_start", [](CoverageQuery& q) { q.start = Vector3(0, kNaN, 0); }, RefusalKind::kBadQuery,
     "start"},
    {"start_in_the_ground", [](CoverageQuery& q) { q.start = Vector3(0, 0, -50); },
     RefusalKind::kBlocked, "start"},
    {"nan_end", [](CoverageQuery& q) { q.end = Vector3(kNaN, 0, 0); }, RefusalKind::kBadQuery,
     "end"},
};

INSTANTIATE_TEST_SUITE_P(All, BadCoverage, ::testing::ValuesIn(kBad),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(BadCoverageCorners, NaNCornersAreRefused) {
  CoverageQuery query = plain_query();
  query.area[1].x() = kNaN;

  EXPECT_EQ(refusal_of(query, testing::level_world()).kind, RefusalKind::kBadQuery);
}

TEST(CoverageAir, ASliverIsSweptWithoutTrouble) {
  CoverageQuery query = plain_query();
  query.area = {{0, 0}, {1000, 1e-6}, {2000, 0}, {1000, -1e-7}};
  query.vehicle.energy.capacity = 1e12;

  const auto refined = refine(query, Setting{testing::level_world(), {}, 1, nullptr});

  ASSERT_TRUE(refined) << refined.error().why;
  EXPECT_EQ(refined->task.lanes.size(), 1U);
}

TEST(CoverageAir, AStartWithinAVolumeIsRefused) {
  world::World world = testing::level_world();
  world.volumes = {zone(rectangle(300, 300, 400, 400))};
  CoverageQuery query = plain_query();
  query.start = Vector3(350, 350, 10);

  EXPECT_EQ(refusal_of(query, world).kind, RefusalKind::kBlocked);
}

TEST(Coverage, TakesOtherLanesWhereTheTurnsOfTheQuickestWouldBeInAVolume) {
  world::World world = testing::level_world();
  CoverageQuery query = plain_query();
  query.vehicle = fixed_wing();
  query.area = rectangle(-300, -100, 300, 100);
  query.mode = SweepMode::kGiven;  // along the longer side, with turns at the west and the east
  const double along = refine(query, {.world = world, .budget = {}})->cost;
  world.volumes = {zone(rectangle(320, -400, 600, 400))};  // no room to turn in the east
  ASSERT_FALSE(refine(query, {.world = world, .budget = {}}));

  query.mode = SweepMode::kLeastTime;
  const auto refined = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(refined) << refined.error().why;
  EXPECT_GT(refined->cost, along);
  EXPECT_GT(covered(query, refined->task), 0.9999);
  for (std::size_t i = 0; i + 1 < refined->task.way.size(); ++i)
    EXPECT_FALSE(enters(refined->task.way[i], refined->task.way[i + 1], world.volumes[0]));
}

// Found by random missions (--sweepers --clean 993004): the vehicle refused way-points of a turn
// beyond the terrain, three times, and its goal failed.
TEST(Coverage, TakesOtherLanesWhereTheTurnsOfTheQuickestWouldLeadOutOfTheTerrain) {
  const world::World world = testing::level_world(320);
  CoverageQuery query = plain_query();
  query.vehicle = fixed_wing();
  query.area = rectangle(-300, -100, 300, 100);
  query.mode = SweepMode::kGiven;  // along the longer side, with turns at the west and the east
  const auto along = refine(query, {.world = world, .budget = {}});
  ASSERT_FALSE(along);
  EXPECT_NE(along.error().why.find("a turn leads out of the terrain near ("), std::string::npos)
      << along.error().why;

  query.mode = SweepMode::kLeastTime;
  const auto refined = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(refined) << refined.error().why;
  EXPECT_GT(covered(query, refined->task), 0.9999);
  for (const Vector3& at : refined->task.way) EXPECT_TRUE(world.terrain.contains(at.x(), at.y()));
}

TEST(Enters, TouchingIsNotEntering) {
  const world::Volume tower = zone(rectangle(0, 0, 10, 10), 0, 20);

  EXPECT_TRUE(enters({-5, 5, 10}, {15, 5, 10}, tower));
  EXPECT_TRUE(enters({5, 5, 10}, {6, 6, 10}, tower)) << "all of it inside";
  EXPECT_TRUE(enters({5, 5, -10}, {5, 5, 40}, tower)) << "upright through it";
  EXPECT_FALSE(enters({-5, 10, 10}, {15, 10, 10}, tower)) << "along a side";
  EXPECT_FALSE(enters({-5, 5, 20}, {15, 5, 20}, tower)) << "over its top";
  EXPECT_FALSE(enters({-5, 5, 10}, {0, 5, 10}, tower)) << "up to it";
  EXPECT_FALSE(enters({-20, 5, 30}, {0, 5, 10}, tower));
  EXPECT_TRUE(enters({-10, 5, 30}, {10, 5, 10}, tower)) << "into it from above";
}

}  // namespace
}  // namespace skein::refiners
