// SPDX-License-Identifier: Apache-2.0
// The channels to and from one peer, and what follows from their condition.
#include "line.hpp"

#include <gtest/gtest.h>

#include "testing/samples.hpp"

namespace skein::blackboard {
namespace {

constexpr Duration kBeat = Duration::milliseconds(200);

class LineToAUav : public ::testing::Test {
 protected:
  /// The channel to the UAV declares this capacity.
  Line line(double capacity = 0, bool parts = true) {
    config.heartbeat_period = kBeat;
    config.channels = {channel(1, 2), channel(2, 1)};
    config.channels[0].capacity = capacity;
    if (parts) config.channels[0].slots.push_back(wire::Slot::kPart);
    return Line({NodeNumber(2), ChannelKind::kRadio, 0, 1}, config);
  }
  static ChannelConfig channel(std::uint32_t from, std::uint32_t to) {
    ChannelConfig channel;
    channel.from = NodeNumber(from);
    channel.to = NodeNumber(to);
    channel.slots = {wire::Slot::kAutonomyDegree, wire::Slot::kTaskEvent, wire::Slot::kHandOver};
    return channel;
  }
  static ChannelCondition up(double capacity = 0) {
    ChannelCondition condition;
    condition.capacity = capacity;
    return condition;
  }
  static ChannelCondition down() { return {.up = false, .latency = {}}; }

  Config config;
};

/// A hand-over that takes so many bytes on a channel.
wire::Sample event_of(std::size_t bytes) {
  const std::size_t bare = channel_bytes(testing::hand_over(1, 0));
  for (std::size_t content = bytes - bare;; --content) {
    wire::Sample event = testing::hand_over(1, content);
    if (channel_bytes(event) <= bytes) return event;
  }
}

wire::Sample state_of(std::size_t bytes) {
  wire::AutonomyDegree state = testing::degree(4);
  state.contact_policy = std::string(bytes, 'a');
  return state;
}

TEST_F(LineToAUav, TakesTurnsAtTheCapacityThatIsDeclaredOrInForce) {
  EXPECT_NE(line(9600).limited(), nullptr);
  Line wide = line();
  EXPECT_EQ(wide.limited(), nullptr);

  wide.set_outgoing(up(19'200), {});
  ASSERT_NE(wide.limited(), nullptr);
  EXPECT_EQ(wide.limited()->capacity(), 19'200);
  wide.set_outgoing(down(), {});
  EXPECT_NE(wide.limited(), nullptr) << "what waits, waits on";
  wide.set_outgoing(up(), {});
  EXPECT_EQ(wide.limited(), nullptr);
}

TEST_F(LineToAUav, GoesBackToTheCapacityThatIsDeclared) {
  Line narrow = line(9600);
  narrow.set_outgoing(up(19'200), {});
  EXPECT_EQ(narrow.limited()->capacity(), 19'200);
  narrow.set_outgoing(up(), {});
  EXPECT_EQ(narrow.limited()->capacity(), 9600);
}

TEST_F(LineToAUav, CarriesWhileItsChannelIsUpOrThereAreRelays) {
  Line one = line();
  EXPECT_TRUE(one.can_send());
  one.set_outgoing(down(), {});
  EXPECT_FALSE(one.can_send());
  one.set_way(1, true);
  EXPECT_TRUE(one.is_relayed());
  EXPECT_TRUE(one.can_send());
  one.set_way(0, true);
  EXPECT_FALSE(one.can_send());
}

TEST_F(LineToAUav, WhoIsHeardOfIsWaitedForTwiceAsLong) {
  Line one = line();
  EXPECT_EQ(one.silence_limit(), Duration::milliseconds(600));
  one.set_way(0, true);
  EXPECT_EQ(one.silence_limit(), Duration::milliseconds(1200));
}

TEST_F(LineToAUav, ARoundTripTakesTheLatencyOfBothWaysTheirCapacitiesAndTheRelays) {
  Line one = line(9600);
  config.channels[1].capacity = 4800;
  one.set_outgoing({.up = true, .latency = Duration::milliseconds(30)}, {});
  one.set_incoming({.up = true, .latency = Duration::milliseconds(50)});
  one.set_way(2, true);

  const RoundTrip trip = one.round_trip();
  EXPECT_EQ(trip.latency, Duration::milliseconds(80));
  EXPECT_EQ(trip.out, 9600);
  EXPECT_EQ(trip.back, 4800);
  EXPECT_EQ(trip.relays, 2U);
  EXPECT_EQ(trip.period, kBeat);
  one.set_incoming(up(2400));
  EXPECT_EQ(one.round_trip().back, 2400);
}

TEST_F(LineToAUav, AnEventIsLongIfItTakesMoreThanTwoPeriodsOfWhatIsDeclared) {
  EXPECT_FALSE(line().is_long_event(event_of(16'384)));
  EXPECT_TRUE(line().is_long_event(event_of(16'400)));
  EXPECT_FALSE(line(64'000).is_long_event(event_of(3'200)));
  EXPECT_TRUE(line(64'000).is_long_event(event_of(3'216)));
  EXPECT_FALSE(line(9600).is_long_event(event_of(1'024)));
  EXPECT_TRUE(line(9600).is_long_event(event_of(1'040)));
}

TEST_F(LineToAUav, NothingIsLongWhereNoPartsGo) {
  const Line one = line(9600, false);

  EXPECT_FALSE(one.is_long_event(event_of(20'000)));
  EXPECT_FALSE(one.is_long_state(state_of(20'000)));
}

TEST_F(LineToAUav, APartTakesAQuarterOfASecondWithinBounds) {
  EXPECT_EQ(line(96'000).bytes_of_a_part(), 3'000U);
  EXPECT_EQ(line(9'600).bytes_of_a_part(), 512U);
  EXPECT_EQ(line(1e6).bytes_of_a_part(), 4'096U);
  EXPECT_EQ(line().bytes_of_a_part(), 4'096U);
}

TEST_F(LineToAUav, AStateIsLongIfItTakesMoreThanTwoParts) {
  const Line one = line(9'600);

  EXPECT_FALSE(one.is_long_state(state_of(512)));
  EXPECT_TRUE(one.is_long_state(state_of(1'024)));
  EXPECT_FALSE(one.is_long_state(event_of(2'048)));
}

}  // namespace
}  // namespace skein::blackboard
