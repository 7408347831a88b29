// SPDX-License-Identifier: Apache-2.0
// Nodes and links that come and go leave the verdict, and all that is kept, as from scratch.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "any_stnu.hpp"
#include "controllability/back_propagation.hpp"
#include "skein/temporal/incremental_controllability.hpp"
#include "stnu_builder.hpp"

namespace skein::temporal {
namespace {

using testing::any_network;
using testing::between;
using testing::draw;
using testing::random_stnu;
using testing::StnuBuilder;

IncrementalDc incremental(const Stnu& network) {
  auto created = IncrementalDc::create(network);
  EXPECT_TRUE(created.has_value());
  return std::move(*created);
}

TEST(IncrementalStructure, ATaskComesAndGoes) {
  IncrementalDc check = incremental(StnuBuilder("z").build());

  const NodeIndex start = check.add_node("start"), end = check.add_node("end");
  EXPECT_TRUE(check.add_contingent({start, end, 2, 5})->controllable);
  EXPECT_TRUE(check.add_arc({start, end, kMinusInfinite, 5})->controllable);
  EXPECT_FALSE(check.add_arc({start, end, kMinusInfinite, 4})->controllable);
  const std::uint32_t deadline = check.placed();
  EXPECT_TRUE(check.result().consistent);
  EXPECT_TRUE(check.remove_arc(deadline)->controllable);
  EXPECT_TRUE(check.remove_contingent(0)->controllable);
  EXPECT_TRUE(check.add_arc({start, end, 1, 1})->controllable);
  EXPECT_EQ(check.placed(), deadline) << "the place is used again";
}

TEST(IncrementalStructure, TheLastContingentLinkTakesThePositionOfTheOneThatGoes) {
  IncrementalDc check = incremental(StnuBuilder("z a b c d")
                                        .contingent("z", "a", 1, 2)
                                        .contingent("z", "b", 3, 4)
                                        .contingent("z", "c", 5, 9)
                                        .build());

  check.remove_contingent(0);
  const auto broken = check.add_arc({0, 3, kMinusInfinite, 7});

  EXPECT_EQ(check.network().contingent.front().contingent, 3U);
  ASSERT_FALSE(broken->controllable);
  for (const ConflictTerm& term : broken->conflict) {
    const bool of_c = term.link.kind == LinkKind::kRequirement || term.link.index == 0;
    EXPECT_TRUE(of_c);
  }
}

TEST(IncrementalStructure, BadChangesAreNamedErrorsAndChangeNothing) {
  IncrementalDc check = incremental(StnuBuilder("z a c").contingent("a", "c", 2, 5).build());
  const Stnu before = check.network();

  EXPECT_EQ(check.add_arc({0, 9, 0, 1}).error().fault, StnuFault::kUnknownNode);
  EXPECT_EQ(check.add_contingent({0, 2, 1, 2}).error().fault, StnuFault::kSharedContingentEnd);
  EXPECT_EQ(check.add_contingent({0, 1, 0, 2}).error().fault, StnuFault::kContingentNotPositive);
  EXPECT_EQ(check.remove_contingent(1).error().fault, StnuFault::kUnknownLink);
  EXPECT_EQ(check.remove_arc(0).error().fault, StnuFault::kUnknownLink);
  EXPECT_EQ(check.network(), before);
}

/// Changes of every kind, drawn so that the network stays about as full as it was.
class Changer {
 public:
  Changer(IncrementalDc& check, std::uint64_t seed) : check_(check), random_(seed) {
    for (std::uint32_t i = 0; i < check.network().arcs.size(); ++i) arcs_.push_back(i);
  }

  Result<DcResult, StnuError> change() {
    switch (random_.below(7)) {
      case 0:
        check_.add_node("more");
        return check_.result();
      case 1:
        return add_contingent();
      case 2:
        return remove_contingent();
      case 3:
        return change_contingent();
      case 4:
        return remove_arc();
      case 5:
        return change_arc();
      default:
        return add_arc();
    }
  }

 private:
  NodeIndex any_node() {
    return static_cast<NodeIndex>(random_.below(check_.network().nodes.size()));
  }
  Result<DcResult, StnuError> add_arc() {
    const NodeIndex from = any_node(), to = any_node();
    if (from == to) return check_.result();
    const Ticks min = draw(-15, 8, random_);
    Arc arc{from, to, min, min + draw(0, 15, random_)};
    if (random_.chance(0.4)) arc.min = kMinusInfinite;
    if (random_.chance(0.4)) arc.max = kInfinite;
    auto result = check_.add_arc(arc);
    arcs_.push_back(check_.placed());
    return result;
  }
  Result<DcResult, StnuError> remove_arc() {
    if (arcs_.empty()) return check_.result();
    const auto at = arcs_.begin() + static_cast<std::ptrdiff_t>(random_.below(arcs_.size()));
    const std::uint32_t arc = *at;
    arcs_.erase(at);
    return check_.remove_arc(arc);
  }
  Result<DcResult, StnuError> change_arc() {
    if (arcs_.empty()) return check_.result();
    const std::uint32_t arc = arcs_[random_.below(arcs_.size())];
    const Ticks min = draw(-15, 8, random_);
    return check_.change_arc(arc, min, min + draw(0, 15, random_));
  }
  ContingentLink any_link(NodeIndex from, NodeIndex to) {
    const Ticks min = draw(1, 8, random_);
    return {from, to, min, random_.chance(0.1) ? min : draw(min, 12, random_)};
  }
  Result<DcResult, StnuError> add_contingent() {
    const NodeIndex from = any_node(), to = any_node();
    const auto& links = check_.network().contingent;
    const bool taken = std::any_of(links.begin(), links.end(),
                                   [&](const ContingentLink& one) { return one.contingent == to; });
    if (from == to || to == 0 || taken) return check_.result();
    return check_.add_contingent(any_link(from, to));
  }
  Result<DcResult, StnuError> remove_contingent() {
    const auto& links = check_.network().contingent;
    if (links.empty()) return check_.result();
    return check_.remove_contingent(static_cast<std::uint32_t>(random_.below(links.size())));
  }
  Result<DcResult, StnuError> change_contingent() {
    const auto& links = check_.network().contingent;
    if (links.empty()) return check_.result();
    const auto link = static_cast<std::uint32_t>(random_.below(links.size()));
    const ContingentLink changed = any_link(0, 1);
    return check_.change_contingent(link, changed.min, changed.max);
  }

  IncrementalDc& check_;
  Random random_;
  std::vector<std::uint32_t> arcs_;
};

RC_GTEST_PROP(IncrementalStructure, RandomChangesAgreeWithChecksFromScratch, (std::uint64_t seed)) {
  IncrementalDc check = incremental(any_network());
  Changer changer(check, seed);

  for (int step = 0; step < 60; ++step) {
    const auto result = changer.change();

    RC_ASSERT(result.has_value());
    const auto scratch = check_dynamic_controllability(check.network());
    RC_ASSERT(result->controllable == scratch->controllable);
    RC_ASSERT(result->consistent == scratch->consistent);
    RC_ASSERT(result->conflict.empty() == result->controllable);
    const Stnu part = testing::named_part(check.network(), result->conflict);
    RC_ASSERT(result->controllable || !BackPropagation(part, false).run());
  }
}

// The law above would hold of verdicts that never change: how much it is about.
TEST(IncrementalStructure, RandomChangesBreakAndMend) {
  int controllable = 0, broken = 0, local = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    IncrementalDc check = incremental(random_stnu({8, 3, 10, 12, false, 0}, random));
    Changer changer(check, seed);
    for (int step = 0; step < 60; ++step) {
      const auto before = check.network().contingent;
      const auto result = changer.change();
      ++(result->controllable ? controllable : broken);
      const bool moved = !(before == check.network().contingent);
      if (moved && result->controllable && result->counters.derived_edges == 0) ++local;
    }
  }
  EXPECT_GT(controllable, 500);
  EXPECT_GT(broken, 500);
  EXPECT_GT(local, 100) << "links that came or went without a check from scratch";
}

}  // namespace
}  // namespace skein::temporal
