// SPDX-License-Identifier: Apache-2.0
#include "adapters/rtps/pace.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace skein::blackboard::rtps {
namespace {

using std::chrono::milliseconds;

TEST(Pace, OnAChannelWithoutLimitIsTheUsualOne) {
  const Pace usual = pace_of(0.0);
  EXPECT_EQ(usual.announcement, milliseconds(1000));
  EXPECT_EQ(usual.lease, milliseconds(5000));
  EXPECT_EQ(usual.heartbeat, milliseconds(50));
}

TEST(Pace, IsThatOfTheNarrowestChannel) {
  TransportPlan plan;
  for (const double capacity : {0.0, 1e6, 9'600.0, 2e6}) {
    plan.channels.emplace_back();
    plan.channels.back().capacity = capacity;
  }
  EXPECT_EQ(pace_of(plan).announcement, pace_of(9'600.0).announcement);
  EXPECT_EQ(pace_of(TransportPlan()).heartbeat, pace_of(0.0).heartbeat);
}

RC_GTEST_PROP(Pace, IsSlowerTheNarrowerTheChannelAndALeaseOutlivesAnnouncementsThatAreLost, ()) {
  const double narrow = *rc::gen::inRange(1'200, 10'000'000);
  const double wide = narrow * *rc::gen::inRange(1, 10);
  const Pace slow = pace_of(narrow), fast = pace_of(wide), usual = pace_of(0.0);
  for (const auto period : {&Pace::announcement, &Pace::lease, &Pace::heartbeat}) {
    const milliseconds of_slow = slow.*period, of_fast = fast.*period, of_usual = usual.*period;
    RC_ASSERT(of_slow >= of_fast);
    RC_ASSERT(of_fast >= of_usual);
  }
  RC_ASSERT(slow.lease >= 4 * slow.announcement);
}

}  // namespace
}  // namespace skein::blackboard::rtps
