// SPDX-License-Identifier: Apache-2.0
#include "wait_starts.hpp"

#include <gtest/gtest.h>

namespace skein::decision_node {
namespace {

class WaitingAgain : public ::testing::Test {
 protected:
  /// A task that waits since then for synchronisation 7, and was seen last at `until`.
  double wait(std::uint64_t task, double since, double until, std::uint64_t synchronisation = 7) {
    const executive::Wait wait{
        functional::TaskId(task), synchronisation, MissionTime::seconds(since), {"heliv"}};
    const double counts_from = (starts.start_of(wait) - MissionTime()).to_seconds();
    starts.see({wait}, MissionTime::seconds(since));
    starts.see({wait}, MissionTime::seconds(until));
    return counts_from;
  }
  WaitStarts starts;
};

TEST_F(WaitingAgain, GoesOnWithTheWaitBeforeIt) {
  EXPECT_DOUBLE_EQ(wait(1, 100, 160), 100);
  EXPECT_DOUBLE_EQ(wait(2, 165, 220), 100);
  EXPECT_DOUBLE_EQ(wait(3, 240, 250), 100);
}

TEST_F(WaitingAgain, LongAfterItIsAnotherWait) {
  wait(1, 100, 160);
  EXPECT_DOUBLE_EQ(wait(2, 181, 200), 181);
}

TEST_F(WaitingAgain, HoweverLongNobodyLookedTheSameTaskIsTheSameWait) {
  wait(1, 100, 160);
  EXPECT_DOUBLE_EQ(wait(1, 100, 1000), 100);
  EXPECT_DOUBLE_EQ(wait(2, 1010, 1011), 100);
}

TEST_F(WaitingAgain, AfterAllHaveComeIsAnotherWait) {
  wait(1, 100, 160);
  starts.met(functional::TaskId(1));
  EXPECT_DOUBLE_EQ(wait(2, 165, 170), 165);
}

TEST_F(WaitingAgain, ForAnotherSynchronisationIsAnotherWait) {
  wait(1, 100, 160, 7);
  EXPECT_DOUBLE_EQ(wait(2, 165, 170, 8), 165);
}

}  // namespace
}  // namespace skein::decision_node
