// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal_lab/mastn_generator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "skein/temporal_lab/reference_solution.hpp"

namespace skein::temporal {
namespace {

constexpr MastnShape kUsual{.agents = 4, .nodes = 20, .local = 10, .external = 4};

Mastn after(Mastn mastn, const std::vector<Step>& steps) {
  for (const Step& step : steps) {
    mastn.arcs[step.arc].min = step.min;
    mastn.arcs[step.arc].max = step.max;
  }
  return mastn;
}

TEST(MastnGenerator, HasTheNodesAndArcsOfItsShape) {
  const Mastn mastn = generate_mastn(kUsual, 7);

  EXPECT_EQ(mastn.agents.size(), 4U);
  EXPECT_EQ(mastn.nodes.size(), 1 + 4 * 20U);
  EXPECT_EQ(mastn.owner.size(), mastn.nodes.size());
  EXPECT_EQ(mastn.arcs.size(), 4 * (20 + 10 + 4U));
  EXPECT_TRUE(mastn.steps.empty());
}

TEST(MastnGenerator, BeginsWithTheChainOfEachAgentFromTheOrigin) {
  const Mastn mastn = generate_mastn(kUsual, 7);

  for (std::uint32_t agent = 0; agent < 4; ++agent) {
    for (std::uint32_t position = 0; position < 20; ++position) {
      const Arc& arc = mastn.arcs[agent * 20 + position];
      EXPECT_EQ(arc.to, 1 + agent * 20 + position);
      EXPECT_EQ(arc.from, position == 0 ? 0 : arc.to - 1);
      EXPECT_EQ(mastn.owner[arc.to], agent);
      EXPECT_GE(arc.min, 0);
    }
  }
  EXPECT_EQ(chain_arcs(kUsual).size(), 80U);
  EXPECT_EQ(chain_arcs(kUsual).back(), 79U);
}

TEST(MastnGenerator, PutsLocalArcsInOneAgentAndExternalArcsBetweenTwo) {
  const Mastn mastn = generate_mastn(kUsual, 7);

  for (std::size_t arc = 80; arc < 120; ++arc) {
    EXPECT_EQ(mastn.owner[mastn.arcs[arc].from], (arc - 80) / 10);
    EXPECT_EQ(mastn.owner[mastn.arcs[arc].to], (arc - 80) / 10);
    EXPECT_GE(mastn.arcs[arc].to, mastn.arcs[arc].from + 2) << "neighbours have the chain";
  }
  for (std::size_t arc = 120; arc < 136; ++arc) {
    EXPECT_EQ(mastn.owner[mastn.arcs[arc].from], (arc - 120) / 4) << "external arcs: creator first";
    EXPECT_NE(mastn.owner[mastn.arcs[arc].to], mastn.owner[mastn.arcs[arc].from]);
  }
}

TEST(MastnGenerator, IsConsistentAndBoundsEveryNodeOnBothSides) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const ReferenceSolution solution = solve_reference(generate_mastn(kUsual, seed));

    ASSERT_TRUE(solution.consistent) << "seed " << seed;
    for (const ReferenceWindow& window : solution.windows) {
      EXPECT_GT(window.min, kMinusInfinite);
      EXPECT_LT(window.max, kInfinite);
    }
  }
}

TEST(MastnGenerator, JoinsNoTwoNodesTwiceEvenInTheSmallestNetworks) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const MastnShape shape{.agents = 2, .nodes = 2, .local = 5, .external = 4};
    const Mastn mastn = generate_mastn(shape, seed);

    std::set<std::pair<NodeIndex, NodeIndex>> joined;
    for (const Arc& arc : mastn.arcs) {
      EXPECT_TRUE(joined.insert(std::minmax(arc.from, arc.to)).second) << "seed " << seed;
    }
    EXPECT_LE(mastn.arcs.size(), 4 + 4U) << "four pairs of nodes of two agents";
  }
}

TEST(MastnGenerator, GivesASingleAgentNoExternalArcs) {
  const MastnShape shape{.agents = 1, .nodes = 5, .local = 2, .external = 4};
  const Mastn mastn = generate_mastn(shape, 1);

  EXPECT_EQ(mastn.arcs.size(), 7U);
  EXPECT_EQ(frontier_ratio(mastn), 0);
}

TEST(MastnGenerator, NamesAreAllDifferent) {
  const MastnShape shape{.agents = 60, .nodes = 12, .local = 0, .external = 0};
  const Mastn mastn = generate_mastn(shape, 1);

  EXPECT_EQ(std::set(mastn.nodes.begin(), mastn.nodes.end()).size(), mastn.nodes.size());
  EXPECT_EQ(std::set(mastn.agents.begin(), mastn.agents.end()).size(), mastn.agents.size());
}

TEST(MastnGenerator, SameSeedSameNetworkOtherSeedAnother) {
  EXPECT_EQ(generate_mastn(kUsual, 3), generate_mastn(kUsual, 3));
  EXPECT_NE(generate_mastn(kUsual, 3), generate_mastn(kUsual, 4));
}

// Source: notes 3: with V = 20, E = 1, 2, 4, 8, 12 give 0.10, 0.18, 0.33, 0.55, 0.71.
TEST(MastnGenerator, FrontierRatiosAreThoseOfTheNotes) {
  const std::vector<std::pair<std::uint32_t, double>> published = {
      {1, 0.10}, {2, 0.18}, {4, 0.33}, {8, 0.55}, {12, 0.71}};
  for (const auto& [external, expected] : published) {
    double sum = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const MastnShape shape{.agents = 8, .nodes = 20, .local = 10, .external = external};
      sum += frontier_ratio(generate_mastn(shape, seed));
    }
    EXPECT_NEAR(sum / 40, expected, 0.02) << "E = " << external;
  }
}

TEST(MastnScenario, FixesEveryChainArcOnceToOneValue) {
  const Mastn mastn = generate_mastn(kUsual, 5);
  const std::vector<Step> steps = make_scenario(mastn, chain_arcs(kUsual), {}, 5);

  ASSERT_EQ(steps.size(), 80U);
  std::set<std::uint32_t> fixed;
  for (std::size_t step = 0; step < steps.size(); ++step) {
    EXPECT_EQ(steps[step].min, steps[step].max);
    EXPECT_EQ(steps[step].at, static_cast<Ticks>(step + 1) * kTicksPerSecond);
    fixed.insert(steps[step].arc);
  }
  EXPECT_EQ(fixed.size(), 80U);
  EXPECT_EQ(*fixed.rbegin(), 79U);
}

TEST(MastnScenario, WithoutRelaxationsStaysConsistentAndInsideTheIntervals) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Mastn mastn = generate_mastn(kUsual, seed);
    const std::vector<Step> steps =
        make_scenario(mastn, chain_arcs(kUsual), {.relaxations = 0}, seed);

    for (const Step& step : steps) {
      EXPECT_GE(step.min, mastn.arcs[step.arc].min);
      EXPECT_LE(step.max, mastn.arcs[step.arc].max);
    }
    EXPECT_TRUE(solve_reference(after(mastn, steps)).consistent) << "seed " << seed;
  }
}

TEST(MastnScenario, RelaxationsLeaveTheIntervalByOneToTenSeconds) {
  const Mastn mastn = generate_mastn(kUsual, 5);
  const ScenarioOptions all_relax{.mode = ScenarioMode::kFree, .relaxations = 1};

  for (const Step& step : make_scenario(mastn, chain_arcs(kUsual), all_relax, 5)) {
    const Arc& arc = mastn.arcs[step.arc];
    const Ticks outside = std::max(arc.min - step.min, step.max - arc.max);
    EXPECT_GE(outside, 1 * kTicksPerSecond);
    EXPECT_LE(outside, 10 * kTicksPerSecond);
  }
}

TEST(MastnScenario, RelaxesAboutTheShareAskedFor) {
  std::size_t relaxed = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Mastn mastn = generate_mastn(kUsual, seed);
    for (const Step& step : make_scenario(mastn, chain_arcs(kUsual), {}, seed)) {
      const Arc& arc = mastn.arcs[step.arc];
      relaxed += step.min < arc.min || step.max > arc.max ? 1U : 0U;
    }
  }

  EXPECT_NEAR(static_cast<double>(relaxed) / 1600, 0.1, 0.03);
}

// Source: notes 3: "in mode F 23-84 % of steps are spent in an inconsistent network".
TEST(MastnScenario, ModeKSpendsLessTimeInconsistentThanModeF) {
  const auto inconsistent_steps = [](ScenarioMode mode) {
    int count = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      Mastn mastn = generate_mastn(kUsual, seed);
      for (const Step& step : make_scenario(mastn, chain_arcs(kUsual), {.mode = mode}, seed)) {
        mastn = after(mastn, {step});
        count += solve_reference(mastn).consistent ? 0 : 1;
      }
    }
    return count;
  };

  const int kept = inconsistent_steps(ScenarioMode::kKept);
  const int free = inconsistent_steps(ScenarioMode::kFree);

  EXPECT_LT(kept * 2, free);
  EXPECT_GE(free, 800 * 23 / 100);
}

TEST(MastnScenario, SameSeedSameStepsOtherSeedOthers) {
  const Mastn mastn = generate_mastn(kUsual, 5);
  const std::vector<std::uint32_t> arcs = chain_arcs(kUsual);

  EXPECT_EQ(make_scenario(mastn, arcs, {}, 3), make_scenario(mastn, arcs, {}, 3));
  EXPECT_NE(make_scenario(mastn, arcs, {}, 3), make_scenario(mastn, arcs, {}, 4));
}

}  // namespace
}  // namespace skein::temporal
