// SPDX-License-Identifier: Apache-2.0
#include "viewpoint/choice.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

namespace skein::refiners {
namespace {

using Utilities = std::vector<std::optional<double>>;

bool are_apart(const std::vector<std::size_t>& chosen, std::size_t gap, std::size_t slots) {
  for (const std::size_t a : chosen)
    for (const std::size_t b : chosen) {
      const std::size_t turn = a > b ? a - b : b - a;
      if (a != b && std::min(turn, slots - turn) < gap) return false;
    }
  return true;
}

double sum_of(const std::vector<std::size_t>& chosen, const Utilities& utilities) {
  double sum = 0;
  for (const std::size_t slot : chosen) sum += utilities[slot].value_or(-1e9);
  return sum;
}

/// The most slots up to `count`, and of those the greatest sum, of all subsets.
std::pair<std::size_t, double> by_trying_all(const Utilities& utilities, std::size_t gap,
                                             std::size_t count) {
  std::pair<std::size_t, double> best{0, 0};
  for (std::uint32_t subset = 1; subset < 1U << utilities.size(); ++subset) {
    std::vector<std::size_t> chosen;
    for (std::size_t slot = 0; slot < utilities.size(); ++slot)
      if ((subset >> slot & 1U) != 0) chosen.push_back(slot);
    const bool possible = std::all_of(chosen.begin(), chosen.end(), [&](std::size_t slot) {
      return utilities[slot].has_value();
    });
    if (!possible || chosen.size() > count || !are_apart(chosen, gap, utilities.size())) continue;
    best =
        std::max(best, {chosen.size(), chosen.size() < best.first ? 0 : sum_of(chosen, utilities)},
                 [](const auto& a, const auto& b) {
                   return a.first != b.first ? a.first < b.first : a.second < b.second;
                 });
  }
  return best;
}

TEST(ChooseAround, OfNothingIsNothing) {
  EXPECT_TRUE(choose_around({}, 3, 2).empty());
  EXPECT_TRUE(choose_around(Utilities(5), 1, 2).empty());
}

TEST(ChooseAround, GivesUpABetterOneForRoom) {
  //  Slot 1 is the best, but leaves room for no second one three slots away.
  const Utilities utilities = {0.5, 0.9, std::nullopt, 0.5, std::nullopt, std::nullopt};

  EXPECT_EQ(choose_around(utilities, 3, 2).size(), 2u);
  EXPECT_EQ(sum_of(choose_around(utilities, 3, 2), utilities), 1.0);
  EXPECT_EQ(choose_around(utilities, 3, 1), std::vector<std::size_t>{1});
}

TEST(ChooseAround, CountsTheGapAcrossTheStartToo) {
  const Utilities utilities = {1.0, std::nullopt, std::nullopt, std::nullopt, 1.0};

  EXPECT_EQ(choose_around(utilities, 2, 2).size(), 1u) << "the last is next to the first";
}

RC_GTEST_PROP(ChooseAround, IsTheBestOfAllSubsets, ()) {
  const auto slots = *rc::gen::inRange<std::size_t>(1, 12);
  const auto gap = *rc::gen::inRange<std::size_t>(1, 7);
  const auto count = *rc::gen::inRange<std::size_t>(1, 6);
  Utilities utilities(slots);
  for (auto& utility : utilities)
    if (*rc::gen::inRange(0, 4) > 0) utility = *rc::gen::inRange(-20, 100) * 0.01;

  const auto chosen = choose_around(utilities, gap, count);

  const auto [most, greatest] = by_trying_all(utilities, gap, count);
  RC_ASSERT(chosen.size() == most);
  RC_ASSERT(are_apart(chosen, gap, slots));
  RC_ASSERT(std::abs(sum_of(chosen, utilities) - greatest) < 1e-9);
}

}  // namespace
}  // namespace skein::refiners
