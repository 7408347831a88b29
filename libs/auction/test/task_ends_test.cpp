// SPDX-License-Identifier: Apache-2.0
// When tasks have ended, by what their owners say, and who is to be free for what follows.
#include "task_ends.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "skein/foundation/random.hpp"
#include "testing/ledger_builder.hpp"

namespace skein::auction {
namespace {

const Claim kFive = claim_to(5);

TEST(TaskEnds, ATaskEndedBetweenTheLastStatusWithoutItAndTheFirstWith) {
  TaskEnds ends;
  ends.heard(MemberNumber(1), at(10), {});
  ends.heard(MemberNumber(1), at(12), {});
  ends.heard(MemberNumber(1), at(15), {kFive});
  ends.heard(MemberNumber(1), at(16), {kFive});
  ends.settled(TaskNumber(5), at(15.5));

  const auto end = ends.of(TaskNumber(5), at(90));
  EXPECT_EQ(end.after, at(12));
  EXPECT_EQ(end.by, at(15.5));
}

TEST(TaskEnds, WhoWasNotHeardBeforeMayHaveEndedItAtAnyTime) {
  TaskEnds ends;
  ends.heard(MemberNumber(1), at(15), {kFive});
  EXPECT_EQ(ends.of(TaskNumber(5), at(20)).after, std::nullopt);
  EXPECT_EQ(ends.of(TaskNumber(5), at(20)).by, at(20));
}

/// Whatever is lost or overtaken, a task of several ended between the two bounds.
RC_GTEST_PROP(TaskEnds, HoldWhateverIsLostOrOvertaken, (std::uint64_t seed)) {
  Random random(seed, "task ends");
  TaskEnds ends;
  struct Said {
    MemberNumber member;
    double sent, heard;
    bool done;
  };
  std::vector<Said> all;
  double end = 0;
  for (std::uint32_t member = 0; member < 2; ++member) {
    const double own = random.uniform(1, 20);
    end = std::max(end, own);
    for (double sent = random.uniform(0, 2); sent < 40; sent += random.uniform(0.1, 3))
      if (random.chance(0.6))
        all.push_back({MemberNumber(member), sent, sent + random.uniform(0, 4), sent >= own});
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.heard < b.heard; });
  std::set<MemberNumber> finished;
  for (const Said& one : all) {
    ends.heard(one.member, at(one.sent), one.done ? std::vector{kFive} : std::vector<Claim>());
    if (one.done) finished.insert(one.member);
    if (finished.size() < 2) continue;
    ends.settled(TaskNumber(5), at(one.heard));
    break;
  }
  RC_PRE(finished.size() == 2);

  const auto told = ends.of(TaskNumber(5), at(100));
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

struct FollowersTest : ::testing::Test {
  // Member 1 has 5 and then 7, member 2 has 8 and then 6, which is to follow 5 in time.
  static Ledger ledger(Stage eight = Stage::kOwned) {
    Ledger result = a_ledger()
                        .has(a_task(5), Stage::kOwned, {1})
                        .has(a_task(7), Stage::kOwned, {1})
                        .has(a_task(8), eight, {2})
                        .has(a_task(6), Stage::kOwned, {2});
    result.precedences.push_back({TaskNumber(5), TaskNumber(6), {10, 60}});
    return result;
  }
  static bool may_be_followed(const Ledger& ledger, std::uint32_t task, bool routes = true) {
    return auction::may_be_followed(ledger, ledger.entries.at(TaskNumber(task)),
                                    granted_load(ledger, 1), routes);
  }
};

TEST_F(FollowersTest, NobodyBeginsWhatAnotherCannotFollowInTime) {
  EXPECT_FALSE(may_be_followed(ledger(), 5));
  EXPECT_FALSE(may_be_followed(ledger(Stage::kGranted), 5, false));
  EXPECT_TRUE(may_be_followed(ledger(Stage::kDone), 5));
  EXPECT_TRUE(may_be_followed(ledger(), 7)) << "nothing follows it";
}

TEST_F(FollowersTest, RoutesThatWaitForEachOtherDoNotCountForEver) {
  EXPECT_TRUE(may_be_followed(ledger(), 5, false));
}

TEST_F(FollowersTest, WhoIsToFollowIsGrantedNothingElse) {
  Ledger now = ledger(Stage::kDone);
  now.entries.at(TaskNumber(5)).stage = Stage::kGranted;
  EXPECT_EQ(granted_load(now, 3).at(MemberNumber(2)), 3U);
  now.entries.at(TaskNumber(5)).stage = Stage::kDone;
  EXPECT_FALSE(granted_load(now, 3).contains(MemberNumber(2)));
}

}  // namespace
}  // namespace skein::auction
