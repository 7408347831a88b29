// SPDX-License-Identifier: Apache-2.0
#include "adapters/rtps/message_pieces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace skein::blackboard::rtps {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using Message = std::vector<std::uint8_t>;

constexpr std::uint8_t kData = 0x15, kHeartbeat = 0x07, kInfoTs = 0x09, kInfoDst = 0x0e,
                       kPrefix = 0x31, kBody = 0x30, kPostfix = 0x32, kWhole = 0x33;

Message header() {
  Message bytes{'R', 'T', 'P', 'S', 2, 2, 1, 15};
  for (std::uint8_t i = 0; i < 12; ++i) bytes.push_back(i);
  return bytes;
}

/// Adds a submessage, in the one or the other order of bytes.
void add(Message& message, std::uint8_t kind, const Message& content, bool little = true) {
  const auto low = static_cast<std::uint8_t>(content.size()),
             high = static_cast<std::uint8_t>(content.size() >> 8U);
  message.insert(message.end(), {kind, static_cast<std::uint8_t>(little ? 1 : 0),
                                 little ? low : high, little ? high : low});
  message.insert(message.end(), content.begin(), content.end());
}

/// What a receiver makes of messages: each submessage with the destination and the time that hold.
/// Its own small reader, of little endian alone.
struct Heard {
  std::uint8_t kind = 0;
  Message content, destination, time;
  bool operator==(const Heard&) const = default;
};
std::vector<Heard> heard(const std::vector<Message>& messages) {
  std::vector<Heard> all;
  for (const Message& message : messages) {
    Heard now;
    for (std::size_t at = 20; at < message.size();) {
      const std::size_t length = message[at + 2] + 256U * message[at + 3];
      const auto from = message.begin() + static_cast<std::ptrdiff_t>(at + 4);
      now.kind = message[at];
      now.content.assign(from, from + static_cast<std::ptrdiff_t>(length));
      if (now.kind == kInfoDst) now.destination = now.content;
      if (now.kind == kInfoTs) now.time = now.content;
      if (now.kind != kInfoDst && now.kind != kInfoTs) all.push_back(now);
      at += 4 + length;
    }
  }
  return all;
}

TEST(MessagePieces, AMessageThatFitsGoesAsItIs) {
  Message message = header();
  add(message, kData, Message(100));

  EXPECT_THAT(pieces_of(message, message.size()), IsEmpty());
}

TEST(MessagePieces, WhatIsSaidAgainGoesInSeveralToTheSameReaderWithItsTimes) {
  Message message = header();
  add(message, kInfoDst, Message(12, 7));
  for (std::uint8_t i = 0; i < 8; ++i) {
    add(message, kInfoTs, Message(8, i));
    add(message, kData, Message(400, i));
  }
  add(message, kHeartbeat, Message(28));

  const auto pieces = pieces_of(message, 1'472);

  ASSERT_THAT(pieces, SizeIs(3));
  EXPECT_EQ(heard(pieces), heard({message}));
  for (const Message& piece : pieces) EXPECT_EQ(piece[20], kInfoDst);
}

TEST(MessagePieces, WhatIsProtectedTogetherStaysTogether) {
  Message message = header();
  for (std::uint8_t i = 0; i < 4; ++i) {
    add(message, kPrefix, Message(20, i));
    add(message, kBody, Message(500, i));
    add(message, kPostfix, Message(20, i));
  }

  const auto pieces = pieces_of(message, 1'472);

  ASSERT_THAT(pieces, SizeIs(2));
  EXPECT_EQ(heard(pieces), heard({message}));
  for (const Message& piece : pieces) EXPECT_EQ(piece[20], kPrefix);
}

TEST(MessagePieces, ASampleThatIsLongByItselfGoesAlone) {
  Message message = header();
  add(message, kData, Message(50));
  add(message, kData, Message(5'000));
  add(message, kData, Message(50));

  const auto pieces = pieces_of(message, 1'472);

  ASSERT_THAT(pieces, SizeIs(3));
  EXPECT_EQ(heard(pieces), heard({message}));
}

TEST(MessagePieces, TheLastSubmessageMayHaveNoLength) {
  Message message = header();
  add(message, kData, Message(1'000));
  add(message, kData, {});
  message.resize(message.size() + 1'000);

  const auto pieces = pieces_of(message, 1'472);

  ASSERT_THAT(pieces, SizeIs(2));
  EXPECT_THAT(pieces[1], SizeIs(20 + 4 + 1'000));
}

TEST(MessagePieces, EitherOrderOfBytesIsRead) {
  Message message = header();
  for (int i = 0; i < 4; ++i) add(message, kData, Message(600), i % 2 == 0);

  EXPECT_THAT(pieces_of(message, 1'472), SizeIs(2));
}

TEST(MessagePieces, WhatIsNotUnderstoodOrProtectedAsAWholeGoesAsItIs) {
  Message whole = header();
  add(whole, kWhole, Message(20));
  add(whole, kBody, Message(3'000));
  EXPECT_THAT(pieces_of(whole, 1'472), IsEmpty());

  Message open = header();
  add(open, kPrefix, Message(20));
  add(open, kBody, Message(3'000));
  EXPECT_THAT(pieces_of(open, 1'472), IsEmpty()) << "no postfix";

  Message cut = header();
  add(cut, kData, Message(3'000));
  cut.pop_back();
  EXPECT_THAT(pieces_of(cut, 1'472), IsEmpty());
  EXPECT_THAT(pieces_of(Message(3'000), 1'472), IsEmpty()) << "not RTPS";
}

RC_GTEST_PROP(MessagePieces, SayTogetherWhatTheMessageSaysAndFit, ()) {
  Message message = header();
  const auto parts = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(0, 4), rc::gen::inRange(1, 900)));
  for (const auto& [what, size] : parts) {
    const Message content(static_cast<std::size_t>(size), static_cast<std::uint8_t>(size));
    if (what == 0) add(message, kInfoDst, Message(12, static_cast<std::uint8_t>(size)));
    if (what == 1) add(message, kInfoTs, Message(8, static_cast<std::uint8_t>(size)));
    if (what == 2) add(message, kData, content);
    if (what != 3) continue;
    add(message, kPrefix, Message(20));
    add(message, kBody, content);
    add(message, kPostfix, Message(20));
  }

  const auto pieces = pieces_of(message, 1'024);

  RC_ASSERT(pieces.empty() || heard(pieces) == heard({message}));
  RC_ASSERT(!pieces.empty() || message.size() <= 1'024 || heard({message}).size() <= 3);
  for (const Message& piece : pieces) RC_ASSERT(piece.size() <= 1'024);
}

RC_GTEST_PROP(MessagePieces, NoBytesAreTooOddToBeLookedAt, (std::vector<std::uint8_t> tail)) {
  Message message = header();
  message.insert(message.end(), tail.begin(), tail.end());

  for (const Message& piece : pieces_of(message, 30)) RC_ASSERT(piece.size() > 20);
}

}  // namespace
}  // namespace skein::blackboard::rtps
