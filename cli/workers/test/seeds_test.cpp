// SPDX-License-Identifier: Apache-2.0
// Seeds are a range, or one.
#include "skein/workers/seeds.hpp"

#include <gtest/gtest.h>

namespace skein::workers {
namespace {

TEST(SeedsOf, AreARangeOrOne) {
  EXPECT_EQ(seeds_of("3..17"), std::pair(std::uint64_t{3}, std::uint64_t{17}));
  EXPECT_EQ(seeds_of("3"), std::pair(std::uint64_t{3}, std::uint64_t{3}));
  for (const char* none : {"", "x", "5..3", "1..", "..4", "1..2x", "-1..3"})
    EXPECT_EQ(seeds_of(none), std::nullopt) << none;
}

}  // namespace
}  // namespace skein::workers
