// SPDX-License-Identifier: Apache-2.0
// When tasks have ended, by what their owners say, and the windows that leaves to what follows.
#include "task_ends.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "skein/foundation/random.hpp"
#include "testing/ledger_builder.hpp"

namespace skein::auction {
namespace {

TaskEnd end_of(const TaskEnds& ends, const Ledger& ledger, double now) {
  return ends.of(ledger.entries.at(TaskNumber(5)), at(now));
}

TEST(TaskEnds, ATaskOfSeveralEndsWithTheLastOfThem) {
  const Ledger ledger = a_ledger().has(a_task(5).members(2), Stage::kGranted, {1, 2});
  TaskEnds ends;
  ends.said(MemberNumber(1), {claim_to(5), at(15)});
  ends.said(MemberNumber(2), {claim_to(5), at(12)});
  EXPECT_EQ(end_of(ends, ledger, 90).after, at(15));
  EXPECT_EQ(end_of(ends, ledger, 90).by, at(15));
}

TEST(TaskEnds, WhatWasDoneUnderAnotherSaleIsNoEnd) {
  const Ledger ledger = a_ledger().has(a_task(5), Stage::kGranted, {1}).sold_again(5);
  TaskEnds ends;
  ends.said(MemberNumber(1), {claim_to(5), at(15)});
  EXPECT_EQ(end_of(ends, ledger, 20).after, std::nullopt);
  EXPECT_EQ(end_of(ends, ledger, 20).by, at(20));
}

/// Whichever of its owners are heard, and however often, a task ended between the two bounds.
RC_GTEST_PROP(TaskEnds, HoldWhoeverIsHeard, (std::uint64_t seed)) {
  Random random(seed, "task ends");
  const Ledger ledger = a_ledger().has(a_task(5).members(3), Stage::kGranted, {1, 2, 3});
  TaskEnds ends;
  double end = 0;
  for (std::uint32_t member = 1; member <= 3; ++member) {
    const double own = random.uniform(1, 40);
    end = std::max(end, own);
    for (int said = 0; random.chance(0.6) && said < 3; ++said)
      ends.said(MemberNumber(member), {claim_to(5), at(own)});
  }
  const TaskEnd told = end_of(ends, ledger, 40);
  if (told.after) RC_ASSERT(told.after->to_seconds() <= end + 1e-6);
  RC_ASSERT(told.by.to_seconds() >= end - 1e-6);
}

TEST(BoundStart, LeavesWhatIsSureWhereverInBetweenTheFirstEnded) {
  Task then = a_task(6).lasting(20);
  bound_start(then, {10, 60}, {at(100), at(103)});
  EXPECT_EQ(then.earliest, 113);
  EXPECT_EQ(then.deadline, 180) << "it begins by 160 s";
}

TEST(BoundStart, WithoutAnEarliestEndADelayWithAGreatestLeavesNoTime) {
  Task then = a_task(6).lasting(20), open = then;
  bound_start(then, {0, 60}, {std::nullopt, at(103)});
  bound_start(open, {10, Delay().most}, {std::nullopt, at(103)});
  EXPECT_FALSE(contradictions({{then}, {}}).empty());
  EXPECT_TRUE(contradictions({{open}, {}}).empty());
}

}  // namespace
}  // namespace skein::auction
