// SPDX-License-Identifier: Apache-2.0
// A goal that fails before its joint task was loaded is told to those who would wait for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/scouting.hpp"

namespace skein::decision_node {
namespace {

using interaction::JointPhase;
using testing::all;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class GivenUp : public ::testing::Test {
 protected:
  GivenUp() { course_.at(10); }

  static mission::HighLevelTask scouting() {
    mission::HighLevelTask goal;
    goal.id = mission::GoalId(70);
    goal.name = "scouting";
    goal.arguments = {std::string("car"), std::string("field"),
                      std::vector<std::string>{"marvin", "heliv"}};
    return goal;
  }
  void give_up(const mission::HighLevelTask& goal) {
    course_.interaction.given_up(goal, "needs 39.7 % of the energy");
  }
  /// Since the last instant.
  std::vector<JointTaskChanged> told() { return all<JointTaskChanged>(course_.host.bus().end()); }
  /// From heliv, about this joint task, or another one of the same model.
  interaction::SessionMessage invitation(const std::string& subject, double opened) const {
    interaction::SessionMessage message;
    message.from = message.terms.opener = "heliv";
    message.terms.subject = subject + "/roles";
    message.terms.mission = 1;
    message.terms.modality = "role-allocation";
    message.terms.members = {"heliv", "marvin"};
    message.terms.model = course_.my.joint.hash;
    message.terms.opened = MissionTime::seconds(opened);
    message.terms.deadline = MissionTime::seconds(opened + 30);
    for (const char* uav : {"heliv", "marvin"}) {
      message.entries.emplace_back();
      message.entries.back().uav = uav;
    }
    return message;
  }

  testing::ScoutingCourse course_;
};

TEST_F(GivenUp, ItsPartnersAreToldWhy) {
  give_up(scouting());

  const auto said = told();
  ASSERT_THAT(said, SizeIs(1));
  EXPECT_EQ(said[0].status.subject, course_.my.joint.subject);
  EXPECT_EQ(said[0].status.phase, JointPhase::kNotLoaded);
  EXPECT_EQ(said[0].status.why, "needs 39.7 % of the energy");
  EXPECT_THAT(said[0].partners, ElementsAre("heliv"));
}

TEST_F(GivenUp, WhatIsNoJointTaskOrNotOfThisUavIsNotTold) {
  mission::HighLevelTask landing = scouting(), others = scouting(), short_of = scouting();
  landing.name = "general-land";
  others.arguments.back() = std::vector<std::string>{"heliv", "karma"};
  short_of.arguments.clear();
  for (const auto& goal : {landing, others, short_of}) give_up(goal);

  EXPECT_THAT(told(), IsEmpty());
}

TEST_F(GivenUp, WhoAsksForItLaterIsToldOnceMore) {
  give_up(scouting());
  (void)told();
  course_.at(60);
  course_.interaction.hear(invitation(course_.my.joint.subject, 60));
  EXPECT_THAT(told(), SizeIs(1));

  course_.at(61);
  course_.interaction.hear(invitation("scouting(car forest) of heliv, marvin", 61));
  EXPECT_THAT(told(), IsEmpty()) << "that may be asked of it yet";
}

TEST_F(GivenUp, WhatIsAskedForAgainIsNotGivenUpAnyMore) {
  give_up(scouting());
  supervisor::LoadJointTask asked;
  asked.task = as_planned(scouting(), *course_.host.config().interaction);
  asked.preferences = {{Duration(), Duration::seconds(1000)}};
  course_.interaction.load(asked);
  (void)told();
  course_.at(60);

  course_.interaction.hear(invitation(course_.my.joint.subject, 60));

  for (const JointTaskChanged& one : told()) EXPECT_EQ(one.status.phase, JointPhase::kLoading);
}

}  // namespace
}  // namespace skein::decision_node
