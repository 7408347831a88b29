// SPDX-License-Identifier: Apache-2.0
// Tests of DIP-G, of messages and of ids.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/temporal/seen_ids.hpp"
#include "testing/post_office.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(DipG, SendsExactlyOneMessageForAPerturbationToAll) {
  PostOffice office(Algorithm::kDipG, two_agents());

  const auto sent = office.disturb({{1, 10, 20}});

  ASSERT_THAT(sent, SizeIs(1));
  EXPECT_EQ(sent.front().receiver, std::nullopt);
}

TEST(DipG, SaysNothingInAnswer) {
  PostOffice office(Algorithm::kDipG, two_agents());

  office.disturb({{1, 10, 20}});

  EXPECT_THAT(office.deliver_all(), SizeIs(1));
}

TEST(DipG, KeepsTheLastValueOfAnArcInWhateverOrderMessagesCome) {
  PostOffice office(Algorithm::kDipG, two_agents());
  const Message first = office.disturb({{1, 10, 20}, {0, 1, 10}}).front();
  const Message second = office.disturb({{1, 12, 20}}).front();
  Agent& b = office.agent(1);

  EXPECT_TRUE(b.on_message(second, at(1)).has_value());
  EXPECT_TRUE(b.on_message(first, at(2)).has_value());

  EXPECT_EQ(b.earliest(3), 13);
  EXPECT_EQ(b.on_message(first, at(3)).error().error, AgentError::kSeenId);
}

TEST(DipG, GoesOnDuringACutAndSendsOneSampleOfEachChangedArcAfter) {
  PostOffice office(Algorithm::kDipG, two_agents());
  office.cut(0, 1);
  office.disturb({{1, 10, 20}});
  office.disturb({{1, 12, 20}});
  office.box().clear();
  EXPECT_EQ(office.window(2).first, 12);
  EXPECT_EQ(office.agent(0).blocked_since(), std::nullopt);

  const auto output = office.agent(0).on_link(1, true, at(9));

  ASSERT_THAT(output->messages, SizeIs(1));
  EXPECT_EQ(output->messages.front().receiver, 1U);
  EXPECT_EQ(output->messages.front().content, Content(ArcUpdates{{{1, 12, 20}}}));
}

TEST(DipG, ReportsOnlyItsOwnNodesAsChanged) {
  PostOffice office(Algorithm::kDipG, two_agents());
  const ArcUpdate change{1, 10, 20};

  const auto output = office.agent(0).on_disturbance({&change, 1}, at(1));

  EXPECT_THAT(output->changed, ::testing::ElementsAre(BoundChange{2, Bound::kLower, 10}));
}

TEST(DipG, SaysWhenItHeardFromEachAgent) {
  PostOffice office(Algorithm::kDipG, two_agents());
  office.disturb({{1, 10, 20}});
  office.deliver_all(at(6));

  const Verdict verdict = office.agent(1).verdict();

  EXPECT_EQ(verdict.words[0].heard, at(6));
  EXPECT_EQ(verdict.words[1].consistent, true);
}

TEST(DipG, RefusesArcsOfOthers) {
  PostOffice office(Algorithm::kDipG, two_agents());
  Message message;
  message.sender = 1;
  message.id = 1;
  message.content = ArcUpdates{{{3, 6, 7}, {1, 6, 7}}};

  EXPECT_EQ(office.agent(0).on_message(message, at(1)).error(),
            (AgentRefusal{AgentError::kNotOwner, 1}));

  EXPECT_EQ(office.agent(0).earliest(4), 10);
}

TEST(SeenIds, HoldsWhatWasInsertedInAnyOrder) {
  SeenIds ids;

  for (const std::uint64_t id : {3U, 1U, 7U, 2U, 6U}) ids.insert(id);

  for (const std::uint64_t id : {1U, 2U, 3U, 6U, 7U}) EXPECT_TRUE(ids.contains(id)) << id;
  for (const std::uint64_t id : {0U, 4U, 5U, 8U}) EXPECT_FALSE(ids.contains(id)) << id;
  EXPECT_EQ(ids.last(), 7U);
}

TEST(Message, IsWrittenForPeople) {
  EXPECT_EQ(to_text(Content(Relax{7, Bound::kLower, 3})), "RELAX(7, LB, job 3)");
  EXPECT_EQ(to_text(Content(Relaxed{7, Bound::kUpper, 3})), "RELAXED(7, UB, job 3)");
  EXPECT_EQ(to_text(Content(Update{7, Bound::kUpper, 12, true, {4, 7}})),
            "UPDATE(7, UB 12, trail 4 7)");
  EXPECT_EQ(to_text(Content(ArcUpdates{{{1, kMinusInfinite, 2}, {3, 0, kInfinite}}})),
            "UPDATE(arc 1 [-inf, 2]; arc 3 [0, +inf])");
  EXPECT_EQ(to_text(Content(NodeUpdates{{{4, Bound::kLower, 5}}})), "UPDATE(4, LB 5)");
  EXPECT_EQ(to_text(Content(MacroUpdates{{{1, 2, 3}}, false})), "MACRO(1->2 >= 3; inconsistent)");
  EXPECT_EQ(to_text(Content(Consistency{true, 9})), "CONSISTENCY(true, 9)");
  EXPECT_EQ(to_text(Content(Hello{})), "HELLO");
}

TEST(Message, CountsWhatThePaperWouldSendSingly) {
  EXPECT_EQ(unit_count(MacroUpdates{{{1, 2, 3}, {2, 1, -9}}, true}), 2U);
  EXPECT_EQ(unit_count(MacroUpdates{{}, false}), 1U);
  EXPECT_EQ(unit_count(NodeUpdates{{{4, Bound::kLower, 5}}}), 1U);
  EXPECT_EQ(unit_count(Relax{}), 1U);
  EXPECT_TRUE(is_data(Relax{}));
  EXPECT_FALSE(is_data(Consistency{}));
}

}  // namespace
}  // namespace skein::temporal::testing
