// SPDX-License-Identifier: Apache-2.0
#include "skein/assembly/assembly.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

#include "skein/blackboard/slot_table.hpp"
#include "skein/scenario_setup/setup.hpp"

namespace skein::assembly {
namespace {

using scenario_setup::roster_of;
using ::testing::HasSubstr;

scenario::Scenario comets() {
  auto scenario =
      scenario::read_scenario(std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/confirmed.yaml");
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

TEST(Assembly, TheRosterHasEveryUavInTheOrderOfTheScenario) {
  const node::Roster roster = roster_of(comets());

  ASSERT_EQ(roster.members().size(), 7U);
  EXPECT_EQ(roster.members()[4].name, "marvin");
  EXPECT_EQ(roster.members()[5].name, "heliv");
  EXPECT_EQ(roster.members()[6].name, "karma");
}

TEST(Assembly, EveryNameOfTheRosterThatIsNoPersonsMakesANodeThatStarts) {
  const scenario::Scenario scenario = comets();
  const node::Roster roster = roster_of(scenario);

  for (const node::Member& member : roster.members()) {
    const bool person = member.role == wire::Role::kRunner || member.role == wire::Role::kOperator;
    if (person) continue;
    SCOPED_TRACE(member.name);
    const auto node = make_node(scenario, member.name);
    ASSERT_NE(node, nullptr);
    EXPECT_NO_FATAL_FAILURE((void)node->handle(node::Started{1, true}, MissionTime()));
  }
}

/// COMETS with so many UAVs, all like Marvin, that deliberate.
scenario::Scenario team_of(int uavs) {
  scenario::Scenario scenario = comets();
  scenario::UavSpec one = *scenario.find_uav("marvin");
  one.degree = 4;
  scenario.uavs.clear();
  scenario.ground.script = {};
  scenario.planning.emplace();
  scenario.planning->domain =
      "(defdomain own ((:- (high-level-task survey (zone duration) (detection)) ())"
      " (:- (device-serves fire-sensor detection) ())"
      " (:method (survey ?_zone ?_duration ?_times ?_origin) () ())))";
  for (int i = 0; i < uavs; ++i) {
    one.name = "u" + std::to_string(i);
    scenario.uavs.push_back(one);
    scenario.world.places["pad of " + one.name] = {10.0 * i, 0, 0};
  }
  return scenario;
}

double bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// What the node of each UAV takes when all are in one process.
double bytes_of_a_node(int uavs) {
  const scenario::Scenario scenario = team_of(uavs);
  const NodeMaker make(scenario);
  std::vector<std::unique_ptr<node::Node>> nodes;
  nodes.reserve(scenario.uavs.size());
  const double before = bytes_in_use();
  for (const scenario::UavSpec& uav : scenario.uavs) nodes.push_back(make(uav.name));
  return (bytes_in_use() - before) / uavs;
}

// Each had a copy of the models of all others, and of all places.
TEST(NodeMaker, ANodeTakesTheSameMemoryHoweverManyOthersThereAre) {
  (void)bytes_of_a_node(50);  // what is allocated once
  const double few = bytes_of_a_node(50);
  const double many = bytes_of_a_node(400);

  std::printf("%.0f bytes a node among 50, %.0f among 400\n", few, many);
  EXPECT_NEAR(many / few, 1, 0.05);
}

/// COMETS with a table of slots of its own.
scenario::Scenario comets_with(const std::string& slots) {
  const std::string path = std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/confirmed.yaml";
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  auto scenario = scenario::read_scenario_text(text + slots, path);
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

TEST(Assembly, AScenarioMayChangeTheTableOfSlots) {
  const scenario::Scenario scenario = comets_with(
      "\nslots:\n  Alarm: {flows: [uav>ground], lifespan: 30}\n  Telemetry: {share: 0.1}\n");

  EXPECT_TRUE(check_assembly(scenario).empty());
  const node::Roster roster = roster_of(scenario);
  const auto share = roster.slots().shares()[static_cast<std::size_t>(wire::Slot::kTelemetry)];
  EXPECT_EQ(share.fraction, 0.1);
  for (const auto& channel : roster.channels_of(*roster.find("ground"))) {
    if (channel.kind != blackboard::ChannelKind::kRadio) continue;
    EXPECT_EQ(channel.carries(wire::Slot::kAlarm), channel.to == roster.ground());
    EXPECT_TRUE(channel.carries(wire::Slot::kTelemetry));
  }
}

TEST(Assembly, WhatIsWrongInTheTableOfSlotsIsSaidAllAtOnceWithItsPlace) {
  const Diagnostics wrong = check_assembly(comets_with(R"(
slots:
  Telemetri: {share: 0.1}
  Alarm: {flows: [uav>grund]}
  PerceptionReport: {share: 0.9}
)"));

  const std::string text = to_text(wrong);
  ASSERT_EQ(wrong.size(), 7U) << text << "an alarm that goes nowhere; shares of four kinds";
  EXPECT_THAT(text, HasSubstr("confirmed.yaml:"));
  EXPECT_THAT(text, HasSubstr("slots.Telemetri: no slot 'Telemetri'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'Telemetry'?"));
  EXPECT_THAT(text, HasSubstr("no node 'grund'"));
  EXPECT_THAT(text, HasSubstr("most has PerceptionReport with 90 %"));
  for (const Diagnostic& one : wrong.all()) EXPECT_GT(one.line, 0) << one.message;
}

TEST(Assembly, ADecisionNodeHasTheDegreeAndThePolicyOfItsUav) {
  scenario::Scenario scenario = comets();
  scenario.uavs[2].degree = 2;
  const auto node = make_node(scenario, "karma");

  const node::Effects effects = node->handle(node::Started{1, true}, MissionTime());

  const auto* send = std::get_if<node::Send>(&effects.at(1));  // after its line of the event log
  ASSERT_NE(send, nullptr);
  const auto* degree = std::get_if<wire::AutonomyDegree>(&send->sample);
  ASSERT_NE(degree, nullptr);
  EXPECT_EQ(degree->uav, "karma");
  EXPECT_EQ(degree->degree, 2);
  EXPECT_EQ(degree->contact_policy, "return");
}

TEST(Assembly, AWayHomeEndsAboveTheStart) {
  const scenario::Scenario scenario = comets();
  const node::Roster roster = roster_of(scenario);
  const auto karma = make_node(scenario, "karma");
  (void)karma->handle(node::Reachability{roster.ground(), true, false}, at(1));
  wire::Telemetry flying;
  flying.airborne = true;
  (void)karma->handle(node::Received{roster.sim(), flying}, at(2));
  (void)karma->handle(node::Reachability{roster.ground(), false, false}, at(3));

  const node::Effects effects = karma->handle(node::Wakeup{}, at(123));

  std::vector<double> way;
  for (const node::Effect& effect : effects) {
    const auto* send = std::get_if<node::Send>(&effect);
    const auto* request =
        send == nullptr ? nullptr : std::get_if<wire::FunctionalRequest>(&send->sample);
    if (request != nullptr && request->type == "goto") way = request->parameters.at(0).numbers;
  }
  ASSERT_EQ(way.size(), 3U);
  EXPECT_EQ(way[0], 0);
  EXPECT_EQ(way[1], -90);
  EXPECT_GE(way[2], 40);
}

TEST(Assembly, TheScenariosOfTheRepositoryHaveNothingWrong) {
  EXPECT_TRUE(check_assembly(comets()).empty());
}

TEST(Assembly, WhatTheReaderCannotSeeIsToldAllAtOnce) {
  scenario::Scenario scenario = comets();
  scenario.uavs[0].start = {5000, 0};
  scenario.uavs[1].start = {0, 9000};

  const Diagnostics diagnostics = check_assembly(scenario);

  ASSERT_EQ(diagnostics.size(), 2U);
  EXPECT_THAT(to_text(diagnostics), HasSubstr("marvin"));
  EXPECT_THAT(to_text(diagnostics), HasSubstr("heliv"));
  EXPECT_THAT(to_text(diagnostics), HasSubstr("confirmed.yaml"));
}

TEST(Assembly, TheVirtualRunHasTheSeedAndTheLimitOfTheScenario) {
  scenario::Scenario scenario = comets();
  scenario.seed = 42;

  const node::VirtualConfig config = virtual_config(scenario);

  EXPECT_EQ(config.seed, 42U);
  EXPECT_EQ(config.time_limit, at(2100));
  EXPECT_TRUE(config.crashes.empty());
}

TEST(Assembly, JobsTakeWhatTheScenarioSaysOfPlanning) {
  scenario::Scenario scenario = comets();
  EXPECT_EQ(virtual_config(scenario).jobs.most, Duration::milliseconds(50));
  scenario.planning.emplace();
  scenario.planning->takes_most = Duration::seconds(4);

  EXPECT_EQ(virtual_config(scenario).jobs.least, Duration::milliseconds(50));
  EXPECT_EQ(virtual_config(scenario).jobs.most, Duration::seconds(4));
}

TEST(Assembly, KillsBecomeCrashesWithTheInstantOfTheRestart) {
  scenario::Scenario scenario = comets();
  scenario.faults.kills = {{at(500), "heliv", Duration::seconds(10)}, {at(600), "karma", {}}};

  const node::VirtualConfig config = virtual_config(scenario);

  ASSERT_EQ(config.crashes.size(), 2U);
  EXPECT_EQ(config.crashes[0].node, "heliv");
  EXPECT_EQ(config.crashes[0].at, at(500));
  EXPECT_EQ(config.crashes[0].restart, at(510));
  EXPECT_EQ(config.crashes[1].node, "karma");
  EXPECT_EQ(config.crashes[1].restart, std::nullopt);
}

TEST(Assembly, FaultsOnBoardReachTheSimulatorInOrderOfTime) {
  scenario::Scenario scenario = comets();
  scenario.faults.breaks = {{at(9), "karma", ""}, {at(4), "heliv", "visible"}};
  const auto sim = make_node(scenario, "sim");

  const node::Effects effects = sim->handle(node::Wakeup{}, at(10));

  std::vector<std::string> faults;
  for (const node::Effect& effect : effects) {
    const auto* log = std::get_if<node::Log>(&effect);
    if (log == nullptr || log->record.kind() != "fault") continue;
    faults.push_back(std::string(log->record.text("what")) + " of " +
                     std::string(log->record.text("target")));
  }
  EXPECT_THAT(faults, ::testing::ElementsAre("sensor visible of heliv", "engine of karma"));
}

TEST(Assembly, FaultsOfEveryKindReachTheSimulatorInOrderOfTime) {
  scenario::Scenario scenario = comets();
  scenario.faults.slows = {{at(4), "karma", 3, Duration::seconds(60)}};
  scenario.faults.aborts = {{at(3), "heliv", "takeshot"}};
  scenario.faults.energies = {{at(2), "marvin", 0.5}};
  const auto sim = make_node(scenario, "sim");

  const node::Effects effects = sim->handle(node::Wakeup{}, at(10));

  std::vector<std::string> faults;
  for (const node::Effect& effect : effects) {
    const auto* log = std::get_if<node::Log>(&effect);
    if (log == nullptr || log->record.kind() != "fault") continue;
    faults.push_back(std::string(log->record.text("what")) + " of " +
                     std::string(log->record.text("target")));
  }
  EXPECT_THAT(faults, ::testing::ElementsAre("energy of marvin", "abort takeshot of heliv",
                                             "slow of karma"));
}

TEST(AssemblyDeathTest, ANameThatIsNotOfTheScenarioIsABrokenContract) {
  const scenario::Scenario scenario = comets();

  EXPECT_DEATH((void)make_node(scenario, "nobody"), "precondition");
}

}  // namespace
}  // namespace skein::assembly
