// SPDX-License-Identifier: Apache-2.0
#include "for_sale.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/auction/lateness.hpp"
#include "testing/ledger_builder.hpp"

namespace skein::auction {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::uint32_t> numbers_of(const Lot& lot) {
  std::vector<std::uint32_t> numbers;
  for (const Task& task : lot.tasks) numbers.push_back(task.number.value());
  return numbers;
}

const std::set<MemberNumber> kOneAndTwo{MemberNumber(1), MemberNumber(2)};

TEST(LotForSale, IsWhatIsOpenAndWithNobodyWhoIsAway) {
  const Ledger ledger = a_ledger()
                            .has(a_task(1), Stage::kForSale)
                            .has(a_task(2), Stage::kOwned, {1})
                            .has(a_task(3), Stage::kGranted, {2})
                            .has(a_task(4), Stage::kDone, {1})
                            .has(a_task(5), Stage::kUnsold)
                            .has(a_task(6), Stage::kOwned, {3})
                            .has(a_task(7).members(2), Stage::kOwned, {1, 3});

  EXPECT_THAT(numbers_of(lot_for_sale(ledger, kOneAndTwo, at(0))), ElementsAre(1, 2, 3));
}

TEST(LotForSale, CountsItsTimesFromTheSale) {
  const Ledger ledger = a_ledger()
                            .has(a_task(1).from(150).by(400), Stage::kForSale)
                            .has(a_task(2).from(50).by(80), Stage::kForSale);

  const Lot lot = lot_for_sale(ledger, kOneAndTwo, at(100));

  EXPECT_EQ(lot.tasks[0].earliest, 50);
  EXPECT_EQ(lot.tasks[0].deadline, 300);
  EXPECT_EQ(lot.tasks[1].earliest, 0) << "what might have begun may begin now";
  EXPECT_EQ(lot.tasks[1].deadline, -20) << "what is late stays late";
}

TEST(LotForSale, WhatIsGrantedHasNoDeadlineAnyMore) {
  const Ledger ledger = a_ledger().has(a_task(1).by(10), Stage::kGranted, {1});

  EXPECT_TRUE(std::isinf(lot_for_sale(ledger, kOneAndTwo, at(50)).tasks.at(0).deadline));
}

TEST(LotForSale, KeepsThePrecedencesOfWhatIsOnSaleAlone) {
  const Ledger ledger = a_ledger()
                            .has(a_task(1), Stage::kDone, {1})
                            .has(a_task(2), Stage::kForSale)
                            .has(a_task(3), Stage::kForSale)
                            .has(a_task(4), Stage::kUnsold)
                            .order(1, 2)
                            .order(2, 3)
                            .order(3, 4);

  EXPECT_THAT(lot_for_sale(ledger, kOneAndTwo, at(0)).precedences,
              ElementsAre(Precedence{TaskNumber(2), TaskNumber(3)}));
}

TEST(HoldingInASale, IsTheMembersRouteWithWhatIsGrantedFixedAtItsHead) {
  const Ledger ledger = a_ledger()
                            .has(a_task(1), Stage::kDone, {1})
                            .has(a_task(2), Stage::kOwned, {1})
                            .has(a_task(3), Stage::kGranted, {1})
                            .has(a_task(4), Stage::kOwned, {1});

  const Holding held = holding(ledger, kOneAndTwo, MemberNumber(1));

  EXPECT_THAT(held.tasks, ElementsAre(TaskNumber(3), TaskNumber(2), TaskNumber(4)));
  EXPECT_EQ(held.fixed, 1U);
}

TEST(HoldingInASale, LeavesOutWhatWasSoldOnAndWhatAPartnerWhoIsAwayHasToo) {
  Ledger ledger = a_ledger()
                      .has(a_task(1), Stage::kOwned, {2})
                      .has(a_task(2).members(2), Stage::kOwned, {1, 3})
                      .has(a_task(3), Stage::kOwned, {1});
  auto& route = ledger.routes[MemberNumber(1)];
  route.insert(route.begin(), {TaskNumber(1), TaskNumber(77)});

  EXPECT_THAT(holding(ledger, kOneAndTwo, MemberNumber(1)).tasks, ElementsAre(TaskNumber(3)));
}

TEST(HoldingInASale, IsNothingOfWhoHasNoRoute) {
  const Holding held = holding(a_ledger(), kOneAndTwo, MemberNumber(1));

  EXPECT_EQ(held.member, MemberNumber(1));
  EXPECT_THAT(held.tasks, IsEmpty());
}

TEST(PutUp, LeavesATaskOfNobodyAndSaysWhy) {
  Ledger ledger = a_ledger().has(a_task(1).members(2), Stage::kGranted, {1, 2}).stopped(1, 2);
  LedgerEntry& entry = ledger.entries.at(TaskNumber(1));
  entry.finished.insert(MemberNumber(1));

  put_up(entry, "put back");

  EXPECT_EQ(entry.stage, Stage::kForSale);
  EXPECT_THAT(entry.owners, IsEmpty());
  EXPECT_THAT(entry.finished, IsEmpty());
  EXPECT_THAT(entry.stopped, IsEmpty());
  EXPECT_EQ(entry.why, "put back");
  EXPECT_EQ(entry.sale, 101U) << "what was said of the old sale is known by it";
}

TEST(TooLate, IsWhatHasNoOwnerAndIsSaidOnce) {
  const auto task = [](std::uint32_t number) { return a_task(number).lasting(20).by(80); };
  Ledger ledger = a_ledger()
                      .has(task(1), Stage::kForSale)
                      .has(task(2), Stage::kUnsold)
                      .has(task(3), Stage::kOwned, {1})
                      .has(task(4), Stage::kGranted, {1})
                      .has(task(5), Stage::kDone, {1})
                      .has(a_task(6).lasting(20), Stage::kUnsold);

  EXPECT_THAT(newly_too_late(ledger, at(60)), IsEmpty());
  EXPECT_THAT(newly_too_late(ledger, at(61)), ElementsAre(TaskNumber(1), TaskNumber(2)));
  EXPECT_THAT(unsold_in_time(ledger, at(60)), ElementsAre(TaskNumber(2), TaskNumber(6)));
  EXPECT_THAT(unsold_in_time(ledger, at(61)), ElementsAre(TaskNumber(6)));

  LedgerEntry& entry = ledger.entries.at(TaskNumber(1));
  take_out(entry, why_too_late(entry.task));
  EXPECT_EQ(entry.stage, Stage::kUnsold);
  EXPECT_THAT(newly_too_late(ledger, at(62)), ElementsAre(TaskNumber(2)));
}

TEST(AllBeforeDone, LooksAtEveryPrecedenceOfTheTaskAndIgnoresWhatTheLedgerLacks) {
  const auto ready = [](Stage first, Stage second) {
    const Ledger ledger = a_ledger()
                              .has(a_task(1), first)
                              .has(a_task(2), second)
                              .has(a_task(3), Stage::kOwned, {1})
                              .has(a_task(4), Stage::kForSale)
                              .order(1, 3)
                              .order(2, 3)
                              .order(3, 4)
                              .order(99, 3);
    return all_before_done(ledger, ledger.entries.at(TaskNumber(3)));
  };

  EXPECT_TRUE(ready(Stage::kDone, Stage::kDone));
  EXPECT_FALSE(ready(Stage::kDone, Stage::kGranted));
  EXPECT_FALSE(ready(Stage::kUnsold, Stage::kDone));
}

TEST(WorthSelling, IsAlwaysWhatHasNoOwner) {
  EXPECT_TRUE(worth_selling(a_ledger().has(a_task(1), Stage::kForSale), false, false, at(0)));
  EXPECT_FALSE(worth_selling(a_ledger(), true, true, at(0)));
}

TEST(WorthSelling, IsWhatIsOwnedIfSomebodyJoinedAndWhatIsUnsoldAlsoAfterAWhile) {
  const Ledger owned = a_ledger().has(a_task(1), Stage::kOwned, {1});
  const Ledger unsold = a_ledger().has(a_task(1), Stage::kUnsold);

  EXPECT_FALSE(worth_selling(owned, false, true, at(0)));
  EXPECT_TRUE(worth_selling(owned, true, false, at(0)));
  EXPECT_FALSE(worth_selling(unsold, false, false, at(0)));
  EXPECT_TRUE(worth_selling(unsold, true, false, at(0)));
  EXPECT_TRUE(worth_selling(unsold, false, true, at(0)));
}

TEST(WorthSelling, IsNotWhatIsUnsoldAndTooLate) {
  const Ledger unsold = a_ledger().has(a_task(1).lasting(20).by(80), Stage::kUnsold);

  EXPECT_TRUE(worth_selling(unsold, true, true, at(60)));
  EXPECT_FALSE(worth_selling(unsold, true, true, at(61)));
}

TEST(WorthSelling, IsNotWhatIsBegunOrDone) {
  const Ledger ledger =
      a_ledger().has(a_task(1), Stage::kGranted, {1}).has(a_task(2), Stage::kDone, {1});

  EXPECT_FALSE(worth_selling(ledger, true, true, at(0)));
}

TEST(NewestForSale, IsTheRevisionOfTheLastThatCameThere) {
  EXPECT_EQ(newest_for_sale(a_ledger()
                                .has(a_task(1), Stage::kForSale)
                                .has(a_task(2), Stage::kForSale)
                                .has(a_task(3), Stage::kOwned, {1})),
            2U);
  EXPECT_EQ(newest_for_sale(a_ledger().has(a_task(3), Stage::kOwned, {1})), 0U);
}

}  // namespace
}  // namespace skein::auction
