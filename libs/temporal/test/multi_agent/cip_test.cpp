// SPDX-License-Identifier: Apache-2.0
// Tests of CIP: the slaves, the supervisor, what passes between them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/post_office.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr AgentIndex kSupervisor = 2;

Message from_supervisor(Content content) {
  Message message;
  message.sender = kSupervisor;
  message.id = 900;
  message.content = std::move(content);
  return message;
}

TEST(CipSlave, SendsOneMessageForAPerturbation) {
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all();

  const auto sent = office.disturb({{1, 10, 20}, {0, 1, 2}});

  ASSERT_THAT(sent, SizeIs(1));
  EXPECT_EQ(sent.front().receiver, kSupervisor);
  EXPECT_EQ(unit_count(sent.front().content), 2U);
}

TEST(CipSlave, DoesNotKnowTheConsistencyUntilItsLastPerturbationIsAnswered) {
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all();

  office.disturb({{1, 10, 20}}, at(3));
  office.disturb({{1, 11, 20}}, at(4));
  EXPECT_EQ(office.agent(0).verdict().consistent, std::nullopt);
  EXPECT_EQ(office.agent(0).blocked_since(), at(3));

  office.deliver_one();
  while (office.box().size() > 1 && office.box().front().sender == kSupervisor)
    office.deliver_one();
  EXPECT_EQ(office.agent(0).verdict().consistent, std::nullopt);

  office.deliver_all();
  EXPECT_EQ(office.agent(0).verdict().consistent, true);
  EXPECT_EQ(office.agent(0).blocked_since(), std::nullopt);
}

TEST(CipSlave, SaysSinceWhenItIsCutFromTheSupervisor) {
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all();

  office.cut(0, kSupervisor, at(5));

  EXPECT_EQ(office.agent(0).blocked_since(), at(5));
  EXPECT_EQ(office.agent(1).blocked_since(), std::nullopt);
}

TEST(CipSlave, SendsOneSampleOfEachChangedArcWhenTheLinkReturns) {
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all();
  office.cut(0, kSupervisor);
  office.disturb({{1, 10, 20}});
  office.disturb({{1, 12, 20}});
  office.box().clear();

  const auto output = office.agent(0).on_link(kSupervisor, true, at(9));

  ASSERT_THAT(output->messages, SizeIs(1));
  EXPECT_EQ(output->messages.front().content, Content(ArcUpdates{{{1, 12, 20}}}));
}

TEST(CipSlave, RefusesDatesOfNodesThatAreNotItsOwn) {
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all();
  const auto refusal = [&](BoundChange bound) {
    const NodeUpdates updates{{{1, Bound::kLower, 7}, bound}};
    return office.agent(0).on_message(from_supervisor(updates), at(1)).error().error;
  };

  EXPECT_EQ(refusal({3, Bound::kLower, 7}), AgentError::kNotOwner);
  EXPECT_EQ(refusal({0, Bound::kLower, 7}), AgentError::kNotOwner);
  EXPECT_EQ(refusal({77, Bound::kLower, 7}), AgentError::kUnknownNode);
  EXPECT_EQ(refusal({2, Bound::kLower, kLargest + 1}), AgentError::kOverflow);

  EXPECT_EQ(office.window(1), Window(0, 10));
}

TEST(CipSlave, HearsTheSupervisorOnly) {
  PostOffice office(Algorithm::kCip, two_agents());
  Message message = from_supervisor(Consistency{});
  message.sender = 1;

  EXPECT_EQ(office.agent(0).on_message(message, at(1)).error().error, AgentError::kUnknownAgent);
}

TEST(CipSupervisor, SendsABoundOnlyWhenItDiffersFromTheLastSent) {
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all();

  office.disturb({{1, 6, 20}});
  office.deliver_one();
  std::size_t bounds = 0;
  for (const Message& message : office.box()) {
    if (std::holds_alternative<NodeUpdates>(message.content)) bounds += unit_count(message.content);
  }

  EXPECT_EQ(bounds, 3U);  // the earliest dates of a2, b1 and b2
}

TEST(CipSupervisor, SendsAlsoWhatARelaxationLeavesWeaker) {
  // Erratum 4: algorithm 2 as printed leaves the slaves with the stale date.
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all();
  office.disturb({{3, 9, 20}});
  office.deliver_all();

  office.disturb({{3, kMinusInfinite, 20}});
  office.deliver_all();

  EXPECT_EQ(office.window(4).first, 0);
}

TEST(CipSupervisor, AnswersEachPerturbationWithOneConsistency) {
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all();

  office.disturb({{1, 6, 20}});
  std::size_t words = 0;
  for (const Message& message : office.deliver_all()) words += is_data(message.content) ? 0 : 1;

  EXPECT_EQ(words, 1U);
}

TEST(CipSupervisor, RefusesPerturbationsOfItsOwnAndArcsOfOthers) {
  PostOffice office(Algorithm::kCip, two_agents());
  office.deliver_all();
  Agent& supervisor = office.agent(kSupervisor);
  const ArcUpdate change{1, 6, 7};
  EXPECT_EQ(supervisor.on_disturbance({&change, 1}, at(1)).error().error, AgentError::kNotOwner);

  Message message;
  message.sender = 1;
  message.id = 900;
  message.content = ArcUpdates{{change}};
  EXPECT_EQ(supervisor.on_message(message, at(1)).error().error, AgentError::kNotOwner);

  EXPECT_EQ(supervisor.earliest(2), 5);
}

}  // namespace
}  // namespace skein::temporal::testing
