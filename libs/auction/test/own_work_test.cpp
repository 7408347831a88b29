// SPDX-License-Identifier: Apache-2.0
#include "own_work.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/ledger_builder.hpp"

namespace skein::auction {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Member 1, whose ledger is of the term that it is in.
struct OwnWorkTest : ::testing::Test {
  void knows(const LedgerBuilder& ledger) { disk.ledger = ledger.shared(); }
  Disk disk;
  TeamLimits limits;
  OwnWork own{MemberNumber(1), limits, disk};
};

TEST_F(OwnWorkTest, ItWantsTheNextOfItsRoute) {
  knows(a_ledger()
            .has(a_task(1), Stage::kDone, {1})
            .has(a_task(2), Stage::kOwned, {1})
            .has(a_task(3), Stage::kOwned, {1})
            .has(a_task(4), Stage::kOwned, {2}));

  EXPECT_THAT(own.wants(at(0)), ElementsAre(claim_to(2)));
}

TEST_F(OwnWorkTest, ItWantsAsManyAsItMayHaveAheadCountingWhatIsGranted) {
  limits.ahead = 2;
  OwnWork bold(MemberNumber(1), limits, disk);
  knows(a_ledger()
            .has(a_task(1), Stage::kGranted, {1})
            .has(a_task(2), Stage::kOwned, {1})
            .has(a_task(3), Stage::kOwned, {1}));

  EXPECT_THAT(bold.wants(at(0)), ElementsAre(claim_to(2)));
  EXPECT_THAT(own.wants(at(0)), IsEmpty());
}

TEST_F(OwnWorkTest, WhatWaitsForAnotherIsPassedOver) {
  knows(a_ledger()
            .has(a_task(1), Stage::kOwned, {2})
            .has(a_task(2), Stage::kOwned, {1})
            .has(a_task(3), Stage::kOwned, {1})
            .order(1, 2));

  EXPECT_THAT(own.wants(at(0)), ElementsAre(claim_to(3)));
}

// Routes sold in two halves of a team may wait for each other.
TEST_F(OwnWorkTest, IdleForLongerThanTheLeaseItWantsAllThatItCould) {
  knows(a_ledger().has(a_task(1), Stage::kOwned, {1}).has(a_task(2), Stage::kOwned, {1}));
  own.begin_next(99, at(5));

  EXPECT_THAT(own.wants(at(15)), ElementsAre(claim_to(1)));
  EXPECT_THAT(own.wants(at(15.001)), ElementsAre(claim_to(1), claim_to(2)));
}

// It sat idle before the mission came; that is no reason to leave the order of its route.
TEST_F(OwnWorkTest, TimeWithoutWorkIsNoTimeOfWaiting) {
  knows(a_ledger());
  own.begin_next(99, at(5));
  knows(a_ledger().has(a_task(8), Stage::kOwned, {1}).has(a_task(2), Stage::kOwned, {1}));

  EXPECT_THAT(own.wants(at(500)), ElementsAre(claim_to(8)));
  own.begin_next(99, at(500));
  EXPECT_THAT(own.wants(at(510)), ElementsAre(claim_to(8)));
  EXPECT_THAT(own.wants(at(510.001)), ElementsAre(claim_to(8), claim_to(2)));
  knows(a_ledger());
  own.begin_next(99, at(520));
  knows(a_ledger().has(a_task(8), Stage::kOwned, {1}).has(a_task(2), Stage::kOwned, {1}));
  EXPECT_THAT(own.wants(at(900)), ElementsAre(claim_to(8)));
}

TEST_F(OwnWorkTest, WhoHasNoRouteWantsNothing) {
  knows(a_ledger().has(a_task(1), Stage::kOwned, {2}));

  EXPECT_THAT(own.wants(at(0)), IsEmpty());
}

TEST_F(OwnWorkTest, ItBeginsWhatWasGrantedFirstWhateverItsNumber) {
  knows(a_ledger().has(a_task(8), Stage::kGranted, {1}).has(a_task(2), Stage::kGranted, {1}));

  EXPECT_EQ(own.begin_next(99, at(0)), claim_to(8));
  EXPECT_EQ(own.begin_next(99, at(1)), std::nullopt) << "one at a time";
  EXPECT_EQ(disk.started.at(TaskNumber(8)), 108U);
}

TEST_F(OwnWorkTest, NothingIsBegunOnALedgerThatIsNotCommittedOrOfAnOlderTerm) {
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}).term(4));
  disk.term = 4;
  EXPECT_EQ(own.begin_next(0, at(0)), std::nullopt);

  disk.term = 5;
  EXPECT_EQ(own.begin_next(1, at(0)), std::nullopt);

  disk.term = 4;
  EXPECT_EQ(own.begin_next(1, at(0)), claim_to(2));
}

TEST_F(OwnWorkTest, WhatIsDoneIsDoneUnderItsSaleAndEarlierOnes) {
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}));
  own.begin_next(1, at(0));

  EXPECT_TRUE(own.done(TaskNumber(2), at(9)));

  EXPECT_TRUE(own.has_ended({TaskNumber(2), 102}));
  EXPECT_TRUE(own.has_ended({TaskNumber(2), 101}));
  EXPECT_FALSE(own.has_ended({TaskNumber(2), 103})) << "sold to it again, it is to do it again";
  EXPECT_EQ(own.begin_next(1, at(1)), std::nullopt);
}

// Found by random missions (--anything 98): it was silent, its repeatable task was sold to another
// and traded back to it, and it began it anew when it had done it.
TEST_F(OwnWorkTest, WhatItIsAtIsDoneUnderALaterSaleToItselfToo) {
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}));
  own.begin_next(1, at(0));
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}).sold_again(2));

  EXPECT_TRUE(own.done(TaskNumber(2), at(9)));

  EXPECT_TRUE(own.has_ended({TaskNumber(2), 202}));
  EXPECT_EQ(own.begin_next(9, at(1)), std::nullopt);
}

TEST_F(OwnWorkTest, WhatIsSoldToOthersMeanwhileIsNotDoneForThem) {
  for (const auto& owners : {Owners{2}, Owners{1, 2}}) {
    knows(a_ledger().has(a_task(2), Stage::kGranted, {1}));
    own.begin_next(1, at(0));
    knows(a_ledger().has(a_task(2), Stage::kGranted, owners).sold_again(2));

    EXPECT_TRUE(own.done(TaskNumber(2), at(9)));

    EXPECT_FALSE(own.has_ended({TaskNumber(2), 202}));
    disk = {};
  }
}

TEST_F(OwnWorkTest, OnlyWhatRunsCanBeDone) {
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}).has(a_task(3), Stage::kGranted, {1}));
  EXPECT_FALSE(own.done(TaskNumber(2), at(9)));
  own.begin_next(9, at(0));

  EXPECT_FALSE(own.done(TaskNumber(3), at(9)));
  EXPECT_TRUE(own.done(TaskNumber(2), at(9)));
  EXPECT_FALSE(own.done(TaskNumber(2), at(9))) << "done twice is done once";
}

TEST_F(OwnWorkTest, WhatItHasDoneItDoesNotBeginAgainThoughItIsSoldToItOnceMore) {
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}));
  own.begin_next(9, at(0));
  EXPECT_TRUE(own.done(TaskNumber(2), at(9)));
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}).sold_again(2));

  EXPECT_EQ(own.begin_next(9, at(12)), std::nullopt);
  EXPECT_EQ(own.done_under(TaskNumber(2)), 202U)
      << "so that the holder of the token hears of its end";
}

TEST_F(OwnWorkTest, WhatItHasDoneAndOthersWereSoldIsNotItsToEnd) {
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}));
  own.begin_next(9, at(0));
  EXPECT_TRUE(own.done(TaskNumber(2), at(9)));
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1, 2}).sold_again(2));

  EXPECT_EQ(own.done_under(TaskNumber(2)), 102U);
  EXPECT_FALSE(own.has_ended({TaskNumber(2), 202}));
}

TEST_F(OwnWorkTest, WhatFailsMakesRoomForTheNextThoughItWasSoldToAnother) {
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}));
  own.begin_next(9, at(0));
  knows(a_ledger().has(a_task(2), Stage::kGranted, {2}).has(a_task(3), Stage::kGranted, {1}));

  EXPECT_TRUE(own.put_back({TaskNumber(2), "wind"}));

  EXPECT_EQ(own.begin_next(9, at(1)), claim_to(3));
}

TEST_F(OwnWorkTest, WhatRunsAndIsPutBackMakesRoomForTheNext) {
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}).has(a_task(3), Stage::kGranted, {1}));
  own.begin_next(9, at(0));

  EXPECT_TRUE(own.put_back({TaskNumber(2), "wind"}));

  EXPECT_EQ(disk.stopped_why.at(TaskNumber(2)), "wind");
  EXPECT_EQ(own.begin_next(9, at(1)), claim_to(3));
}

TEST_F(OwnWorkTest, PuttingBackWhatWaitsLeavesWhatRuns) {
  knows(a_ledger().has(a_task(2), Stage::kGranted, {1}).has(a_task(3), Stage::kOwned, {1}));
  own.begin_next(9, at(0));

  EXPECT_TRUE(own.put_back({TaskNumber(3), ""}));

  EXPECT_TRUE(own.done(TaskNumber(2), at(9)));
}

TEST_F(OwnWorkTest, WhatIsNotItsOwnCannotBePutBack) {
  knows(a_ledger().has(a_task(2), Stage::kOwned, {2}));

  EXPECT_FALSE(own.put_back({TaskNumber(2), ""}));
  EXPECT_FALSE(own.put_back({TaskNumber(77), ""}));
  EXPECT_THAT(disk.stopped, IsEmpty());
}

TEST_F(OwnWorkTest, AJointTaskThatAPartnerGaveUpIsGivenUpOnceAndSaysSo) {
  knows(a_ledger().has(a_task(2).members(2), Stage::kGranted, {1, 2}).stopped(2, 2));

  EXPECT_TRUE(own.give_up_claims());

  EXPECT_EQ(disk.stopped_why.at(TaskNumber(2)), "a partner gave it up");
  EXPECT_EQ(own.begin_next(9, at(0)), std::nullopt);
  EXPECT_FALSE(own.give_up_claims());
}

TEST_F(OwnWorkTest, WhatRunsAlreadyEndsByItselfThoughAPartnerGaveItUp) {
  knows(a_ledger().has(a_task(2).members(2), Stage::kGranted, {1, 2}));
  own.begin_next(9, at(0));
  knows(a_ledger().has(a_task(2).members(2), Stage::kGranted, {1, 2}).stopped(2, 2));

  EXPECT_FALSE(own.give_up_claims());
  EXPECT_TRUE(own.done(TaskNumber(2), at(9)));
}

TEST_F(OwnWorkTest, WhatOthersGaveUpAmongThemselvesIsNoConcern) {
  knows(a_ledger().has(a_task(2).members(2), Stage::kGranted, {2, 3}).stopped(2, 2));

  EXPECT_FALSE(own.give_up_claims());
}

}  // namespace
}  // namespace skein::auction
