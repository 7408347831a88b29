// SPDX-License-Identifier: Apache-2.0
// Tests of DIP-M: macro-constraints, packing, status flag, last value wins.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/post_office.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A: v0 -> a1 -> a2 -> a3, the frontier a1 and a3; a4 apart, tied to v0 and to nothing external.
/// B: b1, b2.
Mastn network() {
  return MastnBuilder()
      .node("a1", "A")
      .node("a2", "A")
      .node("a3", "A")
      .node("a4", "A")
      .node("b1", "B")
      .node("b2", "B")
      .arc("v0", "a1", 0, 10)
      .arc("a1", "a2", 5, 20)
      .arc("a2", "a3", 5, 20)
      .arc("v0", "a4", 0, 50)
      .arc("v0", "b1", 0, 100)
      .arc("b1", "b2", 1, 90)
      .arc("a1", "b1", 0, 100)
      .arc("a3", "b2", 0, 100);
}

MacroUpdates only_macro(const std::vector<Message>& messages) {
  EXPECT_THAT(messages, SizeIs(1));
  return std::get<MacroUpdates>(messages.front().content);
}

Message macro(std::uint64_t id, std::vector<MacroConstraint> constraints, bool consistent = true) {
  Message message;
  message.sender = 1;
  message.id = id;
  message.content = MacroUpdates{std::move(constraints), consistent};
  return message;
}

TEST(DipM, SendsWhatEliminationLeavesBetweenFrontierNodes) {
  PostOffice office(Algorithm::kDipM, network());

  const MacroUpdates updates = std::get<MacroUpdates>(office.box().front().content);

  EXPECT_THAT(updates.constraints, ::testing::UnorderedElementsAre(
                                       MacroConstraint{0, 1, 0}, MacroConstraint{1, 0, -10},
                                       MacroConstraint{1, 3, 10}, MacroConstraint{3, 1, -40}));
  EXPECT_TRUE(updates.consistent);
}

TEST(DipM, PacksAllTheChangesOfOnePerturbation) {
  PostOffice office(Algorithm::kDipM, network());
  office.deliver_all();

  const auto sent = office.disturb({{1, 6, 7}});

  EXPECT_THAT(only_macro(sent).constraints,
              ElementsAre(MacroConstraint{1, 3, 11}, MacroConstraint{3, 1, -27}));
  EXPECT_EQ(unit_count(sent.front().content), 2U);
}

TEST(DipM, SaysNothingOfWhatTheOthersCannotFeel) {
  PostOffice office(Algorithm::kDipM, network());
  office.deliver_all();

  EXPECT_THAT(office.disturb({{3, 10, 20}}), IsEmpty());
  EXPECT_EQ(office.window(4), Window(10, 20));
}

TEST(DipM, ShowsAnInconsistentComponentByItsFlagAndKeepsItsConstraints) {
  const Mastn mastn = MastnBuilder()
                          .node("a1", "A")
                          .node("a2", "A")
                          .node("b1", "B")
                          .arc("v0", "a1", 0, 10)
                          .arc("a1", "a2", 5, 20)
                          .arc("v0", "a2", 0, 100)
                          .arc("v0", "b1", 0, 100);
  PostOffice office(Algorithm::kDipM, mastn);
  office.deliver_all();

  const auto broken = office.disturb({{2, 0, 4}});
  EXPECT_EQ(only_macro(broken), (MacroUpdates{{}, false}));
  office.deliver_all();
  EXPECT_EQ(office.agent(1).verdict().consistent, false);
  EXPECT_EQ(office.agent(1).verdict().words[0].consistent, false);

  office.disturb({{2, 0, 6}});
  office.deliver_all();
  EXPECT_EQ(office.agent(1).verdict().consistent, true);
}

TEST(DipM, KeepsTheLastValueOfAKeyInWhateverOrderMessagesCome) {
  PostOffice office(Algorithm::kDipM, network());
  office.deliver_all();
  const Message first = office.disturb({{1, 6, 7}}).front();
  const Message second = office.disturb({{1, 8, 9}}).front();
  office.box().clear();
  Agent& b = office.agent(1);

  EXPECT_TRUE(b.on_message(second, at(1)).has_value());
  EXPECT_TRUE(b.on_message(first, at(2)).has_value());

  EXPECT_EQ(b.earliest(6), 13);
}

TEST(DipM, AcceptsTheDisappearanceOfAConstraint) {
  PostOffice office(Algorithm::kDipM, network());
  office.deliver_all();

  office.disturb({{1, kMinusInfinite, kInfinite}});
  office.deliver_all();

  EXPECT_EQ(office.window(6), Window(1, 190));
}

TEST(DipM, CountsEliminationsAmongItsChecks) {
  PostOffice office(Algorithm::kDipM, network());
  office.deliver_all();
  const auto before = office.agent(0).elimination_checks();

  office.disturb({{1, 6, 7}});

  EXPECT_EQ(office.agent(0).elimination_checks() - before, 2U);
  EXPECT_GT(office.agent(0).checks(), office.agent(0).elimination_checks());
}

TEST(DipM, NeverBlocks) {
  PostOffice office(Algorithm::kDipM, network());

  office.cut(0, 1, at(4));
  office.disturb({{1, 2, 3}}, at(5));

  EXPECT_EQ(office.agent(0).blocked_since(), std::nullopt);
  EXPECT_EQ(office.window(2).first, 2);
}

TEST(DipM, RefusesMacroConstraintsThatAreNotTheSenders) {
  PostOffice office(Algorithm::kDipM, network());
  office.deliver_all();
  Agent& a = office.agent(0);
  const auto refusal = [&](MacroConstraint constraint) {
    return a.on_message(macro(900, {{5, 6, 2}, constraint}), at(1)).error().error;
  };

  EXPECT_EQ(refusal({1, 5, 0}), AgentError::kNotOwner);
  EXPECT_EQ(refusal({5, 99, 0}), AgentError::kUnknownNode);
  EXPECT_EQ(refusal({5, 5, 0}), AgentError::kArcToItself);
  EXPECT_EQ(refusal({5, 6, kLargest + 1}), AgentError::kOverflow);
  EXPECT_EQ(refusal({5, 6, kInfinite}), AgentError::kEmptyInterval);

  EXPECT_EQ(office.window(1), Window(0, 10));
}

}  // namespace
}  // namespace skein::temporal::testing
