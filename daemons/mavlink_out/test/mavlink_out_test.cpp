// SPDX-License-Identifier: Apache-2.0
// From samples and records to datagrams.
#include "skein/mavlink_out/mavlink_out.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "skein/mavlink/parser.hpp"

namespace skein::mavlink_out {
namespace {

using ::testing::ElementsAre;
using ::testing::IsSupersetOf;

class Station : public ::testing::Test {
 protected:
  Station() {
    socket_ = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in any{};
    any.sin_family = AF_INET;
    any.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&any), sizeof any), 0);
    socklen_t size = sizeof any;
    getsockname(socket_, reinterpret_cast<sockaddr*>(&any), &size);
    AnnouncerConfig config;
    config.vehicles = {{"marvin"}, {"karma"}};
    auto opened = MavlinkOut::open("udp:127.0.0.1:" + std::to_string(ntohs(any.sin_port)), config);
    EXPECT_TRUE(opened.has_value());
    if (opened) out_ = std::move(*opened);
  }
  ~Station() override { close(socket_); }

  void telemetry(const std::string& uav, double at, std::vector<std::string> failed = {}) {
    wire::Telemetry sample;
    sample.header.mission_time = MissionTime::seconds(at).count();
    sample.uav = uav;
    sample.energy = 0.5;
    sample.failed = std::move(failed);
    out_->sees(wire::Sample(sample));
  }
  /// What has come to the station: system and type, and the words of texts.
  std::vector<std::string> turn(double now) {
    node::DaemonState state;
    state.now.steady = Duration::seconds(now);
    out_->turn(state);
    std::vector<std::string> all;
    std::array<std::uint8_t, 2048> datagram{};
    for (;;) {
      const auto size = recv(socket_, datagram.data(), datagram.size(), MSG_DONTWAIT);
      if (size <= 0) return all;
      for (const auto& frame :
           parser_.take(std::span(datagram).first(static_cast<std::size_t>(size))))
        all.push_back(std::to_string(frame.from.system) + " " + said(frame));
    }
  }
  static std::string said(const mavlink::Frame& frame) {
    const auto message = mavlink::to_message(frame);
    if (!message) return "?";
    if (const auto* text = std::get_if<mavlink::StatusText>(&*message))
      return mavlink::text_of(*text);
    return std::visit([](const auto& one) { return std::string(one.kName); }, *message);
  }

  int socket_ = -1;
  std::unique_ptr<MavlinkOut> out_;
  mavlink::Parser parser_;
};

TEST_F(Station, HearsEveryUavThatIsHeard) {
  telemetry("karma", 1);
  EXPECT_THAT(turn(0), ElementsAre("2 HEARTBEAT", "2 SYS_STATUS", "2 BATTERY_STATUS",
                                   "2 EXTENDED_SYS_STATE", "2 GLOBAL_POSITION_INT", "2 ATTITUDE"));

  telemetry("marvin", 2);
  EXPECT_THAT(turn(0.3), IsSupersetOf({"1 HEARTBEAT", "1 GLOBAL_POSITION_INT"}));
}

TEST_F(Station, IsToldAlarmsAndRefusals) {
  telemetry("marvin", 1);
  out_->sees(journal::Record(MissionTime::seconds(1), "ground", "alarm")
                 .with("alarm", 7)
                 .with("state", "raised"));
  out_->sees(journal::Record(MissionTime::seconds(1), "ground", "command")
                 .with("uav", "marvin")
                 .with("state", "refused")
                 .with("what", "plan")
                 .with("why", "busy"));
  out_->sees(journal::Record(MissionTime::seconds(1), "ground", "link"));

  const auto said = turn(0);

  EXPECT_THAT(said, IsSupersetOf({"1 alarm 7 raised"}));
  EXPECT_THAT(said, IsSupersetOf({"1 command to marvin refused: plan: busy"}));
}

TEST_F(Station, IsToldEachDecisionOnce) {
  telemetry("karma", 1);
  wire::UavTasks tasks;
  tasks.uav = "karma";
  tasks.decisions = {{3, "repair", "late", "shifted", 0}, {4, "insert", "mission 1", "", 0}};
  out_->sees(wire::Sample(tasks));
  out_->sees(wire::Sample(tasks));
  auto said = turn(0);
  EXPECT_EQ(std::count(said.begin(), said.end(), "2 decides repair because of late: shifted"), 1);

  tasks.decisions[1].outcome = "planned";
  out_->sees(wire::Sample(tasks));
  EXPECT_THAT(turn(0.1), ElementsAre("2 decides insert because of mission 1: planned"));
}

TEST_F(Station, IsToldWhatFailsOnBoardOnce) {
  telemetry("marvin", 1, {"engine"});
  telemetry("marvin", 2, {"engine"});
  const auto said = turn(0);

  EXPECT_EQ(std::count(said.begin(), said.end(), "1 engine does not work"), 1);
}

TEST_F(Station, MayBeGone) {
  close(socket_);
  socket_ = socket(AF_INET, SOCK_DGRAM, 0);
  for (int i = 0; i < 20; ++i) {
    telemetry("marvin", i);
    EXPECT_THAT(turn(i), ::testing::IsEmpty());
  }
}

TEST(MavlinkOut, AnAddressThatIsNoneIsRefused) {
  const auto opened = MavlinkOut::open("tcp:1.2.3.4:5", {});

  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().why, ::testing::HasSubstr("expected udpin:"));
}

TEST(AnnouncerConfigOf, HasTheUavsOfTheScenarioInTheirOrderWhereTheyStart) {
  scenario::Scenario scenario;
  scenario.world.terrain.west = scenario.world.terrain.south = -100;
  scenario.world.terrain.east = scenario.world.terrain.north = 100;
  scenario.world.terrain.base = 17;
  scenario.rate = 4;
  scenario.uavs.resize(2);
  scenario.uavs[0].name = "b";
  scenario.uavs[1].name = "a";

  const auto config = announcer_config_of(scenario, 48);

  ASSERT_TRUE(config.has_value());
  EXPECT_EQ(config->vehicles[0].name, "b");
  EXPECT_EQ(config->vehicles[1].home, 17);
  EXPECT_EQ(config->rate, 4);
  EXPECT_EQ(config->geoid, 48);
}

TEST(AnnouncerConfigOf, MoreUavsThanSystemIdsAreRefused) {
  scenario::Scenario scenario;
  scenario.world.terrain.west = scenario.world.terrain.south = -100;
  scenario.world.terrain.east = scenario.world.terrain.north = 100;
  scenario.uavs.resize(251);

  EXPECT_FALSE(announcer_config_of(scenario, 0).has_value());
}

}  // namespace
}  // namespace skein::mavlink_out
