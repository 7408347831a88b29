// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/rising.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace skein {
namespace {

MissionTime at(std::int64_t milliseconds) {
  return MissionTime() + Duration::milliseconds(milliseconds);
}

TEST(RisingNumbers, AreNotBelowMissionTime) {
  Rising numbers;
  EXPECT_EQ(numbers.next(at(-5)), 1U);
  EXPECT_EQ(numbers.next(at(0)), 2U);
  EXPECT_EQ(numbers.next(at(700)), 700U);
  EXPECT_EQ(numbers.next(at(700)), 701U);
}

// Who gives out less than one a millisecond.
RC_GTEST_PROP(RisingNumbersLaw, IncreaseAlsoOverLivesWithoutMemory, ()) {
  const auto pauses = *rc::gen::container<std::vector<std::pair<bool, int>>>(
      rc::gen::pair(rc::gen::arbitrary<bool>(), rc::gen::inRange(2, 10'000)));
  Rising numbers;
  std::int64_t now = 0;
  std::uint64_t last = numbers.next(at(now));
  for (const auto& [dies, pause] : pauses) {
    if (dies) numbers = {};
    now += pause;
    const std::uint64_t next = numbers.next(at(now));
    RC_ASSERT(next > last);
    last = next;
  }
}

}  // namespace
}  // namespace skein
