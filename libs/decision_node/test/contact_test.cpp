// SPDX-License-Identifier: Apache-2.0
#include "skein/decision_node/contact.hpp"

#include <gtest/gtest.h>

#include <string>

namespace skein::decision_node {
namespace {

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

// What is heard when (seconds; negative: lost), asked at `ask`.
struct Case {
  std::string name;
  ContactPolicy policy;
  std::vector<double> heard;
  double ask;
  bool due;
};

class ContactWatchTable : public ::testing::TestWithParam<Case> {};

TEST_P(ContactWatchTable, GivesThePolicyOnceTheSilenceHasLasted) {
  const Case& c = GetParam();
  ContactWatch watch(c.policy, Duration::seconds(30));

  for (const double instant : c.heard) watch.ground_heard(instant > 0, at(std::abs(instant)));

  EXPECT_EQ(watch.due(at(c.ask)), c.due ? std::optional(c.policy) : std::nullopt);
}

constexpr auto kHold = ContactPolicy::kHold;
INSTANTIATE_TEST_SUITE_P(
    ContactWatch, ContactWatchTable,
    ::testing::Values(Case{"nothing_is_lost_before_anything_was_heard", kHold, {}, 1000, false},
                      Case{"not_yet", kHold, {1, -10}, 39.9, false},
                      Case{"at_the_instant", kHold, {1, -10}, 40, true},
                      Case{"later", kHold, {1, -10}, 400, true},
                      Case{"regained_before", kHold, {1, -10, 39}, 400, false},
                      Case{"lost_again_counts_anew", kHold, {1, -10, 20, -25}, 54, false},
                      Case{"lost_again_and_long_enough", kHold, {1, -10, 20, -25}, 55, true},
                      Case{"told_twice_counts_from_the_first", kHold, {1, -10, -35}, 40, true},
                      Case{"return_home", ContactPolicy::kReturn, {1, -10}, 40, true},
                      Case{"continue_never", ContactPolicy::kContinue, {1, -10}, 4000, false}),
    [](const auto& one) { return one.param.name; });

TEST(ContactWatch, GivesItAtMostOncePerLoss) {
  ContactWatch watch(ContactPolicy::kHold, Duration::seconds(30));
  watch.ground_heard(false, at(10));

  EXPECT_TRUE(watch.due(at(40)).has_value());
  EXPECT_FALSE(watch.due(at(41)).has_value());
  watch.ground_heard(true, at(50));
  watch.ground_heard(false, at(60));
  EXPECT_TRUE(watch.due(at(90)).has_value());
}

TEST(ContactWatch, AsksToBeWokenExactlyWhenItIsDue) {
  ContactWatch watch(ContactPolicy::kReturn, Duration::seconds(30));

  EXPECT_EQ(watch.next_wakeup(), std::nullopt);
  watch.ground_heard(false, at(10));
  EXPECT_EQ(watch.next_wakeup(), at(40));
  (void)watch.due(at(40));
  EXPECT_EQ(watch.next_wakeup(), std::nullopt);
}

TEST(ContactWatch, OfPolicyContinueNeverAsksToBeWoken) {
  ContactWatch watch(ContactPolicy::kContinue, Duration::seconds(30));

  watch.ground_heard(false, at(10));

  EXPECT_EQ(watch.next_wakeup(), std::nullopt);
}

}  // namespace
}  // namespace skein::decision_node
