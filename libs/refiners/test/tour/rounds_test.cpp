// SPDX-License-Identifier: Apache-2.0
// Ways of tours are looked for as they are needed: no worse, far fewer, and while there is time.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>

#include "test_cases.hpp"
#include "tour/travel.hpp"
#include "tour/worlds.hpp"

namespace skein::refiners {
namespace {

using testing::helicopter;
using testing::level_world;
using world::Vector3;
using world::World;

constexpr double kNever = std::numeric_limits<double>::infinity();

world::Volume block(double west, double south, double east, double north) {
  world::Volume volume;
  volume.name = "block";
  volume.polygon = {{west, south}, {east, south}, {east, north}, {west, north}};
  return volume;
}

/// Walls from the ground to the top of the air, each with the same gap at another end.
World labyrinth() {
  World world = level_world(1000, 80);
  for (int i = 0; i < 9; ++i) {
    const double x = -810 + 200 * i, south = i % 2 == 0 ? -1000 : -800;
    world.volumes.push_back(block(x, south, x + 10, south + 1800));
  }
  return world;
}

/// Closed for straight lines, mostly: blocks in rows, and a wind.
World town() {
  World world = level_world();
  for (int x = -900; x < 1000; x += 150)
    for (int y = -900; y < 1000; y += 150)
      if ((x + 2 * y) % 100 == 0) world.volumes.push_back(block(x, y, x + 100, y + 100));
  world.wind = {.toward = 1, .speed = 4, .gusts = 1};
  return world;
}

PathQuery leg_of(const TourQuery& query) { return test::first_leg(query); }

TourQuery random_tour(const World& world, std::size_t stops, std::uint64_t seed,
                      const world::VehicleModel& vehicle) {
  TourQuery query;
  query.vehicle = vehicle;
  query.vehicle.energy.capacity = 1e9;
  query.vehicle.wind_drift = 1;
  query.start = {-960, -960, 50};
  PathQuery leg;
  leg.vehicle = query.vehicle;
  leg.from = leg.to = query.start;
  const auto airspace = airspace_of(leg, {world, {}});
  Random random(seed);
  while (query.stops.size() < stops) {
    const Vector3 place(random.uniform(-950, 950), random.uniform(-950, 950), 50);
    if (airspace->is_free(place)) query.stops.push_back({"", {{place, place, {}}}});
  }
  return query;
}

/// A way by a place beside that depends on the ends alone; between some there is none. Counts, and
/// may tell when it is asked.
class BentPlanner final : public PathPlanner {
 public:
  static std::optional<Way> bent(const Vector3& a, const Vector3& b) {
    const Vector3 sum = a + b;
    const double odd = std::abs(std::sin(sum.x() * 12.9898 + sum.y() * 78.233));
    if (odd < 0.3) return std::nullopt;
    return Way{a, sum / 2 + Vector3(0, 0, 1000 * (odd - 0.3)), b};
  }
  Outcome<Path> plan(const PathQuery& query, const Setting&) const override {
    ++asked;
    const auto way = bent(query.from, query.to);
    if (!way) return refuse(RefusalKind::kBeyondVehicle, "to", "too far round");
    Refined<Path> path;
    path.task.way = *way;
    return path;
  }
  mutable int asked = 0;
};

double seconds_along(const Way& way, const TourQuery& query, const World& world) {
  const Duration takes =
      estimate_flight(way, query.vehicle, world.wind, query.speed).duration.expected;
  return takes == Duration::max() ? kNever : takes.to_seconds();
}

/// The best of all orders, with all ways known.
double least_of_all_orders(const TourQuery& query, const World& world) {
  const auto airspace = airspace_of(leg_of(query), {world, {}});
  std::vector<Vector3> places = {query.start};
  for (const Stop& stop : query.stops) places.push_back(stop.gates[0].entry);
  std::vector<std::vector<double>> takes(places.size(), std::vector<double>(places.size(), kNever));
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < places.size(); ++j) {
      const bool straight = airspace->is_free(places[i], places[j]);
      const auto way = straight ? Way{places[i], places[j]}
                                : BentPlanner::bent(places[i], places[j]).value_or(Way{});
      if (!way.empty()) takes[i][j] = seconds_along(way, query, world);
    }
  std::vector<std::size_t> order(query.stops.size());
  std::iota(order.begin(), order.end(), std::size_t{1});
  double least = kNever;
  do {
    double sum = 0;
    for (std::size_t i = 0, at = 0; i < order.size(); at = order[i++]) sum += takes[at][order[i]];
    least = std::min(least, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

TEST(TourRounds, FindTheBestOfAllOrdersThoughNotAllWaysAreLookedFor) {
  const World world = town();
  const auto seeds = skein::testing::cases<std::uint64_t>(10, 40);
  std::uint64_t found = 0, asked = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const TourQuery query =
        random_tour(world, 7, seed, seed % 2 == 0 ? helicopter() : testing::fixed_wing());
    const BentPlanner planner;

    const auto tour = refine(query, {.world = world, .budget = {}, .paths = &planner});

    asked += static_cast<std::uint64_t>(planner.asked);
    const double least = least_of_all_orders(query, world);
    ASSERT_EQ(tour.has_value(), least < kNever);
    if (!tour) {
      EXPECT_EQ(tour.error().kind, RefusalKind::kUnreachable);
      continue;
    }
    ++found;
    EXPECT_TRUE(tour->task.exact);
    EXPECT_NEAR(tour->cost, least, 1e-6);
    EXPECT_NEAR(tour->duration.expected.to_seconds(), least, 1e-6);
  }
  EXPECT_GT(found, seeds / 2);
  EXPECT_LT(asked, seeds * 7 * 6);
}

TEST(TourRounds, StraightFlightBoundsEveryWayInAnyWind) {
  World world = level_world();
  Random random(4);
  const auto place = [&] {
    return Vector3(random.uniform(-900, 900), random.uniform(-900, 900), random.uniform(0, 190));
  };
  for (int i = 0; i < 20000; ++i) {
    world.wind = {.toward = random.uniform(-4, 4), .speed = random.uniform(0, 15), .gusts = 1};
    TourQuery query;
    query.vehicle = random.chance(0.5) ? helicopter() : testing::fixed_wing();
    query.vehicle.wind_drift = random.uniform(0, 1);
    query.vehicle.climb_rate = random.uniform(0.3, 8);
    Way way = {place(), place()};
    const double straight = seconds_along(way, query, world);
    for (std::uint64_t k = 1 + random.below(3); k > 0; --k) way.insert(way.begin() + 1, place());

    const double takes = seconds_along(way, query, world);

    ASSERT_GE(takes, straight - 1e-6) << i;
  }
}

TEST(TourRounds, LookForFewWaysAmongHills) {
  const World world = test::hills();
  for (const bool hovers : {true, false}) {
    if (!hovers && !skein::testing::long_tests()) continue;
    const TourQuery query = test::tour_among_hills(world, 60, 1, hovers);
    const auto airspace = airspace_of(leg_of(query), {world, {}});
    const test::CountingPlanner planner(*airspace);

    const auto tour = refine(query, {.world = world, .budget = {}, .paths = &planner});

    ASSERT_TRUE(tour) << tour.error().why;
    EXPECT_GT(test::closed_pairs(*airspace, query).closed, 800U);
    EXPECT_LE(planner.asked(), 6 * 60);
    for (const Visit& visit : tour->task.visits)
      for (std::size_t i = 1; i < visit.way.size(); ++i)
        EXPECT_TRUE(airspace->is_free(visit.way[i - 1], visit.way[i]));
  }
}

TEST(TourRounds, LookForFewWaysInALabyrinth) {
  if (!skein::testing::long_tests()) GTEST_SKIP() << "for ./check --long";
  const World world = labyrinth();
  const TourQuery query = random_tour(world, 60, 3, helicopter());
  const auto airspace = airspace_of(leg_of(query), {world, {}});
  const test::CountingPlanner planner(*airspace);

  const auto tour = refine(query, {.world = world, .budget = {}, .paths = &planner});

  ASSERT_TRUE(tour) << tour.error().why;
  EXPECT_GT(test::closed_pairs(*airspace, query).closed, 1400U);
  EXPECT_LE(planner.asked(), 6 * 60);
  EXPECT_FALSE(tour->effort.cut_short);
}

TEST(TourRounds, WithoutAPlannerUseTheVoxels) {
  const World world = labyrinth();
  const TourQuery query = random_tour(world, 7, 5, helicopter());
  const auto airspace = airspace_of(leg_of(query), {world, {}});
  const test::CountingPlanner planner(*airspace);

  const auto tour = refine(query, {.world = world, .budget = {}});
  const auto same = refine(query, {.world = world, .budget = {}, .paths = &planner});

  ASSERT_TRUE(tour && same);
  EXPECT_TRUE(tour->task.exact);
  EXPECT_EQ(tour->cost, same->cost);
}

/// Up from the n-th time it is asked on.
std::function<bool()> clock_of(int asks, std::shared_ptr<int> asked) {
  return [asks, asked] { return ++*asked > asks; };
}

/// Around by the north; asks the clock as a search does, and tells whether it was called late.
class PunctualPlanner final : public PathPlanner {
 public:
  PunctualPlanner(const int& asks, int most) : asks_(asks), most_(most) {}
  Outcome<Path> plan(const PathQuery& query, const Setting& setting) const override {
    late = late || asks_ > most_;
    ++asked;
    if (setting.budget.expired() || setting.budget.expired())
      return refuse(RefusalKind::kBudgetExhausted, "", "late");
    Refined<Path> path;
    path.task.way = {query.from, Vector3(0, 1500, 100), query.to};
    return path;
  }
  mutable bool late = false;
  mutable int asked = 0;

 private:
  const int& asks_;
  int most_;
};

TEST(TourRounds, KeepTheClockWhereverItRunsOut) {
  const World world = town();
  for (const std::size_t stops : {9U, 30U}) {
    const TourQuery query = random_tour(world, stops, 6, helicopter());
    int none = 0, some = 0;
    for (int asks = 0; asks < 2000; asks = asks * 5 / 4 + 1) {
      SCOPED_TRACE(asks);
      const auto asked = std::make_shared<int>(0);
      const PunctualPlanner planner(*asked, asks);
      Setting setting{.world = world, .budget = {}, .paths = &planner};
      setting.budget.time_is_up = clock_of(asks, asked);

      const auto tour = refine(query, setting);

      EXPECT_FALSE(planner.late);
      EXPECT_LE(*asked, asks + 20) << "asks again and again what it knows";
      if (!tour) {
        EXPECT_EQ(tour.error().kind, RefusalKind::kBudgetExhausted);
        ++none;
        continue;
      }
      ++some;
      EXPECT_EQ(tour->effort.cut_short, !tour->task.exact);
      EXPECT_EQ(tour->task.visits.size(), query.stops.size());
    }
    EXPECT_GT(none, 0);
    EXPECT_GT(some, 0);
  }
}

TEST(TourRounds, GiveTheBestTourKnownWhenTheTimeIsUp) {
  const World world = town();
  int between = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const TourQuery query = random_tour(world, 20, seed, helicopter());
    const auto airspace = airspace_of(leg_of(query), {world, {}});
    const VoxelPathPlanner voxels(*airspace);
    const auto asked = std::make_shared<int>(0);
    Setting setting{.world = world, .budget = {}, .paths = &voxels};
    setting.budget.time_is_up = clock_of(2000, asked);

    const auto tour = refine(query, setting);

    if (!tour || !tour->effort.cut_short) continue;
    ++between;
    EXPECT_FALSE(tour->task.exact);
    EXPECT_EQ(tour->task.visits.size(), query.stops.size());
    double seconds = 0;
    for (const Visit& visit : tour->task.visits) seconds += seconds_along(visit.way, query, world);
    EXPECT_NEAR(seconds, tour->cost, 1e-5);
  }
  EXPECT_GT(between, 0);
}

TEST(TourRounds, OfStepsBoundTheOrdersOfAllRounds) {
  const World world = town();
  const TourQuery query = random_tour(world, 40, 2, helicopter());
  const auto airspace = airspace_of(leg_of(query), {world, {}});
  const VoxelPathPlanner voxels(*airspace);
  Setting setting{.world = world, .budget = {}, .paths = &voxels};
  setting.budget.steps = 3000;

  const auto tour = refine(query, setting), again = refine(query, setting);

  ASSERT_TRUE(tour && again);
  EXPECT_LE(tour->effort.steps, 3000U + kMostTourRounds);
  EXPECT_EQ(tour->cost, again->cost);
  EXPECT_FALSE(tour->effort.cut_short);
}

TEST(TourRounds, NameTheStopThatIsShutIn) {
  World world = labyrinth();
  TourQuery query = random_tour(world, 60, 7, helicopter());
  const Vector3 at = query.stops[41].gates[0].entry;
  for (const double x : {-60.0, 50.0})
    world.volumes.push_back(block(at.x() + x, at.y() - 60, at.x() + x + 10, at.y() + 60));
  for (const double y : {-60.0, 50.0})
    world.volumes.push_back(block(at.x() - 60, at.y() + y, at.x() + 60, at.y() + y + 10));
  std::vector<Stop> outside;
  for (const Stop& stop : query.stops)
    if (const Vector3 away = stop.gates[0].entry - at;
        away.norm() == 0 || away.head<2>().cwiseAbs().maxCoeff() > 100)
      outside.push_back(stop);
  query.stops = outside;
  const auto shut_in = std::find_if(outside.begin(), outside.end(),
                                    [&](const Stop& stop) { return stop.gates[0].entry == at; });

  const auto tour = refine(query, {.world = world, .budget = {}});

  ASSERT_FALSE(tour);
  EXPECT_EQ(tour.error().kind, RefusalKind::kUnreachable);
  EXPECT_EQ(tour.error().field, "stops." + std::to_string(shut_in - outside.begin()));
}

TEST(TourRounds, NameAStopBeyondAWall) {
  World world = level_world(1000, 80);
  world.volumes.push_back(block(-10, -1000, 10, 1000));
  const TourQuery query = random_tour(world, 60, 8, helicopter());

  const auto tour = refine(query, {.world = world, .budget = {}});

  ASSERT_FALSE(tour);
  EXPECT_EQ(tour.error().kind, RefusalKind::kUnreachable);
  ASSERT_GT(tour.error().field.size(), 6U) << tour.error().why;
  const auto stop = std::stoul(tour.error().field.substr(6));
  EXPECT_GT(query.stops[stop].gates[0].entry.x(), 0);
}

TEST(Travel, LearnsFromOneWayThatIsClosedWhatIsShutOff) {
  World world = level_world(1000, 80);
  world.volumes.push_back(block(-10, -1000, 10, 1000));
  const world::VehicleModel vehicle = helicopter();
  const Setting setting{.world = world, .budget = {}};
  const Vector3 a(-500, 0, 50), b(-500, 300, 50), c(500, 0, 50), d(500, 300, 50);
  auto travel = Travel::over({vehicle, 0, 0, {}}, setting, a, b);
  ASSERT_TRUE(travel);
  std::vector<Travel::Id> ids;
  for (const Vector3& place : {a, b, c, d}) ids.push_back(travel->add(place));

  travel->settle(ids[0], ids[1]);
  travel->settle(ids[2], ids[3]);
  travel->settle(ids[0], ids[2]);

  EXPECT_EQ(travel->planned(), 1U);
  EXPECT_EQ(travel->seconds(ids[3], ids[1]), kNever);
  EXPECT_TRUE(travel->settle(ids[1], ids[3]));
  EXPECT_EQ(travel->planned(), 1U);
  EXPECT_NEAR(travel->seconds(ids[0], ids[1]), 30, 1e-6);
}

TEST(TourRounds, VisitAPlaceThatIsFreeThoughItsVoxelIsNot) {
  const World world = level_world();
  TourQuery query = random_tour(world, 3, 9, helicopter());
  query.clearance = 2;
  query.stops[1].gates[0] = {{100, 100, 5}, {100, 100, 5}, {}};

  const auto tour = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(tour) << tour.error().why;
}

TEST(TourRounds, RepeatNoPointInSuccession) {
  const World world = labyrinth();
  TourQuery query = random_tour(world, 8, 10, helicopter());
  const Vector3 centre(-950, -950, 50);  // of a voxel
  query.start = centre;
  query.end = centre;
  query.stops.push_back({"", {{centre, centre, {}}}});
  query.stops.push_back(query.stops[2]);
  query.stops.push_back({"", {{{850, 850, 50}, {850, 850, 50}, {}}}});

  const auto tour = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(tour) << tour.error().why;
  std::vector<Way> ways = {tour->task.last};
  for (const Visit& visit : tour->task.visits) ways.push_back(visit.way);
  EXPECT_EQ(std::count_if(ways.begin(), ways.end(), [](const Way& way) { return way.size() == 1; }),
            2);
  for (const Way& way : ways)
    for (std::size_t i = 1; i < way.size(); ++i) EXPECT_NE(way[i - 1], way[i]);
}

}  // namespace
}  // namespace skein::refiners
