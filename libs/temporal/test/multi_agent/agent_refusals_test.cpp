// SPDX-License-Identifier: Apache-2.0
// Every bad input of every algorithm is refused by its name, leaves the agent as it was, and does
// not use up the id of the message.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "skein/temporal/seen_ids.hpp"
#include "testing/post_office.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::IsEmpty;

class Refusals : public ::testing::TestWithParam<Algorithm> {
 protected:
  Refusals() : office_(GetParam(), two_agents()) {
    office_.deliver_all(at(2));
    before_ = visible();
  }

  /// All that can be seen of agent 0.
  struct Visible {
    Window a1, a2;
    Verdict verdict;
    std::optional<MissionTime> blocked_since;
    std::uint64_t checks = 0;
    bool operator==(const Visible&) const = default;
  };
  Visible visible() {
    Agent& a = office_.agent(0);
    return {office_.window(1), office_.window(2), a.verdict(), a.blocked_since(), a.checks()};
  }

  /// Whom agent 0 hears.
  AgentIndex peer() const { return GetParam() == Algorithm::kCip ? 2 : 1; }
  Message message(std::uint64_t id, Content content) const {
    Message message;
    message.sender = peer();
    message.receiver = 0;
    message.id = id;
    message.content = std::move(content);
    return message;
  }
  /// A content about what is the peer's, good for agent 0 at any time.
  Content good() const {
    switch (GetParam()) {
      case Algorithm::kCip:
        return NodeUpdates{{{1, Bound::kLower, 3}}};
      case Algorithm::kDipG:
        return ArcUpdates{{{3, 6, 20}}};
      case Algorithm::kDipL:
        return Update{3, Bound::kUpper, 60, true, {3}};
      case Algorithm::kDipM:
        return MacroUpdates{{{3, 0, -60}}, true};
    }
    return Hello{};
  }
  /// The same about what is not the peer's.
  Content about_others() const {
    switch (GetParam()) {
      case Algorithm::kCip:
        return NodeUpdates{{{1, Bound::kLower, 3}, {4, Bound::kLower, 3}}};
      case Algorithm::kDipG:
        return ArcUpdates{{{3, 6, 20}, {0, 6, 9}}};
      case Algorithm::kDipL:
        return Update{2, Bound::kUpper, 6, true, {2}};
      case Algorithm::kDipM:
        return MacroUpdates{{{3, 0, -60}, {2, 0, -6}}, true};
    }
    return Hello{};
  }

  AgentError refused(const Result<Output, AgentRefusal>& result) {
    EXPECT_FALSE(result.has_value());
    EXPECT_TRUE(visible() == before_) << "a refused input changes nothing";
    return result ? AgentError{} : result.error().error;
  }

  PostOffice office_;
  Visible before_;
};
INSTANTIATE_TEST_SUITE_P(All, Refusals,
                         ::testing::Values(Algorithm::kCip, Algorithm::kDipG, Algorithm::kDipL,
                                           Algorithm::kDipM));

TEST_P(Refusals, OfDisturbancesLeaveTheAgentAsItWas) {
  Agent& a = office_.agent(0);
  const auto disturb = [&](const std::vector<ArcUpdate>& changes) {
    return refused(a.on_disturbance(changes, at(9)));
  };

  EXPECT_EQ(disturb({{1, 10, 12}, {77, 0, 1}}), AgentError::kUnknownArc);
  EXPECT_EQ(disturb({{1, 10, 12}, {4, 0, 1}}), AgentError::kNotOwner);
  EXPECT_EQ(disturb({{1, 10, 12}, {2, 0, 1}}), AgentError::kExternalArc);
  EXPECT_EQ(disturb({{1, 12, 10}}), AgentError::kEmptyInterval);
  EXPECT_EQ(disturb({{1, kInfinite, kInfinite}}), AgentError::kEmptyInterval);
  EXPECT_EQ(disturb({{1, kMinusInfinite, kMinusInfinite}}), AgentError::kEmptyInterval);
  EXPECT_EQ(disturb({{1, -kLargest - 1, 10}}), AgentError::kOverflow);
  EXPECT_EQ(disturb({{1, 0, kLargest + 1}}), AgentError::kOverflow);
}

TEST_P(Refusals, OfMessagesLeaveTheAgentAsItWasAndTheIdFree) {
  Agent& a = office_.agent(0);
  Message wrong = message(500, about_others());
  EXPECT_EQ(refused(a.on_message(wrong, at(9))), AgentError::kNotOwner);

  wrong = message(500, good());
  wrong.sender = 9;
  EXPECT_EQ(refused(a.on_message(wrong, at(9))), AgentError::kUnknownAgent);
  wrong.sender = 0;
  EXPECT_EQ(refused(a.on_message(wrong, at(9))), AgentError::kUnknownAgent) << "from itself";
  wrong.sender = peer();
  wrong.receiver = 1;
  EXPECT_EQ(refused(a.on_message(wrong, at(9))), AgentError::kWrongReceiver);
  wrong.receiver = 0;
  wrong.id = 0;
  EXPECT_EQ(refused(a.on_message(wrong, at(9))), AgentError::kSeenId) << "ids begin at 1";

  EXPECT_TRUE(a.on_message(message(500, good()), at(10)).has_value());
  before_ = visible();
  EXPECT_EQ(refused(a.on_message(message(500, good()), at(11))), AgentError::kSeenId);
}

TEST_P(Refusals, OfContentsOfOtherAlgorithmsLeaveTheAgentAsItWas) {
  const std::vector<Content> contents = {ArcUpdates{}, NodeUpdates{},  Update{},
                                         Relax{},      MacroUpdates{}, Relaxed{}};
  Agent& a = office_.agent(0);
  std::size_t unexpected = 0;
  for (const Content& content : contents) {
    const bool used =
        content.index() == good().index() ||
        (GetParam() == Algorithm::kDipL && !std::holds_alternative<ArcUpdates>(content) &&
         !std::holds_alternative<NodeUpdates>(content) &&
         !std::holds_alternative<MacroUpdates>(content));
    if (used) continue;
    EXPECT_EQ(refused(a.on_message(message(500, content), at(9))), AgentError::kUnexpected);
    ++unexpected;
  }

  EXPECT_GE(unexpected, 3U);
}

TEST_P(Refusals, OfLinksThatDoNotExist) {
  Agent& a = office_.agent(0);

  for (const bool up : {false, true}) {
    EXPECT_EQ(refused(a.on_link(0, up, at(9))), AgentError::kUnknownAgent);
    EXPECT_EQ(refused(a.on_link(3, up, at(9))), AgentError::kUnknownAgent);
  }
}

TEST_P(Refusals, AnEmptyPerturbationIsNone) {
  const auto output = office_.agent(0).on_disturbance({}, at(9));

  ASSERT_TRUE(output.has_value());
  EXPECT_THAT(output->messages, IsEmpty());
  EXPECT_THAT(output->changed, IsEmpty());
  EXPECT_EQ(output->blocked_since, std::nullopt);
}

TEST_P(Refusals, OfTwoBoundsOfOneArcInAPerturbationTheLastWins) {
  office_.disturb({{1, 15, 16}, {1, 6, 7}});
  office_.deliver_all();

  EXPECT_EQ(office_.window(2), Window(6, 17));
  EXPECT_EQ(office_.window(4), Window(11, 137));
}

TEST(ValidateMastn, NamesWhatIsWrongAndWhere) {
  const auto fault = [](auto spoil) {
    Mastn network = two_agents();
    spoil(network);
    return validate(network).value_or(AgentRefusal{AgentError::kUnexpected, 99});
  };

  EXPECT_EQ(validate(two_agents()), std::nullopt);
  EXPECT_EQ(fault([](Mastn& n) { n.arcs[3].from = 5; }),
            (AgentRefusal{AgentError::kUnknownNode, 3}));
  EXPECT_EQ(fault([](Mastn& n) { n.arcs[4] = n.arcs[0]; }),
            (AgentRefusal{AgentError::kArcGivenTwice, 4}));
  EXPECT_EQ(fault([](Mastn& n) { n.arcs[1].from = 2; }),
            (AgentRefusal{AgentError::kArcToItself, 1}));
  EXPECT_EQ(fault([](Mastn& n) { n.arcs[2].min = 101; }),
            (AgentRefusal{AgentError::kEmptyInterval, 2}));
  EXPECT_EQ(fault([](Mastn& n) { n.arcs[2].min = -kLargest - 1; }),
            (AgentRefusal{AgentError::kOverflow, 2}));
  EXPECT_EQ(fault([](Mastn& n) { n.owner[3] = 2; }), (AgentRefusal{AgentError::kUnknownOwner, 3}));
}

TEST(ValidateMastn, TheSupervisorIsNotMadeOfABadNetworkEither) {
  Mastn network = two_agents();
  network.arcs[1].max = 4;

  EXPECT_EQ(make_supervisor(network).error(), (AgentRefusal{AgentError::kEmptyInterval, 1}));
  EXPECT_EQ(make_agent(Algorithm::kCip, network, 0).error(),
            (AgentRefusal{AgentError::kEmptyInterval, 1}));
}

TEST(OwnerOf, AnArcIsOfItsFirstNodeUnlessThatIsTheOrigin) {
  const Mastn network = two_agents();

  EXPECT_EQ(owner_of(network, network.arcs[2]), 0U);
  EXPECT_EQ(owner_of(network, network.arcs[4]), 1U);
  EXPECT_EQ(owner_of(network, Arc{3, 0, 0, 1}), 1U);
  EXPECT_TRUE(is_external(network, network.arcs[2]));
  EXPECT_FALSE(is_external(network, network.arcs[1]));
  EXPECT_FALSE(is_external(network, network.arcs[4])) << "nobody owns the origin";
}

TEST(AgentErrors, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (int error = 0; error <= static_cast<int>(AgentError::kWeakerUpdate); ++error) {
    names.insert(to_text(static_cast<AgentError>(error)));
  }

  EXPECT_EQ(names.size(), static_cast<std::size_t>(AgentError::kWeakerUpdate) + 1);
  EXPECT_FALSE(names.contains("unknown error"));
}

RC_GTEST_PROP(SeenIds, AreASetWhateverTheOrder, (std::vector<std::uint8_t> given)) {
  SeenIds ids;
  std::set<std::uint64_t> expected;

  for (const std::uint8_t id : given) {
    ids.insert(id % 40 + 1U);
    expected.insert(id % 40 + 1U);
  }

  for (std::uint64_t id = 0; id <= 42; ++id) RC_ASSERT(ids.contains(id) == expected.contains(id));
  RC_ASSERT(ids.last() == (expected.empty() ? 0 : *expected.rbegin()));
}

}  // namespace
}  // namespace skein::temporal::testing
