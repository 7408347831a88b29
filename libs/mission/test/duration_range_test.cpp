// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/duration_range.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace skein::mission {
namespace {

TEST(DurationRange, IsTwoFiguresWithTwoPointsBetween) {
  EXPECT_EQ(duration_range_from("60..120"), (DurationRange{60, 120}));
  EXPECT_EQ(duration_range_from("0.5..2.25"), (DurationRange{0.5, 2.25}));
}

TEST(DurationRange, IsNothingElse) {
  for (const char* text :
       {"", "60", "..", "60..", "..120", "60..120 ", "a..b", "60...120", "-1..5", "P1"})
    EXPECT_EQ(duration_range_from(text), std::nullopt) << text;
}

TEST(DurationRange, OfAnArgumentIsThatOfItsText) {
  EXPECT_EQ(duration_range_of(Argument("60..120")), (DurationRange{60, 120}));
  EXPECT_EQ(duration_range_of(Argument(60.0)), std::nullopt);
}

RC_GTEST_PROP(DurationRange, IsReadBackFromItsFigures, (unsigned least, unsigned most)) {
  RC_ASSERT(duration_range_from(std::to_string(least) + ".." + std::to_string(most)) ==
            (DurationRange{static_cast<double>(least), static_cast<double>(most)}));
}

}  // namespace
}  // namespace skein::mission
