// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/degree_change.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using mission::ChangeDegree;
using testing::at;

constexpr CommandNumber kCommand(7);

/// To this degree, from 3, until 60.
DegreeChange under_way_to(Degree degree, bool resume = false) {
  DegreeChange change;
  ChangeDegree wanted{degree};
  wanted.resume = resume;
  change.begin(kCommand, wanted, at(60));
  return change;
}

TEST(DegreeChange, IsUnderWayFromItsSendingUntilItIsSettled) {
  DegreeChange change;
  EXPECT_FALSE(change.under_way());
  EXPECT_EQ(change.expected(3), 3);
  EXPECT_EQ(change.until(), std::nullopt);

  change = under_way_to(1);

  EXPECT_TRUE(change.under_way());
  EXPECT_EQ(change.expected(3), 1);
  EXPECT_EQ(change.command(), kCommand);
  EXPECT_EQ(change.until(), at(60));
  change.settle();
  EXPECT_FALSE(change.under_way());
  EXPECT_EQ(change.command(), std::nullopt);
}

TEST(DegreeChange, WhatAPlanBoardTellsMeanwhileCountsOnceItIsSettled) {
  DegreeChange change = under_way_to(1);

  EXPECT_EQ(change.on_board(2, at(5)), std::nullopt);

  EXPECT_EQ(change.settle(), 2);
  EXPECT_EQ(change.on_board(3, at(6)), 3);
}

TEST(DegreeChange, AnOldPlanBoardTellsNothing) {
  DegreeChange change;
  EXPECT_EQ(change.on_board(2, at(5)), 2);
  EXPECT_EQ(change.on_board(3, at(5)), std::nullopt);

  change.handed_over(4, 2, at(9));

  EXPECT_EQ(change.on_board(2, at(8)), std::nullopt);
  EXPECT_EQ(change.on_board(2, at(10)), 2);
}

TEST(DegreeChange, IsSettledByARefusalOrAnExpiryOfItsOwnCommand) {
  DegreeChange change = under_way_to(1);

  EXPECT_FALSE(change.ended(CommandNumber(8), CommandState::kRefused, 3));
  EXPECT_TRUE(change.ended(kCommand, CommandState::kRefused, 3));
  EXPECT_TRUE(change.ended(kCommand, CommandState::kExpired, 3));
}

TEST(DegreeChange, ThatIsAcceptedIsSettledByTheHandOverUnlessItMakesNoDifference) {
  DegreeChange change = under_way_to(1);
  EXPECT_FALSE(change.ended(kCommand, CommandState::kAcknowledged, 3));
  EXPECT_FALSE(change.handed_over(2, 3, at(5)).wanted);
  EXPECT_TRUE(change.handed_over(1, 3, at(6)).wanted);

  DegreeChange same = under_way_to(3);
  EXPECT_TRUE(same.ended(kCommand, CommandState::kAcknowledged, 3));
}

TEST(DegreeChange, TheHandOverThatIsWantedCountsMoreThanPlanBoardsBeforeIt) {
  DegreeChange change = under_way_to(1);
  change.on_board(2, at(5));

  change.handed_over(1, 3, at(6));

  EXPECT_EQ(change.settle(), std::nullopt);
}

TEST(DegreeChange, APlanIsResumedIfTheUavWasAskedToAlsoWhenTheAnswerWasLost) {
  EXPECT_TRUE(under_way_to(4, true).handed_over(4, 3, at(5)).resumes);
  EXPECT_FALSE(under_way_to(4, false).handed_over(4, 3, at(5)).resumes);
  EXPECT_FALSE(under_way_to(3, true).handed_over(3, 2, at(5)).resumes);

  DegreeChange late = under_way_to(4, true);
  late.ended(kCommand, CommandState::kExpired, 3);
  late.settle();
  EXPECT_TRUE(late.handed_over(4, 3, at(70)).resumes);
  EXPECT_FALSE(late.handed_over(4, 3, at(71)).resumes);
}

TEST(DegreeChange, WhoHandsOverAtTheDegreeThatItHasWasNotAskedToUnlessItWasGivenThatDegree) {
  DegreeChange change;
  EXPECT_TRUE(change.handed_over(3, 3, at(5)).unasked);
  EXPECT_FALSE(change.handed_over(2, 3, at(6)).unasked);

  DegreeChange same = under_way_to(3);
  same.ended(kCommand, CommandState::kAcknowledged, 3);
  same.settle();
  EXPECT_FALSE(same.handed_over(3, 3, at(7)).unasked);
  EXPECT_TRUE(same.handed_over(3, 3, at(8)).unasked);
}

}  // namespace
}  // namespace skein::ground_station
