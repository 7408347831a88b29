// SPDX-License-Identifier: Apache-2.0
#include "connections.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace skein::blackboard {
namespace {

/// Refuses as told, and remembers what it was asked.
class Stubborn final : public Transport {
 public:
  Result<void, Failure> open(const TransportPlan&) override { return {}; }
  bool write(std::size_t, const wire::Sample&) override { return true; }
  Result<void, Failure> set_up(std::size_t channel, bool up) override {
    asked.emplace_back(channel, up);
    if (refuses) return failure("no endpoints left");
    return {};
  }
  std::vector<Arrival> take() override { return {}; }
  void on_arrival(std::function<void()>) override {}

  bool refuses = true;
  std::vector<std::pair<std::size_t, bool>> asked;
};

constexpr Duration kAgain = Duration::milliseconds(200);
constexpr Duration at(std::int64_t ms) { return Duration::milliseconds(ms); }

class ConnectionsOfALink : public ::testing::Test {
 protected:
  Stubborn transport;
  std::vector<ChannelConfig> channels =
      radio_link({NodeNumber(1), "ground"}, {NodeNumber(3), "marvin"});
  Connections connections{transport, channels, kAgain};
  std::vector<Incoming> out;
};

TEST_F(ConnectionsOfALink, WhatIsGrantedIsNotSpokenOf) {
  transport.refuses = false;

  connections.set_up(0, false, at(10), out);

  EXPECT_TRUE(out.empty());
  EXPECT_FALSE(connections.next_due());
}

TEST_F(ConnectionsOfALink, ARefusalIsNamedOnceAndAskedAgainUntilItIsGranted) {
  connections.set_up(1, true, at(10), out);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(std::get<TransportRefused>(out[0]).channel.partition, "radio/marvin>ground");
  EXPECT_EQ(std::get<TransportRefused>(out[0]).why, "no endpoints left");
  EXPECT_EQ(connections.next_due(), at(210));

  connections.update(at(209), out);
  EXPECT_EQ(transport.asked.size(), 1U);
  connections.update(at(210), out);
  EXPECT_EQ(out.size(), 1U);
  EXPECT_EQ(connections.next_due(), at(410));
  transport.refuses = false;
  connections.update(at(410), out);

  EXPECT_EQ(transport.asked, (std::vector<std::pair<std::size_t, bool>>(3, {1, true})));
  EXPECT_FALSE(connections.next_due());
}

TEST_F(ConnectionsOfALink, OnlyWhatWasWantedLastIsAskedForAgain) {
  connections.set_up(0, true, at(10), out);
  transport.refuses = false;
  connections.set_up(0, false, at(20), out);

  connections.update(at(1000), out);

  EXPECT_EQ(transport.asked, (std::vector<std::pair<std::size_t, bool>>{{0, true}, {0, false}}));
}

TEST_F(ConnectionsOfALink, ASampleThatIsNotTakenIsNamedOnceUntilOneIs) {
  for (const bool taken : {false, false, true, false}) {
    connections.wrote(0, wire::Slot::kAlarm, taken, out);
  }
  connections.wrote(1, wire::Slot::kAlarm, false, out);

  ASSERT_EQ(out.size(), 3U);
  EXPECT_EQ(std::get<TransportRefused>(out[0]).why, "a sample of Alarm was not taken");
  EXPECT_EQ(std::get<TransportRefused>(out[2]).channel.partition, "radio/marvin>ground");
}

}  // namespace
}  // namespace skein::blackboard
