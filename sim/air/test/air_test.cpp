// SPDX-License-Identifier: Apache-2.0
#include "skein/air/air.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace skein::air {
namespace {

Duration ms(std::int64_t milliseconds) { return Duration::milliseconds(milliseconds); }

Condition with(double loss, Duration delay = {}, double rate = 0) {
  return {true, loss, delay, rate};
}

TEST(Air, CarriesAtOnceAtFirst) {
  Air air(2, 1);
  EXPECT_EQ(air.send(0, 1, 100, ms(5)), ms(5));
  EXPECT_TRUE(air.arrives(0, 1, 100));
  EXPECT_EQ(air.counts(0, 1), (Counts{1, 100, 0, 0, 0, 0}));
}

TEST(Air, ACutIsOfOneDirection) {
  Air air(2, 1);
  air.set(0, 1, {false, 0, {}, 0});
  EXPECT_FALSE(air.send(0, 1, 100, ms(0)).has_value());
  EXPECT_TRUE(air.send(1, 0, 100, ms(0)).has_value());
  EXPECT_EQ(air.counts(0, 1).cut, 1U);
}

TEST(Air, WhatIsUnderWayWhenALinkIsCutDoesNotArrive) {
  Air air(2, 1);
  air.set(0, 1, with(0, ms(100)));
  EXPECT_EQ(air.send(0, 1, 100, ms(0)), ms(100));
  air.set(0, 1, {false, 0, {}, 0});
  EXPECT_FALSE(air.arrives(0, 1, 100));
}

TEST(Air, APacketTakesItsTimeAtTheRateAndThenTheDelay) {
  Air air(2, 1);
  air.set(0, 1, with(0, ms(30), 1200));  // 9,600 bit/s
  EXPECT_EQ(air.send(0, 1, 120, ms(0)), ms(130));
  EXPECT_EQ(air.send(0, 1, 120, ms(0)), ms(230));
  EXPECT_EQ(air.send(0, 1, 120, ms(1000)), ms(1130)) << "the queue was empty again";
}

TEST(Air, WhatWaitsTooLongIsLost) {
  Air air(2, 1, ms(500));
  air.set(0, 1, with(0, {}, 1000));
  int taken = 0;
  for (int i = 0; i < 20; ++i) taken += air.send(0, 1, 100, ms(0)) ? 1 : 0;
  EXPECT_EQ(taken, 6) << "five wait, one goes out";
  EXPECT_EQ(air.counts(0, 1).overflowed, 14U);
}

TEST(Air, LosesTheShareItIsToldTo) {
  Air air(2, 7);
  air.set(0, 1, with(0.3));
  int lost = 0;
  for (int i = 0; i < 10'000; ++i) lost += air.send(0, 1, 100, ms(i)) ? 0 : 1;
  EXPECT_NEAR(lost, 3000, 200) << "four standard deviations";
}

TEST(Air, OneSeedLosesTheSame) {
  std::vector<bool> first, second;
  for (auto* run : {&first, &second}) {
    Air air(3, 42);
    air.set(0, 1, with(0.5));
    for (int i = 0; i < 200; ++i) run->push_back(air.send(0, 1, 100, ms(i)).has_value());
  }
  EXPECT_EQ(first, second);
}

// Whatever is sent when, however conditions change: order is kept, nothing comes before it could,
// nothing goes faster than the rate, and every packet is in exactly one count.
RC_GTEST_PROP(AirLaw, KeepsOrderRateAndCount, ()) {
  const double rate = *rc::gen::inRange(100, 5000);
  Air air(2, 1, ms(1000));
  Duration now, last;
  std::uint64_t sent = 0;
  double bytes = 0;
  std::optional<Duration> first;
  for (const int step : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 400))) {
    air.set(0, 1, with(step % 3 == 0 ? 0.5 : 0, ms(step % 50), rate));
    now = now + ms(step % 7 == 0 ? step : 0);
    const std::size_t size = 50 + static_cast<std::size_t>(step);
    ++sent;
    const auto arrives = air.send(0, 1, size, now);
    if (!arrives) continue;
    RC_ASSERT(*arrives >= last);
    RC_ASSERT(*arrives >= now + Duration::seconds(static_cast<double>(size) / rate) - ms(1));
    if (!first) first = now;
    bytes += static_cast<double>(size);
    RC_ASSERT(bytes / rate <= (*arrives - *first).to_seconds() + 0.001);
    last = *arrives;
    RC_ASSERT(air.arrives(0, 1, size));
  }
  const Counts& counts = air.counts(0, 1);
  RC_ASSERT(counts.carried + counts.lost + counts.cut + counts.overflowed == sent);
}

}  // namespace
}  // namespace skein::air
