// SPDX-License-Identifier: Apache-2.0
// What one member says and stores, message by message.
#include "skein/auction/team_member.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "testing/lone_member.hpp"
#include "testing/road_team.hpp"

namespace skein::auction {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using TeamMemberTest = testing::LoneMember;

TEST_F(TeamMemberTest, ItVotesOnceInATermAndStoresThatFirst) {
  TeamMember one = member();

  const TeamEffects first = one.handle(from(1, VoteRequest{1, false, 0, 0}), at(0));
  EXPECT_TRUE(std::holds_alternative<Store>(first.front()));
  EXPECT_TRUE(std::get<Store>(first.front()).disk.voted);
  EXPECT_THAT(said<Vote>(first), SizeIs(1));
  EXPECT_THAT(said<Vote>(one.handle(from(2, VoteRequest{1, false, 0, 0}), at(0.1))), IsEmpty());
  EXPECT_THAT(said<Vote>(one.handle(from(2, VoteRequest{2, false, 0, 0}), at(0.2))), SizeIs(1));
}

TEST_F(TeamMemberTest, AVoteSurvivesARestart) {
  TeamMember one = member();
  const TeamEffects voted = one.handle(from(1, VoteRequest{1, false, 0, 0}), at(0));

  TeamMember again = member(std::get<Store>(voted.front()).disk);

  EXPECT_THAT(said<Vote>(again.handle(from(2, VoteRequest{1, false, 0, 0}), at(1))), IsEmpty());
}

TEST_F(TeamMemberTest, WhoKnowsLessThanItGetsNoVote) {
  Disk disk;
  disk.term = 3;
  disk.ledger = granted();
  TeamMember one = member(disk);

  EXPECT_THAT(said<Vote>(one.handle(from(1, VoteRequest{4, false, 3, 3}), at(0))), IsEmpty());
  EXPECT_THAT(said<Vote>(one.handle(from(1, VoteRequest{5, false, 2, 99}), at(0))), IsEmpty());
  EXPECT_THAT(said<Vote>(one.handle(from(1, VoteRequest{6, false, 3, 4}), at(0))), SizeIs(1));
}

TEST_F(TeamMemberTest, ATrialChangesNothing) {
  TeamMember one = member();

  const TeamEffects tried = one.handle(from(1, VoteRequest{1, true, 0, 0}), at(0));

  EXPECT_THAT(said<Vote>(tried), SizeIs(1));
  EXPECT_EQ(count<Store>(tried), 0U);
  EXPECT_THAT(said<Vote>(one.handle(from(2, VoteRequest{1, false, 0, 0}), at(0.1))), SizeIs(1));
}

TEST_F(TeamMemberTest, ATrialIsRefusedWhileAHolderIsHeard) {
  TeamMember one = member();
  one.handle(from(1, Beat{3, 4, granted()}), at(0));

  EXPECT_THAT(said<Vote>(one.handle(from(2, VoteRequest{9, true, 9, 9}), at(1))), IsEmpty());
  EXPECT_THAT(said<Vote>(one.handle(from(2, VoteRequest{9, true, 9, 9}), at(3))), SizeIs(1));
}

TEST_F(TeamMemberTest, WithoutABeatItAsksOnTrialThenInEarnestThenHolds) {
  TeamMember one = member();
  one.handle(Tick{}, at(0));
  const auto asks = said<VoteRequest>(one.handle(Tick{}, *one.next_wakeup()));
  ASSERT_THAT(asks, SizeIs(2));
  EXPECT_TRUE(asks[0].trial);

  const auto earnest = said<VoteRequest>(one.handle(from(1, Vote{1, true}), at(5)));
  ASSERT_THAT(earnest, SizeIs(2));
  EXPECT_FALSE(earnest[0].trial);
  const TeamEffects held = one.handle(from(2, Vote{1, false}), at(5.1));
  EXPECT_EQ(count<TokenTaken>(held), 1U);
  EXPECT_THAT(said<Beat>(held), SizeIs(2));
  EXPECT_TRUE(one.holds_token());
}

TEST_F(TeamMemberTest, AVoteOfAnotherTermOrKindDoesNotCount) {
  TeamMember one = member();
  one.handle(Tick{}, at(0));
  one.handle(Tick{}, *one.next_wakeup());

  one.handle(from(1, Vote{1, false}), at(5));
  one.handle(from(1, Vote{2, true}), at(5));

  EXPECT_FALSE(one.holds_token());
}

TEST_F(TeamMemberTest, AGrantThatNoMajorityHasIsNotBegun) {
  TeamMember one = member();

  EXPECT_EQ(count<BeginTask>(one.handle(from(1, Beat{3, 3, granted()}), at(0))), 0U);
  EXPECT_EQ(count<BeginTask>(one.handle(from(1, Beat{3, 4, granted()}), at(1))), 1U);
  EXPECT_EQ(count<BeginTask>(one.handle(from(1, Beat{3, 4, granted()}), at(2))), 0U);
}

TEST_F(TeamMemberTest, ABeatOfAnOlderTokenIsAnsweredWithTheNewerTermAlone) {
  TeamMember one = member();
  one.handle(from(2, VoteRequest{4, false, 9, 9}), at(0));

  const TeamEffects heard = one.handle(from(1, Beat{3, 4, granted()}), at(0.1));

  EXPECT_THAT(said<Status>(heard), IsEmpty());
  ASSERT_THAT(said<NewerTerm>(heard), SizeIs(1));
  EXPECT_EQ(said<NewerTerm>(heard)[0].term, 4U);
  EXPECT_EQ(count<BeginTask>(heard), 0U);
}

TEST_F(TeamMemberTest, WhoAsksForVotesInAnOlderTermIsToldTheNewer) {
  Disk disk;
  disk.term = 5;
  TeamMember one = member(disk);

  for (const VoteRequest& older : {VoteRequest{5, true, 9, 9}, VoteRequest{4, false, 9, 9}}) {
    const TeamEffects heard = one.handle(from(1, older), at(9));
    EXPECT_THAT(said<Vote>(heard), IsEmpty());
    ASSERT_THAT(said<NewerTerm>(heard), SizeIs(1));
    EXPECT_EQ(said<NewerTerm>(heard)[0].term, 5U);
  }
  EXPECT_THAT(said<NewerTerm>(one.handle(from(1, VoteRequest{6, true, 9, 9}), at(9))), IsEmpty());
}

TEST_F(TeamMemberTest, WhoIsToldANewerTermAsksForTheOneAfterIt) {
  TeamMember one = member();
  one.handle(Tick{}, at(0));
  one.handle(Tick{}, *one.next_wakeup());

  one.handle(from(1, NewerTerm{7}), at(5));

  const auto asks = said<VoteRequest>(one.handle(Tick{}, *one.next_wakeup()));
  ASSERT_THAT(asks, SizeIs(2));
  EXPECT_EQ(asks[0].term, 8U);
}

TEST_F(TeamMemberTest, AHolderThatIsToldANewerTermGivesTheTokenUp) {
  TeamMember one = member();
  one.handle(Tick{}, at(0));
  one.handle(Tick{}, *one.next_wakeup());
  one.handle(from(1, Vote{1, true}), at(5));
  one.handle(from(1, Vote{1, false}), at(5));
  ASSERT_TRUE(one.holds_token());

  EXPECT_EQ(count<TokenLost>(one.handle(from(2, NewerTerm{1}), at(6))), 0U);
  EXPECT_EQ(count<TokenLost>(one.handle(from(2, NewerTerm{2}), at(6))), 1U);
}

// Each has what the other refuses it for.
TEST_F(TeamMemberTest, TheNewerTermAndTheNewerLedgerFindEachOther) {
  Disk newer_term, newer_ledger;
  newer_term.term = 8;
  newer_ledger.term = 3;
  newer_ledger.ledger = granted();
  const std::vector<MemberNumber> roster{MemberNumber(0), MemberNumber(1)};
  std::vector<TeamMember> both;
  both.push_back(TeamMember({roster[0], roster, {}, {}, 1, newer_term}));
  both.push_back(TeamMember({roster[1], roster, {}, {}, 1, newer_ledger}));
  for (TeamMember& one : both) one.handle(Tick{}, at(0));

  while (!both[0].holds_token() && !both[1].holds_token()) {
    const std::size_t waking = *both[0].next_wakeup() < *both[1].next_wakeup() ? 0 : 1;
    const MissionTime now = *both[waking].next_wakeup();
    ASSERT_LT(now, at(60));
    std::deque<std::pair<std::size_t, TeamInput>> inputs{{waking, Tick{}}};
    for (; !inputs.empty(); inputs.pop_front()) {
      const auto [who, input] = inputs.front();
      for (const TeamEffect& effect : both[who].handle(input, now)) {
        if (const auto* tell = std::get_if<Tell>(&effect)) {
          inputs.emplace_back(1 - who, Heard{roster[who], tell->message});
        }
      }
    }
  }

  EXPECT_TRUE(both[1].holds_token());
  EXPECT_GT(both[0].ledger().revision, 4U);
}

TEST_F(TeamMemberTest, WhatItBegunIsStoredBeforeItIsBegun) {
  TeamMember one = member();

  const TeamEffects begun = one.handle(from(1, Beat{3, 4, granted()}), at(0));

  ASSERT_TRUE(std::holds_alternative<Store>(begun.front()));
  EXPECT_THAT(std::get<Store>(begun.front()).disk.started,
              ElementsAre(std::pair(TaskNumber(5), std::uint64_t{9})));
}

TEST_F(TeamMemberTest, WhatRanWhenItCrashedIsSaidToHaveStoppedAndNotBegunAgain) {
  TeamMember one = member();
  const TeamEffects begun = one.handle(from(1, Beat{3, 4, granted()}), at(0));
  TeamMember again = member(std::get<Store>(begun.front()).disk);

  const TeamEffects heard = again.handle(from(1, Beat{3, 4, granted()}), at(1));

  EXPECT_EQ(count<BeginTask>(heard), 0U);
  EXPECT_THAT(said<Status>(heard).at(0).stopped, ElementsAre(Claim{TaskNumber(5), 9}));
}

TEST_F(TeamMemberTest, WhatIsDoneIsSaidUntilTheLedgerSaysSo) {
  TeamMember one = member();
  one.handle(from(1, Beat{3, 4, granted()}), at(0));
  one.handle(TaskDone{TaskNumber(5)}, at(10));

  for (const double second : {11, 12}) {
    const auto status = said<Status>(one.handle(from(1, Beat{3, 4, granted()}), at(second)));
    EXPECT_THAT(status.at(0).done, ElementsAre(DoneClaim{{TaskNumber(5), 9}, at(10)}));
  }
  auto later = granted();
  later->revision = 5;
  later->entries[TaskNumber(5)].stage = Stage::kDone;
  EXPECT_THAT(said<Status>(one.handle(from(1, Beat{3, 5, later}), at(13))).at(0).done, IsEmpty());
}

TEST_F(TeamMemberTest, AHolderThatHearsNoMajorityGivesTheTokenUp) {
  TeamMember one = member();
  one.handle(Tick{}, at(0));
  one.handle(Tick{}, *one.next_wakeup());
  one.handle(from(1, Vote{1, true}), at(5));
  one.handle(from(1, Vote{1, false}), at(5));
  ASSERT_TRUE(one.holds_token());

  std::size_t lost = 0;
  while (one.holds_token() && *one.next_wakeup() < at(30)) {
    lost += count<TokenLost>(one.handle(Tick{}, *one.next_wakeup()));
  }

  EXPECT_EQ(lost, 1U);
}

// Found by a random mission (--team --deaths 11988): the ground station held the token, was given a
// mission, and another held it before anybody had heard of that.
TEST_F(TeamMemberTest, AMissionIsSaidToHoldersWhoseLedgerLacksIt) {
  TeamMember one = member();
  one.handle(Tick{}, at(0));
  one.handle(Tick{}, *one.next_wakeup());
  one.handle(from(1, Vote{1, true}), at(5));
  one.handle(from(1, Vote{1, false}), at(5));
  ASSERT_TRUE(one.holds_token());
  one.handle(MissionGiven{{MissionNumber(7), {}}}, at(5.1));
  ASSERT_TRUE(one.ledger().missions.contains(MissionNumber(7)));
  const auto said_after = [&](const Beat& beat, double second) {
    return said<Status>(one.handle(from(1, beat), at(second))).at(0).missions.size();
  };
  auto later = granted();

  EXPECT_EQ(said_after({3, 4, later}, 6), 1U);
  later = std::make_shared<Ledger>(*later);
  ++later->revision;
  later->missions.insert(MissionNumber(7));
  EXPECT_EQ(said_after({3, 4, later}, 7), 0U);
  EXPECT_EQ(said_after({3, 4, nullptr}, 8), 0U);
  later = std::make_shared<Ledger>(*later);
  later->term = 5;
  later->missions.erase(MissionNumber(7));
  EXPECT_EQ(said_after({5, 5, later}, 9), 1U) << "a member that had not heard of it took the token";
}

// ---- taking part, and beats ----

struct Plain : Craft {
  Abilities abilities() const override { return 0; }
  std::optional<Leg> leg(Stopover, Stopover) const override { return Leg{1, 1, 0}; }
};

// Alone, so that it holds the token at once.
TeamMember alone() {
  TeamSetup setup;
  setup.self = MemberNumber(0);
  setup.roster = {MemberNumber(0)};
  setup.craft = [](const auto&, MissionTime) { return std::make_unique<const Plain>(); };
  setup.names = {{MemberNumber(0), "marvin"}};
  return TeamMember(std::move(setup));
}

Stage stage_after(bool bids) {
  TeamMember one = alone();
  one.handle(Bids{bids}, at(0));
  Task task;
  task.number = TaskNumber(5);
  one.handle(MissionGiven{{MissionNumber(1), {{task}, {}}}}, at(0.1));
  for (int i = 1; i < 40; ++i) one.handle(Tick{}, at(i * 0.5));
  return one.ledger().entries.at(TaskNumber(5)).stage;
}

TEST(TeamMemberTakesPart, OnlyWhoBidsIsSoldTo) {
  EXPECT_EQ(stage_after(true), Stage::kGranted);
  EXPECT_EQ(stage_after(false), Stage::kForSale);
}

TEST(TeamMemberTakesPart, WhatItOffersInTheFirstRoundIsTold) {
  TeamMember one = alone();
  one.handle(Bids{true}, at(0));
  Task task;
  task.number = TaskNumber(5);
  std::size_t offered = 0;
  one.handle(MissionGiven{{MissionNumber(1), {{task}, {}}}}, at(0.1));
  for (int i = 1; i < 40; ++i) {
    for (const TeamEffect& effect : one.handle(Tick{}, at(i * 0.5))) {
      const auto* offer = std::get_if<Offered>(&effect);
      if (offer == nullptr) continue;
      ++offered;
      EXPECT_EQ(offer->offer.items.at(0).item, TaskNumber(5));
    }
  }
  EXPECT_EQ(offered, 1U);
  EXPECT_THAT(one.ledger().entries.at(TaskNumber(5)).why, ::testing::HasSubstr("to marvin for"));
}

// One of three, with a vehicle and a task for sale, that has just been voted for by member 1.
TeamMember just_voted_for() {
  TeamSetup setup;
  setup.self = MemberNumber(0);
  setup.roster = {MemberNumber(0), MemberNumber(1), MemberNumber(2)};
  setup.craft = [](const auto&, MissionTime) { return std::make_unique<const Plain>(); };
  TeamMember one(std::move(setup));
  Task task;
  task.number = TaskNumber(5);
  one.handle(MissionGiven{{MissionNumber(1), {{task}, {}}}}, at(0));
  one.handle(Tick{}, *one.next_wakeup());
  one.handle(Heard{MemberNumber(1), Vote{1, true}}, at(5));
  one.handle(Heard{MemberNumber(1), Vote{1, false}}, at(5));
  return one;
}

// What `member` says after the first beat of member 0: it has the ledger, and a vehicle or none.
TeamInput answers(std::uint32_t member, const TeamMember& holder, bool bids) {
  const Status status{1, holder.ledger().revision, {}, {}, {}, {}, {}, bids, {}};
  return Heard{MemberNumber(member), status};
}

// Found by a mission that was given before anybody held the token: its first holder sold all of it
// to itself, "nobody else could", and began what another was nearer to.
TEST_F(TeamMemberTest, WhoTakesTheTokenHearsTheOthersBeforeItSells) {
  TeamMember one = just_voted_for();
  ASSERT_TRUE(one.holds_token());

  EXPECT_EQ(count<Offered>(one.handle(answers(1, one, false), at(5.02))), 0U);
  EXPECT_THAT(said<ToMember>(one.handle(answers(2, one, true), at(5.04))), SizeIs(1));
}

TEST_F(TeamMemberTest, WhoDoesNotAnswerTheFirstBeatIsNotWaitedForBeyondTheNext) {
  TeamMember one = just_voted_for();

  one.handle(answers(1, one, false), at(5.02));
  ASSERT_LE(*one.next_wakeup(), at(5.6));
  EXPECT_EQ(count<Offered>(one.handle(Tick{}, *one.next_wakeup())), 1U);
}

// In flight the way gets shorter all the time: that is no gain of a trade.
TEST(TeamMemberTakesPart, InOneSaleItBidsFromWhereItWasWhenThatBegan) {
  struct Moving : Plain {
    explicit Moving(MissionTime now) : seconds(now.to_seconds()) {}
    std::optional<Leg> leg(Stopover, Stopover) const override { return Leg{seconds, seconds, 0}; }
    double seconds;
  };
  TeamSetup setup;
  setup.self = MemberNumber(0);
  setup.roster = {MemberNumber(0), MemberNumber(1)};
  setup.craft = [](const auto&, MissionTime now) { return std::make_unique<const Moving>(now); };
  TeamMember one(std::move(setup));
  Task task;
  task.number = TaskNumber(5);
  const auto lot = std::make_shared<const Catalogue>(Lot{{task}, {}});
  const auto price = [&](std::uint64_t sale, std::uint32_t round, double now) {
    const Call call{SaleNumber(sale), round, lot, {}, 0, {TaskNumber(5)}, 0, false};
    for (const TeamEffect& effect : one.handle(Heard{MemberNumber(1), ToMember(call)}, at(now))) {
      const auto* tell = std::get_if<Tell>(&effect);
      const auto* said = tell ? std::get_if<ToAuctioneer>(&tell->message) : nullptr;
      if (said) return std::get<Offer>(*said).items.at(0).gaps.at(0).in.seconds;
    }
    return -1.0;
  };

  EXPECT_EQ(price(1, 1, 10), 10);
  EXPECT_EQ(price(1, 2, 11), 10);
  EXPECT_EQ(price(2, 1, 12), 12);
}

TEST_F(TeamMemberTest, WhatIsPutBackSaysWhyUntilTheLedgerSaysSo) {
  TeamMember one = member();
  auto ledger = granted();
  ledger->entries.at(TaskNumber(5)).stage = Stage::kOwned;
  one.handle(from(1, Beat{3, 4, ledger}), at(0));
  one.handle(TaskPutBack{TaskNumber(5), "degree 4"}, at(1));

  const auto told = said<Status>(one.handle(from(1, Beat{3, 4, nullptr}), at(2)));

  ASSERT_THAT(told, SizeIs(1));
  EXPECT_THAT(told[0].stopped, ElementsAre(Claim{TaskNumber(5), 9}));
  EXPECT_THAT(told[0].stopped_why, ElementsAre("degree 4"));
  EXPECT_TRUE(one.has_ended({TaskNumber(5), 9}));
  EXPECT_FALSE(one.has_ended({TaskNumber(5), 10}));
}

TEST_F(TeamMemberTest, WhatItHasDoneIsToldUnderTheSaleThatTheLedgerHas) {
  TeamMember one = member();
  one.handle(from(1, Beat{3, 4, granted()}), at(0));
  one.handle(TaskDone{TaskNumber(5)}, at(10));
  auto sold_again = granted();
  sold_again->entries.at(TaskNumber(5)).sale = 12;
  sold_again->revision = 6;

  const auto told = said<Status>(one.handle(from(1, Beat{3, 6, sold_again}), at(11)));

  ASSERT_THAT(told, SizeIs(1));
  EXPECT_THAT(told[0].done, ElementsAre(DoneClaim{Claim{TaskNumber(5), 12}, at(10)}));
}

TEST_F(TeamMemberTest, OnlyWhoLacksTheLedgerIsSentIt) {
  TeamMember one = member();
  one.handle(Tick{}, at(0));
  one.handle(Tick{}, at(5));
  one.handle(from(1, Vote{1, true}), at(5.1));
  const TeamEffects held = one.handle(from(1, Vote{1, false}), at(5.2));
  const auto first = said<Beat>(held);
  ASSERT_THAT(first, SizeIs(2));
  ASSERT_NE(first[0].ledger, nullptr);
  Status has;
  has.term = 1;
  has.revision = first[0].ledger->revision;
  one.handle(from(1, has), at(5.3));

  const auto later = said<Beat>(one.handle(Tick{}, at(6.5)));
  has.revision = 0;  // it forgot
  one.handle(from(1, has), at(6.6));
  const auto again = said<Beat>(one.handle(Tick{}, at(7.5)));

  ASSERT_THAT(later, SizeIs(2));
  EXPECT_EQ(later[0].ledger, nullptr);
  EXPECT_NE(later[1].ledger, nullptr) << "member 2 has said nothing";
  ASSERT_THAT(again, SizeIs(2));
  EXPECT_NE(again[0].ledger, nullptr);
}

}  // namespace
}  // namespace skein::auction
