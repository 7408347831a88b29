// SPDX-License-Identifier: Apache-2.0
// Whether a refiner ends soon after the processor time that it is given.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "processor_time.hpp"
#include "skein/refiners/refinement.hpp"
#include "skein/refiners/setting.hpp"
#include "test_cases.hpp"

namespace skein::refiners::testing {

using skein::testing::kRoom;
using skein::testing::processor_seconds;

/// The least of so many is told: what else the machine does costs processor time too, since caches
/// and cores are shared.
constexpr int kTries = 8;
constexpr double kBudgets[] = {0, 0.02, 0.15};  // [s]

template <class Task>
bool says_something(const Outcome<Task>& outcome) {
  return outcome || !outcome.error().why.empty();
}

/// By how much it is late, at best of a few times: a machine that is busy only adds.
template <class Query>
void expect_in_time(const Query& query, const world::World& world, const std::string& what) {
  for (const double budget : kBudgets) {
    double late = 1e9;
    for (int i = 0; i < kTries && late > kRoom; ++i) {
      const double began = processor_seconds();
      Setting setting{world, {}, 1, nullptr};
      setting.budget.time_is_up = [&] { return processor_seconds() - began > budget; };
      const auto outcome = refine(query, setting);
      late = std::min(late, skein::testing::late_here(processor_seconds() - began - budget));
      EXPECT_TRUE(says_something(outcome)) << what;
    }
    if (skein::testing::long_tests() && late > 0.02)
      std::printf("%5.0f ms late of %g s: %s\n", 1e3 * late, budget, what.c_str());
    EXPECT_LT(late, kRoom) << what << " with " << budget << " s";
  }
}

}  // namespace skein::refiners::testing
