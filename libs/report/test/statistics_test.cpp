// SPDX-License-Identifier: Apache-2.0
#include "story/statistics.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>

#include "builders.hpp"

namespace skein::report {
namespace {

using testing::expectation;
using testing::message;
using testing::stamp;
using testing::task;
using testing::telemetry;

Statistics measure(const Journal& journal) { return measure(tell({}, journal), journal); }

TEST(Measure, DistanceIsTheLengthOfTheWayInTheAir) {
  Journal j;
  j.telemetry = {telemetry(0, "m", {0, 0, 0}, false), telemetry(1, "m", {0, 0, 0}, true),
                 telemetry(2, "m", {3, 4, 0}, true),  telemetry(4, "m", {3, 4, 12}, true),
                 telemetry(5, "m", {3, 4, 0}, false), telemetry(6, "m", {100, 4, 0}, false)};

  const UavFigures f = measure(j).uavs.at(0);

  EXPECT_DOUBLE_EQ(f.distance, 5 + 12 + 12);
  EXPECT_DOUBLE_EQ(f.airborne, 5);
  EXPECT_EQ(f.max_altitude, 12);
  EXPECT_DOUBLE_EQ(f.max_speed, 5);
}

TEST(Measure, EnergyUsedIsFromFirstToLast) {
  Journal j;
  j.telemetry = {telemetry(0, "m", {}, true, 0.9), telemetry(9, "m", {}, true, 0.4)};

  EXPECT_DOUBLE_EQ(*measure(j).uavs.at(0).energy_used, 0.5);
}

TEST(Measure, AUavWithoutTelemetryHasNoAltitude) {
  Journal j;
  j.tasks = {task(1, "m", 1, TaskState::kScheduled)};

  const Statistics s = measure(j);

  EXPECT_FALSE(s.uavs.at(0).max_altitude);
  EXPECT_FALSE(s.uavs.at(0).energy_used);
  EXPECT_FALSE(s.separation);
}

TEST(Measure, SeparationCountsOnlyWhileBothFly) {
  Journal j;
  j.telemetry = {telemetry(0, "a", {0, 0, 0}, false), telemetry(0, "b", {1, 0, 0}, false),
                 telemetry(5, "a", {0, 0, 50}, true), telemetry(5, "b", {30, 40, 50}, true),
                 telemetry(9, "a", {0, 0, 50}, true), telemetry(9, "b", {60, 80, 50}, true)};

  const Statistics s = measure(j);

  ASSERT_TRUE(s.separation);
  EXPECT_DOUBLE_EQ(s.separation->metres, 50);
  EXPECT_DOUBLE_EQ(s.separation->t, 5);
}

TEST(Measure, SeparationIsBetweenSamplesOfDifferentInstantsToo) {
  for (const bool swapped : {false, true}) {
    const std::string one = swapped ? "b" : "a", other = swapped ? "a" : "b";
    Journal j;
    j.telemetry = {telemetry(0, one, {0, 0, 0}), telemetry(10, one, {100, 0, 0}),
                   telemetry(5, other, {50, 7, 0}), telemetry(10, other, {50, 60, 0})};
    sort_by_time(j);

    const Separation found = *measure(j).separation;

    EXPECT_DOUBLE_EQ(found.metres, 7) << "at 5 s, which only one of them has a sample of";
    EXPECT_DOUBLE_EQ(found.t, 5);
    EXPECT_EQ(found.first, 0U);
    EXPECT_EQ(found.second, 1U);
  }
}

// All pairs at every common instant, the slow way.
RC_GTEST_PROP(Measure, SeparationAgreesWithAllPairs, ()) {
  const auto steps = *rc::gen::container<std::vector<std::tuple<int, int, bool>>>(rc::gen::tuple(
      rc::gen::inRange(-50, 50), rc::gen::inRange(-50, 50), rc::gen::arbitrary<bool>()));
  const char* names[] = {"a", "b", "c"};
  Journal j;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto& [x, y, airborne] = steps[i];
    j.telemetry.push_back(telemetry(static_cast<double>(i / 3), names[i % 3],
                                    {static_cast<double>(x), static_cast<double>(y), 0}, airborne));
  }
  std::optional<double> expected;
  for (const TelemetryRecord& p : j.telemetry) {
    for (const TelemetryRecord& q : j.telemetry) {
      if (p.uav >= q.uav || p.stamp.at != q.stamp.at || !p.airborne || !q.airborne) continue;
      const double d = std::hypot(p.position.x - q.position.x, p.position.y - q.position.y);
      expected = std::min(expected.value_or(d), d);
    }
  }

  const std::optional<Separation> found = measure(j).separation;

  RC_ASSERT(found.has_value() == expected.has_value());
  if (found) RC_ASSERT(std::abs(found->metres - *expected) < 1e-9);
}

RC_GTEST_PROP(Measure, DistanceAgreesWithASum, ()) {
  const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(-50, 50), rc::gen::inRange(-50, 50)));
  Journal j;
  double expected = 0, x = 0, y = 0;
  j.telemetry = {telemetry(0, "m", {0, 0, 0})};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    x += steps[i].first;
    y += steps[i].second;
    expected += std::sqrt(
        static_cast<double>(steps[i].first * steps[i].first + steps[i].second * steps[i].second));
    j.telemetry.push_back(telemetry(static_cast<double>(i + 1), "m", {x, y, 0}));
  }

  RC_ASSERT(std::abs(measure(j).uavs.at(0).distance - expected) < 1e-6);
}

TEST(Measure, TasksAreCountedByTheirOutcome) {
  Journal j;
  j.tasks = {task(1, "m", 1, TaskState::kRunning), task(2, "m", 1, TaskState::kEnded),
             task(1, "m", 2, TaskState::kRunning), task(3, "m", 2, TaskState::kAborted),
             task(4, "m", 3, TaskState::kScheduled)};
  sort_by_time(j);

  const UavFigures f = measure(j).uavs.at(0);

  EXPECT_EQ(f.tasks, 3U);
  EXPECT_EQ(f.ended, 1U);
  EXPECT_EQ(f.aborted, 1U);
}

TEST(Measure, ChannelsCountMessagesLossesAndLatency) {
  Journal j;
  j.messages = {message(1, "a", "b", 1, Direction::kSent),
                message(1.25, "a", "b", 1, Direction::kReceived),
                message(2, "a", "b", 2, Direction::kSent)};
  j.undelivered = {{stamp(9, "a"), true, "Alarm", "b", 2}, {stamp(9, "a"), false, "Alarm", "b", 3}};

  const Statistics s = measure(j);

  ASSERT_EQ(s.channels.size(), 1U);
  const ChannelFigures& f = s.channels.at({"Alarm", "a", "b"});
  EXPECT_EQ(f.sent, 2U);
  EXPECT_EQ(f.received, 1U);
  EXPECT_EQ(f.expired, 1U);
  EXPECT_EQ(f.lost, 1U);
  EXPECT_EQ(f.latencies, std::vector<double>{0.25});
}

TEST(Measure, ClocksThatDisagreeGiveNoLatency) {
  Journal j;
  j.messages = {message(1, "a", "b", 1, Direction::kReceived),
                message(2, "a", "b", 1, Direction::kSent)};

  EXPECT_TRUE(measure(j).channels.at({"Alarm", "a", "b"}).latencies.empty());
}

TEST(Measure, ARunIsGoodWhenSomethingWasExpectedAndAllHolds) {
  Journal none, good, bad;
  good.expectations = {expectation("e", true, "")};
  bad.expectations = {expectation("e", true, ""), expectation("f", false, "")};

  EXPECT_FALSE(measure(none).ok());
  EXPECT_TRUE(measure(good).ok());
  EXPECT_FALSE(measure(bad).ok());
  EXPECT_EQ(measure(bad).failed, 1U);
  EXPECT_EQ(measure(bad).lines, 2U);
}

TEST(SeparationSeries, HasAGapWhileFewerThanTwoFly) {
  Journal j;
  for (int t = 0; t <= 10; ++t) {
    j.telemetry.push_back(telemetry(t, "a", {0, 0, 0}));
    j.telemetry.push_back(telemetry(t, "b", {10.0 + t, 0, 0}, t < 3 || t > 7));
  }

  const auto series = separation_series(tell({}, j), 11);

  ASSERT_EQ(series.size(), 6U);
  EXPECT_EQ(series.front(), (std::pair{0.0, 10.0}));
  EXPECT_EQ(series.back(), (std::pair{10.0, 20.0}));
}

TEST(Quantile, IsTheNearestRank) {
  const std::vector<double> values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};

  EXPECT_EQ(quantile(values, 0.5), 5);
  EXPECT_EQ(quantile(values, 0.95), 10);
  EXPECT_EQ(quantile(values, 0.0), 1);
  EXPECT_EQ(quantile({}, 0.5), 0);
}

}  // namespace
}  // namespace skein::report
