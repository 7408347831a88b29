// SPDX-License-Identifier: Apache-2.0
// The laws of events and states that are too long to be said at once, over every transport.
#include <algorithm>

#include "testing/laws.hpp"

namespace skein::blackboard::testing {
namespace {

constexpr Duration kOften = Duration::milliseconds(50);

// A channel of 2 Mbit/s in each direction: a megabyte takes four seconds of it and more.
TEST_F(BlackboardLaws, ALongEventComesWholeAndOnceBesideCommandsAndTelemetry) {
  start_pair();
  const ChannelCondition narrow{.up = true, .latency = {}, .loss = 0, .capacity = 2e6};
  system.set_condition(kMarvin, kGround, narrow);
  system.set_condition(kGround, kMarvin, narrow);
  const auto whole = [&] { return system.values<wire::HandOver>(kGround); };

  const wire::HandOver sent = hand_over(7, 1'000'000);
  send(kMarvin, kGround, sent);
  Duration next = system.now().steady;
  std::uint64_t id = 0;
  std::size_t handled_before = 0;
  const bool came = system.run_until([&] {
    if (!whole().empty()) return true;
    handled_before = events(kGround).size();
    if (handled_before == id && system.now().steady >= next) {
      next = system.now().steady + kOften;
      send(kMarvin, kGround, task_event(++id));
      send(kMarvin, kGround, telemetry(0.5));
    }
    return false;
  });

  ASSERT_TRUE(came);
  EXPECT_GT(handled_before, 10U);
  ASSERT_LT(id, 900U) << "the number of the one that settles";
  settle();
  ASSERT_EQ(whole().size(), 1U);
  EXPECT_EQ(whole()[0].goals, sent.goals);
  EXPECT_TRUE(std::ranges::is_sorted(events(kGround)));
  EXPECT_GT(system.values<wire::Telemetry>(kGround).size(), 3U);
}

// A channel of 200 kbit/s: a state of 20 kB takes a second of it.
TEST_F(BlackboardLaws, ALongStateComesOverANarrowChannelAndAgainToThePeersNextLife) {
  start_pair();
  const ChannelCondition narrow{.up = true, .latency = {}, .loss = 0, .capacity = 2e5};
  const auto make_narrow = [&] {
    system.set_condition(kMarvin, kGround, narrow);
    system.set_condition(kGround, kMarvin, narrow);
  };
  const auto last = [&] {
    const auto values = system.values<wire::AutonomyDegree>(kGround);
    return values.empty() ? 0 : values.back().degree;
  };
  const auto plan = [](std::uint8_t value) {
    wire::AutonomyDegree state = degree(value);
    state.contact_policy.assign(20'000, 'a');
    return state;
  };
  make_narrow();

  send(kMarvin, kGround, plan(2));
  EXPECT_TRUE(system.run_until([&] { return last() == 2; }));
  send(kMarvin, kGround, plan(3));
  EXPECT_TRUE(system.run_until([&] { return last() == 3; }));

  system.kill(kGround);
  system.start(kGround);
  make_narrow();
  EXPECT_TRUE(system.run_until([&] { return last() == 3; }));
  send(kMarvin, kGround, degree(4));
  EXPECT_TRUE(system.run_until([&] { return last() == 4; }));
}

}  // namespace
}  // namespace skein::blackboard::testing
