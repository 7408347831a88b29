// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/shortest_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace skein {
namespace {

TEST(ShortestText, HasNoMoreDigitsThanItNeeds) {
  EXPECT_EQ(shortest_text(0.1), "0.1");
  EXPECT_EQ(shortest_text(120), "120");
  EXPECT_EQ(shortest_text(-2.5), "-2.5");
  EXPECT_EQ(shortest_text(-0.0), "0");
}

RC_GTEST_PROP(ShortestText, IsReadAsTheSameNumber, (std::uint64_t bits)) {
  const auto number = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(number));
  RC_ASSERT(std::strtod(shortest_text(number).c_str(), nullptr) == number);
}

}  // namespace
}  // namespace skein
