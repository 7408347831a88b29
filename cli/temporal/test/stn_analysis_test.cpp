// SPDX-License-Identifier: Apache-2.0
#include "stn_analysis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/foundation/random.hpp"
#include "skein/temporal_files/network_text.hpp"
#include "skein/temporal_lab/reference_solution.hpp"

namespace skein::temporal_tool {
namespace {

using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::LinkKind;
using temporal::Stnu;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::UnorderedElementsAre;

ConflictPart part(LinkKind kind, std::uint32_t index, LinkBound bound) {
  return {{kind, index}, bound};
}

TEST(AnalyseConsistency, GivesTheDatesOfAConsistentNetwork) {
  const Stnu network{{"v0", "a", "b"}, 0, {{0, 1, 2, 5}}, {{1, 2, 3, 4}}};

  const Consistency answer = analyse_consistency(network).value();

  EXPECT_TRUE(answer.consistent);
  EXPECT_THAT(answer.conflict, IsEmpty());
  EXPECT_THAT(answer.windows, ElementsAre(temporal::DateWindow{0, 0}, temporal::DateWindow{2, 5},
                                          temporal::DateWindow{5, 9}));
}

TEST(AnalyseConsistency, NamesTheLinksOfANegativeCycle) {
  const Stnu network{
      {"v0", "a", "b"}, 0, {{0, 1, 5, kInfinite}, {0, 2, kMinusInfinite, 7}}, {{1, 2, 3, 4}}};

  const Consistency answer = analyse_consistency(network).value();

  EXPECT_FALSE(answer.consistent);
  EXPECT_THAT(answer.conflict,
              UnorderedElementsAre(part(LinkKind::kRequirement, 0, LinkBound::kMin),
                                   part(LinkKind::kContingent, 0, LinkBound::kMin),
                                   part(LinkKind::kRequirement, 1, LinkBound::kMax)));
}

TEST(AnalyseConsistency, TakesParallelLinksTogether) {
  const Stnu network{
      {"v0", "a"}, 0, {{0, 1, 0, 9}, {1, 0, -6, -2}, {0, 1, kMinusInfinite, 5}}, {{0, 1, 3, 8}}};

  const Consistency answer = analyse_consistency(network).value();

  EXPECT_THAT(answer.windows, ElementsAre(temporal::DateWindow{0, 0}, temporal::DateWindow{3, 5}));
}

TEST(AnalyseConsistency, NamesParallelLinksThatLeaveNoRoom) {
  const Stnu network{{"v0", "a"}, 0, {{1, 0, -2, 0}}, {{0, 1, 3, 8}}};

  const Consistency answer = analyse_consistency(network).value();

  EXPECT_FALSE(answer.consistent);
  EXPECT_THAT(answer.conflict,
              UnorderedElementsAre(part(LinkKind::kRequirement, 0, LinkBound::kMin),
                                   part(LinkKind::kContingent, 0, LinkBound::kMin)));
}

TEST(AnalyseConsistency, RefusesDatesThatOverflow) {
  Stnu network{{"v0", "a", "b"}, 0, {}, {}};
  for (temporal::NodeIndex i = 0; i < 2; ++i) {
    network.arcs.push_back({i, i + 1, temporal::kLargest, temporal::kLargest});
  }

  EXPECT_FALSE(analyse_consistency(network));
}

// Random small networks with links in both directions and in parallel.
Stnu any_network(Random& random) {
  Stnu network{{"v0", "a", "b", "c"}, 0, {}, {}};
  const auto node = [&] { return static_cast<temporal::NodeIndex>(random.below(4)); };
  for (std::uint64_t i = 2 + random.below(6); i > 0; --i) {
    const temporal::NodeIndex from = node();
    const temporal::NodeIndex to = node();
    const auto min = static_cast<temporal::Ticks>(random.below(20)) - 8;
    if (from == to) continue;
    network.arcs.push_back({from, to, min, min + static_cast<temporal::Ticks>(random.below(12))});
  }
  if (random.chance(0.5)) network.contingent.push_back({node() % 2, 2 + node() % 2, 1, 4});
  return network;
}

TEST(AnalyseConsistency, AgreesWithBellmanFordAndItsConflictsAreNegativeCycles) {
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const Stnu network = any_network(random);
    const temporal::Stn stn = temporal::without_uncertainty(network);
    const auto reference = temporal::solve_reference(stn.nodes.size(), stn.arcs);

    const Consistency answer = analyse_consistency(network).value();

    ASSERT_EQ(answer.consistent, reference.consistent) << i;
    temporal::Ticks sum = 0;
    for (const ConflictPart& one : answer.conflict) {
      const bool contingent = one.link.kind == LinkKind::kContingent;
      const temporal::Arc arc =
          stn.arcs[contingent ? network.arcs.size() + one.link.index : one.link.index];
      sum += one.bound == LinkBound::kMin ? -arc.min : arc.max;
    }
    ASSERT_EQ(sum < 0, !answer.consistent) << i;
    for (std::size_t node = 0; node < answer.windows.size(); ++node) {
      ASSERT_EQ(answer.windows[node].earliest, reference.windows[node].min) << i;
      ASSERT_EQ(answer.windows[node].latest, reference.windows[node].max) << i;
    }
  }
}

TEST(AnalyseControllability, TellsConsistentFromControllable) {
  const Stnu network{
      {"v0", "a", "b"}, 0, {{0, 1, 0, 0}, {0, 2, kMinusInfinite, 5}}, {{1, 2, 1, 9}}};

  const Controllability answer = analyse_controllability(network).value();

  EXPECT_TRUE(answer.consistent);
  EXPECT_FALSE(answer.controllable);
  EXPECT_THAT(answer.conflict, IsSupersetOf({part(LinkKind::kRequirement, 0, LinkBound::kMin),
                                             part(LinkKind::kContingent, 0, LinkBound::kMax),
                                             part(LinkKind::kRequirement, 1, LinkBound::kMax)}));
}

TEST(AnalyseControllability, AgreesWithConsistencyWhereNothingIsUncertain) {
  Random random(12);
  for (int i = 0; i < 500; ++i) {
    Stnu network = any_network(random);
    network.contingent.clear();

    const Controllability answer = analyse_controllability(network).value();

    EXPECT_EQ(answer.controllable, analyse_consistency(network)->consistent);
    EXPECT_EQ(answer.controllable, answer.consistent);
  }
}

TEST(LinksOf, KeepsTheOrder) {
  EXPECT_THAT(links_of({part(LinkKind::kContingent, 3, LinkBound::kMin),
                        part(LinkKind::kRequirement, 1, LinkBound::kMax)}),
              ElementsAre(temporal::LinkRef{LinkKind::kContingent, 3},
                          temporal::LinkRef{LinkKind::kRequirement, 1}));
}

}  // namespace
}  // namespace skein::temporal_tool
