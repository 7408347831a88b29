// SPDX-License-Identifier: Apache-2.0
// Tests of DIP-L: jobs, trails, sessions, and the walk-through of M 3.6.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "testing/post_office.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

template <class Content>
std::vector<Content> contents(const std::vector<Message>& messages) {
  std::vector<Content> all;
  for (const Message& message : messages) {
    if (const auto* content = std::get_if<Content>(&message.content)) all.push_back(*content);
  }
  return all;
}

Message from_b(std::uint64_t id, Content content) {
  Message message;
  message.sender = 1;
  message.receiver = 0;
  message.id = id;
  message.content = std::move(content);
  return message;
}

AgentError refusal_of(Agent& agent, const Message& message) {
  const auto result = agent.on_message(message, at(1));
  EXPECT_FALSE(result.has_value());
  return result ? AgentError{} : result.error().error;
}

/// The figure 1 of M, with values of our own chosen so that the walk-through of 3.6 happens:
/// acquisitions, a recharge of A by B, a transfer from C to B while an instrument of B is on.
Mastn figure_1() {
  MastnBuilder builder;
  for (const char* agent : {"A", "B", "C"}) {
    for (int i = 1; i <= (*agent == 'A' ? 6 : 8); ++i) {
      builder.node("v" + std::to_string(i) + agent, agent);
    }
  }
  return builder.arc("v0", "v1A", 0, 10)
      .arc("v1A", "v2A", 20, 30)
      .arc("v2A", "v3A", 10, 60)
      .arc("v3A", "v4A", 25, 40)
      .arc("v4A", "v5A", 5, 50)
      .arc("v5A", "v6A", 15, 30)
      .arc("v0", "v1B", 0, 10)
      .arc("v1B", "v2B", 30, 40)
      .arc("v2B", "v3B", 15, 20)
      .arc("v3B", "v4B", 25, 40)
      .arc("v4B", "v5B", 5, 60)
      .arc("v5B", "v6B", 2, 30)
      .arc("v6B", "v7B", 10, 200)
      .arc("v7B", "v8B", 1, 20)
      .arc("v5B", "v8B", 0, 250)
      .arc("v0", "v7B", 150, 400)
      .arc("v0", "v1C", 0, 10)
      .arc("v1C", "v2C", 10, 20)
      .arc("v2C", "v3C", 5, 30)
      .arc("v3C", "v4C", 10, 20)
      .arc("v4C", "v5C", 5, 60)
      .arc("v5C", "v6C", 5, 15)
      .arc("v6C", "v7C", 0, 30)
      .arc("v7C", "v8C", 5, 15)
      .arc("v2C", "v5C", 0, 60)
      .arc("v0", "v8C", 0, 300)
      .arc("v3A", "v3B", -5, 40)
      .arc("v4A", "v4B", -5, 40)
      .arc("v5C", "v6B", 0, 120)
      .arc("v6B", "v8C", 10, 100)
      .arc("v8C", "v7B", 0, 150);
}
constexpr std::uint32_t kArcV2bV3b = 8;

/// The numbers of nodes replaced by their names, jobs kept.
std::string named(const Mastn& network, const Message& message) {
  const auto name = [&](NodeIndex node) { return network.nodes[node]; };
  const auto bound = [](Bound b) { return b == Bound::kLower ? "LB" : "UB"; };
  std::ostringstream text;
  text << network.agents[message.sender] << " -> " << network.agents[*message.receiver] << "  ";
  if (const auto* m = std::get_if<Update>(&message.content)) {
    text << "UPDATE(" << name(m->node) << ", " << bound(m->bound) << " " << m->value << ") through";
    for (const NodeIndex node : m->trail) text << " " << name(node);
  } else if (const auto* r = std::get_if<Relax>(&message.content)) {
    text << "RELAX(" << name(r->node) << ", " << bound(r->bound) << ", job " << r->job << ")";
  } else if (const auto* d = std::get_if<Relaxed>(&message.content)) {
    text << "RELAXED(" << name(d->node) << ", " << bound(d->bound) << ", job " << d->job << ")";
  } else {
    text << to_text(message.content);
  }
  return text.str();
}

std::string blocked(PostOffice& office, const Mastn& network) {
  std::string text;
  for (AgentIndex i = 0; i < network.agents.size(); ++i) {
    if (office.agent(i).blocked_since()) text += " " + network.agents[i];
  }
  return text.empty() ? "" : "   | blocked:" + text;
}

TEST(DipL, FollowsTheRelaxationWalkThroughMessageByMessage) {
  const Mastn network = figure_1();
  PostOffice office(Algorithm::kDipL, network);
  office.deliver_all();
  std::ostringstream trace;

  office.disturb({{kArcV2bV3b, 0, 20}});
  while (!office.box().empty()) {
    const Message message = office.deliver_one();
    trace << named(network, message) << blocked(office, network) << "\n";
  }

  std::ifstream file(SKEIN_SOURCE_DIR "/libs/temporal/test/golden/dip_l_figure_1.txt");
  std::string expected;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with('#')) expected += line + "\n";
  }
  EXPECT_EQ(trace.str(), expected);
}

TEST(DipL, SendsABoundOnlyToTheAgentsThatShareTheNode) {
  PostOffice office(Algorithm::kDipL, figure_1());
  office.deliver_all();

  const auto sent = office.disturb({{kArcV2bV3b, 17, 20}});

  for (const Message& message : sent) {
    const auto* update = std::get_if<Update>(&message.content);
    if (update == nullptr) continue;
    const std::string name = figure_1().nodes[update->node];
    EXPECT_EQ(message.receiver, name == "v6B" ? 2U : 0U) << name;
  }
  EXPECT_THAT(contents<Update>(sent), SizeIs(3));
}

TEST(DipL, WaitsForRelaxedBeforeItContracts) {
  PostOffice office(Algorithm::kDipL, two_agents());
  office.deliver_all();

  const auto sent = office.disturb({{1, 2, 20}}, at(7));

  EXPECT_THAT(contents<Relax>(sent), SizeIs(1));
  EXPECT_THAT(contents<Update>(sent), IsEmpty());
  EXPECT_EQ(office.agent(0).blocked_since(), at(7));
  EXPECT_EQ(office.agent(0).verdict().consistent, std::nullopt);
  office.deliver_all(at(9));
  EXPECT_EQ(office.agent(0).blocked_since(), std::nullopt);
  EXPECT_EQ(office.window(3), Window(2, 130));
}

TEST(DipL, ClosesTwoRelaxationsOfOneChainInOneBatch) {
  // Erratum 6: with one source for each waiting node A would never contract again.
  const Mastn network = MastnBuilder()
                            .node("a1", "A")
                            .node("a2", "A")
                            .node("a3", "A")
                            .node("b1", "B")
                            .arc("v0", "a1", 0, 100)
                            .arc("a1", "a2", 5, 100)
                            .arc("a2", "a3", 5, 100)
                            .arc("a3", "b1", 0, 100)
                            .arc("v0", "b1", 0, 500);
  PostOffice office(Algorithm::kDipL, network);
  office.deliver_all();

  office.disturb({{1, 2, 100}, {2, 1, 100}});
  office.deliver_all();

  EXPECT_EQ(office.agent(0).blocked_since(), std::nullopt);
  EXPECT_EQ(office.window(4).first, 3);
}

TEST(DipL, StopsAtAPositiveCycleAcrossAgents) {
  // Erratum 12: no window closes here, only the trail tells.
  const Mastn network = MastnBuilder()
                            .node("a1", "A")
                            .node("b1", "B")
                            .arc("v0", "a1", 0, kInfinite)
                            .arc("a1", "b1", 1, kInfinite)
                            .arc("b1", "a1", 1, kInfinite);

  PostOffice office(Algorithm::kDipL, network);
  const auto delivered = office.deliver_all();

  EXPECT_LT(delivered.size(), 20U);
  EXPECT_EQ(office.agent(0).verdict().consistent, false);
}

TEST(DipL, NamesOnlyDataMessagesInConsistency) {
  // Erratum 8: counting CONSISTENCY itself, two agents answer each other for ever.
  PostOffice office(Algorithm::kDipL, two_agents());
  office.deliver_all();

  office.disturb({{1, 10, 20}});
  const auto delivered = office.deliver_all();

  EXPECT_LE(contents<Consistency>(delivered).size(), 4U);
}

TEST(DipL, StaysBlockedThroughACutUntilTheLinkReturns) {
  PostOffice office(Algorithm::kDipL, two_agents());
  office.deliver_all();

  office.disturb({{1, 2, 20}}, at(5));
  office.cut(0, 1, at(6));
  office.deliver_all(at(7));
  EXPECT_EQ(office.agent(0).blocked_since(), at(5));

  office.heal(0, 1, at(8));
  office.deliver_all(at(9));
  EXPECT_EQ(office.agent(0).blocked_since(), std::nullopt);
  EXPECT_EQ(office.window(3), Window(2, 130));
}

TEST(DipL, DropsWhatWasSentToAnEarlierSession) {
  PostOffice office(Algorithm::kDipL, two_agents());
  office.deliver_all();
  const auto old = office.disturb({{1, 10, 20}});
  office.box().clear();

  office.heal(0, 1);
  office.deliver_all();
  Message late = old.front();
  late.id += 1000;
  const auto result = office.agent(1).on_message(late, at(1));

  ASSERT_TRUE(result.has_value());
  EXPECT_THAT(result->changed, IsEmpty());
  EXPECT_EQ(office.window(3), Window(10, 130));
}

TEST(DipL, OpensTheSessionWhicheverEndIsToldFirst) {
  PostOffice office(Algorithm::kDipL, two_agents());
  office.deliver_all();

  const auto only_a = office.agent(0).on_link(1, true, at(1));
  office.post(only_a->messages);
  office.deliver_all();
  const auto then_b = office.agent(1).on_link(0, true, at(2));
  office.post(then_b->messages);
  office.deliver_all();

  EXPECT_EQ(office.window(3), Window(5, 130));
  EXPECT_EQ(office.window(2), Window(5, 30));
  EXPECT_EQ(office.agent(0).verdict().consistent, true);
  EXPECT_EQ(office.agent(1).verdict().consistent, true);
}

TEST(DipL, TellsHowOldTheWordOfEachAgentIs) {
  PostOffice office(Algorithm::kDipL, two_agents());
  office.deliver_all(at(3));

  const Verdict verdict = office.agent(0).verdict();

  EXPECT_EQ(verdict.words[1], (LastWord{true, at(3)}));
  EXPECT_EQ(verdict.words[0], (LastWord{true, std::nullopt}));
}

TEST(DipL, RefusesBoundsOfNodesThatAreNotTheSenders) {
  PostOffice office(Algorithm::kDipL, two_agents());
  office.deliver_all();
  Agent& a = office.agent(0);
  const auto update = [](NodeIndex node, std::vector<NodeIndex> trail) {
    return Update{node, Bound::kLower, 50, true, std::move(trail)};
  };

  EXPECT_EQ(refusal_of(a, from_b(900, update(2, {2}))), AgentError::kNotOwner);
  EXPECT_EQ(refusal_of(a, from_b(900, update(99, {99}))), AgentError::kUnknownNode);
  EXPECT_EQ(refusal_of(a, from_b(900, update(4, {4}))), AgentError::kUnknownNode);
  EXPECT_EQ(refusal_of(a, from_b(900, update(3, {2}))), AgentError::kNotOwner);
  EXPECT_EQ(refusal_of(a, from_b(900, update(3, {3, 2, 3}))), AgentError::kCyclicOwnership);
  EXPECT_EQ(refusal_of(a, from_b(900, Relax{1, Bound::kLower, 1})), AgentError::kNotOwner);
  EXPECT_EQ(refusal_of(a, from_b(900, Relaxed{1, Bound::kLower, 1})), AgentError::kNotOwner);
  EXPECT_EQ(refusal_of(a, from_b(900, Relaxed{2, Bound::kLower, 99})), AgentError::kUnknownJob);

  EXPECT_EQ(office.window(2), Window(5, 30));
}

TEST(DipL, RefusesAnUpdateWeakerThanTheLastOrOutOfRange) {
  PostOffice office(Algorithm::kDipL, two_agents());
  office.deliver_all();
  Agent& a = office.agent(0);

  EXPECT_EQ(refusal_of(a, from_b(900, Update{3, Bound::kLower, 1, true, {3}})),
            AgentError::kWeakerUpdate);
  EXPECT_EQ(refusal_of(a, from_b(900, Update{3, Bound::kLower, kLargest + 1, true, {3}})),
            AgentError::kOverflow);
}

TEST(DipL, RefusesAnAnswerToASessionThatNeverWas) {
  PostOffice office(Algorithm::kDipL, two_agents());
  office.deliver_all();
  Message message = from_b(900, Hello{});
  message.receiver_epoch = 4;

  EXPECT_EQ(refusal_of(office.agent(0), message), AgentError::kUnexpected);
}

}  // namespace
}  // namespace skein::temporal::testing
