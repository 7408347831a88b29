// SPDX-License-Identifier: Apache-2.0
// The durations of plans against the functional simulator: does it really fly within them?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "refinery/refinery.hpp"
#include "skein/foundation/random.hpp"
#include "test_cases.hpp"
#include "testing/planning_lab.hpp"
#include "testing/range.hpp"

namespace skein::supervisor {
namespace {

using testing::Flown;
using testing::Range;
using testing::vehicle_of;
using testing::waypoints;
using testing::world_of;
using world::Vector3;

world::World windy(double speed, double gusts) {
  world::World world = world_of("scenarios/domains/seeds.yaml");
  world.wind = {0.6, speed, gusts};
  return world;
}

/// Takes off, flies to places here and there, lands; each within its times.
void expect_within(const world::World& world, const world::VehicleModel& model, std::uint64_t seed,
                   int legs) {
  const auto shared = std::make_shared<const world::World>(world);
  Knowledge knowledge;
  knowledge.vehicle = model;
  Refinery refinery(Gazetteer(std::make_shared<const Knowledge>(knowledge), shared), {}, seed);
  Range range(world, model, seed);
  Random random(seed, "places");
  const auto check = [&](const std::string& what, const Flown& flown, const Times& times) {
    EXPECT_GE(flown.seconds, times.least)
        << model.name << ' ' << what << " seed " << seed << ' ' << flown.why;
    EXPECT_LE(flown.seconds, times.most) << model.name << ' ' << what << " seed " << seed;
    if (std::getenv("SKEIN_SHOW") != nullptr)
      std::printf("%s %s [%.1f %.1f %.1f] flown %.1f %s\n", model.name.c_str(), what.c_str(),
                  times.least, times.expected, times.most, flown.seconds, flown.why.c_str());
  };
  const Motion up = refinery.ways.takeoff(Vector3::Zero()).value();
  functional::Parameters altitude;
  altitude.add("altitude", up.way.back().z());
  check("takeoff", range.fly("takeoff", altitude, 200), up.times);
  for (int i = 0; i < legs; ++i) {
    const Vector3 to(random.uniform(-300, 300), random.uniform(-300, 300), random.uniform(30, 90));
    const auto motion = refinery.ways.path(range.position(), to);
    ASSERT_TRUE(motion) << motion.error();
    const Flown flown = range.fly("goto", waypoints(motion->way), 2000);
    check("goto " + std::to_string(refiners::length_of(motion->way)) + " m", flown, motion->times);
  }
  const Vector3 at = range.position();
  check("land", range.fly("land", {}, 600), refinery.ways.landing(at, at).value().times);
}

TEST(FlownTimes, HelicoptersFlyWithinThemInWind) {
  for (const char* name : {"marvin", "heliv"})
    for (std::uint64_t seed = 1; seed <= skein::testing::cases(3U, 300U); ++seed)
      expect_within(windy(2, 0.5),
                    vehicle_of(std::string("scenarios/comets/models/") + name + ".yaml"), seed, 8);
}

TEST(FlownTimes, TheBlimpFliesWithinThemInWind) {
  for (std::uint64_t seed = 1; seed <= skein::testing::cases(6U, 300U); ++seed)
    expect_within(windy(2, 0.5), vehicle_of("scenarios/comets/models/karma.yaml"), seed, 8);
}

/// Down in circles of points that are as near as its turns: some are missed and come back to.
TEST(FlownTimes, PointsThatAreMissedAreWithinThem) {
  const auto model = vehicle_of("scenarios/comets/models/karma.yaml");
  const world::World world = windy(2, 0.5);
  std::size_t outside = 0, flights = 0;
  for (std::uint64_t seed = 1; seed <= skein::testing::cases(25U, 600U); ++seed) {
    Random random(seed, "circles");
    Range range(world, model, seed);
    functional::Parameters altitude;
    altitude.add("altitude", 90.0);
    ASSERT_GT(range.fly("takeoff", altitude, 300).seconds, 0);
    const Vector3 begin(random.uniform(-200, 200), random.uniform(-200, 200), 90);
    ASSERT_GT(range.fly("goto", waypoints({range.position(), begin}), 2000).seconds, 0);
    refiners::Way way = {range.position()};
    const double first = random.uniform(-3, 3), sense = random.chance(0.5) ? 1 : -1;
    const double points = random.uniform(3, 12);
    for (int i = 0; i < points; ++i) {
      const double angle = first + sense * 1.1 * i;
      way.push_back(begin + Vector3(40 * (std::cos(angle) - std::cos(first)),
                                    40 * (std::sin(angle) - std::sin(first)), -4.5 * i));
    }
    const Times times = flight_times(way, model, world.wind);
    const Flown flown = range.fly("goto", waypoints(way), 2000);
    ++flights;
    if (flown.seconds < times.least || flown.seconds > times.most) ++outside;
  }
  EXPECT_LE(outside, flights / 300) << "of " << flights;
}

TEST(FlownTimes, StillAirIsNoSpecialCase) {
  for (const char* name : {"marvin", "heliv", "karma"})
    expect_within(windy(0, 0), vehicle_of(std::string("scenarios/comets/models/") + name + ".yaml"),
                  11, 8);
}

TEST(FlownTimes, PatternsAreFlownWithinThem) {
  const world::World world = windy(2, 0.5);
  for (const char* name : {"marvin", "heliv", "karma"}) {
    const auto model = vehicle_of(std::string("scenarios/comets/models/") + name + ".yaml");
    Knowledge knowledge;
    knowledge.vehicle = model;
    Refinery refinery(Gazetteer(std::make_shared<const Knowledge>(knowledge),
                                std::make_shared<const world::World>(world)),
                      {}, 1);
    Range range(world, model, 5);
    functional::Parameters altitude;
    altitude.add("altitude", 40.0);
    ASSERT_GT(range.fly("takeoff", altitude, 200).seconds, 0);
    const Motion way = refinery.ways.path(range.position(), {10, 80, 40}).value();
    ASSERT_GT(range.fly("goto", waypoints(way.way), 200).seconds, 0);

    const auto patrol =
        refinery.patrols.over({10, 80, 40}, world.zones.front(), model.sensors.front(), 240);
    ASSERT_TRUE(patrol) << patrol.error();
    const Flown flown = range.fly("goto", waypoints(patrol->way), 2000);

    if (std::getenv("SKEIN_SHOW") != nullptr)
      std::printf("%s patrol %zu points [%.1f %.1f %.1f] flown %.1f %s\n", name, patrol->way.size(),
                  patrol->times.least, patrol->times.expected, patrol->times.most, flown.seconds,
                  flown.why.c_str());
    EXPECT_GE(flown.seconds, patrol->times.least) << name << ' ' << flown.why;
    EXPECT_LE(flown.seconds, patrol->times.most) << name;

    const auto sweep =
        refinery.sweeps.over(range.position(), world.zones.front(), model.sensors.front());
    ASSERT_TRUE(sweep) << sweep.error();
    const Motion to_sweep = refinery.ways.path(range.position(), sweep->way.front()).value();
    ASSERT_GT(range.fly("goto", waypoints(to_sweep.way), 2000).seconds, 0);
    const Flown swept = range.fly("goto", waypoints(sweep->way), 2000);
    if (std::getenv("SKEIN_SHOW") != nullptr)
      std::printf("%s sweep %zu points [%.1f %.1f %.1f] flown %.1f %s\n", name, sweep->way.size(),
                  sweep->times.least, sweep->times.expected, sweep->times.most, swept.seconds,
                  swept.why.c_str());
    EXPECT_GE(swept.seconds, sweep->times.least) << name << ' ' << swept.why;
    EXPECT_LE(swept.seconds, sweep->times.most) << name;
  }
}

/// From the last point of a way, in the field, between 30 and 100 m up.
Vector3 next_point(Random& random, const Vector3& from) {
  const double reach = random.chance(0.3) ? 60 : 350;
  const double rise = random.chance(0.5) ? 0 : random.uniform(-30, 30);
  const Vector3 to =
      from + Vector3(random.uniform(-reach, reach), random.uniform(-reach, reach), rise);
  return to.cwiseMax(Vector3(-300, -300, 30)).cwiseMin(Vector3(300, 300, 100));
}

struct Statistics {
  std::size_t flights = 0, outside = 0;
  std::vector<double> share;  ///< of the greatest duration by the flown one, over 100 m and more
};

/// Random ways one after the other, at times with a wait between, in a random wind.
void fly_random_ways(const world::VehicleModel& model, std::uint64_t seed, Statistics& all) {
  Random random(seed, "ways");
  world::World world = windy(random.uniform(0, 4), random.uniform(0, 1));
  world.wind.toward = random.uniform(-3, 3);
  if (random.chance(0.2)) world.wind.speed = world.wind.gusts = 0;
  Range range(world, model, seed);
  Vector3 at(0, 0, random.uniform(30, 100));
  functional::Parameters altitude;
  altitude.add("altitude", at.z());
  ASSERT_GT(range.fly("takeoff", altitude, 300).seconds, 0);
  for (int leg = 0; leg < 6; ++leg) {
    functional::Parameters seconds;
    seconds.add("duration", random.uniform(1, 60));
    if (random.chance(0.4)) range.fly("wait", seconds, 100);
    refiners::Way way = {at};
    const double points = random.chance(0.6) ? 1 : random.uniform(1, 9);
    while (static_cast<double>(way.size()) <= points) way.push_back(next_point(random, way.back()));
    const Times times = flight_times(way, model, world.wind);
    const Flown flown = range.fly("goto", waypoints(way), 4000);
    ASSERT_GT(flown.seconds, 0) << model.name << " seed " << seed << ' ' << flown.why;
    ++all.flights;
    if (flown.seconds < times.least || flown.seconds > times.most) ++all.outside;
    if (refiners::length_of(way) > 100) all.share.push_back(times.most / flown.seconds);
    at = way.back();
  }
}

TEST(FlownTimes, HoldRandomWaysInRandomWindsAndAreNarrow) {
  for (const auto& [name, narrow] : {std::pair{"marvin", 1.2}, {"heliv", 1.5}, {"karma", 1.9}}) {
    const auto model = vehicle_of(std::string("scenarios/comets/models/") + name + ".yaml");
    Statistics all;
    for (std::uint64_t seed = 1; seed <= skein::testing::cases(15U, 400U); ++seed)
      fly_random_ways(model, seed, all);

    EXPECT_LE(all.outside, 1 + all.flights / 1000) << name;
    const auto median = all.share.begin() + std::ssize(all.share) / 2;
    std::nth_element(all.share.begin(), median, all.share.end());
    EXPECT_LE(*median, narrow) << name;
  }
}

/// Robots drive from place to place among hills; each within its times.
TEST(FlownTimes, RobotsDriveWithinThem) {
  int drives = 0;
  for (const char* name : {"mana", "effibot"}) {
    const auto model = vehicle_of(std::string("scenarios/action/models/") + name + ".yaml");
    for (std::uint64_t seed = 1; seed <= skein::testing::cases(4U, 200U); ++seed) {
      Random random(seed, "drives");
      world::World world = windy(2, 0.5);
      world::TerrainSpec spec = world.terrain.spec();
      spec.hills.clear();
      spec.elevations.clear();
      for (int i = 0; i < 4; ++i)
        spec.hills.push_back({{random.uniform(-250, 250), random.uniform(-250, 250)},
                              random.uniform(2, 40),
                              random.uniform(50, 120)});
      world.terrain = world::Terrain(spec);
      Knowledge knowledge;
      knowledge.vehicle = model;
      Refinery refinery(Gazetteer(std::make_shared<const Knowledge>(knowledge),
                                  std::make_shared<const world::World>(world)),
                        {}, seed);
      Range range(world, model, seed);
      for (int i = 0; i < 8; ++i) {
        const Vector3 to(random.uniform(-280, 280), random.uniform(-280, 280), 0);
        const auto motion = refinery.ways.path(range.position(), to);
        if (!motion) continue;  // too steep there
        const Flown flown = range.fly("goto", waypoints(motion->way), 3000);
        EXPECT_GE(flown.seconds, motion->times.least) << name << " seed " << seed << flown.why;
        EXPECT_LE(flown.seconds, motion->times.most) << name << " seed " << seed;
        EXPECT_LE(motion->times.most, 1.25 * motion->times.least + 30) << name;
        ++drives;
      }
    }
  }
  EXPECT_GT(drives, 30);
}

}  // namespace
}  // namespace skein::supervisor
