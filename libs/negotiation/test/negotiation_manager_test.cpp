// SPDX-License-Identifier: Apache-2.0
#include "skein/negotiation/negotiation_manager.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/negotiating_team.hpp"

namespace skein::interaction {
namespace {

using testing::begin_roles;
using ::testing::ElementsAre;
using testing::name_of;
using testing::names;
using testing::Team;
using Kind = NegotiationOutcome::Kind;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

testing::Link after(Duration delay) {
  return [delay](std::size_t, std::size_t, MissionTime) { return delay; };
}
testing::Link tenth() { return after(Duration::milliseconds(100)); }

std::string kinds(Team& team) {
  std::string text;
  for (const auto& [member, end] : team.ends()) {
    text += name_of(member) + " " + std::string(to_text(end.kind)) + ". ";
  }
  return text;
}

TEST(NegotiationManager, TwoAgreeInFiveMessages) {
  Team team(2, tenth());
  team.begin_when_invited(1, begin_roles(2));
  team.begin(0, begin_roles(2));

  team.run_until(at(20));

  EXPECT_EQ(kinds(team), "a agreed. b agreed. ");
  const Rows expected{{"a", "watch", {10}}, {"b", "relay", {11}}};
  EXPECT_EQ(team.ends().at(0).result, expected);
  EXPECT_EQ(team.ends().at(1).result, expected);
  EXPECT_EQ(team.sent(), 5U);
  EXPECT_EQ(team.outcomes().breaks(), "");
}

TEST(NegotiationManager, OpenedByWhoDoesNotDecideItTakesOneMessageMore) {
  Team team(2, tenth());
  team.begin_when_invited(0, begin_roles(2));
  team.begin(1, begin_roles(2));

  team.run_until(at(20));

  EXPECT_EQ(kinds(team), "a agreed. b agreed. ");
  EXPECT_EQ(team.sent(), 6U);
}

TEST(NegotiationManager, WhoeverOpensTheResultIsOne) {
  for (std::size_t opener = 0; opener < 4; ++opener) {
    Team team(4, tenth());
    for (std::size_t i = 0; i < 4; ++i) team.begin_when_invited(i, begin_roles(4));
    team.begin(opener, begin_roles(4));

    team.run_until(at(20));

    EXPECT_EQ(kinds(team), "a agreed. b agreed. c agreed. d agreed. ") << "opened by " << opener;
    EXPECT_EQ(team.ends().at(3).result.front(), (Row{"a", "watch", {10}}));
  }
}

TEST(NegotiationManager, OpenedByAllAtOnceItIsOneSession) {
  Team team(4, tenth());
  for (std::size_t i = 0; i < 4; ++i) team.begin(i, begin_roles(4));

  team.run_until(at(20));

  EXPECT_EQ(team.outcomes().all().size(), 1U) << team.outcomes().text();
  EXPECT_EQ(kinds(team), "a agreed. b agreed. c agreed. d agreed. ");
}

TEST(NegotiationManager, OpenedOneAfterTheOtherTheEarlierSessionGoesOn) {
  Team team(3, after(Duration::seconds(1)));
  team.begin(2, begin_roles(3));
  team.at(at(0.3), [&] { team.begin(1, begin_roles(3)); });
  team.at(at(0.6), [&] { team.begin(0, begin_roles(3)); });

  team.run_until(at(20));

  EXPECT_EQ(kinds(team), "a agreed. b agreed. c agreed. ") << team.outcomes().text();
  EXPECT_EQ(team.outcomes().all().begin()->first.opener, "c");
}

TEST(NegotiationManager, WithoutOneMemberAllFail) {
  Team team(3, tenth());
  team.begin_when_invited(1, begin_roles(3));
  team.crash(2);
  team.begin(0, begin_roles(3));

  team.run_until(at(20));

  EXPECT_EQ(kinds(team), "a failed. b failed. ");
  EXPECT_EQ(team.ends().at(0).why, "a: half the time is over without an offer of c");
}

TEST(NegotiationManager, WhoCannotPlayAnyRoleLetsAllFailAtOnce) {
  Team team(3, tenth());
  for (std::size_t i = 0; i < 3; ++i) team.begin_when_invited(i, begin_roles(3));
  team.set_offer(1, failure("no path to the fire"));
  team.begin(0, begin_roles(3));

  team.run_until(at(2));

  EXPECT_EQ(kinds(team), "a failed. b failed. c failed. ");
  EXPECT_EQ(team.ends().at(2).why, "b: no path to the fire");
}

TEST(NegotiationManager, RolesThatNobodyCanPlayFailWithTheReason) {
  Team team(2, tenth());
  team.begin_when_invited(1, begin_roles(2));
  team.set_offer(0, Rows{{"relay", "", {3}}});
  team.set_offer(1, Rows{{"relay", "", {3}}});
  team.begin(0, begin_roles(2));

  team.run_until(at(20));

  EXPECT_EQ(kinds(team), "a failed. b failed. ");
  EXPECT_NE(team.ends().at(0).why.find("no assignment of roles"), std::string::npos);
}

TEST(NegotiationManager, OtherVersionsOfTheModelFailAtBothWithBothNamed) {
  Team team(2, tenth());
  BeginNegotiation other = begin_roles(2);
  other.model = ModelHash{8};
  team.begin_when_invited(1, other);
  team.begin(0, begin_roles(2));

  team.run_until(at(20));

  EXPECT_EQ(kinds(team), "a failed. b failed. ");
  EXPECT_EQ(team.ends().at(0).why,
            "b: another version of the model: 0000000000000008, that of a is 0000000000000007");
  EXPECT_EQ(team.ends().at(1).why, team.ends().at(0).why);
}

TEST(NegotiationManager, BothWithOtherVersionsFindOutWhenBothOpen) {
  Team team(2, tenth());
  BeginNegotiation other = begin_roles(2);
  other.model = ModelHash{8};
  team.begin(0, begin_roles(2));
  team.begin(1, other);

  team.run_until(at(2));

  EXPECT_EQ(kinds(team), "a failed. b failed. ");
}

TEST(NegotiationManager, TheLateAreRefused) {
  Team team(2, [](std::size_t, std::size_t, MissionTime now) -> std::optional<Duration> {
    if (now > at(1)) return std::nullopt;  // so it does not hear of the failure
    return Duration::milliseconds(100);
  });
  team.begin(0, begin_roles(2));
  team.at(at(6), [&] { team.begin(1, begin_roles(2)); });

  team.run_until(at(7));

  EXPECT_EQ(kinds(team), "a failed. b failed. ") << team.outcomes().text();
  EXPECT_EQ(team.ends().at(1).why, "b: too late for it");
}

TEST(NegotiationManager, AfterAFailureTheNextSessionIsANewOne) {
  Team team(2, tenth());
  team.begin(0, begin_roles(2));
  team.at(at(12), [&] {
    team.begin_when_invited(0, begin_roles(2));
    team.begin(1, begin_roles(2));
  });

  team.run_until(at(30));

  EXPECT_EQ(team.outcomes().all().size(), 2U);
  EXPECT_EQ(kinds(team), "a agreed. b agreed. ");
}

TEST(NegotiationManager, AWithdrawalBeforeThePromiseFailsEverywhere) {
  Team team(2, tenth());
  team.set_job_time(Duration::seconds(3));
  team.begin_when_invited(1, begin_roles(2));
  team.begin(0, begin_roles(2));
  team.at(at(4), [&] { team.give(1, WithdrawNegotiation{"mref/roles", "the operator says so"}); });

  team.run_until(at(5));

  EXPECT_EQ(kinds(team), "a failed. b failed. ");
  EXPECT_EQ(team.ends().at(0).why, "b: the operator says so");
}

TEST(NegotiationManager, WhatWasPromisedCannotBeTakenBack) {
  bool cut = false;
  Team team(2, [&](std::size_t from, std::size_t, MissionTime) -> std::optional<Duration> {
    if (cut && from == 0) return std::nullopt;
    return Duration::milliseconds(100);
  });
  team.begin_when_invited(1, begin_roles(2));
  team.begin(0, begin_roles(2));
  team.at(at(0.15), [&] {
    cut = true;
    team.give(1, WithdrawNegotiation{"mref/roles", "no"});
  });

  team.run_until(at(1));

  EXPECT_EQ(team.refused(), std::vector<std::string>{"'mref/roles' has been promised"});
}

// The decision is lost, and everything after it until long after the deadline.
TEST(NegotiationManager, WhoHeardNothingAfterItsPromiseIsUndecidedUntilItHears) {
  bool cut = false;
  Team team(2, [&](std::size_t from, std::size_t, MissionTime) -> std::optional<Duration> {
    if (cut && from == 0) return std::nullopt;
    return Duration::milliseconds(100);
  });
  team.begin_when_invited(1, begin_roles(2));
  team.begin(0, begin_roles(2));
  team.at(at(0.15), [&] { cut = true; });
  team.run_until(at(30));

  EXPECT_EQ(kinds(team), "a agreed. b undecided. ");
  EXPECT_EQ(team.ends().at(0).unconfirmed, std::vector<std::string>{"b"});
  EXPECT_EQ(team.ends().at(1).result, team.ends().at(0).result);

  cut = false;
  team.run_until(at(40));

  EXPECT_EQ(kinds(team), "a agreed. b agreed. ");
  EXPECT_EQ(team.settled(), 1U);
}

// Not the member that was cut off from the decider, but another tells it.
TEST(NegotiationManager, TheDecisionReachesWhoHearsOnlyAThird) {
  Team team(3, [&](std::size_t from, std::size_t to, MissionTime) -> std::optional<Duration> {
    if ((from == 0 && to == 2) || (from == 2 && to == 0)) return std::nullopt;
    return Duration::milliseconds(100);
  });
  for (std::size_t i = 0; i < 3; ++i) team.begin_when_invited(i, begin_roles(3));
  team.begin(1, begin_roles(3));

  team.run_until(at(20));

  EXPECT_EQ(kinds(team), "a agreed. b agreed. c agreed. ");
}

TEST(NegotiationManager, WhoWasRestartedVowsNothingInTheOldSession) {
  Team team(2, tenth());
  team.set_job_time(Duration::seconds(1));
  team.begin_when_invited(1, begin_roles(2));
  team.begin(0, begin_roles(2));
  team.at(at(0.5), [&] {
    team.crash(1);
    team.restart(1);
  });

  team.run_until(at(3));

  EXPECT_EQ(kinds(team), "a failed. ");
  EXPECT_EQ(team.ends().at(0).why, "a: b was restarted");
}

class AWrongBeginning : public ::testing::TestWithParam<std::pair<std::string, std::string>> {};

NegotiationManager alone() {
  return NegotiationManager("a", 1, standard_modalities(), {}, MissionTime());
}

TEST(NegotiationManager, ANegotiationWithoutSenseIsRefusedWithEveryReason) {
  BeginNegotiation begin = begin_roles(2);
  begin.modality = "haggling";
  begin.members = {"b", "b"};
  begin.subject = "";
  begin.within = Duration();

  const auto refused = alone().handle(begin, at(1));

  ASSERT_FALSE(refused);
  EXPECT_EQ(
      refused.error().why,
      "no subject; members out of order, or there twice; opened by 'a', who is no member; its "
      "deadline is not after its opening; unknown modality 'haggling'");
}

TEST(NegotiationManager, OneSubjectIsNegotiatedOnceAtATime) {
  NegotiationManager manager = alone();
  ASSERT_TRUE(manager.handle(begin_roles(2), at(1)));

  const auto again = manager.handle(begin_roles(2), at(2));

  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().why, "'mref/roles' is being negotiated");
}

TEST(NegotiationManager, AnOfferThatNobodyAskedForIsRefused) {
  EXPECT_FALSE(alone().handle(OfferPrepared{{"x", at(1), "a"}, Rows{}}, at(1)));
  EXPECT_FALSE(alone().handle(WithdrawNegotiation{"x", "no"}, at(1)));
}

TEST(NegotiationManager, TimeDoesNotGoBack) {
  NegotiationManager manager = alone();
  ASSERT_TRUE(manager.handle(NegotiationTick{}, at(2)));

  EXPECT_FALSE(manager.handle(NegotiationTick{}, at(1)));
}

TEST(NegotiationManager, WhatTimeDidIsToldEvenIfTheInputIsRefused) {
  NegotiationManager manager = alone();
  ASSERT_TRUE(manager.handle(begin_roles(2), at(1)));

  EXPECT_FALSE(manager.handle(WithdrawNegotiation{"something", "no"}, at(20)));
  const auto effects = manager.handle(NegotiationTick{}, at(20));

  const bool told = std::any_of(effects->begin(), effects->end(), [](const auto& one) {
    return std::holds_alternative<NegotiationEnded>(one);
  });
  EXPECT_TRUE(told);
}

/// A message of b to a about a session that b opened.
SessionMessage message_of_b() {
  NegotiationManager b("b", 1, standard_modalities(), {}, MissionTime());
  for (const auto& one : testing::open_session(b, begin_roles(2), testing::role_costs(1), at(1))) {
    if (const auto* send = std::get_if<SendSessionMessage>(&one)) return send->message;
  }
  ADD_FAILURE() << "nothing sent";
  return {};
}

struct Nonsense {
  std::string why;
  std::function<void(SessionMessage&)> make;
  friend void PrintTo(const Nonsense& one, std::ostream* to) { *to << one.why; }
};
class MessagesWithoutSense : public ::testing::TestWithParam<Nonsense> {};

TEST_P(MessagesWithoutSense, AreRejectedWithTheReason) {
  SessionMessage message = message_of_b();
  GetParam().make(message);
  NegotiationManager manager = alone();

  const auto effects = manager.handle(SessionMessageReceived{message}, at(2));

  ASSERT_EQ(effects->size(), 1U);
  const auto* rejected = std::get_if<MessageRejected>(&effects->front());
  ASSERT_NE(rejected, nullptr);
  EXPECT_EQ(rejected->why, GetParam().why);
  EXPECT_EQ(manager.state_text(), "");
}

INSTANTIATE_TEST_SUITE_P(
    All, MessagesWithoutSense,
    ::testing::Values(
        Nonsense{"of mission 2, not 1", [](auto& m) { m.terms.mission = 2; }},
        Nonsense{"of a session without a",
                 [](auto& m) {
                   m.terms.members = {"b", "c"};
                   m.from = "b";
                 }},
        Nonsense{"from itself", [](auto& m) { m.from = "a"; }},
        Nonsense{"from 'z', who is no member", [](auto& m) { m.from = "z"; }},
        Nonsense{"it has not one entry for each member", [](auto& m) { m.entries.pop_back(); }},
        Nonsense{"it speaks of 'q', not of b", [](auto& m) { m.entries[1].uav = "q"; }},
        Nonsense{"b promised without an offer",
                 [](auto& m) {
                   m.entries[1].offered = false;
                   m.entries[1].vow = Entry::Vow::kPromised;
                 }},
        Nonsense{"a figure of the offer of b is not finite",
                 [](auto& m) {
                   m.entries[1].offered = true;
                   m.entries[1].offer = {{"watch", "", {std::nan("")}}};
                 }},
        Nonsense{"a promised before the others",
                 [](auto& m) {
                   m.entries[0].offered = true;
                   m.entries[0].vow = Entry::Vow::kPromised;
                 }},
        Nonsense{"its deadline is not after its opening",
                 [](auto& m) { m.terms.deadline = m.terms.opened; }},
        Nonsense{"of a session that is over", [](auto& m) { m.terms.deadline = at(1.5); }},
        Nonsense{"opened by 'y', who is no member", [](auto& m) { m.terms.opener = "y"; }}));

TEST(NegotiationManager, AMemberThatAnswersNonsenseIsRefusedWithTheReason) {
  Team team(2, tenth());
  team.begin_when_invited(1, begin_roles(2));
  team.set_job_time(Duration::seconds(1));
  team.begin(0, begin_roles(2));
  team.at(at(1.5), [&] {
    SessionMessage lie;
    lie.from = "b";
    lie.terms = {"mref/roles",
                 1,
                 "role-allocation",
                 {"a", "b"},
                 ModelHash{7},
                 begin_roles(2).parameters,
                 "a",
                 MissionTime(),
                 at(10)};
    lie.entries.resize(2);
    lie.entries[0].uav = "a";
    lie.entries[1] = {"b", true, {{"fly-to-the-moon", "", {1}}}, Entry::Vow::kNone, 0, "", false};
    team.give(0, SessionMessageReceived{lie});
  });

  team.run_until(at(20));

  EXPECT_EQ(team.ends().at(0).why, "a: the offer of b: unknown role 'fly-to-the-moon'");
  EXPECT_EQ(team.ends().at(1).kind, Kind::kFailed);
}

/// What c says of a session of its own about the same, with a third member.
SessionMessage session_of_c(MissionTime opened) {
  SessionMessage message;
  message.from = "c";
  message.terms = {"mref/roles", 1,     "role-allocation", names(3), ModelHash{7}, {}, "c",
                   opened,       at(30)};
  for (const std::string& uav : names(3)) {
    message.entries.emplace_back();
    message.entries.back().uav = uav;
  }
  return message;
}

/// Opened before that of the two, and after it; some come before they begin.
class SessionOfOtherMembers : public ::testing::TestWithParam<double> {};

TEST_P(SessionOfOtherMembers, IsTurnedDownWithTheReasonAndTheOthersAgree) {
  Team team(3, tenth());
  team.begin_when_invited(1, begin_roles(2));
  team.set_job_time(Duration::milliseconds(200));
  team.at(at(0.2), [&] { team.begin(0, begin_roles(2)); });
  for (const double when : {0.05, 0.15, 0.25, 0.35, 0.45, 0.55}) {
    const SessionMessage intruding = session_of_c(at(GetParam() + when / 100));
    team.at(at(when), [&, intruding] {
      for (const std::size_t to : {0, 1}) team.give(to, SessionMessageReceived{intruding});
    });
  }

  team.run_until(at(20));

  const auto& two = team.outcomes().all().begin()->second;
  ASSERT_EQ(team.outcomes().all().size(), 1U) << team.outcomes().text();
  EXPECT_EQ(two.at(0).kind, Kind::kAgreed) << two.at(0).why;
  EXPECT_EQ(two.at(1).kind, Kind::kAgreed) << two.at(1).why;
  EXPECT_THAT(team.rejected(), ::testing::Contains("other members: a, b, not a, b, c"));
}

INSTANTIATE_TEST_SUITE_P(NegotiationManager, SessionOfOtherMembers, ::testing::Values(-1, 0.3),
                         [](const auto& one) { return one.param < 0 ? "Earlier" : "Later"; });

TEST(NegotiationManager, WhoWantOtherMembersFailAtBothWithBothNamed) {
  Team team(3, tenth());
  team.begin(0, begin_roles(2));
  team.begin(1, begin_roles(3));

  team.run_until(at(20));

  std::vector<std::string> whys;
  for (const auto& [id, ends] : team.outcomes().all())
    for (const auto& [member, end] : ends) whys.push_back(name_of(member) + " hears of " + end.why);
  EXPECT_THAT(whys, ElementsAre("a hears of b: other members: a, b, c, not a, b",
                                "b hears of a: other members: a, b, not a, b, c"));
}

TEST(NegotiationManager, TwoFactsThatExcludeEachOtherAreRejected) {
  NegotiationManager manager = alone();
  SessionMessage one = message_of_b();
  one.entries[1].offered = true;
  one.entries[1].offer = {{"watch", "", {1}}};
  ASSERT_TRUE(manager.handle(SessionMessageReceived{one}, at(2)));
  one.entries[1].offer = {{"watch", "", {2}}};

  const auto effects = manager.handle(SessionMessageReceived{one}, at(3));

  ASSERT_EQ(effects->size(), 1U);
  EXPECT_EQ(std::get<MessageRejected>(effects->front()).why, "b offered something else");
}

TEST(NegotiationManager, RecordsAreForgottenInTheEnd) {
  NegotiationManager manager = alone();
  ASSERT_TRUE(manager.handle(SessionMessageReceived{message_of_b()}, at(2)));
  EXPECT_NE(manager.state_text(), "");

  ASSERT_TRUE(manager.handle(NegotiationTick{}, at(1000)));

  EXPECT_EQ(manager.state_text(), "");
}

}  // namespace
}  // namespace skein::interaction
