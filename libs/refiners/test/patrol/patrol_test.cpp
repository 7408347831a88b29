// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/patrol.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "skein/refiners/flyable.hpp"
#include "test_cases.hpp"
#include "testing/builders.hpp"
#include "testing/patrol_oracle.hpp"

namespace skein::refiners {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): builders read as words
using world::Polygon;
using world::Vector2;

constexpr double kCell = 10;

Polygon square(double side) { return {{0, 0}, {side, 0}, {side, side}, {0, side}}; }

world::World a_world(std::size_t side, int peaks = 0, std::uint64_t seed = 1) {
  world::World world = level_world(2000, 200);
  world.ground = peaked_ground(side, kCell, peaks, seed);
  return world;
}

world::Volume a_volume(Polygon polygon) {
  world::Volume volume;
  volume.name = "closed";
  volume.polygon = std::move(polygon);
  return volume;
}

PatrolQuery a_query(double extent, double seconds) {
  PatrolQuery query;
  query.vehicle = helicopter();
  query.vehicle.energy.capacity = 1e12;
  query.zone = square(extent);
  query.start = {5, 5, 50};
  query.altitude = 50;
  query.footprint = 20;
  query.duration = Duration::seconds(seconds);
  return query;
}

Outcome<Patrol> ask(const PatrolQuery& query, const world::World& world) {
  return refine(query, Setting{.world = world, .budget = {}});
}

NaiveFigures simulate(const PatrolQuery& query, const world::World& world, const Way& way) {
  const NaiveFlight flight{.speed = 10,
                           .footprint = query.footprint,
                           .from = query.duration.to_seconds() / 2,
                           .step = 0.25,
                           .least_risk = query.least_risk};
  return NaivePatrol(world.ground, cells_in(world.ground.grid, query.zone), flight).fly(way);
}

void expect_refused(const PatrolQuery& query, const world::World& world, RefusalKind kind,
                    const std::string& field) {
  const auto refined = ask(query, world);

  ASSERT_FALSE(refined.has_value()) << field;
  EXPECT_EQ(refined.error().kind, kind) << refined.error().why;
  EXPECT_EQ(refined.error().field, field);
}

/// What patrols are compared with must itself see everything: figures against a round that never
/// sees some cells say nothing.
TEST(LawnMower, SeesEveryCellOncePerRoundWhateverPartOfACellItsLanesAreApart) {
  for (const std::size_t side : {34UL, 40UL})
    for (const double footprint : {1.0, 1.5, 2.0, 2.3, 3.0, 3.3, 5.0}) {
      world::World world = level_world(2000, 200);
      world.ground = peaked_ground(side, 1, 0, 1);
      const auto extent = static_cast<double>(side);
      const double round = extent * (std::ceil(extent / (2 * footprint)) + 2);
      const NaiveFlight flight{.speed = 1, .footprint = footprint, .from = round, .step = 0.5};

      const auto figures =
          NaivePatrol(world.ground, cells_in(world.ground.grid, square(extent)), flight)
              .fly(lawn_mower(extent, extent, footprint, 1, 2.2 * round));

      EXPECT_EQ(figures.unseen, 0U) << side << " cells, footprint " << footprint;
      EXPECT_LT(figures.worst, 1.1 * round) << side << " cells, footprint " << footprint;
    }
}

TEST(Potential, IsOneForWhatIsFreshAndFallsWithRiskAndIdleness) {
  EXPECT_EQ(potential(0.7, 0, 600), 1);
  EXPECT_LT(potential(0.7, 100, 600), potential(0.7, 50, 600));
  EXPECT_LT(potential(0.8, 50, 600), potential(0.7, 50, 600));
  EXPECT_DOUBLE_EQ(potential(0.5, 600, 300), std::exp(-1.0));
}

TEST(UpdatedIdleness, IsResetUnderTheVehicleAndPartlyAtTheEdge) {
  EXPECT_EQ(updated_idleness(500, 1, 0, 20), 0);
  EXPECT_NEAR(updated_idleness(500, 1, 20, 20), (1 - std::exp(-1.0)) * 501, 1e-9);
  EXPECT_NEAR(updated_idleness(500, 1, 200, 20), 501, 1e-9);
}

TEST(UpdatedIdleness, GrowsWithDistanceAndWithWhatItWas) {
  for (double distance = 1; distance < 60; distance += 1) {
    EXPECT_LT(updated_idleness(500, 1, distance - 1, 20), updated_idleness(500, 1, distance, 20));
    EXPECT_LE(updated_idleness(400, 1, distance, 20), updated_idleness(500, 1, distance, 20));
  }
}

TEST(Patrol, FiguresAgreeWithANaiveSimulationOfTheWay) {
  const world::World world = a_world(24, 2);
  const PatrolQuery query = a_query(240, 3000);

  const auto refined = ask(query, world);

  ASSERT_TRUE(refined.has_value()) << refined.error().why;
  const PatrolFigures& predicted = refined->task.predicted;
  const NaiveFigures naive = simulate(query, world, refined->task.way);
  EXPECT_NEAR(predicted.worst_idleness, naive.worst, 1 + 0.01 * naive.worst);
  EXPECT_NEAR(predicted.worst_risk_idleness, naive.worst_risk, 1 + 0.01 * naive.worst_risk);
  EXPECT_NEAR(predicted.mean_idleness, naive.mean, 0.5 + 0.01 * naive.mean);
  EXPECT_EQ(predicted.unseen, naive.unseen);
  EXPECT_EQ(predicted.cells, 24U * 24U);
}

TEST(Patrol, LeavesNoPerceivableCellUnseen) {
  const auto seeds = skein::testing::cases<std::uint64_t>(3, 8);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const world::World world = a_world(30, static_cast<int>(seed % 5), seed);
    PatrolQuery query = a_query(300, 4000);
    query.footprint = 12 + 3 * static_cast<double>(seed);

    const auto refined = ask(query, world);

    ASSERT_TRUE(refined.has_value()) << refined.error().why;
    EXPECT_EQ(refined->task.predicted.unseen, 0U) << "seed " << seed;
    EXPECT_EQ(simulate(query, world, refined->task.way).unseen, 0U) << "seed " << seed;
  }
}

TEST(Patrol, OfEvenRiskIsNearTheLowerBoundOfTheWorstIdleness) {
  const world::World world = a_world(64);

  const auto refined = ask(a_query(640, 12000), world);

  ASSERT_TRUE(refined.has_value());
  const PatrolFigures& figures = refined->task.predicted;
  const double without_grain = 64 * 64 * 100 / (2.0 * 20 * 10);
  EXPECT_LE(figures.worst_idleness, 1.5 * without_grain);
  EXPECT_LE(figures.worst_idleness_bound, without_grain);
  EXPECT_GE(figures.worst_idleness_bound, 0.75 * without_grain);
}

// A step is a visit of a piece of a lane, or 64 changes tried: one search takes tens of thousands.
TEST(Patrol, OfEvenRiskIsPlannedWithoutASearch) {
  const world::World world = a_world(64);

  const auto refined = ask(a_query(640, 12000), world);

  ASSERT_TRUE(refined.has_value());
  EXPECT_LT(refined->effort.steps, 5000U);
}

TEST(Patrol, OfAnyLengthAndFootprintHasNoFigureBelowItsBound) {
  Random random(5, "lengths");
  const std::uint64_t patrols = skein::testing::long_tests() ? 200 : 10;
  for (std::uint64_t seed = 1; seed <= patrols; ++seed) {
    const double side = 10 + static_cast<double>(random.below(20));
    const world::World world =
        a_world(static_cast<std::size_t>(side), static_cast<int>(seed % 4), seed);
    PatrolQuery query = a_query(side * kCell, std::exp(random.uniform(3, 8)));
    query.footprint = kCell * random.uniform(0.6, 4);

    const auto refined = ask(query, world);

    ASSERT_TRUE(refined.has_value()) << refined.error().why;
    const NaiveFigures flown = simulate(query, world, refined->task.way);
    const PatrolFigures& figures = refined->task.predicted;
    const auto about = [&](const char* what) {
      return std::string(what) + ", seed " + std::to_string(seed) + ", " +
             std::to_string(query.duration.to_seconds()) + " s, footprint " +
             std::to_string(query.footprint);
    };
    EXPECT_GE(figures.worst_idleness + 1e-6, figures.worst_idleness_bound) << about("worst");
    EXPECT_GE(figures.worst_risk_idleness + 1e-6, figures.worst_risk_idleness_bound)
        << about("worst by risk");
    EXPECT_GE(figures.mean_idleness + 1e-6, figures.mean_idleness_bound) << about("mean");
    EXPECT_GE(1.02 * flown.mean + 1, figures.mean_idleness_bound) << about("mean, naively");
  }
}

TEST(Patrol, OfPeakedRiskIsWellBelowTheLawnMower) {
  const world::World world = a_world(48, 3, 2);
  const PatrolQuery query = a_query(480, 15000);

  const auto refined = ask(query, world);

  ASSERT_TRUE(refined.has_value());
  const NaiveFigures ours = simulate(query, world, refined->task.way);
  const NaiveFigures mower =
      simulate(query, world, lawn_mower(480, 480, query.footprint, kCell, 150000));
  EXPECT_LE(ours.worst_risk, 0.6 * mower.worst_risk);
  EXPECT_LE(ours.mean, 0.92 * mower.mean);
}

/// Maps as of real fires: a few round peaks are kinder. Footprints of few cells see the least, wide
/// ones leave little to choose.
TEST(Patrol, OfScatteredRiskIsBetterThanTheLawnMowerWithAnyFootprint) {
  constexpr std::size_t kSide = 42;
  constexpr double kExtent = kSide * kCell;
  struct Row {
    double footprint, mean, worst;
  };
  for (const Row& row : {Row{1, 0.94, 0.62}, Row{2, 0.94, 0.6}, Row{3, 0.92, 0.6}}) {
    if (row.footprint > 1 && !skein::testing::long_tests()) continue;
    world::World world = a_world(kSide);
    world.ground = scattered_ground(kSide, kCell, 1);
    PatrolQuery query = a_query(kExtent, 8000 / row.footprint);
    query.footprint = row.footprint * kCell;

    const auto refined = ask(query, world);

    ASSERT_TRUE(refined.has_value());
    const NaiveFigures ours = simulate(query, world, refined->task.way);
    const NaiveFigures mower = simulate(
        query, world, lawn_mower(kExtent, kExtent, query.footprint, kCell, 80000 / row.footprint));
    EXPECT_LE(ours.mean, row.mean * mower.mean) << "footprint " << row.footprint;
    EXPECT_LE(ours.worst_risk, row.worst * mower.worst_risk) << "footprint " << row.footprint;
    EXPECT_EQ(ours.unseen, 0U);
  }
}

TEST(Patrol, ByGradientLeavesCellsUnseen) {
  const world::World world = a_world(64, 1);
  PatrolQuery query = a_query(640, 4000);
  query.mode = PatrolMode::kGradient;

  const auto refined = ask(query, world);

  ASSERT_TRUE(refined.has_value()) << refined.error().why;
  EXPECT_GT(refined->task.predicted.worst_idleness,
            2.4 * refined->task.predicted.worst_idleness_bound);
}

TEST(Patrol, LastsAsLongAsAskedAndStaysInTheZone) {
  const world::World world = a_world(30, 2);
  const PatrolQuery query = a_query(300, 1500);

  const auto refined = ask(query, world);

  ASSERT_TRUE(refined.has_value());
  EXPECT_NEAR(refined->duration.expected.to_seconds(), 1500, 1e-3);
  EXPECT_NEAR(length_of(refined->task.way), 15000, 1e-3);
  for (const world::Vector3& point : refined->task.way) {
    EXPECT_TRUE(world::contains(query.zone, point.head<2>()));
    EXPECT_NEAR(point.z(), 50, 1e-9);
  }
}

TEST(Patrol, IsTheSameEachTime) {
  const world::World world = a_world(30, 2);
  const PatrolQuery query = a_query(300, 1500);

  EXPECT_EQ(ask(query, world)->task.way, ask(query, world)->task.way);
}

TEST(Patrol, NeverEntersAClosedVolumeAndWhatItHidesAttractsNobody) {
  world::World world = a_world(40, 2);
  world.volumes.push_back(a_volume({{120, 120}, {280, 120}, {280, 280}, {120, 280}}));
  const PatrolQuery query = a_query(400, 3000);

  const auto refined = ask(query, world);

  ASSERT_TRUE(refined.has_value()) << refined.error().why;
  EXPECT_GT(refined->task.predicted.hidden, 100U);
  EXPECT_EQ(refined->task.predicted.cells + refined->task.predicted.hidden, 1600U);
  EXPECT_EQ(refined->task.predicted.unseen, 0U);
  const Way& way = refined->task.way;
  for (std::size_t i = 1; i < way.size(); ++i)
    for (double t = 0; t <= 1; t += 0.05)
      EXPECT_FALSE(world::contains(world.volumes[0].polygon,
                                   (way[i - 1] + t * (way[i] - way[i - 1])).head<2>()));
  const auto middle = world.ground.grid.at({200, 200});
  EXPECT_TRUE(std::isnan(refined->task.potential[*middle]));
}

TEST(Patrol, FliesUnderAVolumeThatIsHigherAndPastOneThatIsLater) {
  world::World world = a_world(20);
  world.volumes = {a_volume(square(100)), a_volume(square(100))};
  world.volumes[0].floor = 300;
  world.volumes[1].when.from = MissionTime{} + Duration::seconds(9e5);

  const auto refined = ask(a_query(200, 1000), world);

  ASSERT_TRUE(refined.has_value()) << refined.error().why;
  EXPECT_EQ(refined->task.predicted.hidden, 0U);
}

TEST(Patrol, OfAConcaveZoneStaysInIt) {
  const world::World world = a_world(40, 2);
  PatrolQuery query = a_query(400, 3000);
  query.zone = {{0, 0},     {400, 0},   {400, 130}, {150, 140},
                {130, 280}, {400, 300}, {390, 400}, {0, 400}};

  const auto refined = ask(query, world);

  ASSERT_TRUE(refined.has_value()) << refined.error().why;
  EXPECT_EQ(refined->task.predicted.unseen, 0U);
  EXPECT_EQ(refined->task.predicted.hidden, 0U);
  EXPECT_EQ(simulate(query, world, refined->task.way).unseen, 0U);
  const Way& way = refined->task.way;
  for (std::size_t i = 1; i < way.size(); ++i)
    for (double t = 0; t <= 1; t += 0.1)
      EXPECT_TRUE(world::contains(query.zone, (way[i - 1] + t * (way[i] - way[i - 1])).head<2>()));
}

TEST(Patrol, OfAVehicleThatCannotHoverIsFlyable) {
  const world::World world = a_world(60, 2);
  PatrolQuery query = a_query(600, 3000);
  query.vehicle = fixed_wing();
  query.vehicle.energy.capacity = 1e12;
  query.speed = 10;

  const auto refined = ask(query, world);

  ASSERT_TRUE(refined.has_value()) << refined.error().why;
  EXPECT_TRUE(is_flyable(refined->task.way, query.vehicle, query.speed, 0.5));
  EXPECT_EQ(refined->task.predicted.unseen, 0U);
  for (const world::Vector3& point : refined->task.way) {
    EXPECT_GE(point.x(), -120);
    EXPECT_LE(point.x(), 720);
  }
}

TEST(Patrol, FollowsTheGround) {
  world::World world = a_world(30, 1);
  world::TerrainSpec spec = world.terrain.spec();
  spec.hills = {{.at = {150, 150}, .height = 60, .radius = 200}};
  world.terrain = world::Terrain(spec);
  PatrolQuery query = a_query(300, 2000);
  query.start.z() = 200;

  const auto refined = ask(query, world);

  ASSERT_TRUE(refined.has_value()) << refined.error().why;
  for (std::size_t i = 1; i < refined->task.way.size(); ++i) {
    const world::Vector3& at = refined->task.way[i];
    EXPECT_GE(at.z(), world.terrain.elevation(at.x(), at.y()) + 0.89 * query.altitude);
  }
  EXPECT_NEAR(refined->duration.expected.to_seconds(), 2000, 25);
}

TEST(Patrol, CutShortByTheClockGivesWhatIsPlannedOrSaysThatNothingIs) {
  const world::World world = a_world(40, 2);
  const PatrolQuery query = a_query(400, 3000);
  int parts = 0, wholes = 0;
  for (int most = 0; most < 400; most += 1 + most / 10) {
    int asked = 0;
    const Setting setting{.world = world, .budget = {.time_is_up = [&] { return ++asked > most; }}};

    const auto refined = refine(query, setting);

    if (!refined) {
      EXPECT_EQ(refined.error().kind, RefusalKind::kBudgetExhausted);
      EXPECT_EQ(parts + wholes, 0) << "with more time there is no less";
      continue;
    }
    EXPECT_TRUE(refined->effort.cut_short || asked <= most);
    const double seconds = refined->duration.expected.to_seconds();
    ++(seconds < 2900 ? parts : wholes);
    EXPECT_EQ(seconds < 2900 && wholes > 0, false);
  }
  EXPECT_GT(parts, 0);
  EXPECT_GT(wholes, 0);
}

TEST(Patrol, WithTimeEnoughIsThatWithoutAClock) {
  const world::World world = a_world(40, 2);
  const PatrolQuery query = a_query(400, 3000);

  const auto timed =
      refine(query, Setting{.world = world, .budget = {.time_is_up = [] { return false; }}});
  const auto free = refine(query, Setting{.world = world, .budget = {}});

  ASSERT_TRUE(timed && free);
  EXPECT_EQ(timed->task.way, free->task.way);
  EXPECT_EQ(timed->task.potential.size(), free->task.potential.size());
}

TEST(Patrol, KeepsToItsSteps) {
  const world::World world = a_world(40, 2);

  const auto refined = refine(a_query(400, 3000),
                              Setting{.world = world, .budget = {.time_is_up = {}, .steps = 500}});

  ASSERT_TRUE(refined.has_value()) << refined.error().why;
  EXPECT_LE(refined->effort.steps, 501U);
  EXPECT_FALSE(refined->effort.cut_short);
}

TEST(Patrol, ComesFromOutsideTheZone) {
  const world::World world = a_world(20);
  PatrolQuery query = a_query(200, 1000);
  query.start = {-300, 80, 10};

  const auto refined = ask(query, world);

  ASSERT_TRUE(refined.has_value()) << refined.error().why;
  EXPECT_EQ(refined->task.way.front(), query.start);
  EXPECT_NEAR(refined->duration.expected.to_seconds(), 1000, 1e-3);
}

TEST(Patrol, BeyondTheEnergyIsRefusedWithTheFigures) {
  const world::World world = a_world(20);
  PatrolQuery query = a_query(200, 10000);
  query.vehicle.energy.capacity = 5e6;

  expect_refused(query, world, RefusalKind::kBeyondVehicle, "duration");
}

TEST(Patrol, RefusesFiguresThatMakeNoSense) {
  const world::World world = a_world(20);
  const PatrolQuery good = a_query(200, 1000);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](auto change, const std::string& field) {
    PatrolQuery query = good;
    change(query);
    expect_refused(query, world, RefusalKind::kBadQuery, field);
  };

  refused([](PatrolQuery& q) { q.duration = Duration::seconds(0); }, "duration");
  refused([](PatrolQuery& q) { q.duration = Duration::seconds(1e9); }, "duration");
  refused([](PatrolQuery& q) { q.footprint = 0; }, "footprint");
  refused([](PatrolQuery& q) { q.footprint = 4; }, "footprint");
  refused([&](PatrolQuery& q) { q.footprint = nan; }, "footprint");
  refused([](PatrolQuery& q) { q.altitude = -1; }, "altitude");
  refused([](PatrolQuery& q) { q.least_risk = 0; }, "least_risk");
  refused([](PatrolQuery& q) { q.speed = -1; }, "speed");
  refused([&](PatrolQuery& q) { q.start.x() = nan; }, "start");
  refused([&](PatrolQuery& q) { q.heading = nan; }, "heading");
  refused([](PatrolQuery& q) { q.zone = {{0, 0}, {9, 9}, {9, 0}, {0, 9}}; }, "zone");
  refused([](PatrolQuery& q) { q.zone = {{1, 1}, {2, 1}, {2, 2}}; }, "zone");
}

TEST(Patrol, RefusesWhatTheVehicleCannot) {
  const world::World world = a_world(20);
  PatrolQuery fast = a_query(200, 1000), high = fast, turning = fast;
  fast.speed = 16;
  high.altitude = 501;
  turning.vehicle = fixed_wing();
  turning.mode = PatrolMode::kGradient;

  expect_refused(fast, world, RefusalKind::kBeyondVehicle, "speed");
  expect_refused(high, world, RefusalKind::kBeyondVehicle, "altitude");
  expect_refused(turning, world, RefusalKind::kBeyondVehicle, "mode");
}

TEST(Patrol, RefusesAGroundThatIsNotThereOrWrong) {
  world::World none = a_world(20), wrong = none, large = none;
  none.ground = {};
  wrong.ground.risk[7] = std::numeric_limits<double>::quiet_NaN();
  large.ground.risk.clear();
  large.ground.grid.columns = large.ground.grid.rows = 2001;

  expect_refused(a_query(200, 1000), none, RefusalKind::kBadQuery, "world.ground");
  expect_refused(a_query(200, 1000), wrong, RefusalKind::kBadQuery, "world.ground.risk");
  expect_refused(a_query(200, 1000), large, RefusalKind::kBadQuery, "world.ground");
}

TEST(Patrol, RefusesAZoneThatIsClosedAltogetherAndAStartThatIs) {
  world::World closed = a_world(20), start = closed;
  closed.volumes.push_back(a_volume({{-50, -50}, {300, -50}, {300, 300}, {-50, 300}}));
  start.volumes.push_back(a_volume({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}));
  PatrolQuery outside = a_query(200, 1000);
  outside.start = {-100, 0, 50};

  expect_refused(outside, closed, RefusalKind::kNotPerceivable, "zone");
  expect_refused(a_query(200, 1000), start, RefusalKind::kBlocked, "start");
}

}  // namespace
}  // namespace skein::refiners
