// SPDX-License-Identifier: Apache-2.0
#include "retold.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace skein::replay_tool {
namespace {

using journal::Record;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Record line(double at, const std::string& node, const std::string& kind) {
  return {MissionTime::seconds(at), node, kind};
}

Record task(double at, int id, const char* state) {
  return line(at, "marvin", "task")
      .with("uav", "marvin")
      .with("task", id)
      .with("type", "goto")
      .with("state", state);
}

/// The last sample of a type.
template <class T>
T last(const std::vector<wire::Sample>& samples) {
  T found;
  for (const wire::Sample& sample : samples)
    if (const auto* one = std::get_if<T>(&sample)) found = *one;
  return found;
}

class ARetoldRun : public ::testing::Test {
 protected:
  std::vector<wire::Sample> see(const Record& record) { return retold.see(record); }
  Retold retold{{"karma", "marvin"}};
};

TEST_F(ARetoldRun, TellsWhereObjectsWereSeen) {
  const std::vector<double> at = {120, 80, 5};
  see(line(3, "ground", "seen").with("name", "fire").with("type", "fire"));
  const auto news = see(line(9, "ground", "seen")
                            .with("name", "car")
                            .with("type", "vehicle")
                            .with("position", at)
                            .with("spread", 4.0)
                            .with("when", 8.5));

  const auto object = last<wire::SeenObject>(news);
  EXPECT_EQ(object.name, "car");
  EXPECT_EQ(object.kind, "vehicle");
  EXPECT_EQ(object.at.x, 120);
  EXPECT_EQ(object.spread, 4);
  EXPECT_EQ(object.seen, MissionTime::seconds(8.5).count());
  const auto other = last<wire::SeenObject>(see(line(10, "ground", "seen").with("name", "fire")));
  EXPECT_NE(other.header.instance, object.header.instance) << "each object is a value of its own";
}

TEST_F(ARetoldRun, TellsWhereAUavStandsInAJointTask) {
  see(line(8, "marvin", "joint").with("uav", "marvin").with("joint", "other").with("task", 2));
  const auto news = see(line(9, "marvin", "joint")
                            .with("uav", "marvin")
                            .with("joint", "watch 7")
                            .with("task", 7)
                            .with("model", "watch")
                            .with("phase", "running")
                            .with("holders", "karma far, marvin near")
                            .with("blocks", "b1 b2")
                            .with("violated", "apart")
                            .with("start", 12.5));

  const auto state = last<wire::JointTaskState>(news);
  EXPECT_EQ(state.uav, "marvin");
  EXPECT_EQ(state.subject, "watch 7");
  EXPECT_EQ(state.header.origin, 11U);
  EXPECT_EQ(state.header.instance, 2U) << "the second joint task of this UAV";
  EXPECT_EQ(state.phase, wire::JointTaskPhase::kRunning);
  EXPECT_THAT(state.holders,
              ElementsAre(wire::RoleHolder{"karma", "far"}, wire::RoleHolder{"marvin", "near"}));
  EXPECT_THAT(state.active_blocks, ElementsAre("b1", "b2"));
  EXPECT_THAT(state.violated, ElementsAre("apart"));
  EXPECT_EQ(state.agreed_start, 12'500'000'000);
}

TEST_F(ARetoldRun, TellsWhereAUavWas) {
  const auto news = see(line(7, "sim", "telemetry")
                            .with("uav", "marvin")
                            .with("position", std::vector<double>{1, 2, 30})
                            .with("velocity", std::vector<double>{3, 0, 0})
                            .with("heading", 0.5)
                            .with("energy", 0.8)
                            .with("airborne", true));

  const auto telemetry = last<wire::Telemetry>(news);
  EXPECT_EQ(telemetry.uav, "marvin");
  EXPECT_EQ(telemetry.position, (wire::FloatVector3{1, 2, 30}));
  EXPECT_EQ(telemetry.header.mission_time, 7'000'000'000);
  const auto board = last<wire::UavBoard>(news);
  EXPECT_EQ(board.header.instance, 11U);
  EXPECT_EQ(board.located_at, 7'000'000'000);
  EXPECT_TRUE(board.airborne);
}

TEST_F(ARetoldRun, TellsTheStatesOfTasksAndSinceWhen) {
  (void)see(task(3, 100, "scheduled"));
  const auto tasks = last<wire::UavTasks>(see(task(5, 100, "running"))).tasks;

  ASSERT_EQ(tasks.size(), 1U);
  EXPECT_EQ(tasks[0].state, wire::TaskState::kRunning);
  EXPECT_EQ(tasks[0].since, 5'000'000'000);
  EXPECT_FALSE(tasks[0].at_ground);
}

TEST_F(ARetoldRun, KeepsThePlanButWhatIsOver) {
  const auto planned = [](double at, int id) {
    return line(at, "marvin", "planned")
        .with("uav", "marvin")
        .with("task", id)
        .with("type", "goto");
  };
  (void)see(planned(1, 100));
  (void)see(planned(1, 101));
  (void)see(task(4, 100, "ended"));
  const auto plan = last<wire::UavTasks>(see(planned(5, 102))).plan;

  std::vector<std::uint64_t> ids;
  for (const auto& entry : plan) ids.push_back(entry.id);
  EXPECT_THAT(ids, ElementsAre(101, 102));
}

TEST_F(ARetoldRun, TellsAlarmsPhaseAndTheEnd) {
  (void)see(line(1, "ground", "phase").with("name", "Search"));
  (void)see(line(2, "ground", "alarm")
                .with("alarm", 1)
                .with("state", "raised")
                .with("position", std::vector<double>{5, 6, 0})
                .with("belief", 0.7));
  (void)see(line(9, "ground", "alarm").with("alarm", 1).with("state", "confirmed"));
  const auto board =
      last<wire::GroundBoard>(see(line(20, "ground", "mission").with("state", "finished")));

  EXPECT_EQ(board.phase, "Search");
  ASSERT_EQ(board.alarms.size(), 1U);
  EXPECT_EQ(board.alarms[0].state, wire::AlarmState::kConfirmed);
  EXPECT_EQ(board.alarms[0].first_seen, 2'000'000'000);
  EXPECT_TRUE(board.finished);
}

TEST_F(ARetoldRun, ATaskOfTheTeamHasTheOwnersItHasNow) {
  const auto owner = [](double at, const char* stage, const char* owners) {
    return line(at, "ground", "owner")
        .with("task", 12)
        .with("statement", "perceive P1 30")
        .with("stage", stage)
        .with("owners", owners);
  };
  (void)see(owner(1, "for-sale", ""));
  const auto team = last<wire::GroundBoard>(see(owner(2, "granted", "marvin, heliv"))).team;

  ASSERT_EQ(team.size(), 1U);
  EXPECT_EQ(team[0].statement, "perceive P1 30");
  EXPECT_EQ(team[0].stage, "granted");
  EXPECT_THAT(team[0].owners, ::testing::ElementsAre("marvin", "heliv"));
}

TEST_F(ARetoldRun, ACommandIsOneEntryFromIssueToItsEnd) {
  const auto command = [](double at, const char* state) {
    return line(at, "ground", "command")
        .with("uav", "marvin")
        .with("command", 4)
        .with("what", "DEGREE 1")
        .with("state", state);
  };
  (void)see(command(1, "issued"));
  const auto under_way = last<wire::GroundBoard>(see(command(1.5, "delivered"))).commands;
  ASSERT_EQ(under_way.size(), 1U);
  EXPECT_EQ(under_way[0].state, wire::CommandState::kDelivered);
  EXPECT_EQ(under_way[0].settled, wire::kNoInstant);
  const auto commands = last<wire::GroundBoard>(see(command(2, "acknowledged"))).commands;

  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(commands[0].state, wire::CommandState::kAcknowledged);
  EXPECT_EQ(commands[0].settled, 2'000'000'000);
}

TEST_F(ARetoldRun, ACutLinkIsTold) {
  const auto link = last<wire::LinkState>(
      see(line(1, "sim", "link").with("from", "ground").with("to", "karma").with("up", false)));

  EXPECT_EQ(link.from, 1U);
  EXPECT_EQ(link.to, 10U);
  EXPECT_FALSE(link.up);
}

TEST_F(ARetoldRun, WhatThePageDoesNotShowAndUavsOfOthersArePassedOver) {
  EXPECT_THAT(see(line(1, "marvin", "sync").with("id", "s")), IsEmpty());
  EXPECT_THAT(see(line(1, "x", "degree").with("uav", "stranger").with("degree", 2)), IsEmpty());
}

// Whatever a line says, what is told can be sent: a damaged log must not end the replay.
RC_GTEST_PROP(RetoldLaw, WhatIsToldIsWellFormedWhateverALineSays, ()) {
  static const std::vector<std::string> kinds = {
      "telemetry", "degree", "hand",  "task",  "goal",    "plan",  "planned",
      "decision",  "link",   "reach", "alarm", "command", "phase", "mission"};
  Retold retold({"marvin"});
  Record record = line(*rc::gen::inRange(0, 1000), "ground", *rc::gen::elementOf(kinds));
  record.with("uav", "marvin");
  for (const char* key : {"task", "goal", "state", "position", "degree", "number", "alarm",
                          "command", "way", "energy", "earliest_start"}) {
    if (*rc::gen::arbitrary<bool>()) {
      record.with(key, *rc::gen::arbitrary<double>());
    } else if (*rc::gen::arbitrary<bool>()) {
      record.with(key, *rc::gen::arbitrary<std::vector<double>>());
    } else {
      record.with(key, *rc::gen::string<std::string>());
    }
  }
  for (const wire::Sample& sample : retold.see(record)) RC_ASSERT(!wire::to_json(sample).empty());
}

}  // namespace
}  // namespace skein::replay_tool
