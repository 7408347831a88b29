// SPDX-License-Identifier: Apache-2.0
// valid-position() against an exhaustive fine grid and constraints reckoned naively.
#include "skein/interaction/valid_position.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "skein/foundation/random.hpp"
#include "test_cases.hpp"

namespace skein::interaction {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSide = 160, kHeight = 80;

/// Where fire, its inside, a partner and the ground station are.
using Places = std::map<std::string, Position>;

/// Level ground, and air up to a height.
world::World level(double side, std::int32_t up) {
  world::TerrainSpec ground;
  ground.east = ground.north = side;
  world::World world{{}, world::Terrain(ground), {}, {}, {}, {}, {}, {}, {}};
  const auto voxels = static_cast<std::int32_t>(side / 10);
  world.airspace = {world::Vector3::Zero(), 10, {voxels, voxels, up}};
  return world;
}

struct Case {
  world::World world = level(kSide, 8);
  world::VehicleModel vehicle;
  Places places;
  std::vector<ActiveScm> scms;
  Position from{};
};

SpatialConstraint constraint(SpatialConstraint::Quantity quantity, std::vector<std::string> of,
                             Relation relation, double than, double tolerance = 0) {
  return {quantity, std::move(of), relation, Term(than), tolerance};
}

ActiveScm active(std::string id, std::vector<SpatialConstraint> constraints) {
  ActiveScm one{std::move(id), {}, {}};
  one.scm.name = one.id;
  one.scm.constraints = std::move(constraints);
  for (const char* place : {"fire", "inside", "partner", "station"}) {
    one.scm.parameters.push_back({place, true});
    one.binding.places[place] = {place};
  }
  return one;
}

using Quantity = SpatialConstraint::Quantity;

/// As the SCMs of the reference model, with figures of every size.
std::vector<ActiveScm> any_scms(Random& random) {
  std::vector<ActiveScm> scms;
  if (random.chance(0.7)) {
    const double near = random.uniform(5, 40);
    scms.push_back(active(
        "perception",
        {constraint(Quantity::kDistance, {"fire"}, Relation::kGreater, near),
         constraint(Quantity::kDistance, {"fire"}, Relation::kLess, near + random.uniform(5, 40)),
         constraint(Quantity::kAzimuth, {"fire", "inside"}, Relation::kEqual,
                    random.uniform(0, 2 * kPi), random.uniform(0.1, 0.5)),
         constraint(Quantity::kAltitude, {"fire", "inside"}, Relation::kEqual,
                    random.uniform(0.1, 1.2), random.uniform(0.1, 0.3))}));
  }
  if (random.chance(0.6)) {
    const double reach = random.uniform(20, 120);
    scms.push_back(
        active("between", {constraint(Quantity::kDistance, {"partner"}, Relation::kLess, reach),
                           constraint(Quantity::kDistance, {"station"}, Relation::kLess,
                                      reach + random.uniform(0, 60))}));
  }
  SpatialConstraint nearer = constraint(Quantity::kDistance, {"fire"}, Relation::kLess, 0);
  nearer.than = std::vector<std::string>{"fire", "partner"};
  if (random.chance(0.3)) scms.push_back(active("nearer", {nearer}));
  scms.push_back(active("apart", {constraint(Quantity::kDistance, {"partner"}, Relation::kGreater,
                                             random.uniform(5, 30))}));
  return scms;
}

Case any_case(std::uint64_t seed) {
  Random random(seed);
  const auto inside = [&] { return random.uniform(10, kSide - 10); };
  Case one;
  world::TerrainSpec terrain;
  terrain.east = terrain.north = kSide;
  terrain.cell = 10;
  for (int i = 0; i < 3; ++i) {
    terrain.hills.push_back(
        {{inside(), inside()}, random.uniform(-10, 50), random.uniform(20, 70)});
  }
  one.world.terrain = world::Terrain(terrain);
  one.world.airspace.origin.z() = -20;
  one.world.airspace.size[2] = 10;
  for (std::uint64_t i = 0; i < random.below(4); ++i) {
    const double x = inside(), y = inside(), r = random.uniform(5, 40);
    one.world.volumes.push_back({"zone",
                                 {{x - r, y - r}, {x + r, y - r}, {x + r, y + r}, {x - r, y + r}},
                                 random.uniform(-20, 40),
                                 60,
                                 {}});
  }
  one.vehicle.ceiling = 60;
  for (const char* name : {"fire", "inside", "station"}) {
    const double x = inside(), y = inside();
    one.places[name] = {x, y, one.world.terrain.elevation(x, y)};
  }
  one.places["partner"] = {inside(), inside(), random.uniform(20, 70)};
  one.from = {inside(), inside(), random.uniform(20, 70)};
  one.scms = any_scms(random);
  return one;
}

double naive_value(const SpatialConstraint& c, const Places& places, const Position& at) {
  const Position& o = places.at(c.of[0]);
  const double dx = at[0] - o[0], dy = at[1] - o[1], dz = at[2] - o[2];
  if (c.quantity == Quantity::kDistance) return std::sqrt(dx * dx + dy * dy + dz * dz);
  if (c.quantity == Quantity::kAltitude) return std::atan(dz / std::sqrt(dx * dx + dy * dy));
  const Position& to = places.at(c.of[1]);
  return std::atan2(dy, dx) - std::atan2(to[1] - o[1], to[0] - o[0]);
}

bool naive_holds(const Case& one, const Position& at) {
  const auto& world = one.world;
  if (at[0] < 0 || at[0] > kSide || at[1] < 0 || at[1] > kSide) return false;
  const double height = at[2] - world.terrain.elevation(at[0], at[1]);
  if (height < 5 || height > 60 || at[2] > kHeight || at[2] < -20) return false;
  for (const auto& zone : world.volumes) {
    const bool over = at[0] >= zone.polygon[0].x() && at[0] <= zone.polygon[2].x() &&
                      at[1] >= zone.polygon[0].y() && at[1] <= zone.polygon[2].y();
    if (over && at[2] >= zone.floor && at[2] <= zone.ceiling) return false;
  }
  for (const ActiveScm& scm : one.scms) {
    for (const SpatialConstraint& c : scm.scm.constraints) {
      const double value = naive_value(c, one.places, at);
      double than = 0;
      if (const auto* term = std::get_if<Term>(&c.than)) {
        than = std::get<double>(*term);
      } else {
        const Position &a = one.places.at("fire"), &b = one.places.at("partner");
        than = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      }
      if (c.relation == Relation::kLess && !(value < than)) return false;
      if (c.relation == Relation::kGreater && !(value > than)) return false;
      if (c.relation != Relation::kEqual) continue;
      const double turn = c.quantity == Quantity::kAzimuth ? 2 * kPi : 1e9;
      if (std::abs(std::remainder(value - than, turn)) > c.tolerance) return false;
    }
  }
  return true;
}

bool grid_has_one(const Case& one, double step) {
  for (double x = 0; x <= kSide; x += step) {
    for (double y = 0; y <= kSide; y += step) {
      for (double z = -20; z <= kHeight; z += step) {
        if (naive_holds(one, {x, y, z})) return true;
      }
    }
  }
  return false;
}

Observer observer_of(const Places& places) {
  return [&places](const std::string& name) -> std::optional<Sighting> {
    const auto found = places.find(name);
    if (found == places.end()) return std::nullopt;
    return Sighting{found->second, MissionTime()};
  };
}

ValidPositionQuery query_of(const Case& one) {
  ValidPositionQuery query;
  query.scms = one.scms;
  query.air = free_air_of(one.world, one.vehicle, 5, MissionTime());
  query.from = one.from;
  return query;
}

std::uint64_t cases() { return skein::testing::cases<std::uint64_t>(40, 1000); }

TEST(ValidPosition, IsFoundWhereTheGridHasOneAndTrueWhereItIsFound) {
  std::size_t there = 0, found = 0, beyond = 0;
  std::vector<double> milliseconds;
  for (std::uint64_t seed = 1; seed <= cases(); ++seed) {
    const Case one = any_case(seed);
    const auto begun = std::chrono::steady_clock::now();
    const auto position = valid_position(query_of(one), observer_of(one.places), MissionTime());
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begun;
    milliseconds.push_back(took.count());

    ASSERT_TRUE(!position || naive_holds(one, position->position)) << seed;
    const bool in_grid = grid_has_one(one, 2);
    there += in_grid ? 1 : 0;
    found += in_grid && position ? 1 : 0;
    beyond += !in_grid && position ? 1 : 0;
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  const std::size_t n = milliseconds.size();
  std::printf(
      "grid has one in %zu of %zu; found %zu of those, %zu between its points; 95 %% in %.1f ms, "
      "all in %.1f ms\n",
      there, n, found, beyond, milliseconds[n * 95 / 100], milliseconds.back());
  EXPECT_GT(there, n / 4);
  EXPECT_LT(there, n * 9 / 10);
  EXPECT_GE(static_cast<double>(found), 0.99 * static_cast<double>(there));
}

TEST(ValidPosition, OfTheReferenceModelIsInFrontOfTheFireAtThirtyDegrees) {
  Case one;
  one.vehicle.ceiling = 80;
  one.places = {{"fire", {80, 80, 0}},
                {"inside", {120, 80, 0}},
                {"partner", {10, 10, 30}},
                {"station", {0, 0, 0}}};
  one.scms = {active(
      "mcs2",
      {constraint(Quantity::kDistance, {"fire"}, Relation::kGreater, 25),
       constraint(Quantity::kDistance, {"fire"}, Relation::kLess, 50),
       constraint(Quantity::kAzimuth, {"fire", "inside"}, Relation::kEqual, 0, 0.2),
       constraint(Quantity::kAltitude, {"fire", "inside"}, Relation::kEqual, kPi / 6, 0.2)})};
  one.from = {10, 80, 30};

  const auto found = valid_position(query_of(one), observer_of(one.places), MissionTime());

  ASSERT_TRUE(found);
  EXPECT_TRUE(found->by_margin);
  EXPECT_TRUE(naive_holds(one, found->position));
  EXPECT_LT(found->position[0], 80 + 26 * std::cos(kPi / 6) + 4) << "no farther than it must be";
}

TEST(ValidPosition, WhereOneIsAlreadyItStays) {
  Case one = any_case(1);
  one.scms.clear();
  one.world.volumes.clear();
  one.from = {80, 80, one.world.terrain.elevation(80, 80) + 20};

  const auto found = valid_position(query_of(one), observer_of(one.places), MissionTime());

  ASSERT_TRUE(found);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found->position[i], one.from[i], 1e-9);
}

TEST(ValidPosition, OneSeedGivesOneAnswer) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Case one = any_case(seed);
    const auto first = valid_position(query_of(one), observer_of(one.places), MissionTime());
    const auto again = valid_position(query_of(one), observer_of(one.places), MissionTime());
    ASSERT_EQ(first.has_value(), again.has_value());
    EXPECT_TRUE(!first || first->position == again->position) << seed;
  }
}

TEST(ValidPosition, WhatExcludesEachOtherHasNoneWithinTheBudget) {
  Case one = any_case(3);
  one.scms = {active("s", {constraint(Quantity::kDistance, {"fire"}, Relation::kLess, 30),
                           constraint(Quantity::kDistance, {"fire"}, Relation::kGreater, 40)})};
  ValidPositionQuery query = query_of(one);
  query.budget = 500;

  const auto found = valid_position(query, observer_of(one.places), MissionTime());

  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().kind, NoPosition::kNoneFound);
  EXPECT_EQ(found.error().why, "no position in free air where all constraints hold, of 500 tried");
}

TEST(ValidPosition, IsNoneWhereAPlaceIsUnknownOrTooOld) {
  Case one = any_case(3);
  one.places.erase("partner");

  const auto unknown = valid_position(query_of(one), observer_of(one.places), MissionTime());
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().kind, NoPosition::kUnknownPlace);

  const Case known = any_case(3);
  const auto old =
      valid_position(query_of(known), observer_of(known.places), MissionTime::seconds(6));
  ASSERT_FALSE(old);
  EXPECT_EQ(old.error().kind, NoPosition::kUnknownPlace);
}

TEST(FreeAir, EndsAtTheGroundTheCeilingTheVolumesAndTheBorder) {
  Case one;
  one.world = level(100, 10);
  one.world.volumes = {{"zone",
                        {{40, 40}, {60, 40}, {60, 60}, {40, 60}},
                        20,
                        40,
                        {MissionTime(), MissionTime::seconds(100)}}};
  one.vehicle.ceiling = 70;

  const FreeAir air = free_air_of(one.world, one.vehicle, 5, MissionTime());
  EXPECT_TRUE(air.holds({50, 50, 10}));
  EXPECT_FALSE(air.holds({50, 50, 4})) << "too low";
  EXPECT_FALSE(air.holds({10, 10, 71})) << "above the ceiling";
  EXPECT_FALSE(air.holds({50, 50, 30})) << "in the zone";
  EXPECT_FALSE(air.holds({39, 50, 30})) << "where no way leads, so near the zone";
  EXPECT_FALSE(air.holds({50, 50, 19})) << "below it";
  EXPECT_TRUE(air.holds({50 - 10 - one.vehicle.body_radius - 1.1, 50, 30}));
  EXPECT_FALSE(air.holds({101, 50, 30})) << "off the map";
  EXPECT_TRUE(
      free_air_of(one.world, one.vehicle, 5, MissionTime::seconds(100)).holds({50, 50, 30}));
  EXPECT_EQ(air.high, (Position{100, 100, 100}));
}

}  // namespace
}  // namespace skein::interaction
