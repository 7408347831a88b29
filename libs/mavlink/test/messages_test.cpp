// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink/messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "skein/mavlink/frame.hpp"
#include "testing/any_message.hpp"
#include "testing/hex.hpp"

namespace skein::mavlink {
namespace {

using ::testing::ElementsAre;

struct Fact {
  std::uint32_t message;
  int crc_extra, length;
};
// Made from the published definitions by a generator of its own, and equal to what the npm package
// mavlink-mappings 1.0.21 says.
constexpr std::array kFacts = {
    Fact{0, 50, 9},    Fact{1, 124, 43},  Fact{30, 39, 28},   Fact{33, 104, 28}, Fact{75, 158, 35},
    Fact{76, 152, 33}, Fact{77, 143, 10}, Fact{147, 154, 54}, Fact{245, 130, 2}, Fact{253, 83, 54}};

TEST(Messages, TheirListsOfFieldsGiveTheChecksumsOfThePublishedDefinitions) {
  EXPECT_EQ(kFacts.size(), std::variant_size_v<Message>);
  for (const Fact& fact : kFacts) {
    const Known* known = find_known(fact.message);
    ASSERT_NE(known, nullptr) << fact.message;
    EXPECT_EQ(known->layout.crc_extra, fact.crc_extra) << fact.message;
    EXPECT_EQ(known->layout.length, fact.length) << fact.message;
  }
  EXPECT_EQ(find_known(69), nullptr);
  EXPECT_EQ(find_known(70), nullptr) << "the pilot's channels are not ours to override";
}

TEST(Messages, AHeartbeatHasTheBytesThatAnotherImplementationGivesIt) {
  const Heartbeat px4{0x03040000, 2, 12, 0x81, 4, 3};

  EXPECT_EQ(hex(to_bytes(to_frame(px4, {1, 1}, 7))), "fd09000007010100000000000403020c8104039080");
}

TEST(Messages, AnArmingHasTheBytesThatAnotherImplementationGivesIt) {
  CommandLong arm;
  arm.param1 = 1;
  arm.command = 400;
  arm.target_system = arm.target_component = 1;

  EXPECT_EQ(hex(to_bytes(to_frame(arm, {1, 1}, 8))),
            "fd2000000801014c00000000803f000000000000000000000000000000000000000000000000900101016"
            "9b4");
}

TEST(Messages, ZerosAtTheEndAreCutButNeverTheFirstByte) {
  EXPECT_THAT(to_frame(ExtendedSysState{0, 0}, {1, 1}, 0).payload, ElementsAre(0));
  EXPECT_THAT(to_frame(ExtendedSysState{0, 2}, {1, 1}, 0).payload, ElementsAre(0, 2));
  EXPECT_THAT(to_frame(CommandAck{400, 0}, {1, 1}, 0).payload, ElementsAre(0x90, 0x01));
}

TEST(Messages, WhatANewerDefinitionAppendedIsLeftOut) {
  Frame frame = to_frame(ExtendedSysState{1, 2}, {1, 1}, 0);
  frame.payload.insert(frame.payload.end(), {9, 9, 9});

  EXPECT_EQ(to_message(frame), Message(ExtendedSysState{1, 2}));
}

TEST(Messages, WhatWeDoNotKnowIsNoMessage) {
  EXPECT_EQ(to_message(Frame{{1, 1}, 0, 70, false, {1}}), std::nullopt);
}

TEST(Messages, WordsEndWhereTheZerosBegin) {
  StatusText status;
  const std::string_view words = "Low battery";
  std::copy(words.begin(), words.end(), status.text.begin());
  EXPECT_EQ(text_of(status), "Low battery");
  status.text.fill('x');
  EXPECT_EQ(text_of(status).size(), 50U);
  status.text = {'a', '\xff', '\n', '~'};
  EXPECT_EQ(text_of(status), "a??~");
}

RC_GTEST_PROP(Messages, ReadBackAsTheyWereWritten, ()) {
  const Message message = any_message();
  const Frame frame = to_frame(message, {3, 191}, *rc::gen::arbitrary<std::uint8_t>());

  RC_ASSERT(!frame.payload.empty());
  RC_ASSERT(frame.payload.size() <= find_known(frame.message)->layout.length);
  RC_ASSERT(to_message(frame) == message);
}

RC_GTEST_PROP(Messages, ReadTheSameWithTheZerosThatAnotherSenderLeftThere, ()) {
  const Message message = any_message();
  Frame frame = to_frame(message, {3, 191}, 0);
  frame.payload.resize(find_known(frame.message)->layout.length, 0);

  RC_ASSERT(to_message(frame) == message);
}

}  // namespace
}  // namespace skein::mavlink
