// SPDX-License-Identifier: Apache-2.0
// What the holder of the token makes of what the members say: statuses in, ledger out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/ledger_builder.hpp"

namespace skein::auction {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Member 0 of three holds the token and has no vehicle; 1 and 2 say what they want.
struct LedgerKeepingTest : ::testing::Test {
  void holds(const LedgerBuilder& ledger, TeamLimits limits = {}) {
    Disk disk;
    disk.ledger = ledger.shared();
    holder = std::make_unique<TeamMember>(
        TeamSetup{MemberNumber(0),
                  {MemberNumber(0), MemberNumber(1), MemberNumber(2)},
                  {},
                  limits,
                  1,
                  disk,
                  {{MemberNumber(1), "karma"}, {MemberNumber(2), "heliv"}}});
    holder->handle(Tick{}, at(0));
    holder->handle(Tick{}, *holder->next_wakeup());
    holder->handle(Heard{MemberNumber(1), Vote{1, true}}, at(5));
    holder->handle(Heard{MemberNumber(1), Vote{1, false}}, at(5));
    ASSERT_TRUE(holder->holds_token());
  }
  static Status wants(std::vector<Claim> claims) {
    Status status;
    status.term = 1;
    status.bids = false;
    status.wants = std::move(claims);
    return status;
  }
  static Status done(const std::vector<Claim>& claims, double second = 5) {
    Status status = wants({});
    for (const Claim& claim : claims) status.done.push_back({claim, at(second)});
    return status;
  }
  static Status stopped(std::vector<Claim> claims, std::vector<std::string> why = {}) {
    Status status = wants({});
    status.stopped = std::move(claims);
    status.stopped_why = std::move(why);
    return status;
  }
  TeamEffects says(std::uint32_t who, const Status& status, double second = 5.1) {
    return holder->handle(Heard{MemberNumber(who), status}, at(second));
  }
  // Member `who` is heard every second until then.
  void only_hears(std::uint32_t who, double until) {
    for (double second = 6; second <= until; second += 1) says(who, wants({}), second);
  }
  const LedgerEntry& entry(std::uint32_t task) const {
    return holder->ledger().entries.at(TaskNumber(task));
  }
  Stage stage(std::uint32_t task) const { return entry(task).stage; }

  std::unique_ptr<TeamMember> holder;
};

TEST_F(LedgerKeepingTest, ATaskIsGrantedToTheOwnerThatWantsIt) {
  holds(a_ledger().has(a_task(5), Stage::kOwned, {1}));

  says(2, wants({claim_to(5)}));
  EXPECT_EQ(stage(5), Stage::kOwned);
  says(1, wants({claim_to(5)}));
  EXPECT_EQ(stage(5), Stage::kGranted);
}

// 6 is to begin 10 to 60 s after 5 ends.
TEST_F(LedgerKeepingTest, WhatIsToFollowADelayHasTheWindowThatTheEndLeaves) {
  holds(a_ledger()
            .has(a_task(5).lasting(20), Stage::kGranted, {1})
            .has(a_task(6).lasting(15), Stage::kOwned, {2})
            .delay(5, 6, {10, 60}));

  says(1, wants({}), 5.7);
  EXPECT_EQ(entry(6).task.earliest, 0);
  says(1, done({claim_to(5)}, 5.5), 6.8);

  EXPECT_EQ(stage(5), Stage::kDone);
  EXPECT_NEAR(entry(6).task.earliest, 15.5, 1e-9);
  EXPECT_NEAR(entry(6).task.deadline, 80.5, 1e-9) << "it begins by 65.5 s";
}

// It took the token after that end: whoever ended it says when.
TEST_F(LedgerKeepingTest, TheWindowIsTheSameForAHolderThatHearsOfTheEndMuchLater) {
  holds(a_ledger()
            .has(a_task(5).lasting(20), Stage::kGranted, {1})
            .has(a_task(6).lasting(15), Stage::kOwned, {2})
            .delay(5, 6, {10, 60}));

  says(1, done({claim_to(5)}, 2.5), 31);

  EXPECT_NEAR(entry(6).task.earliest, 12.5, 1e-9);
  EXPECT_NEAR(entry(6).task.deadline, 77.5, 1e-9);
}

// One of its two owners ended its part under an earlier holder, at nobody knows what time.
TEST_F(LedgerKeepingTest, OfATaskOfSeveralTheWindowHoldsWheneverTheOtherEnded) {
  auto ledger = a_ledger()
                    .has(a_task(5).lasting(20).members(2), Stage::kGranted, {1, 2})
                    .has(a_task(6).lasting(15), Stage::kOwned, {2})
                    .delay(5, 6, {10, 60})
                    .finished(5, 1);
  holds(ledger);
  says(2, done({claim_to(5)}, 5), 8);
  EXPECT_NEAR(entry(6).task.earliest, 18, 1e-9) << "both had ended it when that was heard";
  EXPECT_NEAR(entry(6).task.deadline, 80, 1e-9) << "it had not ended before the one that is known";

  holds(ledger);
  says(1, done({claim_to(5)}, 5.5), 8);
  says(2, done({claim_to(5)}, 5), 8);
  EXPECT_NEAR(entry(6).task.earliest, 15.5, 1e-9) << "who ended it says so until the book does";
  EXPECT_NEAR(entry(6).task.deadline, 80.5, 1e-9);
}

// 2 is to do 6 in time after 5, and has 7 before that in its route.
TEST_F(LedgerKeepingTest, RoutesThatWaitForEachOtherHoldAGrantBackForALease) {
  const auto ledger = a_ledger()
                          .has(a_task(5), Stage::kOwned, {1})
                          .has(a_task(7), Stage::kOwned, {2})
                          .has(a_task(6), Stage::kOwned, {2})
                          .delay(5, 6, {10, 60});
  holds(ledger);
  const auto both_say = [&](double second) {
    says(1, wants({claim_to(5)}), second);
    says(2, wants({}), second);
  };
  for (double second = 6; second < 16; second += 1) both_say(second);
  EXPECT_EQ(stage(5), Stage::kOwned);
  both_say(17);
  EXPECT_EQ(stage(5), Stage::kGranted);
}

TEST_F(LedgerKeepingTest, WhatIsFollowedWithinADelayIsGrantedOnceWhoFollowsIsFree) {
  holds(a_ledger()
            .has(a_task(5), Stage::kOwned, {1})
            .has(a_task(7), Stage::kGranted, {2})
            .has(a_task(6), Stage::kOwned, {2})
            .delay(5, 6, {10, 60}));

  says(1, wants({claim_to(5)}));
  EXPECT_EQ(stage(5), Stage::kOwned);
  says(2, done({claim_to(7)}));
  EXPECT_EQ(stage(5), Stage::kGranted);
}

TEST_F(LedgerKeepingTest, AClaimUnderAnEarlierSaleIsNotGranted) {
  holds(a_ledger().has(a_task(5), Stage::kOwned, {1}));

  says(1, wants({Claim{TaskNumber(5), 104}}));

  EXPECT_EQ(stage(5), Stage::kOwned);
}

TEST_F(LedgerKeepingTest, AJointTaskIsGrantedOnceAllItsOwnersWantItAtATime) {
  holds(a_ledger().has(a_task(5).members(2), Stage::kOwned, {1, 2}));

  says(1, wants({claim_to(5)}));
  says(1, wants({}));
  says(2, wants({claim_to(5)}));
  EXPECT_EQ(stage(5), Stage::kOwned) << "the first does not want it any more";
  says(1, wants({claim_to(5)}));
  EXPECT_EQ(stage(5), Stage::kGranted);
}

TEST_F(LedgerKeepingTest, WhatComesAfterSomethingIsGrantedOnceThatIsDone) {
  holds(a_ledger()
            .has(a_task(4), Stage::kGranted, {2})
            .has(a_task(5), Stage::kOwned, {1})
            .order(4, 5));

  says(1, wants({claim_to(5)}));
  EXPECT_EQ(stage(5), Stage::kOwned);
  says(2, done({claim_to(4)}));
  EXPECT_EQ(stage(4), Stage::kDone);
  EXPECT_EQ(stage(5), Stage::kGranted);
}

TEST_F(LedgerKeepingTest, NobodyIsGrantedMoreThanItMayHaveAhead) {
  TeamLimits two;
  two.ahead = 2;
  const LedgerBuilder three = a_ledger()
                                  .has(a_task(4), Stage::kOwned, {1})
                                  .has(a_task(5), Stage::kOwned, {1})
                                  .has(a_task(6), Stage::kOwned, {1});
  const Status all = wants({claim_to(4), claim_to(5), claim_to(6)});

  holds(three);
  says(1, all);
  EXPECT_EQ(stage(4), Stage::kGranted);
  EXPECT_EQ(stage(5), Stage::kOwned);

  holds(three, two);
  says(1, all);
  EXPECT_EQ(stage(5), Stage::kGranted);
  EXPECT_EQ(stage(6), Stage::kOwned);
}

// Its partner is not done yet, but this member may go on.
TEST_F(LedgerKeepingTest, WhoFinishedItsPartOfAJointTaskHasRoomForTheNext) {
  holds(a_ledger()
            .has(a_task(4).members(2), Stage::kGranted, {1, 2})
            .has(a_task(5), Stage::kOwned, {1}));

  Status both = done({claim_to(4)});
  both.wants = {claim_to(5)};
  says(1, both);

  EXPECT_EQ(stage(4), Stage::kGranted);
  EXPECT_EQ(stage(5), Stage::kGranted);
}

TEST_F(LedgerKeepingTest, AJointTaskIsDoneOnceAllItsOwnersSaidSo) {
  holds(a_ledger().has(a_task(4).members(2), Stage::kGranted, {1, 2}));

  says(1, done({claim_to(4)}));
  says(1, done({claim_to(4)}));
  EXPECT_EQ(stage(4), Stage::kGranted) << "one of them twice is one of them";
  EXPECT_THAT(entry(4).finished, ElementsAre(MemberNumber(1)));
  says(2, done({claim_to(4)}));
  EXPECT_EQ(stage(4), Stage::kDone);
  EXPECT_EQ(entry(4).why, "done");
}

TEST_F(LedgerKeepingTest, ATaskThatItsOwnersGaveUpIsForSaleAndSaysWhoAndWhy) {
  holds(a_ledger().has(a_task(4), Stage::kGranted, {1}).has(a_task(5), Stage::kOwned, {2}));

  says(1, stopped({claim_to(4)}, {"wind"}));
  says(2, stopped({claim_to(5)}));

  EXPECT_EQ(stage(4), Stage::kForSale);
  EXPECT_EQ(entry(4).why, "put back by karma: wind");
  EXPECT_THAT(entry(4).owners, IsEmpty());
  EXPECT_EQ(entry(5).why, "put back by heliv");
}

// It may be in the air with it: not before the other has said so too.
TEST_F(LedgerKeepingTest, AGrantedJointTaskIsForSaleOnceAllItsOwnersSpoke) {
  holds(a_ledger().has(a_task(4).members(2), Stage::kGranted, {1, 2}));

  says(1, stopped({claim_to(4)}));
  EXPECT_EQ(stage(4), Stage::kGranted);
  says(2, done({claim_to(4)}));
  EXPECT_EQ(stage(4), Stage::kForSale);
}

TEST_F(LedgerKeepingTest, AJointTaskThatIsNotGrantedIsForSaleOnceOneOfItsOwnersGivesItUp) {
  holds(a_ledger().has(a_task(4).members(2), Stage::kOwned, {1, 2}));

  says(1, stopped({claim_to(4)}));

  EXPECT_EQ(stage(4), Stage::kForSale);
}

TEST_F(LedgerKeepingTest, NothingEndsByWhatOthersSayOrWhatIsSaidOfAnotherSale) {
  holds(a_ledger().has(a_task(4), Stage::kGranted, {1}));
  const std::uint64_t before = holder->ledger().revision;

  says(2, done({claim_to(4)}));
  says(2, stopped({claim_to(4)}));
  says(1, done({Claim{TaskNumber(4), 103}}));
  says(1, stopped({Claim{TaskNumber(99), 103}}));

  EXPECT_EQ(stage(4), Stage::kGranted);
  EXPECT_EQ(holder->ledger().revision, before) << "and no member is sent the ledger again";
}

TEST_F(LedgerKeepingTest, AStatusOfAnOlderTermChangesNothing) {
  holds(a_ledger().has(a_task(4), Stage::kGranted, {1}));
  Status older = done({claim_to(4)});
  older.term = 0;

  says(1, older);

  EXPECT_EQ(stage(4), Stage::kGranted);
}

TEST_F(LedgerKeepingTest, AfterTheLeaseWhatASilentMemberOwnsIsForSaleAndNotBefore) {
  holds(a_ledger().has(a_task(4), Stage::kOwned, {1}));
  says(1, wants({}), 5.5);

  only_hears(2, 15);
  says(2, wants({}), 15.5);
  EXPECT_EQ(stage(4), Stage::kOwned) << "ten seconds";
  says(2, wants({}), 15.6);
  EXPECT_EQ(stage(4), Stage::kForSale);
  EXPECT_EQ(entry(4).why, "karma was silent beyond its lease");
}

TEST_F(LedgerKeepingTest, WhoWasNeverHeardHasItsLeaseFromTheBeginningOfTheTerm) {
  holds(a_ledger().has(a_task(4), Stage::kOwned, {1}));

  only_hears(2, 15);
  EXPECT_EQ(stage(4), Stage::kOwned);
  says(2, wants({}), 15.1);
  EXPECT_EQ(stage(4), Stage::kForSale);
}

TEST_F(LedgerKeepingTest, WhatWasGrantedWaitsForASilentMemberUnlessItMayBeDoneTwice) {
  holds(a_ledger()
            .has(a_task(4), Stage::kGranted, {1})
            .has(a_task(5).repeatable(), Stage::kGranted, {1}));

  only_hears(2, 60);

  EXPECT_EQ(stage(4), Stage::kGranted);
  EXPECT_EQ(stage(5), Stage::kForSale);
}

// Found by random missions (--anything 950001): it was done again, long after all heard each other.
TEST_F(LedgerKeepingTest, WhatAFormerOwnerHasDoneIsDoneThoughItWasSoldAgain) {
  holds(a_ledger().has(a_task(4).repeatable(), Stage::kGranted, {2}).sold_again(4));

  says(1, done({{TaskNumber(4), entry(4).sale - 1}}));

  EXPECT_EQ(stage(4), Stage::kDone);
  EXPECT_EQ(entry(4).owners, std::vector<MemberNumber>{MemberNumber(1)});
}

TEST_F(LedgerKeepingTest, WhatAFormerOwnerHasDoneIsOneWordOfManyWhereSeveralAreToDoItTogether) {
  holds(a_ledger().has(a_task(4).members(2), Stage::kGranted, {1, 2}).sold_again(4));

  says(1, done({{TaskNumber(4), entry(4).sale - 1}}));

  EXPECT_EQ(stage(4), Stage::kGranted);
}

TEST_F(LedgerKeepingTest, WhatIsTooLateAfterOthersIsForNobodyAndItsTimesAreThoseOfTheMission) {
  holds(a_ledger()
            .has(a_task(3).lasting(20), Stage::kForSale)
            .has(a_task(4).lasting(10).by(110), Stage::kForSale)
            .order(3, 4));
  Status bids = wants({});
  bids.bids = true;
  bids.revision = holder->ledger().revision;

  says(1, bids, 95.512345678);

  EXPECT_EQ(stage(4), Stage::kUnsold);
  EXPECT_EQ(entry(4).why,
            "the last cannot end before 125.5 s, its deadline is 110 s: 3 begins at 95.5 s at the "
            "earliest and lasts 20 s, then 4 lasts 10 s");
}

TEST_F(LedgerKeepingTest, WhatALostMemberWasGrantedIsForSaleAtOnce) {
  holds(a_ledger().has(a_task(4), Stage::kGranted, {1}));

  holder->handle(DeclaredLost{MemberNumber(1)}, at(6));

  EXPECT_EQ(stage(4), Stage::kForSale);
  EXPECT_EQ(entry(4).why, "karma was declared lost");
  EXPECT_TRUE(holder->ledger().losses.is_lost(MemberNumber(1)));
}

TEST_F(LedgerKeepingTest, WhoIsFoundAgainCountsWhateverOthersHeardOfTheLoss) {
  holds(a_ledger().has(a_task(4), Stage::kGranted, {1}));
  holder->handle(DeclaredLost{MemberNumber(1)}, at(6));
  Status knows_less = wants({});
  knows_less.losses.declare(MemberNumber(1), true);

  holder->handle(DeclaredFound{MemberNumber(1)}, at(7));
  says(2, knows_less, 7.5);

  EXPECT_FALSE(holder->ledger().losses.is_lost(MemberNumber(1)));
}

TEST_F(LedgerKeepingTest, WhatALostMemberHadFinishedOfAJointTaskCounts) {
  holds(a_ledger().has(a_task(4).members(2), Stage::kGranted, {1, 2}));
  says(1, done({claim_to(4)}));

  Status tells = wants({});
  tells.losses.declare(MemberNumber(1), true);
  says(2, tells);

  EXPECT_EQ(stage(4), Stage::kGranted);
}

// ---- missions ----

struct MissionAdmissionTest : LedgerKeepingTest {
  TeamEffects given(std::uint64_t number, Lot lot) {
    return holder->handle(MissionGiven{{MissionNumber(number), std::move(lot)}}, at(5.2));
  }
  static std::vector<Contradiction> rejected_in(const TeamEffects& effects) {
    for (const TeamEffect& effect : effects) {
      const auto* told = std::get_if<SaleTold>(&effect);
      const auto* rejected = told != nullptr ? std::get_if<Rejected>(&told->what) : nullptr;
      if (rejected != nullptr) return rejected->contradictions;
    }
    return {};
  }
};

TEST_F(MissionAdmissionTest, ItsTasksAreForSale) {
  holds(a_ledger());

  given(1, {{a_task(4), a_task(5)}, {{TaskNumber(4), TaskNumber(5)}}});

  EXPECT_EQ(stage(4), Stage::kForSale);
  EXPECT_EQ(stage(5), Stage::kForSale);
  EXPECT_THAT(holder->ledger().precedences, ElementsAre(Precedence{TaskNumber(4), TaskNumber(5)}));
  EXPECT_EQ(entry(4).revision, holder->ledger().revision);
}

TEST_F(MissionAdmissionTest, GivenTwiceItIsOne) {
  holds(a_ledger());
  given(1, {{a_task(4)}, {}});
  const std::uint64_t before = holder->ledger().revision;

  given(1, {{a_task(4), a_task(9)}, {}});

  EXPECT_FALSE(holder->ledger().entries.contains(TaskNumber(9)));
  EXPECT_EQ(holder->ledger().revision, before);
}

TEST_F(MissionAdmissionTest, ATaskThatTheLedgerHasStaysAsItIs) {
  holds(a_ledger().has(a_task(4), Stage::kOwned, {1}));

  given(1, {{a_task(4).lasting(99), a_task(5)}, {}});

  EXPECT_EQ(stage(4), Stage::kOwned);
  EXPECT_EQ(entry(4).task.duration, 0);
  EXPECT_EQ(stage(5), Stage::kForSale);
}

TEST_F(MissionAdmissionTest, OneThatContradictsItselfIsRejectedWholeAndOnce) {
  holds(a_ledger());
  const Lot circle{{a_task(4), a_task(5)},
                   {{TaskNumber(4), TaskNumber(5)}, {TaskNumber(5), TaskNumber(4)}}};

  EXPECT_EQ(rejected_in(given(1, circle)).size(), 1U);

  EXPECT_THAT(holder->ledger().entries, IsEmpty());
  EXPECT_THAT(rejected_in(given(1, circle)), IsEmpty());
}

TEST_F(MissionAdmissionTest, ItMayComeAfterAnEarlierMissionButNotAfterWhatNobodyKnows) {
  holds(a_ledger().has(a_task(1), Stage::kOwned, {1}));

  EXPECT_THAT(rejected_in(given(1, {{a_task(4)}, {{TaskNumber(1), TaskNumber(4)}}})), IsEmpty());
  EXPECT_EQ(stage(4), Stage::kForSale);
  EXPECT_EQ(rejected_in(given(2, {{a_task(5)}, {{TaskNumber(77), TaskNumber(5)}}})).size(), 1U);
}

TEST_F(MissionAdmissionTest, OneGivenToAnotherMemberArrivesWithItsStatus) {
  holds(a_ledger());
  Status status = wants({});
  status.missions = {{MissionNumber(3), {{a_task(8)}, {}}}};

  says(2, status);

  EXPECT_EQ(stage(8), Stage::kForSale);
  EXPECT_THAT(holder->ledger().missions, ElementsAre(MissionNumber(3)));
}

// Found by an outsider's mission: over 19,200 bit/s a ledger was on its way for a second, a new one
// was said each second, and none arrived before it expired.
TEST_F(LedgerKeepingTest, WhoDoesNotAnswerIsToldTheLedgerEverMoreRarely) {
  holds(LedgerBuilder());
  const auto tells = [&](double second) {
    std::vector<bool> with_ledger;
    for (const TeamEffect& effect : holder->handle(Tick{}, at(second))) {
      const auto* tell = std::get_if<Tell>(&effect);
      const auto* beat = tell != nullptr ? std::get_if<Beat>(&tell->message) : nullptr;
      if (beat != nullptr) with_ledger.push_back(beat->ledger != nullptr);
    }
    return with_ledger;
  };
  const auto has_it = [&] {
    Status status = wants({});
    status.revision = holder->ledger().revision;
    return status;
  };

  std::vector<int> told;
  for (int second = 6; second < 30; ++second) {
    const auto with_ledger = tells(second);
    ASSERT_EQ(with_ledger.size(), 2U) << "both hear their holder";
    if (with_ledger[1]) told.push_back(second);
    says(1, has_it(), second);
  }
  EXPECT_THAT(told, ElementsAre(6, 7, 9, 13, 17, 21, 25, 29)) << "at most 8 beats apart";

  says(2, has_it(), 30);
  EXPECT_THAT(tells(31), ElementsAre(false, false));
}

}  // namespace
}  // namespace skein::auction
