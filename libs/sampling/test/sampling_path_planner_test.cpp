// SPDX-License-Identifier: Apache-2.0
#include "skein/sampling/sampling_path_planner.hpp"

#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "skein/refiners/flyable.hpp"
#include "worlds.hpp"

namespace skein::sampling {
namespace {

using refiners::Outcome;
using refiners::Path;
using refiners::PathQuery;
using refiners::RefusalKind;
using refiners::Setting;
using refiners::Way;
using world::Vector3;

PathQuery a_query(const Vector3& from, const Vector3& to) {
  PathQuery query;
  query.vehicle = a_helicopter();
  query.from = from;
  query.to = to;
  return query;
}

Outcome<Path> planned(const world::World& world, const PathQuery& query, std::uint64_t seed = 1) {
  return SamplingPathPlanner().plan(query, Setting{.world = world, .budget = {}, .seed = seed});
}

/// A wall across the plain with a gap at its north end.
world::World walled() {
  world::World world = a_plain();
  world.volumes = {a_box("wall", {480, 0}, {520, 900}, -10, 300)};
  return world;
}

/// By the terrain and the distance to polygons alone, every 20 cm.
void expect_free(const Way& way, const world::World& world, const PathQuery& query,
                 double body_radius = 1) {
  std::vector<world::Volume> volumes = world.volumes;
  volumes.insert(volumes.end(), query.reserved.begin(), query.reserved.end());
  for (const Vector3& point : points_along(way, 0.2)) {
    const double height = point.z() - world.terrain.elevation(point.x(), point.y());
    ASSERT_GE(height, std::max(query.clearance, body_radius) - 1e-6) << point.transpose();
    ASSERT_LE(height, query.vehicle.ceiling + 1e-5) << point.transpose();
    for (const world::Volume& volume : volumes)
      ASSERT_GE(distance_to(volume, point), body_radius - 1e-3)
          << volume.name << " at " << point.transpose();
  }
}

TEST(SamplingPathPlanner, GoesStraightWhereThatIsFree) {
  const auto path = planned(a_plain(), a_query({100, 100, 50}, {900, 800, 80}));

  ASSERT_TRUE(path.has_value());
  EXPECT_EQ(path->task.way, (Way{{100, 100, 50}, {900, 800, 80}}));
  EXPECT_EQ(path->effort.steps, 0U);
  EXPECT_DOUBLE_EQ(path->cost, path->task.length);
  EXPECT_GT(path->duration.expected, Duration::seconds(path->task.length / 8.1));
}

TEST(SamplingPathPlanner, GoesRoundAWallByAboutTheShortestWay) {
  const auto query = a_query({100, 100, 50}, {900, 100, 50});
  const auto world = walled();

  const double shortest = 2 * std::hypot(380 - 1, 801) + 42;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const auto path = planned(world, query, seed);

    ASSERT_TRUE(path.has_value()) << path.error().why;
    expect_free(path->task.way, world, query);
    EXPECT_GE(path->task.length, shortest - 3);
    EXPECT_LE(path->task.length, 1.01 * shortest) << "seed " << seed;
    EXPECT_FALSE(path->effort.cut_short);
  }
}

TEST(SamplingPathPlanner, KeepsOutOfVolumesReservedByOthers) {
  auto query = a_query({100, 500, 50}, {900, 500, 50});
  query.reserved = {a_box("other's", {400, 300}, {600, 700}, 0, 120)};

  const auto path = planned(a_plain(), query);

  ASSERT_TRUE(path.has_value());
  expect_free(path->task.way, a_plain(), query);
}

TEST(SamplingPathPlanner, WaysOverHillsAmongConcaveVolumesAreFree) {
  Random random(1);
  int found = 0, refused = 0;
  for (int i = 0; i < 8; ++i) {
    world::World world = hills(random);
    for (int k = 0; k < 8; ++k) world.volumes.push_back(a_star(random, std::to_string(k)));
    const auto at = [&](double x, double y) {
      return Vector3(x, y, world.terrain.elevation(x, y) + random.uniform(15, 60));
    };
    auto query = a_query(at(random.uniform(0, 200), random.uniform(0, 1000)),
                         at(random.uniform(800, 1000), random.uniform(0, 1000)));
    query.clearance = 10;
    query.vehicle.ceiling = 120;

    const auto path = planned(world, query);

    if (!path) {
      ++refused;
      EXPECT_TRUE(path.error().kind == RefusalKind::kBlocked ||
                  path.error().kind == RefusalKind::kBudgetExhausted)
          << path.error().why;
      continue;
    }
    ++found;
    expect_free(path->task.way, world, query);
  }
  EXPECT_GE(found, 4) << refused << " refused";
}

TEST(SamplingPathPlanner, VehiclesThatCannotHoverGetWaysTheyCanFly) {
  Random random(2);
  int found = 0;
  for (int i = 0; i < 6; ++i) {
    const world::World world = i == 0 ? walled() : hills(random, 8);
    auto query = a_query({60, 100, 170}, {940, random.uniform(100, 900), 150});
    query.vehicle = a_blimp();
    query.heading_from = random.uniform(-3, 3);
    query.heading_to = random.uniform(-3, 3);

    const auto path = planned(world, query);

    if (!path) continue;
    ++found;
    EXPECT_TRUE(refiners::is_flyable(path->task.way, query.vehicle, 0, 0.5));
    EXPECT_EQ(path->task.way.front(), query.from);
    EXPECT_EQ(path->task.way.back(), query.to);
    expect_free(path->task.way, world, query);
  }
  EXPECT_GE(found, 4);
}

TEST(SamplingPathPlanner, VolumesThatComeAfterTheFlightDoNotCount) {
  world::World world = walled();
  const auto query = a_query({100, 100, 50}, {900, 100, 50});
  const auto length_if_there_from = [&](double seconds) {
    world.volumes[0].when.from = MissionTime::seconds(seconds);
    return planned(world, query)->task.length;
  };

  EXPECT_NEAR(length_if_there_from(1000), 800, 1e-6) << "over after 100 s";
  EXPECT_GT(length_if_there_from(60), 1800);
}

TEST(SamplingPathPlanner, WhatBlocksAnEndIsNamed) {
  const auto world = walled();

  const auto start = planned(world, a_query({500, 500, 50}, {900, 500, 50}));
  const auto goal = planned(world, a_query({100, 500, 50}, {900, 500, -3}));
  const auto outside = planned(world, a_query({100, 500, 50}, {2000, 500, 50}));
  auto high = a_query({100, 500, 50}, {900, 500, 180});
  high.vehicle.ceiling = 100;

  EXPECT_EQ(start.error().kind, RefusalKind::kBlocked);
  EXPECT_EQ(start.error().field, "from");
  EXPECT_NE(start.error().why.find("the volume 'wall'"), std::string::npos) << start.error().why;
  EXPECT_EQ(goal.error().field, "to");
  EXPECT_NE(goal.error().why.find("the ground"), std::string::npos) << goal.error().why;
  EXPECT_NE(outside.error().why.find("the limits"), std::string::npos) << outside.error().why;
  EXPECT_EQ(planned(world, high).error().kind, RefusalKind::kBeyondVehicle);
}

TEST(SamplingPathPlanner, WhatItDoesNotFindItDoesNotCallUnreachable) {
  world::World world = walled();
  world.volumes[0].polygon = {{480, -10}, {520, -10}, {520, 1010}, {480, 1010}};
  Setting setting{.world = world, .budget = {.time_is_up = {}, .steps = 300}};

  const auto path = SamplingPathPlanner().plan(a_query({100, 100, 50}, {900, 100, 50}), setting);

  ASSERT_FALSE(path.has_value());
  EXPECT_EQ(path.error().kind, RefusalKind::kBudgetExhausted);
  EXPECT_NE(path.error().why.find("300 samples"), std::string::npos) << path.error().why;
}

TEST(SamplingPathPlanner, StopsWhenTheTimeIsUp) {
  world::World world = walled();
  world.volumes[0].polygon = {{480, -10}, {520, -10}, {520, 1010}, {480, 1010}};
  int asked = 0;
  Setting setting{.world = world, .budget = {.time_is_up = [&] { return ++asked > 20; }}};

  const auto path = SamplingPathPlanner().plan(a_query({100, 100, 50}, {900, 100, 50}), setting);

  ASSERT_FALSE(path.has_value());
  EXPECT_NE(path.error().why.find("the time was up"), std::string::npos) << path.error().why;
  EXPECT_LE(asked, 25);
}

TEST(SamplingPathPlanner, KeepsRadioContactAtEverySample) {
  Random random(3);
  int found = 0;
  for (int i = 0; i < 4; ++i) {
    world::World world = hills(random, 6);
    world.radio.range = 800;
    auto query = a_query({50, 50, 150}, {950, 500, 150});
    query.contact = refiners::Contact{{300, 300, 190}, {{750, 400, 195}, {5000, 0, 0}}};

    const auto path = planned(world, query);

    if (!path) continue;
    ++found;
    const bool relayed =
        world.radio.link(query.contact->with, query.contact->relays[0], world.terrain, false).up;
    for (const Vector3& point : points_along(path->task.way, 1.0)) {
      const auto up = [&](const Vector3& station) {
        return world.radio.link(station, point, world.terrain, false).up;
      };
      ASSERT_TRUE(up(query.contact->with) || (relayed && up(query.contact->relays[0])));
    }
  }
  EXPECT_GE(found, 1);
}

TEST(SamplingPathPlanner, RefusesWhoHasNoContactAtAnEnd) {
  world::World world = a_plain();
  world.radio.range = 300;
  auto query = a_query({50, 50, 50}, {950, 500, 50});
  query.contact = refiners::Contact{{100, 100, 10}, {}};

  const auto path = planned(world, query);

  ASSERT_FALSE(path.has_value());
  EXPECT_EQ(path.error().kind, RefusalKind::kNoContact);
  EXPECT_EQ(path.error().field, "to");
}

TEST(SamplingPathPlanner, TheSameSeedGivesTheSameWayWhateverWentOnBefore) {
  const auto world = walled();
  const auto query = a_query({100, 100, 50}, {900, 100, 50});
  const auto other = a_query({900, 300, 50}, {100, 700, 60});

  const auto first = planned(world, query, 5);
  const auto other_after = planned(world, other, 7);
  for (int i = 0; i < 17; ++i) ompl::RNG().uniform01();  // OMPL's shared generator moves on
  const auto other_again = planned(world, other, 7);
  const auto again = planned(world, query, 5);
  const auto reseeded = planned(world, query, 6);

  EXPECT_EQ(first->task.way, again->task.way);
  EXPECT_EQ(first->effort, again->effort);
  EXPECT_EQ(other_after->task.way, other_again->task.way);
  EXPECT_NE(first->task.way, reseeded->task.way);
}

TEST(SamplingPathPlanner, KeepsQuietAndLeavesOthersTheirMessages) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  ASSERT_TRUE(planned(walled(), a_query({100, 100, 50}, {900, 100, 50})).has_value());
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  testing::internal::CaptureStdout();
  OMPL_INFORM("from somebody else");
  EXPECT_NE(testing::internal::GetCapturedStdout().find("somebody else"), std::string::npos);
}

TEST(SamplingPathPlanner, FiguresThatMakeNoSenseAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PathQuery good = a_query({100, 100, 50}, {900, 100, 50});
  std::vector<PathQuery> queries(9, good);
  queries[0].from.x() = nan;
  queries[1].to.z() = std::numeric_limits<double>::infinity();
  queries[2].clearance = -1;
  queries[3].speed = nan;
  queries[4].heading_from = nan;
  queries[5].reserved = {{"crossed", {{0, 0}, {10, 10}, {10, 0}, {0, 10}}, 0, 10, {}}};
  queries[6].reserved = {a_box("upside down", {0, 0}, {10, 10}, 50, 20)};
  queries[7].contact = refiners::Contact{{nan, 0, 0}, {}};
  queries[8].vehicle.cruise_speed = -3;

  for (const PathQuery& query : queries) {
    const auto path = planned(a_plain(), query);
    ASSERT_FALSE(path.has_value());
    EXPECT_EQ(path.error().kind, RefusalKind::kBadQuery) << path.error().why;
    EXPECT_NE(path.error().field, "");
  }
  PathQuery fast = good;
  fast.speed = 100;
  EXPECT_EQ(planned(a_plain(), fast).error().kind, RefusalKind::kBeyondVehicle);
}

}  // namespace
}  // namespace skein::sampling
