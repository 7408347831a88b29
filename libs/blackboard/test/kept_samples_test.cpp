// SPDX-License-Identifier: Apache-2.0
#include "adapters/rtps/kept_samples.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace skein::blackboard::rtps {
namespace {

using std::chrono::seconds;

wire::AutonomyDegree degree(std::uint32_t instance, std::uint8_t value) {
  wire::AutonomyDegree sample;
  sample.header.instance = instance;
  sample.degree = value;
  return sample;
}

wire::TaskEvent event(std::uint64_t sequence) {
  wire::TaskEvent sample;
  sample.header.sequence_number = sequence;
  return sample;
}

class KeptByAChannel : public ::testing::Test {
 protected:
  std::vector<wire::Sample> all(seconds at) const {
    std::vector<wire::Sample> found;
    kept.for_each(start + at, [&](const wire::Sample& sample) { found.push_back(sample); });
    return found;
  }
  KeptSamples::Clock::time_point start;
  KeptSamples kept;
};

TEST_F(KeptByAChannel, AreTheLastStatesOfEachInstanceHoweverOld) {
  kept.keep(degree(1, 2), start);
  kept.keep(degree(2, 3), start);
  kept.keep(degree(1, 4), start);

  const auto found = all(seconds(1000));

  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(std::get<wire::AutonomyDegree>(found[0]).degree, 4);
  EXPECT_EQ(std::get<wire::AutonomyDegree>(found[1]).degree, 3);
}

TEST_F(KeptByAChannel, AreYoungEventsInTheirOrder) {
  kept.keep(event(1), start);
  kept.keep(event(2), start + seconds(5));
  kept.keep(event(3), start + seconds(6));

  const auto found = all(kEventLifespan + seconds(1));

  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(wire::header_of(found[0]).sequence_number, 2U);
  EXPECT_EQ(wire::header_of(found[1]).sequence_number, 3U);
}

TEST_F(KeptByAChannel, AreNoMoreEventsThanAWriterKeeps) {
  for (std::uint64_t i = 1; i <= kEventDepth + 10; ++i) kept.keep(event(i), start);

  const auto found = all(seconds(0));

  ASSERT_EQ(found.size(), kEventDepth);
  EXPECT_EQ(wire::header_of(found[0]).sequence_number, 11U);
}

TEST_F(KeptByAChannel, AreNoStreams) {
  kept.keep(wire::Telemetry{}, start);

  EXPECT_TRUE(all(seconds(0)).empty());
}

}  // namespace
}  // namespace skein::blackboard::rtps
