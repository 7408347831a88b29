// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/area_gates.hpp"

#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

using testing::fixed_wing;
using testing::helicopter;
using testing::level_world;

CoverageQuery field(const world::VehicleModel& vehicle) {
  CoverageQuery query;
  query.vehicle = vehicle;
  query.area = {{-200, -150}, {200, -150}, {200, 150}, {-200, 150}};
  query.swath = 60;
  query.altitude = 50;
  return query;
}

TEST(AreaGates, AFieldMayBeEnteredNearEachOfItsCorners) {
  const world::World world = level_world();
  const CoverageQuery query = field(helicopter());

  const auto gates = gates_of(query, {.world = world, .budget = {}});

  ASSERT_TRUE(gates) << gates.error().why;
  EXPECT_EQ(gates->size(), 4U);
  for (const world::Vector2& corner : query.area) {
    double nearest = 1e9;
    for (const Gate& gate : *gates)
      nearest = std::min(nearest, (gate.entry.head<2>() - corner).norm());
    EXPECT_LT(nearest, 60);
  }
}

TEST(AreaGates, TheTimeInsideIsThatOfTheSweepFromThere) {
  const world::World world = level_world();
  CoverageQuery query = field(helicopter());
  const Setting setting{.world = world, .budget = {}};

  const auto gates = gates_of(query, setting);

  ASSERT_TRUE(gates) << gates.error().why;
  for (const Gate& gate : *gates) {
    query.start = gate.entry;
    const auto sweep = refine(query, setting);
    ASSERT_TRUE(sweep);
    EXPECT_NEAR(gate.inside.to_seconds(), sweep->cost, 0.05 * sweep->cost);
    EXPECT_LT((gate.exit - sweep->task.way.back()).norm(), 1);
  }
}

TEST(AreaGates, AreaOfManyCornersHasNoMoreThanEightEntries) {
  const world::World world = level_world();
  CoverageQuery query = field(fixed_wing());
  query.area.clear();
  for (int i = 0; i < 30; ++i)
    query.area.emplace_back(300 * std::cos(i * 0.2094), 300 * std::sin(i * 0.2094));

  const auto gates = gates_of(query, {.world = world, .budget = {}});

  ASSERT_TRUE(gates) << gates.error().why;
  EXPECT_LE(gates->size(), kMostEntries);
  EXPECT_GE(gates->size(), 2U);
}

TEST(AreaGates, AnAreaThatCannotBeSweptHasTheReasonOfItsSweep) {
  const world::World world = level_world();
  CoverageQuery query = field(helicopter());
  query.swath = -1;

  const auto gates = gates_of(query, {.world = world, .budget = {}});

  ASSERT_FALSE(gates);
  EXPECT_EQ(gates.error().field, "swath");
}

}  // namespace
}  // namespace skein::refiners
