// SPDX-License-Identifier: Apache-2.0
// The parts the check and the dispatchable form are made of, each by itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "controllability/best_case_schedule.hpp"
#include "controllability/dc_engine.hpp"
#include "controllability/implied_edges.hpp"
#include "controllability/link_search.hpp"
#include "network/indexed_heap.hpp"
#include "network/wide_network.hpp"
#include "random_stnu.hpp"
#include "skein/temporal/stnu_execution.hpp"
#include "skein/temporal_lab/stnu_generator.hpp"
#include "stnu_builder.hpp"

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::random_stnu;
using testing::StnuBuilder;

RC_GTEST_PROP(IndexedHeap, GivesItemsInTheOrderOfTheirLowestKeys, (std::vector<int> keys)) {
  IndexedHeap<int> heap(8);
  std::vector<int> least(8, std::numeric_limits<int>::max());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto item = static_cast<std::uint32_t>(i % 8);
    RC_ASSERT(heap.lower(item, keys[i]) == (i < 8 || keys[i] < least[item]));
    least[item] = std::min(least[item], keys[i]);
  }

  std::vector<int> out;
  while (!heap.empty()) {
    const std::uint32_t item = heap.pop();
    RC_ASSERT(heap.key(item) == least[item]);
    RC_ASSERT(!heap.contains(item));
    out.push_back(least[item]);
  }

  RC_ASSERT(std::is_sorted(out.begin(), out.end()));
  RC_ASSERT(out.size() == std::min<std::size_t>(8, keys.size()));
}

TEST(IndexedHeap, ClearForgetsEverything) {
  IndexedHeap<int> heap(3);
  heap.lower(1, 5);

  heap.clear();

  EXPECT_TRUE(heap.empty());
  EXPECT_TRUE(heap.lower(1, 9));
}

TEST(LoGraph, KeepsEachBoundByTheNodeItEndsIn) {
  const Stnu network = StnuBuilder("z a c").arc("z", "a", 2, 7).contingent("a", "c", 3, 5).build();

  const LoGraph graph(network, LoGraph::OpenBounds::kKeep);

  const std::uint32_t max = graph.edge_of(0, LinkBound::kMax);
  EXPECT_EQ(graph.edge_end(max), 1U);
  EXPECT_EQ(graph.edge(max).weight, 7);
  EXPECT_EQ(graph.edge(graph.edge_of(0, LinkBound::kMin)).weight, -2);
  EXPECT_EQ(graph.link_ending(2), 0U);
  EXPECT_THAT(graph.links_activated(1), ElementsAre(0U));
  EXPECT_EQ(graph.base_out_of(0).size(), 1U);
}

TEST(LoGraph, OpenBoundsHaveNoEdgeUnlessKept) {
  const Stnu network = StnuBuilder("z a").arc("z", "a", kMinusInfinite, kInfinite).build();

  EXPECT_EQ(LoGraph(network, LoGraph::OpenBounds::kDrop).edge_of(0, LinkBound::kMax), kNone);
  const LoGraph kept(network, LoGraph::OpenBounds::kKeep);
  EXPECT_EQ(kept.edge(kept.edge_of(0, LinkBound::kMax)).weight, kInfinite);
}

bool satisfied(const LoGraph& graph, const BestCaseSchedule& schedule) {
  bool all = true;
  for (NodeIndex node = 0; node < graph.node_count(); ++node) {
    for_each_edge_into(graph, node, kNone, [&](NodeIndex from, Ticks weight, EdgeRef /*edge*/) {
      all = all && schedule.date(node) - schedule.date(from) <= weight;
    });
  }
  return all;
}

Ticks weight_of(const LoGraph& graph, const PathStep& step) {
  if (step.edge.kind == EdgeRef::Kind::kLower) return graph.link(step.edge.index).min;
  return graph.edge(step.edge.index).weight;
}

TEST(BestCaseSchedule, SatisfiesEveryEdgeOrShowsANegativeCycle) {
  Random random(70);
  int solved = 0;
  for (int i = 0; i < 2'000; ++i) {
    const Stnu network = random_stnu({8, 3, 14, 12, false, 0}, random);
    const LoGraph graph(network, LoGraph::OpenBounds::kDrop);
    BestCaseSchedule schedule(graph.node_count());

    if (schedule.solve(graph, false) == BestCaseSchedule::Outcome::kDone) {
      ASSERT_TRUE(satisfied(graph, schedule));
      ++solved;
      continue;
    }
    Ticks sum = 0;
    const std::vector<PathStep>& cycle = schedule.cycle();
    for (std::size_t s = 0; s < cycle.size(); ++s) {
      sum += weight_of(graph, cycle[s]);
      ASSERT_EQ(cycle[s].to, cycle[(s + 1) % cycle.size()].from);
    }
    ASSERT_LT(sum, 0);
  }
  EXPECT_GT(solved, 300);
  EXPECT_LT(solved, 1'900);
}

TEST(BestCaseSchedule, NeedsFewSweepsOfAWidePlanInWhateverOrderItComes) {
  for (const bool shuffled : {false, true}) {
    Random random(2);
    const Stn wide = testing::wide_network({2000, shuffled, false}, random);
    const LoGraph graph({wide.nodes, wide.origin, wide.arcs, {}}, LoGraph::OpenBounds::kDrop);
    BestCaseSchedule schedule(graph.node_count());

    EXPECT_EQ(schedule.solve(graph, false), BestCaseSchedule::Outcome::kDone);

    EXPECT_LE(schedule.sweeps(), 6U) << shuffled;
  }
}

TEST(BestCaseSchedule, ANewEdgeMovesItOrClosesACycleAsIfSolvedAnew) {
  Random random(71);
  int cycles = 0;
  for (int i = 0; i < 2'000; ++i) {
    Stnu network = random_stnu({7, 2, 6, 12, false, 0}, random);
    network.arcs.push_back({1, 2, kMinusInfinite, kInfinite});
    const auto arc = static_cast<std::uint32_t>(network.arcs.size() - 1);
    LoGraph graph(network, LoGraph::OpenBounds::kKeep);
    BestCaseSchedule schedule(graph.node_count());
    if (schedule.solve(graph, false) != BestCaseSchedule::Outcome::kDone) continue;
    const std::uint32_t edge = graph.edge_of(arc, LinkBound::kMax);
    const Ticks weight = testing::draw(-25, 5, random);
    const std::vector<Ticks> before = schedule.dates();

    const auto outcome = schedule.add_edges(graph, 2, {{1, weight, {EdgeRef::Kind::kBase, edge}}});

    graph.set_weight(edge, weight);
    BestCaseSchedule anew(graph.node_count());
    ASSERT_EQ(outcome, anew.solve(graph, false));
    if (outcome == BestCaseSchedule::Outcome::kDone) {
      ASSERT_TRUE(satisfied(graph, schedule));
    } else {
      ASSERT_EQ(schedule.dates(), before);
      ++cycles;
    }
  }
  EXPECT_GT(cycles, 50);
}

TEST(LinkSearch, FindsDistancesAsFarAsTheUncertaintyCarries) {
  // x is at most 2 before c; y at most 1 before x; w at most 9 before y: the spread is 4.
  const Stnu network = StnuBuilder("z a c x y w v")
                           .contingent("a", "c", 2, 6)
                           .arc("x", "c", kMinusInfinite, 2)
                           .arc("y", "x", kMinusInfinite, 1)
                           .arc("w", "y", kMinusInfinite, 9)
                           .arc("v", "w", kMinusInfinite, 1)
                           .build();
  const LoGraph graph(network, LoGraph::OpenBounds::kDrop);
  BestCaseSchedule schedule(graph.node_count());
  schedule.solve(graph, false);
  LinkSearch search(graph.node_count());

  EXPECT_EQ(search.run(graph, schedule, 0, nullptr), kNone);

  EXPECT_EQ(search.distance(3), 2);
  EXPECT_EQ(search.distance(4), 3);
  EXPECT_EQ(search.distance(5), 12);
  EXPECT_FALSE(search.reached(6));
  std::vector<Ticks> weights;
  for (const LoGraph::Edge& edge : search.derived_edges(graph.link(0)))
    weights.push_back(edge.weight);
  EXPECT_THAT(weights, ::testing::UnorderedElementsAre(-2, -2, 6));
  EXPECT_EQ(search.snapshot().path_from(4, 2).size(), 2U);
}

TEST(LinkSearch, WaitsForTheLinksItPasses) {
  const Stnu network =
      StnuBuilder("z a b c").contingent("a", "b", 2, 4).contingent("b", "c", 3, 6).build();
  const LoGraph graph(network, LoGraph::OpenBounds::kDrop);
  BestCaseSchedule schedule(graph.node_count());
  schedule.solve(graph, false);
  LinkSearch search(graph.node_count());
  std::vector<std::uint8_t> ready = {0, 0};

  EXPECT_EQ(search.run(graph, schedule, 0, &ready), 1U);
  EXPECT_EQ(search.run(graph, schedule, 1, &ready), kNone);
  ready[1] = 1;
  EXPECT_EQ(search.run(graph, schedule, 0, &ready), kNone);
}

TEST(ImpliedEdges, AChainOfDelaysMakesTheLongDelayNeedless) {
  const std::vector<DistanceEdge> edges = {{1, 0, -3}, {2, 0, -7}, {2, 1, -4}};

  EXPECT_THAT(without_implied_edges(edges, 3), ElementsAre(edges[0], edges[2]));
}

TEST(ImpliedEdges, AStricterDelayThanTheChainStays) {
  const std::vector<DistanceEdge> edges = {{1, 0, -3}, {2, 0, -8}, {2, 1, -4}};

  EXPECT_EQ(without_implied_edges(edges, 3), edges);
}

TEST(ImpliedEdges, ADelayIsNotReplacedByADeadlineOnTheWay) {
  const std::vector<DistanceEdge> edges = {{1, 0, 2}, {2, 0, -4}, {2, 1, -9}};

  EXPECT_EQ(without_implied_edges(edges, 3), edges);
}

TEST(ImpliedEdges, EqualDeadlinesDoNotReplaceEachOther) {
  const std::vector<DistanceEdge> edges = {{0, 1, 0}, {0, 2, 5}, {1, 0, 0}, {1, 2, 5}};

  EXPECT_EQ(without_implied_edges(edges, 3), edges);
}

TEST(FindViolations, NamesRequirementsAndDurationsThatDatesBreak) {
  const Stnu network = StnuBuilder("z a c").arc("z", "a", 1, 2).contingent("a", "c", 3, 5).build();

  EXPECT_THAT(find_violations(network, {0, 2, 5}), IsEmpty());
  EXPECT_THAT(find_violations(network, {0, 3, 6}), ElementsAre(LinkRef{LinkKind::kRequirement, 0}));
  EXPECT_THAT(find_violations(network, {0, 2, 8}), ElementsAre(LinkRef{LinkKind::kContingent, 0}));
  EXPECT_THAT(find_violations(network, {0, std::nullopt, 8}), IsEmpty());
}

TEST(DrawDurations, StayWithinBoundsAndReachThem) {
  const Stnu network = StnuBuilder("z a").contingent("z", "a", 3, 9).build();
  Random random(1);
  std::set<Ticks> seen;
  for (int i = 0; i < 300; ++i) seen.insert(draw_durations(network, random).at(0));

  EXPECT_EQ(*seen.begin(), 3);
  EXPECT_EQ(*seen.rbegin(), 9);
  EXPECT_EQ(seen.size(), 7U);
}

TEST(DcEngine, TheCounterOfSearchesStaysBelowTwiceTheLinks) {
  Random random(72);
  for (int i = 0; i < 1'000; ++i) {
    const Stnu network = random_stnu({14, 6, 20, 15, false, 0}, random);

    const auto result = check_dynamic_controllability(network);

    ASSERT_LE(result->counters.searches, 2 * network.contingent.size());
  }
}

TEST(ConflictTerm, IsWrittenWithTheNamesOfTheNetwork) {
  const Stnu network = StnuBuilder("z a c").arc("z", "a", 1, 2).contingent("a", "c", 3, 5).build();

  EXPECT_EQ(to_text(ConflictTerm{{LinkKind::kRequirement, 0}, LinkBound::kMin}, network),
            "min of z -> a");
  EXPECT_EQ(to_text(ConflictTerm{{LinkKind::kContingent, 0}, LinkBound::kMax}, network),
            "max of contingent a -> c");
}

}  // namespace
}  // namespace skein::temporal
