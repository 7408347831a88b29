// SPDX-License-Identifier: Apache-2.0
#include "skein/air/weather.hpp"

#include <gtest/gtest.h>

namespace skein::air {
namespace {

constexpr std::uint32_t kGround = 1, kMarvin = 10;

wire::LinkState link(std::uint32_t from, std::uint32_t to, bool up) {
  wire::LinkState state;
  state.from = from;
  state.to = to;
  state.up = up;
  return state;
}

wire::Clock clock(wire::ClockPhase phase, double rate = 1) {
  wire::Clock one;
  one.phase = phase;
  one.rate = rate;
  return one;
}

TEST(Weather, IsFineUntilTheMissionRuns) {
  Air air(2, 1);
  Weather weather({kGround, kMarvin}, {0.5, {}, 1200}, air);
  weather.hear(link(kGround, kMarvin, false));
  EXPECT_EQ(air.condition(0, 1), Condition{});
  weather.hear(clock(wire::ClockPhase::kRunning));
  EXPECT_FALSE(air.condition(0, 1).up);
  EXPECT_TRUE(air.condition(1, 0).up) << "the other direction is not cut";
  EXPECT_EQ(air.condition(1, 0).loss, 0.5);
  weather.hear(clock(wire::ClockPhase::kFinished));
  EXPECT_EQ(air.condition(0, 1), Condition{}) << "last words are heard";
}

TEST(Weather, TurnsMissionSecondsIntoSteadyOnes) {
  Air air(2, 1);
  Weather weather({kGround, kMarvin}, {}, air);
  wire::LinkState state = link(kGround, kMarvin, true);
  state.latency = 200'000'000;
  state.capacity = 8000;  // bit/s
  weather.hear(state);
  weather.hear(clock(wire::ClockPhase::kRunning, 10));
  EXPECT_EQ(air.condition(0, 1).delay, Duration::milliseconds(20));
  EXPECT_EQ(air.condition(0, 1).rate, 10'000);
}

TEST(Weather, OfTwoLossesTheWorseCountsDelaysAddUpAndARateTakesThePlaceOfTheCapacity) {
  Air air(2, 1);
  Weather weather({kGround, kMarvin}, {0.3, Duration::milliseconds(5), 500}, air);
  wire::LinkState state = link(kGround, kMarvin, true);
  state.loss = 0.1;
  state.latency = 10'000'000;
  state.capacity = 8000;  // bit/s
  weather.hear(clock(wire::ClockPhase::kRunning));
  weather.hear(state);
  EXPECT_EQ(air.condition(0, 1), (Condition{true, 0.3, Duration::milliseconds(15), 500}));
  EXPECT_EQ(air.condition(1, 0).rate, 500) << "nothing was said of it";
}

TEST(Weather, PassesOverLinksOfOthers) {
  Air air(2, 1);
  Weather weather({kGround, kMarvin}, {}, air);
  weather.hear(clock(wire::ClockPhase::kRunning));
  weather.hear(link(7, kMarvin, false));
  weather.hear(wire::Telemetry{});
  EXPECT_TRUE(air.condition(0, 1).up);
}

}  // namespace
}  // namespace skein::air
