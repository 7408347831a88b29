// SPDX-License-Identifier: Apache-2.0
// A role whose flight gets no air, or whose partner is silent: what the end of the partner means to
// it, and that it has only a flight left. "marvin" relays for "heliv", meets it twice, and flies
// back to the ground at last.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "skein/decision_node/stand_in.hpp"
#include "testing/flown_node.hpp"
#include "testing/merged_team.hpp"
#include "testing/negotiating_partner.hpp"
#include "testing/stood_in.hpp"

namespace skein::decision_node {
namespace {

using executive::AbortCause;
using executive::TaskEvent;
using executive::TaskState;
using interaction::JointPhase;
using testing::all;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::SizeIs;

Config flying_relay() {
  Config config = testing::stood_in_config("relay");
  auto knowledge = std::make_shared<supervisor::Knowledge>(*config.knowledge);
  knowledge->vehicle = testing::quick_helicopter();
  config.knowledge = knowledge;
  return config;
}

world::Telemetry seen(const std::string& uav, const world::Vector3& place) {
  world::Telemetry telemetry = testing::flying(true);
  telemetry.uav = uav;
  telemetry.state.position = place;
  telemetry.state.energy = 1;
  return telemetry;
}

/// Heliv agrees to whatever marvin's stand-in asks for.
class FlightWithoutAir : public ::testing::Test {
 protected:
  FlightWithoutAir() {
    give(seen("marvin", {60, 0, 20}));
    PlayJointTask play{testing::watching_task()};
    play.task.arguments[1] = world::Vector3(0, 0, 50);
    give(play);
    run(3);
  }

  void give(const StandInInput& input) {
    std::deque<StandInEffects> open{stand_in_.handle(input, now_)};
    while (!open.empty()) {
      const StandInEffects effects = std::move(open.front());
      open.pop_front();
      for (const auto& one : all<SendNegotiation>(effects.said))
        for (const auto& answer : answers_to(one.message))
          open.push_back(stand_in_.handle(answer, now_));
      for (const Notice& one : all<Notice>(effects.said)) notices_.push_back(one.text);
      for (const auto& one : all<JointTaskChanged>(effects.said)) marvin_ = one.status;
      for (const mission::Request& one : effects.asked)
        if (const auto* start = std::get_if<executive::Start>(&one)) tasks_.push_back(start->task);
    }
  }

  std::vector<interaction::SessionMessage> answers_to(const interaction::SessionMessage& message) {
    const bool when = message.terms.subject.ends_with("/start");
    return (when ? start_ : roles_).answers(interaction::SessionMessageReceived{message}, now_);
  }

  void run(int seconds, bool heliv_is_heard = true) {
    for (int i = 0; i < seconds; ++i) {
      now_ = now_ + Duration::seconds(1);
      give(seen("marvin", {60, 0, 20}));
      if (heliv_is_heard) give(PartnerSeen{seen("heliv", {0, 100, 20})});
      give(Tick{});
    }
  }

  /// Of the task that the role asked for last.
  void over(TaskState state, AbortCause cause = AbortCause::kOther) {
    ASSERT_FALSE(tasks_.empty()) << ::testing::PrintToString(notices_);
    const executive::Task task = tasks_.back();
    give(TaskEvent{task.id, task.type, TaskState::kRunning, ""});
    run(2);
    give(TaskEvent{task.id, task.type, state, "it waits for karma to leave", cause});
  }

  void heliv_ends() { heliv_is(JointPhase::kEnded); }
  void heliv_is(JointPhase phase, const std::map<std::string, std::string>& holders = {}) {
    JointTaskTold told;
    told.status.uav = "heliv";
    told.status.subject = marvin_.subject;
    told.status.phase = phase;
    told.status.holders = holders;
    told.at = now_;
    give(told);
  }

  MissionTime now_ = MissionTime::seconds(10);
  std::vector<executive::Task> tasks_;  ///< that the role asked for
  std::vector<std::string> notices_;
  interaction::JointTaskStatus marvin_;  ///< as it told last

 private:
  StandIn stand_in_{flying_relay()};
  /// Heliv's, in the two sessions.
  testing::NegotiatingPartner roles_{interaction::Rows{{"watch", "", {10}}}};
  testing::NegotiatingPartner start_{interaction::Rows{{"interval", "", {0, 1000}}}};
};

// Found by random missions (--merged 59): its partner had achieved the goal, and it failed.
TEST_F(FlightWithoutAir, TheLastOneEndsTheRoleWhereItIsOnceThePartnerHasEnded) {
  for (int i = 0; i < 3; ++i) over(TaskState::kEnded);
  ASSERT_THAT(tasks_, SizeIs(4)) << "there, two meetings, back";
  heliv_ends();

  over(TaskState::kAborted, AbortCause::kNoAir);

  EXPECT_EQ(marvin_.phase, JointPhase::kEnded);
  EXPECT_THAT(notices_, Contains(HasSubstr("it stays where it is")));
}

// Found by random missions (--partners --merged 950006): while it waited for its air, contact was
// lost, and the policy of that stopped it.
TEST_F(FlightWithoutAir, WhoIsStoppedInTheLastOneHasEndedItsRoleOnceThePartnerHas) {
  for (int i = 0; i < 3; ++i) over(TaskState::kEnded);
  heliv_ends();
  give(StopPlaying{std::nullopt, "contact lost: hold"});
  EXPECT_EQ(marvin_.phase, JointPhase::kEnded);
}

TEST_F(FlightWithoutAir, WhoIsStoppedInTheLastOneHasAbortedItsRoleWhileThePartnerPlays) {
  for (int i = 0; i < 3; ++i) over(TaskState::kEnded);
  give(StopPlaying{std::nullopt, "contact lost: hold"});
  EXPECT_EQ(marvin_.phase, JointPhase::kAborted);
}

TEST_F(FlightWithoutAir, TheLastOneFailsTheRoleWhileThePartnerPlays) {
  for (int i = 0; i < 3; ++i) over(TaskState::kEnded);
  over(TaskState::kAborted, AbortCause::kNoAir);
  EXPECT_EQ(marvin_.phase, JointPhase::kAborted);
}

TEST_F(FlightWithoutAir, OneBeforeAMeetingFailsTheRoleThoughThePartnerHasEnded) {
  heliv_ends();
  over(TaskState::kAborted, AbortCause::kNoAir);
  EXPECT_EQ(marvin_.phase, JointPhase::kLeaving);
}

TEST_F(FlightWithoutAir, AFlightThatFailsOtherwiseFailsTheRoleThoughThePartnerHasEnded) {
  for (int i = 0; i < 3; ++i) over(TaskState::kEnded);
  heliv_ends();
  for (int i = 0; i < 3; ++i) over(TaskState::kAborted);
  EXPECT_EQ(marvin_.phase, JointPhase::kAborted);
}

using PartnerOutOfReach = FlightWithoutAir;

// Found by storms (agreed-places/pursuit 608): a partner had ended beyond its reach.
TEST_F(PartnerOutOfReach, IsNotNeededForTheLastFlight) {
  for (int i = 0; i < 3; ++i) over(TaskState::kEnded);
  run(100, false);
  EXPECT_EQ(marvin_.phase, JointPhase::kRunning);

  over(TaskState::kEnded);
  EXPECT_EQ(marvin_.phase, JointPhase::kEnded);
}

TEST_F(PartnerOutOfReach, IsLostBeforeTheLastFlight) {
  for (int i = 0; i < 2; ++i) over(TaskState::kEnded);
  run(100, false);
  EXPECT_EQ(marvin_.phase, JointPhase::kLeaving);
  EXPECT_THAT(marvin_.why, HasSubstr("no contact with 'heliv'"));
}

TEST_F(PartnerOutOfReach, IsNotLostOnceItHasEnded) {
  heliv_ends();
  run(100, false);
  EXPECT_EQ(marvin_.phase, JointPhase::kRunning);
}

TEST_F(PartnerOutOfReach, ThatGoesOnWithoutTheOtherIsLostToThatOne) {
  heliv_is(JointPhase::kRunning, {{"heliv", "watch"}, {"marvin", "relay"}});
  EXPECT_EQ(marvin_.phase, JointPhase::kRunning);

  heliv_is(JointPhase::kRunning, {{"heliv", "watch"}, {"karma", "relay"}});
  EXPECT_EQ(marvin_.phase, JointPhase::kLeaving);
  EXPECT_EQ(marvin_.why, "'heliv' goes on without 'marvin'");
}

}  // namespace
}  // namespace skein::decision_node
