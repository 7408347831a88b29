// SPDX-License-Identifier: Apache-2.0
#include "tour/ring_costs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tour/cases.hpp"
#include "tour/search.hpp"

namespace skein::refiners {
namespace {

std::vector<test::TourCase> all_kinds() {
  std::vector<test::TourCase> cases = test::cases_like_tsplib(1, 5);
  for (test::TourCase& c : test::cases_of_heaps(4, 5)) cases.push_back(std::move(c));
  return cases;
}

/// The same tour, whose end is somewhere else or free.
TourProblem open_tour(TourProblem problem, bool free) {
  for (std::size_t i = 0; i < problem.stops(); ++i)
    problem.to_end[i] = free ? 0 : problem.from_start[i] + static_cast<TourCost>(i % 7);
  return problem;
}

std::vector<std::size_t> some_order(const TourProblem& problem) {
  return insert_cheaply(problem, true);
}

/// Places that can be reached from the first stop along the lists, either way. Start and end of an
/// open tour join none.
std::size_t joined(const RingCosts& costs, City places) {
  std::vector<City> group(places);
  std::iota(group.begin(), group.end(), City{0});
  const auto head = [&](City city) {
    while (group[city] != city) city = group[city] = group[group[city]];
    return city;
  };
  for (City city = 0; city < places; ++city)
    for (const auto& [cost, other] : costs.near(city))
      if (other < places) group[head(other)] = head(city);
  std::size_t count = 0;
  for (City city = 0; city < places; ++city) count += head(city) == head(0) ? 1 : 0;
  return count;
}

TEST(RingCosts, NearPlacesJoinAllStopsHoweverFarApartTheirHeapsAre) {
  for (const test::TourCase& c : all_kinds())
    for (const int kind : {0, 1, 2}) {
      const TourProblem closed = test::closed_tour(c);
      const TourProblem problem = kind == 0 ? closed : open_tour(closed, kind == 1);
      const RingCosts costs(problem, some_order(problem));

      const City places = costs.closed() ? costs.size() : static_cast<City>(problem.stops());
      EXPECT_EQ(joined(costs, places), places) << c.name << " " << kind;
    }
}

TEST(RingCosts, ListsHoldTheNearestOthersNearestFirstAndNoPlaceTwice) {
  for (const test::TourCase& c : all_kinds()) {
    const TourProblem problem = test::closed_tour(c);
    const RingCosts costs(problem, some_order(problem));
    for (City city = 0; city < costs.size(); ++city) {
      const auto near = costs.near(city);
      std::vector<TourCost> all;
      std::vector<City> listed;
      for (City other = 0; other < costs.size(); ++other)
        if (other != city) all.push_back(costs(city, other));
      std::sort(all.begin(), all.end());

      EXPECT_TRUE(std::is_sorted(near.begin(), near.end(),
                                 [](const Near& a, const Near& b) { return a.first < b.first; }));
      for (std::size_t i = 0; i < near.size(); ++i) {
        EXPECT_EQ(near[i].first, costs(city, near[i].second));
        if (i < 10) {
          EXPECT_EQ(near[i].first, all[i]);
        }
        listed.push_back(near[i].second);
      }
      std::sort(listed.begin(), listed.end());
      EXPECT_EQ(std::adjacent_find(listed.begin(), listed.end()), listed.end());
      EXPECT_FALSE(std::binary_search(listed.begin(), listed.end(), city));
    }
  }
}

TEST(RingCosts, AreThoseOfTheProblemWhateverTheNumbersOfItsStops) {
  const TourProblem problem =
      open_tour(test::closed_tour(test::cases_like_tsplib(1, 5).front()), false);
  const auto order = some_order(problem);

  const RingCosts costs(problem, order);

  ASSERT_FALSE(costs.closed());
  for (City a = 0; a < order.size(); ++a) {
    EXPECT_EQ(costs(costs.start(), a), problem.from_start[order[a]]);
    EXPECT_EQ(costs(a, costs.end_place()), problem.to_end[order[a]]);
    for (City b = 0; b < order.size(); ++b)
      if (a != b) {
        EXPECT_EQ(costs(a, b), problem.cost(order[a], order[b]));
      }
  }
  EXPECT_LT(costs(costs.start(), costs.end_place()), 0);
}

TEST(RingCosts, PlacesThatCannotBeReachedAreInNoNewDirection) {
  TourProblem problem = test::closed_tour(test::cases_of_heaps(1, 3).front());
  const std::size_t count = problem.stops();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      if (i % 2 != j % 2) problem.between[i * count + j] = kNoWay;

  const RingCosts costs(problem, some_order(problem));

  for (City city = 0; city < costs.size(); ++city)
    for (std::size_t i = 10; i < costs.near(city).size(); ++i)
      EXPECT_LT(costs.near(city)[i].first, kNoWay);
}

}  // namespace
}  // namespace skein::refiners
