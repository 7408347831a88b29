// SPDX-License-Identifier: Apache-2.0
// The incremental check at the edges: exactly where a verdict turns, errors while broken, changes
// that cancel out, contingent links among them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "any_stnu.hpp"
#include "skein/temporal/incremental_controllability.hpp"
#include "stnu_builder.hpp"

namespace skein::temporal {
namespace {

using testing::any_arc;
using testing::any_network;
using testing::between;
using testing::StnuBuilder;

IncrementalDc incremental(const Stnu& network) { return IncrementalDc::create(network).value(); }

/// Tasks a -> b of 2 to 4 (link 0) and c -> d of 3 to 6 (link 1); arcs: 0 the pause b -> c of 0 to
/// 5, 1 the whole a -> d of 0 to 10, 2 the start z -> a of 0 to 20.
Stnu in_turn() {
  return StnuBuilder("z a b c d")
      .contingent("a", "b", 2, 4)
      .contingent("c", "d", 3, 6)
      .arc("b", "c", 0, 5)
      .arc("a", "d", 0, 10)
      .arc("z", "a", 0, 20)
      .build();
}

bool controllable(const Result<DcResult, StnuError>& result) { return result.value().controllable; }

TEST(IncrementalDcEdges, TheVerdictTurnsAtOneNanosecondToAndFro) {
  IncrementalDc check = incremental(in_turn());

  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(controllable(check.change_arc(1, 0, 9))) << i;
    EXPECT_TRUE(check.result().consistent);
    EXPECT_TRUE(controllable(check.change_arc(1, 0, 10))) << i;
  }
}

TEST(IncrementalDcEdges, BothBoundsTurnIt) {
  IncrementalDc check = incremental(in_turn());

  EXPECT_TRUE(controllable(check.change_arc(1, 10, 13))) << "2 + 5 + 3 and a spread of 3";
  EXPECT_FALSE(controllable(check.change_arc(1, 11, 14))) << "2 + 5 + 3 is too early";
  EXPECT_FALSE(controllable(check.change_arc(1, 10, 12))) << "a spread of 2";
  EXPECT_TRUE(controllable(check.change_arc(1, 9, 12)));
}

TEST(IncrementalDcEdges, TheSameBoundsAgainAreNoWork) {
  IncrementalDc check = incremental(in_turn());

  const auto result = check.change_arc(1, 0, 10);

  EXPECT_TRUE(controllable(result));
  EXPECT_EQ(result->counters.searches, 0U);
  EXPECT_EQ(check.network(), in_turn());
}

TEST(IncrementalDcEdges, TwoTighteningsMayBreakWhatEachAloneDoesNot) {
  IncrementalDc check = incremental(in_turn());

  check.change_arc(1, 0, 11);
  EXPECT_TRUE(controllable(check.change_arc(0, 1, 5))) << "4 + 1 + 6";
  EXPECT_FALSE(controllable(check.change_arc(1, 0, 10)));
  EXPECT_TRUE(controllable(check.change_arc(0, 0, 5))) << "the pause may give way";
  EXPECT_FALSE(controllable(check.change_arc(0, 1, 5)));
  EXPECT_TRUE(controllable(check.change_arc(1, 0, 11))) << "or the deadline";
}

TEST(IncrementalDcEdges, LooseningBesideTheConflictDoesNotHelpAndIsRemembered) {
  IncrementalDc check = incremental(in_turn());
  check.change_arc(1, 0, 9);

  EXPECT_FALSE(controllable(check.change_arc(2, 0, 200)));
  EXPECT_EQ(check.network().arcs[2].max, 200);
  EXPECT_TRUE(controllable(check.change_arc(1, 0, 10)));
  EXPECT_EQ(check.network().arcs[2].max, 200);
}

TEST(IncrementalDcEdges, GoesThroughAllThreeVerdictsAndBack) {
  IncrementalDc check = incremental(in_turn());

  check.change_arc(1, 0, 9);
  EXPECT_TRUE(check.result().consistent);
  check.change_arc(1, 0, 4);
  EXPECT_FALSE(check.result().consistent) << "2 + 3 > 4";
  check.change_arc(1, 0, 5);
  EXPECT_TRUE(check.result().consistent);
  EXPECT_FALSE(check.result().controllable);
  check.change_arc(1, kMinusInfinite, kInfinite);
  EXPECT_TRUE(check.result().controllable);
}

TEST(IncrementalDcEdges, AContingentLinkTurnsTheVerdictAtOneNanosecondToo) {
  IncrementalDc check = incremental(in_turn());

  EXPECT_FALSE(controllable(check.change_contingent(0, 2, 5)));
  EXPECT_TRUE(controllable(check.change_contingent(1, 3, 5))) << "5 + 5";
  EXPECT_TRUE(controllable(check.change_contingent(0, 1, 5))) << "sooner is no harm";
  EXPECT_FALSE(controllable(check.change_arc(1, 0, 9)));
}

TEST(IncrementalDcEdges, EveryErrorLeavesNetworkAndVerdictWhateverTheyAre) {
  for (const Ticks deadline : {Ticks{10}, Ticks{9}, Ticks{4}}) {
    IncrementalDc check = incremental(in_turn());
    check.change_arc(1, 0, deadline);
    const Stnu network = check.network();
    const DcResult result = check.result();
    const auto refused = [&](const Result<DcResult, StnuError>& answer) {
      EXPECT_EQ(check.network(), network);
      EXPECT_EQ(check.result().consistent, result.consistent);
      EXPECT_EQ(check.result().controllable, result.controllable);
      EXPECT_EQ(check.result().conflict, result.conflict);
      EXPECT_FALSE(answer.has_value());
      return answer ? StnuFault::kNotControllable : answer.error().fault;
    };

    EXPECT_EQ(refused(check.change_arc(3, 0, 1)), StnuFault::kUnknownLink);
    EXPECT_EQ(refused(check.change_arc(1, 8, 7)), StnuFault::kEmptyInterval);
    EXPECT_EQ(refused(check.change_arc(1, kInfinite, kInfinite)), StnuFault::kEmptyInterval);
    EXPECT_EQ(refused(check.change_arc(1, -kLargest - 1, 7)), StnuFault::kOverflow);
    EXPECT_EQ(refused(check.change_contingent(2, 1, 2)), StnuFault::kUnknownLink);
    EXPECT_EQ(refused(check.change_contingent(0, 0, 4)), StnuFault::kContingentNotPositive);
    EXPECT_EQ(refused(check.change_contingent(0, kMinusInfinite, 4)),
              StnuFault::kContingentNotPositive);
    EXPECT_EQ(refused(check.change_contingent(0, 2, kInfinite)), StnuFault::kContingentUnbounded);
    EXPECT_EQ(refused(check.change_contingent(0, 5, 4)), StnuFault::kEmptyInterval);
    EXPECT_EQ(refused(check.change_contingent(0, 2, kLargest + 1)), StnuFault::kOverflow);
    EXPECT_TRUE(controllable(check.change_arc(1, 0, 10))) << "and it goes on";
  }
}

TEST(IncrementalDcEdges, IsNotMadeOfABadNetwork) {
  Stnu network = in_turn();
  network.contingent[1].contingent = network.contingent[0].contingent;

  const auto created = IncrementalDc::create(network);

  ASSERT_FALSE(created.has_value());
  EXPECT_EQ(created.error(),
            (StnuError{StnuFault::kSharedContingentEnd, LinkRef{LinkKind::kContingent, 1}}));
}

TEST(IncrementalDcEdges, AMovedOneGoesOn) {
  IncrementalDc first = incremental(in_turn());
  first.change_arc(1, 0, 9);

  IncrementalDc second = std::move(first);
  EXPECT_FALSE(second.result().controllable);
  IncrementalDc third = incremental(StnuBuilder("z").build());
  third = std::move(second);

  EXPECT_TRUE(controllable(third.change_arc(1, 0, 10)));
}

/// x at first no more than 5 before the end of a -> c (arc 0), and free of a (arc 1).
TEST(IncrementalDcEdges, ANodeThatCameBehindTheEndAndIsSetFreeIsFree) {
  IncrementalDc check = incremental(StnuBuilder("z a c x")
                                        .contingent("a", "c", 1, 10)
                                        .arc("x", "c", kMinusInfinite, 5)
                                        .arc("a", "x", kMinusInfinite, kInfinite)
                                        .build());

  EXPECT_TRUE(controllable(check.change_arc(0, kMinusInfinite, -1))) << "x waits for c";
  EXPECT_TRUE(controllable(check.change_arc(0, kMinusInfinite, kInfinite)));
  EXPECT_TRUE(controllable(check.change_arc(1, kMinusInfinite, 0))) << "x may come before a";
  EXPECT_FALSE(controllable(check.change_arc(0, kMinusInfinite, 5))) << "c may come 10 after a";
}

/// Narrow or wide, at times open at an end, at times the first again.
Arc any_bounds(const Arc& first) {
  if (between(0, 5) == 0) return first;
  Arc arc{first.from, first.to, between<Ticks>(-20, 12), 0};
  arc.max = arc.min + between<Ticks>(0, between(0, 2) == 0 ? 8 : 40);
  if (between(0, 4) == 0) arc.min = kMinusInfinite;
  if (between(0, 4) == 0) arc.max = kInfinite;
  return arc;
}

RC_GTEST_PROP(IncrementalDcEdges, ChangesOfArcsAndOfLinksMixedAgreeWithACheckFromScratch, ()) {
  const Stnu first = any_network();
  RC_PRE(!first.arcs.empty() && !first.contingent.empty());
  IncrementalDc check = incremental(first);

  for (int step = 0; step < 40; ++step) {
    if (between(0, 20) == 0) {
      const auto link =
          between<std::uint32_t>(0, static_cast<std::uint32_t>(first.contingent.size()));
      const Ticks min = between<Ticks>(1, 9);
      RC_ASSERT(check.change_contingent(link, min, min + between<Ticks>(0, 6)).has_value());
    } else {
      const std::uint32_t arc = any_arc(first);
      const Arc next = any_bounds(first.arcs[arc]);
      RC_ASSERT(check.change_arc(arc, next.min, next.max).has_value());
    }
    const auto scratch = check_dynamic_controllability(check.network());
    RC_ASSERT(check.result().controllable == scratch->controllable);
    RC_ASSERT(check.result().consistent == scratch->consistent);
    if (scratch->controllable) continue;
    const Stnu part = testing::named_part(check.network(), check.result().conflict);
    RC_ASSERT(!check_dynamic_controllability(part)->controllable);
  }
}

RC_GTEST_PROP(IncrementalDcEdges, TheOrderOfChangesDoesNotMatter, ()) {
  const Stnu first = any_network();
  RC_PRE(first.arcs.size() >= 2U);
  std::vector<Arc> wanted = first.arcs;
  for (Arc& arc : wanted) {
    if (arc.min != kMinusInfinite) arc.min += between<Ticks>(-4, 1);
    if (arc.max != kInfinite) arc.max += between<Ticks>(0, 5);
  }
  std::vector<std::uint32_t> order(wanted.size());
  std::iota(order.begin(), order.end(), 0U);
  IncrementalDc forwards = incremental(first);
  IncrementalDc backwards = incremental(first);

  for (const std::uint32_t arc : order) forwards.change_arc(arc, wanted[arc].min, wanted[arc].max);
  std::reverse(order.begin(), order.end());
  for (const std::uint32_t arc : order) backwards.change_arc(arc, wanted[arc].min, wanted[arc].max);

  RC_ASSERT(forwards.network() == backwards.network());
  RC_ASSERT(forwards.result().controllable == backwards.result().controllable);
  RC_ASSERT(forwards.result().consistent == backwards.result().consistent);
}

RC_GTEST_PROP(IncrementalDcEdges, WhatIsPutBackHasItsFirstVerdict, ()) {
  const Stnu first = any_network();
  RC_PRE(!first.arcs.empty());
  IncrementalDc check = incremental(first);
  const bool before = check.result().controllable;

  for (int i = 0; i < 8; ++i) {
    const std::uint32_t arc = any_arc(first);
    const Ticks min = between<Ticks>(-20, 20);
    RC_ASSERT(check.change_arc(arc, min, min + between<Ticks>(0, 10)).has_value());
  }
  for (std::uint32_t arc = 0; arc < first.arcs.size(); ++arc) {
    RC_ASSERT(check.change_arc(arc, first.arcs[arc].min, first.arcs[arc].max).has_value());
  }

  RC_ASSERT(check.network() == first);
  RC_ASSERT(check.result().controllable == before);
}

}  // namespace
}  // namespace skein::temporal
