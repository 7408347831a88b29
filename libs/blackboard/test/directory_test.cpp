// SPDX-License-Identifier: Apache-2.0
// The peers of a node, found in its channels and met later.
#include "directory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace skein::blackboard {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

const Node kSelf{NodeNumber(1), "ground"}, kHeliv{NodeNumber(2), "heliv"},
    kMarvin{NodeNumber(3), "marvin"};

/// Counts the channels that were added.
class Counting final : public Transport {
 public:
  explicit Counting(std::size_t channels) : channels_(channels) {}
  Result<void, Failure> open(const TransportPlan&) override { return {}; }
  Result<std::size_t, Failure> add(const ChannelConfig&) override { return channels_++; }
  bool write(std::size_t, const wire::Sample&) override { return true; }
  Result<void, Failure> set_up(std::size_t, bool) override { return {}; }
  std::vector<Arrival> take() override { return {}; }
  void on_arrival(std::function<void()>) override {}
  std::size_t channels() const { return channels_; }

 private:
  std::size_t channels_;
};

/// Of the ground, which has a link with heliv, and with marvin if it is met.
class DirectoryOfTheGround : public ::testing::Test {
 protected:
  static Config ground() {
    Config config;
    config.self = kSelf.number;
    config.channels = radio_link(kSelf, kHeliv);
    config.channels_with = [](NodeNumber number) {
      return number == kMarvin.number ? radio_link(kSelf, kMarvin) : std::vector<ChannelConfig>();
    };
    return config;
  }
  std::size_t from(NodeNumber node) const {
    const auto found = std::ranges::find(config.channels, node, &ChannelConfig::from);
    return static_cast<std::size_t>(found - config.channels.begin());
  }

  Config config = ground();
  Counting transport{config.channels.size()};
  Directory directory{config, transport};
};

wire::SampleHeader of(NodeNumber origin) {
  wire::SampleHeader header;
  header.origin = origin.value();
  return header;
}

TEST_F(DirectoryOfTheGround, FindsThePeersInItsChannels) {
  ASSERT_TRUE(directory.open());

  const Peer* heliv = directory.find(kHeliv.number);
  ASSERT_NE(heliv, nullptr);
  EXPECT_EQ(config.channels[heliv->channels().outgoing].to, kHeliv.number);
  EXPECT_EQ(config.channels[heliv->channels().incoming].from, kHeliv.number);
  EXPECT_EQ(directory.over(heliv->channels().incoming), heliv);
  EXPECT_EQ(directory.over(heliv->channels().outgoing), nullptr);
  EXPECT_EQ(directory.find(kSelf.number), nullptr);
  EXPECT_EQ(directory.find(kMarvin.number), nullptr);
  EXPECT_EQ(directory.all().size(), 1U);
  EXPECT_FALSE(directory.world());
}

TEST_F(DirectoryOfTheGround, WhoIsFoundIsDueAtOnce) {
  ASSERT_TRUE(directory.open());

  EXPECT_THAT(directory.agenda().due({MissionTime(), Duration()}), ElementsAre(kHeliv.number));
}

TEST_F(DirectoryOfTheGround, WhoIsMetGetsChannelsOnceAndTheyAreDown) {
  ASSERT_TRUE(directory.open());
  Peer* heliv = directory.find(kHeliv.number);

  Peer* marvin = directory.meet(kMarvin.number, {});

  ASSERT_NE(marvin, nullptr);
  EXPECT_FALSE(marvin->line().outgoing().up);
  EXPECT_FALSE(marvin->line().incoming().up);
  EXPECT_EQ(directory.over(from(kMarvin.number)), marvin);
  EXPECT_EQ(directory.meet(kMarvin.number, {}), marvin);
  EXPECT_EQ(transport.channels(), 4U);
  EXPECT_EQ(config.channels.size(), 4U);
  EXPECT_EQ(directory.meet(kHeliv.number, {}), heliv);
  EXPECT_TRUE(heliv->line().outgoing().up);
}

TEST_F(DirectoryOfTheGround, WhoHasNoChannelsIsNoPeer) {
  ASSERT_TRUE(directory.open());

  EXPECT_EQ(directory.meet(kSelf.number, {}), nullptr);
  EXPECT_EQ(directory.meet(NodeNumber(9), {}), nullptr);
  config.channels_with = nullptr;
  EXPECT_EQ(directory.meet(kMarvin.number, {}), nullptr);
  EXPECT_EQ(transport.channels(), 2U);
}

TEST_F(DirectoryOfTheGround, TheOriginOfARelayedSampleIsAnotherThanWhoSpeaks) {
  ASSERT_TRUE(directory.open());
  Peer* marvin = directory.meet(kMarvin.number, {});
  const std::size_t over_heliv = from(kHeliv.number);

  EXPECT_EQ(directory.origin(over_heliv, of(kHeliv.number)), directory.find(kHeliv.number));
  EXPECT_EQ(directory.origin(over_heliv, of(kMarvin.number)), marvin);
  EXPECT_EQ(directory.origin(over_heliv, of(NodeNumber(9))), nullptr);
}

TEST_F(DirectoryOfTheGround, APeerIsDueWhenItWasPlannedLast) {
  ASSERT_TRUE(directory.open());
  Peer* heliv = directory.find(kHeliv.number);
  heliv->set_outgoing({.up = false, .latency = {}}, {});
  EXPECT_TRUE(directory.agenda().next_due());

  directory.plan(*heliv);

  EXPECT_FALSE(directory.agenda().next_due());
}

TEST(Directory, SaysWhichChannelsMakeNoSense) {
  const auto problem = [](std::vector<ChannelConfig> channels) {
    Config config;
    config.self = kSelf.number;
    config.channels = std::move(channels);
    Counting transport(config.channels.size());
    const auto opened = Directory(config, transport).open();
    return opened ? std::string() : opened.error().why;
  };
  auto one_way = radio_link(kSelf, kHeliv);
  std::erase_if(one_way, [](const auto& channel) { return channel.to == kSelf.number; });
  auto twice = radio_link(kSelf, kHeliv);
  for (const ChannelConfig& channel : radio_link(kSelf, kHeliv)) twice.push_back(channel);

  EXPECT_EQ(problem(one_way), "no channel back for radio/ground>heliv");
  EXPECT_EQ(problem(twice), "two channels to node 2");
  EXPECT_EQ(problem(radio_link(kHeliv, kMarvin)),
            "channel radio/heliv>marvin neither starts nor ends at this node");
  EXPECT_EQ(problem({world_channel(), world_channel()}), "two world channels");
  EXPECT_EQ(problem({world_channel()}), "");
}

}  // namespace
}  // namespace skein::blackboard
