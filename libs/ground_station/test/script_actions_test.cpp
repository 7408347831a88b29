// SPDX-License-Identifier: Apache-2.0
// What the actions of a script ask for, in whose name, and until when.
#include "script_actions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using ::testing::ElementsAre;
using testing::flat_terrain;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class Actions : public ::testing::Test {
 protected:
  /// All that these ask for, with the alarm if there is one.
  std::vector<MissionPlanning::Effect> effects_of(const std::vector<Action>& actions) {
    std::vector<MissionPlanning::Effect> effects;
    ScriptActions done(
        {"step one", MissionTime::seconds(60), alarm ? &*alarm : nullptr, flat_terrain()}, effects);
    for (const Action& action : actions) done.perform(action);
    finished = done.finished();
    return effects;
  }
  template <class Effect>
  Effect only(const Action& action) {
    const auto effects = effects_of({action});
    EXPECT_THAT(effects, SizeIs(1));
    return std::get<Effect>(effects.front());
  }
  static SendPlan look_at_the_alarm() {
    SendPlan plan{"heliv", {}};
    PlannedTask look;
    look.task.id = executive::TaskId(7);
    look.targets = {{TheAlarm{}, "target"}};
    plan.tasks.push_back(look);
    return plan;
  }

  std::optional<Alarm> alarm;
  bool finished = false;
};

TEST_F(Actions, AreCommandsInTheNameOfTheStepUntilTheyExpire) {
  const auto command = only<IssueCommand>(SendMessage{"heliv", "go on"});
  EXPECT_EQ(command.uav, "heliv");
  EXPECT_EQ(command.asked_by, "step one");
  EXPECT_EQ(command.expires, MissionTime::seconds(60));
  EXPECT_EQ(std::get<executive::ProcessMessage>(command.request).message, "go on");
}

TEST_F(Actions, ATaskIsSentToTheAlarmThatThereIs) {
  alarm.emplace();
  alarm->position = {10, 20, 0};
  const auto command = only<IssueCommand>(look_at_the_alarm());
  const auto& start = std::get<executive::Start>(command.request);
  ASSERT_NE(start.task.parameters.find("target"), nullptr);
  EXPECT_EQ(start.task.parameters.find("target")->numbers.front(), 10);
}

TEST_F(Actions, ATaskWithoutItsTargetIsNotSent) {
  const auto anomaly = only<Anomaly>(look_at_the_alarm());
  EXPECT_THAT(anomaly.why, HasSubstr("task 7 of heliv is not sent"));
}

TEST_F(Actions, AMissionWithoutItsTargetIsNotSent) {
  SendMission send{"heliv", {}, {{0, 0, TheAlarm{}}}};
  send.mission.tasks.emplace_back();
  send.mission.tasks.back().arguments.emplace_back(std::string("somewhere"));
  EXPECT_THAT(only<Anomaly>(send).why, HasSubstr("is not sent"));

  alarm.emplace();
  alarm->position = {10, 20, 0};
  const auto command = only<IssueCommand>(send);
  const auto& mission = std::get<mission::UnitMission>(command.request);
  EXPECT_EQ(mission.asked_by, "step one");
  EXPECT_EQ(std::get<world::Vector3>(mission.tasks[0].arguments[0]).x(), 10);
}

TEST_F(Actions, TasksAreAbortedInTheirOrderOrAllThatThereAre) {
  const auto two =
      effects_of({AbortTasks{"heliv", std::vector{executive::TaskId(3), executive::TaskId(2)}}});
  ASSERT_THAT(two, SizeIs(2));
  EXPECT_EQ(std::get<executive::Abort>(std::get<IssueCommand>(two[0]).request).id,
            executive::TaskId(3));
  EXPECT_EQ(only<AbortEverything>(AbortTasks{"heliv", std::nullopt}).uav, "heliv");
}

TEST_F(Actions, AirIsClosedForThoseNamedOrForAll) {
  CloseAir close;
  close.volume.name = "smoke";
  const auto all = only<IssueToAll>(close);
  EXPECT_EQ(std::get<mission::ChangeWorld>(all.request).volume.name, "smoke");
  close.uavs = {"heliv", "marvin"};
  EXPECT_THAT(effects_of({close}), SizeIs(2));
}

TEST_F(Actions, TheMissionIsFinishedWhenOneSaysSo) {
  effects_of({DropPlan{"heliv"}});
  EXPECT_FALSE(finished);
  const auto effects = effects_of({DropPlan{"heliv"}, Finish{}});
  EXPECT_TRUE(finished);
  EXPECT_TRUE(std::holds_alternative<MissionFinished>(effects.back()));
}

}  // namespace
}  // namespace skein::ground_station
