// SPDX-License-Identifier: Apache-2.0
// The measuring, on networks small enough for the test; skein mastn bench has the large ones.
#include "skein/mastn_experiment/mastn_experiment.hpp"

#include <gtest/gtest.h>

#include "skein/mastn_experiment/mastn_claims.hpp"

namespace skein::temporal {
namespace {

constexpr MastnShape kShape{.agents = 4, .nodes = 10, .local = 5, .external = 3};

class Measured : public ::testing::TestWithParam<ScenarioMode> {
 protected:
  const ExperimentRow row = measure(kShape, GetParam(), 11);
};

TEST_P(Measured, NeverShowsAWrongDateOrVerdict) {
  for (const AlgorithmFigures& figures : row.algorithms) {
    EXPECT_EQ(figures.wrong, 0U);
    EXPECT_EQ(figures.excess, 0U);
  }
}

TEST_P(Measured, DipGSendsOneMessagePerPerturbationAndComputesNTimes) {
  const AlgorithmFigures& dip_g = row.of(Algorithm::kDipG);

  EXPECT_EQ(row.perturbations, 40U);
  EXPECT_EQ(dip_g.traffic.data(), 40U);
  EXPECT_EQ(dip_g.most_data, 1U);
  EXPECT_EQ(dip_g.checks, 4 * row.single_checks);
}

TEST_P(Measured, CipComputesOnceAndConfirmsEachPerturbation) {
  const AlgorithmFigures& cip = row.of(Algorithm::kCip);

  EXPECT_EQ(cip.traffic.disturbances, 40U);
  EXPECT_GE(cip.traffic.consistency, 40U);
  EXPECT_GT(cip.traffic.node_updates, 0U);
  EXPECT_EQ(cip.checks, row.single_checks);
}

TEST_P(Measured, EachAlgorithmSendsOnlyItsOwnKinds) {
  const Traffic& dip_l = row.of(Algorithm::kDipL).traffic;
  const Traffic& dip_m = row.of(Algorithm::kDipM).traffic;

  EXPECT_GT(dip_l.updates, 0U);
  EXPECT_EQ(dip_l.data(), dip_l.updates + dip_l.relaxations);
  EXPECT_GT(dip_m.macro_bounds, 0U);
  EXPECT_EQ(dip_m.data(), dip_m.macro_bounds);
  EXPECT_LE(dip_m.macro_packs, dip_m.macro_arcs);
  EXPECT_LE(dip_m.macro_arcs, dip_m.macro_bounds);
  EXPECT_LE(dip_m.macro_packs, row.perturbations);
}

TEST_P(Measured, OnlyDipMEliminates) {
  EXPECT_EQ(row.of(Algorithm::kDipG).eliminations, 0U);
  EXPECT_GT(row.of(Algorithm::kDipM).eliminations, 0U);
  EXPECT_LT(row.of(Algorithm::kDipM).eliminations, row.of(Algorithm::kDipM).checks);
}

TEST_P(Measured, CountsPerturbationsBetweenConsistentStatesApart) {
  EXPECT_LE(row.calm, row.perturbations - row.inconsistent);
  if (GetParam() == ScenarioMode::kKept) {
    EXPECT_GT(row.calm, 0U);
  }
  EXPECT_EQ(row.of(Algorithm::kDipG).calm_data, row.calm) << "one message for each";
  EXPECT_LE(row.of(Algorithm::kCip).calm_data, row.of(Algorithm::kCip).traffic.data());
}

TEST_P(Measured, TellsOfEachPerturbationWhatItDoes) {
  const auto of = [this](Turn turn) { return row.turns[static_cast<std::size_t>(turn)]; };
  EXPECT_EQ(of(Turn::kContraction) + of(Turn::kRelaxation), row.calm);
  EXPECT_EQ(of(Turn::kBreak) + of(Turn::kBroken), row.perturbations - row.calm);
  EXPECT_EQ(of(Turn::kBreak) > 0, row.inconsistent > 0);
  for (const AlgorithmFigures& figures : row.algorithms) {
    std::uint64_t most = 0;
    for (const Traffic& each : figures.most) most = std::max(most, each.data());
    EXPECT_EQ(most, figures.most_data);
  }
}

TEST_P(Measured, StartingAfreshCostsMore) { EXPECT_GT(row.full_checks, 4 * row.single_checks); }

INSTANTIATE_TEST_SUITE_P(Modes, Measured,
                         ::testing::Values(ScenarioMode::kKept, ScenarioMode::kFree),
                         [](const auto& mode) { return to_text(mode.param); });

TEST(Experiment, RunsEveryParameterSetInOrderAndTellsProgress) {
  ExperimentPlan plan;
  plan.agents = {2, 3};
  plan.external = {1, 2};
  plan.nodes = 4;
  plan.local = 1;
  plan.networks = 2;
  std::vector<std::size_t> told;

  const std::vector<ExperimentRow> rows =
      run_experiment(plan, [&told](std::size_t done, std::size_t total) {
        told.push_back(done);
        EXPECT_EQ(total, 16U);
      });

  ASSERT_EQ(rows.size(), 16U);
  EXPECT_EQ(told.size(), 16U);
  EXPECT_EQ(told.back(), 16U);
  EXPECT_EQ(rows[1].seed, 2U);
  EXPECT_EQ(rows[2].shape.external, 2U);
  EXPECT_EQ(rows[4].shape.agents, 3U);
  EXPECT_EQ(rows[8].mode, ScenarioMode::kFree);
}

TEST(Experiment, OneSeedOneResult) {
  EXPECT_EQ(to_csv({measure(kShape, ScenarioMode::kKept, 3)}),
            to_csv({measure(kShape, ScenarioMode::kKept, 3)}));
}

}  // namespace
}  // namespace skein::temporal
