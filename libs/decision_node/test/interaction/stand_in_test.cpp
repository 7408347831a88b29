// SPDX-License-Identifier: Apache-2.0
// A stand-in for "marvin", whose partner is "heliv".
#include "skein/decision_node/stand_in.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/flown_node.hpp"
#include "testing/stood_in.hpp"

namespace skein::decision_node {
namespace {

using executive::TaskId;
using executive::TaskState;
using interaction::JointPhase;
using testing::all;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class StoodIn : public ::testing::Test {
 protected:
  StandInEffects give(const StandInInput& input) { return stand_in_.handle(input, now_); }
  StandInEffects play() {
    give(testing::flying(true));
    return give(PlayJointTask{testing::watching_task()});
  }

  StandIn stand_in_{testing::stood_in_config("relay")};
  MissionTime now_ = MissionTime::seconds(10);
};

TEST_F(StoodIn, ItNegotiatesInTheUavsName) {
  const auto effects = play();

  EXPECT_TRUE(stand_in_.plays(TaskId(22)));
  const auto sent = all<SendNegotiation>(effects.said);
  ASSERT_FALSE(sent.empty());
  EXPECT_EQ(sent[0].to, "heliv");
  EXPECT_EQ(sent[0].message.from, "marvin");
  EXPECT_EQ(sent[0].message.terms.subject, testing::joint().subject + "/roles");
}

TEST_F(StoodIn, ItOffersTheRolesThatTheModelAllows) {
  const auto offered = all<NegotiationNoted>(play().said);

  ASSERT_FALSE(offered.empty());
  EXPECT_EQ(offered.back().state, "offered");
  ASSERT_THAT(offered.back().rows, SizeIs(2));
  EXPECT_EQ(offered.back().rows[0].name, "watch");
  EXPECT_THAT(offered.back().rows[0].numbers, IsEmpty()) << "why it does not";
  EXPECT_EQ(offered.back().rows[1].name, "relay");
  EXPECT_THAT(offered.back().rows[1].numbers, SizeIs(1));
}

TEST_F(StoodIn, WhereTheModelAllowsNoneItSaysSo) {
  StandIn other(testing::stood_in_config(""));
  other.handle(testing::flying(true), now_);

  const auto noted =
      all<NegotiationNoted>(other.handle(PlayJointTask{testing::watching_task()}, now_).said);

  ASSERT_FALSE(noted.empty());
  bool refused = false;
  for (const NegotiationNoted& one : noted) {
    refused =
        refused || (one.state == "refused" &&
                    one.why.find("does not let the ground station play it") != std::string::npos);
  }
  EXPECT_TRUE(refused);
}

TEST_F(StoodIn, WhatMakesNoSenseIsOverAtOnce) {
  mission::HighLevelTask wrong = testing::watching_task();
  wrong.arguments.pop_back();

  const auto effects = give(PlayJointTask{wrong});

  ASSERT_FALSE(effects.changed.empty());
  EXPECT_EQ(effects.changed.back().state, TaskState::kAborted);
  EXPECT_THAT(effects.changed.back().reason, HasSubstr("uavs"));
  EXPECT_FALSE(stand_in_.plays());
}

TEST_F(StoodIn, WhoIsStoppedWhileItLoadsIsOverAndPartnersAreTold) {
  play();

  const auto effects = give(StopPlaying{std::nullopt, "'marvin' is at degree 1 now"});

  ASSERT_THAT(effects.changed, SizeIs(1));
  EXPECT_EQ(effects.changed[0].state, TaskState::kAborted);
  const auto told = all<JointTaskChanged>(effects.said);
  ASSERT_THAT(told, SizeIs(1));
  EXPECT_EQ(told[0].status.phase, JointPhase::kAborted);
  EXPECT_FALSE(stand_in_.plays());
}

TEST_F(StoodIn, WhereNothingIsPlayedNothingIsSaid) {
  EXPECT_THAT(give(testing::flying(true)).said, IsEmpty());
  EXPECT_FALSE(stand_in_.next_wakeup());
  EXPECT_THAT(give(StopPlaying{std::nullopt, "it restarted"}).changed, IsEmpty());
}

}  // namespace
}  // namespace skein::decision_node
