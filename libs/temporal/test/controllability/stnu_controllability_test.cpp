// SPDX-License-Identifier: Apache-2.0
// Controllability: textbook cases, bad input, and agreement with two other ways to decide it.
#include "skein/temporal/stnu_controllability.hpp"

#include <gtest/gtest.h>

#include <set>

#include "controllability/back_propagation.hpp"
#include "random_stnu.hpp"
#include "skein/temporal_lab/stnu_generator.hpp"
#include "stnu_builder.hpp"
#include "stnu_game.hpp"
#include "test_cases.hpp"

namespace skein::temporal {
namespace {

using testing::named_part;
using testing::random_stnu;
using testing::RandomStnuOptions;
using testing::StnuBuilder;

DcResult check(const Stnu& network) {
  const auto result = check_dynamic_controllability(network);
  EXPECT_TRUE(result.has_value()) << (result ? "" : to_text(result.error(), network));
  return result.value_or(DcResult{});
}

Stnu with_nature_tamed(Stnu network) {
  for (const ContingentLink& link : network.contingent) {
    network.arcs.push_back({link.activation, link.contingent, link.min, link.max});
  }
  network.contingent.clear();
  return network;
}

TEST(Controllability, ATaskThatMayLastLongerThanItsDeadlineIsNotControllable) {
  const Stnu network = StnuBuilder("z a c").contingent("a", "c", 2, 5).arc("a", "c", 0, 4).build();

  const DcResult result = check(network);

  EXPECT_TRUE(result.consistent);
  EXPECT_FALSE(result.controllable);
  EXPECT_EQ(result.conflict.size(), 2U);
}

TEST(Controllability, ANodeThatFollowsAnEndByReactionIsControllable) {
  const Stnu network =
      StnuBuilder("z a c x").contingent("a", "c", 2, 5).arc("c", "x", 0, 1).build();

  EXPECT_TRUE(check(network).controllable);
}

TEST(Controllability, ANodeThatMustPrecedeAnUncertainEndCloselyIsNotControllable) {
  const Stnu network =
      StnuBuilder("z a c x").contingent("a", "c", 2, 5).arc("x", "c", 1, 2).build();

  EXPECT_FALSE(check(network).controllable);
}

TEST(Controllability, ANodeMayPrecedeAnEndByAsMuchAsIsUncertain) {
  const Stnu network =
      StnuBuilder("z a c x").contingent("a", "c", 2, 5).arc("x", "c", 0, 3).build();

  EXPECT_TRUE(check(network).controllable);
}

TEST(Controllability, TwoUncertainEndsCannotBeMadeToMeet) {
  const Stnu network = StnuBuilder("z a c b d")
                           .contingent("a", "c", 2, 6)
                           .contingent("b", "d", 2, 6)
                           .arc("c", "d", -1, 1)
                           .build();

  const DcResult result = check(network);

  EXPECT_TRUE(result.consistent);
  EXPECT_FALSE(result.controllable);
}

TEST(Controllability, AChainOfContingentLinksAddsItsUncertainty) {
  StnuBuilder builder("z a b c");
  builder.contingent("a", "b", 2, 4).contingent("b", "c", 3, 6);

  EXPECT_TRUE(check(StnuBuilder(builder).arc("a", "c", 5, 10).build()).controllable);
  EXPECT_FALSE(check(StnuBuilder(builder).arc("a", "c", 5, 9).build()).controllable);
  EXPECT_FALSE(check(StnuBuilder(builder).arc("a", "c", 6, 10).build()).controllable);
}

TEST(Controllability, ALoopOfContingentLinksIsInconsistent) {
  const Stnu network =
      StnuBuilder("z a b").contingent("a", "b", 1, 2).contingent("b", "a", 1, 2).build();

  const DcResult result = check(network);

  EXPECT_FALSE(result.consistent);
  EXPECT_FALSE(result.conflict.empty());
}

TEST(Controllability, AFixedContingentLinkIsARequirement) {
  const Stnu network =
      StnuBuilder("z a c x").contingent("a", "c", 3, 3).arc("x", "c", 1, 1).build();

  EXPECT_TRUE(check(network).controllable);
}

TEST(Controllability, AnInconsistentNetworkNamesItsNegativeCycle) {
  const Stnu network =
      StnuBuilder("z a b c").arc("a", "b", 5, 9).arc("b", "c", 0, 3).arc("a", "c", 0, 4).build();

  const DcResult result = check(network);

  EXPECT_FALSE(result.consistent);
  const std::set<ConflictTerm> named(result.conflict.begin(), result.conflict.end());
  const auto arc = [](std::uint32_t index) { return LinkRef{LinkKind::kRequirement, index}; };
  EXPECT_EQ(named,
            (std::set<ConflictTerm>{
                {arc(0), LinkBound::kMin}, {arc(1), LinkBound::kMin}, {arc(2), LinkBound::kMax}}));
}

TEST(Controllability, AZeroCycleIsNoConflict) {
  const Stnu network =
      StnuBuilder("z a b").arc("a", "b", 5, 5).arc("b", "a", -5, -5).arc("a", "a", 0, 0).build();

  EXPECT_TRUE(check(network).controllable);
}

TEST(Controllability, ASelfLoopThatAsksForTimeIsInconsistent) {
  const Stnu network = StnuBuilder("z a").arc("a", "a", 1, 2).build();

  EXPECT_FALSE(check(network).consistent);
}

TEST(Controllability, TheLargestValuesAreHandledExactly) {
  Stnu network = StnuBuilder("z a c").contingent("a", "c", 1, 2).build();
  network.contingent[0].max = kLargest;
  network.arcs = {{1, 2, -kLargest, kLargest}};

  EXPECT_TRUE(check(network).controllable);

  network.arcs[0].max = kLargest - 1;

  EXPECT_FALSE(check(network).controllable);
}

TEST(Controllability, ALargeNegativeCycleIsInconsistentRatherThanAnOverflow) {
  Stnu network = StnuBuilder("z a b").build();
  network.arcs = {{1, 2, kLargest, kInfinite}, {2, 1, kLargest, kInfinite}};

  EXPECT_FALSE(check(network).consistent);
}

TEST(Controllability, ADistanceThatDoesNotFitIsANamedError) {
  Stnu network = StnuBuilder("z a b c d").build();
  network.arcs = {
      {0, 1, kLargest, kInfinite}, {1, 2, kLargest, kInfinite}, {2, 3, kLargest, kInfinite}};

  const auto result = check_dynamic_controllability(network);

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().fault, StnuFault::kOverflow);
}

TEST(Controllability, ALongChainNeedsNoDeepStack) {
  Stnu network;
  constexpr std::uint32_t kNodes = 20'001;
  for (std::uint32_t node = 0; node < kNodes; ++node) network.nodes.push_back(std::to_string(node));
  for (std::uint32_t node = 0; node + 1 < kNodes; ++node) {
    if (node % 100 == 50) {
      network.contingent.push_back({node, node + 1, 1, 2});
    } else {
      network.arcs.push_back({node, node + 1, 1, 1});
    }
  }

  EXPECT_TRUE(check(network).controllable);
}

TEST(Controllability, BadLinksAreNamedErrors) {
  struct Case {
    StnuFault fault;
    Stnu network;
  };
  const StnuBuilder three("z a c");
  Stnu stranger = three.build();
  stranger.arcs = {{1, 7, 0, 1}};
  Stnu origin = three.build();
  origin.origin = 9;
  Stnu large = three.build();
  large.arcs = {{0, 1, 0, kLargest + 1}};
  const std::vector<Case> cases = {
      {StnuFault::kUnknownNode, stranger},
      {StnuFault::kUnknownNode, origin},
      {StnuFault::kOverflow, large},
      {StnuFault::kEmptyInterval, StnuBuilder(three).arc("a", "c", 2, 1).build()},
      {StnuFault::kEmptyInterval, StnuBuilder(three).contingent("a", "c", 2, 1).build()},
      {StnuFault::kContingentNotPositive, StnuBuilder(three).contingent("a", "c", 0, 1).build()},
      {StnuFault::kContingentLoop, StnuBuilder(three).contingent("a", "a", 1, 2).build()},
      {StnuFault::kSharedContingentEnd,
       StnuBuilder(three).contingent("a", "c", 1, 2).contingent("z", "c", 1, 2).build()},
  };
  for (const Case& bad : cases) {
    const auto result = check_dynamic_controllability(bad.network);

    ASSERT_FALSE(result.has_value()) << to_text(bad.fault);
    EXPECT_EQ(result.error().fault, bad.fault);
    EXPECT_FALSE(to_text(result.error(), bad.network).empty());
  }
  Stnu endless = StnuBuilder(three).contingent("a", "c", 1, 2).build();
  endless.contingent[0].max = kInfinite;
  EXPECT_EQ(check_dynamic_controllability(endless).error().fault, StnuFault::kContingentUnbounded);
}

RandomStnuOptions any_shape(Random& random) {
  RandomStnuOptions options;
  options.nodes = 2 + static_cast<std::uint32_t>(random.below(13));
  options.contingent = static_cast<std::uint32_t>(random.below(options.nodes / 2 + 2));
  options.arcs = static_cast<std::uint32_t>(random.below(3 * options.nodes));
  options.longest = 3 + static_cast<Ticks>(random.below(20));
  return options;
}

TEST(ControllabilityDifferential, ManyNetworksAgreeWithMorris) {
  Random random(2014);
  int controllable = 0;
  int consistent_only = 0;
  const int tried = skein::testing::cases(4'000, 20'000);
  for (int i = 0; i < tried; ++i) {
    const Stnu network = random_stnu(any_shape(random), random);

    const DcResult result = check(network);

    ASSERT_EQ(result.controllable, BackPropagation(network, false).run()) << "network " << i;
    ASSERT_EQ(result.consistent, check(with_nature_tamed(network)).consistent) << "network " << i;
    ASSERT_EQ(result.controllable, result.conflict.empty());
    controllable += result.controllable ? 1 : 0;
    consistent_only += result.consistent && !result.controllable ? 1 : 0;
  }
  EXPECT_GT(controllable, 3 * tried / 10);
  EXPECT_GT(consistent_only, 3 * tried / 20);
}

TEST(ControllabilityDifferential, TheNamedLinksAloneAreNotControllable) {
  Random random(77);
  for (int i = 0; i < 5'000; ++i) {
    const Stnu network = random_stnu(any_shape(random), random);
    const DcResult result = check(network);
    if (result.controllable) continue;

    const Stnu part = named_part(network, result.conflict);

    ASSERT_FALSE(BackPropagation(part, false).run()) << "network " << i;
    ASSERT_EQ(check(with_nature_tamed(part)).consistent, result.consistent) << "network " << i;
  }
}

TEST(ControllabilityDifferential, BenchmarkNetworksAgreeWithMorris) {
  Random random(9);
  for (const bool broken : {false, true}) {
    for (std::uint32_t i = 0; i < 10; ++i) {
      const Stnu network = generate_stnu({.nodes = 150,
                                          .contingent = 15,
                                          .lanes = 5,
                                          .extra_arcs_percent = 65,
                                          .break_it = broken},
                                         random);

      const DcResult result = check(network);

      EXPECT_EQ(result.controllable, !broken);
      EXPECT_EQ(result.controllable, BackPropagation(network, false).run());
      EXPECT_TRUE(result.consistent);
    }
  }
}

TEST(ControllabilityDifferential, TheGeneratorKeepsToTheFamily) {
  Random random(4);

  const Stnu network = generate_stnu({}, random);

  std::size_t edges = 2 * network.contingent.size();
  for (const Arc& arc : network.arcs)
    edges += (arc.min != kMinusInfinite ? 1U : 0U) + (arc.max != kInfinite ? 1U : 0U);
  EXPECT_EQ(network.nodes.size(), 500U);
  EXPECT_EQ(network.contingent.size(), 50U);
  EXPECT_NEAR(static_cast<double>(edges), 3.2 * 500, 100);
  Random again(4);
  EXPECT_EQ(network, generate_stnu({}, again));
}

TEST(ControllabilityDifferential, TinyNetworksAgreeWithTheGameItself) {
  Random random(5);
  int controllable = 0;
  int consistent_only = 0;
  for (int i = 0; i < 6'000; ++i) {
    RandomStnuOptions options;
    options.nodes = 3 + static_cast<std::uint32_t>(random.below(3));
    options.contingent = 1 + static_cast<std::uint32_t>(random.below(3));
    options.arcs = static_cast<std::uint32_t>(random.below(6));
    options.longest = 2 + static_cast<Ticks>(random.below(2));
    options.anchored = true;
    options.horizon = 7;
    const Stnu network = random_stnu(options, random);

    const DcResult result = check(network);

    ASSERT_EQ(result.controllable, testing::StnuGame(network).controller_wins()) << "network " << i;
    controllable += result.controllable ? 1 : 0;
    consistent_only += result.consistent && !result.controllable ? 1 : 0;
  }
  EXPECT_GT(controllable, 300);
  EXPECT_GT(consistent_only, 400);
}

}  // namespace
}  // namespace skein::temporal
