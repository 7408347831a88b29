// SPDX-License-Identifier: Apache-2.0
#include "skein/node/mission_clock.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "skein/foundation/random.hpp"

namespace skein::node {
namespace {

using wire::ClockPhase;

Duration steady(double seconds) { return Duration::seconds(seconds); }

wire::Clock sample(double time, double rate = 1, ClockPhase phase = ClockPhase::kRunning) {
  wire::Clock clock;
  clock.time = MissionTime::seconds(time).count();
  clock.rate = rate;
  clock.phase = phase;
  return clock;
}

TEST(MissionClock, OneThatWasToldSoGoesOnHoweverLongNobodySpeaks) {
  MissionClock clock(Duration::max());
  clock.update(sample(10), steady(100));

  EXPECT_NEAR(clock.now(steady(1'100)).to_seconds(), 1'010, 2) << "within what crystals do";
  EXPECT_TRUE(clock.steady_at(MissionTime::seconds(2'000), steady(1'100)).has_value());
}

TEST(ClockLeader, HoldsAtZeroUntilItRuns) {
  ClockLeader leader(20);

  EXPECT_EQ(leader.now(steady(100)), MissionTime());
  EXPECT_EQ(leader.phase(), ClockPhase::kHolding);
  EXPECT_FALSE(leader.steady_at(MissionTime::seconds(1)));
}

TEST(ClockLeader, CountsSteadyTimeTimesTheRate) {
  ClockLeader leader(20);

  leader.run(steady(100));

  EXPECT_EQ(leader.now(steady(100)), MissionTime());
  EXPECT_EQ(leader.now(steady(101.5)), MissionTime::seconds(30));
  EXPECT_EQ(leader.steady_at(MissionTime::seconds(30)), steady(101.5));
}

TEST(ClockLeader, ASecondStartChangesNothing) {
  ClockLeader leader(1);
  leader.run(steady(100));

  leader.run(steady(200));

  EXPECT_EQ(leader.now(steady(200)), MissionTime::seconds(100));
}

TEST(ClockLeader, GoesOnFromWhereItIsSet) {
  ClockLeader leader(20);

  leader.set(MissionTime::seconds(300), steady(100));
  EXPECT_EQ(leader.now(steady(101)), MissionTime::seconds(300));
  leader.run(steady(102));

  EXPECT_EQ(leader.now(steady(103)), MissionTime::seconds(320));
  EXPECT_EQ(leader.steady_at(MissionTime::seconds(320)), steady(103));
}

TEST(ClockLeader, StandsStillOnceItHasFinished) {
  ClockLeader leader(2);
  leader.run(steady(0));

  leader.finish(steady(10));
  leader.run(steady(11));

  EXPECT_EQ(leader.now(steady(50)), MissionTime::seconds(20));
  EXPECT_EQ(leader.phase(), ClockPhase::kFinished);
  EXPECT_FALSE(leader.steady_at(MissionTime::seconds(30)));
}

TEST(ClockLeader, TellsTimeRateAndPhase) {
  ClockLeader leader(4);
  leader.run(steady(1));

  const wire::Clock clock = leader.sample(steady(3));

  EXPECT_EQ(clock.time, MissionTime::seconds(8).count());
  EXPECT_EQ(clock.rate, 4);
  EXPECT_EQ(clock.phase, ClockPhase::kRunning);
}

TEST(MissionClock, StandsAtZeroBeforeItHearsAnything) {
  MissionClock clock;

  EXPECT_EQ(clock.now(steady(1000)), MissionTime());
  EXPECT_EQ(clock.phase(), ClockPhase::kHolding);
  EXPECT_FALSE(clock.steady_at(MissionTime::seconds(1), steady(1000)));
}

TEST(MissionClock, StandsStillWhileTheLeaderHolds) {
  MissionClock clock;

  clock.update(sample(7, 20, ClockPhase::kHolding), steady(1));

  EXPECT_EQ(clock.now(steady(2)), MissionTime::seconds(7));
  EXPECT_EQ(clock.now(steady(3)), MissionTime::seconds(7));
}

TEST(MissionClock, GoesOnAtTheLastRateBetweenSamples) {
  MissionClock clock;

  clock.update(sample(40, 20), steady(100));

  EXPECT_NEAR(clock.now(steady(100.1)).to_seconds(), 42, 0.01);
  EXPECT_NEAR(clock.now(steady(100.4)).to_seconds(), 48, 0.05);
  EXPECT_EQ(clock.rate(), 20);
}

TEST(MissionClock, StandsStillSoonAfterItsLeaderFellSilentAndGoesOnWithIt) {
  MissionClock clock;
  clock.update(sample(40, 20), steady(100));

  EXPECT_NEAR(clock.now(steady(160)).to_seconds(), 50, 0.05);
  EXPECT_FALSE(clock.steady_at(MissionTime::seconds(60), steady(160)));
  clock.update(sample(50, 20), steady(160));

  EXPECT_NEAR(clock.now(steady(160.2)).to_seconds(), 54, 0.05);
}

TEST(MissionClock, ASlowSampleIsOutweighedByAFasterOneBeforeIt) {
  MissionClock clock;
  clock.update(sample(10), steady(10));

  clock.update(sample(10.1), steady(10.15));  // 50 ms on its way

  EXPECT_NEAR(clock.now(steady(10.2)).to_seconds(), 10.2, 0.001);
}

TEST(MissionClock, ASlowSampleIsOutweighedByAFasterOneAfterIt) {
  MissionClock clock;
  clock.update(sample(10), steady(10.5));

  clock.update(sample(10.6), steady(10.6));

  EXPECT_NEAR(clock.now(steady(10.7)).to_seconds(), 10.7, 0.001);
}

TEST(MissionClock, StopsWhereTheLeaderSaysItFinished) {
  MissionClock clock;
  clock.update(sample(10), steady(10));

  clock.update(sample(12, 1, ClockPhase::kFinished), steady(12.1));

  EXPECT_EQ(clock.now(steady(50)), MissionTime::seconds(12));
  EXPECT_EQ(clock.phase(), ClockPhase::kFinished);
  EXPECT_FALSE(clock.steady_at(MissionTime::seconds(13), steady(50)));
}

TEST(MissionClock, AFinishedTimeInThePastDoesNotTurnItBack) {
  MissionClock clock;
  clock.update(sample(10), steady(10));
  const MissionTime before = clock.now(steady(10.4));

  clock.update(sample(10.2, 1, ClockPhase::kFinished), steady(10.4));

  EXPECT_EQ(clock.now(steady(16)), before);
}

TEST(MissionClock, FollowsAChangeOfRate) {
  MissionClock clock;
  clock.update(sample(10, 1), steady(10));

  clock.update(sample(11, 30), steady(11));

  EXPECT_NEAR(clock.now(steady(11.4)).to_seconds(), 23, 0.1);
}

class Drift : public ::testing::TestWithParam<double> {};

TEST_P(Drift, ClocksThatDriftStayTogether) {
  const double rate = GetParam();
  for (const double drift : {-1e-4, 1e-4}) {
    MissionClock clock;
    double truth = 0;

    for (int i = 0; i <= 10'000; ++i) {  // 1000 s, ten samples a second
      truth = rate * (1 + drift) * i * 0.1;
      clock.update(sample(truth, rate), steady(i * 0.1));
    }

    EXPECT_NEAR(clock.now(steady(1000)).to_seconds(), truth, rate * 1e-3) << drift;
  }
}
INSTANTIATE_TEST_SUITE_P(AtAnyRate, Drift, ::testing::Values(0.1, 1, 20, 1000));

TEST(MissionClock, ARateOfNoUseIsDisregarded) {
  MissionClock clock;
  clock.update(sample(10, 2), steady(10));

  for (const double rate : {0.0, -1.0, 1e-9, 1e308, std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::quiet_NaN()}) {
    clock.update(sample(500, rate), steady(10.3));
  }

  EXPECT_NEAR(clock.now(steady(10.4)).to_seconds(), 10.8, 0.01);
  EXPECT_EQ(clock.rate(), 2);
}

TEST(MissionClock, ExtremeTimesBreakNothing) {
  MissionClock clock;
  wire::Clock extreme = sample(0, 1e6);

  for (const auto time :
       {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
    extreme.time = time;
    clock.update(extreme, steady(1));
    (void)clock.now(steady(2));
    (void)clock.steady_at(MissionTime::max(), steady(1));
  }

  EXPECT_EQ(clock.now(steady(1e9)), MissionTime::max());
}

// Whatever arrives, in whatever order, mission time never goes back.
RC_GTEST_PROP(MissionClock, NeverGoesBack, (std::uint64_t seed)) {
  Random random(seed);
  MissionClock clock;
  double s = 0;
  MissionTime last;

  for (int i = 0; i < 200; ++i) {
    s += random.uniform(0, 0.3);
    const auto phase = static_cast<ClockPhase>(random.below(3));
    const double rate = random.chance(0.8) ? 20 : random.uniform(-1, 100);
    if (random.chance(0.5)) clock.update(sample(random.uniform(0, 40 * s), rate, phase), steady(s));
    const MissionTime now = clock.now(steady(s));
    RC_ASSERT(now >= last);
    last = now;
  }
}

// Against the truth: never ahead of the leader, and behind it by no more than the quickest of the
// last samples was on its way (what the estimate gives way is that of a second at most).
RC_GTEST_PROP(MissionClock, StaysWithinTheQuickestSamplesOfTheTruth, (std::uint64_t seed)) {
  Random random(seed);
  const double rate = random.uniform(0.1, 100);
  const double quick = random.uniform(0, 0.02);
  MissionClock clock;

  for (int i = 1; i < 300; ++i) {
    const double sent = i * 0.1;
    const double delay = i % 5 == 1 ? quick : random.uniform(quick, 0.09);
    clock.update(sample(rate * sent, rate), steady(sent + delay));
    const double now = clock.now(steady(sent + delay)).to_seconds();
    RC_ASSERT(now <= rate * (sent + delay) + 1e-6);
    RC_ASSERT(now >= rate * (sent + delay - quick - 1e-3) - 1e-6);
  }
}

RC_GTEST_PROP(MissionClock, SteadyAtIsTheInverseOfNow, (std::uint64_t seed)) {
  Random random(seed);
  const double rate = random.uniform(0.01, 1000);
  const double start = random.uniform(0, 1e6);
  MissionClock clock;
  clock.update(sample(random.uniform(0, 1000), rate), steady(start));
  const double last = start + random.uniform(0, 1);
  clock.update(sample(random.uniform(0, 2000), rate), steady(last));
  const MissionTime wanted =
      clock.now(steady(last)) + Duration::seconds(rate * random.uniform(0, 0.49));

  const auto when = clock.steady_at(wanted, steady(last));

  RC_ASSERT(when.has_value());
  RC_ASSERT(std::abs((clock.now(*when) - wanted).to_seconds()) <= rate * 1e-6);
}

TEST(LeaderListening, IsOverOnceSomebodyIsHeardButNotAtOnce) {
  const LeaderListening listening(steady(10), Duration::seconds(0.5));

  EXPECT_FALSE(listening.is_over(steady(10.4), true)) << "others may be later";
  EXPECT_TRUE(listening.is_over(steady(10.5), true));
  EXPECT_EQ(listening.next(steady(10.4)), steady(10.5));
}

TEST(LeaderListening, GoesOnForAWhileAsLongAsNobodyIsHeard) {
  const Duration most = LeaderListening::kAtMost;
  const LeaderListening listening(steady(10), Duration::seconds(0.5));

  EXPECT_FALSE(listening.is_over(steady(10) + most - Duration::nanoseconds(1), false));
  EXPECT_TRUE(listening.is_over(steady(10) + most, false));
  EXPECT_EQ(listening.next(steady(11)), steady(10) + most);
}

TEST(LeaderListening, MayLastLongerOverSlowHeartbeats) {
  const Duration least = LeaderListening::kAtMost + LeaderListening::kAtMost;
  const LeaderListening listening(steady(10), least);

  EXPECT_FALSE(listening.is_over(steady(10) + LeaderListening::kAtMost, false));
  EXPECT_TRUE(listening.is_over(steady(10) + least, false));
}

RC_GTEST_PROP(ClockLeader, SteadyAtIsTheInverseOfNow, (std::uint64_t seed)) {
  Random random(seed);
  const double rate = random.uniform(0.01, 1000);
  ClockLeader leader(rate);
  leader.run(steady(random.uniform(0, 1e6)));
  const MissionTime wanted = MissionTime::seconds(random.uniform(0, 1e4));

  const auto when = leader.steady_at(wanted);

  RC_ASSERT(when.has_value());
  RC_ASSERT(std::abs((leader.now(*when) - wanted).to_seconds()) <= rate * 1e-6);
}

}  // namespace
}  // namespace skein::node
