// SPDX-License-Identifier: Apache-2.0
// A budget holds: what is asked for so many seconds of processor time ends soon after them, with an
// answer. (How soon is in docs/performance.md; here with room for a machine that is busy.)
#include <gtest/gtest.h>

#include <ctime>

#include "coverage_cases.hpp"
#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

constexpr double kRoom = 0.5;  // [s]; without the clock in every loop: 4 to 9 s

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

TEST(BudgetLaw, SweepsOfAreasOfManyCornersEndInTime) {
  const auto world = testing::level_world(1000);
  for (const std::size_t corners : {300UL, 1000UL, 2000UL})
    for (const double budget : {0.05, 0.2}) {
      Random random(corners, "star");
      CoverageQuery query;
      query.vehicle = testing::helicopter();
      query.vehicle.energy.capacity *= 1000;
      query.area = testing::random_star(random, corners, 300, 900);
      query.swath = 20;
      query.altitude = 60;
      const double began = processor_seconds();
      Setting setting{world, {}, 1, nullptr};
      setting.budget.time_is_up = [&] { return processor_seconds() - began > budget; };

      const auto refined = refine(query, setting);

      EXPECT_LT(processor_seconds() - began, budget + kRoom) << corners << " corners";
      ASSERT_TRUE(refined) << refined.error().why;
      EXPECT_TRUE(refined->effort.cut_short || corners == 300) << corners;
      EXPECT_GT(testing::covered(query, refined->task, 2000), 0.999);
    }
}

}  // namespace
}  // namespace skein::refiners
