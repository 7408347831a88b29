// SPDX-License-Identifier: Apache-2.0
// Whoever says anything new is there, also while its heartbeats are lost.
#include <gtest/gtest.h>

#include "skein/blackboard/blackboard.hpp"
#include "testing/memory_boards.hpp"
#include "testing/samples.hpp"

namespace skein::blackboard {
namespace {

const Node kGround{NodeNumber(1), "ground"};
const Node kUav{NodeNumber(2), "uav"};
constexpr Duration kPeriod = Duration::milliseconds(200);
constexpr std::uint64_t kLife = 5;

/// A ground station that hears what is put into the channel from a UAV, which is not there.
class SignsOfLife : public ::testing::Test {
 protected:
  SignsOfLife() {
    Config config;
    config.self = kGround.number;
    config.heartbeat_period = kPeriod;
    config.channels = radio_link(kGround, kUav);
    boards_.start(config);
  }
  void SetUp() override {
    say(wire::Heartbeat{});
    ASSERT_TRUE(reachable());
  }

  template <class T>
  void say(T sample, std::uint64_t life = kLife) {
    sample.header.sequence_number = ++sequence_;
    repeat(std::move(sample), life);
  }
  template <class T>
  void repeat(T sample, std::uint64_t life = kLife) {
    sample.header.origin = kUav.number.value();
    sample.header.destination = kGround.number.value();
    sample.header.incarnation = life;
    sample.header.expires = wire::kNever;
    boards_.hub().inject("radio/uav>ground", sample);
    boards_.settle();
  }
  void wait_half_a_period() { boards_.run_until(boards_.time() + Duration::milliseconds(100)); }
  bool reachable() { return boards_[kGround.number].reachable(kUav.number); }
  /// Whether it is in reach after ten periods in each half of which this is done.
  bool stays_in_reach(const std::function<void()>& speak) {
    for (int half = 0; half < 20 && reachable(); ++half) {
      wait_half_a_period();
      speak();
    }
    return reachable();
  }

 private:
  testing::MemoryBoards boards_{[](NodeNumber, Incoming&&) {}};
  std::uint64_t sequence_ = 0;
};

TEST_F(SignsOfLife, AStreamAStateAnEventAndAPartAreSomeAsAHeartbeatIs) {
  EXPECT_TRUE(stays_in_reach([&] { say(wire::Heartbeat{}); }));
  EXPECT_TRUE(stays_in_reach([&] { say(wire::Telemetry{}); }));
  EXPECT_TRUE(stays_in_reach([&] { say(wire::AutonomyDegree{}); }));
  EXPECT_TRUE(stays_in_reach([&] { say(wire::TaskEvent{}); }));
  EXPECT_TRUE(stays_in_reach([&] { say(wire::Part{}); }));
}

TEST_F(SignsOfLife, SilenceAfterAnyOfThemIsKnownWithinThreePeriods) {
  ASSERT_TRUE(stays_in_reach([&] { say(wire::Telemetry{}); }));
  for (int half = 0; half < 6; ++half) wait_half_a_period();
  EXPECT_FALSE(reachable());
}

TEST_F(SignsOfLife, WhatWasSaidBeforeIsNone) {
  wire::Telemetry telemetry;
  telemetry.header.sequence_number = 100;
  EXPECT_FALSE(stays_in_reach([&] { repeat(telemetry); }));
  say(wire::Heartbeat{});
  wire::TaskEvent event;
  event.header.sequence_number = 1;
  EXPECT_FALSE(stays_in_reach([&] { repeat(event); }));
}

TEST_F(SignsOfLife, WhatAnotherLifeSaysIsNone) {
  EXPECT_FALSE(stays_in_reach([&] { say(wire::Telemetry{}, kLife - 1); }));
  say(wire::Heartbeat{});
  EXPECT_FALSE(stays_in_reach([&] { say(wire::Telemetry{}, kLife + 1); }));
}

// A life begins, and comes back, with its heartbeat, which says where its events begin.
TEST_F(SignsOfLife, NothingButAHeartbeatBringsContactBack) {
  ASSERT_FALSE(stays_in_reach([] {}));
  say(wire::Telemetry{});
  EXPECT_FALSE(reachable());
  say(wire::Heartbeat{});
  EXPECT_TRUE(reachable());
}

}  // namespace
}  // namespace skein::blackboard
