// SPDX-License-Identifier: Apache-2.0
// A team cut in two halves: DIP-G and DIP-M go on, each half with what it knows. Source: M 4.2.
#include <gtest/gtest.h>

#include "skein/foundation/random.hpp"
#include "skein/temporal_lab/mastn_generator.hpp"
#include "skein/temporal_lab/mastn_simulation.hpp"
#include "skein/temporal_lab/reference_solution.hpp"

namespace skein::temporal {
namespace {

constexpr MastnShape kShape{.agents = 4, .nodes = 6, .local = 3, .external = 3};
constexpr std::size_t kMostMessages = 50'000;

bool in_first_half(AgentIndex agent) { return agent < 2; }

void apply(Mastn& mastn, const Step& step) {
  mastn.arcs[step.arc].min = step.min;
  mastn.arcs[step.arc].max = step.max;
}

/// A scenario whose middle third falls into a cut between the halves.
class Partition {
 public:
  Partition(Algorithm algorithm, std::uint64_t seed)
      : network_(generate_mastn(kShape, seed)),
        simulation_(*MastnSimulation::make(algorithm, network_, {.seed = seed})) {
    ScenarioOptions options;
    options.mode = seed % 2 == 0 ? ScenarioMode::kKept : ScenarioMode::kFree;
    options.relaxations = 0.3;
    steps_ = make_scenario(network_, chain_arcs(kShape), options, seed);
  }

  // Plays the steps of one third.
  void play(std::size_t third) {
    const std::size_t length = steps_.size() / 3;
    for (std::size_t step = third * length; step < (third + 1) * length; ++step) {
      const ArcUpdate change{steps_[step].arc, steps_[step].min, steps_[step].max};
      ASSERT_FALSE(simulation_.disturb({&change, 1}));
      const AgentIndex owner = owner_of(network_, network_.arcs[change.arc]);
      for (Mastn* view : {&first_, &second_}) {
        if (!cut_ || (view == &first_) == in_first_half(owner)) apply(*view, steps_[step]);
      }
      apply(network_, steps_[step]);
      ASSERT_TRUE(simulation_.settle(kMostMessages));
    }
  }

  void cut() {
    first_ = second_ = network_;
    cut_ = true;
    for (const auto& [one, other] : simulation_.links()) {
      if (in_first_half(one) != in_first_half(other)) simulation_.cut(one, other);
    }
  }

  void heal() {
    simulation_.heal_all();
    cut_ = false;
    first_ = second_ = network_;
    ASSERT_TRUE(simulation_.settle(kMostMessages));
  }

  // Each agent against Bellman–Ford on what its half knows.
  void expect_right() const {
    const ReferenceSolution first = solve_reference(first_);
    const ReferenceSolution second = solve_reference(second_);
    for (AgentIndex agent = 0; agent < kShape.agents; ++agent) {
      const ReferenceSolution& right = in_first_half(agent) ? first : second;
      EXPECT_EQ(simulation_.consistent(agent), right.consistent) << "agent " << agent;
      for (NodeIndex node = 1; right.consistent && node < network_.nodes.size(); ++node) {
        if (network_.owner[node] != agent) continue;
        EXPECT_EQ(simulation_.earliest(node), right.windows[node].min) << network_.nodes[node];
        EXPECT_EQ(simulation_.latest(node), right.windows[node].max) << network_.nodes[node];
      }
    }
  }

  const MastnSimulation& simulation() const { return simulation_; }

 private:
  Mastn network_;  // as disturbed
  Mastn first_ = network_;
  Mastn second_ = network_;  // as far as each half knows
  bool cut_ = false;
  MastnSimulation simulation_;
  std::vector<Step> steps_;
};

class GoesOn : public ::testing::TestWithParam<Algorithm> {};

TEST_P(GoesOn, WithWhatItsHalfKnowsAndAgreesAgainAfterwards) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Partition team(GetParam(), seed);
    team.play(0);
    team.expect_right();

    team.cut();
    team.play(1);
    team.expect_right();
    EXPECT_EQ(team.simulation().blocked_agents(), 0U);

    team.heal();
    team.expect_right();
    team.play(2);
    team.expect_right();
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Algorithms, GoesOn, ::testing::Values(Algorithm::kDipG, Algorithm::kDipM));

class MayBlock : public ::testing::TestWithParam<Algorithm> {};

TEST_P(MayBlock, WhileCutAndIsRightAfterwards) {
  std::size_t blocked = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Partition team(GetParam(), seed);
    team.play(0);

    team.cut();
    team.play(1);
    blocked += team.simulation().blocked_agents();

    team.heal();
    team.expect_right();
    EXPECT_EQ(team.simulation().blocked_agents(), 0U);
    team.play(2);
    team.expect_right();
    if (HasFailure()) return;
  }
  RecordProperty("blocked", static_cast<int>(blocked));
}

INSTANTIATE_TEST_SUITE_P(Algorithms, MayBlock, ::testing::Values(Algorithm::kDipL));

}  // namespace
}  // namespace skein::temporal
