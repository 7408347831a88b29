// SPDX-License-Identifier: Apache-2.0
// Contradictions against the closure of the precedences.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "skein/foundation/random.hpp"
#include "testing/road_team.hpp"

namespace skein::auction {
namespace {

constexpr std::uint32_t kCount = 6;

Lot tangled(std::uint64_t seed) {
  Random random(seed, "contradictions");
  Lot lot;
  for (std::uint32_t n = 0; n < kCount; ++n) {
    RoadTask task = a_task(n).lasting(random.uniform(1, 10)).from(random.uniform(0, 20));
    if (random.chance(0.4)) task.by(random.uniform(10, 60));
    lot.tasks.push_back(task);
  }
  const auto edges = random.below(8);
  for (std::uint64_t i = 0; i < edges; ++i) {
    lot.precedences.push_back({TaskNumber(static_cast<std::uint32_t>(random.below(kCount))),
                               TaskNumber(static_cast<std::uint32_t>(random.below(kCount)))});
  }
  return lot;
}

bool has(const Lot& lot, TaskNumber first, TaskNumber then) {
  const auto& all = lot.precedences;
  return std::find(all.begin(), all.end(), Precedence{first, then}) != all.end();
}

// Whom each must wait for, by repeated union (Warshall).
std::vector<std::vector<bool>> waits_for(const Lot& lot) {
  std::vector<std::vector<bool>> waits(kCount, std::vector<bool>(kCount));
  for (const auto& [first, then, delay] : lot.precedences)
    waits[then.value()][first.value()] = true;
  for (std::uint32_t via = 0; via < kCount; ++via) {
    for (std::uint32_t a = 0; a < kCount; ++a) {
      for (std::uint32_t b = 0; b < kCount; ++b) {
        if (waits[a][via] && waits[via][b]) waits[a][b] = true;
      }
    }
  }
  return waits;
}

bool is_circle(const Contradiction& one) {
  return one.chain.size() > 1 && one.chain.front() == one.chain.back();
}

RC_GTEST_PROP(ContradictionsOracle, ACircleIsNamedIfThereIsOneAndItIsOne, (std::uint64_t seed)) {
  const Lot lot = tangled(seed);
  const auto waits = waits_for(lot);
  bool circular = false;
  for (std::uint32_t n = 0; n < kCount; ++n) circular = circular || waits[n][n];

  const auto found = contradictions(lot);

  RC_ASSERT(std::count_if(found.begin(), found.end(), is_circle) == (circular ? 1 : 0));
  for (const Contradiction& one : found) {
    for (std::size_t i = 1; i < one.chain.size(); ++i) {
      RC_ASSERT(has(lot, one.chain[i - 1], one.chain[i]));
    }
    if (is_circle(one)) RC_ASSERT(one.why == "each is to end before the next begins");
  }
}

// The earliest end of a task is the longest of all chains that lead to it.
double longest(const Lot& lot, std::uint32_t task) {
  const Task& own = lot.tasks[task];
  double end = own.earliest + own.duration;
  for (const auto& [first, then, delay] : lot.precedences) {
    if (then.value() == task) end = std::max(end, longest(lot, first.value()) + own.duration);
  }
  return end;
}

RC_GTEST_PROP(ContradictionsOracle, ExactlyThoseTasksAreLateWhoseLongestChainIsTooLong,
              (std::uint64_t seed)) {
  const Lot lot = tangled(seed);
  const auto waits = waits_for(lot);
  std::map<TaskNumber, std::vector<TaskNumber>> late;
  for (const Contradiction& one : contradictions(lot)) {
    if (!is_circle(one)) late[one.chain.back()] = one.chain;
  }

  for (std::uint32_t n = 0; n < kCount; ++n) {
    bool behind_a_circle = false;
    for (std::uint32_t m = 0; m < kCount; ++m) {
      behind_a_circle = behind_a_circle || (waits[m][m] && (m == n || waits[n][m]));
    }
    const bool expected = !behind_a_circle && longest(lot, n) > lot.tasks[n].deadline;
    RC_ASSERT(late.contains(TaskNumber(n)) == expected);
    if (!expected) continue;
    double end = 0;  // the chain that is named is itself too long
    for (const TaskNumber task : late[TaskNumber(n)]) {
      const Task& one = lot.tasks[task.value()];
      end = std::max(end, one.earliest) + one.duration;
    }
    RC_ASSERT(end > lot.tasks[n].deadline);
  }
}

TEST(ContradictionsOracle, ATaskThatIsToEndBeforeItselfIsTheShortestCircle) {
  const auto found = contradictions({{a_task(3)}, {{TaskNumber(3), TaskNumber(3)}}});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].chain, ::testing::ElementsAre(TaskNumber(3), TaskNumber(3)));
}

TEST(ContradictionsOracle, ATaskGivenThreeTimesIsNamedOnce) {
  const auto found = contradictions({{a_task(3), a_task(3), a_task(3)}, {}});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].why, "is given twice");
}

}  // namespace
}  // namespace skein::auction
