// SPDX-License-Identifier: Apache-2.0
// skein-mavlink between real DDS and a vehicle that speaks MAVLink over UDP.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <fstream>

#include "skein/blackboard/domain_lease.hpp"
#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using run_tool::Process;
using ::testing::HasSubstr;

constexpr const char* kHeliv = "heliv: {model:";
constexpr const char* kHelivElsewhere = "heliv: {functional: autopilot, model:";

/// A UDP port that was free a moment ago.
std::string free_port() {
  const int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in any{};
  any.sin_family = AF_INET;
  any.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(bind(descriptor, reinterpret_cast<sockaddr*>(&any), sizeof any), 0);
  socklen_t size = sizeof any;
  getsockname(descriptor, reinterpret_cast<sockaddr*>(&any), &size);
  close(descriptor);
  return std::to_string(ntohs(any.sin_port));
}

std::optional<Process::Status> end_of(Process& process, double seconds) {
  holds_within(seconds, [&] { return process.poll().has_value(); });
  return process.poll();
}

/// The vehicle and the bridge to it, at the rate of the scenario.
class Aircraft {
 public:
  Aircraft(DdsRun& files, const std::string& uav, const std::string& dialect,
           const std::string& domain, const std::string& rate)
      : files_(files) {
    const std::string scenario = files.file("scenario.yaml").string();
    const std::string port = free_port();
    bridge_ =
        start("bridge.log", {kPrograms + "/skein-mavlink", "--scenario", scenario, "--uav", uav,
                             "--domain", domain, "--rate", rate, "--connect", "udpin:" + port});
    vehicle_ = start("vehicle.log", {kPrograms + "/skein_mavlink_vehicle", scenario, uav, dialect,
                                     "udp:127.0.0.1:" + port, rate});
  }
  std::string log() const { return run_tool::tail_of(files_.file("bridge.log").string(), 40); }
  /// The end of the clock ends the bridge.
  bool bridge_ends() { return bridge_ && end_of(*bridge_, 30).has_value(); }

 private:
  std::optional<Process> start(const std::string& log, const std::vector<std::string>& command) {
    auto process = Process::start(command, files_.file(log).string());
    EXPECT_TRUE(process.has_value());
    if (!process) return std::nullopt;
    return std::move(*process);
  }

  DdsRun& files_;
  std::optional<Process> bridge_, vehicle_;
};

class DdsMavlink : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Dialects, DdsMavlink, ::testing::Values("px4", "ardupilot"),
                         [](const auto& one) { return std::string(one.param); });

TEST_P(DdsMavlink, TheContractOfAFunctionalLayerIsKept) {
  DdsRun files;
  files.take_scenario("confirmed");
  files.change(kHeliv, kHelivElsewhere);
  const auto lease = blackboard::claim_domain();
  ASSERT_TRUE(lease.has_value());
  const std::string domain = std::to_string(lease->domain());
  Aircraft aircraft(files, "heliv", GetParam(), domain, "10");

  const std::string log = files.file("check.log").string();
  auto check =
      Process::start({kPrograms + "/skein", "functional", files.file("scenario.yaml").string(),
                      "--uav", "heliv", "--domain", domain, "--rate", "10"},
                     log);
  ASSERT_TRUE(check.has_value());
  const auto status = end_of(*check, 150);

  ASSERT_TRUE(status.has_value()) << run_tool::tail_of(log, 30) << aircraft.log();
  EXPECT_EQ(status->code, 0) << run_tool::tail_of(log, 30) << aircraft.log();
  EXPECT_THAT(run_tool::tail_of(log, 30), HasSubstr("18 of 18 points kept by 'autopilot'"));
  EXPECT_TRUE(aircraft.bridge_ends()) << "the clock has ended";
}

/// Planned on board at degree 4: takeoff, a sweep with the device on, home, landing.
constexpr const char* kMission = R"(scenario: mavlink
epoch: 2026-05-19T09:00:00Z
duration_limit: 900
world:
  include: SCENARIOS/worlds/lousa.yaml
  zones:
    orchard: [[100, 50], [250, 50], [250, 150], [100, 150]]
  places:
    gate: [100, 20]
uavs:
  marvin: {model: SCENARIOS/comets/models/marvin.yaml, start: [0, 0], degree: 4, functional: autopilot}
planning:
  domain: SCENARIOS/domains/comets.lisp
  altitude: 50
  voxel: 20
ground:
  position: [-20, -20, 8]
  script:
    - step: search
      when: {time: 5}
      do:
        - mission: {uav: marvin, id: 1, tasks: [{id: 1, task: [perform-detection, orchard, gate, 200]}, {id: 2, task: [general-land]}]}
    - step: end
      when: {goal: {uav: marvin, id: 2, state: achieved}}
      do: [{finish: true}]
expect:
  - {name: the orchard was searched, event: {kind: goal, goal: 1, state: achieved}}
  - {name: Marvin is down at the end, finally: {kind: telemetry, uav: marvin}, is: {airborne: false}}
)";

TEST(DdsMavlinkMission, OnePlannedOnBoardIsFlownThroughTheBridge) {
  DdsRun run;
  std::ofstream(run.file("scenario.yaml")) << kMission;
  run.change("SCENARIOS", std::string(SKEIN_SOURCE_DIR) + "/scenarios");
  const auto lease = blackboard::claim_domain();
  ASSERT_TRUE(lease.has_value());
  const std::string domain = std::to_string(lease->domain());
  Aircraft aircraft(run, "marvin", "ardupilot", domain, "10");

  run.start({"--rate", "10", "--domain", domain, "--without", "autopilot"});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value()) << aircraft.log();
  EXPECT_EQ(status->code, 0) << run.output() << aircraft.log();
  EXPECT_THAT(run.output(), HasSubstr("2 of 2 expectations met"));
  EXPECT_GT(run.count("functional", "type", "goto"), 0U);
  EXPECT_GT(run.count("functional", "type", "takeshot"), 0U);
  for (const journal::Record& line : run.records()) {
    if (line.kind() == "functional") {
      EXPECT_EQ(line.node(), "autopilot");
    }
  }
  EXPECT_TRUE(aircraft.bridge_ends());
}

TEST(DdsMavlinkRefusals, WhatItCannotFlyIsRefusedBeforeAnythingIsStarted) {
  DdsRun files;
  files.take_scenario("confirmed");
  files.change("karma: {model:", "karma: {functional: autopilot, model:");
  const std::string log = files.file("bridge.log").string();
  auto bridge = Process::start(
      {kPrograms + "/skein-mavlink", "--scenario", files.file("scenario.yaml").string(), "--uav",
       "karma", "--dialect", "betaflight"},
      log);
  ASSERT_TRUE(bridge.has_value());
  const auto status = end_of(*bridge, 20);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 2);
  EXPECT_THAT(run_tool::tail_of(log, 5), HasSubstr("cannot hover"));
  EXPECT_THAT(run_tool::tail_of(log, 5), HasSubstr("--dialect 'betaflight'"));
}

}  // namespace
}  // namespace skein::testing
