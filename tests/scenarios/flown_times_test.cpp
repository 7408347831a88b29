// SPDX-License-Identifier: Apache-2.0
// The durations of plans against the functional simulator: does it really fly within them?
#include <gtest/gtest.h>

#include <cmath>

#include "refinery.hpp"
#include "skein/foundation/random.hpp"
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
  const Motion up = refinery.takeoff(Vector3::Zero()).value();
  world::Parameters altitude;
  altitude.add("altitude", up.way.back().z());
  check("takeoff", range.fly("takeoff", altitude, 200), up.times);
  for (int i = 0; i < legs; ++i) {
    const Vector3 to(random.uniform(-300, 300), random.uniform(-300, 300), random.uniform(30, 90));
    const auto motion = refinery.path(range.position(), to);
    ASSERT_TRUE(motion) << motion.error();
    check("goto " + std::to_string((to - range.position()).norm()),
          range.fly("goto", waypoints(motion->way), 2000), motion->times);
  }
  const Vector3 at = range.position();
  check("land", range.fly("land", {}, 600), refinery.landing(at, at).value().times);
}

TEST(FlownTimes, HelicoptersFlyWithinThemInWind) {
  for (const char* name : {"marvin", "heliv"})
    for (std::uint64_t seed = 1; seed <= (std::getenv("SKEIN_LONG") ? 300U : 3U); ++seed)
      expect_within(windy(2, 0.5),
                    vehicle_of(std::string("scenarios/comets/models/") + name + ".yaml"), seed, 8);
}

TEST(FlownTimes, TheBlimpFliesWithinThemInWind) {
  for (std::uint64_t seed = 1; seed <= (std::getenv("SKEIN_LONG") ? 300U : 6U); ++seed)
    expect_within(windy(2, 0.5), vehicle_of("scenarios/comets/models/karma.yaml"), seed, 8);
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
    world::Parameters altitude;
    altitude.add("altitude", 40.0);
    ASSERT_GT(range.fly("takeoff", altitude, 200).seconds, 0);
    const Motion way = refinery.path(range.position(), {10, 80, 40}).value();
    ASSERT_GT(range.fly("goto", waypoints(way.way), 200).seconds, 0);

    const auto patrol =
        refinery.patrol({10, 80, 40}, world.zones.front(), model.sensors.front(), 240);
    ASSERT_TRUE(patrol) << patrol.error();
    const Flown flown = range.fly("goto", waypoints(patrol->way), 2000);

    if (std::getenv("SKEIN_SHOW") != nullptr)
      std::printf("%s patrol %zu points [%.1f %.1f %.1f] flown %.1f %s\n", name, patrol->way.size(),
                  patrol->times.least, patrol->times.expected, patrol->times.most, flown.seconds,
                  flown.why.c_str());
    EXPECT_GE(flown.seconds, patrol->times.least) << name << ' ' << flown.why;
    EXPECT_LE(flown.seconds, patrol->times.most) << name;

    const auto sweep = refinery.sweep(range.position(), world.zones.front(), model.sensors.front());
    ASSERT_TRUE(sweep) << sweep.error();
    const Motion to_sweep = refinery.path(range.position(), sweep->way.front()).value();
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

}  // namespace
}  // namespace skein::supervisor
