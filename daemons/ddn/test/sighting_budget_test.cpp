// SPDX-License-Identifier: Apache-2.0
#include "skein/ddn/sighting_budget.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace skein::ddn {
namespace {

MissionTime at(double seconds) { return MissionTime() + Duration::seconds(seconds); }

TEST(SightingBudget, TheFirstTwentyLooksThatFindSomethingAreEventsThenOneEachFiveSeconds) {
  SightingBudget budget;
  int taken = 0;
  for (int i = 0; i < 40; ++i) taken += budget.take("ir", at(100)) ? 1 : 0;
  EXPECT_EQ(taken, 20);

  EXPECT_FALSE(budget.take("ir", at(104.9)));
  EXPECT_TRUE(budget.take("ir", at(105)));
  EXPECT_FALSE(budget.take("ir", at(105)));
}

TEST(SightingBudget, EachDeviceHasItsOwn) {
  SightingBudget budget;
  while (budget.take("ir", at(0))) {
  }

  EXPECT_TRUE(budget.take("visible", at(0)));
}

RC_GTEST_PROP(SightingBudget, NoStretchOfTimeHasMoreThanItsShareAndWhoIsSeldomIsNeverRefused, ()) {
  const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 20'000));
  SightingBudget budget;
  std::vector<double> taken;
  double now = 0;
  for (const int step : steps) {
    now += step / 1000.0;
    const bool is_seldom = step >= 5'000 || taken.empty();
    const bool is_taken = budget.take("ir", at(now));
    RC_ASSERT(is_taken || !is_seldom);
    if (is_taken) taken.push_back(now);
  }
  for (std::size_t i = 0; i < taken.size(); ++i)
    for (std::size_t j = i; j < taken.size(); ++j)
      RC_ASSERT(static_cast<double>(j - i + 1) <= 20 + (taken[j] - taken[i]) / 5 + 1e-6);
}

}  // namespace
}  // namespace skein::ddn
