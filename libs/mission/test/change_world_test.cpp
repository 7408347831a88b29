// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "skein/mission/autonomy.hpp"

namespace skein::mission {
namespace {

ChangeWorld closing(world::Volume volume) {
  ChangeWorld change;
  change.volume = std::move(volume);
  return change;
}

TEST(Volume, HasEveryProblemNamed) {
  EXPECT_TRUE(
      problems_of(closing({"box", {{0, 0}, {100, 0}, {100, 100}, {0, 100}}, 20, 60, {}})).empty());
  EXPECT_EQ(problems_of(closing({"", {{0, 0}}, 5, 5, {}})).size(), 3U);
}

// It would be the home of all who are told of it.
TEST(KnownPlace, IsNotEachUavsOwnHome) {
  const auto problems = [](const std::string& name) {
    ChangeWorld change;
    change.place = KnownPlace{name, {10, 20, 0}};
    return problems_of(change);
  };

  EXPECT_TRUE(problems("homestead").empty());
  EXPECT_EQ(problems("Home"), std::vector<std::string>{"'Home' is each UAV's own home"});
  EXPECT_EQ(problems("zero").size(), 1U);
}

}  // namespace
}  // namespace skein::mission
