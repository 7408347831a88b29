// SPDX-License-Identifier: Apache-2.0
// Work in processes of its own comes back, whatever becomes of them.
#include "skein/workers/workers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <map>

namespace skein::workers {
namespace {

using ::testing::HasSubstr;

// What `count` pieces of work said, by their numbers.
std::map<std::uint64_t, Outcome> done(int count, const std::function<std::string(int)>& work,
                                      const Limits& limits) {
  std::map<std::uint64_t, Outcome> all;
  int given = 0;
  do_apart(
      [&]() -> std::optional<Work> {
        if (given == count) return std::nullopt;
        return [&work, number = given++] { return work(number); };
      },
      limits,
      [&](std::uint64_t number, const Outcome& outcome) {
        EXPECT_FALSE(all.contains(number));
        all[number] = outcome;
      });
  return all;
}

TEST(DoApart, TellsOfEveryPieceOnceByItsNumber) {
  for (const int jobs : {1, 3, 20}) {
    const auto all =
        done(11, [](int number) { return "piece " + std::to_string(number); }, {jobs, 60});

    ASSERT_EQ(all.size(), 11U);
    for (const auto& [number, outcome] : all) {
      EXPECT_EQ(outcome.said, "piece " + std::to_string(number));
      EXPECT_EQ(outcome.end, Outcome::End::kDone);
    }
  }
}

TEST(DoApart, CarriesMoreThanAPipeHolds) {
  const std::string much(3'000'000, 'x');

  EXPECT_EQ(do_apart([&] { return much; }, {}).said, much);
}

TEST(DoApart, LeavesNothingOfItselfInTheCaller) {
  int here = 1;

  do_apart(
      [&] {
        here = 2;
        return std::string();
      },
      {});

  EXPECT_EQ(here, 1);
}

TEST(DoApart, SaysOfAProcessThatDiesByWhat) {
  const auto all = done(3,
                        [](int number) {
                          if (number == 1) std::raise(SIGKILL);
                          return std::string("good");
                        },
                        {2, 60});

  EXPECT_EQ(all.at(0).said, "good");
  EXPECT_EQ(all.at(1).end, Outcome::End::kDied);
  EXPECT_THAT(all.at(1).why, HasSubstr("Killed"));
  EXPECT_EQ(all.at(2).said, "good");
}

TEST(DoApart, ByProcessorTimeEndsWhatDoesNotEnd) {
  const Outcome outcome = do_apart(
      [] {
        volatile std::uint64_t count = 0;
        while (count < UINT64_MAX) count = count + 1;
        return std::string();
      },
      {1, 1});

  EXPECT_EQ(outcome.end, Outcome::End::kHung);
  EXPECT_THAT(outcome.why, HasSubstr("1 s of processor time"));
}

TEST(DoApart, OfNothingTellsNothing) {
  EXPECT_TRUE(done(0, [](int) { return std::string(); }, {}).empty());
}

}  // namespace
}  // namespace skein::workers
