// SPDX-License-Identifier: Apache-2.0
// Each modality against trying everything.
#include "skein/negotiation/modality.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "skein/foundation/random.hpp"
#include "skein/negotiation/area_offer.hpp"
#include "testing/negotiating_team.hpp"

namespace skein::interaction {
namespace {

using testing::names;

Terms terms_of(std::size_t members, Rows parameters) {
  return {"s", 1, "", names(members), {}, std::move(parameters), "a", {}, MissionTime::seconds(1)};
}

const NegotiationModality& modality(const std::string& name) {
  static const Modalities all = standard_modalities();
  return *all.at(name);
}

Row row(const std::string& name, std::vector<double> numbers) {
  return {name, "", std::move(numbers)};
}

/// Calls with every way to choose one of `choices` for each of `n`.
void for_every_choice(std::size_t n, std::size_t choices,
                      const std::function<void(const std::vector<std::size_t>&)>& look) {
  std::vector<std::size_t> chosen(n, 0);
  for (;;) {
    look(chosen);
    std::size_t i = 0;
    while (i < n && ++chosen[i] == choices) chosen[i++] = 0;
    if (i == n) return;
  }
}

constexpr double kNone = std::numeric_limits<double>::infinity();

double number_of(const Rows& offer, const std::string& name, double which) {
  for (const Row& one : offer) {
    if (one.name == name && one.numbers[0] == which) return one.numbers[1];
  }
  return kNone;
}

TEST(RoleAllocation, CostsAsLittleAsAnyAssignmentThatSatisfiesTheArities) {
  Random random(4);
  std::size_t possible = 0, impossible = 0;
  for (int round = 0; round < 300; ++round) {
    const std::size_t n = 2 + random.below(4), roles = 1 + random.below(3);
    Rows parameters;
    for (std::size_t i = 0; i < roles; ++i) {
      const double least = static_cast<double>(random.below(3));
      const double most = random.chance(0.3) ? -1 : least + static_cast<double>(random.below(3));
      parameters.push_back(row("r" + std::to_string(i), {least, most}));
    }
    const Terms terms = terms_of(n, parameters);
    Offers offers;
    for (const std::string& uav : terms.members) {
      for (std::size_t i = 0; i < roles; ++i) {
        const double cost = std::floor(random.uniform(0, 9));  // ties
        if (random.chance(0.8)) offers[uav].push_back(row("r" + std::to_string(i), {cost}));
      }
      offers[uav];
    }
    double least = kNone;
    for_every_choice(n, roles, [&](const std::vector<std::size_t>& chosen) {
      double sum = 0;
      std::vector<double> held(roles, 0);
      for (std::size_t i = 0; i < n; ++i) {
        double cost = kNone;
        for (const Row& one : offers[terms.members[i]]) {
          if (one.name == parameters[chosen[i]].name) cost = one.numbers[0];
        }
        sum += cost;
        ++held[chosen[i]];
      }
      for (std::size_t i = 0; i < roles; ++i) {
        const auto& arity = parameters[i].numbers;
        if (held[i] < arity[0] || (arity[1] >= 0 && held[i] > arity[1])) return;
      }
      least = std::min(least, sum);
    });

    const auto result = modality("role-allocation").settle(terms, offers);

    ASSERT_EQ(result.has_value(), least < kNone) << round;
    (result ? possible : impossible) += 1;
    if (!result) continue;
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ((*result)[i].name, terms.members[i]);
      sum += (*result)[i].numbers[0];
    }
    EXPECT_EQ(sum, least) << round;
  }
  EXPECT_GT(possible, 50U);
  EXPECT_GT(impossible, 50U);
}

TEST(RoleAllocation, TakesTheFirstOfEqualAssignments) {
  const Terms terms = terms_of(2, {row("watch", {1, 1}), row("relay", {1, 1})});
  const Rows same{row("watch", {5}), row("relay", {5})};

  const auto result = modality("role-allocation").settle(terms, {{"a", same}, {"b", same}});

  EXPECT_EQ(*result, (Rows{{"a", "watch", {5}}, {"b", "relay", {5}}}));
}

TEST(RoleAllocation, WhereNoneIsPossibleItSaysWhatEachRoleAsksForAndWhoOffersIt) {
  const Terms terms =
      terms_of(2, {row("watch", {2, -1}), row("relay", {1, 1}), row("map", {0, 2})});

  const auto result =
      modality("role-allocation")
          .settle(terms, {{"a", {row("watch", {5})}}, {"b", {row("watch", {5}), row("map", {3})}}});

  ASSERT_FALSE(result);
  EXPECT_EQ(
      result.error().why,
      "no assignment of roles to the 2 members satisfies the arities: 'watch' is for at "
      "least 2, offered by a and b; 'relay' is for 1, offered by nobody; 'map' is for at most "
      "2, offered by b");
}

TEST(RoleAllocation, WhoDoesNotOfferARoleMaySayWhy) {
  const Terms terms = terms_of(2, {row("watch", {1, 1}), row("relay", {1, 1})});
  const Row blind{"watch", "it has no camera", {}}, lame{"watch", "its camera has failed", {}};
  EXPECT_FALSE(modality("role-allocation").problem_of(terms, {row("relay", {4}), blind}));

  const auto result =
      modality("role-allocation")
          .settle(terms, {{"a", {row("relay", {4}), blind}}, {"b", {lame, row("relay", {3})}}});

  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().why,
              ::testing::HasSubstr("'watch' is for 1, offered by nobody (a: it has no camera; b: "
                                   "its camera has failed); 'relay' is for 1, offered by a and b"));
  const auto with_one = modality("role-allocation")
                            .settle(terms, {{"a", {row("relay", {4}), blind}},
                                            {"b", {row("watch", {9}), row("relay", {3})}}});
  EXPECT_EQ(with_one.value(), (Rows{{"a", "relay", {4}}, {"b", "watch", {9}}}));
}

TEST(RoleAllocation, SixteenUavsAreNoMatter) {
  const Terms terms = terms_of(16, {row("x", {4, 4}), row("y", {4, 4}), row("z", {0, -1})});
  Offers offers;
  for (std::size_t i = 0; i < 16; ++i) {
    const double own = static_cast<double>(i);
    offers[terms.members[i]] = {row("x", {own}), row("y", {20 - own}), row("z", {9})};
  }

  const auto result = modality("role-allocation").settle(terms, offers);

  ASSERT_TRUE(result);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ((*result)[i].text, i < 4 ? "x" : i < 12 ? "z" : "y") << i;
  }
}

struct SlotCost {
  double ranks = kNone, worst = kNone, from = kNone;
  bool operator<(const SlotCost& other) const {
    return std::tie(ranks, worst, from) < std::tie(other.ranks, other.worst, other.from);
  }
};

TEST(TimeInterval, IsTheBestOfAllInstantsForAll) {
  Random random(8);
  std::size_t found = 0;
  for (int round = 0; round < 300; ++round) {
    const std::size_t n = 2 + random.below(3);
    const double duration = 1 + static_cast<double>(random.below(5));
    const Terms terms = terms_of(n, {row("duration", {duration})});
    Offers offers;
    for (const std::string& uav : terms.members) {
      for (std::size_t i = 0; i < 1 + random.below(4); ++i) {
        const double from = static_cast<double>(random.below(30));
        offers[uav].push_back(
            row("interval", {from, from + 2 + static_cast<double>(random.below(10))}));
      }
    }
    // Everything is whole: so are the best instants.
    SlotCost best;
    for (int from = 0; from < 50; ++from) {
      SlotCost cost{0, 0, static_cast<double>(from)};
      for (const auto& [uav, offer] : offers) {
        std::size_t rank = 0;
        while (rank < offer.size() &&
               !(offer[rank].numbers[0] <= from && from + duration <= offer[rank].numbers[1]))
          ++rank;
        const double its = rank == offer.size() ? kNone : static_cast<double>(rank);
        cost.ranks += its;
        cost.worst = std::max(cost.worst, its);
      }
      if (cost.ranks < kNone) best = std::min(best, cost);
    }

    const auto result = modality("time-interval").settle(terms, offers);

    ASSERT_EQ(result.has_value(), best.ranks < kNone) << round;
    if (!result) continue;
    ++found;
    EXPECT_EQ(result->front().numbers[0], best.from) << round;
    EXPECT_GE(result->front().numbers[1], best.from + duration);
  }
  EXPECT_GT(found, 60U);
}

TEST(TimeInterval, OfTheReferenceExampleIsWhatBothWant) {
  const Terms terms = terms_of(2, {row("duration", {900})});
  const Rows same{row("interval", {30, 1400})};

  const auto result = modality("time-interval").settle(terms, {{"a", same}, {"b", same}});

  EXPECT_EQ(*result, (Rows{row("interval", {30, 1400})}));
}

double gap_of(const std::vector<std::size_t>& chosen, std::size_t directions) {
  double least = static_cast<double>(directions);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::size_t apart =
          chosen[i] > chosen[j] ? chosen[i] - chosen[j] : chosen[j] - chosen[i];
      least = std::min(least, static_cast<double>(std::min(apart, directions - apart)));
    }
  }
  return least;
}

TEST(PerceptionPositions, AreSpreadAsFarAsAnyAndThenCostAsLittle) {
  Random random(15);
  std::size_t found = 0;
  for (int round = 0; round < 200; ++round) {
    const std::size_t n = 2 + random.below(3), directions = n + random.below(8);
    const Terms terms = terms_of(n, {row("directions", {static_cast<double>(directions)})});
    Offers offers;
    for (const std::string& uav : terms.members) {
      offers[uav];
      for (std::size_t d = 0; d < directions; ++d) {
        const double cost = std::floor(random.uniform(0, 20));
        if (random.chance(0.6))
          offers[uav].push_back(row("direction", {static_cast<double>(d), cost}));
      }
    }
    double best_gap = 0, least = kNone;
    for_every_choice(n, directions, [&](const std::vector<std::size_t>& chosen) {
      double sum = 0;
      for (std::size_t i = 0; i < n; ++i)
        sum += number_of(offers[terms.members[i]], "direction", static_cast<double>(chosen[i]));
      const double gap = gap_of(chosen, directions);
      if (sum == kNone || gap < best_gap || (gap == best_gap && sum >= least)) return;
      best_gap = gap;
      least = sum;
    });

    const auto result = modality("perception-positions").settle(terms, offers);

    ASSERT_EQ(result.has_value(), best_gap > 0) << round;
    if (!result) continue;
    ++found;
    double sum = 0;
    std::vector<std::size_t> chosen;
    for (const Row& one : *result) {
      chosen.push_back(static_cast<std::size_t>(one.numbers[0]));
      sum += number_of(offers[one.name], "direction", one.numbers[0]);
    }
    EXPECT_EQ(gap_of(chosen, directions), best_gap) << round;
    EXPECT_EQ(sum, least) << round;
  }
  EXPECT_GT(found, 80U);
}

TEST(PerceptionPositions, FourAroundAFireStandCrosswise) {
  const Terms terms = terms_of(4, {row("directions", {24})});
  Offers offers;
  for (std::size_t i = 0; i < 4; ++i) {
    for (int d = 0; d < 24; ++d)
      offers[terms.members[i]].push_back(row("direction", {1.0 * d, 1.0 * std::abs(d - 3)}));
  }

  const auto result = modality("perception-positions").settle(terms, offers);

  std::vector<double> directions;
  for (const Row& one : *result) directions.push_back(one.numbers[0]);
  std::sort(directions.begin(), directions.end());
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(directions[i] - directions[i - 1], 6);
}

TEST(RelayChain, EachLinkIsTakenByOneForTheLeastCost) {
  Random random(16);
  for (int round = 0; round < 200; ++round) {
    const std::size_t n = 2 + random.below(4), links = 1 + random.below(n);
    Rows parameters;
    for (std::size_t i = 0; i < links; ++i)
      parameters.push_back(row("link", {100.0 * static_cast<double>(i), 0, 50}));
    const Terms terms = terms_of(n, parameters);
    Offers offers;
    for (const std::string& uav : terms.members) {
      offers[uav];
      for (std::size_t i = 0; i < links; ++i) {
        if (random.chance(0.8))
          offers[uav].push_back(
              row("link", {static_cast<double>(i), std::floor(random.uniform(0, 9))}));
      }
    }
    double least = kNone;
    for_every_choice(n, links + 1, [&](const std::vector<std::size_t>& chosen) {
      double sum = 0;
      for (std::size_t link = 0; link < links; ++link) {
        if (std::count(chosen.begin(), chosen.end(), link) != 1) return;
      }
      for (std::size_t i = 0; i < n; ++i) {
        if (chosen[i] < links)
          sum += number_of(offers[terms.members[i]], "link", static_cast<double>(chosen[i]));
      }
      least = std::min(least, sum);
    });

    const auto result = modality("relay-chain").settle(terms, offers);

    ASSERT_EQ(result.has_value(), least < kNone);
    if (!result) continue;
    double sum = 0;
    for (const Row& one : *result) {
      if (one.numbers[0] >= 0) sum += number_of(offers[one.name], "link", one.numbers[0]);
    }
    EXPECT_EQ(sum, least);
  }
}

// When one leaves, those who are left form the chain anew.
TEST(RelayChain, IsFormedAnewByThoseWhoAreLeft) {
  const Rows links{row("link", {0, 0, 50}), row("link", {400, 0, 50})};
  const Offers offers{{"a", {row("link", {0, 1}), row("link", {1, 9})}},
                      {"b", {row("link", {0, 9}), row("link", {1, 1})}},
                      {"c", {row("link", {0, 5}), row("link", {1, 5})}}};
  const auto all = modality("relay-chain").settle(terms_of(3, links), offers);
  EXPECT_EQ(*all, (Rows{row("a", {0}), row("b", {1}), row("c", {-1})}));

  Terms without = terms_of(3, links);
  without.members = {"a", "c"};
  const auto left =
      modality("relay-chain").settle(without, {{"a", offers.at("a")}, {"c", offers.at("c")}});

  EXPECT_EQ(*left, (Rows{row("a", {0}), row("c", {1})}));
}

Rows offer_with(void (*change)(Sweeper&)) {
  Sweeper one;
  one.vehicle.cruise_speed = one.vehicle.max_speed = 10;
  one.vehicle.climb_rate = one.vehicle.descent_rate = 3;
  one.vehicle.acceleration = 2;
  one.vehicle.yaw_rate = 1;
  one.vehicle.ceiling = 300;
  one.altitude = one.swath = 50;
  change(one);
  return offer_of(one);
}

struct Wrong {
  std::string modality;
  Rows parameters, offer;  ///< an empty offer: the parameters are wrong
  std::string why;
  friend void PrintTo(const Wrong& one, std::ostream* to) {
    *to << one.modality << ": " << one.why;
  }
};
class WhatMakesNoSense : public ::testing::TestWithParam<Wrong> {};

TEST_P(WhatMakesNoSense, IsSaid) {
  const Wrong& one = GetParam();
  const NegotiationModality& its = modality(one.modality);
  const Terms terms = terms_of(3, one.parameters);

  const auto of_terms = its.problem_of(terms);
  ASSERT_EQ(of_terms.has_value(), one.offer.empty()) << of_terms.value_or("");
  EXPECT_EQ(one.offer.empty() ? *of_terms : its.problem_of(terms, one.offer).value_or("nothing"),
            one.why);
}

const Rows kRoles{row("watch", {1, 1}), row("relay", {0, -1})};
const Rows kDuration{row("duration", {60})};
const Rows kArea{row("area", {0, 0, 100, 0, 100, 100})};
const Rows kDirections{row("directions", {12})};
const Rows kLinks{row("link", {0, 0, 0}), row("link", {1, 1, 1})};

INSTANTIATE_TEST_SUITE_P(
    All, WhatMakesNoSense,
    ::testing::Values(
        Wrong{"role-allocation", {}, {}, "no roles"},
        Wrong{"role-allocation",
              {row("watch", {1, 1}), row("watch", {1, 1})},
              {},
              "role 'watch' is there twice, or has no name"},
        Wrong{
            "role-allocation", {row("watch", {1})}, {}, "role 'watch' has no arity [least, most]"},
        Wrong{"role-allocation",
              {row("watch", {0.5, 1})},
              {},
              "role 'watch' has no arity [least, most]"},
        Wrong{"role-allocation", kRoles, {row("cook", {1})}, "unknown role 'cook'"},
        Wrong{"role-allocation",
              kRoles,
              {row("watch", {1}), row("watch", {2})},
              "two costs of role 'watch'"},
        Wrong{"role-allocation", kRoles, {row("watch", {-1})}, "role 'watch' has no cost"},
        Wrong{"role-allocation", kRoles, {row("watch", {})}, "role 'watch' has no cost"},
        Wrong{"time-interval", {}, {}, "not one 'duration' with 1 numbers"},
        Wrong{"time-interval", {row("duration", {0})}, {}, "it lasts no time"},
        Wrong{"time-interval", kDuration, {row("interval", {5})}, "'interval' is no interval"},
        Wrong{"time-interval",
              kDuration,
              {row("interval", {5, 5})},
              "an interval ends before it begins"},
        Wrong{"area-sharing", {row("area", {0, 0, 1})}, {}, "'area' is no area of corners x, y"},
        Wrong{"area-sharing", {}, {}, "no areas"},
        Wrong{"area-sharing",
              {row("zone", {0, 0, 1, 0, 1, 1})},
              {},
              "'zone' is no area of corners x, y"},
        Wrong{"area-sharing",
              {row("area", {0, 0, 100, 0, 50, 10, 100, 100})},
              {},
              "the area is not convex"},
        Wrong{"area-sharing", kArea, {row("speed", {1})}, "not one 'start' with 2 numbers"},
        Wrong{"area-sharing",
              kArea,
              {row("start", {1, 1}), row("sweep", {50, 40, 0}), row("vehicle", {1})},
              "not one 'vehicle' with 19 numbers"},
        Wrong{"area-sharing", kArea, offer_with([](Sweeper& one) { one.busy = -1; }),
              "busy: a time is at least 0"},
        Wrong{"perception-positions",
              {row("directions", {2})},
              {},
              "not from as many directions as members to 72"},
        Wrong{"perception-positions",
              {row("directions", {4.5})},
              {},
              "not from as many directions as members to 72"},
        Wrong{"perception-positions",
              kDirections,
              {row("direction", {12, 1})},
              "there is no such direction, only 0 to 11"},
        Wrong{"perception-positions",
              kDirections,
              {row("direction", {1, 1}), row("direction", {1, 2})},
              "two costs of one direction"},
        Wrong{"perception-positions",
              kDirections,
              {row("direction", {1, -1})},
              "a direction costs less than nothing"},
        Wrong{"relay-chain", {}, {}, "no links"},
        Wrong{"relay-chain", {row("link", {0, 0})}, {}, "'link' is no link"},
        Wrong{"relay-chain",
              {row("link", {0, 0, 0}), row("link", {0, 0, 0}), row("link", {0, 0, 0}),
               row("link", {0, 0, 0})},
              {},
              "more links than members"},
        Wrong{"relay-chain", kLinks, {row("direction", {1, 1})}, "'direction' is no link"},
        Wrong{
            "relay-chain", kLinks, {row("link", {1.5, 1})}, "there is no such link, only 0 to 1"}));

}  // namespace
}  // namespace skein::interaction
