// SPDX-License-Identifier: Apache-2.0
#include "adapters/cyclonedds/bounded_call.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <memory>

namespace skein::blackboard::cyclonedds {
namespace {

constexpr Duration kLong = Duration::milliseconds(30'000), kShort = Duration::milliseconds(20);

TEST(BoundedCall, OneThatReturnsIsCarriedOutBeforeItsCallerGoesOn) {
  std::atomic<bool> done = false;

  EXPECT_TRUE(returns_within(kLong, [&] { done = true; }));

  EXPECT_TRUE(done);
}

TEST(BoundedCall, OneThatDoesNotReturnInTimeIsLeftToItself) {
  auto gate = std::make_shared<std::promise<void>>();
  auto ended = std::make_shared<std::promise<void>>();

  const bool returned = returns_within(kShort, [gate = gate->get_future().share(), ended] {
    gate.wait();
    ended->set_value();
  });

  EXPECT_FALSE(returned);
  gate->set_value();
  ended->get_future().wait();  // it went on meanwhile
}

}  // namespace
}  // namespace skein::blackboard::cyclonedds
