// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal/stn_solution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "wide_network.hpp"

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

using Distances = std::vector<std::vector<Ticks>>;

/// All shortest distances by Floyd–Warshall, "to - from <= distance"; nothing if a node is at a
/// negative distance from itself. Shares nothing with the solver.
std::optional<Distances> floyd_warshall(const Stn& network) {
  const std::size_t n = network.nodes.size();
  Distances d(n, std::vector<Ticks>(n, kInfinite));
  for (std::size_t i = 0; i < n; ++i) d[i][i] = 0;
  const auto lower = [&](NodeIndex from, NodeIndex to, Ticks weight) {
    d[from][to] = std::min(d[from][to], weight);
  };
  for (const Arc& arc : network.arcs) {
    if (arc.max != kInfinite) lower(arc.from, arc.to, arc.max);
    if (arc.min != kMinusInfinite) lower(arc.to, arc.from, -arc.min);
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (d[i][k] == kInfinite || d[k][j] == kInfinite) continue;
        d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (d[i][i] < 0) return std::nullopt;
  }
  return d;
}

DateWindow window_from(const Distances& d, NodeIndex origin, NodeIndex node) {
  const Ticks back = d[node][origin];
  return {back == kInfinite ? kMinusInfinite : -back, d[origin][node]};
}

/// The conflict is a closed walk along constraints whose weights leave no room.
void expect_negative_cycle(const Stn& network, const std::vector<ConflictArc>& conflict) {
  ASSERT_FALSE(conflict.empty());
  Ticks sum = 0;
  for (std::size_t i = 0; i < conflict.size(); ++i) {
    const ConflictArc& one = conflict[i];
    const ConflictArc& next = conflict[(i + 1) % conflict.size()];
    const Arc& arc = network.arcs.at(one.arc);
    const Arc& after = network.arcs.at(next.arc);
    sum += one.bound == Bound::kLower ? arc.min : -arc.max;
    EXPECT_EQ(one.bound == Bound::kLower ? arc.to : arc.from,
              next.bound == Bound::kLower ? after.from : after.to);
  }
  EXPECT_GT(sum, 0) << "target - source >= weight, once around";
}

/// Any arcs, some of them open, in parallel, in both directions, from a node to itself.
Stn any_network(Random& random) {
  Stn network;
  const std::uint64_t n = 1 + random.below(8);
  for (std::uint64_t i = 0; i < n; ++i) network.nodes.push_back(std::to_string(i));
  network.origin = static_cast<NodeIndex>(random.below(n));
  for (std::uint64_t i = random.below(3 * n); i > 0; --i) {
    Arc arc{static_cast<NodeIndex>(random.below(n)), static_cast<NodeIndex>(random.below(n))};
    if (arc.from == arc.to && random.chance(0.7)) continue;
    arc.min = static_cast<Ticks>(random.below(30)) - 14;
    arc.max = arc.min + static_cast<Ticks>(random.below(25));
    if (random.chance(0.2)) arc.min = kMinusInfinite;
    if (random.chance(0.2)) arc.max = kInfinite;
    network.arcs.push_back(arc);
  }
  return network;
}

TEST(SolveStn, AgreesWithFloydWarshallOnAnyNetwork) {
  Random random(5);
  int consistent = 0;
  for (int i = 0; i < 5000; ++i) {
    const Stn network = any_network(random);
    const std::optional<Distances> right = floyd_warshall(network);

    const StnSolution solution = solve_stn(network).value();

    ASSERT_EQ(solution.consistent, right.has_value()) << i;
    ASSERT_EQ(solution.conflict.empty(), solution.consistent) << i;
    if (!solution.consistent) expect_negative_cycle(network, solution.conflict);
    for (NodeIndex node = 0; node < solution.windows.size(); ++node) {
      ASSERT_EQ(solution.windows[node], window_from(*right, network.origin, node)) << i;
    }
    consistent += solution.consistent ? 1 : 0;
  }
  EXPECT_GT(consistent, 1500);
  EXPECT_LT(consistent, 4500);
}

TEST(SolveStn, AgreesWithFloydWarshallOnWidePlans) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    const Stn network = testing::wide_network({60, seed % 2 == 0, seed > 6}, random);
    const std::optional<Distances> right = floyd_warshall(network);

    const StnSolution solution = solve_stn(network).value();

    ASSERT_EQ(solution.consistent, right.has_value());
    for (NodeIndex node = 0; node < solution.windows.size(); ++node) {
      ASSERT_EQ(solution.windows[node], window_from(*right, network.origin, node));
    }
    if (!solution.consistent) expect_negative_cycle(network, solution.conflict);
  }
}

// The law behind "stn check" in less than a second: ten times the network, ten times the work,
// whatever the order of the file and whether it is consistent or not.
TEST(SolveStn, TakesWorkInProportionToAWidePlan) {
  for (const bool shuffled : {false, true}) {
    for (const bool broken : {false, true}) {
      for (const std::uint32_t nodes : {500U, 5000U}) {
        Random random(nodes);
        const Stn network = testing::wide_network({nodes, shuffled, broken}, random);

        const StnSolution solution = solve_stn(network).value();

        EXPECT_EQ(solution.consistent, !broken);
        EXPECT_LT(solution.checks, 20 * 2 * network.arcs.size()) << nodes << shuffled << broken;
      }
    }
  }
}

TEST(SolveStn, TakesArcsFromANodeToItselfAsWhatTheySay) {
  const auto with = [](Ticks min, Ticks max) { return Stn{{"v0", "a"}, 0, {{1, 1, min, max}}}; };

  EXPECT_TRUE(solve_stn(with(0, 0))->consistent);
  EXPECT_TRUE(solve_stn(with(-3, kInfinite))->consistent);
  EXPECT_THAT(solve_stn(with(2, kInfinite))->conflict, ElementsAre(ConflictArc{0, Bound::kLower}));
  EXPECT_THAT(solve_stn(with(kMinusInfinite, -1))->conflict,
              ElementsAre(ConflictArc{0, Bound::kUpper}));
}

TEST(SolveStn, NamesBothBoundsOfAnEmptyInterval) {
  const Stn network{{"v0", "a"}, 0, {{0, 1, 3, 2}}};

  EXPECT_THAT(solve_stn(network)->conflict,
              UnorderedElementsAre(ConflictArc{0, Bound::kLower}, ConflictArc{0, Bound::kUpper}));
}

TEST(SolveStn, LeavesOpenWhatNothingBounds) {
  const Stn network{{"v0", "a", "b"}, 0, {{1, 2, 3, 4}}};

  const StnSolution solution = solve_stn(network).value();

  EXPECT_THAT(solution.windows, ElementsAre(DateWindow{0, 0}, DateWindow{}, DateWindow{}));
  EXPECT_THAT(solution.conflict, IsEmpty());
}

TEST(SolveStn, RefusesWhatIsBeyondTheRangeOfTimes) {
  const Stn far{{"v0", "a", "b"}, 0, {{0, 1, kLargest, kInfinite}, {1, 2, 1, kInfinite}}};
  const Stn early{
      {"v0", "a", "b"}, 0, {{0, 1, kMinusInfinite, -kLargest}, {1, 2, kMinusInfinite, -1}}};
  const Stn bound{{"v0", "a"}, 0, {{0, 1, 0, kLargest + 1}}};
  const Stn ends{{"v0", "a"}, 0, {{0, 7, 0, 1}}};

  EXPECT_EQ(solve_stn(far).error().error, StnError::kOverflow);
  EXPECT_EQ(solve_stn(early).error().error, StnError::kOverflow);
  EXPECT_EQ(solve_stn(bound).error(), (StnRefusal{StnError::kOverflow, 0}));
  EXPECT_EQ(solve_stn(ends).error(), (StnRefusal{StnError::kUnknownNode, 7}));
}

TEST(SolveStn, IsRightAtTheEndOfTheRange) {
  const Stn network{
      {"v0", "a", "b"}, 0, {{0, 1, kLargest, kLargest}, {0, 2, -kLargest, -kLargest}}};

  const StnSolution solution = solve_stn(network).value();

  EXPECT_THAT(solution.windows, ElementsAre(DateWindow{0, 0}, DateWindow{kLargest, kLargest},
                                            DateWindow{-kLargest, -kLargest}));
}

}  // namespace
}  // namespace skein::temporal
