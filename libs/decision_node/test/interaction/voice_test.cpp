// SPDX-License-Identifier: Apache-2.0
// What the ground station says in the name of a UAV whose role it plays: "marvin", with "heliv".
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/flown_node.hpp"

namespace skein::decision_node {
namespace {

using interaction::JointPhase;
using testing::all;
using ::testing::ElementsAre;
using testing::FlownNode;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kJoint = "lift of heliv, marvin";

interaction::SessionMessage said_by(const std::string& uav) {
  interaction::SessionMessage message;
  message.from = uav;
  message.terms.subject = std::string(kJoint) + "/roles";
  message.terms.modality = "role-allocation";
  message.terms.members = {"heliv", "marvin"};
  message.terms.opener = uav;
  message.terms.deadline = MissionTime::seconds(30);
  return message;
}

interaction::JointTaskStatus stands(JointPhase phase, const std::string& uav = "marvin") {
  interaction::JointTaskStatus status;
  status.uav = uav;
  status.subject = kJoint;
  status.task = 22;
  status.phase = phase;
  status.holders = {{"heliv", "hook"}, {"marvin", "guide"}};
  return status;
}

class Voiced : public ::testing::Test {
 protected:
  void play(JointPhase phase = JointPhase::kRunning) { node_.give(GroundPlays{stands(phase)}); }

  FlownNode node_{2, ContactPolicy::kReturn};
};

TEST_F(Voiced, WhatTheGroundSaysInItsNameGoesToThePartner) {
  const auto effects = node_.give(GroundNegotiates{"heliv", said_by("marvin")});

  ASSERT_THAT(all<SendNegotiation>(effects), SizeIs(1));
  EXPECT_EQ(all<SendNegotiation>(effects)[0].to, "heliv");
}

TEST_F(Voiced, TheGroundSpeaksInNoOthersNameAndToNobodyElse) {
  EXPECT_THAT(all<SendNegotiation>(node_.give(GroundNegotiates{"heliv", said_by("karma")})),
              IsEmpty());
  EXPECT_THAT(all<SendNegotiation>(node_.give(GroundNegotiates{"karma", said_by("marvin")})),
              IsEmpty());
  EXPECT_THAT(all<SpokenFor>(node_.give(GroundPlays{stands(JointPhase::kRunning, "heliv")})),
              IsEmpty());
}

TEST_F(Voiced, WhatPartnersSayOfWhatIsPlayedGoesToTheGround) {
  play();

  EXPECT_THAT(all<NegotiationPassedOn>(node_.give(said_by("heliv"))), SizeIs(1));
  EXPECT_THAT(all<PartnerPassedOn>(
                  node_.give(JointTaskTold{stands(JointPhase::kRunning, "heliv"), node_.now()})),
              SizeIs(1));
  world::Telemetry heliv;
  heliv.uav = "heliv";
  const auto passed = all<TelemetryPassedOn>(node_.give(PartnerSeen{heliv}));
  ASSERT_THAT(passed, SizeIs(1));
  EXPECT_EQ(passed[0].telemetry.uav, "heliv");
}

TEST_F(Voiced, ASessionOfTheGroundsIsPassedOnBeforeTheJointTaskIsHeardOf) {
  node_.give(GroundNegotiates{"heliv", said_by("marvin")});

  EXPECT_THAT(all<NegotiationPassedOn>(node_.give(said_by("heliv"))), SizeIs(1));
}

TEST_F(Voiced, WhereNothingIsPlayedTheNodeAnswersItself) {
  EXPECT_THAT(all<NegotiationPassedOn>(node_.give(said_by("heliv"))), IsEmpty());
  play();
  play(JointPhase::kEnded);
  EXPECT_THAT(all<NegotiationPassedOn>(node_.give(said_by("heliv"))), IsEmpty());
}

TEST_F(Voiced, PartnersAreToldWhereItIs) {
  EXPECT_THAT(all<ShareTelemetry>(node_.give(testing::flying(true))), IsEmpty());
  play();

  const auto shared = all<ShareTelemetry>(node_.give(testing::flying(true)));

  ASSERT_THAT(shared, SizeIs(1));
  EXPECT_EQ(shared[0].partner, "heliv");
}

TEST_F(Voiced, AfterAMinuteWithoutTheGroundItLeavesInTheGroundsPlace) {
  play();
  node_.give(Contact{"ground", true, false});
  EXPECT_THAT(all<SpokenFor>(node_.wake_at(20)), IsEmpty());

  // Its contact-loss policy comes after 30 s, and is told as the reason.
  const auto left = all<SpokenFor>(node_.wake_at(31));

  ASSERT_THAT(left, SizeIs(1));
  EXPECT_EQ(left[0].status.phase, JointPhase::kAborted);
  EXPECT_TRUE(left[0].to_partners && left[0].to_ground);
  EXPECT_THAT(left[0].status.why, HasSubstr("contact-loss policy"));
}

// Found by random missions (--escorts): "who has it in hand decides", who had nothing to decide.
TEST_F(Voiced, WhileItsRoleWaitsItSaysThatItIsNoOperatorsTurn) {
  FlownNode node(2);
  node.give(GroundPlays{stands(JointPhase::kRunning)});
  node.give(testing::flying(true));
  node.wake_at(62);

  const auto told = all<Notice>(node.give(testing::flying(true)));

  ASSERT_THAT(told, SizeIs(1));
  EXPECT_THAT(told[0].text, HasSubstr("the ground station plays a role of it, which waits"));
}

TEST_F(Voiced, WithoutAPolicyItLeavesAfterAMinute) {
  FlownNode node(2);
  node.give(GroundPlays{stands(JointPhase::kRunning)});
  node.give(Contact{"ground", true, false});
  EXPECT_THAT(all<SpokenFor>(node.wake_at(59)), IsEmpty());

  EXPECT_THAT(all<SpokenFor>(node.wake_at(60)), SizeIs(1));
}

TEST_F(Voiced, WhatItHasLeftStaysLeftUntilTheGroundSaysSoToo) {
  play();
  node_.give(Contact{"ground", true, false});
  node_.wake_at(31);
  node_.give(Contact{"ground", true, true});

  const auto again = all<SpokenFor>(node_.give(GroundPlays{stands(JointPhase::kRunning)}));

  ASSERT_THAT(again, SizeIs(1));
  EXPECT_EQ(again[0].status.phase, JointPhase::kAborted);
  EXPECT_TRUE(again[0].to_ground && !again[0].to_partners);
  EXPECT_THAT(all<SpokenFor>(node_.give(GroundPlays{stands(JointPhase::kAborted)})), IsEmpty());
  EXPECT_THAT(all<SpokenFor>(node_.give(GroundPlays{stands(JointPhase::kLoading)})), SizeIs(1));
}

// ---- tasks of the role ----

class WithATaskOfTheRole : public ::testing::Test {
 protected:
  WithATaskOfTheRole() {
    node_.give(testing::flying(true));
    EXPECT_TRUE(node_.answer_to(testing::start_of(400'000'001, "wait")).accepted);
    node_.give(GroundPlays{stands(JointPhase::kRunning)});
  }
  static std::vector<executive::TaskState> states(const Effects& effects) {
    std::vector<executive::TaskState> states;
    for (const TaskChanged& one : all<TaskChanged>(effects)) states.push_back(one.event.state);
    return states;
  }

  FlownNode node_{2};
};

TEST_F(WithATaskOfTheRole, ItGoesOnWhileTheGroundPlays) {
  EXPECT_THAT(states(node_.give(GroundPlays{stands(JointPhase::kRunning)})), IsEmpty());
  EXPECT_THAT(states(node_.wake_at(100)), IsEmpty());
}

TEST_F(WithATaskOfTheRole, ItIsAbortedWhenTheNodeLeavesInTheGroundsPlace) {
  node_.give(Contact{"ground", true, false});

  EXPECT_THAT(states(node_.wake_at(60)), ElementsAre(executive::TaskState::kAborting));
}

// Restarted, it knows of no role, and begins to negotiate anew.
TEST_F(WithATaskOfTheRole, ItIsAbortedWhenTheGroundStationForgotIt) {
  EXPECT_THAT(states(node_.give(GroundPlays{stands(JointPhase::kLoading)})),
              ElementsAre(executive::TaskState::kAborting));
}

}  // namespace
}  // namespace skein::decision_node
