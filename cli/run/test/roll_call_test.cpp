// SPDX-License-Identifier: Apache-2.0
#include "roll_call.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::run_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Verdict = RollCall::Verdict;

Duration second(double seconds) { return Duration::seconds(seconds); }
const double kSilence = RollCall::kPatience.to_seconds();

/// Karma and Marvin are started at 0, the clock runs from 100 s on.
class RollCalls : public ::testing::Test {
 protected:
  void SetUp() override {
    roll_call.started("marvin", second(0));
    roll_call.started("karma", second(0));
  }
  void start_mission() { roll_call.runs(second(100)); }

  RollCall roll_call;
};

TEST_F(RollCalls, WaitForNobodyBeforeTheClockRuns) {
  EXPECT_EQ(roll_call.verdict(second(1000)), Verdict::kGoOn);
  EXPECT_THAT(roll_call.missing(second(1000)), IsEmpty());
}

TEST_F(RollCalls, AreCompleteWhereAllWereHeard) {
  roll_call.heard("marvin");
  roll_call.heard("karma");
  start_mission();

  EXPECT_EQ(roll_call.verdict(second(1000)), Verdict::kGoOn);
  EXPECT_THAT(roll_call.missing(second(1000)), IsEmpty());
}

TEST_F(RollCalls, ListenAnewOnceTheSilentOneHasHadItsTimeSinceTheClockRuns) {
  roll_call.heard("marvin");
  start_mission();
  roll_call.runs(second(105));  // as each sample of the clock says again

  EXPECT_EQ(roll_call.verdict(second(100 + kSilence - 0.1)), Verdict::kGoOn);
  EXPECT_EQ(roll_call.verdict(second(100 + kSilence)), Verdict::kListenAnew);
  EXPECT_THAT(roll_call.missing(second(100 + kSilence)), ElementsAre("karma"));
}

TEST_F(RollCalls, GiveUpWhereListeningAnewHelpsNot) {
  roll_call.heard("marvin");
  start_mission();
  roll_call.listens_anew(second(100 + kSilence));

  EXPECT_EQ(roll_call.verdict(second(100 + 2 * kSilence - 0.1)), Verdict::kGoOn);
  EXPECT_EQ(roll_call.verdict(second(100 + 2 * kSilence)), Verdict::kGiveUp);
}

TEST_F(RollCalls, GoOnWhereItHelps) {
  roll_call.heard("marvin");
  start_mission();
  roll_call.listens_anew(second(100 + kSilence));
  roll_call.heard("karma");

  EXPECT_EQ(roll_call.verdict(second(1000)), Verdict::kGoOn);
}

TEST_F(RollCalls, GiveTheSecondOfTwoItsTimeAfterListeningAnewToo) {
  roll_call.heard("marvin");
  roll_call.heard("karma");
  start_mission();
  roll_call.started("karma", second(200));
  roll_call.listens_anew(second(195));

  EXPECT_EQ(roll_call.verdict(second(200 + kSilence)), Verdict::kGoOn);
  EXPECT_EQ(roll_call.verdict(second(200 + 2 * kSilence)), Verdict::kGiveUp);
}

TEST_F(RollCalls, ExpectNothingOfWhoWasKilledUntilItIsStartedAgain) {
  roll_call.heard("marvin");
  start_mission();
  roll_call.killed("karma");
  EXPECT_EQ(roll_call.verdict(second(1000)), Verdict::kGoOn);

  roll_call.started("karma", second(1000));
  EXPECT_EQ(roll_call.verdict(second(1000 + kSilence - 0.1)), Verdict::kGoOn);
  EXPECT_EQ(roll_call.verdict(second(1000 + kSilence)), Verdict::kListenAnew);
}

TEST_F(RollCalls, MissAtTheEndWhoTookPartFromTheStartButNotWhoHasJustComeBack) {
  roll_call.heard("marvin");
  start_mission();
  roll_call.started("marvin", second(101));

  EXPECT_THAT(roll_call.missing(second(102)), ElementsAre("karma"));
  EXPECT_THAT(roll_call.missing(second(101 + kSilence)), ElementsAre("karma", "marvin"));
}

TEST_F(RollCalls, KnowWhoWasNotHeardYet) {
  EXPECT_THAT(roll_call.unheard(), ElementsAre("karma", "marvin"));
  roll_call.heard("marvin");
  EXPECT_THAT(roll_call.unheard(), ElementsAre("karma"));
}

TEST_F(RollCalls, DisregardStrangers) {
  roll_call.heard("marvin");
  roll_call.heard("karma");
  roll_call.heard("stranger");
  start_mission();

  EXPECT_THAT(roll_call.missing(second(1000)), IsEmpty());
}

}  // namespace
}  // namespace skein::run_tool
