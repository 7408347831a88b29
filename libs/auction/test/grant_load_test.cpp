// SPDX-License-Identifier: Apache-2.0
// Who is free for what is to follow a task in time, and is kept free for it.
#include "grant_load.hpp"

#include <gtest/gtest.h>

#include "testing/ledger_builder.hpp"

namespace skein::auction {
namespace {

struct GrantLoadTest : ::testing::Test {
  // Member 1 has 5 and then 7, member 2 has 8 and then 6, which is to follow 5 in time.
  static LedgerBuilder ledger(Stage eight = Stage::kOwned, Stage six = Stage::kOwned) {
    return a_ledger()
        .has(a_task(5), Stage::kOwned, {1})
        .has(a_task(7), Stage::kOwned, {1})
        .has(a_task(8), eight, {2})
        .has(a_task(6), six, six == Stage::kForSale ? Owners() : Owners{2})
        .delay(5, 6, {10, 60});
  }
  static bool may_be_followed(const Ledger& ledger, std::uint32_t task, bool plans = true) {
    return GrantLoad(ledger, 1).may_be_followed(TaskNumber(task), plans);
  }
};

TEST_F(GrantLoadTest, NobodyBeginsWhatAnotherCannotFollowInTime) {
  EXPECT_FALSE(may_be_followed(ledger(), 5));
  EXPECT_FALSE(may_be_followed(ledger(Stage::kGranted), 5, false));
  EXPECT_TRUE(may_be_followed(ledger(Stage::kDone), 5));
  EXPECT_TRUE(may_be_followed(ledger(), 7)) << "nothing follows it";
}

TEST_F(GrantLoadTest, RoutesThatWaitForEachOtherDoNotCountForEver) {
  EXPECT_TRUE(may_be_followed(ledger(), 5, false));
}

TEST_F(GrantLoadTest, WhatIsToFollowIsSoldFirstIfAnybodyBuysIt) {
  EXPECT_FALSE(may_be_followed(ledger(Stage::kDone, Stage::kForSale), 5));
  EXPECT_TRUE(may_be_followed(ledger(Stage::kDone, Stage::kForSale), 5, false));
  EXPECT_TRUE(may_be_followed(ledger(Stage::kDone, Stage::kUnsold), 5));
}

TEST_F(GrantLoadTest, WhatElseItComesAfterIsDoneFirst) {
  EXPECT_FALSE(may_be_followed(ledger(Stage::kDone).order(7, 6), 5, false));
  EXPECT_TRUE(may_be_followed(ledger(Stage::kDone).order(8, 6), 5, false)) << "it is done";
  EXPECT_TRUE(may_be_followed(ledger(Stage::kDone).order(7, 6).order(5, 7), 5, false))
      << "7 waits for this one";
}

TEST_F(GrantLoadTest, OfTwoThatAreFollowedByTheSameOneInTimeNeitherWaitsForTheOther) {
  const LedgerBuilder both = ledger(Stage::kDone).delay(7, 6, {0, 90});
  EXPECT_TRUE(may_be_followed(both, 5));
  EXPECT_TRUE(may_be_followed(both, 7));
}

TEST_F(GrantLoadTest, WhoIsToFollowIsGrantedNothingElse) {
  Ledger now = ledger(Stage::kDone);
  now.entries.at(TaskNumber(5)).stage = Stage::kGranted;
  EXPECT_TRUE(GrantLoad(now, 3).any_full({MemberNumber(2)}));
  now.entries.at(TaskNumber(5)).stage = Stage::kDone;
  EXPECT_FALSE(GrantLoad(now, 3).any_full({MemberNumber(2)}));
}

}  // namespace
}  // namespace skein::auction
