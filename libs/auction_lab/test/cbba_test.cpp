// SPDX-License-Identifier: Apache-2.0
// Our sales beside CBBA, on the aim that both make small: the sum of the tours.
#include "testing/cbba.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "test_cases.hpp"
#include "testing/team.hpp"

namespace skein::auction {
namespace {

using namespace testing;

struct Places {
  std::vector<Place> begins, tasks;
};

Places places_of(const Team& team) {
  Places places;
  for (const FlatVehicle& vehicle : team.vehicles) places.begins.push_back(vehicle.begin);
  for (const Task& task : team.lot.tasks) places.tasks.push_back(task.at);
  return places;
}

TEST(Cbba, ATaskForEachGoesToTheNearest) {
  Cbba cbba({{0, 0}, {100, 0}}, {{90, 0}, {10, 0}});
  cbba.run();

  EXPECT_TRUE(cbba.complete());
  EXPECT_DOUBLE_EQ(cbba.sum(), 20);
}

TEST(Cbba, WhoIsOutbidReleasesWhatItAddedAfterwards) {
  // The first would go 30, 31, 32; the second stands beside 31 and 32.
  Cbba cbba({{0, 0}, {32, 1}}, {{30, 0}, {31, 0}, {32, 0}});
  cbba.run();

  EXPECT_TRUE(cbba.complete());
  EXPECT_LT(cbba.sum(), 10);
}

TEST(Cbba, OurSalesComeNearerToTheLeastSumForMoreMessages) {
  double ours = 0, theirs = 0, worst_ours = 0, worst_theirs = 0;
  std::uint64_t our_messages = 0, their_messages = 0;
  const auto count = skein::testing::cases<std::uint64_t>(10, 300);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const Team team = random_team(3, 9, seed);
    const Places places = places_of(team);
    Cbba cbba(places.begins, places.tasks);
    cbba.run();
    ASSERT_TRUE(cbba.complete()) << seed;
    const SaleOutcome outcome = team.sell();
    const double least = best_tours(places.begins, places.tasks, false);
    ours += outcome.value.first / least - 1;
    theirs += cbba.sum() / least - 1;
    worst_ours = std::max(worst_ours, outcome.value.first / least - 1);
    worst_theirs = std::max(worst_theirs, cbba.sum() / least - 1);
    our_messages += outcome.messages;
    their_messages += cbba.messages();
    EXPECT_GE(cbba.sum(), least - 1e-9);
  }
  const auto each = static_cast<double>(count);
  std::printf(
      "gap mean, worst; messages: auction %.2f %%, %.2f %%; %.0f; CBBA %.2f %%, %.2f %%; %.0f\n",
      100 * ours / each, 100 * worst_ours, static_cast<double>(our_messages) / each,
      100 * theirs / each, 100 * worst_theirs, static_cast<double>(their_messages) / each);

  EXPECT_LT(ours, theirs);
  EXPECT_GT(our_messages, their_messages);
}

}  // namespace
}  // namespace skein::auction
