// SPDX-License-Identifier: Apache-2.0
// Negotiations whose result takes so long to reckon that it is a job.
#include <gtest/gtest.h>

#include "testing/negotiating_team.hpp"

namespace skein::interaction {
namespace {

using testing::begin_roles;
using testing::Team;
using Kind = NegotiationOutcome::Kind;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

std::optional<Duration> tenth(std::size_t, std::size_t, MissionTime) {
  return Duration::milliseconds(100);
}

struct Asked {
  NegotiationManager manager;
  ReckonResult what;
};

/// `a` knows all offers of its session with `b` and has asked for what follows from them.
Asked asked() {
  NegotiationManager manager("a", 1, testing::modalities(true), {}, at(0));
  const auto begun = manager.handle(begin_roles(2), at(1));
  const Terms terms = std::get<PrepareOffer>(begun->front()).terms;
  EXPECT_TRUE(manager.handle(OfferPrepared{terms.id(), testing::role_costs(0)}, at(1)));
  SessionMessage offer{"b", terms, std::vector<Entry>(2), true};
  offer.entries[0].uav = "a";
  offer.entries[1].uav = "b";
  offer.entries[1].offered = true;
  offer.entries[1].offer = testing::role_costs(1);
  const auto effects = manager.handle(SessionMessageReceived{offer}, at(2));
  for (const NegotiationEffect& effect : *effects) {
    if (const auto* reckon = std::get_if<ReckonResult>(&effect)) return {manager, *reckon};
  }
  ADD_FAILURE() << "no result is asked for";
  return {manager, {}};
}

bool asks(const Result<NegotiationEffects, Failure>& effects) {
  bool any = false;
  for (const auto& one : *effects) any = any || std::holds_alternative<ReckonResult>(one);
  return any;
}

TEST(LongResults, AreAgreedOnceAllHaveReckonedThem) {
  Team team(3, tenth);
  team.make_results_jobs();
  team.set_job_time(Duration::seconds(1));
  for (std::size_t i = 0; i < 3; ++i) team.begin_when_invited(i, begin_roles(3));
  team.begin(2, begin_roles(3));

  team.run_until(at(20));

  ASSERT_EQ(team.ends().size(), 3U);
  for (const auto& [member, end] : team.ends()) EXPECT_EQ(end.kind, Kind::kAgreed);
  EXPECT_EQ(team.ends().at(0).result.front(), (Row{"a", "watch", {10}}));
  EXPECT_EQ(team.outcomes().breaks(), "");
}

TEST(LongResults, ThatAreNotThereWhenHalfTheTimeIsOverFail) {
  Team team(2, tenth);
  team.make_results_jobs();
  team.begin_when_invited(1, begin_roles(2));
  team.begin(0, begin_roles(2));
  team.at(at(0.15), [&] { team.set_job_time(Duration::seconds(6)); });

  team.run_until(at(20));

  ASSERT_EQ(team.ends().size(), 2U);
  EXPECT_EQ(team.ends().at(0).why, "a: half the time is over without a promise of a");
  EXPECT_EQ(team.ends().at(1).kind, Kind::kFailed);
  EXPECT_EQ(team.outcomes().breaks(), "");
}

TEST(LongResults, AreAskedForOnce) {
  Asked one = asked();

  const auto later = one.manager.handle(NegotiationTick{}, at(4));

  EXPECT_FALSE(asks(later));
  EXPECT_EQ(one.what.offers.size(), 2U);
}

TEST(LongResults, ThatNobodyWantsAnyMoreAreRefused) {
  Asked one = asked();
  ASSERT_TRUE(one.manager.handle(WithdrawNegotiation{"mref/roles", "the operator"}, at(3)));

  const auto late = one.manager.handle(
      ResultReckoned{one.what.terms.id(), reckon(one.what.terms, one.what.offers)}, at(4));

  ASSERT_FALSE(late);
  EXPECT_NE(late.error().why.find("no result is wanted for mref/roles"), std::string::npos);
}

TEST(LongResults, OfOffersThatHaveNoneAreRefusalsWithTheReason) {
  Asked one = asked();

  const auto effects =
      one.manager.handle(ResultReckoned{one.what.terms.id(), failure("too wide for two")}, at(3));

  ASSERT_TRUE(effects);
  std::string why;
  for (const NegotiationEffect& effect : *effects) {
    if (const auto* ended = std::get_if<NegotiationEnded>(&effect)) why = ended->outcome.why;
  }
  EXPECT_EQ(why, "a: too wide for two");
}

}  // namespace
}  // namespace skein::interaction
