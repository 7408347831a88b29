// SPDX-License-Identifier: Apache-2.0
// What the doctor says of a machine and of a domain.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "doctor/domain.hpp"
#include "doctor/machine.hpp"
#include "skein/scenario/scenario_print.hpp"
#include "temporary_folder.hpp"
#include "testing/fake_observer.hpp"

namespace skein::spy_tool {
namespace {

using ::testing::HasSubstr;
using Grade = Finding::Grade;

/// The texts of that grade, one a line, each behind what was checked.
std::string texts(const Findings& findings, Grade grade) {
  std::string all;
  for (const Finding& one : findings)
    if (one.grade == grade) all += one.check + ": " + one.text + "\n";
  return all;
}

MachineFacts healthy() {
  MachineFacts facts;
  facts.interfaces = {{"lo", "127.0.0.1", true, false, true},
                      {"radio0", "10.0.0.1", true, true, false}};
  facts.receive_buffer = 4 << 20;
  facts.wall = 1'795'000'000'000'000'000;
  return facts;
}

blackboard::NetworkConfig on(const std::string& address) {
  blackboard::NetworkConfig network;
  network.interfaces = {address};
  return network;
}

TEST(DoctorOfMachines, FindsNothingBadOnAHealthyOne) {
  const Findings findings = judge_machine(healthy(), healthy(), on("10.0.0.1"));
  EXPECT_EQ(texts(findings, Grade::kBad), "");
  EXPECT_EQ(texts(findings, Grade::kNote), "");
}

TEST(DoctorOfMachines, FindsAnAddressThatNobodyHasAndInterfacesThatCannotDoIt) {
  MachineFacts facts = healthy();
  EXPECT_THAT(texts(judge_machine(facts, facts, on("10.9.9.9")), Grade::kBad),
              HasSubstr("no interface has address 10.9.9.9"));
  facts.interfaces[1].multicast = false;
  EXPECT_THAT(texts(judge_machine(facts, facts, on("10.0.0.1")), Grade::kBad),
              HasSubstr("takes no multicast"));
  blackboard::NetworkConfig quiet = on("10.0.0.1");
  quiet.multicast = false;
  EXPECT_EQ(texts(judge_machine(facts, facts, quiet), Grade::kBad), "");
  facts.interfaces[1].up = false;
  EXPECT_THAT(texts(judge_machine(facts, facts, quiet), Grade::kBad), HasSubstr("is down"));
}

TEST(DoctorOfMachines, NotesThatOnlyThisMachineIsSeen) {
  EXPECT_THAT(texts(judge_machine(healthy(), healthy(), {}), Grade::kNote),
              HasSubstr("only programs of this machine"));
}

TEST(DoctorOfMachines, NotesSmallBuffersAndWhatWasLostForThem) {
  MachineFacts before = healthy(), after = healthy();
  after.receive_buffer = 212'992;
  before.overflows = 100;
  after.overflows = 123;
  const std::string notes = texts(judge_machine(before, after, on("10.0.0.1")), Grade::kNote);
  EXPECT_THAT(notes, HasSubstr("sysctl -w net.core.rmem_max=2097152"));
  EXPECT_THAT(notes, HasSubstr("23 UDP packets"));
}

TEST(DoctorOfMachines, NotesAClockThatWasSetOrNeverWas) {
  MachineFacts before = healthy(), after = healthy();
  after.steady = 3'000'000'000;
  after.wall = before.wall + 5'500'000'000;
  EXPECT_THAT(texts(judge_machine(before, after, on("10.0.0.1")), Grade::kNote),
              HasSubstr("set by 2.500 s"));
  before.wall = after.wall = 60'000'000'000;
  after.steady = 0;
  EXPECT_THAT(texts(judge_machine(before, after, on("10.0.0.1")), Grade::kNote),
              HasSubstr("before 2020"));
}

TEST(DoctorOfMachines, FindsSharedMemoryOfDeadProgramsOnly) {
  const skein::testing::TemporaryFolder folder;
  const auto file = [&](const std::string& name) { return (folder.path() / name).string(); };
  std::ofstream(file("fastrtps_dead")) << "1234567";
  std::ofstream(file("fastrtps_used")) << "1";
  std::ofstream(file("somebody's")) << "1";
  const std::ifstream used(file("fastrtps_used"));

  const MachineFacts facts = look_at_machine(folder.path().string());

  EXPECT_EQ(facts.leftovers.names, std::vector<std::string>{"fastrtps_dead"});
  EXPECT_EQ(facts.leftovers.bytes, 7U);
  EXPECT_THAT(texts(judge_machine(facts, facts, {}), Grade::kNote),
              HasSubstr("1 files of dead programs (7 bytes), fastrtps_dead"));
}

TEST(DoctorOfMachines, SeesTheLoopbackOfThisOne) {
  const MachineFacts facts = look_at_machine();
  bool loopback = false;
  for (const Interface& one : facts.interfaces)
    loopback = loopback || (one.address == "127.0.0.1" && one.loopback);
  EXPECT_TRUE(loopback);
  EXPECT_GT(facts.receive_buffer, 0U);
}

TEST(DoctorOfMachines, SaysWhyMulticastCannotBeTried) {
  EXPECT_FALSE(try_multicast("10.254.253.252").has_value());
  EXPECT_FALSE(try_multicast("somewhere").has_value());
}

/// A domain, and what the doctor says of it.
class DoctorOfDomains : public ::testing::Test {
 protected:
  testing::Story domain() { return testing::Story(observer_); }
  Findings judge() {
    Graph graph;
    Consultation consultation;
    for (const blackboard::Sighting& one : observer_.sightings) {
      graph.see(one, {});
      const auto* raw = std::get_if<blackboard::SampleSeen>(&one);
      if (raw == nullptr) continue;
      const Heard heard(*raw, graph.endpoint(raw->writer), wire::slot_from_name(raw->topic));
      const auto* sample = heard.sample();
      graph.hear(raw->writer, raw->at, 0,
                 sample == nullptr ? nullptr : std::get_if<wire::DirectoryEntry>(sample));
      consultation.hear(heard, graph);
    }
    return consultation.judge(graph, 7);
  }
  std::string bad() { return texts(judge(), Grade::kBad); }
  std::string notes() { return texts(judge(), Grade::kNote); }

  testing::FakeObserver observer_;
};

TEST_F(DoctorOfDomains, NotesThatNobodyIsThere) {
  EXPECT_THAT(notes(), HasSubstr("nobody is on domain 7"));
}

TEST_F(DoctorOfDomains, FindsAnotherLayoutOfSamples) {
  domain().node("ground", 1).joins("marvin", "skein 0.0.9 layout 0000000000000000");
  EXPECT_THAT(bad(), HasSubstr("other layouts of samples"));
  EXPECT_THAT(bad(), HasSubstr("have marvin"));
  EXPECT_THAT(notes(), HasSubstr("0.0.9: marvin"));
}

TEST_F(DoctorOfDomains, NamesWhoFliesAnotherScenarioAndWhereItDiffers) {
  const auto flying = [](const scenario::Scenario& scenario) {
    return to_text(blackboard::program_description(scenario::print_of(scenario).text()));
  };
  scenario::Scenario other;
  other.world.places["hut"] = {1, 2, 3};
  domain().joins("ground", flying({})).joins("marvin", flying({})).joins("spy");
  EXPECT_THAT(texts(judge(), Grade::kGood), HasSubstr("all fly the same: ground, marvin\n"));
  domain().joins("karma", flying(other));
  EXPECT_THAT(bad(), HasSubstr("karma not the same as ground, marvin: differs in places"));
}

TEST_F(DoctorOfDomains, NotesProgramsThatDoNotSayWhatTheyAre) {
  domain().node("ground", 1).joins("rviz", "");
  EXPECT_EQ(bad(), "");
  EXPECT_THAT(notes(), HasSubstr("do not say which program they are: rviz"));
}

TEST_F(DoctorOfDomains, FindsATopicOfOursWithAnotherTypeOrWeakerQos) {
  blackboard::Endpoint clock = reader_of(wire::Slot::kClock, {"world"});
  clock.writer = true;
  clock.type = "rosgraph::Clock";
  blackboard::Endpoint event = reader_of(wire::Slot::kTaskEvent, {"world"});
  event.writer = true;
  event.qos = {};
  domain().joins("tool", "").has("tool", clock).has("tool", event);
  EXPECT_THAT(bad(), HasSubstr("Clock of tool has the type rosgraph::Clock"));
  EXPECT_THAT(bad(), HasSubstr("TaskEvent of tool: the writer offers best effort"));
}

TEST_F(DoctorOfDomains, HasNothingAgainstTypesThatAreAnnounced) {
  blackboard::Endpoint event = reader_of(wire::Slot::kTaskEvent, {"types"});
  event.writer = true;
  event.qos = {};
  event.qos.exclusive = true;
  domain().node("ground", 1).has("ground", event);
  EXPECT_EQ(bad(), "");
}

TEST_F(DoctorOfDomains, FindsMalformedSamplesWithTheirField) {
  domain()
      .node("sim", 2)
      .writes("sim", wire::Slot::kClock)
      .says_bytes("sim", "Clock", {0, 1, 0, 0, 1});
  EXPECT_THAT(bad(), HasSubstr("1 times malformed: Clock of sim: header"));
}

// In flight nobody writes a directory.
TEST_F(DoctorOfDomains, FindsTwoProcessesOfOneNameByTheirHeartbeats) {
  wire::Heartbeat heartbeat;
  heartbeat.header.origin = 10;
  for (const char* one : {"marvin", "laptop"})
    domain().joins(one).writes(one, wire::Slot::kHeartbeat, "radio/marvin>ground");
  domain().says("marvin", heartbeat);
  EXPECT_EQ(bad(), "");
  domain().says("laptop", heartbeat);
  EXPECT_THAT(bad(), HasSubstr("participant laptop at 127.0.0.1:7411, participant marvin at "));
}

TEST_F(DoctorOfDomains, TakesNoRelayForASecondProcess) {
  wire::Heartbeat heartbeat;
  heartbeat.header.origin = 10;
  for (const char* one : {"marvin", "relay"})
    domain().joins(one).writes(one, wire::Slot::kHeartbeat, "radio/marvin>ground");
  domain().says("marvin", heartbeat);
  heartbeat.header.via = {11};
  domain().says("relay", heartbeat);
  EXPECT_EQ(bad(), "");
}

TEST_F(DoctorOfDomains, NotesNodesThatWait) {
  domain().node("marvin", 10, wire::Role::kDdn, false);
  EXPECT_THAT(notes(), HasSubstr("wait for somebody whom they have not heard: marvin"));
}

TEST_F(DoctorOfDomains, NotesClocksOfMachinesThatDiffer) {
  domain().node("marvin", 10).node("sim", 2);
  domain().writes("marvin", wire::Slot::kTelemetry).writes("sim", wire::Slot::kTruth);
  domain().says("marvin", wire::Telemetry{}, 1, -30).says("sim", wire::Truth{}, 1, 0.001);
  EXPECT_THAT(notes(), HasSubstr("differ, by 30.0 s"));
}

}  // namespace
}  // namespace skein::spy_tool
