// SPDX-License-Identifier: Apache-2.0
// Cuts and their ends, ages of words, clock errors: what holds for each algorithm by itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/foundation/random.hpp"
#include "skein/temporal_lab/mastn_generator.hpp"
#include "skein/temporal_lab/mastn_simulation.hpp"
#include "skein/temporal_lab/reference_solution.hpp"
#include "testing/post_office.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::IsEmpty;

class Reconnection : public ::testing::TestWithParam<Algorithm> {
 protected:
  /// The other end of the link that agent 0 has.
  AgentIndex far_end() const { return GetParam() == Algorithm::kCip ? 2 : 1; }
};
INSTANTIATE_TEST_SUITE_P(All, Reconnection,
                         ::testing::Values(Algorithm::kCip, Algorithm::kDipG, Algorithm::kDipL,
                                           Algorithm::kDipM));

void expect_reference(PostOffice& office, const Mastn& network) {
  const ReferenceSolution expected = solve_reference(network);
  for (AgentIndex agent = 0; agent < network.agents.size(); ++agent) {
    EXPECT_EQ(office.agent(agent).verdict().consistent, expected.consistent) << agent;
    EXPECT_EQ(office.agent(agent).blocked_since(), std::nullopt) << agent;
  }
  if (!expected.consistent) return;
  for (NodeIndex node = 1; node < network.nodes.size(); ++node) {
    EXPECT_EQ(office.window(node), Window(expected.windows[node].min, expected.windows[node].max))
        << node;
  }
}

TEST_P(Reconnection, TheEndOfACutThatNeverWasChangesNoDate) {
  PostOffice office(GetParam(), two_agents());
  office.deliver_all(at(1));

  for (int i = 0; i < 3; ++i) {
    office.heal(0, far_end(), at(2));
    office.deliver_all(at(3));
  }

  expect_reference(office, two_agents());
}

TEST_P(Reconnection, ARelaxationDuringACutIsCaughtUp) {
  Mastn network = two_agents();
  PostOffice office(GetParam(), network);
  office.disturb({{1, 20, 20}});
  office.deliver_all(at(1));

  office.cut(0, far_end(), at(2));
  office.disturb({{1, 3, 25}}, at(3));
  office.box().clear();
  office.heal(0, far_end(), at(4));
  office.deliver_all(at(5));

  network.arcs[1] = {1, 2, 3, 25};
  expect_reference(office, network);
}

TEST_P(Reconnection, AConflictMadeOfBothSidesDuringACutIsFoundAfterItAndMended) {
  // a2 at 9 at the earliest, b2 5 later at the earliest: a deadline of 13 is one too early.
  Mastn network = two_agents();
  PostOffice office(GetParam(), network);
  office.deliver_all(at(1));
  office.cut(0, far_end(), at(2));
  office.disturb({{1, 9, 20}}, at(3));
  office.disturb({{4, 0, 13}}, at(3));
  std::erase_if(office.box(), [&](const Message& message) {
    return message.sender == 0 || message.receiver == 0U;
  });
  office.deliver_all(at(4));

  office.heal(0, far_end(), at(5));
  office.deliver_all(at(6));
  network.arcs[1].min = 9;
  network.arcs[4].max = 13;
  EXPECT_FALSE(solve_reference(network).consistent);
  expect_reference(office, network);

  office.disturb({{4, 0, 14}}, at(7));
  office.deliver_all(at(8));
  network.arcs[4].max = 14;
  expect_reference(office, network);
}

TEST_P(Reconnection, WhatIsSentAgainIsTheLastOnly) {
  PostOffice office(GetParam(), two_agents());
  office.deliver_all(at(1));
  office.cut(0, far_end(), at(2));
  for (Ticks min = 6; min < 16; ++min) office.disturb({{1, min, 20}}, at(3));
  office.box().clear();

  office.heal(0, far_end(), at(4));
  std::size_t units = 0;
  for (const Message& message : office.box()) {
    if (message.sender == 0 && is_data(message.content)) units += unit_count(message.content);
  }

  EXPECT_LE(units, 4U) << "one sample of each key, not ten of one";
  office.deliver_all(at(5));
  EXPECT_EQ(office.window(4), Window(20, 150));
}

TEST_P(Reconnection, RandomCutsOfRandomLinksEndInTheDatesOfTheWhole) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const MastnShape shape{.agents = 3, .nodes = 4, .local = 2, .external = 2};
    Mastn network = generate_mastn(shape, seed);
    auto simulation =
        MastnSimulation::make(GetParam(), network,
                              {.longest_delay = kTicksPerSecond, .in_order = true, .seed = seed})
            .value();
    Random random(seed);
    const auto links = simulation.links();
    for (const Step& step :
         make_scenario(network, chain_arcs(shape),
                       {.mode = ScenarioMode::kFree, .relaxations = 0.4, .interval = 1}, seed)) {
      const auto& [one, other] = links[random.below(links.size())];
      if (random.chance(0.3)) simulation.cut(one, other);
      if (random.chance(0.3)) simulation.heal(one, other);
      const ArcUpdate change{step.arc, step.min, step.max};
      ASSERT_FALSE(simulation.disturb({&change, 1}));
      network.arcs[step.arc].min = step.min;
      network.arcs[step.arc].max = step.max;
      ASSERT_TRUE(
          simulation.run_until(simulation.now() + Duration::nanoseconds(400'000'000), 5'000));
    }
    simulation.heal_all();
    ASSERT_TRUE(simulation.settle(50'000)) << "seed " << seed;

    const ReferenceSolution expected = solve_reference(network);
    ASSERT_EQ(simulation.consistent(), expected.consistent) << "seed " << seed;
    ASSERT_EQ(simulation.blocked_agents(), 0U);
    if (!expected.consistent) continue;
    for (NodeIndex node = 1; node < network.nodes.size(); ++node) {
      ASSERT_EQ(simulation.earliest(node), expected.windows[node].min) << "seed " << seed;
      ASSERT_EQ(simulation.latest(node), expected.windows[node].max) << "seed " << seed;
    }
  }
}

TEST(Reordering, DipGAndDipMBearAnyOrder) {
  for (const Algorithm algorithm : {Algorithm::kDipG, Algorithm::kDipM}) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const MastnShape shape{.agents = 3, .nodes = 4, .local = 2, .external = 2};
      Mastn network = generate_mastn(shape, seed);
      auto simulation = MastnSimulation::make(
                            algorithm, network,
                            {.longest_delay = 9 * kTicksPerSecond, .in_order = false, .seed = seed})
                            .value();
      for (const std::uint64_t again : {seed, seed + 100, seed + 200}) {  // each arc three times
        for (const Step& step : make_scenario(network, chain_arcs(shape), {}, again)) {
          const ArcUpdate change{step.arc, step.min, step.max};
          ASSERT_FALSE(simulation.disturb({&change, 1}));
          network.arcs[step.arc].min = step.min;
          network.arcs[step.arc].max = step.max;
        }
      }
      ASSERT_TRUE(simulation.settle(50'000));

      const ReferenceSolution expected = solve_reference(network);
      ASSERT_EQ(simulation.consistent(), expected.consistent);
      for (NodeIndex node = 1; expected.consistent && node < network.nodes.size(); ++node) {
        ASSERT_EQ(simulation.earliest(node), expected.windows[node].min) << "seed " << seed;
        ASSERT_EQ(simulation.latest(node), expected.windows[node].max) << "seed " << seed;
      }
    }
  }
}

TEST(CipReconnection, ASlaveThatSaidNothingHearsAVerdictThatTurnedMeanwhile) {
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all(at(1));
  office.cut(1, 2, at(2));
  office.disturb({{1, 20, 20}}, at(3));
  office.disturb({{0, 190, 190}}, at(3));
  while (!office.box().empty()) {
    if (office.box().front().receiver == 1U) {
      office.box().pop_front();  // lost
    } else {
      office.deliver_one(at(4));
    }
  }
  EXPECT_EQ(office.agent(0).verdict().consistent, false) << "190 + 20 + 5 > 200";
  EXPECT_EQ(office.agent(1).verdict().consistent, true) << "as it heard last";
  EXPECT_EQ(office.agent(1).blocked_since(), at(2));

  office.heal(1, 2, at(5));
  office.deliver_all(at(6));

  EXPECT_EQ(office.agent(1).verdict().consistent, false);
  EXPECT_EQ(office.agent(1).blocked_since(), std::nullopt);
}

TEST(AgesOfWords, GrowOldDuringACutAndAreFreshAfterIt) {
  for (const Algorithm algorithm : {Algorithm::kDipG, Algorithm::kDipL, Algorithm::kDipM}) {
    PostOffice office(algorithm, two_agents());
    office.disturb({{1, 10, 20}}, at(3));
    office.deliver_all(at(3));
    const auto heard = [&] { return office.agent(1).verdict().words[0].heard; };
    EXPECT_EQ(heard(), at(3)) << to_text(algorithm);

    office.cut(0, 1, at(5));
    office.disturb({{1, 11, 20}}, at(6));
    office.box().clear();
    EXPECT_EQ(heard(), at(3)) << to_text(algorithm);

    office.heal(0, 1, at(8));
    office.deliver_all(at(9));
    EXPECT_EQ(heard(), at(9)) << to_text(algorithm);
  }
}

TEST(AgesOfWords, ASlaveHearsOnlyTheSupervisorAndTheSupervisorEachSlave) {
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all(at(1));
  office.disturb({{1, 10, 20}}, at(4));
  office.deliver_all(at(4));

  const Verdict slave = office.agent(0).verdict();
  const Verdict supervisor = office.agent(2).verdict();

  EXPECT_EQ(slave.words[0], (LastWord{true, at(4)}));
  EXPECT_EQ(slave.words[1], LastWord{});
  EXPECT_EQ(supervisor.words[0].heard, at(4));
  EXPECT_EQ(supervisor.words[1].heard, std::nullopt) << "B never wrote";
}

TEST(ClockErrors, WidenFiniteBoundsOfExternalArcsOnly) {
  const Mastn network = MastnBuilder()
                            .node("a1", "A")
                            .node("b1", "B")
                            .node("b2", "B")
                            .arc("v0", "a1", 10, 10)
                            .arc("a1", "b1", 5, kInfinite)
                            .arc("b1", "b2", 2, 2)
                            .arc("v0", "b2", 0, 50);
  PostOffice exact(Algorithm::kDipG, network, {{0, 0}});
  PostOffice office(Algorithm::kDipG, network, {{3, 1}});

  EXPECT_EQ(exact.window(2), Window(15, 48));
  EXPECT_EQ(office.window(2), Window(11, 48)) << "15 - 3 - 1, and no latest date";
  EXPECT_EQ(office.window(3), Window(13, 50)) << "2 is the same clock's";
  EXPECT_EQ(office.window(1), Window(10, 10)) << "v0 is nobody's";
}

TEST(ClockErrors, MayMakeConsistentWhatIsOnlyJustNot) {
  const auto verdict = [](Ticks error) {
    const Mastn network = MastnBuilder()
                              .node("a1", "A")
                              .node("b1", "B")
                              .arc("v0", "a1", 10, 10)
                              .arc("a1", "b1", 5, 5)
                              .arc("v0", "b1", 19, 19);
    PostOffice office(Algorithm::kDipL, network, {{error, error}});
    office.deliver_all();
    return office.agent(0).verdict().consistent;
  };

  EXPECT_EQ(verdict(1), false) << "15 and 2, not 19";
  EXPECT_EQ(verdict(2), true) << "15 and 4";
}

TEST(ClockErrors, ThatDoNotFitAreRefused) {
  const Mastn network =
      MastnBuilder().node("a1", "A").node("b1", "B").arc("a1", "b1", 0, kLargest - 3);

  EXPECT_TRUE(make_agent(Algorithm::kDipM, network, 0, {{1, 2}}).has_value());
  EXPECT_EQ(make_agent(Algorithm::kDipM, network, 0, {{2, 2}}).error(),
            (AgentRefusal{AgentError::kOverflow, 0}));
  EXPECT_EQ(make_supervisor(network, {{2, 2}}).error(), (AgentRefusal{AgentError::kOverflow, 0}));
  EXPECT_EQ(make_agent(Algorithm::kDipM, network, 0, {{0, kLargest}}).error(),
            (AgentRefusal{AgentError::kOverflow, 1}));
}

TEST(AgentAlone, NeedsNobody) {
  const Mastn network =
      MastnBuilder().node("a1", "A").node("a2", "A").arc("v0", "a1", 1, 9).arc("a1", "a2", 2, 3);
  for (const Algorithm algorithm : {Algorithm::kDipG, Algorithm::kDipL, Algorithm::kDipM}) {
    PostOffice office(algorithm, network);

    EXPECT_THAT(office.disturb({{0, 4, 5}}), IsEmpty());

    EXPECT_THAT(office.box(), IsEmpty());
    EXPECT_EQ(office.window(2), Window(6, 8));
    EXPECT_EQ(office.agent(0).verdict().consistent, true);
  }
}

}  // namespace
}  // namespace skein::temporal::testing
