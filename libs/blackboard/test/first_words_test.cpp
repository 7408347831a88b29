// SPDX-License-Identifier: Apache-2.0
#include "adapters/rtps/first_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace skein::blackboard::rtps {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Clock = FirstWords::Clock;
using std::chrono::seconds;

const Clock::time_point kMade{seconds(100)};

wire::Sample telemetry(std::uint32_t instance, std::uint64_t number) {
  wire::Telemetry sample;
  sample.header.instance = instance;
  sample.header.sequence_number = number;
  return sample;
}

std::vector<std::uint64_t> said_again(FirstWords& words, Clock::time_point now) {
  std::vector<std::uint64_t> numbers;
  words.found(wire::Slot::kTelemetry, now, [&](const wire::Sample& sample) {
    numbers.push_back(wire::header_of(sample).sequence_number);
  });
  return numbers;
}

TEST(FirstWords, AreTheLastOfEachInstance) {
  FirstWords words;
  words.begin(wire::Slot::kTelemetry, kMade);
  words.keep(telemetry(1, 1), kMade);
  words.keep(telemetry(2, 2), kMade);
  words.keep(telemetry(1, 3), kMade);

  EXPECT_THAT(said_again(words, kMade + seconds(1)), ElementsAre(3, 2));
}

TEST(FirstWords, WaitForTheFirstReaderHoweverLate) {
  FirstWords words;
  words.begin(wire::Slot::kTelemetry, kMade);
  words.keep(telemetry(1, 1), kMade);
  words.keep(telemetry(1, 2), kMade + seconds(100));

  EXPECT_THAT(said_again(words, kMade + seconds(200)), ElementsAre(2));
  EXPECT_THAT(said_again(words, kMade + seconds(200)), IsEmpty());
}

TEST(FirstWords, AreSaidToAllWhoComeWhileTheWriterIsNew) {
  FirstWords words;
  words.begin(wire::Slot::kTelemetry, kMade);
  words.keep(telemetry(1, 1), kMade);

  EXPECT_THAT(said_again(words, kMade + seconds(1)), ElementsAre(1));
  EXPECT_THAT(said_again(words, kMade + seconds(9)), ElementsAre(1));
  EXPECT_THAT(said_again(words, kMade + FirstWords::kNew), IsEmpty());
}

TEST(FirstWords, OfAWriterThatNeverBeganAreNone) {
  FirstWords words;
  words.keep(telemetry(1, 1), kMade);
  EXPECT_THAT(said_again(words, kMade), IsEmpty());

  words.begin(wire::Slot::kTelemetry, kMade);
  words.keep(telemetry(1, 1), kMade);
  words.clear();
  EXPECT_THAT(said_again(words, kMade), IsEmpty());
}

}  // namespace
}  // namespace skein::blackboard::rtps
