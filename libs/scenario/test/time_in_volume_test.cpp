// SPDX-License-Identifier: Apache-2.0
// The measure of the time flown in closed air.
#include <gtest/gtest.h>

#include <utility>

#include "skein/scenario/expectation.hpp"

namespace skein::scenario {
namespace {

using journal::Record;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

Record telemetry(double seconds, const std::string& uav, std::vector<double> position,
                 bool airborne = true) {
  return Record(at(seconds), "sim", "telemetry")
      .with("uav", uav)
      .with("position", std::move(position))
      .with("airborne", airborne);
}
world::Volume square(const std::string& name) {
  world::Volume volume;
  volume.name = name;
  volume.polygon = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  volume.floor = 0;
  volume.ceiling = 50;
  return volume;
}
Verdict time_in(std::vector<ClosedAir> air, const std::vector<Record>& records,
                std::vector<std::string> uavs = {}) {
  ExpectMeasure measure{
      ExpectMeasure::Quantity::kTimeInVolume, std::move(uavs), {}, 1, std::move(air)};
  return check({{"it", std::move(measure)}}, records).at(0);
}
Record step(double seconds, const std::string& name) {
  return Record(at(seconds), "ground", "step").with("name", name);
}
Pattern step_is(const std::string& name) {
  return {{{"kind", {std::string("step")}}, {"name", {name}}}};
}

TEST(TimeInVolume, IsThatOfAllUavsInTheAirTogether) {
  const std::vector<Record> records = {
      telemetry(1, "a", {5, 5, 20}),  telemetry(1, "b", {5, 5, 60}),
      telemetry(2, "a", {6, 5, 20}),  telemetry(2, "b", {5, 5, 40}),
      telemetry(4, "a", {20, 5, 20}), telemetry(4, "b", {5, 5, 0}, false),
      telemetry(9, "a", {20, 5, 20}), telemetry(9, "b", {5, 5, 0}, false)};

  const Verdict all = time_in({{square("n"), {}, {}}}, records);
  const Verdict of_b = time_in({{square("n"), {}, {}}}, records, {"b"});

  EXPECT_EQ(all.seen, "5 s (a in n at 1 s first)");
  EXPECT_FALSE(all.passed);
  EXPECT_EQ(of_b.seen, "2 s (b in n at 2 s first)");
}

TEST(TimeInVolume, InTwoVolumesThatOverlapCountsOnce) {
  const std::vector<Record> records = {telemetry(1, "a", {5, 5, 20}),
                                       telemetry(2, "a", {5, 5, 20})};

  const Verdict verdict = time_in({{square("n"), {}, {}}, {square("m"), {}, {}}}, records);

  EXPECT_EQ(verdict.seen, "1 s (a in n at 1 s first)");
}

TEST(TimeInVolume, CountsFromItsClosingToItsOpening) {
  std::vector<Record> records;
  for (int second = 0; second < 20; ++second) {
    if (second == 5) records.push_back(step(5, "close"));
    if (second == 8) records.push_back(step(8, "open"));
    records.push_back(telemetry(second, "a", {5, 5, 20}));
  }

  const Verdict verdict = time_in({{square("n"), step_is("close"), step_is("open")}}, records);
  const Verdict never_closed = time_in({{square("n"), step_is("other"), {}}}, records);

  EXPECT_EQ(verdict.seen, "3 s (a in n at 5 s first)");
  EXPECT_EQ(never_closed.seen, "0 s");
  EXPECT_TRUE(never_closed.passed);
}

TEST(TimeInVolume, AnOpeningBeforeTheClosingOpensNothing) {
  const std::vector<Record> records = {step(0, "open"), step(1, "close"),
                                       telemetry(2, "a", {5, 5, 20}),
                                       telemetry(4, "a", {5, 5, 20})};

  const Verdict verdict = time_in({{square("n"), step_is("close"), step_is("open")}}, records);

  EXPECT_EQ(verdict.seen, "2 s (a in n at 2 s first)");
}

TEST(TimeInVolume, CountsDuringTheVolumesOwnTime) {
  world::Volume volume = square("n");
  volume.when = {at(3), at(5)};
  std::vector<Record> records;
  for (int second = 0; second < 20; ++second) records.push_back(telemetry(second, "a", {5, 5, 20}));

  EXPECT_EQ(time_in({{volume, {}, {}}}, records).seen, "2 s (a in n at 3 s first)");
  EXPECT_EQ(time_in({{volume, {}, {}}}, {}).seen, "nothing to measure: no telemetry");
}

}  // namespace
}  // namespace skein::scenario
