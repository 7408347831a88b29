// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/tour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "skein/foundation/random.hpp"
#include "skein/refiners/tour_problem.hpp"
#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

using testing::helicopter;
using testing::level_world;
using world::Vector3;

Gate gate_at(const Vector3& place) { return {place, place, {}}; }
Stop point(double x, double y, double z = 50) { return {"", {gate_at({x, y, z})}}; }

TourQuery query_over(std::vector<Stop> stops) {
  TourQuery query;
  query.vehicle = helicopter();
  query.start = {0, 0, 50};
  query.stops = std::move(stops);
  return query;
}

std::vector<std::size_t> order_of(const Tour& tour) {
  std::vector<std::size_t> order;
  for (const Visit& visit : tour.visits) order.push_back(visit.stop);
  return order;
}

/// Every way goes by one fixed place, or there is none; counts how often it is asked.
class DetourPlanner final : public PathPlanner {
 public:
  explicit DetourPlanner(std::optional<Vector3> by) : by_(std::move(by)) {}
  Outcome<Path> plan(const PathQuery& query, const Setting&) const override {
    ++asked;
    if (!by_) return refuse(RefusalKind::kUnreachable, "to", "closed");
    Refined<Path> path;
    path.task.way = {query.from, *by_, query.to};
    return path;
  }
  mutable int asked = 0;

 private:
  std::optional<Vector3> by_;
};

/// A wall from south to north at x from 290 to 310, through the whole air.
world::World walled_world() {
  world::World world = level_world();
  world::Volume wall;
  wall.name = "wall";
  wall.polygon = {{290, -1000}, {310, -1000}, {310, 1000}, {290, 1000}};
  world.volumes.push_back(wall);
  return world;
}

TEST(Tour, VisitsPointsAlongALineInOrder) {
  const world::World world = level_world();
  const TourQuery query = query_over({point(300, 0), point(100, 0), point(200, 0)});

  const auto tour = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(tour) << tour.error().why;
  EXPECT_EQ(order_of(tour->task), (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_TRUE(tour->task.exact);
  EXPECT_DOUBLE_EQ(tour->task.length, 300);
  EXPECT_NEAR(tour->cost, 30, 1e-6);
  EXPECT_TRUE(tour->task.last.empty());
}

TEST(Tour, EndsWhereItMust) {
  const world::World world = level_world();
  TourQuery query = query_over({point(300, 0), point(100, 0)});
  query.end = query.start;
  query.stops.push_back(point(200, 0));

  const auto tour = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(tour) << tour.error().why;
  EXPECT_NEAR(tour->cost, 60, 1e-6);
  EXPECT_EQ(tour->task.last.back(), *query.end);
  EXPECT_EQ(tour->task.last.front(), tour->task.visits.back().way.back());
}

TEST(Tour, EntersAnAreaByTheGateThatIsBestForTheWhole) {
  const world::World world = level_world();
  Stop area{"field",
            {{{100, 0, 50}, {200, 0, 50}, Duration::seconds(7)},
             {{200, 0, 50}, {100, 0, 50}, Duration::seconds(7)}}};
  TourQuery query = query_over({area});
  query.end = Vector3(300, 0, 50);
  query.start = {0, 0, 50};

  const auto there = refine(query, {.world = world, .budget = {}});
  std::swap(query.start, *query.end);
  const auto back = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(there && back);
  EXPECT_EQ(there->task.visits[0].gate, 0U);
  EXPECT_EQ(back->task.visits[0].gate, 1U);
  EXPECT_NEAR(there->cost, 27, 1e-6);
  EXPECT_NEAR(back->cost, 27, 1e-6);
}

TEST(Tour, IsMadeOfWaysThatJoinAndAddUp) {
  const world::World world = level_world();
  Random random(1);
  std::vector<Stop> stops;
  for (int i = 0; i < 30; ++i) {
    const Vector3 a(random.uniform(-900, 900), random.uniform(-900, 900), 60);
    const Vector3 b(random.uniform(-900, 900), random.uniform(-900, 900), 90);
    stops.push_back({"", {{a, b, Duration::seconds(5)}, {b, a, Duration::seconds(5)}}});
  }
  TourQuery query = query_over(stops);
  query.vehicle.energy.capacity = 1e9;
  query.end = Vector3(0, 0, 80);

  const auto tour = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(tour) << tour.error().why;
  ASSERT_EQ(tour->task.visits.size(), 30U);
  Vector3 at = query.start;
  double seconds = 0, length = 0;
  for (const Visit& visit : tour->task.visits) {
    const Gate& gate = query.stops[visit.stop].gates[visit.gate];
    EXPECT_EQ(visit.way.front(), at);
    EXPECT_EQ(visit.way.back(), gate.entry);
    seconds += estimate_flight(visit.way, query.vehicle, world.wind).duration.expected.to_seconds();
    seconds += gate.inside.to_seconds();
    length += length_of(visit.way);
    at = gate.exit;
  }
  seconds +=
      estimate_flight({at, *query.end}, query.vehicle, world.wind).duration.expected.to_seconds();
  EXPECT_NEAR(tour->cost, seconds, 1e-6);
  EXPECT_NEAR(tour->duration.expected.to_seconds(), seconds, 1e-6);
  EXPECT_NEAR(tour->task.length, length + (*query.end - at).norm(), 1e-6);
}

TEST(Tour, AsksForAWayOnlyWhereTheStraightOneIsClosedAndOnceForBothSenses) {
  const world::World world = walled_world();
  const DetourPlanner planner(Vector3(300, 990, 50));
  TourQuery query = query_over({point(100, 0), point(500, 0), point(500, 100)});
  query.end = query.start;

  const auto tour = refine(query, {.world = world, .budget = {}, .paths = &planner});

  ASSERT_TRUE(tour) << tour.error().why;
  EXPECT_EQ(planner.asked, 4);  // from the start and from stop 0, to stops 1 and 2
  for (const Visit& visit : tour->task.visits)
    for (std::size_t i = 1; i < visit.way.size(); ++i) {
      const bool crosses = (visit.way[i - 1].x() < 290) != (visit.way[i].x() < 290);
      EXPECT_TRUE(!crosses || visit.way.size() == 3);
    }
}

TEST(Tour, NamesTheStopThatCannotBeReached) {
  const world::World world = walled_world();
  const DetourPlanner closed(std::nullopt);
  TourQuery query = query_over({point(100, 0), point(500, 0)});
  query.stops[1].name = "beyond";

  const auto tour = refine(query, {.world = world, .budget = {}, .paths = &closed});

  ASSERT_FALSE(tour);
  EXPECT_EQ(tour.error().kind, RefusalKind::kUnreachable);
  EXPECT_EQ(tour.error().field, "stops.1");
  EXPECT_NE(tour.error().why.find("'beyond'"), std::string::npos);
}

TEST(Tour, NamesTheStopThatIsInAVolume) {
  const world::World world = walled_world();

  const auto tour =
      refine(query_over({point(100, 0), point(300, 0)}), {.world = world, .budget = {}});

  ASSERT_FALSE(tour);
  EXPECT_EQ(tour.error().kind, RefusalKind::kBlocked);
  EXPECT_EQ(tour.error().field, "stops.1.gates.0.entry");
}

TEST(Tour, LeavesOutAGateThatIsBlocked) {
  const world::World world = walled_world();
  TourQuery query = query_over({point(300, 0)});
  query.stops[0].gates.push_back(gate_at({200, 0, 50}));

  const auto tour = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(tour) << tour.error().why;
  EXPECT_EQ(tour->task.visits[0].gate, 1U);
}

TEST(Tour, IsRefusedWhenTheEnergyDoesNotLast) {
  const world::World world = level_world();
  TourQuery query = query_over({point(900, 0), point(-900, 0)});
  query.vehicle.energy.capacity = 1e5;

  const auto tour = refine(query, {.world = world, .budget = {}});

  ASSERT_FALSE(tour);
  EXPECT_EQ(tour.error().kind, RefusalKind::kBeyondVehicle);
  EXPECT_EQ(tour.error().field, "vehicle.energy");
}

TEST(Tour, RefusesFiguresThatMakeNoSenseByTheirFields) {
  const world::World world = level_world();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto field_of = [&](auto spoil) {
    TourQuery query = query_over({point(100, 0), point(200, 0), point(300, 0)});
    spoil(query);
    const auto tour = refine(query, {.world = world, .budget = {}});
    return tour ? "none" : tour.error().field;
  };

  EXPECT_EQ(field_of([](TourQuery& q) { q.stops.clear(); }), "stops");
  EXPECT_EQ(field_of([](TourQuery& q) { q.stops[1].gates.clear(); }), "stops.1.gates");
  EXPECT_EQ(field_of([&](TourQuery& q) { q.stops[2].gates[0].entry.x() = nan; }),
            "stops.2.gates.0.entry");
  EXPECT_EQ(field_of([&](TourQuery& q) { q.stops[2].gates[0].exit.z() = nan; }),
            "stops.2.gates.0.exit");
  EXPECT_EQ(field_of([](TourQuery& q) { q.stops[0].gates[0].inside = Duration::seconds(-1); }),
            "stops.0.gates.0.inside");
  EXPECT_EQ(field_of([&](TourQuery& q) { q.start.y() = nan; }), "start");
  EXPECT_EQ(field_of([&](TourQuery& q) { q.end = Vector3(nan, 0, 0); }), "end");
  EXPECT_EQ(field_of([](TourQuery& q) { q.speed = -1; }), "speed");
  EXPECT_EQ(field_of([](TourQuery& q) { q.speed = 99; }), "speed");
  EXPECT_EQ(field_of([](TourQuery& q) { q.clearance = -1; }), "clearance");
  EXPECT_EQ(field_of([](TourQuery& q) { q.vehicle.climb_rate = 0; }), "vehicle.climb_rate");
  EXPECT_EQ(field_of([](TourQuery& q) { q.stops.assign(1001, q.stops[0]); }), "stops");
}

TEST(Tour, AgainstTheWindIsAnotherCostThanWithIt) {
  world::World world = level_world();
  world.wind = {.toward = 0, .speed = 5, .gusts = 0};
  TourQuery query = query_over({point(400, 0)});
  query.vehicle.wind_drift = 1;

  const auto with = refine(query, {.world = world, .budget = {}});
  query.stops = {point(-400, 0)};
  const auto against = refine(query, {.world = world, .budget = {}});

  ASSERT_TRUE(with && against);
  EXPECT_NEAR(with->cost, 400 / 15.0, 1e-6);
  EXPECT_NEAR(against->cost, 400 / 5.0, 1e-6);
}

TEST(Tour, AClockThatIsUpStillGivesATourThatSaysSo) {
  const world::World world = level_world();
  std::vector<Stop> stops;
  for (int i = 0; i < 40; ++i) stops.push_back(point(20.0 * i, (i * 37) % 100));
  Setting setting{.world = world, .budget = {}};
  setting.budget.time_is_up = [] { return true; };

  const auto tour = refine(query_over(stops), setting);

  ASSERT_TRUE(tour) << tour.error().why;
  EXPECT_TRUE(tour->effort.cut_short);
  EXPECT_FALSE(tour->task.exact);
  EXPECT_EQ(tour->task.visits.size(), 40U);
}

}  // namespace
}  // namespace skein::refiners
