// SPDX-License-Identifier: Apache-2.0
// One reader of all heartbeats over radio: which channels it serves, and on which one each came.
#include "adapters/rtps/heartbeat_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "adapters/rtps/links.hpp"
#include "skein/blackboard/observer.hpp"

namespace skein::blackboard::rtps {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using wire::Slot;

const Node kMarvin{NodeNumber(1), "marvin"}, kKarma{NodeNumber(2), "karma"},
    kHero{NodeNumber(3), "hero"}, kGround{NodeNumber(4), "ground"};

/// Marvin's channels: the world (0), then to and from karma (1, 2), hero (3, 4), ground (5, 6).
TransportPlan marvins_plan() {
  TransportPlan plan{kMarvin.number, {world_channel()}, {Slot::kClock}};
  for (const Node& peer : {kKarma, kHero})
    for (const ChannelConfig& one : radio_link(kMarvin, peer)) plan.channels.push_back(one);
  const auto station = station_link(kGround, kMarvin);
  plan.channels.push_back(station[1]);
  plan.channels.push_back(station[0]);
  return plan;
}

Arrival heartbeat(NodeNumber origin, std::vector<std::uint32_t> via = {}) {
  wire::Heartbeat heartbeat;
  heartbeat.header.origin = origin.value();
  heartbeat.header.via = std::move(via);
  return {7, wire::Sample(heartbeat)};
}

TEST(ReaderOfHeartbeats, ServesWhatComesOverRadioAndNothingElse) {
  const auto plan = marvins_plan();
  const auto reader = HeartbeatReader::of(plan, {});
  ASSERT_TRUE(reader.has_value());
  std::vector<std::size_t> covered;
  for (std::size_t i = 0; i < plan.channels.size(); ++i)
    if (reader->covers(i)) covered.push_back(i);
  EXPECT_THAT(covered, ElementsAre(2, 4, 6));
  EXPECT_THAT(reader->link().reads, ElementsAre(Slot::kHeartbeat));
  EXPECT_THAT(reader->link().writes, IsEmpty());
  EXPECT_FALSE(reader->link().waits_to_read(Slot::kHeartbeat));
}

TEST(ReaderOfHeartbeats, IsInThePartitionsOfThoseChannelsAlone) {
  const auto plan = marvins_plan();
  const auto reader = HeartbeatReader::of(plan, {});
  ASSERT_TRUE(reader.has_value());
  for (std::size_t i = 0; i < plan.channels.size(); ++i)
    EXPECT_EQ(partitions_meet({reader->link().config.partition}, {plan.channels[i].partition}),
              reader->covers(i))
        << plan.channels[i].partition;
  for (const char* const other : {"radio/karma>marvin2", "radio/marvin>karma", "onboard/marvin"})
    EXPECT_FALSE(partitions_meet({reader->link().config.partition}, {other})) << other;
}

TEST(ReaderOfHeartbeats, KnowsByTheHeaderWhichChannelOneCameOver) {
  const auto reader = HeartbeatReader::of(marvins_plan(), {});
  ASSERT_TRUE(reader.has_value());
  EXPECT_EQ(reader->channel_of(heartbeat(kKarma.number)), 2U);
  EXPECT_EQ(reader->channel_of(heartbeat(kGround.number)), 6U);
  EXPECT_EQ(reader->channel_of(heartbeat(kGround.number, {2, 3})), 4U) << "hero passed it on last";
  EXPECT_EQ(reader->channel_of(heartbeat(NodeNumber(99))), 2U) << "a stranger, to be named";
  EXPECT_EQ(reader->channel_of({7, Malformed{Slot::kHeartbeat, {}, {"header", "short"}}}), 2U);
}

TEST(ReaderOfHeartbeats, IsNotThereWithKeysAndForSpies) {
  DdsConfig secured, at_once;
  secured.network.keys = "keys/marvin";
  at_once.endpoints_at_once = true;
  EXPECT_FALSE(HeartbeatReader::of(marvins_plan(), secured).has_value());
  EXPECT_FALSE(HeartbeatReader::of(marvins_plan(), at_once).has_value());
  EXPECT_FALSE(HeartbeatReader::of({kMarvin.number, {world_channel()}, {}}, {})) << "no radio";
  TransportPlan spy = marvins_plan();
  for (ChannelConfig& channel : spy.channels)
    if (channel.kind == ChannelKind::kRadio) channel.partition = "radio/*";
  EXPECT_FALSE(HeartbeatReader::of(spy, {}).has_value());
}

// ---- among the links of a node ----

/// Notes which readers each channel has; it writes nothing.
class NotedEndpoints final : public Endpoints {
 public:
  explicit NotedEndpoints(std::vector<Slot>& readers) : readers_(readers) {}
  Result<void, Failure> open() override { return {}; }
  Result<void, Failure> add_writer(Slot /*slot*/) override { return {}; }
  Result<void, Failure> add_reader(Slot slot) override {
    readers_.push_back(slot);
    return {};
  }
  Result<void, Failure> close() override {
    readers_.clear();
    return {};
  }
  bool write(const wire::Sample& /*sample*/) override { return true; }
  void flush(Clock::time_point /*until*/) override {}

 private:
  std::vector<Slot>& readers_;
};

class LinksOfANode : public ::testing::Test {
 protected:
  LinksOfANode() {
    links_.plan(marvins_plan(), {});
    const auto opened = links_.open([this](std::size_t channel, const LinkPlan& /*link*/) {
      return std::make_unique<NotedEndpoints>(readers_[channel]);
    });
    EXPECT_TRUE(opened.has_value());
  }
  std::vector<std::size_t> channels_taken() {
    std::vector<std::size_t> channels;
    for (const Arrival& arrival : links_.take()) channels.push_back(arrival.channel);
    return channels;
  }
  std::map<std::size_t, std::vector<Slot>> readers_;  // before the links, which write there
  Links links_;
};

TEST_F(LinksOfANode, HaveOneReaderOfHeartbeatsOverRadio) {
  std::size_t of_heartbeats = 0;
  for (const auto& [channel, slots] : readers_)
    of_heartbeats += static_cast<std::size_t>(std::ranges::count(slots, Slot::kHeartbeat));
  EXPECT_EQ(of_heartbeats, 1U);
  EXPECT_THAT(readers_[7], ElementsAre(Slot::kHeartbeat));
}

TEST_F(LinksOfANode, GiveWhatItReadsOnTheChannelOfWhoSaidItAndNothingOfOneThatIsCut) {
  const auto say = [this](NodeNumber origin) { links_.mailbox().put(heartbeat(origin)); };
  say(kHero.number);
  say(kKarma.number);
  EXPECT_THAT(channels_taken(), ElementsAre(4, 2));

  ASSERT_TRUE(links_.set_up(2, false).has_value());
  say(kHero.number);
  say(kKarma.number);
  EXPECT_THAT(channels_taken(), ElementsAre(4)) << "karma is cut off at this end";
  EXPECT_THAT(readers_[7], ElementsAre(Slot::kHeartbeat)) << "it stays";

  ASSERT_TRUE(links_.set_up(2, true).has_value());
  say(kKarma.number);
  EXPECT_THAT(channels_taken(), ElementsAre(2));
}

}  // namespace
}  // namespace skein::blackboard::rtps
