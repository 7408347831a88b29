// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/network.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::blackboard {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(NetworkAddress, HasAPortOrNot) {
  EXPECT_EQ(parse_address("10.0.0.2")->address, "10.0.0.2");
  EXPECT_EQ(parse_address("10.0.0.2")->port, 0U);
  EXPECT_EQ(parse_address("10.0.0.2:9160")->address, "10.0.0.2");
  EXPECT_EQ(parse_address("10.0.0.2:9160")->port, 9160U);
}

TEST(NetworkAddress, IsNothingElse) {
  for (const char* text : {"", "10.0.0", "10.0.0.256", "uav1", "::1", "10.0.0.2:", "10.0.0.2:0",
                           "10.0.0.2:65536", "10.0.0.2:-1", "10.0.0.2:9160x", ":9160"}) {
    EXPECT_FALSE(parse_address(text)) << text;
  }
}

TEST(NetworkConfig, TheDefaultHasNoProblems) { EXPECT_THAT(problems_of({}), IsEmpty()); }

TEST(NetworkConfig, EveryProblemIsToldAtOnce) {
  NetworkConfig network;
  network.interfaces = {"eth0", "10.0.0.1:7"};
  network.peers = {"10.0.0.2", "10.0.0.2:9160", "marvin"};
  network.discovery_servers = {"10.0.0.9:11811", "10.0.0.9"};

  EXPECT_THAT(problems_of(network),
              ElementsAre("interface 'eth0' is not an IPv4 address, or one with :PORT",
                          "interface '10.0.0.1:7' has a port",
                          "peer 'marvin' is not an IPv4 address, or one with :PORT",
                          "discovery server '10.0.0.9' has no port"));
}

TEST(NetworkConfig, VendorsHaveNamesThatLeadBackToThem) {
  EXPECT_EQ(dds_names(), (std::vector<std::string>{"fastdds", "cyclonedds"}));
  for (const std::string& name : dds_names()) EXPECT_EQ(name_of(dds_from_name(name).value()), name);
  EXPECT_FALSE(dds_from_name("opendds"));
}

TEST(NetworkConfig, WhatCycloneCannotDoIsSaid) {
  NetworkConfig network;
  network.discovery_servers = {"10.0.0.1:11811"};
  network.keys = "keys/marvin";
  EXPECT_TRUE(problems_of(network).empty());

  network.dds = DdsVendor::kCycloneDds;

  EXPECT_EQ(problems_of(network).size(), 2U);

  network = {};
  network.dds = DdsVendor::kCycloneDds;
  network.interfaces = {"10.0.0.2", "10.0.1.2"};
  EXPECT_TRUE(problems_of(network).empty());
  network.interfaces.emplace_back("127.0.0.1");
  EXPECT_EQ(problems_of(network).size(), 1U);
}

TEST(NetworkConfig, TypesAreAnnouncedOverCycloneAlone) {
  NetworkConfig network;
  network.types = true;
  network.dds = DdsVendor::kCycloneDds;
  EXPECT_TRUE(problems_of(network).empty());

  network.dds = DdsVendor::kFastDds;

  ASSERT_EQ(problems_of(network).size(), 1U);
  EXPECT_NE(problems_of(network)[0].find("--types"), std::string::npos);
}

}  // namespace
}  // namespace skein::blackboard
