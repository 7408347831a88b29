// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_talks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/scouting.hpp"

namespace skein::decision_node {
namespace {

using interaction::NegotiationOutcome;
using testing::all;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using Kind = NegotiationOutcome::Kind;

/// Marvin talks to heliv, who does not answer: outcomes are told.
class ScoutsTalk : public ::testing::Test {
 protected:
  ScoutsTalk() { course_.at(1); }

  std::string subject(const std::string& modality) const {
    return course_.my.joint.subject + "/" + modality;
  }
  bool decided(const std::string& modality, Kind kind, interaction::Rows result = {}) {
    interaction::Terms terms;
    terms.subject = subject(modality);
    terms.modality = modality;
    terms.members = {"heliv", "marvin"};
    NegotiationOutcome outcome;
    outcome.kind = kind;
    outcome.result = std::move(result);
    outcome.why = kind == Kind::kAgreed ? "" : "nobody answers";
    return talks_.decided(terms, outcome);
  }
  /// To heliv since the time was set.
  std::size_t said() { return all<SendNegotiation>(course_.host.bus().end()).size(); }
  /// Half of the field to each.
  static interaction::Rows halves() {
    return {
        interaction::row_of("heliv", world::Polygon{{0, 0}, {100, 0}, {100, 200}, {0, 200}}),
        interaction::row_of("marvin", world::Polygon{{100, 0}, {200, 0}, {200, 200}, {100, 200}})};
  }

  testing::ScoutingCourse course_;
  AreaShare share_{"marvin"};
  RoleRecord record_;
  RoleTalks talks_{course_.surroundings(), {course_, share_, record_}};
};

TEST_F(ScoutsTalk, WhatNobodyNegotiatesIsAborted) {
  talks_.negotiate("haggle");

  EXPECT_THAT(course_.told, ElementsAre("haggle aborted"));
  EXPECT_EQ(said(), 0U);
}

TEST_F(ScoutsTalk, AnAreaThatNobodySharesIsTakenWhole) {
  talks_.negotiate("keep");

  EXPECT_THAT(course_.told, ElementsAre("keep ended"));
  EXPECT_NEAR(share_.area_left(), 200 * 200, 1);
  EXPECT_EQ(said(), 0U);
}

TEST_F(ScoutsTalk, AnAreaIsSharedWithWhoHoldsTheRole) {
  talks_.negotiate("divide");
  EXPECT_GT(said(), 0U);
  EXPECT_THAT(course_.told, IsEmpty());

  EXPECT_FALSE(decided(kAreaSharing, Kind::kAgreed, halves()));

  EXPECT_THAT(course_.told, ElementsAre("divide ended"));
  EXPECT_NEAR(share_.area_left(), 100 * 200, 1);
  EXPECT_EQ(talks_.next_wakeup(), std::nullopt);
}

// A division that nobody had heard of yet when it left.
TEST_F(ScoutsTalk, ThePartOfWhoHasLeftMeanwhileIsNobodys) {
  talks_.negotiate("divide");
  course_.my.holders.erase("heliv");

  EXPECT_FALSE(decided(kAreaSharing, Kind::kAgreed, halves()));

  EXPECT_THAT(course_.told, ElementsAre("divide ended", "member lost"));
  ASSERT_THAT(share_.nobodys(), SizeIs(1));
  EXPECT_NEAR(world::area(share_.nobodys().front()), 100 * 200, 1);
}

TEST_F(ScoutsTalk, AnAreaThatIsNotSharedIsAskedForAgainAfterASecond) {
  talks_.negotiate("divide");
  course_.interaction.withdraw(subject(kAreaSharing), "test");
  (void)decided(kAreaSharing, Kind::kFailed);

  EXPECT_EQ(talks_.next_wakeup(), MissionTime::seconds(2));
  course_.at(1.9);
  talks_.time_passes();
  EXPECT_EQ(said(), 0U);
  course_.at(2);
  talks_.time_passes();
  EXPECT_GT(said(), 0U);
  EXPECT_THAT(course_.told, IsEmpty());
}

TEST_F(ScoutsTalk, AnActionWithALongNameIsAskedForAgainByThatName) {
  talks_.negotiate("divide-the-whole-field");
  course_.interaction.withdraw(subject(kAreaSharing), "test");
  (void)decided(kAreaSharing, Kind::kFailed);
  course_.at(2);
  talks_.time_passes();
  (void)decided(kAreaSharing, Kind::kAgreed, halves());
  EXPECT_THAT(course_.told, ElementsAre("divide-the-whole-field ended"));
}

TEST_F(ScoutsTalk, AnActionThatIsWithdrawnIsNotAskedForAgain) {
  talks_.negotiate("divide");
  (void)decided(kAreaSharing, Kind::kFailed);

  talks_.withdraw("divide");

  EXPECT_THAT(course_.told, ElementsAre("divide aborted"));
  EXPECT_EQ(talks_.next_wakeup(), std::nullopt);
  (void)decided(kAreaSharing, Kind::kAgreed, halves());
  EXPECT_THAT(course_.told, SizeIs(1)) << "nobody waits for it any more";
  EXPECT_TRUE(share_.agreed()) << "who has what is known all the same";
}

TEST_F(ScoutsTalk, RolesThatAreOthersNowAreSaid) {
  talks_.negotiate("swap");

  EXPECT_TRUE(decided("role-allocation", Kind::kAgreed, {{"heliv", "spare", {}}}));

  EXPECT_EQ(course_.my.holders.at("heliv"), "spare");
  EXPECT_EQ(course_.my.holders.at("marvin"), "scout");
  EXPECT_THAT(course_.told, IsEmpty()) << "the role that asked is over";
}

TEST_F(ScoutsTalk, RolesThatWereConfirmedStandForTwentySeconds) {
  talks_.negotiate("swap");
  EXPECT_FALSE(
      decided("role-allocation", Kind::kAgreed, {{"heliv", "scout", {}}, {"marvin", "scout", {}}}));
  EXPECT_THAT(course_.told, ElementsAre("swap ended"));
  course_.interaction.withdraw(subject("role-allocation"), "test");

  course_.at(20.9);
  talks_.negotiate("swap");
  EXPECT_THAT(course_.told, ElementsAre("swap ended", "swap ended"));
  EXPECT_EQ(said(), 0U);

  course_.at(21);
  talks_.negotiate("swap");
  EXPECT_THAT(course_.told, SizeIs(2));
  EXPECT_GT(said(), 0U);
}

TEST_F(ScoutsTalk, RolesDoNotStandOnceSomebodyIsLost) {
  talks_.negotiate("swap");
  (void)decided("role-allocation", Kind::kAgreed);
  course_.interaction.withdraw(subject("role-allocation"), "test");

  talks_.lose();
  course_.at(5);
  talks_.negotiate("swap");

  EXPECT_GT(said(), 0U);
}

// Found by random missions (--sharing 70): the session with who is lost lasted until nobody had any
// patience left.
TEST_F(ScoutsTalk, WhatIsBeingSharedIsSharedAmongThoseWhoAreLeftOnceSomebodyIsLost) {
  course_.my.holders["karma"] = "scout";
  talks_.negotiate("divide");
  course_.at(230);
  course_.my.holders.erase("heliv");
  talks_.lose();
  (void)decided(kAreaSharing, Kind::kFailed);

  ASSERT_EQ(talks_.next_wakeup(), MissionTime::seconds(231));
  course_.at(245);
  talks_.time_passes();

  const auto said = all<SendNegotiation>(course_.host.bus().end());
  ASSERT_THAT(said, Not(IsEmpty()));
  EXPECT_THAT(said.back().message.terms.members, ElementsAre("karma", "marvin"));
  EXPECT_THAT(course_.told, IsEmpty()) << "it has all the patience that it had at first";
}

// Found by random missions (--escorts --deaths): of those who had promised nobody was left who knew
// whether all had, and the role waited for that to its end.
TEST_F(ScoutsTalk, WhatIsUndecidedIsBegunAnewOnceSomebodyIsLost) {
  course_.my.holders["karma"] = "scout";
  talks_.negotiate("swap");
  (void)said();
  course_.at(20);
  EXPECT_FALSE(decided("role-allocation", Kind::kUndecided));
  EXPECT_THAT(course_.told, IsEmpty()) << "it may be settled yet";
  course_.interaction.withdraw(subject("role-allocation"), "test");
  (void)said();
  course_.at(30);
  course_.my.holders.erase("heliv");

  talks_.lose();

  EXPECT_GT(said(), 0U);
}

// Found by area-sharing/one-back: it took all that two had left, and they were back 20 s later.
TEST_F(ScoutsTalk, WhoIsLeftAloneWaitsUntilTheSessionIsOver) {
  talks_.negotiate("divide");
  course_.at(30);
  course_.my.holders.erase("heliv");

  talks_.lose();

  EXPECT_EQ(talks_.next_wakeup(), std::nullopt);
  EXPECT_THAT(course_.told, IsEmpty());
}

TEST_F(ScoutsTalk, RolesThatAreNotAgreedOnAbortTheAction) {
  talks_.negotiate("swap");

  EXPECT_FALSE(decided("role-allocation", Kind::kFailed));

  EXPECT_THAT(course_.told, ElementsAre("swap aborted"));
}

TEST_F(ScoutsTalk, AnotherRoleKnowsNothingOfWhatWasUnderWay) {
  talks_.negotiate("divide");
  (void)decided(kAreaSharing, Kind::kFailed);

  talks_.begin_anew();

  EXPECT_EQ(talks_.next_wakeup(), std::nullopt);
  (void)decided(kAreaSharing, Kind::kAgreed, halves());
  EXPECT_THAT(course_.told, IsEmpty());
}

}  // namespace
}  // namespace skein::decision_node
