// SPDX-License-Identifier: Apache-2.0
// A wait that the vehicle was stopped in goes on at its executive; numbers of own flights are used
// once.
#include "merging/left_wait.hpp"

#include <gtest/gtest.h>

#include "merging/own_flight_ids.hpp"

namespace skein::decision_node {
namespace {

constexpr functional::TaskId kWait{7}, kOther{8};

TEST(ALeftWait, IsTheOneThatWasLeftLast) {
  LeftWait wait;
  EXPECT_FALSE(wait.is(kWait));
  wait.leave(kWait);
  EXPECT_TRUE(wait.is(kWait));
  wait.leave(kOther);
  EXPECT_FALSE(wait.is(kWait));
  EXPECT_TRUE(wait.is(kOther));
}

TEST(ALeftWait, HidesItsEndOnTheVehicleAndNothingElse) {
  LeftWait wait;
  wait.leave(kWait);
  EXPECT_TRUE(wait.hides({kWait, functional::TaskState::kAborted, ""}));
  EXPECT_FALSE(wait.hides({kWait, functional::TaskState::kRunning, ""}));
  EXPECT_FALSE(wait.hides({kOther, functional::TaskState::kAborted, ""}));
}

TEST(ALeftWait, IsOverOnceItsExecutiveDropsIt) {
  LeftWait wait;
  wait.leave(kWait);
  EXPECT_FALSE(wait.drop(kOther));
  EXPECT_TRUE(wait.drop(kWait));
  EXPECT_FALSE(wait.drop(kWait));
  EXPECT_FALSE(wait.hides({kWait, functional::TaskState::kAborted, ""}));
}

TEST(OwnFlights, HaveNumbersThatAreUsedOnce) {
  OwnFlightIds ids;
  EXPECT_EQ(ids.next(), functional::kFirstAsideId);
  EXPECT_EQ(ids.next(), functional::kFirstAsideId) << "it is not used yet";
  EXPECT_EQ(ids.take(), functional::kFirstAsideId);
  EXPECT_EQ(ids.take().value(), functional::kFirstAsideId.value() + 1);
}

TEST(OwnFlights, OfALaterLifeHaveOtherNumbers) {
  OwnFlightIds ids;
  for (int i = 0; i < 1'000; ++i) ids.take();  // no more than one each millisecond
  const functional::TaskId before = ids.take();
  ids.begin_anew(MissionTime::seconds(2));
  EXPECT_GT(ids.next(), before);
  EXPECT_TRUE(OwnFlightIds::has(ids.next()));
  EXPECT_FALSE(OwnFlightIds::has(functional::kFirstBackgroundId));
  EXPECT_FALSE(OwnFlightIds::has(kWait));
}

}  // namespace
}  // namespace skein::decision_node
