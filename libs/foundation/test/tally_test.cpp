// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/tally.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace skein {
namespace {

using ::testing::ElementsAre;

TEST(Tally, NamesTheFirstTheTenthTheHundredthTimeWithTheCount) {
  Tally<std::string> tally(8);
  std::vector<std::string> named;
  for (int i = 0; i < 150; ++i)
    if (const auto count = tally.count("it")) named.push_back(*count);

  EXPECT_THAT(named, ElementsAre("", " (10 times)", " (100 times)"));
}

TEST(Tally, CountsEachKindByItself) {
  Tally<int> tally(8);
  for (int i = 0; i < 9; ++i) tally.count(1);

  EXPECT_EQ(tally.count(2), "");
  EXPECT_EQ(tally.count(1), " (10 times)");
}

TEST(Tally, KindsWithoutEndAreNotNamedAndTheFirstGoOn) {
  Tally<int> tally(2);
  for (int kind = 0; kind < 10; ++kind) tally.count(kind);

  EXPECT_EQ(tally.count(7), std::nullopt);
  for (int i = 0; i < 8; ++i) tally.count(1);
  EXPECT_EQ(tally.count(1), " (10 times)");
}

}  // namespace
}  // namespace skein
