// SPDX-License-Identifier: Apache-2.0
// Patrols and waits beside closed air, flown by the simulator: is that what was meant?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "flight/closed_air.hpp"
#include "refinery/refinery.hpp"
#include "skein/foundation/random.hpp"
#include "skein/world/segment.hpp"
#include "test_cases.hpp"
#include "testing/flown.hpp"
#include "testing/range.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using world::Vector2;
using world::Vector3;

/// Points over a zone, on the ground.
std::vector<Vector3> lattice_over(const world::Zone& zone, const world::Terrain& terrain) {
  Vector2 low = zone.polygon.front(), high = low, middle = Vector2::Zero();
  for (const Vector2& corner : zone.polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
    middle += corner / static_cast<double>(zone.polygon.size());
  }
  std::vector<Vector3> points;
  const auto add = [&](double x, double y) {
    if (world::contains(zone.polygon, {x, y})) points.emplace_back(x, y, terrain.elevation(x, y));
  };
  add(middle.x(), middle.y());
  for (double x = low.x(); x <= high.x(); x += (high.x() - low.x()) / 20)
    for (double y = low.y(); y <= high.y(); y += (high.y() - low.y()) / 20) add(x, y);
  return points;
}

/// Seconds of the flight in which the device's cone met the zone: fixed to the vehicle, or aimed.
double seconds_in_view(const Range& range, const world::SensorModel& device,
                       const std::optional<Vector3>& aim, const std::vector<Vector3>& zone) {
  double seconds = 0;
  for (std::size_t t = 0; t < range.track().size(); ++t) {
    const Vector3& at = range.track()[t];
    const Vector3 axis = device.gimballed && aim
                             ? Vector3((*aim - at).normalized())
                             : world::direction_of(range.headings()[t], device.boresight_pitch);
    const world::View view{at, axis, device.range, device.aperture};
    if (std::any_of(zone.begin(), zone.end(),
                    [&](const Vector3& point) { return world::in_view(view, point); }))
      seconds += kRangeStep;
  }
  return seconds;
}

TEST(FlownPatrols, HaveTheZoneInSightForTheirTime) {
  // Of ressac's head nothing but the steep side reaches the ground from far up.
  for (const char* name : {"comets/models/marvin", "comets/models/heliv", "comets/models/karma",
                           "action/models/ressac"}) {
    const auto model = vehicle_of(std::string("scenarios/") + name + ".yaml");
    for (std::uint64_t seed = 1; seed <= skein::testing::cases(8U, 150U); ++seed) {
      const std::string which = std::string(name) + " seed " + std::to_string(seed);
      Random random(seed, "patrols");
      const world::World world = windy(random);
      const world::Zone zone = a_zone(random, 8, 250);
      const double altitude = random.uniform(35, std::min(model.ceiling - 5, 145.0));
      const double seconds = random.uniform(20, 300);
      Refinery refinery = refinery_of(world, model, altitude);
      const world::SensorModel& device = model.sensors.back();
      if (altitude >= device.range) continue;
      const Vector3 from(0, 0, altitude);
      Range range(world, model, seed);
      ASSERT_GT(range.fly("takeoff", altitude_of(altitude), 400).seconds, 0);

      const auto patrol = refinery.patrols.over(from, zone, device, seconds);

      ASSERT_TRUE(patrol) << which << ": " << patrol.error();
      const auto flown = range.fly("goto", waypoints(patrol->way), 4000);
      ASSERT_GT(flown.seconds, 0) << which << ' ' << flown.why;
      const double in_sight =
          seconds_in_view(range, device, patrol->aim, lattice_over(zone, world.terrain));
      // One that cannot hover turns beyond the edge, as much as the law "detected" allows.
      const double share = model.hovers ? 1 : 0.85;
      EXPECT_GE(in_sight, share * seconds) << which;
      EXPECT_LE(flown.seconds, patrol->times.most) << which;
      EXPECT_GE(flown.seconds, patrol->times.least) << which;
      if (std::getenv("SKEIN_SHOW") != nullptr)
        std::printf("%s asked %.0f in sight %.0f flown %.0f [%.0f %.0f %.0f] points %zu%s\n",
                    which.c_str(), seconds, in_sight, flown.seconds, patrol->times.least,
                    patrol->times.expected, patrol->times.most, patrol->way.size(),
                    patrol->aim ? " aimed" : "");
    }
  }
}

// What an aimed head sees beside the time asked is no more than what the flight may be quicker by,
// the last leg, and what is seen from further away than patrols count on.
TEST(FlownPatrols, AreCutWhereTheQuickestFlightHasTheirTime) {
  const auto marvin = vehicle_of("scenarios/comets/models/marvin.yaml");
  const world::SensorModel& device = *world::find_sensor(marvin, "visible");
  for (std::uint64_t seed = 1; seed <= skein::testing::cases(8U, 100U); ++seed) {
    Random random(seed, "cut patrols");
    const world::World world = windy(random);
    const world::Zone zone = a_zone(random, 60, 160);
    const double altitude = random.uniform(60, 110), seconds = random.uniform(60, 250);
    Refinery refinery = refinery_of(world, marvin, altitude);
    Range range(world, marvin, seed);
    ASSERT_GT(range.fly("takeoff", altitude_of(altitude), 400).seconds, 0);

    const auto patrol = refinery.patrols.over({0, 0, altitude}, zone, device, seconds);

    ASSERT_TRUE(patrol) << "seed " << seed << ": " << patrol.error();
    ASSERT_TRUE(patrol->aim) << seed;
    const auto flown = range.fly("goto", waypoints(patrol->way), 4000);
    ASSERT_GT(flown.seconds, 0) << "seed " << seed << ' ' << flown.why;
    const double in_sight =
        seconds_in_view(range, device, patrol->aim, lattice_over(zone, world.terrain));
    EXPECT_GE(in_sight, seconds) << "seed " << seed;
    EXPECT_LE(in_sight, seconds + flown.seconds - patrol->times.least + 30) << "seed " << seed;
  }
}

// To and fro over 8 m at the very edge of what it sees ahead: its nose never points there for long.
TEST(FlownPatrols, OneWhoseNoseTurnsSlowlyCountsOnlyWhatThatPointsAt) {
  const auto marvin = vehicle_of("scenarios/comets/models/marvin.yaml");
  const world::SensorModel& visible = *world::find_sensor(marvin, "visible");
  world::World world = world_of("scenarios/domains/seeds.yaml");
  world.wind = {5.8, 0.7, 0};
  world::Volume tower;
  tower.name = "tower";
  tower.polygon = {{-138, -38}, {-39, -38}, {-39, 41}, {-138, 41}};
  tower.ceiling = 139;
  world.volumes = {tower};
  world::Zone zone;
  zone.polygon = {{15, -100}, {167, -36}, {134, 42}, {-18, -23}};
  const Vector3 from(-150, 80, 95);
  Refinery refinery = refinery_of(world, marvin, 95);

  const auto patrol = refinery.patrols.over(from, zone, visible, 186);

  ASSERT_TRUE(patrol) << patrol.error();
  Range range(world, marvin, 1);
  ASSERT_GT(range.fly("takeoff", altitude_of(95), 400).seconds, 0);
  ASSERT_GT(range.fly("goto", waypoints({{0, 80, 95}, from}), 400).seconds, 0);
  ASSERT_GT(range.fly("goto", waypoints(patrol->way), 4000).seconds, 0);
  EXPECT_GE(seconds_in_view(range, visible, patrol->aim, lattice_over(zone, world.terrain)), 186);
}

/// Seconds for which the device has the zone in view during the patrol that is planned from there.
double seconds_patrolled(const world::World& world, const world::VehicleModel& model,
                         const Vector3& from, const world::Zone& zone, double seconds) {
  const world::SensorModel& device = model.sensors.front();
  const auto patrol = refinery_of(world, model, from.z()).patrols.over(from, zone, device, seconds);
  if (!patrol) return -1;
  Range range(world, model, 1);
  if (range.fly("takeoff", altitude_of(from.z()), 400).seconds < 0) return -1;
  if (range.fly("goto", waypoints({from}), 400).seconds < 0) return -1;
  if (range.fly("goto", waypoints(patrol->way), 4000).seconds < 0) return -1;
  return seconds_in_view(range, device, patrol->aim, lattice_over(zone, world.terrain));
}

// From 143 m only the steep side of its view reaches the ground, no further ahead than its axis.
TEST(FlownPatrols, GroundBeyondTheRangeOfADeviceIsNotInSight) {
  const auto ressac = vehicle_of("scenarios/action/models/ressac.yaml");
  world::World world = world_of("scenarios/domains/seeds.yaml");
  world.wind = {3.5, 0.7, 0.1};
  world::Zone zone;
  zone.polygon = {{28, -79}, {183, -23}, {138, 100}, {-16, 44}};

  EXPECT_GE(seconds_patrolled(world, ressac, {-249, 49, 143}, zone, 70), 70);
}

TEST(FlownPatrols, AreRefusedToADeviceThatHasNoGroundAheadWithinItsRange) {
  auto ressac = vehicle_of("scenarios/action/models/ressac.yaml");
  ressac.sensors.front().gimballed = false;
  const world::World world = world_of("scenarios/domains/seeds.yaml");
  world::Zone zone;
  zone.polygon = {{0, 0}, {200, 0}, {200, 200}, {0, 200}};

  const auto patrol =
      refinery_of(world, ressac, 175).patrols.over({0, 0, 175}, zone, ressac.sensors.front(), 70);

  ASSERT_FALSE(patrol);
  EXPECT_EQ(patrol.error(), "visible has no ground ahead within its range from 175 m over it");
}

// What the quickest of its flights makes of a circle of points counts, not one that misses them.
TEST(FlownPatrols, OfManyPointsNearEachOtherLastLongEnoughFromAfar) {
  const auto ressac = vehicle_of("scenarios/action/models/ressac.yaml");
  world::World world = world_of("scenarios/domains/seeds.yaml");
  world.wind = {4.5, 2, 0.1};
  world::Zone zone;
  zone.polygon = {{-48, -31}, {48, -30}, {47, 31}, {-49, 30}};

  EXPECT_GE(seconds_patrolled(world, ressac, {125, 130, 143}, zone, 168), 168);
}

TEST(FlownPatrols, AHeadIsAimedAtAZoneThatIsTooSmallToBeSeenAhead) {
  const auto marvin = vehicle_of("scenarios/comets/models/marvin.yaml");
  const world::SensorModel& visible = *world::find_sensor(marvin, "visible");
  const world::World world = world_of("scenarios/domains/seeds.yaml");
  const auto patrol = [&](double side) {
    world::Zone zone;
    zone.polygon = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    return refinery_of(world, marvin, 80).patrols.over({0, 0, 80}, zone, visible, 100);
  };

  const auto small = patrol(40), large = patrol(400);

  ASSERT_TRUE(small) << small.error();
  ASSERT_TRUE(large) << large.error();
  ASSERT_TRUE(small->aim.has_value());
  EXPECT_NEAR((small->aim->head<2>() - Vector2(20, 20)).norm(), 0, 1e-6);
  EXPECT_FALSE(large->aim.has_value());
}

/// Of what was flown outside closed air before: how deep it went into it [m].
double depth_in(const world::World& world, const std::vector<Vector3>& track) {
  double deepest = 0;
  for (const Vector3& at : track)
    for (const world::Volume& volume : world.volumes) {
      if (!is_near(volume, at, 1e-6)) continue;
      double edge = 1e9;
      for (std::size_t i = 0; i < volume.polygon.size(); ++i)
        edge = std::min(
            edge, world::to_segment<Vector2>(at.head<2>(), volume.polygon[i],
                                             volume.polygon[(i + 1) % volume.polygon.size()]));
      deepest = std::max(deepest, edge);
    }
  return deepest;
}

TEST(FlownWaits, BesideClosedAirStayOutsideIt) {
  int flown = 0;
  for (const char* name : {"karma", "heliv"}) {
    const auto model = vehicle_of(std::string("scenarios/comets/models/") + name + ".yaml");
    for (std::uint64_t seed = 1; seed <= skein::testing::cases(10U, 200U); ++seed) {
      const std::string which = std::string(name) + " seed " + std::to_string(seed);
      Random random(seed, "waits");
      world::World world = windy(random);
      for (int i = 0; i < 3; ++i) {
        world::Volume volume;
        volume.name = "tower";
        volume.polygon = a_zone(random, 20, 120).polygon;
        for (Vector2& corner : volume.polygon) corner *= 1.6;
        volume.floor = 0;
        volume.ceiling = 200;
        world.volumes.push_back(std::move(volume));
      }
      Refinery refinery = refinery_of(world, model, 80);
      Vector3 at(0, 0, 80);
      if (!refinery.air.has_room(at)) continue;
      Range range(world, model, seed);
      ASSERT_GT(range.fly("takeoff", altitude_of(80), 400).seconds, 0);
      for (int leg = 0; leg < 4; ++leg) {
        const Vector3 to(random.uniform(-250, 250), random.uniform(-250, 250), 80);
        const auto way = refinery.ways.path(at, to);
        if (!way) continue;
        const auto there = range.fly("goto", waypoints(way->way), 4000);
        ASSERT_GT(there.seconds, 0) << which << ' ' << there.why;
        EXPECT_LE(depth_in(world, range.track()), 0) << which << " leg " << leg;
        if (random.chance(0.5)) range.fly("wait", seconds_of(random.uniform(5, 60)), 100);
        EXPECT_LE(depth_in(world, range.track()), 0) << which << " wait " << leg;
        at = to;
        ++flown;
      }
    }
  }
  EXPECT_GE(flown, 20);
}

TEST(FlownPatrols, BesideClosedAirStayOutsideIt) {
  int flown = 0;
  for (const char* name : {"marvin", "heliv", "karma"}) {
    const auto model = vehicle_of(std::string("scenarios/comets/models/") + name + ".yaml");
    for (std::uint64_t seed = 1; seed <= skein::testing::cases(10U, 150U); ++seed) {
      const std::string which = std::string(name) + " seed " + std::to_string(seed);
      Random random(seed, "patrols beside closed air");
      world::World world = windy(random);
      const world::Zone zone = a_zone(random, 30, 200);
      world::Volume volume;
      volume.name = "smoke";
      volume.polygon = a_zone(random, 40, 120).polygon;
      volume.floor = 0;
      volume.ceiling = 200;
      world.volumes.push_back(volume);
      Refinery refinery = refinery_of(world, model, 60);
      const Vector3 from(0, 0, 60);
      const auto patrol =
          refinery.air.has_room(from)
              ? refinery.patrols.over(from, zone, model.sensors.front(), random.uniform(20, 200))
              : Answer<Motion>(tl::unexpected(std::string("closed")));
      if (!patrol) continue;
      Range range(world, model, seed);
      ASSERT_GT(range.fly("takeoff", altitude_of(60), 400).seconds, 0);

      const auto one = range.fly("goto", waypoints(patrol->way), 4000);

      ASSERT_GT(one.seconds, 0) << which << ' ' << one.why;
      EXPECT_LE(depth_in(world, range.track()), 0) << which;
      ++flown;
    }
  }
  EXPECT_GE(flown, 8);
}

}  // namespace
}  // namespace skein::supervisor
