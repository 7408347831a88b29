// SPDX-License-Identifier: Apache-2.0
// Marvin scouts alone, since heliv left; heliv asks for it again.
#include "interaction/newcomers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/scouting.hpp"

namespace skein::decision_node {
namespace {

using interaction::NegotiationOutcome;
using testing::all;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::SizeIs;

class ScoutingAlone : public ::testing::Test {
 protected:
  ScoutingAlone() {
    course_.my.holders = {{"marvin", "scout"}};
    course_.at(100);
    play_.begin("scout");
    (void)course_.host.bus().end();
    course_.at(100);
  }

  interaction::Terms asked_for(const std::string& what,
                               std::vector<std::string> members = {"heliv", "marvin"}) const {
    interaction::Terms terms;
    terms.subject = course_.my.joint.subject + "/" + what;
    terms.modality = what == "roles" ? "role-allocation" : "time-interval";
    terms.members = std::move(members);
    terms.opener = "heliv";
    terms.opened = MissionTime::seconds(99);
    return terms;
  }
  void agreed(const interaction::Terms& terms, interaction::Rows result) {
    NegotiationOutcome outcome;
    outcome.kind = NegotiationOutcome::Kind::kAgreed;
    outcome.result = std::move(result);
    newcomers_.decided(terms, outcome);
  }
  void agreed_on_roles() {
    agreed(asked_for("roles"), {{"heliv", "scout", {3}}, {"marvin", "scout", {0}}});
  }
  std::vector<std::string> invitations() {
    std::vector<std::string> members;
    for (const auto& one : all<SendNegotiation>(course_.host.bus().end()))
      members.push_back(one.message.terms.subject);
    course_.at(100);
    return members;
  }

  testing::ScoutingCourse course_;
  JointPlay play_{course_.surroundings()};
  Companions companions_{course_.host.partners(), course_.my, "marvin"};
  const Joint asked_ = course_.my.joint;
  Newcomers newcomers_{course_.surroundings(), asked_, play_, companions_};
};

TEST_F(ScoutingAlone, WhoHoldsNoRoleComesByRolesAndStart) {
  EXPECT_TRUE(newcomers_.come_by(asked_for("roles")));
  EXPECT_TRUE(newcomers_.come_by(asked_for("start")));
  EXPECT_FALSE(newcomers_.come_by(asked_for("area-sharing")));

  course_.my.phase = interaction::JointPhase::kLoading;
  EXPECT_FALSE(newcomers_.come_by(asked_for("roles"))) << "all are alike then";
  course_.my.phase = interaction::JointPhase::kRunning;
  course_.my.holders["heliv"] = "scout";
  EXPECT_FALSE(newcomers_.come_by(asked_for("start"))) << "it only wants another start";
}

TEST_F(ScoutingAlone, WhoPlaysTakesPartInWhatANewcomerAsks) {
  newcomers_.invited(asked_for("roles"));

  EXPECT_THAT(invitations(), ::testing::Contains(course_.my.joint.subject + "/roles"));
}

TEST_F(ScoutingAlone, WhoDoesNotCallAllWhoPlayIsNotAnswered) {
  course_.my.holders["karma"] = "scout";

  newcomers_.invited(asked_for("roles"));

  EXPECT_THAT(invitations(), IsEmpty());
}

TEST_F(ScoutingAlone, WhoPlaysKeepsItsRoleAndBeginsAtOnce) {
  const auto roles = newcomers_.offer_for(asked_for("roles"));
  ASSERT_TRUE(roles) << roles.error().why;
  EXPECT_THAT(*roles, ElementsAre(interaction::Row{"scout", "", {0}}));
  agreed_on_roles();

  const auto start = newcomers_.offer_for(asked_for("start"));

  ASSERT_TRUE(start) << start.error().why;
  ASSERT_THAT(*start, SizeIs(1));
  EXPECT_EQ(start->front().numbers.front(), 100);
  EXPECT_NEAR(start->front().numbers.back(), 160, 1);
}

TEST_F(ScoutingAlone, NobodyIsTakenInWhereTheRoleSharesNothingAnyMore) {
  play_.begin("spare");

  const auto offer = newcomers_.offer_for(asked_for("roles"));

  ASSERT_FALSE(offer);
  EXPECT_EQ(offer.error().why, "it is at it, and takes nobody in any more");
}

TEST_F(ScoutingAlone, SomebodyIsTakenInWherePlacesAreAgreedOnAnew) {
  course_.my.holders = {{"marvin", "post"}};
  play_.begin("post");

  const auto offer = newcomers_.offer_for(asked_for("roles"));

  ASSERT_TRUE(offer) << offer.error().why;
  EXPECT_THAT(*offer, ElementsAre(interaction::Row{"post", "", {0}}));
}

// As who looks, while others form a chain of relays.
TEST_F(ScoutingAlone, WhoseRoleHearsNoCallLeavesItToThoseWhoHearOne) {
  course_.my.holders = {{"karma", "post"}, {"marvin", "spare"}};
  play_.begin("spare");
  const auto roles = asked_for("roles", {"heliv", "karma", "marvin"});

  const auto offer = newcomers_.offer_for(roles);

  ASSERT_TRUE(offer) << offer.error().why;
  EXPECT_THAT(*offer, ElementsAre(interaction::Row{"spare", "", {0}}));
  course_.my.holders = {{"marvin", "spare"}};
  EXPECT_FALSE(newcomers_.offer_for(roles)) << "nobody hears one";
}

TEST_F(ScoutingAlone, AStartIsForWhoHasARole) {
  const auto offer = newcomers_.offer_for(asked_for("start"));

  ASSERT_FALSE(offer);
  EXPECT_EQ(offer.error().why, "'heliv' has no role");
}

TEST_F(ScoutingAlone, WhoHasARoleIsAwaitedForAMinuteAndHoldsItFromItsStartOn) {
  agreed_on_roles();
  EXPECT_THAT(newcomers_.awaited(), ElementsAre(Pair("heliv", "scout")));
  EXPECT_THAT(course_.my.holders, SizeIs(1));

  agreed(asked_for("start"), {{"interval", "", {101, 102}}});

  EXPECT_THAT(newcomers_.awaited(), IsEmpty());
  EXPECT_THAT(course_.my.holders, ElementsAre(Pair("heliv", "scout"), Pair("marvin", "scout")));
  EXPECT_EQ(course_.my.allocation, to_text(asked_for("roles").id()));
  EXPECT_TRUE(companions_.counts_on("heliv"));
  EXPECT_TRUE(newcomers_.is_from_before("heliv", MissionTime::seconds(100)));
  EXPECT_FALSE(newcomers_.is_from_before("heliv", MissionTime::seconds(100.1)));
  EXPECT_FALSE(newcomers_.is_from_before("marvin", MissionTime::seconds(50)));
}

TEST_F(ScoutingAlone, WhoDoesNotComeIsNotAwaitedForEver) {
  agreed_on_roles();

  course_.at(159.9);
  EXPECT_THAT(newcomers_.awaited(), SizeIs(1));
  course_.at(160);
  EXPECT_THAT(newcomers_.awaited(), IsEmpty());
}

TEST_F(ScoutingAlone, WhatIsNotAgreedTakesNobodyIn) {
  NegotiationOutcome failed;
  failed.why = "nobody answers";
  newcomers_.decided(asked_for("roles"), failed);
  EXPECT_THAT(newcomers_.awaited(), IsEmpty());
  agreed_on_roles();

  newcomers_.decided(asked_for("start"), failed);

  EXPECT_THAT(newcomers_.awaited(), SizeIs(1));
  EXPECT_THAT(course_.my.holders, SizeIs(1));
}

// On a bad radio the newcomer knows that the start is agreed on some seconds before the others do.
TEST_F(ScoutingAlone, WhoCallsBeforeItIsTakenInIsHeardThen) {
  interaction::Terms call = asked_for("area-sharing");
  call.modality = kAreaSharing;
  EXPECT_FALSE(newcomers_.called(call));
  agreed_on_roles();
  EXPECT_TRUE(newcomers_.called(call));
  (void)course_.host.bus().end();
  course_.at(101);

  agreed(asked_for("start"), {{"interval", "", {101, 102}}});

  EXPECT_THAT(course_.host.bus().end(), ::testing::Not(IsEmpty()));
  EXPECT_FALSE(newcomers_.called(call)) << "it is like everybody else's now";
}

}  // namespace
}  // namespace skein::decision_node
