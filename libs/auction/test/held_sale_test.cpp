// SPDX-License-Identifier: Apache-2.0
#include "held_sale.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "testing/ledger_builder.hpp"

namespace skein::auction {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const SaleNumber kNumber((3ULL << kSalesOfATerm) + 5);
const MemberNames kNames{{{MemberNumber(0), "marvin"}, {MemberNumber(1), "karma"}}};

// A sale of the lot that two members held to its end: the first begins at 0, the second at 100 m.
struct HeldSaleTest : ::testing::Test {
  HeldSale sold(std::vector<Task> tasks, std::uint64_t begun_at = 1000) {
    RoadSale team({std::move(tasks), {}}, {0, 100});
    team.hold();
    return {std::move(*team.sale), kNumber, begun_at};
  }
  std::string why(const SaleEffect& effect) {
    HeldSale sale = sold({a_task(1)});
    sale.explain(effect, kNames);
    return sale.why[TaskNumber(1)];
  }
  static Ledger booked(const HeldSale& sale, Ledger ledger) {
    ++ledger.revision;
    sale.book(ledger);
    return ledger;
  }
};

TEST_F(HeldSaleTest, SaysWhoBoughtForHowMuchAndWhoElseWouldHave) {
  Sold won{TaskNumber(1), {MemberNumber(0)}, 1, false, {0, 12.5, 0}, std::nullopt};
  EXPECT_EQ(why(won), "sold to marvin for 12.5; nobody else could");

  won.trade = true;
  won.next_best = Sold::Rival{{MemberNumber(0), MemberNumber(1)}, {0, 20, 0}};
  EXPECT_EQ(why(won), "traded to marvin for 12.5; next best marvin, karma for 20");
}

// Said by foul bids: no such numbers of milliseconds fit into a duration.
TEST_F(HeldSaleTest, SaysOfAWorthBeyondAllMeasureTheMostThatATimeHolds) {
  const auto said_of = [&](double worth) {
    return why(Sold{TaskNumber(1), {MemberNumber(0)}, 1, false, {0, worth, 0}, std::nullopt});
  };
  for (const double worth : {1e300, 1e13})
    EXPECT_EQ(said_of(worth), "sold to marvin for 9223372036.854775807; nobody else could");
  EXPECT_EQ(said_of(-1e300), "sold to marvin for -9223372036.854775808; nobody else could");
  for (const double worth : {HUGE_VAL, -HUGE_VAL, std::nan("")})
    EXPECT_EQ(said_of(worth), "sold to marvin for what nobody could do it for; nobody else could");
}

TEST_F(HeldSaleTest, SaysOfWhatWasNotSoldTheReasonOfEachBehindThatOfAll) {
  Unsold left{TaskNumber(1), {{MemberNumber(1), "too far"}, {MemberNumber(7), "broken"}}, ""};
  EXPECT_EQ(why(left), "karma: too far; 7: broken") << "who has no name has a number";

  left.together = "too few";
  EXPECT_EQ(why(left), "too few; karma: too far; 7: broken");
}

TEST_F(HeldSaleTest, SaysOfEveryTaskOfAContradictionWhatItIs) {
  HeldSale sale = sold({a_task(1)});

  sale.explain(Rejected{{{{TaskNumber(1), TaskNumber(2)}, "a circle"}}}, kNames);

  EXPECT_EQ(sale.why[TaskNumber(1)], "a circle");
  EXPECT_EQ(sale.why[TaskNumber(2)], "a circle");
}

TEST_F(HeldSaleTest, SaysNothingOfCallsAndEnds) {
  HeldSale sale = sold({a_task(1)});

  sale.explain(Ended{}, kNames);
  sale.explain(Dropped{MemberNumber(0), 1, "silent"}, kNames);

  EXPECT_THAT(sale.why, IsEmpty());
}

TEST_F(HeldSaleTest, BooksOwnersAndRoutes) {
  const Ledger next =
      booked(sold({a_task(1).at(10), a_task(2).at(90)}),
             a_ledger().has(a_task(1), Stage::kForSale).has(a_task(2), Stage::kForSale));

  EXPECT_EQ(next.entries.at(TaskNumber(1)).stage, Stage::kOwned);
  EXPECT_THAT(next.entries.at(TaskNumber(1)).owners, ElementsAre(MemberNumber(0)));
  EXPECT_THAT(next.entries.at(TaskNumber(2)).owners, ElementsAre(MemberNumber(1)));
  EXPECT_THAT(next.routes.at(MemberNumber(1)), ElementsAre(TaskNumber(2)));
  EXPECT_EQ(next.entries.at(TaskNumber(1)).revision, next.revision);
}

TEST_F(HeldSaleTest, WhatItSellsIsOwnedUnderItsNumber) {
  const Ledger next = booked(sold({a_task(1)}), a_ledger().has(a_task(1), Stage::kForSale));

  EXPECT_EQ(next.entries.at(TaskNumber(1)).sale, kNumber.value());
}

TEST_F(HeldSaleTest, WhoKeepsItsTaskKeepsItsClaim) {
  const Ledger next =
      booked(sold({a_task(1).at(10)}), a_ledger().has(a_task(1), Stage::kOwned, {0}));

  EXPECT_EQ(next.entries.at(TaskNumber(1)).sale, 101U);
  EXPECT_EQ(next.entries.at(TaskNumber(1)).revision, 1U);
}

TEST_F(HeldSaleTest, WhatChangedWhileItWasSoldStaysAsItChanged) {
  Ledger ledger = a_ledger().has(a_task(1), Stage::kForSale);
  ledger.entries.at(TaskNumber(1)).revision = 6;

  EXPECT_EQ(booked(sold({a_task(1)}, 5), ledger).entries.at(TaskNumber(1)).stage, Stage::kForSale);
  EXPECT_EQ(booked(sold({a_task(1)}, 6), ledger).entries.at(TaskNumber(1)).stage, Stage::kOwned);
}

TEST_F(HeldSaleTest, WhatIsGrantedOrDoneIsNotBookedAnew) {
  for (const Stage stage : {Stage::kGranted, Stage::kDone, Stage::kUnsold}) {
    const Ledger next = booked(sold({a_task(1).at(10)}), a_ledger().has(a_task(1), stage, {1}));

    EXPECT_EQ(next.entries.at(TaskNumber(1)).stage, stage);
    EXPECT_THAT(next.entries.at(TaskNumber(1)).owners, ElementsAre(MemberNumber(1)));
  }
}

TEST_F(HeldSaleTest, WhatNobodyBoughtIsUnsoldOnceThereIsAReason) {
  HeldSale sale = sold({a_task(1).needing(0b10)});
  const Ledger before = a_ledger().has(a_task(1), Stage::kForSale);
  EXPECT_EQ(booked(sale, before).entries.at(TaskNumber(1)).stage, Stage::kForSale);

  sale.explain(Unsold{TaskNumber(1), {{MemberNumber(0), "no camera"}}, ""}, kNames);

  const Ledger next = booked(sale, before);
  EXPECT_EQ(next.entries.at(TaskNumber(1)).stage, Stage::kUnsold);
  EXPECT_EQ(next.entries.at(TaskNumber(1)).why, "marvin: no camera");
}

TEST_F(HeldSaleTest, WhatTheSaleWasNotAboutStaysInTheRoute) {
  const Ledger next =
      booked(sold({a_task(1).at(10)}),
             a_ledger().has(a_task(9), Stage::kDone, {0}).has(a_task(1), Stage::kForSale));

  EXPECT_THAT(next.routes.at(MemberNumber(0)), ElementsAre(TaskNumber(1), TaskNumber(9)));
}

}  // namespace
}  // namespace skein::auction
