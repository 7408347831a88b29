// SPDX-License-Identifier: Apache-2.0
// Tests of what all agents share: building, refusals, laws that hold for every algorithm.
#include "skein/temporal/agent.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/temporal_lab/reference_solution.hpp"
#include "testing/post_office.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::SizeIs;

class AnyAlgorithm : public ::testing::TestWithParam<Algorithm> {};
INSTANTIATE_TEST_SUITE_P(All, AnyAlgorithm,
                         ::testing::Values(Algorithm::kCip, Algorithm::kDipG, Algorithm::kDipL,
                                           Algorithm::kDipM));

AgentError error_of(const Result<Output, AgentRefusal>& result) {
  EXPECT_FALSE(result.has_value());
  return result.error().error;
}

std::vector<Window> windows(PostOffice& office, std::size_t nodes) {
  std::vector<Window> all;
  for (NodeIndex node = 1; node < nodes; ++node) all.push_back(office.window(node));
  return all;
}

std::vector<Window> expected(const Mastn& network) {
  const auto reference = solve_reference(network);
  EXPECT_TRUE(reference.consistent);
  std::vector<Window> all;
  for (std::size_t node = 1; node < network.nodes.size(); ++node) {
    all.emplace_back(reference.windows[node].min, reference.windows[node].max);
  }
  return all;
}

TEST_P(AnyAlgorithm, KnowsTheDatesOfTheInitialNetworkAfterTheFirstMessages) {
  PostOffice office(GetParam(), two_agents());

  office.deliver_all();

  EXPECT_EQ(windows(office, 5), expected(two_agents()));
  EXPECT_EQ(office.agent(0).verdict().consistent, true);
  EXPECT_EQ(office.agent(1).verdict().consistent, true);
}

TEST_P(AnyAlgorithm, FollowsAContractionThenARelaxation) {
  Mastn network = two_agents();
  PostOffice office(GetParam(), network);
  office.deliver_all();

  office.disturb({{1, 20, 20}});
  office.deliver_all();
  office.disturb({{1, 2, 30}});
  office.deliver_all();

  network.arcs[1].min = 2;
  network.arcs[1].max = 30;
  EXPECT_EQ(windows(office, 5), expected(network));
}

TEST_P(AnyAlgorithm, SaysInconsistentThenRecovers) {
  PostOffice office(GetParam(), two_agents());
  office.deliver_all();

  office.disturb({{4, 0, 8}});
  office.deliver_all();
  EXPECT_EQ(office.agent(0).verdict().consistent, false);
  EXPECT_EQ(office.agent(1).verdict().consistent, false);

  office.disturb({{1, 3, 20}});
  office.deliver_all();
  EXPECT_EQ(office.agent(0).verdict().consistent, true);
  EXPECT_EQ(office.agent(1).verdict().consistent, true);
  EXPECT_EQ(office.window(4), Window(8, 8));
}

TEST_P(AnyAlgorithm, WidensExternalArcsByTheClockErrorOfBoth) {
  Mastn network = two_agents();
  PostOffice office(GetParam(), network, {{1, 2}});

  office.deliver_all();

  network.arcs[2].min -= 3;
  network.arcs[2].max += 3;
  EXPECT_EQ(windows(office, 5), expected(network));
}

TEST_P(AnyAlgorithm, TakesABatchAsOnePerturbation) {
  Mastn network = two_agents();
  PostOffice office(GetParam(), network);
  office.deliver_all();

  office.disturb({{0, 8, 9}, {1, 1, 2}});
  office.deliver_all();

  network.arcs[0] = {0, 1, 8, 9};
  network.arcs[1] = {1, 2, 1, 2};
  EXPECT_EQ(windows(office, 5), expected(network));
}

TEST_P(AnyAlgorithm, RefusesDisturbancesThatAreNotItsOwnOrWrong) {
  PostOffice office(GetParam(), two_agents());
  office.deliver_all();
  Agent& a = office.agent(0);
  const auto disturb = [&](const ArcUpdate& change) {
    return error_of(a.on_disturbance({&change, 1}, at(1)));
  };

  EXPECT_EQ(disturb({9, 0, 1}), AgentError::kUnknownArc);
  EXPECT_EQ(disturb({3, 0, 1}), AgentError::kNotOwner);
  EXPECT_EQ(disturb({2, 0, 1}), AgentError::kExternalArc);
  EXPECT_EQ(disturb({1, 2, 1}), AgentError::kEmptyInterval);
  EXPECT_EQ(disturb({1, 2, kLargest + 1}), AgentError::kOverflow);

  EXPECT_EQ(windows(office, 5), expected(two_agents()));
  EXPECT_EQ(a.verdict().consistent, true);
}

TEST_P(AnyAlgorithm, RefusesTheWholeBatchForOneWrongChange) {
  PostOffice office(GetParam(), two_agents());
  office.deliver_all();
  const std::vector<ArcUpdate> batch = {{1, 20, 20}, {0, 2, 1}};

  EXPECT_EQ(error_of(office.agent(0).on_disturbance(batch, at(1))), AgentError::kEmptyInterval);

  office.disturb({{0, 1, 10}});
  office.deliver_all();
  EXPECT_EQ(office.window(2), Window(6, 30));
}

TEST_P(AnyAlgorithm, RefusesMessagesFromUnknownAgentsAndToOthers) {
  PostOffice office(GetParam(), two_agents());
  office.deliver_all();
  Message message;
  message.id = 1000;
  message.content = Consistency{};

  message.sender = 7;
  EXPECT_EQ(error_of(office.agent(0).on_message(message, at(1))), AgentError::kUnknownAgent);
  message.sender = 0;
  EXPECT_EQ(error_of(office.agent(0).on_message(message, at(1))), AgentError::kUnknownAgent);
  message.sender = GetParam() == Algorithm::kCip ? 2 : 1;
  message.receiver = 1;
  EXPECT_EQ(error_of(office.agent(0).on_message(message, at(1))), AgentError::kWrongReceiver);
  EXPECT_EQ(error_of(office.agent(0).on_link(7, true, at(1))), AgentError::kUnknownAgent);
}

TEST_P(AnyAlgorithm, RefusesAMessageItHasSeen) {
  PostOffice office(GetParam(), two_agents());
  office.deliver_all();
  office.disturb({{1, 10, 20}});
  const Message message = office.deliver_one();
  Agent& receiver = office.agent(*message.receiver);

  EXPECT_EQ(error_of(receiver.on_message(message, at(2))), AgentError::kSeenId);

  office.deliver_all();
  EXPECT_EQ(office.window(4), Window(15, 150));
}

TEST_P(AnyAlgorithm, RefusesAContentItDoesNotUse) {
  PostOffice office(GetParam(), two_agents());
  office.deliver_all();
  Message message;
  message.sender = GetParam() == Algorithm::kCip ? 2 : 1;
  message.id = 1000;
  message.content = GetParam() == Algorithm::kDipM ? Content(ArcUpdates{}) : MacroUpdates{};

  EXPECT_EQ(error_of(office.agent(0).on_message(message, at(1))), AgentError::kUnexpected);
}

TEST_P(AnyAlgorithm, CatchesUpAfterACut) {
  Mastn network = two_agents();
  PostOffice office(GetParam(), network);
  office.deliver_all();
  const AgentIndex far = GetParam() == Algorithm::kCip ? 2 : 1;

  office.cut(0, far, at(10));
  office.disturb({{1, 15, 20}}, at(11));
  office.disturb({{3, 1, 3}}, at(11));
  std::erase_if(office.box(), [&](const Message& m) {
    return (m.sender == 0 && m.receiver == far) || (m.sender == far && m.receiver == 0);
  });
  office.deliver_all(at(12));
  office.heal(0, far, at(20));
  office.deliver_all(at(21));

  network.arcs[1] = {1, 2, 15, 20};
  network.arcs[3] = {3, 4, 1, 3};
  EXPECT_EQ(windows(office, 5), expected(network));
  EXPECT_EQ(office.agent(0).verdict().consistent, true);
  EXPECT_EQ(office.agent(1).verdict().consistent, true);
  EXPECT_EQ(office.agent(0).blocked_since(), std::nullopt);
}

TEST_P(AnyAlgorithm, FindsANegativeCycleAcrossAgentsThatNothingTiesToTheOrigin) {
  Mastn network = MastnBuilder()
                      .node("a1", "A")
                      .node("b1", "B")
                      .arc("a1", "b1", 1, kInfinite)
                      .arc("b1", "a1", 1, kInfinite);

  PostOffice office(GetParam(), network);
  office.deliver_all();

  EXPECT_EQ(office.agent(0).verdict().consistent, false);
  EXPECT_EQ(office.agent(1).verdict().consistent, false);
}

TEST(MakeAgent, RefusesWrongNetworks) {
  const auto error = [](const Mastn& network) {
    return make_agent(Algorithm::kDipG, network, 0).error().error;
  };
  Mastn network = two_agents();

  network.arcs[1].to = 9;
  EXPECT_EQ(error(network), AgentError::kUnknownNode);
  network = two_agents();
  network.arcs.push_back(network.arcs[1]);
  EXPECT_EQ(error(network), AgentError::kArcGivenTwice);
  network = two_agents();
  network.arcs[1].to = 1;
  EXPECT_EQ(error(network), AgentError::kArcToItself);
  network = two_agents();
  network.arcs[1].min = 21;
  EXPECT_EQ(error(network), AgentError::kEmptyInterval);
  network = two_agents();
  network.arcs[1].max = kLargest + 1;
  EXPECT_EQ(error(network), AgentError::kOverflow);
  network = two_agents();
  network.owner[2] = 5;
  EXPECT_EQ(error(network), AgentError::kUnknownOwner);
  network = two_agents();
  network.owner.pop_back();
  EXPECT_EQ(error(network), AgentError::kUnknownOwner);
  EXPECT_EQ(error(Mastn{}), AgentError::kUnknownOwner);
}

TEST(MakeAgent, RefusesAnIndexThatIsNoAgents) {
  EXPECT_EQ(make_agent(Algorithm::kDipL, two_agents(), 2).error(),
            (AgentRefusal{AgentError::kUnknownAgent, 2}));
}

TEST(MakeAgent, RefusesClockErrorsThatAreNotOneForEachAgent) {
  EXPECT_EQ(make_agent(Algorithm::kDipL, two_agents(), 0, {{1}}).error().error,
            AgentError::kUnknownAgent);
  EXPECT_EQ(make_agent(Algorithm::kDipL, two_agents(), 0, {{1, -1}}).error().error,
            AgentError::kOverflow);
}

TEST(Names, AreThoseOfTheCommandLine) {
  EXPECT_EQ(to_text(Algorithm::kDipL), "dip-l");
  EXPECT_EQ(to_text(AgentError::kSeenId), "id already seen");
}

}  // namespace
}  // namespace skein::temporal::testing
