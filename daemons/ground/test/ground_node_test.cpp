// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/ground_node.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/station.hpp"

#include "skein/translation/sensing.hpp"

namespace skein::ground {
namespace {

namespace gs = ground_station;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using wire::TaskState;

using testing::at;
using testing::planned;
using testing::Station;
using testing::step;

/// A mission of one step: at 1 s Marvin gets a goto.
gs::Script one_goto() {
  gs::Script script;
  script.steps.push_back(
      step("go", {gs::AtTime{at(1)}}, {gs::SendPlan{"marvin", {planned(2, "goto")}}}));
  script.steps.back().phase = "Going";
  return script;
}

wire::TaskEvent task_event(std::uint64_t id, TaskState state) {
  wire::TaskEvent event;
  event.id = id;
  event.type = "goto";
  event.state = state;
  return event;
}

wire::RequestReply reply(std::uint64_t command, bool accepted, const std::string& why = "") {
  wire::RequestReply sample;
  sample.command = command;
  sample.accepted = accepted;
  sample.why = why;
  return sample;
}

wire::SyncMessage sync(const std::string& from, const std::string& to) {
  wire::SyncMessage message;
  message.id = 551;
  message.from = from;
  message.to = to;
  return message;
}

/// A look straight down at (0, 0) that sees fire there.
wire::PerceptionReport sight(const std::string& device) {
  world::Perception look;
  look.uav = "somebody";
  look.device = device;
  look.viewpoint = {0, 0, 40};
  look.direction = {0, 0, -1};
  look.range = 200;
  look.aperture = 0.8F;
  look.detections = {{"fire", {0, 0, 0}, 5, 0.9}};
  return translation::to_wire(look);
}

// ---- the script becomes requests ----

TEST(GroundNode, WakesForItsScript) {
  Station station(one_goto());

  EXPECT_EQ(station.node().next_wakeup(), at(1));
}

TEST(GroundNode, SendsAPlannedTaskAsANumberedRequestThatExpires) {
  Station station(one_goto());

  station.give(node::Wakeup{}, 1);

  const auto requests = station.sent<wire::TaskRequest>();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].first, "marvin");
  EXPECT_EQ(requests[0].second.command, 1U);
  EXPECT_EQ(requests[0].second.kind, wire::RequestKind::kStart);
  EXPECT_EQ(requests[0].second.task.id, 2U);
  EXPECT_EQ(requests[0].second.task.type, "goto");
  EXPECT_EQ(station.all<node::Send>()[0].expires, at(61));
  EXPECT_EQ(station.all<node::Send>()[0].receipt, 1U);
}

TEST(GroundNode, PublishesAndLogsThePhaseItEnters) {
  Station station(one_goto());

  station.give(node::Wakeup{}, 1);

  ASSERT_EQ(station.published<wire::MissionState>().size(), 1U);
  const auto state = station.published<wire::MissionState>()[0];
  EXPECT_EQ(state.phase, "Going");
  EXPECT_FALSE(state.finished);
  ASSERT_EQ(station.records("phase").size(), 1U);
  EXPECT_EQ(station.records("phase")[0].text("name"), "Going");
  EXPECT_EQ(station.records("step").size(), 1U);
}

TEST(GroundNode, ACommandThatCouldNotBeDeliveredIsOverAtOnce) {
  Station station(one_goto());
  station.give(node::Wakeup{}, 1);
  const auto marvin = station.roster().find("marvin")->number;

  station.give(node::Undelivered{marvin, wire::Slot::kAlarm, 4, 0, false}, 50);
  station.give(node::Undelivered{marvin, wire::Slot::kTaskRequest, 1, 1, true}, 61);
  EXPECT_TRUE(station.records("command").empty()) << "no command, and one that may be answered";
  station.give(node::Undelivered{marvin, wire::Slot::kTaskRequest, 1, 1, false}, 61);

  ASSERT_EQ(station.records("command").size(), 1U);
  EXPECT_EQ(station.records("command")[0].text("state"), "expired");
  EXPECT_EQ(station.records("command")[0].text("why"), "not delivered: no contact in its lifetime");
}

TEST(GroundNode, LogsACommandFromItsIssueToItsAnswer) {
  Station station(one_goto());
  station.give(node::Wakeup{}, 1);
  ASSERT_EQ(station.records("command").size(), 1U);
  EXPECT_EQ(station.records("command")[0].text("state"), "issued");
  EXPECT_EQ(station.records("command")[0].text("uav"), "marvin");

  station.give(node::Delivered{station.roster().find("marvin")->number, 1}, 2);
  ASSERT_EQ(station.records("command").size(), 1U);
  EXPECT_EQ(station.records("command")[0].text("state"), "delivered");

  station.from("marvin", reply(1, true), 2);

  ASSERT_EQ(station.records("command").size(), 1U);
  EXPECT_EQ(station.records("command")[0].text("state"), "acknowledged");
}

TEST(GroundNode, LogsWhyACommandWasRefused) {
  Station station(one_goto());
  station.give(node::Wakeup{}, 1);

  station.from("marvin", reply(1, false, "known id"), 2);

  ASSERT_EQ(station.records("command").size(), 2U);
  EXPECT_EQ(station.records("command")[0].text("state"), "delivered");
  EXPECT_EQ(station.records("command")[1].text("state"), "refused");
  EXPECT_EQ(station.records("command")[1].text("why"), "known id");
}

TEST(GroundNode, LogsACommandThatWasNeverAnsweredAsExpired) {
  Station station(one_goto());
  station.give(node::Wakeup{}, 1);
  ASSERT_TRUE(station.node().next_wakeup().has_value());

  station.give(node::Wakeup{}, station.node().next_wakeup()->to_seconds());

  ASSERT_EQ(station.records("command").size(), 1U);
  EXPECT_EQ(station.records("command")[0].text("state"), "expired");
}

// ---- what the UAVs say reaches the script ----

TEST(GroundNode, AStepFollowsTheEventOfATask) {
  gs::Script script = one_goto();
  script.steps.push_back(
      step("end", {gs::OnTask{"marvin", executive::TaskId(2), executive::TaskState::kEnded}},
           {gs::Finish{}}));
  Station station(script);
  station.give(node::Wakeup{}, 1);
  station.from("marvin", reply(1, true), 2);
  station.from("marvin", task_event(2, TaskState::kRunning), 3);
  EXPECT_THAT(station.all<node::Finish>(), IsEmpty());

  station.from("marvin", task_event(2, TaskState::kEnded), 4);

  EXPECT_EQ(station.all<node::Finish>().size(), 1U);
  ASSERT_EQ(station.records("mission").size(), 1U);
  EXPECT_EQ(station.records("mission")[0].text("state"), "finished");
  ASSERT_FALSE(station.published<wire::MissionState>().empty());
  const auto state = station.published<wire::MissionState>().back();
  EXPECT_TRUE(state.finished);
  EXPECT_EQ(state.outcome, "finished");
}

// A UAV is known by its node, whatever name its samples give.
TEST(GroundNode, TheEventOfAnotherUavIsNotMarvins) {
  gs::Script script;
  script.steps.push_back(
      step("end", {gs::OnTask{"marvin", executive::TaskId(2), executive::TaskState::kEnded}},
           {gs::Finish{}}));
  Station station(script);
  wire::TaskEvent event = task_event(2, TaskState::kEnded);
  event.uav = "marvin";

  station.from("heliv", event, 1);
  EXPECT_THAT(station.all<node::Finish>(), IsEmpty());

  station.from("marvin", event, 2);
  EXPECT_EQ(station.all<node::Finish>().size(), 1U);
}

TEST(GroundNode, APlanBoardTellsWhatEventsDidNot) {
  gs::Script script;
  script.steps.push_back(
      step("end", {gs::OnTask{"marvin", executive::TaskId(2), executive::TaskState::kEnded}},
           {gs::Finish{}}));
  Station station(script);
  wire::PlanBoard board;
  board.uav = "marvin";
  board.degree = 3;
  board.tasks = {{2, "goto", TaskState::kEnded, ""}};

  station.from("marvin", board, 1);

  EXPECT_EQ(station.all<node::Finish>().size(), 1U);
}

TEST(GroundNode, ARestartedUavIsNoticedWithWhatWasLost) {
  Station station(one_goto());
  station.give(node::Wakeup{}, 1);
  station.from("marvin", reply(1, true), 2);
  station.from("marvin", task_event(2, TaskState::kRunning), 3);

  station.give(node::Reachability{station.roster().find("marvin")->number, true, true}, 9);

  ASSERT_EQ(station.records("notice").size(), 1U);
  EXPECT_EQ(station.records("notice")[0].text("text"), "restarted; 1 tasks lost");
}

// ---- perceptions become alarms ----

TEST(GroundNode, LogsAPerceptionUnderTheNameOfItsSender) {
  Station station;

  station.from("marvin", sight("fire-sensor"), 1);

  ASSERT_EQ(station.records("perception").size(), 1U);
  EXPECT_EQ(station.records("perception")[0].text("uav"), "marvin");
  EXPECT_EQ(station.records("perception")[0].text("device"), "fire-sensor");
  EXPECT_EQ(station.records("perception")[0].number("detections"), 1);
}

TEST(GroundNode, SendsAnAlarmToEveryUavAndLogsIt) {
  Station station;
  double now = 0;
  while (station.records("alarm").empty() && now < 60) {
    now += 2;
    wire::PerceptionReport report = sight("fire-sensor");
    report.header.mission_time = at(now).count();
    station.from("marvin", report, now);
  }

  ASSERT_EQ(station.records("alarm").size(), 1U);
  EXPECT_EQ(station.records("alarm")[0].text("state"), "raised");
  const auto alarms = station.sent<wire::Alarm>();
  ASSERT_EQ(alarms.size(), 2U);
  EXPECT_EQ(alarms[0].first, "marvin");
  EXPECT_EQ(alarms[1].first, "heliv");
  EXPECT_EQ(alarms[0].second.state, wire::AlarmState::kRaised);
  EXPECT_GE(alarms[0].second.belief, 0.9);
}

/// Alarms told to Marvin while the fire is in sight every 2 s.
std::vector<wire::Alarm> told_in_a_minute(Station& station) {
  std::vector<wire::Alarm> told;
  for (double now = 2; now <= 60; now += 2) {
    wire::PerceptionReport report = sight("fire-sensor");
    report.header.mission_time = at(now).count();
    station.from("marvin", report, now);
    for (const auto& [to, alarm] : station.sent<wire::Alarm>())
      if (to == "marvin") told.push_back(alarm);
  }
  return told;
}

TEST(GroundNode, TellsAnAlarmAgainWhereItsAgeCounts) {
  Station station({}, Duration::seconds(10));
  Station silent;

  const auto again = told_in_a_minute(station), once = told_in_a_minute(silent);

  ASSERT_EQ(once.size(), 1U);
  EXPECT_EQ(once[0].seen, wire::kNever);
  ASSERT_GE(again.size(), 5U);
  EXPECT_GE(again.back().seen, at(50).count());
}

TEST(GroundNode, TellsEveryUavWhereAnObjectWasSeenAndLogsIt) {
  Station station({{"fire-front", "fire", {10, 0, 0}, 50, 1}}, Duration());
  wire::PerceptionReport report = sight("visible");
  report.header.mission_time = at(2).count();
  station.from("marvin", report, 2.2);
  EXPECT_TRUE(station.sent<wire::SeenObject>().empty()) << "one sighting may be a false alarm";
  report.header.mission_time = at(3).count();
  station.from("marvin", report, 3.2);

  const auto told = station.sent<wire::SeenObject>();
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[1].first, "heliv");
  EXPECT_EQ(told[1].second.name, "fire-front");
  EXPECT_EQ(told[1].second.at, (wire::Vector3{0, 0, 0}));
  EXPECT_EQ(told[1].second.seen, at(3).count());
  ASSERT_EQ(station.records("seen").size(), 1U);
  EXPECT_EQ(station.records("seen")[0].number("when"), 3);
  EXPECT_EQ(station.records("seen")[0].text("type"), "fire");
}

// ---- synchronisation ----

TEST(GroundNode, RelaysASynchronisationMessageToTheOneItIsFor) {
  Station station({}, 2);

  station.from("marvin", sync("marvin", "heliv"), 1);

  const auto relayed = station.sent<wire::SyncMessage>();
  ASSERT_EQ(relayed.size(), 1U);
  EXPECT_EQ(relayed[0].first, "heliv");
  EXPECT_EQ(relayed[0].second.id, 551U);
  EXPECT_EQ(relayed[0].second.from, "marvin");
}

TEST(GroundNode, RelaysTheWordAndTheInstantAsTheyWereSaid) {
  Station station({}, 2);
  wire::SyncMessage withdrawal = sync("marvin", "heliv");
  withdrawal.word = wire::SyncWord::kWithdrawn;
  withdrawal.said = 42;

  station.from("marvin", withdrawal, 1);

  const auto relayed = station.sent<wire::SyncMessage>();
  ASSERT_EQ(relayed.size(), 1U);
  EXPECT_EQ(relayed[0].second.word, wire::SyncWord::kWithdrawn);
  EXPECT_EQ(relayed[0].second.said, 42);
}

struct Stray {
  std::string name, from, to;
};
class StraySynchronisation : public ::testing::TestWithParam<Stray> {};

TEST_P(StraySynchronisation, IsNoticedAndGoesNowhere) {
  Station station({}, 2);

  station.from("marvin", sync(GetParam().from, GetParam().to), 1);

  EXPECT_TRUE(station.sends_nothing());
  EXPECT_EQ(station.records("notice").size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(GroundNode, StraySynchronisation,
                         ::testing::Values(Stray{"to_nobody", "marvin", "nobody"},
                                           Stray{"to_the_ground", "marvin", "ground"},
                                           Stray{"to_the_simulator", "marvin", "sim"},
                                           Stray{"from_nobody", "nobody", "heliv"},
                                           Stray{"empty", "", ""}),
                         [](const auto& one) { return one.param.name; });

// ---- degree 1: the ground runs the plan ----

TEST(GroundNode, AtDegree1DispatchesElementaryRequestsAndFollowsTheirStatuses) {
  Station station(one_goto(), 1);
  station.give(node::Wakeup{}, 1);
  EXPECT_THAT(station.sent<wire::TaskRequest>(), IsEmpty());
  const auto requests = station.sent<wire::FunctionalRequest>();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].first, "marvin");
  EXPECT_EQ(requests[0].second.kind, wire::FunctionalRequestKind::kDispatch);
  EXPECT_EQ(requests[0].second.type, "goto");
  EXPECT_EQ(station.records("request").size(), 1U);

  wire::FunctionalStatus status;
  status.id = 2;
  status.state = TaskState::kAborted;
  status.reason = "out of the terrain";
  station.from("marvin", status, 2);

  ASSERT_EQ(station.records("task").size(), 1U);
  EXPECT_EQ(station.records("task")[0].text("state"), "aborted");
  EXPECT_EQ(station.records("task")[0].text("reason"), "out of the terrain");
  EXPECT_EQ(station.records("task")[0].text("uav"), "marvin");
}

TEST(GroundNode, AtDegree1InterruptsWhatTheScriptAborts) {
  gs::Script script = one_goto();
  script.steps.push_back(
      step("stop", {gs::AtTime{at(5)}}, {gs::AbortTasks{"marvin", std::nullopt}}));
  Station station(script, 1);
  station.give(node::Wakeup{}, 1);

  station.give(node::Wakeup{}, 5);

  const auto requests = station.sent<wire::FunctionalRequest>();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].second.kind, wire::FunctionalRequestKind::kInterrupt);
  EXPECT_EQ(requests[0].second.id, 2U);
}

TEST(GroundNode, LogsTheSynchronisationsOfThePlansItRuns) {
  gs::PlannedTask rendezvous = planned(3, "synchronise");
  rendezvous.task.synchronisation =
      executive::Synchronisation{551, {"marvin", "heliv"}, {"marvin", "heliv"}, {}};
  gs::Script script;
  script.steps.push_back(step("meet", {gs::AtTime{at(1)}}, {gs::SendPlan{"marvin", {rendezvous}}}));
  Station station(script, 1);

  station.give(node::Wakeup{}, 1);

  ASSERT_GE(station.records("sync").size(), 1U);
  EXPECT_EQ(station.records("sync")[0].text("from"), "marvin");
  EXPECT_EQ(station.records("sync")[0].text("direction"), "sent");

  station.from("heliv", sync("heliv", "marvin"), 2);

  const auto events = station.sent<wire::TaskEvent>();
  ASSERT_FALSE(events.empty()) << "the UAV is told of what it cannot see";
  EXPECT_EQ(events.back().first, "marvin");
  EXPECT_EQ(events.back().second.id, 3U);
  EXPECT_EQ(events.back().second.state, TaskState::kEnded);
}

// ---- strangers ----

class FromAStranger : public ::testing::TestWithParam<wire::Sample> {};

TEST_P(FromAStranger, ASampleSendsNothing) {
  Station station(one_goto());
  station.give(node::Wakeup{}, 1);

  station.from_stranger(GetParam(), 2);
  EXPECT_TRUE(station.sends_nothing());
  station.from("sim", GetParam(), 3);
  EXPECT_TRUE(station.sends_nothing());
  station.give(node::Reachability{node::NodeNumber(77), true, true}, 4);
  EXPECT_TRUE(station.sends_nothing());
}

INSTANTIATE_TEST_SUITE_P(
    GroundNode, FromAStranger,
    ::testing::Values(wire::Telemetry{}, sight("fire-sensor"), task_event(2, TaskState::kEnded),
                      reply(44, true), wire::FunctionalStatus{}, wire::PlanBoard{}, sync("a", "b"),
                      wire::AutonomyDegree{}, wire::Alarm{}, wire::TaskRequest{}, wire::LinkState{},
                      wire::HandOver{}, wire::MissionPlan{}, wire::MissionOutcome{},
                      wire::Decision{}),
    [](const auto& one) { return std::string(wire::slot_name(wire::slot_of(one.param))); });

// A stranger cannot answer in the place of the UAV.
TEST(GroundNode, AReplyFromSomebodyElseDoesNotSettleACommand) {
  Station station(one_goto());
  station.give(node::Wakeup{}, 1);

  station.from("heliv", reply(1, true), 2);

  EXPECT_THAT(station.records("command"), IsEmpty());
}

TEST(GroundNode, PerceptionsOfAStrangerRaiseNoAlarm) {
  Station station;
  std::size_t alarms = 0;
  for (int i = 1; i < 30; ++i) {
    wire::PerceptionReport report = sight("fire-sensor");
    report.header.mission_time = at(2.0 * i).count();
    station.from_stranger(report, 2.0 * i);
    alarms += station.records("alarm").size();
  }

  EXPECT_EQ(alarms, 0U);
}

}  // namespace
}  // namespace skein::ground
