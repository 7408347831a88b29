// SPDX-License-Identifier: Apache-2.0
// The engine at its edges: pending constraints, nested undo, refusals, removal, the largest times.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "skein/temporal/stn_engine.hpp"

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

Stn network(std::size_t nodes, std::vector<Arc> arcs, NodeIndex origin = 0) {
  Stn stn;
  for (std::size_t i = 0; i < nodes; ++i) stn.nodes.push_back("n" + std::to_string(i));
  stn.arcs = std::move(arcs);
  stn.origin = origin;
  return stn;
}

StnEngine engine_of(const Stn& stn) { return StnEngine::make(stn).value(); }

/// Two tasks one after the other and a deadline: v0 -[0,10]-> 1 -[5,8]-> 2, v0 -[0,20]-> 2.
StnEngine two_tasks() {
  return engine_of(network(3, {{0, 1, 0, 10}, {1, 2, 5, 8}, {0, 2, 0, 20}}));
}

using Window = std::pair<Ticks, Ticks>;
Window window(const StnEngine& engine, NodeIndex node) {
  return {engine.earliest(node), engine.latest(node)};
}

/// All that can be seen of an engine but the work it did.
struct Visible {
  std::vector<Window> windows;
  std::vector<std::optional<Arc>> arcs;
  bool consistent;
  std::size_t arc_count;
  std::vector<BoundChange> changes;
  bool operator==(const Visible&) const = default;
};

Visible visible(const StnEngine& engine) {
  Visible all{{}, {}, engine.consistent(), engine.arc_count(), engine.changes()};
  for (NodeIndex node = 0; node < engine.node_count(); ++node) {
    all.windows.push_back(window(engine, node));
  }
  for (ArcId arc = 0; arc < 12; ++arc) all.arcs.push_back(engine.arc(arc));
  return all;
}

Ticks sum_of(const StnEngine& engine, const std::vector<ConflictArc>& cycle) {
  Ticks sum = 0;
  for (const ConflictArc& step : cycle) {
    const Arc arc = engine.arc(step.arc).value();
    sum += step.bound == Bound::kLower ? arc.min : -arc.max;
  }
  return sum;
}

TEST(StnEngineWindowTest, StopsARaiseThatWouldPassTheLatestDateAtOnce) {
  // Behind node 1 hangs a long chain: none of it is to be looked at.
  std::vector<Arc> arcs = {
      {0, 1, 0, 10}, {0, 2, 0, 0}, {2, 1, kMinusInfinite, kInfinite}, {1, 3, 1, 9}};
  for (NodeIndex node = 4; node < 2'000; ++node) arcs.push_back({node - 1, node, 1, 9});
  StnEngine engine = engine_of(network(2'000, arcs));
  const std::uint64_t before = engine.checks();

  EXPECT_EQ(engine.set_arc({2, 11, kInfinite}), std::nullopt);

  EXPECT_FALSE(engine.consistent());
  EXPECT_LE(engine.checks() - before, 10U);
  EXPECT_EQ(sum_of(engine, engine.conflict()), 1);
}

TEST(StnEngineWindowTest, AWindowOfOneInstantIsNoConflict) {
  StnEngine engine = two_tasks();

  engine.set_arcs(std::vector<ArcBounds>{{0, 7, 7}, {1, 5, 5}, {2, 12, 12}});

  EXPECT_TRUE(engine.consistent());
  EXPECT_EQ(window(engine, 2), Window(12, 12));
}

TEST(StnEnginePending, OneNanosecondTooMuchIsAConflictAndOneLessIsNot) {
  StnEngine engine = two_tasks();

  engine.set_arc({0, 15, 16});
  EXPECT_TRUE(engine.consistent()) << "15 + 5 is the deadline";
  engine.set_arc({0, 16, 16});
  EXPECT_FALSE(engine.consistent());
  EXPECT_EQ(sum_of(engine, engine.conflict()), 1);

  engine.set_arc({1, 4, 8});
  EXPECT_TRUE(engine.consistent());
  EXPECT_EQ(window(engine, 2), Window(20, 20));
}

TEST(StnEnginePending, OutlivesChangesElsewhere) {
  StnEngine engine =
      engine_of(network(4, {{0, 1, 5, 9}, {1, 2, 5, 9}, {0, 2, 0, 9}, {0, 3, 0, 50}}));

  engine.set_arc({3, 10, 40});
  engine.set_arc({3, 2, 60});

  EXPECT_FALSE(engine.consistent());
  EXPECT_THAT(engine.conflict(),
              UnorderedElementsAre(ConflictArc{0, Bound::kLower}, ConflictArc{1, Bound::kLower},
                                   ConflictArc{2, Bound::kUpper}));
}

TEST(StnEnginePending, IsNotFreedByARelaxationBesideTheConflict) {
  StnEngine engine = engine_of(network(3, {{0, 1, 5, 9}, {1, 2, 5, 9}, {0, 2, 0, 9}}));

  engine.set_arc({0, 5, 1'000});
  engine.set_arc({2, -1'000, 9});

  EXPECT_FALSE(engine.consistent()) << "neither bound is on the cycle";
  engine.set_arc({2, -1'000, 10});
  EXPECT_TRUE(engine.consistent());
}

TEST(StnEnginePending, OfTwoConflictsTheOtherRemains) {
  StnEngine engine = engine_of(
      network(5, {{0, 1, 5, 9}, {1, 2, 5, 9}, {0, 2, 0, 9}, {3, 4, 2, 3}, {4, 3, -1, 0}}));

  engine.remove_arc(2);

  EXPECT_FALSE(engine.consistent());
  std::set<ArcId> named;
  for (const ConflictArc& step : engine.conflict()) named.insert(step.arc);
  EXPECT_THAT(named, ElementsAre(3U, 4U));

  engine.remove_arc(4);
  EXPECT_TRUE(engine.consistent());
  EXPECT_THAT(engine.conflict(), IsEmpty());
}

TEST(StnEnginePending, ABatchMayBreakAndMendAtOnce) {
  StnEngine engine = two_tasks();

  engine.set_arcs(std::vector<ArcBounds>{{0, 18, 30}, {2, 0, 40}});

  EXPECT_TRUE(engine.consistent());
  EXPECT_EQ(window(engine, 2), Window(23, 38));
}

TEST(StnEnginePending, ANodeAddedDuringAConflictHasItsDatesWhenItIsOver) {
  StnEngine engine = two_tasks();
  engine.set_arc({2, 0, 4});
  ASSERT_FALSE(engine.consistent());

  const NodeIndex node = engine.add_node();
  const auto arc = engine.add_arc({2, node, 1, 2});
  ASSERT_TRUE(arc.has_value());
  EXPECT_FALSE(engine.consistent());

  engine.set_arc({2, 0, 7});
  EXPECT_TRUE(engine.consistent());
  EXPECT_EQ(window(engine, node), Window(6, 9));
  EXPECT_EQ(window(engine, 1), Window(0, 2));
}

TEST(StnEngineUndo, AMiddleCheckpointRolledBackKeepsTheOuterAndTheNext) {
  StnEngine engine = two_tasks();
  const auto first = window(engine, 2);

  engine.checkpoint();
  engine.set_arc({0, 2, 10});
  engine.checkpoint();
  engine.set_arc({0, 3, 10});
  engine.rollback();
  EXPECT_EQ(engine.earliest(2), 7) << "the outer change is kept";
  engine.checkpoint();
  engine.set_arc({0, 4, 10});
  engine.commit();
  EXPECT_EQ(engine.earliest(2), 9);
  engine.rollback();

  EXPECT_EQ(window(engine, 2), first);
  EXPECT_EQ(engine.arc(0), (Arc{0, 1, 0, 10}));
}

TEST(StnEngineUndo, GoesBackToAConflictThatWasThere) {
  StnEngine engine = two_tasks();
  engine.set_arc({2, 0, 4});
  const auto conflict = engine.conflict();

  engine.checkpoint();
  engine.set_arc({2, 0, 30});
  EXPECT_TRUE(engine.consistent());
  engine.rollback();

  EXPECT_FALSE(engine.consistent());
  EXPECT_EQ(sum_of(engine, engine.conflict()), sum_of(engine, conflict));
  engine.set_arc({1, 4, 8});
  EXPECT_TRUE(engine.consistent()) << "and is freed from there";
}

TEST(StnEngineUndo, GivesARemovedArcItsNumberBackEvenIfItWasUsedAgain) {
  StnEngine engine = two_tasks();

  engine.checkpoint();
  engine.remove_arc(1);
  const ArcId again = engine.add_arc({2, 1, 3, 4}).value();
  EXPECT_EQ(again, 1U) << "numbers of removed arcs are used again";
  EXPECT_EQ(engine.find_arc(1, 2), std::nullopt);
  engine.rollback();

  EXPECT_EQ(engine.arc(1), (Arc{1, 2, 5, 8}));
  EXPECT_EQ(engine.find_arc(2, 1), std::nullopt);
  EXPECT_EQ(engine.arc_count(), 3U);
  EXPECT_EQ(window(engine, 2), Window(5, 18));
}

TEST(StnEngineUndo, ARefusalInsideACheckpointUndoesOnlyItself) {
  StnEngine engine = two_tasks();
  engine.checkpoint();
  engine.set_arc({0, 3, 10});
  const ArcId free = engine.add_arc({2, 1, kMinusInfinite, kInfinite}).value();
  engine.set_arcs(std::vector<ArcBounds>{
      {2, kMinusInfinite, kInfinite}, {0, kLargest, kInfinite}, {1, 0, kInfinite}});
  const Visible before = visible(engine);

  const auto refusal = engine.set_arc({1, 1, kInfinite});

  ASSERT_TRUE(refusal.has_value());
  EXPECT_EQ(refusal->error, StnError::kOverflow);
  EXPECT_EQ(visible(engine), before);
  engine.rollback();
  EXPECT_EQ(engine.arc(free), std::nullopt);
  EXPECT_EQ(window(engine, 2), Window(5, 18));
}

TEST(StnEngineUndo, ACopyTakenInsideACheckpointCanGoBackByItself) {
  StnEngine engine = two_tasks();
  engine.checkpoint();
  engine.set_arc({0, 3, 10});

  StnEngine copy = engine;
  copy.rollback();

  EXPECT_EQ(copy.earliest(1), 0);
  EXPECT_EQ(engine.earliest(1), 3);
  engine.commit();
  EXPECT_EQ(engine.earliest(1), 3);
}

TEST(StnEngineRefusal, EveryKindLeavesAllThatCanBeSeen) {
  for (const Ticks deadline : {Ticks{20}, Ticks{4}}) {  // consistent, and not
    StnEngine engine = two_tasks();
    engine.set_arc({2, 0, deadline});
    const Visible before = visible(engine);
    const auto refused = [&](const std::optional<StnRefusal>& refusal) {
      EXPECT_EQ(visible(engine), before);
      return refusal.value_or(StnRefusal{StnError::kUnknownArc, 999}).error;
    };
    const auto refused_arc = [&](const Arc& arc) {
      const auto result = engine.add_arc(arc);
      return refused(result ? std::nullopt : std::optional(result.error()));
    };

    EXPECT_EQ(refused_arc({0, 3, 0, 1}), StnError::kUnknownNode);
    EXPECT_EQ(refused_arc({3, 0, 0, 1}), StnError::kUnknownNode);
    EXPECT_EQ(refused_arc({1, 2, 0, 1}), StnError::kArcGivenTwice);
    EXPECT_EQ(refused_arc({1, 1, 0, 1}), StnError::kArcToItself);
    EXPECT_EQ(refused_arc({2, 1, 1, 0}), StnError::kEmptyInterval);
    EXPECT_EQ(refused_arc({2, 1, kMinusInfinite, kMinusInfinite}), StnError::kEmptyInterval);
    EXPECT_EQ(refused_arc({2, 1, 0, kLargest + 1}), StnError::kOverflow);
    EXPECT_EQ(refused(engine.set_arc({3, 0, 1})), StnError::kUnknownArc);
    EXPECT_EQ(refused(engine.set_arc({0, 1, 0})), StnError::kEmptyInterval);
    EXPECT_EQ(refused(engine.set_arc({0, -kLargest - 1, 0})), StnError::kOverflow);
    EXPECT_EQ(refused(engine.remove_arc(3)), StnError::kUnknownArc);
  }
}

TEST(StnEngineRefusal, AnArcWhoseDatesOverflowIsNotAdded) {
  StnEngine engine = engine_of(network(3, {{0, 1, kLargest, kInfinite}}));
  const Visible before = visible(engine);

  const auto result = engine.add_arc({1, 2, 1, kInfinite});

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().error, StnError::kOverflow);
  EXPECT_EQ(visible(engine), before);
  EXPECT_EQ(engine.find_arc(1, 2), std::nullopt);
  EXPECT_TRUE(engine.add_arc({1, 2, 0, kInfinite}).has_value()) << "and can be, when it fits";
}

TEST(StnEngineRefusal, AnOverflowUndoesTheWholeBatch) {
  StnEngine engine = engine_of(network(3, {{0, 1, 0, kInfinite}, {1, 2, 0, kInfinite}}));
  const Visible before = visible(engine);

  const auto refusal =
      engine.set_arcs(std::vector<ArcBounds>{{0, kLargest, kInfinite}, {1, kLargest, kInfinite}});

  EXPECT_EQ(refusal.value_or(StnRefusal{}).error, StnError::kOverflow);
  EXPECT_EQ(visible(engine), before);
}

TEST(StnEngineBounds, TheLargestTimesAreTakenExactly) {
  const StnEngine engine =
      engine_of(network(3, {{0, 1, -kLargest, kLargest}, {0, 2, kLargest, kLargest}}));

  EXPECT_EQ(window(engine, 1), Window(-kLargest, kLargest));
  EXPECT_EQ(window(engine, 2), Window(kLargest, kLargest));
}

TEST(StnEngineBounds, AnArcWithoutBoundsSaysNothing) {
  StnEngine engine = two_tasks();
  const auto before = window(engine, 2);

  const auto arc = engine.add_arc({2, 1, kMinusInfinite, kInfinite});

  ASSERT_TRUE(arc.has_value());
  EXPECT_THAT(engine.changes(), IsEmpty());
  EXPECT_EQ(window(engine, 2), before);
}

TEST(StnEngineBounds, TheLastOfTwoBoundsOfOneArcInACallWins) {
  StnEngine engine = two_tasks();

  engine.set_arcs(std::vector<ArcBounds>{{0, 9, 10}, {0, 2, 3}});

  EXPECT_EQ(window(engine, 1), Window(2, 3));
  EXPECT_EQ(engine.arc(0), (Arc{0, 1, 2, 3}));
}

TEST(StnEngineBounds, AnEmptyCallChangesNothing) {
  StnEngine engine = two_tasks();

  EXPECT_EQ(engine.set_arcs({}), std::nullopt);

  EXPECT_THAT(engine.changes(), IsEmpty());
  EXPECT_EQ(window(engine, 2), Window(5, 18));
}

TEST(StnEngineBounds, NodesAndArcsKeepTheirNumbersWhicheverIsTheOrigin) {
  StnEngine engine = engine_of(network(3, {{2, 1, 1, 4}, {1, 0, 2, 2}}, 2));

  EXPECT_EQ(engine.find_arc(2, 1), 0U);
  EXPECT_EQ(engine.find_arc(1, 2), std::nullopt) << "an arc has a direction";
  EXPECT_EQ(engine.find_arc(0, 77), std::nullopt);
  engine.set_arc({0, 3, 4});
  EXPECT_THAT(engine.changes(), UnorderedElementsAre(BoundChange{1, Bound::kLower, 3},
                                                     BoundChange{0, Bound::kLower, 5}));
}

TEST(StnEngineBounds, ARemovedArcTiesNoMore) {
  StnEngine engine = engine_of(network(2, {{0, 1, 3, 4}}));

  engine.remove_arc(0);

  EXPECT_EQ(window(engine, 1), Window(kMinusInfinite, kInfinite));
  EXPECT_THAT(engine.changes(), UnorderedElementsAre(BoundChange{1, Bound::kLower, kMinusInfinite},
                                                     BoundChange{1, Bound::kUpper, kInfinite}));
}

TEST(StnErrors, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const StnError error :
       {StnError::kUnknownNode, StnError::kUnknownArc, StnError::kArcGivenTwice,
        StnError::kArcToItself, StnError::kEmptyInterval, StnError::kOverflow}) {
    names.insert(to_text(error));
  }

  EXPECT_THAT(names, SizeIs(6));
  EXPECT_FALSE(names.contains("unknown error"));
}

}  // namespace
}  // namespace skein::temporal
