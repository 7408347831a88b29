// SPDX-License-Identifier: Apache-2.0
// Tests of the engine, the random ones against a Bellman–Ford that shares nothing with it.
#include "skein/temporal/stn_engine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "skein/foundation/random.hpp"
#include "skein/temporal_lab/reference_solution.hpp"

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Optional;
using ::testing::SizeIs;

Stn network(std::size_t nodes, std::vector<Arc> arcs, NodeIndex origin = 0) {
  Stn stn;
  for (std::size_t i = 0; i < nodes; ++i) stn.nodes.push_back("n" + std::to_string(i));
  stn.arcs = std::move(arcs);
  stn.origin = origin;
  return stn;
}

StnEngine engine_of(const Stn& stn) {
  auto engine = StnEngine::make(stn);
  EXPECT_TRUE(engine.has_value());
  return *std::move(engine);
}

/// v0 -[1,10]-> 1 -[2,3]-> 2 -[0,20]-> 3
StnEngine chain() { return engine_of(network(4, {{0, 1, 1, 10}, {1, 2, 2, 3}, {2, 3, 0, 20}})); }

using Window = std::pair<Ticks, Ticks>;
Window window(const StnEngine& engine, NodeIndex node) {
  return {engine.earliest(node), engine.latest(node)};
}

std::vector<Window> windows(const StnEngine& engine) {
  std::vector<Window> all;
  for (NodeIndex node = 0; node < engine.node_count(); ++node) all.push_back(window(engine, node));
  return all;
}

StnError error_of(const std::optional<StnRefusal>& refusal) {
  EXPECT_TRUE(refusal.has_value());
  return refusal ? refusal->error : StnError{};
}

TEST(StnEngine, GivesEarliestAndLatestDatesOfAChain) {
  const StnEngine engine = chain();

  EXPECT_TRUE(engine.consistent());
  EXPECT_THAT(windows(engine),
              ElementsAre(Window{0, 0}, Window{1, 10}, Window{3, 13}, Window{3, 33}));
}

TEST(StnEngine, PropagatesAContractionBothWays) {
  StnEngine engine = chain();

  EXPECT_EQ(engine.set_arc({1, 3, 3}), std::nullopt);
  EXPECT_EQ(engine.set_arc({2, 5, 20}), std::nullopt);

  EXPECT_EQ(window(engine, 2), Window(4, 13));
  EXPECT_EQ(window(engine, 3), Window(9, 33));
}

TEST(StnEngine, ForgetsWhatFollowedFromARelaxedArc) {
  StnEngine engine = chain();
  engine.set_arc({0, 5, 6});

  engine.set_arc({0, 2, 40});

  EXPECT_THAT(windows(engine),
              ElementsAre(Window{0, 0}, Window{2, 40}, Window{4, 43}, Window{4, 63}));
}

TEST(StnEngine, ReportsTheBoundsThatChangedAndNoOther) {
  StnEngine engine = chain();

  engine.set_arc({2, 1, 20});

  EXPECT_THAT(engine.changes(), ElementsAre(BoundChange{3, Bound::kLower, 4}));
}

TEST(StnEngine, KeepsAnyNodeAsTheOrigin) {
  const StnEngine engine = engine_of(network(3, {{2, 0, 4, 5}, {0, 1, 1, 1}}, 2));

  EXPECT_THAT(windows(engine), ElementsAre(Window{4, 5}, Window{5, 6}, Window{0, 0}));
  EXPECT_EQ(engine.arc(0), (Arc{2, 0, 4, 5}));
}

TEST(StnEngine, LeavesAnUntiedNodeUnbounded) {
  const StnEngine engine = engine_of(network(3, {{1, 2, 3, 4}}));

  EXPECT_TRUE(engine.consistent());
  EXPECT_EQ(window(engine, 2), Window(kMinusInfinite, kInfinite));
}

TEST(StnEngine, FindsANegativeCycleAmongUntiedNodes) {
  const StnEngine engine = engine_of(network(4, {{1, 2, 3, 4}, {2, 3, 1, 9}, {3, 1, -3, 0}}));

  EXPECT_FALSE(engine.consistent());
  EXPECT_THAT(engine.conflict(), SizeIs(3));
}

TEST(StnEngine, RecoversWhenARelaxationFreesThePendingConstraint) {
  StnEngine engine = chain();
  engine.set_arc({0, 1, 2});
  const auto id = engine.add_arc({0, 3, 30, 40});
  ASSERT_TRUE(id.has_value());
  EXPECT_FALSE(engine.consistent());
  EXPECT_THAT(engine.conflict(), SizeIs(4));

  engine.set_arc({0, 1, 10});

  EXPECT_TRUE(engine.consistent());
  EXPECT_EQ(window(engine, 3), Window(30, 33));
  EXPECT_EQ(window(engine, 1), Window(7, 10));
}

TEST(StnEngine, RecoversWhenTheConflictingArcIsRemoved) {
  StnEngine engine = chain();
  const auto before = windows(engine);
  const ArcId id = engine.add_arc({0, 3, 50, 60}).value();

  EXPECT_EQ(engine.remove_arc(id), std::nullopt);

  EXPECT_TRUE(engine.consistent());
  EXPECT_EQ(windows(engine), before);
  EXPECT_EQ(engine.arc(id), std::nullopt);
  EXPECT_EQ(engine.arc_count(), 3U);
}

TEST(StnEngine, NamesTheArcsOfTheNegativeCycleInOrder) {
  StnEngine engine = engine_of(network(3, {{0, 1, 5, 9}, {1, 2, 5, 9}, {0, 2, 0, 9}}));

  EXPECT_THAT(engine.conflict(), ::testing::UnorderedElementsAre(ConflictArc{0, Bound::kLower},
                                                                 ConflictArc{1, Bound::kLower},
                                                                 ConflictArc{2, Bound::kUpper}));
}

TEST(StnEngine, TakesBackATentativeChange) {
  StnEngine engine = chain();
  const auto before = windows(engine);

  engine.checkpoint();
  const NodeIndex node = engine.add_node();
  engine.add_arc({3, node, 1, 2}).value();
  engine.set_arc({0, 8, 9});
  engine.remove_arc(2);
  engine.rollback();

  EXPECT_EQ(windows(engine), before);
  EXPECT_EQ(engine.node_count(), 4U);
  EXPECT_EQ(engine.arc(2), (Arc{2, 3, 0, 20}));
}

TEST(StnEngine, TakesBackAnInconsistency) {
  StnEngine engine = chain();

  engine.checkpoint();
  engine.add_arc({0, 3, 50, 60}).value();
  EXPECT_FALSE(engine.consistent());
  engine.rollback();

  EXPECT_TRUE(engine.consistent());
  EXPECT_EQ(window(engine, 3), Window(3, 33));
}

TEST(StnEngine, KeepsTheInnerChangeOnlyAsLongAsTheOuterOne) {
  StnEngine engine = chain();

  engine.checkpoint();
  engine.set_arc({0, 4, 10});
  engine.checkpoint();
  engine.set_arc({0, 6, 10});
  engine.commit();
  EXPECT_EQ(engine.earliest(1), 6);
  engine.rollback();

  EXPECT_EQ(engine.earliest(1), 1);
}

TEST(StnEngine, ReportsWhatAnUndoChangedBack) {
  StnEngine engine = chain();
  engine.checkpoint();
  engine.set_arc({2, 1, 20});

  engine.rollback();

  EXPECT_THAT(engine.changes(), ElementsAre(BoundChange{3, Bound::kLower, 3}));
}

TEST(StnEngine, ACopyIsIndependent) {
  StnEngine engine = chain();
  const StnEngine copy = engine;

  engine.set_arc({0, 6, 10});

  EXPECT_EQ(copy.earliest(1), 1);
}

TEST(StnEngine, RefusesWhatItCannotBuild) {
  const auto error = [](std::vector<Arc> arcs) {
    return StnEngine::make(network(3, std::move(arcs))).error();
  };

  EXPECT_EQ(error({{0, 3, 0, 1}}), (StnRefusal{StnError::kUnknownNode, 0}));
  EXPECT_EQ(error({{0, 1, 0, 1}, {0, 1, 0, 2}}), (StnRefusal{StnError::kArcGivenTwice, 1}));
  EXPECT_EQ(error({{1, 1, 0, 1}}), (StnRefusal{StnError::kArcToItself, 0}));
  EXPECT_EQ(error({{0, 1, 2, 1}}), (StnRefusal{StnError::kEmptyInterval, 0}));
  EXPECT_EQ(error({{0, 1, kInfinite, kInfinite}}), (StnRefusal{StnError::kEmptyInterval, 0}));
  EXPECT_EQ(error({{0, 1, 0, kLargest + 1}}), (StnRefusal{StnError::kOverflow, 0}));
  EXPECT_EQ(StnEngine::make(Stn{}).error(), (StnRefusal{StnError::kUnknownNode, 0}));
}

TEST(StnEngine, RefusedChangesLeaveItAsItWas) {
  StnEngine engine = chain();
  const auto before = windows(engine);

  EXPECT_EQ(error_of(engine.set_arc({9, 0, 1})), StnError::kUnknownArc);
  EXPECT_EQ(error_of(engine.set_arc({0, 3, 2})), StnError::kEmptyInterval);
  EXPECT_EQ(error_of(engine.set_arc({0, -kLargest - 1, 2})), StnError::kOverflow);
  EXPECT_EQ(error_of(engine.remove_arc(3)), StnError::kUnknownArc);
  EXPECT_EQ(engine.add_arc({0, 1, 0, 1}).error().error, StnError::kArcGivenTwice);
  EXPECT_EQ(engine.add_arc({0, 7, 0, 1}).error(), (StnRefusal{StnError::kUnknownNode, 7}));
  const std::vector<ArcBounds> second_wrong = {{0, 5, 6}, {1, 3, 2}};
  EXPECT_EQ(error_of(engine.set_arcs(second_wrong)), StnError::kEmptyInterval);

  EXPECT_EQ(windows(engine), before);
  EXPECT_EQ(engine.arc(0), (Arc{0, 1, 1, 10}));
}

TEST(StnEngine, UndoesAChangeWhoseDatesOverflow) {
  StnEngine engine = engine_of(network(3, {{0, 1, kLargest - 5, kLargest}, {1, 2, 0, kInfinite}}));
  const auto before = windows(engine);

  EXPECT_EQ(error_of(engine.set_arc({1, 6, kInfinite})), StnError::kOverflow);

  EXPECT_EQ(windows(engine), before);
  EXPECT_TRUE(engine.consistent());
  EXPECT_EQ(engine.set_arc({1, 5, kInfinite}), std::nullopt);
  EXPECT_EQ(engine.earliest(2), kLargest);
}

TEST(StnEngine, CostsWhatAChangeRevisesNotTheSizeOfTheNetwork) {
  std::vector<Arc> arcs;
  for (NodeIndex node = 1; node < 20'000; ++node) arcs.push_back({0, node, 0, 100});
  for (NodeIndex node = 2; node < 20'000; node += 2) arcs.push_back({node - 1, node, 1, 50});
  StnEngine engine = engine_of(network(20'000, arcs));
  const std::uint64_t before = engine.checks();

  engine.set_arc({500, 10, 90});

  EXPECT_LE(engine.checks() - before, 20U);
}

TEST(StnEngine, ALongChainIsRaisedInOnePass) {
  std::vector<Arc> arcs;
  for (NodeIndex node = 1; node < 20'000; ++node) arcs.push_back({node - 1, node, 1, 2});
  StnEngine engine = engine_of(network(20'000, arcs));
  const std::uint64_t before = engine.checks();

  engine.set_arc({0, 2, 2});

  EXPECT_EQ(engine.earliest(19'999), 20'000);
  EXPECT_LE(engine.checks() - before, 5U * 20'000);
}

TEST(StnEngine, HoldsAnArcInLessThan200Bytes) {
  std::vector<Arc> arcs;
  for (NodeIndex node = 1; node < 10'000; ++node) arcs.push_back({node - 1, node, 1, 2});
  for (NodeIndex node = 7; node < 10'000; ++node) arcs.push_back({node - 7, node, 1, 30});
  const StnEngine engine = engine_of(network(10'000, arcs));

  EXPECT_LE(engine.memory_bytes() / arcs.size(), 200U);
}

/// A random network under random edits, mirrored as a plain list of arcs.
class RandomEdits {
 public:
  explicit RandomEdits(std::uint64_t seed) : random_(seed) {
    const std::size_t nodes = 2 + random_.below(12);
    for (std::size_t i = 1; i < nodes; ++i) engine_.add_node();
    for (std::size_t i = 0; i < 2 * nodes; ++i) add_arc();
  }

  void step() {
    switch (random_.below(10)) {
      case 0:
        return add_arc();
      case 1:
        return remove_arc();
      case 2:
        return tentative();
      default:
        return set_arcs();
    }
  }

  void compare() const {
    std::vector<Arc> arcs;
    for (const auto& [id, arc] : arcs_) arcs.push_back(arc);
    const auto reference = solve_reference(engine_.node_count(), arcs);
    ASSERT_EQ(engine_.consistent(), reference.consistent);
    if (!reference.consistent) return check_conflict();
    ASSERT_THAT(engine_.conflict(), IsEmpty());
    for (NodeIndex node = 0; node < engine_.node_count(); ++node) {
      ASSERT_EQ(engine_.earliest(node), reference.windows[node].min);
      ASSERT_EQ(engine_.latest(node), reference.windows[node].max);
    }
  }

  bool consistent() const { return engine_.consistent(); }

 private:
  void check_conflict() const {
    const auto cycle = engine_.conflict();
    ASSERT_FALSE(cycle.empty());
    Ticks sum = 0;
    std::set<NodeIndex> passed;
    NodeIndex at = end_of(cycle.back());
    for (const ConflictArc& step : cycle) {
      ASSERT_EQ(start_of(step), at);
      at = end_of(step);
      ASSERT_TRUE(passed.insert(at).second);
      const Arc& arc = arcs_.at(step.arc);
      sum += step.bound == Bound::kLower ? arc.min : -arc.max;
    }
    ASSERT_GT(sum, 0);
  }
  NodeIndex start_of(const ConflictArc& step) const {
    return step.bound == Bound::kLower ? arcs_.at(step.arc).from : arcs_.at(step.arc).to;
  }
  NodeIndex end_of(const ConflictArc& step) const {
    return step.bound == Bound::kLower ? arcs_.at(step.arc).to : arcs_.at(step.arc).from;
  }

  void add_arc() {
    Arc arc = bounds();
    arc.from = static_cast<NodeIndex>(random_.below(engine_.node_count()));
    arc.to = static_cast<NodeIndex>(random_.below(engine_.node_count()));
    const auto id = engine_.add_arc(arc);
    if (id) arcs_[*id] = arc;
  }

  void remove_arc() {
    if (arcs_.empty()) return;
    const ArcId id = any_arc();
    ASSERT_EQ(engine_.remove_arc(id), std::nullopt);
    arcs_.erase(id);
  }

  void set_arcs() {
    if (arcs_.empty()) return;
    std::vector<ArcBounds> changes(1 + random_.below(3));
    for (ArcBounds& change : changes) {
      const Arc arc = bounds();
      change = {any_arc(), arc.min, arc.max};
      arcs_[change.arc].min = arc.min;
      arcs_[change.arc].max = arc.max;
    }
    ASSERT_EQ(engine_.set_arcs(changes), std::nullopt);
  }

  void tentative() {
    const auto before = arcs_;
    engine_.checkpoint();
    for (int i = 0; i < 3; ++i) {
      if (random_.chance(0.3)) add_arc();
      if (random_.chance(0.3)) remove_arc();
      set_arcs();
    }
    if (random_.chance(0.3)) return engine_.commit();
    engine_.rollback();
    arcs_ = before;
  }

  ArcId any_arc() {
    return std::next(arcs_.begin(), static_cast<std::ptrdiff_t>(random_.below(arcs_.size())))
        ->first;
  }

  Arc bounds() {
    const auto middle = static_cast<Ticks>(random_.below(30)) - 12;
    Arc arc{0, 0, middle - static_cast<Ticks>(random_.below(30)),
            middle + static_cast<Ticks>(random_.below(30))};
    if (random_.chance(0.2)) arc.min = kMinusInfinite;
    if (random_.chance(0.2)) arc.max = kInfinite;
    return arc;
  }

  Random random_;
  StnEngine engine_;
  std::map<ArcId, Arc> arcs_;
};

TEST(StnEngine, AgreesWithBellmanFordAfterEveryRandomEdit) {
  int consistent = 0;
  int inconsistent = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    RandomEdits edits(seed);
    for (int i = 0; i < 60; ++i) {
      edits.step();
      SCOPED_TRACE("seed " + std::to_string(seed) + " step " + std::to_string(i));
      edits.compare();
      if (HasFatalFailure()) return;
      ++(edits.consistent() ? consistent : inconsistent);
    }
  }
  EXPECT_GT(consistent, 3000);
  EXPECT_GT(inconsistent, 3000);
}

}  // namespace
}  // namespace skein::temporal
