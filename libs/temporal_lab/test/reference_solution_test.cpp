// SPDX-License-Identifier: Apache-2.0
// The oracle against something even plainer: all assignments tried one by one.
#include "skein/temporal_lab/reference_solution.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace skein::temporal {
namespace {

// Three nodes beside v0, each tried at every date in ±12; arcs of values within ±4 cannot need
// more.
constexpr Ticks kFarthest = 12;
constexpr std::size_t kNodes = 4;

bool satisfies(const std::vector<Ticks>& dates, const std::vector<Arc>& arcs) {
  return std::all_of(arcs.begin(), arcs.end(), [&](const Arc& arc) {
    const Ticks distance = dates[arc.to] - dates[arc.from];
    return arc.min <= distance && distance <= arc.max;
  });
}

ReferenceSolution solve_by_trying(const std::vector<Arc>& arcs) {
  ReferenceSolution solution{false,
                             std::vector<ReferenceWindow>(kNodes, {kInfinite, kMinusInfinite})};
  std::vector<Ticks> dates(kNodes, 0);
  for (dates[1] = -kFarthest; dates[1] <= kFarthest; ++dates[1]) {
    for (dates[2] = -kFarthest; dates[2] <= kFarthest; ++dates[2]) {
      for (dates[3] = -kFarthest; dates[3] <= kFarthest; ++dates[3]) {
        if (!satisfies(dates, arcs)) continue;
        solution.consistent = true;
        for (std::size_t node = 0; node < kNodes; ++node) {
          solution.windows[node].min = std::min(solution.windows[node].min, dates[node]);
          solution.windows[node].max = std::max(solution.windows[node].max, dates[node]);
        }
      }
    }
  }
  if (!solution.consistent) solution.windows.clear();
  return solution;
}

// A chain that bounds every node, and some arcs more.
std::vector<Arc> arbitrary_arcs() {
  std::vector<Arc> arcs;
  const auto add = [&arcs](NodeIndex from, NodeIndex to) {
    const Ticks min = *rc::gen::inRange<Ticks>(-4, 5);
    arcs.push_back({from, to, min, *rc::gen::inRange<Ticks>(min, 5)});
  };
  for (NodeIndex node = 1; node < kNodes; ++node) add(node - 1, node);
  const auto more = *rc::gen::inRange<int>(0, 4);
  for (int arc = 0; arc < more; ++arc) {
    const NodeIndex from = *rc::gen::inRange<NodeIndex>(0, kNodes);
    add(from, (from + *rc::gen::inRange<NodeIndex>(1, kNodes)) % kNodes);
  }
  return arcs;
}

RC_GTEST_PROP(ReferenceSolution, FindsWhatTryingAllAssignmentsFinds, ()) {
  const std::vector<Arc> arcs = arbitrary_arcs();

  RC_ASSERT(solve_reference(kNodes, arcs) == solve_by_trying(arcs));
}

RC_GTEST_PROP(ReferenceSolution, ImpliedIntervalsAreThoseOfTheNetworkShiftedToTheNode, ()) {
  std::vector<Arc> arcs = arbitrary_arcs();
  RC_PRE(solve_reference(kNodes, arcs).consistent);
  const NodeIndex from = *rc::gen::inRange<NodeIndex>(0, kNodes);
  const NodeIndex to = *rc::gen::inRange<NodeIndex>(0, kNodes);
  const ReferenceWindow implied = implied_interval(kNodes, arcs, from, to);
  const auto swap_origin = [from](NodeIndex node) {
    return node == from ? 0 : (node == 0 ? from : node);
  };
  for (Arc& arc : arcs) arc = {swap_origin(arc.from), swap_origin(arc.to), arc.min, arc.max};

  RC_ASSERT(solve_reference(kNodes, arcs).windows[swap_origin(to)] == implied);
}

TEST(ReferenceSolution, LeavesUnboundedWhatNothingBounds) {
  const ReferenceSolution solution = solve_reference(3, {{0, 1, 5, kInfinite}});

  ASSERT_TRUE(solution.consistent);
  EXPECT_EQ(solution.windows[0], (ReferenceWindow{0, 0}));
  EXPECT_EQ(solution.windows[1], (ReferenceWindow{5, kInfinite}));
  EXPECT_EQ(solution.windows[2], (ReferenceWindow{kMinusInfinite, kInfinite}));
}

TEST(ReferenceSolution, SeesAConflictThatTheOriginDoesNotReach) {
  EXPECT_FALSE(solve_reference(4, {{1, 2, 5, 6}, {2, 1, 0, 3}}).consistent);
}

TEST(ReferenceSolution, NoNodesAndNoArcsAreConsistent) {
  EXPECT_TRUE(solve_reference(0, {}).consistent);
  EXPECT_TRUE(solve_reference(1, {}).consistent);
}

}  // namespace
}  // namespace skein::temporal
