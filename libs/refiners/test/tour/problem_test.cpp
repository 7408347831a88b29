// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/tour_problem.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "skein/foundation/random.hpp"
#include "skein/world/geometry.hpp"
#include "test_cases.hpp"
#include "tour/search.hpp"

namespace skein::refiners {
namespace {

struct Shape {
  std::size_t stops = 5, most_gates = 1;
  bool symmetrical = false, fixed_end = true, closed = false;
  double closed_ways = 0;  // how many ways are not there
};

TourProblem random_problem(const Shape& shape, Random& random) {
  TourProblem problem;
  const auto cost = [&] {
    return random.chance(shape.closed_ways) ? kNoWay : static_cast<TourCost>(random.below(1000));
  };
  for (std::size_t stop = 0; stop < shape.stops; ++stop)
    for (std::size_t gate = 0; gate < 1 + random.below(shape.most_gates); ++gate) {
      problem.stop_of.push_back(stop);
      problem.inside.push_back(static_cast<TourCost>(random.below(100)));
      problem.from_start.push_back(cost());
      problem.to_end.push_back(shape.closed      ? problem.from_start.back()
                               : shape.fixed_end ? cost()
                                                 : 0);
    }
  const std::size_t n = problem.gates();
  problem.between.resize(n * n);
  for (TourCost& between : problem.between) between = cost();
  if (shape.symmetrical)
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < a; ++b) problem.between[b * n + a] = problem.cost(a, b);
  return problem;
}

/// Every order of the stops, with the best gates along each found by trying all.
TourCost least_by_trying(const TourProblem& problem) {
  const StopGates gates_of(problem);
  std::vector<std::size_t> stops(problem.stops());
  std::iota(stops.begin(), stops.end(), std::size_t{0});
  TourCost least = std::numeric_limits<TourCost>::max();
  do {
    std::vector<std::size_t> gates;
    const auto choose = [&](const auto& self, std::size_t i) -> void {
      if (i == stops.size()) {
        least = std::min(least, cost_of(problem, gates));
        return;
      }
      for (std::size_t g = gates_of.begin(stops[i]); g < gates_of.end(stops[i]); ++g) {
        gates.push_back(g);
        self(self, i + 1);
        gates.pop_back();
      }
    };
    choose(choose, 0);
  } while (std::next_permutation(stops.begin(), stops.end()));
  return least;
}

void expect_valid(const TourProblem& problem, const TourOrder& order) {
  std::set<std::size_t> visited;
  for (const std::size_t gate : order.gates) visited.insert(problem.stop_of[gate]);
  EXPECT_EQ(order.gates.size(), problem.stops());
  EXPECT_EQ(visited.size(), problem.stops());
  EXPECT_EQ(order.cost, cost_of(problem, order.gates));
}

Budget steps(std::uint64_t count) {
  Budget budget;
  budget.steps = count;
  return budget;
}

RC_GTEST_PROP(TourProblem, SmallOnesAreSolvedAsWellAsByTryingEverything, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  Shape shape;
  shape.stops = *rc::gen::inRange<std::size_t>(1, 6);
  shape.most_gates = *rc::gen::inRange<std::size_t>(1, 4);
  shape.fixed_end = *rc::gen::arbitrary<bool>();
  shape.closed_ways = *rc::gen::element(0.0, 0.2);
  const TourProblem problem = random_problem(shape, random);

  const TourOrder order = solve_tour(problem, {}, 1);

  expect_valid(problem, order);
  RC_ASSERT(order.exact);
  RC_ASSERT(order.cost == least_by_trying(problem));
}

/// The order by inserting, each place reckoned anew from the whole order.
std::vector<std::size_t> inserted_naively(const TourProblem& problem) {
  const StopGates gates_of(problem);
  std::vector<std::size_t> order;
  for (std::size_t stop = 0; stop < problem.stops(); ++stop) {
    std::vector<std::size_t> best;
    for (std::size_t gate = gates_of.begin(stop); gate < gates_of.end(stop); ++gate)
      for (std::size_t at = 0; at <= order.size(); ++at) {
        std::vector<std::size_t> longer = order;
        longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(at), gate);
        if (best.empty() || cost_of(problem, longer) < cost_of(problem, best)) best = longer;
      }
    order = best;
  }
  return order;
}

RC_GTEST_PROP(TourProblem, IsBegunByPuttingEachStopWhereTheWholeOrderCostsLeast, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  Shape shape;
  shape.stops = *rc::gen::inRange<std::size_t>(1, 80);
  shape.symmetrical = *rc::gen::arbitrary<bool>();
  shape.most_gates = shape.symmetrical ? 1 : *rc::gen::inRange<std::size_t>(1, 4);
  shape.fixed_end = *rc::gen::arbitrary<bool>();
  const TourProblem problem = random_problem(shape, random);

  RC_ASSERT(insert_cheaply(problem, is_symmetrical(problem)) == inserted_naively(problem));
}

/// Squares of costs are compared, so that each pair has to be tried once: the first, the last, and
/// those on the borders of squares.
TEST(TourProblem, IsNotSymmetricalWhenASinglePairDiffers) {
  Random random(9);
  Shape shape;
  shape.stops = 70;
  shape.symmetrical = true;
  TourProblem problem = random_problem(shape, random);
  EXPECT_TRUE(is_symmetrical(problem));
  for (std::size_t a = 0; a < problem.gates(); ++a)
    for (std::size_t b = 0; b < problem.gates(); ++b) {
      if (a == b) continue;
      ++problem.between[a * problem.gates() + b];
      EXPECT_FALSE(is_symmetrical(problem)) << a << ' ' << b;
      --problem.between[a * problem.gates() + b];
    }
}

TEST(TourProblem, EightStopsInAnyOrderAreSolvedExactly) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    Shape shape;
    shape.stops = 8;
    shape.fixed_end = i % 2 == 0;
    const TourProblem problem = random_problem(shape, random);

    const TourOrder order = solve_tour(problem, {}, 1);

    EXPECT_TRUE(order.exact);
    EXPECT_EQ(order.cost, least_by_trying(problem));
  }
}

TEST(TourProblem, TwelveStopsOfEightGatesAreStillExact) {
  Random random(4);
  Shape shape;
  shape.stops = 12;
  TourProblem problem = random_problem(shape, random);
  problem = {};
  for (std::size_t gate = 0; gate < 96; ++gate) {
    problem.stop_of.push_back(gate / 8);
    problem.inside.push_back(0);
    problem.from_start.push_back(static_cast<TourCost>(random.below(1000)));
    problem.to_end.push_back(0);
  }
  for (std::size_t i = 0; i < 96 * 96; ++i)
    problem.between.push_back(static_cast<TourCost>(random.below(1000)));

  const TourOrder order = solve_tour(problem, {}, 1);

  EXPECT_TRUE(order.exact);
  expect_valid(problem, order);
}

TEST(TourProblem, GatesAlongAnOrderAreTheBestOnes) {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    Shape shape;
    shape.stops = 4;
    shape.most_gates = 4;
    const TourProblem problem = random_problem(shape, random);
    const StopGates gates_of(problem);
    TourCost least = std::numeric_limits<TourCost>::max();
    for (std::size_t a = gates_of.begin(2); a < gates_of.end(2); ++a)
      for (std::size_t b = gates_of.begin(0); b < gates_of.end(0); ++b)
        for (std::size_t c = gates_of.begin(3); c < gates_of.end(3); ++c)
          for (std::size_t d = gates_of.begin(1); d < gates_of.end(1); ++d)
            least = std::min(least, cost_of(problem, {a, b, c, d}));

    const std::vector<std::size_t> chosen = choose_gates(problem, {2, 0, 3, 1});

    EXPECT_EQ(cost_of(problem, chosen), least);
  }
}

/// Areas with doors: ways in and out anywhere near their middles, so no sense is like the other.
TourProblem areas_with_doors(std::size_t stops, std::size_t doors, bool fixed_end, Random& random) {
  TourProblem problem;
  std::vector<std::pair<double, double>> entries, exits;
  const auto hop = [](const auto& a, const auto& b) {
    return static_cast<TourCost>(std::hypot(a.first - b.first, a.second - b.second));
  };
  const std::pair<double, double> start(0, 0), end(1000, 0);
  for (std::size_t stop = 0; stop < stops; ++stop) {
    const double x = random.uniform(0, 1000), y = random.uniform(0, 1000);
    for (std::size_t door = 0; door < doors; ++door) {
      entries.emplace_back(x + random.uniform(-100, 100), y + random.uniform(-100, 100));
      exits.emplace_back(x + random.uniform(-100, 100), y + random.uniform(-100, 100));
      problem.stop_of.push_back(stop);
      problem.inside.push_back(static_cast<TourCost>(random.below(100)));
      problem.from_start.push_back(hop(start, entries.back()));
      problem.to_end.push_back(fixed_end ? hop(exits.back(), end) : 0);
    }
  }
  for (const auto& exit : exits)
    for (const auto& entry : entries) problem.between.push_back(hop(exit, entry));
  return problem;
}

/// True when the search without the exact one finds what that proves to be best.
bool finds_the_best(const TourProblem& problem) {
  const Budget endless, budget = steps(default_tour_steps(problem));
  Countdown unbounded(endless), countdown(budget);
  const TourCost best = solve_exactly(problem, unbounded)->cost;
  TourOrder found;
  found.gates = insert_cheaply(problem);
  (is_symmetrical(problem) ? improve_symmetrical : improve_any)(problem, found, countdown, 1);
  const TourCost cost = cost_of(problem, found.gates);
  EXPECT_GE(cost, best);
  return cost == best;
}

/// How often, of `cases`.
int times_best(const Shape& shape, int cases) {
  Random random(6);
  int best = 0;
  for (int i = 0; i < cases; ++i) best += finds_the_best(random_problem(shape, random)) ? 1 : 0;
  return best;
}

TEST(TourSearch, FindsTheBestOrderOfTwelveStopsNearlyAlways) {
  Shape shape;
  shape.stops = 12;
  const int tried = skein::testing::cases(10, 40);

  const int any = times_best(shape, tried);
  shape.symmetrical = true;
  const int open = times_best(shape, tried);
  shape.closed = true;
  const int closed = times_best(shape, tried);

  RecordProperty("any", any);
  EXPECT_GE(any, tried - 1);
  EXPECT_GE(open, tried - 1);
  EXPECT_GE(closed, tried - 1);
}

TEST(TourSearch, FindsTheBestGatesOfTenAreasNearlyAlways) {
  Random random(7);
  int best = 0;
  const int tried = skein::testing::cases(10, 40);
  for (int i = 0; i < tried; ++i)
    best += finds_the_best(areas_with_doors(10, 4, i % 2 == 0, random)) ? 1 : 0;

  RecordProperty("best", best);
  EXPECT_GE(best, tried - 1);
}

RC_GTEST_PROP(TourSearch, GivesWhatItSaysForAnyShape, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  Shape shape;
  shape.stops = *rc::gen::inRange<std::size_t>(1, 40);
  shape.most_gates = *rc::gen::element<std::size_t>(1, 1, 3);
  shape.symmetrical = *rc::gen::arbitrary<bool>();
  shape.fixed_end = *rc::gen::arbitrary<bool>();
  shape.closed = *rc::gen::arbitrary<bool>();
  shape.closed_ways = *rc::gen::element(0.0, 0.1);
  const TourProblem problem = random_problem(shape, random);

  const TourOrder order = solve_tour(problem, steps(200), 7);

  expect_valid(problem, order);
  RC_ASSERT(order.cost <= cost_of(problem, insert_cheaply(problem)));
  RC_ASSERT(order.effort.steps <= 201U);
}

/// No turn of a piece, no piece moved elsewhere lowers the cost, as counted anew.
void expect_no_better_neighbour(const TourProblem& problem, const std::vector<std::size_t>& order) {
  const TourCost cost = cost_of(problem, order);
  const auto n = static_cast<std::ptrdiff_t>(order.size());
  for (std::ptrdiff_t i = 0; i < n; ++i)
    for (std::ptrdiff_t j = i + 1; j < n; ++j) {
      std::vector<std::size_t> turned = order;
      std::reverse(turned.begin() + i, turned.begin() + j + 1);
      EXPECT_GE(cost_of(problem, turned), cost);
      for (std::ptrdiff_t k = j + 1; k <= n; ++k) {
        std::vector<std::size_t> moved = order;
        std::rotate(moved.begin() + i, moved.begin() + j, moved.begin() + k);
        EXPECT_GE(cost_of(problem, moved), cost);
      }
    }
}

TEST(TourSearch, EndsWhereNoTurnAndNoExchangeImproves) {
  Random random(8);
  for (int i = 0; i < 60; ++i) {
    Shape shape;
    shape.stops = 9;  // so that all others are near ones
    shape.symmetrical = true;
    shape.closed = i % 2 == 0;
    const TourProblem problem = random_problem(shape, random);
    const Budget none = steps(0);
    Countdown countdown(none);
    TourOrder order;
    order.gates = insert_cheaply(problem);

    improve_symmetrical(problem, order, countdown, 1);

    expect_no_better_neighbour(problem, order.gates);
  }
}

TEST(TourSearch, IsTheSameForTheSameSeed) {
  Random random(9);
  for (const bool symmetrical : {true, false}) {
    Shape shape;
    shape.stops = 60;
    shape.most_gates = symmetrical ? 1 : 3;
    shape.symmetrical = symmetrical;
    const TourProblem problem = random_problem(shape, random);

    const TourOrder one = solve_tour(problem, steps(500), 11);
    const TourOrder two = solve_tour(problem, steps(500), 11);

    EXPECT_EQ(one.gates, two.gates);
    EXPECT_EQ(one.effort, two.effort);
    EXPECT_FALSE(one.effort.cut_short);
  }
}

TEST(TourSearch, AClockThatIsUpAtOnceStillGivesAnOrder) {
  Random random(10);
  for (const std::size_t stops : {1U, 7U, 12U, 80U}) {
    Shape shape;
    shape.stops = stops;
    const TourProblem problem = random_problem(shape, random);
    Budget budget;
    budget.time_is_up = [] { return true; };

    const TourOrder order = solve_tour(problem, budget, 1);

    expect_valid(problem, order);
    EXPECT_EQ(order.effort.cut_short, !order.exact);
  }
}

TEST(TourSearch, AClockEndsItSoonAfterItIsUp) {
  Random random(11);
  Shape shape;
  shape.stops = 100;
  for (const bool symmetrical : {true, false}) {
    shape.symmetrical = symmetrical;
    const TourProblem problem = random_problem(shape, random);
    int asked = 0;
    Budget budget;
    budget.time_is_up = [&] { return ++asked > 5; };

    const TourOrder order = solve_tour(problem, budget, 1);

    expect_valid(problem, order);
    EXPECT_TRUE(order.effort.cut_short);
    EXPECT_LT(order.effort.steps, 200U);
    EXPECT_EQ(asked, 6);
  }
}

TEST(TourSearch, MoreStepsThanTheExactSearchMayTakeLeaveItToTheOther) {
  Random random(12);
  Shape shape;
  shape.stops = 10;
  const TourProblem problem = random_problem(shape, random);

  const TourOrder order = solve_tour(problem, steps(50), 1);

  expect_valid(problem, order);
  EXPECT_FALSE(order.exact);
}

TEST(TourSearch, NoOpenOrderCostsAtLeastNoWay) {
  Random random(13);
  Shape shape;
  shape.stops = 20;
  TourProblem problem = random_problem(shape, random);
  for (std::size_t from = 0; from < problem.gates(); ++from)
    problem.between[from * problem.gates() + 4] = kNoWay;
  problem.from_start[4] = kNoWay;

  const TourOrder order = solve_tour(problem, steps(500), 1);

  EXPECT_GE(order.cost, kNoWay);
}

TEST(TourSearch, FindsOpenOrdersAmongClosedWays) {
  Random random(14);
  Shape shape;
  shape.stops = 25;
  shape.closed_ways = 0.5;
  for (int i = 0; i < 10; ++i) {
    const TourOrder order = solve_tour(random_problem(shape, random), {}, 1);

    EXPECT_LT(order.cost, kNoWay);
  }
}

TEST(SolveTour, IsWithinATenthOfTheBestEvenWhenTheTimeWasUpBeforeItBegan) {
  for (const std::size_t places : {150UL, 400UL}) {
    Random random(places, "places");
    std::vector<world::Vector2> at(places);
    for (world::Vector2& place : at) place = {random.uniform(0, 1000), random.uniform(0, 1000)};
    const auto far = [&](std::size_t a, std::size_t b) {
      return static_cast<TourCost>(std::llround(1e6 * (at[a] - at[b]).norm()));
    };
    TourProblem problem;
    for (std::size_t i = 1; i < places; ++i) {
      problem.stop_of.push_back(i - 1);
      problem.inside.push_back(0);
      problem.from_start.push_back(far(0, i));
      problem.to_end.push_back(far(i, 0));
      for (std::size_t j = 1; j < places; ++j) problem.between.push_back(far(i, j));
    }
    Budget none;
    none.time_is_up = [] { return true; };

    const TourOrder late = solve_tour(problem, none, 1);

    EXPECT_TRUE(late.effort.cut_short);
    EXPECT_LT(static_cast<double>(late.cost),
              1.1 * static_cast<double>(solve_tour(problem, {}, 1).cost));
  }
}

}  // namespace
}  // namespace skein::refiners
