// SPDX-License-Identifier: Apache-2.0
// A mission beside writers that are none of ours and say what they like in the names of its nodes:
// it is refused, counted, named the first and the tenth time, and the mission is flown all the
// same.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>

#include "skein/blackboard/domain_lease.hpp"
#include "testing/clocks_apart.hpp"
#include "testing/dds_run.hpp"
#include "testing/foreign_writer.hpp"

namespace skein::testing {
namespace {

using blackboard::DdsVendor;
using blackboard::testing::Bytes;
using blackboard::testing::bytes_of;
using blackboard::testing::ForeignWriter;
using blackboard::testing::make_foreign_writer;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using wire::Slot;

constexpr double kRate = 15;
/// As the fleet numbers them: the ground station, the simulator, the UAVs in the scenario's order.
constexpr std::uint32_t kGround = 1, kSim = 2, kMarvin = 10, kKarma = 12;

/// A well-formed sample of a life before all others, so that it is none of the session of those.
template <class T>
T said(std::uint32_t origin, std::uint32_t destination) {
  T sample;
  sample.header.origin = origin;
  sample.header.destination = destination;
  sample.header.incarnation = 1;
  sample.header.sequence_number = 1;
  sample.header.expires = wire::kNever;
  return sample;
}

/// What is said, where, and what who hears it logs of it.
struct Wrong {
  Slot slot;
  std::string partition;
  Bytes bytes;
  std::string node, why;
};

Bytes cut_short(Bytes bytes) {
  bytes.resize(bytes.size() / 2);
  return bytes;
}

Bytes not_cdr(Bytes bytes) {
  bytes[1] = 7;  // XCDR2
  return bytes;
}

Bytes a_megabyte_after(Bytes header) {
  header.resize(60);
  header.resize(1'000'000, 0xA5);
  return header;
}

/// In the name of a UAV, to the ground station.
std::vector<Wrong> of_karma() {
  const std::string way = "radio/karma>ground";
  auto board = said<wire::PlanBoard>(kKarma, kGround);
  board.tasks.resize(wire::kMaximumSequence + 1);
  auto telemetry = said<wire::Telemetry>(kKarma, kGround);
  telemetry.position.z = std::numeric_limits<float>::quiet_NaN();
  const auto degree = said<wire::AutonomyDegree>(kKarma, kGround);
  const auto sync = said<wire::SyncMessage>(kKarma, kGround);
  const auto beat = said<wire::Heartbeat>(kKarma, kGround);
  return {
      {Slot::kAutonomyDegree, way, not_cdr(bytes_of(degree)), "ground", "not CDR version 1"},
      {Slot::kPlanBoard, way, bytes_of(board), "ground", "too many elements"},
      {Slot::kPlanFrontier, way, a_megabyte_after(bytes_of(board)), "ground", ""},
      {Slot::kTelemetry, way, bytes_of(telemetry), "ground", "not a finite number"},
      {Slot::kTaskEvent, way, bytes_of(said<wire::TaskEvent>(77, kGround)), "ground",
       "not a node of channel"},
      {Slot::kSyncMessage, way, cut_short(bytes_of(sync)), "ground", "cut short"},
      {Slot::kHeartbeat, way, bytes_of(beat), "ground", "a second node has this name"},
  };
}

/// In the names of the ground station and of the simulator.
std::vector<Wrong> of_ground_and_sim() {
  const std::string way = "radio/ground>marvin";
  const auto request = said<wire::TaskRequest>(kGround, kMarvin);
  const auto degree = said<wire::DegreeCommand>(kGround, kMarvin);
  auto clock = said<wire::Clock>(kSim, 0);
  clock.phase = static_cast<wire::ClockPhase>(17);
  return {
      {Slot::kTaskRequest, way, cut_short(bytes_of(request)), "marvin", "cut short"},
      {Slot::kDegreeCommand, way, not_cdr(bytes_of(degree)), "marvin", "not CDR version 1"},
      {Slot::kClock, "world", bytes_of(clock), "heliv", ""},
  };
}

struct Vendors {
  std::string ours, theirs;
};

class DdsBadInput : public ::testing::TestWithParam<Vendors> {
 protected:
  void start() {
    run.take_scenario("confirmed");
    run.start({"--rate", std::to_string(kRate), "--domain", domain(), "--dds", GetParam().ours});
    run.wait_for_output("the mission starts");
  }
  std::string domain() const { return std::to_string(lease_.domain()); }
  std::unique_ptr<ForeignWriter> writer(Slot topic, Slot type, const std::string& partition) const {
    return make_foreign_writer(blackboard::dds_from_name(GetParam().theirs).value(),
                               {lease_.domain(), topic, type, partition});
  }
  /// What that node has said of it so far.
  std::vector<std::string> named(const Wrong& wrong) const {
    const std::string start = "] " + std::string(wire::slot_name(wrong.slot)) + " of ";
    std::vector<std::string> lines;
    std::ifstream in(run.folder() / "logs" / (wrong.node + ".log"));
    for (std::string line; std::getline(in, line);)
      if (line.find(start) != std::string::npos && line.find(wrong.why) != std::string::npos)
        lines.push_back(line);
    return lines;
  }
  /// Says all of it again and again, as streams may be lost, until each was named twice.
  void say_until_named(const std::vector<Wrong>& all) {
    std::vector<std::unique_ptr<ForeignWriter>> writers;
    for (const Wrong& one : all) writers.push_back(writer(one.slot, one.slot, one.partition));
    const auto is_named = [&](const Wrong& one) { return named(one).size() > 1; };
    holds_within(20, [&] {
      for (std::size_t i = 0; i < all.size(); ++i)
        if (!is_named(all[i])) writers[i]->write(all[i].bytes);
      return std::all_of(all.begin(), all.end(), is_named);
    });
    for (const Wrong& one : all) {
      const auto lines = named(one);
      EXPECT_THAT(lines, ElementsAre(Not(HasSubstr("times)")), HasSubstr("(10 times)")))
          << wire::slot_name(one.slot) << " in " << one.partition;
    }
  }
  void say_with_another_type() {
    const Wrong wrong{
        Slot::kAlarm, "radio/ground>marvin", {}, "marvin", "is skein::idl::Telemetry"};
    const auto foreign = writer(wrong.slot, Slot::kTelemetry, wrong.partition);
    EXPECT_TRUE(holds_within(20, [&] { return named(wrong).size() == 1; }));
  }
  void expect_mission_as_if_nothing_had_been() {
    const auto status = run.wait();
    ASSERT_TRUE(status.has_value());
    EXPECT_EQ(status->code, 0) << run.output();
    EXPECT_THAT(run.output(), HasSubstr("20 of 20 expectations met"));
    EXPECT_EQ(run.count("process", "state", "exited"), 5U);
  }

  DdsRun run;

 private:
  blackboard::DomainLease lease_ = blackboard::claim_domain().value();
};

TEST_P(DdsBadInput, IsRefusedCountedAndNamedOnceByEveryDaemonAndTheMissionIsFlown) {
  start();

  std::vector<Wrong> all = of_karma();
  std::ranges::move(of_ground_and_sim(), std::back_inserter(all));
  say_until_named(all);
  say_with_another_type();

  expect_mission_as_if_nothing_had_been();
}

// Among them the clock, commands, task events and heartbeats; each of what the mission says
// meanwhile.
TEST_P(DdsBadInput, WhatWasSaidBeforeAndIsPlayedAgainIsHandledOnceAndNamed) {
  start();
  const std::string recording = run.file("old.mcap").string();

  ASSERT_EQ(run.skein({"spy", "--duration", "4", "record", recording}).code, 0);
  const Answered played = run.skein({"spy", "--dds", GetParam().theirs, "play", recording});

  EXPECT_EQ(played.code, 0) << played.text;
  expect_mission_as_if_nothing_had_been();
  EXPECT_GT(run.count("dropped", "field", "header.sequence_number"), 0U);
  EXPECT_EQ(breaches_beyond_clocks(run.records(), kRate), "");
}

INSTANTIATE_TEST_SUITE_P(OfBothVendors, DdsBadInput,
                         ::testing::Values(Vendors{"fastdds", "cyclonedds"},
                                           Vendors{"cyclonedds", "fastdds"}),
                         [](const auto& one) {
                           return "on_" + one.param.ours + "_from_" + one.param.theirs;
                         });

}  // namespace
}  // namespace skein::testing
