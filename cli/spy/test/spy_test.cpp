// SPDX-License-Identifier: Apache-2.0
// The spy against a node on a real domain of its own.
#include "skein/spy_tool/spy.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/node/roster.hpp"
#include "skein/node/waker.hpp"

namespace skein::spy_tool {
namespace {

using blackboard::Now;

// A ground station of either vendor that has published its directory entry and a mission state.
class SpyOnANode : public ::testing::TestWithParam<blackboard::DdsVendor> {
 protected:
  void SetUp() override {
    auto lease = blackboard::claim_domain();
    ASSERT_TRUE(lease.has_value()) << lease.error().why;
    lease_.emplace(std::move(*lease));
    options_.domain = lease_->domain();
    open();
  }

  /// The board of the ground station; its radio carries so many bit/s, 0: any.
  void open(double capacity = 0) {
    board_.reset();
    transport_.reset();
    blackboard::DdsConfig dds{lease_->domain(), "ground", {}, {}};
    dds.network.dds = GetParam();
    dds.network.types = GetParam() == blackboard::DdsVendor::kCycloneDds;
    transport_ = blackboard::make_dds_transport(std::move(dds));
    const node::Roster roster({"marvin"});
    blackboard::Config config;
    config.self = roster.ground();
    config.channels = roster.channels_of(*roster.find("ground"));
    for (blackboard::ChannelConfig& channel : config.channels) {
      if (channel.kind == blackboard::ChannelKind::kRadio) channel.capacity = capacity;
    }
    auto board = blackboard::Blackboard::open(config, *transport_);
    ASSERT_TRUE(board.has_value()) << board.error().why;
    board_.emplace(std::move(*board));
    wire::DirectoryEntry entry;
    entry.name = "ground";
    entry.role = wire::Role::kGround;
    ASSERT_TRUE(board_->publish(entry, Now{{}, node::Waker::steady_now()}).has_value());
    wire::MissionState state;
    state.phase = "Detection";
    ASSERT_TRUE(board_->publish(state, Now{{}, node::Waker::steady_now()}).has_value());
  }

  std::optional<blackboard::DomainLease> lease_;
  std::unique_ptr<blackboard::Transport> transport_;
  std::optional<blackboard::Blackboard> board_;
  SpyOptions options_;
  std::ostringstream out_;
  std::ostringstream err_;
};

TEST_P(SpyOnANode, PrintsTheSampleAskedFor) {
  options_.slots = {"MissionState"};
  options_.count = 1;
  options_.duration = 20;
  options_.json = true;

  options_.verb = Verb::kEcho;
  EXPECT_EQ(spy(options_, out_, err_), kExitOk) << err_.str();

  const auto line = nlohmann::json::parse(out_.str());
  EXPECT_EQ(line["phase"], "Detection");
  EXPECT_EQ(line["header"]["origin"], 1);
}

TEST_P(SpyOnANode, ListsNodesAndSlotsAsJson) {
  options_.duration = 1.5;
  options_.json = true;

  EXPECT_EQ(spy(options_, out_, err_), kExitOk) << err_.str();

  const auto document = nlohmann::json::parse(out_.str());
  ASSERT_EQ(document["nodes"].size(), 1U);
  EXPECT_EQ(document["nodes"][0]["name"], "ground");
  bool phase_seen = false;
  for (const auto& slot : document["slots"]) phase_seen |= slot["slot"] == "MissionState";
  EXPECT_TRUE(phase_seen);
}

TEST_P(SpyOnANode, HearsNothingInAPartitionWithoutWriters) {
  options_.partitions = {"radio/nobody>nowhere"};
  options_.duration = 0.5;

  EXPECT_EQ(spy(options_, out_, err_), kExitTimeout);
  EXPECT_NE(err_.str().find("nothing heard: no writer: "), std::string::npos) << err_.str();
}

TEST_P(SpyOnANode, PrintsOneFieldOfTheLastValueOnce) {
  options_.verb = Verb::kEcho;
  options_.slots = {"MissionState"};
  options_.fields = {"phase"};
  options_.where = "finished == false && header.origin == 1";
  options_.count = 1;
  options_.timeout = 20;

  EXPECT_EQ(spy(options_, out_, err_), kExitOk) << err_.str();

  EXPECT_EQ(out_.str(), "Detection\n");
}

TEST_P(SpyOnANode, SaysThatAWriterIsThereAndSilent) {
  options_.verb = Verb::kEcho;
  options_.slots = {"GroundBoard"};
  options_.timeout = 2;

  EXPECT_EQ(spy(options_, out_, err_), kExitTimeout);

  EXPECT_NE(err_.str().find("silent writer: 1 writers of GroundBoard"), std::string::npos)
      << err_.str();
}

TEST_P(SpyOnANode, ListsTopicsWithoutReadingThem) {
  options_.verb = Verb::kTopics;
  options_.slots = {"Mission*"};
  options_.json = true;

  EXPECT_EQ(spy(options_, out_, err_), kExitOk) << err_.str();

  bool found = false;
  std::istringstream lines(out_.str());
  for (std::string line; std::getline(lines, line);) {
    const auto topic = nlohmann::json::parse(line);
    found = found || (topic["topic"] == "MissionState" && topic["writers"] == 1);
  }
  EXPECT_TRUE(found) << out_.str();
}

TEST_P(SpyOnANode, OverANarrowRadioSeesAnEndpointFromItsFirstUseOn) {
  open(50'000);
  options_.verb = Verb::kTopics;
  options_.slots = {"TaskRequest"};
  options_.duration = 1;
  options_.json = true;
  spy(options_, out_, err_);
  EXPECT_EQ(out_.str(), "");

  wire::TaskRequest request;
  const blackboard::NodeNumber marvin = node::Roster({"marvin"}).find("marvin")->number;
  ASSERT_TRUE(board_->send(request, marvin, Now{{}, node::Waker::steady_now()}).has_value());
  options_.duration = 4;
  spy(options_, out_, err_);

  EXPECT_EQ(nlohmann::json::parse(out_.str())["writers"], 1) << err_.str();
}

TEST_P(SpyOnANode, ListsTheProgramsWithTheirVersionAndProcess) {
  options_.verb = Verb::kNodes;
  options_.json = true;

  EXPECT_EQ(spy(options_, out_, err_), kExitOk) << err_.str();

  const auto node = nlohmann::json::parse(out_.str());
  EXPECT_EQ(node["node"], "ground");
  EXPECT_EQ(node["role"], "ground");
  EXPECT_EQ(node["vendor"], name_of(GetParam()));
  EXPECT_FALSE(node["version"].is_null());
  EXPECT_GT(node["writers"], 0);
}

TEST_P(SpyOnANode, TheDoctorFindsNothingBad) {
  options_.verb = Verb::kDoctor;

  EXPECT_EQ(spy(options_, out_, err_), kExitOk) << out_.str();

  EXPECT_NE(out_.str().find("good  schemas: all programs of ours"), std::string::npos)
      << out_.str();
}

INSTANTIATE_TEST_SUITE_P(Dds, SpyOnANode,
                         ::testing::Values(blackboard::DdsVendor::kFastDds,
                                           blackboard::DdsVendor::kCycloneDds),
                         [](const auto& vendor) { return std::string(name_of(vendor.param)); });

TEST(Spy, TheDoctorSaysWhyDdsCannotBeUsed) {
  SpyOptions options;
  options.verb = Verb::kDoctor;
  options.duration = 0.1;
  options.network.interfaces = {"10.254.253.252"};
  std::ostringstream out, err;

  EXPECT_EQ(spy(options, out, err), kExitNegative);

  EXPECT_NE(out.str().find("BAD   interface: no interface has address 10.254.253.252"),
            std::string::npos)
      << out.str();
}

TEST(Spy, AWrongSlotIsRefusedWithTheNearest) {
  SpyOptions options;
  options.slots = {"Telemtry"};
  std::ostringstream out, err;

  options.verb = Verb::kEcho;
  EXPECT_EQ(spy(options, out, err), kExitBadInput);

  EXPECT_NE(err.str().find("did you mean 'Telemetry'?"), std::string::npos);
}

}  // namespace
}  // namespace skein::spy_tool
