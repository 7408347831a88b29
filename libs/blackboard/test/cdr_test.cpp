// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/cdr.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "testing/random_sample.hpp"

namespace skein::blackboard {
namespace {

using testing::for_each_slot_type;
using testing::random_value;
using Bytes = std::vector<std::uint8_t>;

Bytes encoded(const wire::Sample& sample) {
  Bytes bytes(encoded_size(sample));
  EXPECT_EQ(encode(sample, bytes), bytes.size());
  return bytes;
}

TEST(Cdr, WhatIsEncodedIsDecodedTheSame) {
  Random random(1);
  for_each_slot_type([&]<class T>() {
    for (int i = 0; i < 50; ++i) {
      const wire::Sample sample = random_value<T>(random);

      const auto decoded = decode(wire::slot_of(sample), encoded(sample));

      ASSERT_TRUE(std::holds_alternative<wire::Sample>(decoded));
      EXPECT_EQ(std::get<wire::Sample>(decoded), sample);
    }
  });
}

TEST(Cdr, EveryTruncationIsMalformedAndHarmless) {
  Random random(2);
  for_each_slot_type([&]<class T>() {
    const wire::Sample sample = random_value<T>(random);
    const Bytes whole = encoded(sample);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));

      const auto decoded = decode(wire::slot_of(sample), cut);

      EXPECT_TRUE(std::holds_alternative<Malformed>(decoded)) << size << " of " << whole.size();
    }
  });
}

TEST(Cdr, RandomDamageNeverDoesHarm) {
  Random random(3);
  for_each_slot_type([&]<class T>() {
    const wire::Sample sample = random_value<T>(random);
    for (int i = 0; i < 300; ++i) {
      Bytes bytes = encoded(sample);
      for (int hits = 0; hits < 3; ++hits) {
        bytes[random.below(bytes.size())] = static_cast<std::uint8_t>(random.bits());
      }

      const auto decoded = decode(wire::slot_of(sample), bytes);

      if (const auto* good = std::get_if<wire::Sample>(&decoded)) wire::find_violation(*good);
    }
  });
}

TEST(Cdr, ReadsTheOtherByteOrder) {
  // SyncMessage with id 5, from "ab", to "", written by hand as a big-endian machine would.
  const Bytes bytes = {
      0, 0, 0, 0,                  // CDR_BE
      0, 0, 0, 3,                  // origin
      0, 0, 0, 0,                  // instance
      0, 0, 0, 1,                  // destination
      0, 0, 0, 0,                  // padding
      0, 0, 0, 0, 0,   0,   0, 9,  // incarnation
      0, 0, 0, 0, 0,   0,   0, 2,  // sequence_number
      0, 0, 0, 0, 0,   0,   1, 0,  // mission_time
      0, 0, 0, 0, 0,   0,   0, 0,  // expires
      0, 0, 0, 7,                  // mission
      0, 0, 0, 0,                  // via: nobody
      0, 0, 0, 0, 0,   0,   0, 5,  // id
      0, 0, 0, 3, 'a', 'b', 0, 0,  // from, padding
      0, 0, 0, 1, 0,   0,   0, 0,  // to, padding
      0, 0, 0, 2,                  // word
      0, 0, 0, 0,                  // padding
      0, 0, 0, 0, 0,   0,   1, 1   // said
  };

  const auto decoded = decode(wire::Slot::kSyncMessage, bytes);

  ASSERT_TRUE(std::holds_alternative<wire::Sample>(decoded));
  const auto& message = std::get<wire::SyncMessage>(std::get<wire::Sample>(decoded));
  EXPECT_EQ(message.header.origin, 3U);
  EXPECT_EQ(message.header.mission_time, 256);
  EXPECT_EQ(message.id, 5U);
  EXPECT_EQ(message.from, "ab");
  EXPECT_EQ(message.to, "");
  EXPECT_EQ(message.word, wire::SyncWord::kWithdrawn);
  EXPECT_EQ(message.said, 257);
}

TEST(Cdr, SaysWhichFieldIsWrongAndWhoseItIs) {
  wire::PlanBoard board;
  board.header.origin = 3;
  board.tasks.resize(2);
  Bytes bytes = encoded(board);
  // … the reason's last byte, three of padding, the number of models: 4 bytes.
  bytes.resize(bytes.size() - 10);

  const auto decoded = decode(wire::Slot::kPlanBoard, bytes);

  ASSERT_TRUE(std::holds_alternative<Malformed>(decoded));
  const auto& malformed = std::get<Malformed>(decoded);
  EXPECT_EQ(malformed.header.origin, 3U);
  EXPECT_EQ(malformed.violation, (wire::Violation{"tasks[1].reason", "cut short"}));
}

TEST(Cdr, ABooleanIsZeroOrOne) {
  wire::PlanBoard board;
  Bytes bytes = encoded(board);
  // … airborne, a byte of padding, the numbers of tasks and models: 4 bytes each.
  bytes[bytes.size() - 10] = 2;

  const auto decoded = decode(wire::Slot::kPlanBoard, bytes);

  ASSERT_TRUE(std::holds_alternative<Malformed>(decoded));
  EXPECT_EQ(std::get<Malformed>(decoded).violation.field, "airborne");
}

TEST(Cdr, ALengthBeyondTheLimitsIsRefusedBeforeAnythingIsAllocated) {
  wire::PlanBoard board;
  Bytes bytes = encoded(board);
  std::fill(bytes.end() - 8, bytes.end() - 4, std::uint8_t{0xFF});

  const auto decoded = decode(wire::Slot::kPlanBoard, bytes);

  ASSERT_TRUE(std::holds_alternative<Malformed>(decoded));
  EXPECT_EQ(std::get<Malformed>(decoded).violation,
            (wire::Violation{"tasks", "too many elements"}));
}

TEST(Cdr, OtherEncapsulationsAreRefused) {
  Bytes bytes = encoded(wire::Clock{});
  bytes[1] = 7;  // CDR2

  EXPECT_TRUE(std::holds_alternative<Malformed>(decode(wire::Slot::kClock, bytes)));
}

}  // namespace
}  // namespace skein::blackboard
