// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink/parser.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing/any_message.hpp"

namespace skein::mavlink {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Frame heartbeat(std::uint8_t sequence) {
  return to_frame(Heartbeat{4, 2, 3, 0x89, 4, 3}, {1, 1}, sequence);
}

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// More than any frame is long: whatever began before has ended.
const Bytes kSilence(300, 0);

TEST(Parser, FindsFramesInPiecesOfAnySize) {
  const Bytes stream = to_bytes(heartbeat(1)) + to_bytes(heartbeat(2));
  Parser parser;

  EXPECT_THAT(parser.take(std::span(stream).first(15)), IsEmpty());
  EXPECT_THAT(parser.take(std::span(stream).subspan(15, 10)), ElementsAre(heartbeat(1)));
  EXPECT_THAT(parser.take(std::span(stream).subspan(25)), ElementsAre(heartbeat(2)));
  EXPECT_EQ(parser.counts(), (ParserCounts{2, 0, 0, 0}));
}

TEST(Parser, AWrongChecksumIsNoFrameAndIsCounted) {
  Bytes wrong = to_bytes(heartbeat(1));
  wrong[12] ^= 1;
  Parser parser;

  EXPECT_THAT(parser.take(wrong + to_bytes(heartbeat(2))), ElementsAre(heartbeat(2)));
  EXPECT_EQ(parser.counts(), (ParserCounts{1, wrong.size(), 1, 0}));
}

TEST(Parser, AFrameThatAsksForWhatWeDoNotUnderstandIsDropped) {
  Bytes frame = to_bytes(heartbeat(1));
  frame[2] = 0x02;
  Checksum crc;
  for (std::size_t i = 1; i + 2 < frame.size(); ++i) crc.add(frame[i]);
  crc.add(std::uint8_t{50});
  frame[frame.size() - 2] = static_cast<std::uint8_t>(crc.value());
  frame.back() = static_cast<std::uint8_t>(crc.value() >> 8U);
  Parser parser;

  EXPECT_THAT(parser.take(frame + to_bytes(heartbeat(2))), ElementsAre(heartbeat(2)));
  EXPECT_EQ(parser.counts().unknown_flags, 1U);
}

// As node-mavlink 2.3.0 signs a heartbeat.
TEST(Parser, ASignatureIsTakenAlong) {
  const Bytes frame = {0xfd, 0x09, 0x01, 0x00, 0x09, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00,
                       0x04, 0x03, 0x02, 0x0c, 0x81, 0x04, 0x03, 0xe0, 0x14, 0x01, 0x00, 0x80,
                       0xe2, 0xec, 0x8d, 0x22, 0x85, 0xd4, 0x5c, 0x88, 0xff, 0xe2};
  Parser parser;

  const auto frames = parser.take(frame + to_bytes(heartbeat(2)));

  ASSERT_THAT(frames, SizeIs(2));
  EXPECT_TRUE(frames[0].is_signed);
  EXPECT_EQ(to_message(frames[0]), Message(Heartbeat{0x03040000, 2, 12, 0x81, 4, 3}));
  EXPECT_FALSE(frames[1].is_signed);
}

TEST(Parser, MessagesThatWeDoNotKnowAreSkipped) {
  Bytes unknown = to_bytes(heartbeat(1));
  unknown[7] = 200;
  Parser parser;

  EXPECT_THAT(parser.take(unknown + to_bytes(heartbeat(2))), ElementsAre(heartbeat(2)));
  EXPECT_EQ(parser.counts().skipped_bytes, unknown.size());
}

// A receiver that looks on behind the length that garbage pretends misses what follows.
TEST(Parser, AFrameWithinWhatPretendedToBeOneIsFound) {
  const Bytes pretends = {kMagic, 255, 0, 0, 0, 1, 1, 0, 0, 0};
  Parser parser;

  EXPECT_THAT(parser.take(pretends + to_bytes(heartbeat(1))), IsEmpty()) << "it may go on";
  EXPECT_THAT(parser.take(kSilence), ElementsAre(heartbeat(1)));
}

RC_GTEST_PROP(Parser, GarbageBetweenFramesNeverLosesOne, ()) {
  Bytes stream;
  std::vector<Frame> sent;
  const auto count = *rc::gen::inRange(1, 30);
  // Bytes that begin frames are frequent in the garbage: the worst for whoever looks for them.
  const auto byte = rc::gen::weightedOneOf<std::uint8_t>({{3, rc::gen::arbitrary<std::uint8_t>()},
                                                          {1, rc::gen::just(kMagic)},
                                                          {2, rc::gen::just<std::uint8_t>(0)}});
  for (int i = 0; i < count; ++i) {
    stream = std::move(stream) + *rc::gen::container<Bytes>(byte);
    sent.push_back(to_frame(any_message(), {1, 1}, static_cast<std::uint8_t>(i)));
    stream = std::move(stream) + to_bytes(sent.back());
  }
  stream = std::move(stream) + kSilence;

  Parser parser;
  std::vector<Frame> found;
  for (std::size_t at = 0; at < stream.size();) {
    const auto piece =
        std::min<std::size_t>(*rc::gen::inRange<std::size_t>(1, 400), stream.size() - at);
    for (Frame& one : parser.take(std::span(stream).subspan(at, piece))) found.push_back(one);
    at += piece;
  }

  RC_ASSERT(found == sent);
  RC_ASSERT(parser.counts().frames == sent.size());
}

RC_GTEST_PROP(Parser, WhatIsNoFrameIsNotTakenForOne, ()) {
  Bytes frame = to_bytes(to_frame(any_message(), {1, 1}, 0));
  const auto at = *rc::gen::inRange<std::size_t>(1, frame.size());
  frame[at] ^= static_cast<std::uint8_t>(1U << *rc::gen::inRange(0U, 8U));
  Parser parser;

  // Marked as signed it is longer, and its checksum still wrong.
  RC_ASSERT(parser.take(frame + kSilence).empty());
}

}  // namespace
}  // namespace skein::mavlink
