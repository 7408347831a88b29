// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/id.hpp"

#include <gtest/gtest.h>

#include <type_traits>
#include <unordered_set>

namespace skein {
namespace {

using Apple = Id<struct AppleTag>;
using Pear = Id<struct PearTag>;

TEST(Id, TwoKindsDoNotMix) {
  static_assert(!std::is_convertible_v<Apple, Pear>);
  static_assert(!std::is_convertible_v<std::uint32_t, Apple>);
  static_assert(!std::is_constructible_v<Apple, Pear>);
}

TEST(Id, OrderAndHashFollowTheValue) {
  EXPECT_LT(Apple(1), Apple(2));
  EXPECT_EQ((std::unordered_set<Apple>{Apple(1), Apple(1), Apple(2)}).size(), 2U);
  EXPECT_EQ(to_text(Apple(7)), "7");
}

}  // namespace
}  // namespace skein
