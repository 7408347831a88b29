// SPDX-License-Identifier: Apache-2.0
// What fails is made small.
#include "skein/storm_tool/shrink.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace skein::storm_tool {
namespace {

using Numbers = std::vector<int>;

std::vector<Numbers> without_one(const Numbers& all) {
  std::vector<Numbers> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    result.push_back(all);
    result.back().erase(result.back().begin() + static_cast<std::ptrdiff_t>(i));
  }
  return result;
}

bool has(const Numbers& all, int one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

// Whatever it takes to fail is what is left, nothing more.
RC_GTEST_PROP(Shrunk, LeavesJustWhatItTakesToFail, (const std::set<int>& all)) {
  const Numbers whole(all.begin(), all.end());
  Numbers needed;
  for (const int one : whole)
    if (*rc::gen::arbitrary<bool>()) needed.push_back(one);
  const auto fails = [&](const Numbers& less) {
    return std::all_of(needed.begin(), needed.end(), [&](int one) { return has(less, one); });
  };

  RC_ASSERT(shrunk(whole, without_one, fails) == needed);
}

// A part that can go only once another has gone.
TEST(Shrunk, TriesAgainWhatCouldNotGoAtFirst) {
  const auto fails = [](const Numbers& less) {
    return has(less, 3) && (has(less, 1) || !has(less, 2));
  };

  EXPECT_EQ(shrunk(Numbers{1, 2, 3}, without_one, fails), Numbers{3});
}

}  // namespace
}  // namespace skein::storm_tool
