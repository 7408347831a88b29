// SPDX-License-Identifier: Apache-2.0
// relay against exhaustive searches written from the definitions.
#include "skein/refiners/relay.hpp"

#include <gtest/gtest.h>

#include "test_cases.hpp"
#include "testing/relay_cases.hpp"

namespace skein::refiners {
namespace {

using testing::RelayCase;
using world::Vector3;

int cases(int few, int all) { return skein::testing::cases(few, all); }

/// A ridge along the north between two ends, 600 m apart, that hear 500 m far.
RelayCase ridge() {
  RelayCase result{testing::level_world(500, 300), {}};
  world::TerrainSpec spec = result.world.terrain.spec();
  for (double north = -500; north <= 500; north += 50) spec.hills.push_back({{0, north}, 30, 150});
  result.world.terrain = world::Terrain(spec);
  result.world.radio.range = 500;
  result.query.vehicle = testing::helicopter();
  result.query.a = {-300, 0, 2};
  result.query.b = {300, 0, 2};
  return result;
}

Outcome<Relay> ask(const RelayCase& given, Budget budget = {}) {
  return refine(given.query, {given.world, std::move(budget)});
}

double weakest(const RelayCase& given, const std::vector<Vector3>& positions) {
  double least = std::numeric_limits<double>::infinity();
  Vector3 last = given.query.a;
  const auto hop = [&](const Vector3& next) {
    least = std::min(least, given.world.radio.margin(last, next, given.world.terrain));
    last = next;
  };
  for (const Vector3& position : positions) hop(position);
  hop(given.query.b);
  return least;
}

TEST(Relay, StandsWhereBothHearItBest) {
  const RelayCase given = ridge();

  const auto outcome = ask(given);

  ASSERT_TRUE(outcome) << outcome.error().why;
  ASSERT_EQ(outcome->task.positions.size(), 1U);
  EXPECT_EQ(outcome->cost, 1);
  EXPECT_LT(std::abs(outcome->task.positions[0].x()), 100);
  EXPECT_NEAR(outcome->task.margin, weakest(given, outcome->task.positions), 1e-12);
  EXPECT_EQ(outcome->task.margin, testing::best_of_all(given).margin);
}

TEST(Relay, IsNotNeededByTwoThatHearEachOther) {
  RelayCase given = ridge();
  given.query.b = {-200, 100, 5};

  const auto outcome = ask(given);

  ASSERT_TRUE(outcome);
  EXPECT_TRUE(outcome->task.positions.empty());
  EXPECT_EQ(outcome->cost, 0);
  EXPECT_EQ(outcome->effort.steps, 1U);
}

TEST(Relay, AVolumeKeepsRelaysOutOnlyWhileItHolds) {
  RelayCase given = ridge();
  const auto before = ask(given);
  given.world.volumes.push_back({"zone",
                                 {{-400, -400}, {400, -400}, {400, 400}, {-400, 400}},
                                 0,
                                 1000,
                                 {MissionTime(), MissionTime::seconds(100)}});

  const auto while_it_holds = ask(given);
  given.query.at = MissionTime::seconds(100);
  const auto afterwards = ask(given);

  ASSERT_TRUE(before && afterwards);
  EXPECT_FALSE(while_it_holds);
  EXPECT_EQ(afterwards->task.positions, before->task.positions);
}

TEST(Relay, StaysUnderTheCeilingAndOverTheClearance) {
  RelayCase given = ridge();
  given.query.vehicle.ceiling = 90;
  given.query.clearance = 50;

  const auto outcome = ask(given);

  ASSERT_TRUE(outcome) << outcome.error().why;
  const Vector3& at = outcome->task.positions[0];
  const double height = at.z() - given.world.terrain.elevation(at.x(), at.y());
  EXPECT_LE(height, 90);
  EXPECT_GE(height, 50);
}

TEST(Relay, KeepsTheMarginAskedFor) {
  RelayCase given = ridge();
  given.world.radio.range = 1000;
  const double best = ask(given)->task.margin;

  given.query.least_margin = best - 0.01;
  EXPECT_TRUE(ask(given));
  given.query.least_margin = best + 0.01;
  EXPECT_FALSE(ask(given));
}

TEST(Relay, SaysHowMuchTooFarApartTheyAre) {
  RelayCase given = ridge();
  given.world.radio.range = 200;

  const auto outcome = ask(given);

  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, RefusalKind::kNoContact);
  EXPECT_EQ(outcome.error().field, "most");
  EXPECT_NE(outcome.error().why.find("200 m too little"), std::string::npos) << outcome.error().why;
}

TEST(Relay, SaysThatTheGroundHides) {
  RelayCase given = ridge();
  given.query.vehicle.ceiling = 25;

  const auto outcome = ask(given);

  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, RefusalKind::kNoContact);
  EXPECT_NE(outcome.error().why.find("ground"), std::string::npos) << outcome.error().why;
}

TEST(Relay, AChainSpansWhatOneDoesNot) {
  RelayCase given = ridge();
  given.world.radio.range = 250;
  given.query.most = 4;

  const auto outcome = ask(given);

  ASSERT_TRUE(outcome) << outcome.error().why;
  EXPECT_EQ(outcome->task.positions.size(), 2U);
  EXPECT_GE(outcome->task.margin, 0);
  EXPECT_NEAR(outcome->task.margin, weakest(given, outcome->task.positions), 1e-12);
}

TEST(Relay, OneIsAsGoodAsTheBestOfAllVoxels) {
  Random random(11);
  int found = 0, none = 0;
  std::uint64_t links = 0, exhaustive = 0;
  for (int i = 0; i < cases(150, 1000); ++i) {
    const RelayCase given = testing::random_relay_case(
        random, 12 + static_cast<std::int32_t>(random.below(5)), 12, random.uniform(0.3, 1));
    if (given.world.radio.margin(given.query.a, given.query.b, given.world.terrain) >=
        given.query.least_margin)
      continue;

    const auto outcome = ask(given);
    const testing::Exhaustive best = testing::best_of_all(given);

    ASSERT_EQ(outcome.has_value(), best.margin >= 0) << "case " << i;
    (outcome ? found : none) += 1;
    links += outcome ? outcome->effort.steps : 0;
    exhaustive += outcome ? best.links : 0;
    if (!outcome) continue;
    ASSERT_NEAR(outcome->task.margin, best.margin, 1e-9) << "case " << i;
    ASSERT_NEAR(outcome->task.margin, weakest(given, outcome->task.positions), 1e-9);
  }
  EXPECT_GT(found, 20);
  EXPECT_GT(none, 5);
  EXPECT_LT(links * 10, exhaustive);
}

TEST(Relay, ChainsHaveTheHopsAndTheMarginOfBellmanFord) {
  Random random(12);
  std::size_t chains = 0, none = 0;
  for (int i = 0; i < cases(12, 100); ++i) {
    RelayCase given = testing::random_relay_case(random, 12, 12, random.uniform(0.15, 0.4));
    given.query.most = 5;
    if (given.world.radio.margin(given.query.a, given.query.b, given.world.terrain) >=
        given.query.least_margin)
      continue;

    const auto outcome = ask(given);
    const auto best = testing::bellman_ford(given, 5);

    ASSERT_EQ(outcome.has_value(), best.has_value()) << "case " << i;
    none += outcome ? 0U : 1U;
    if (!outcome) continue;
    ASSERT_EQ(outcome->task.positions.size(), best->relays) << "case " << i;
    ASSERT_NEAR(outcome->task.margin, best->margin, 1e-9) << "case " << i;
    ASSERT_NEAR(outcome->task.margin, weakest(given, outcome->task.positions), 1e-9);
    chains += best->relays > 1 ? 1U : 0U;
  }
  EXPECT_GT(chains, 2U);
}

TEST(Relay, AChainInALargeAirspaceSaysHowCoarselyItWasLookedFor) {
  Random random(13);
  RelayCase given = testing::random_relay_case(random, 60, 20, 0.3);
  given.query.a = {30, 30, given.world.terrain.elevation(30, 30) + 2};
  given.query.b = {1170, 1170, given.world.terrain.elevation(1170, 1170) + 2};
  given.query.least_margin = 0;
  given.query.vehicle.ceiling = 1e4;
  given.query.most = 8;

  const auto outcome = ask(given);

  ASSERT_TRUE(outcome) << outcome.error().why;
  EXPECT_GT(outcome->task.positions.size(), 2U);
  EXPECT_GT(outcome->task.spacing, 20);
  EXPECT_NEAR(outcome->task.margin, weakest(given, outcome->task.positions), 1e-9);
  EXPECT_GE(outcome->task.margin, 0);
}

TEST(Relay, StopsAtItsBudget) {
  RelayCase hidden = ridge();
  hidden.query.vehicle.ceiling = 25;
  Budget few;
  few.steps = 2;
  Budget none;
  none.time_is_up = [] { return true; };

  const auto by_steps = ask(ridge(), few), by_time = ask(hidden, none);

  ASSERT_FALSE(by_steps || by_time);
  EXPECT_EQ(by_steps.error().kind, RefusalKind::kBudgetExhausted);
  EXPECT_EQ(by_time.error().kind, RefusalKind::kBudgetExhausted);
}

TEST(Relay, EachFaultOfAQueryIsNamed) {
  const auto fault = [](auto change) {
    RelayCase given = ridge();
    change(given);
    const auto outcome = ask(given);
    return outcome ? "" : std::string(to_text(outcome.error().kind)) + " " + outcome.error().field;
  };
  const double nan = std::nan("");

  EXPECT_EQ(fault([&](RelayCase& c) { c.query.a.x() = nan; }), "bad-query a");
  EXPECT_EQ(fault([](RelayCase& c) { c.query.b.z() = -5; }), "blocked b");
  EXPECT_EQ(fault([](RelayCase& c) { c.query.most = 0; }), "bad-query most");
  EXPECT_EQ(fault([](RelayCase& c) { c.query.least_margin = -1; }), "bad-query least_margin");
  EXPECT_EQ(fault([&](RelayCase& c) { c.query.clearance = nan; }), "bad-query clearance");
  EXPECT_EQ(fault([](RelayCase& c) { c.world.radio.range = 0; }), "bad-query world.radio");
  EXPECT_EQ(fault([](RelayCase& c) { c.world.airspace.voxel = 0; }), "bad-query world.airspace");
  EXPECT_EQ(fault([](RelayCase& c) { c.query.vehicle.cruise_speed = 0; }),
            "bad-query vehicle.speed.cruise");
}

}  // namespace
}  // namespace skein::refiners
