// SPDX-License-Identifier: Apache-2.0
// The incremental check says what a check from scratch says, after any sequence of changes.
#include "skein/temporal/incremental_controllability.hpp"

#include <gtest/gtest.h>

#include "controllability/back_propagation.hpp"
#include "random_stnu.hpp"
#include "skein/temporal_lab/stnu_generator.hpp"
#include "stnu_builder.hpp"
#include "test_cases.hpp"

namespace skein::temporal {
namespace {

using testing::draw;
using testing::random_stnu;
using testing::StnuBuilder;

IncrementalDc incremental(const Stnu& network) {
  auto created = IncrementalDc::create(network);
  EXPECT_TRUE(created.has_value());
  return std::move(*created);
}

Stnu deadline_task() {
  return StnuBuilder("z a c")
      .contingent("a", "c", 2, 5)
      .arc("a", "c", 0, 5)
      .arc("z", "a", 0, 10)
      .build();
}

TEST(IncrementalDc, TighteningADeadlineBreaksAndLooseningMends) {
  IncrementalDc check = incremental(deadline_task());

  EXPECT_TRUE(check.result().controllable);
  EXPECT_FALSE(check.change_arc(0, 0, 4)->controllable);
  EXPECT_TRUE(check.result().consistent);
  EXPECT_FALSE(check.change_arc(0, 0, 1)->consistent);
  EXPECT_TRUE(check.change_arc(0, 0, 6)->controllable);
}

TEST(IncrementalDc, ANetworkThatStartsBrokenCanBeMended) {
  Stnu network = deadline_task();
  network.arcs[0].max = 3;
  IncrementalDc check = incremental(network);

  EXPECT_FALSE(check.result().controllable);
  EXPECT_FALSE(check.change_arc(1, 0, 20)->controllable);
  EXPECT_TRUE(check.change_arc(0, kMinusInfinite, kInfinite)->controllable);
  EXPECT_FALSE(check.change_arc(0, 0, 4)->controllable);
}

TEST(IncrementalDc, AChangeOfAContingentLinkIsCheckedToo) {
  IncrementalDc check = incremental(deadline_task());

  EXPECT_FALSE(check.change_contingent(0, 2, 6)->controllable);
  EXPECT_TRUE(check.change_contingent(0, 5, 5)->controllable);
  EXPECT_TRUE(check.change_contingent(0, 1, 4)->controllable);
}

TEST(IncrementalDc, ABadChangeIsANamedErrorAndChangesNothing) {
  IncrementalDc check = incremental(deadline_task());
  const Stnu before = check.network();

  EXPECT_EQ(check.change_arc(9, 0, 1).error().fault, StnuFault::kUnknownLink);
  EXPECT_EQ(check.change_arc(0, 2, 1).error().fault, StnuFault::kEmptyInterval);
  EXPECT_EQ(check.change_arc(0, 0, kLargest + 1).error().fault, StnuFault::kOverflow);
  EXPECT_EQ(check.change_contingent(4, 1, 2).error().fault, StnuFault::kUnknownLink);
  EXPECT_EQ(check.change_contingent(0, 0, 2).error().fault, StnuFault::kContingentNotPositive);
  EXPECT_EQ(to_text(check.change_arc(9, 0, 1).error(), before), "link #9: unknown link");
  EXPECT_EQ(check.network(), before);
  EXPECT_TRUE(check.result().controllable);
}

TEST(IncrementalDc, AnOverflowLeavesTheStateAsItWas) {
  Stnu network =
      StnuBuilder("z a b c").arc("z", "a", 0, 1).arc("a", "b", 0, 1).arc("b", "c", 0, 1).build();
  for (Arc& arc : network.arcs) arc.max = kInfinite;
  network.arcs[0].min = kLargest;
  network.arcs[1].min = kLargest;
  IncrementalDc check = incremental(network);

  EXPECT_EQ(check.change_arc(2, kLargest, kInfinite).error().fault, StnuFault::kOverflow);
  EXPECT_EQ(check.network(), network);
  EXPECT_TRUE(check.change_arc(2, 0, 3)->controllable);
}

TEST(IncrementalDc, LargeChangesToAndFroNeverOverflowWhatIsKept) {
  IncrementalDc check =
      incremental(StnuBuilder("z a").arc("z", "a", 0, 1).arc("a", "z", 0, 1).build());
  check.change_arc(0, kMinusInfinite, kInfinite);
  check.change_arc(1, kMinusInfinite, kInfinite);
  for (int i = 0; i < 20; ++i) {
    for (const std::uint32_t arc : {0U, 1U}) {
      EXPECT_TRUE(check.change_arc(arc, kLargest, kInfinite)->controllable);
      EXPECT_TRUE(check.change_arc(arc, kMinusInfinite, kInfinite)->controllable);
    }
  }
}

/// New bounds: a little tighter or looser than before, or the bounds the arc had first.
Arc changed(const Arc& arc, const Arc& first, Ticks most, Random& random) {
  Arc next = random.chance(0.3) ? first : arc;
  const auto shift = [&](Ticks& bound) {
    if (bound != kInfinite && bound != kMinusInfinite) bound += draw(-most, most, random);
  };
  if (random.chance(0.1)) next.min = kMinusInfinite;
  if (random.chance(0.1)) next.max = kInfinite;
  if (random.chance(0.7)) shift(next.min);
  if (random.chance(0.7)) shift(next.max);
  if (next.min > next.max) next = first;
  return next;
}

TEST(IncrementalDc, RandomChangesAgreeWithAChecksFromScratch) {
  Random random(31);
  int controllable = 0;
  int broken = 0;
  for (int i = 0; i < 600; ++i) {
    const auto nodes = static_cast<std::uint32_t>(4 + random.below(11));
    const Stnu first = random_stnu({nodes, 1 + nodes / 3, 2 * nodes, 12, false, 0}, random);
    if (first.arcs.empty()) continue;
    IncrementalDc check = incremental(first);
    for (int step = 0; step < 30; ++step) {
      const auto arc = static_cast<std::uint32_t>(random.below(first.arcs.size()));
      const Arc next = changed(check.network().arcs[arc], first.arcs[arc], 6, random);

      const auto result = check.change_arc(arc, next.min, next.max);

      ASSERT_TRUE(result.has_value());
      const auto scratch = check_dynamic_controllability(check.network());
      ASSERT_EQ(result->controllable, scratch->controllable) << "network " << i << " step " << step;
      ASSERT_EQ(result->consistent, scratch->consistent) << "network " << i << " step " << step;
      ASSERT_EQ(result->conflict.empty(), result->controllable);
      ++(result->controllable ? controllable : broken);
    }
  }
  EXPECT_GT(controllable, 4'000);
  EXPECT_GT(broken, 4'000);
}

TEST(IncrementalDc, TheConflictItKeepsIsOneOfTheNetworkAsItIs) {
  Random random(32);
  for (int i = 0; i < 200; ++i) {
    const Stnu first = random_stnu({10, 4, 20, 12, false, 0}, random);
    IncrementalDc check = incremental(first);
    for (int step = 0; step < 30; ++step) {
      const auto arc = static_cast<std::uint32_t>(random.below(first.arcs.size()));
      const Arc next = changed(check.network().arcs[arc], first.arcs[arc], 6, random);
      const auto result = check.change_arc(arc, next.min, next.max);
      if (result->controllable) continue;

      const Stnu part = testing::named_part(check.network(), result->conflict);

      ASSERT_FALSE(BackPropagation(part, false).run()) << "network " << i << " step " << step;
    }
  }
}

TEST(IncrementalDc, PlansOfTheBenchmarkFamilyAgreeWithAChecksFromScratch) {
  Random random(33);
  const Stnu first = generate_stnu(
      {.nodes = 200, .contingent = 30, .lanes = 5, .extra_arcs_percent = 65, .break_it = false},
      random);
  IncrementalDc check = incremental(first);
  const int steps = skein::testing::cases(200, 1'000);
  for (int step = 0; step < steps; ++step) {
    const auto arc = static_cast<std::uint32_t>(random.below(first.arcs.size()));
    const Arc next =
        changed(check.network().arcs[arc], first.arcs[arc], 30 * kTicksPerSecond, random);

    const auto result = check.change_arc(arc, next.min, next.max);

    ASSERT_TRUE(result.has_value());
    ASSERT_EQ(result->controllable, check_dynamic_controllability(check.network())->controllable)
        << step;
    if (!result->controllable) check.change_arc(arc, first.arcs[arc].min, first.arcs[arc].max);
  }
}

}  // namespace
}  // namespace skein::temporal
