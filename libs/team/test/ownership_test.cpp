// SPDX-License-Identifier: Apache-2.0
// What of the team's book is news.
#include "skein/team/ownership.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/team/global_mission.hpp"

namespace skein::team {
namespace {

using auction::Stage;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

auction::Ledger ledger() {
  auction::Ledger book;
  book.term = 1;
  book.revision = 1;
  for (const std::uint32_t number : {11U, 12U}) {
    auction::LedgerEntry& entry = book.entries[auction::TaskNumber(number)];
    entry.task.number = auction::TaskNumber(number);
    mission::HighLevelTask task;
    task.name = "look";
    task.arguments = {std::string("P1")};
    entry.task.work = std::make_shared<const Order>(task, "operator");
  }
  return book;
}

TEST(Ownership, OfAnUnknownBookEveryTaskIsNews) {
  Ownership ownership(Roster({"marvin", "heliv"}));

  const auto news = ownership.news(ledger());

  ASSERT_THAT(news, SizeIs(2));
  EXPECT_EQ(news[0].task, mission::GoalId(11));
  EXPECT_EQ(news[0].statement, "look P1");
  EXPECT_EQ(news[0].stage, Stage::kForSale);
}

TEST(Ownership, OnlyWhatChangedIsToldWithItsOwnersAndWhy) {
  Ownership ownership(Roster({"marvin", "heliv"}));
  auction::Ledger book = ledger();
  ownership.news(book);
  book.revision = 2;
  auction::LedgerEntry& sold = book.entries.at(auction::TaskNumber(12));
  sold.stage = Stage::kOwned;
  sold.owners = {auction::MemberNumber(1)};
  sold.sale = 7;
  sold.why = "sold to heliv for 12 s";

  const auto news = ownership.news(book);

  ASSERT_THAT(news, SizeIs(1));
  EXPECT_THAT(news[0].owners, ElementsAre("heliv"));
  EXPECT_EQ(news[0].sale, 7U);
  EXPECT_EQ(news[0].why, "sold to heliv for 12 s");
  EXPECT_EQ(ownership.known().at(mission::GoalId(12)), news[0]);
}

TEST(Ownership, ARevisionThatChangesNothingForPeopleIsNoNews) {
  Ownership ownership(Roster({"marvin", "heliv"}));
  auction::Ledger book = ledger();
  ownership.news(book);
  EXPECT_THAT(ownership.news(book), IsEmpty());
  book.revision = 9;
  book.entries.at(auction::TaskNumber(11)).revision = 9;

  EXPECT_THAT(ownership.news(book), IsEmpty());
}

TEST(Ownership, StagesHaveNames) {
  EXPECT_EQ(to_text(Stage::kForSale), "for-sale");
  EXPECT_EQ(to_text(Stage::kOwned), "owned");
  EXPECT_EQ(to_text(Stage::kGranted), "granted");
  EXPECT_EQ(to_text(Stage::kDone), "done");
  EXPECT_EQ(to_text(Stage::kUnsold), "unsold");
}

}  // namespace
}  // namespace skein::team
