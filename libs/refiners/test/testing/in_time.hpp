// SPDX-License-Identifier: Apache-2.0
// Whether a refiner ends soon after the processor time that it is given.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "skein/refiners/refinement.hpp"
#include "skein/refiners/setting.hpp"
#include "test_cases.hpp"

namespace skein::refiners::testing {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kRoom = 0.5;  // [s]
#else
constexpr double kRoom = 0.05;  // [s]
#endif
/// The least of so many is told: what else the machine does costs processor time too, since caches
/// and cores are shared.
constexpr int kTries = 8;
/// What the work of `work_seconds` takes on machine A with nothing beside it [s].
constexpr double kUsualWork = 0.003;
constexpr double kBudgets[] = {0, 0.02, 0.15};  // [s]

inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A fixed piece of work, in and out of the caches.
inline double work_seconds() {
  static std::vector<std::uint32_t> table(1U << 20U, 1);
  const double began = processor_seconds();
  std::uint32_t state = 1;
  for (int i = 0; i < 1'000'000; ++i) {
    state = state * 1664525U + 1013904223U;
    table[state >> 12U] += state;
  }
  return processor_seconds() - began;
}

/// How many times as long as usual everything takes here and now, at least once: who shares the
/// cores and the caches of a machine makes its processor seconds longer.
inline double slowness() { return std::max(1.0, work_seconds() / kUsualWork); }

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
      const double by = processor_seconds() - began - budget;
      late = std::min(late, by > kRoom ? by / slowness() : by);
      EXPECT_TRUE(says_something(outcome)) << what;
    }
    if (skein::testing::long_tests() && late > 0.02)
      std::printf("%5.0f ms late of %g s: %s\n", 1e3 * late, budget, what.c_str());
    EXPECT_LT(late, kRoom) << what << " with " << budget << " s";
  }
}

}  // namespace skein::refiners::testing
