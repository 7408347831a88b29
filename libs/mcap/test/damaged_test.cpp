// SPDX-License-Identifier: Apache-2.0
// Files that were cut off, damaged, or never were any.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bytes.hpp"
#include "recorded.hpp"

namespace skein::mcap {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<Told> some(std::size_t count) {
  std::vector<Told> messages;
  for (std::size_t i = 0; i < count; ++i)
    messages.push_back({i % 3 == 0 ? "a" : "b", 100 * i, 100 * i, "message " + std::to_string(i)});
  return messages;
}

bool begins_with(const std::vector<Told>& all, const std::vector<Told>& some) {
  return some.size() <= all.size() && std::equal(some.begin(), some.end(), all.begin());
}

RC_GTEST_PROP(Cut, AnywhereAFileGivesWhatCameBeforeTheCut, ()) {
  const auto messages = *rc::gen::container<std::vector<Told>>(any_message());
  const std::string file = written(messages, *any_compression());
  const auto size = *rc::gen::inRange<std::size_t>(0, file.size());

  const Read back = read(std::string_view(file).substr(0, size));

  RC_ASSERT(begins_with(messages, back.messages));
  RC_ASSERT(!back.contents.complete);
  RC_ASSERT(!back.contents.problems.empty());
}

TEST(Cut, AfterAFlushNothingOfBeforeIsLost) {
  const auto messages = some(40);

  const Read back = read(written(messages, Compression::kZstd, 200, false));

  EXPECT_EQ(back.messages, messages);
  EXPECT_FALSE(back.contents.complete);
  EXPECT_THAT(back.contents.problems, Contains(HasSubstr("ends without a footer")));
}

TEST(Cut, WithinAnUncompressedChunkGivesTheMessagesThatAreWhole) {
  const auto messages = some(40);
  const std::string file = written(messages, Compression::kNone, 1'000'000);

  const Read back = read(std::string_view(file).substr(0, file.find("message 30")));

  EXPECT_EQ(back.messages.size(), 30U);
  EXPECT_TRUE(begins_with(messages, back.messages));
}

// One chunk of many is lost with its checksum; the others, and the end, are there.
TEST(Damaged, AChunkIsLeftOutAndTheOthersAreRead) {
  const auto messages = some(60);
  std::string file = written(messages, Compression::kNone, 300);
  file[file.find("message 31")] = 'M';

  const Read back = read(file);

  EXPECT_LT(back.messages.size(), 60U);
  EXPECT_GT(back.messages.size(), 40U);
  EXPECT_EQ(back.messages.back(), messages.back());
  EXPECT_THAT(back.contents.problems, Contains(HasSubstr("chunk whose checksum is wrong")));
  EXPECT_THAT(back.contents.problems, Contains(HasSubstr("of 60 that were written")));
}

// Whatever is changed: what is read was written, in that order, but for what no checksum covers.
RC_GTEST_PROP(Damaged, AnywhereAFileIsReadOrRefusedWithoutACrash, ()) {
  const auto compression = *any_compression();
  std::string file = written(some(20), compression);
  for (const auto& [at, to] :
       *rc::gen::container<std::vector<std::pair<std::size_t, char>>>(rc::gen::pair(
           rc::gen::inRange<std::size_t>(0, file.size()), rc::gen::arbitrary<char>())))
    file[at] = to;
  ScanLimits limits;
  limits.chunk = 1 << 20;

  const Read back = read(file, limits);

  RC_ASSERT(back.contents.messages == back.messages.size());
}

RC_GTEST_PROP(Foreign, BytesAreRefused, (const std::string& bytes)) {
  const Read back = read(bytes);

  RC_ASSERT(back.messages.empty());
  RC_ASSERT(!back.contents.begun);
}

TEST(Foreign, AChunkThatSaysItIsHugeTakesNoMemory) {
  Bytes chunk, header;
  header.put(std::string_view("")).put(std::string_view("x"));
  chunk.put(std::uint64_t{0}).put(std::uint64_t{0}).put(std::uint64_t{1} << 60);
  chunk.put(std::uint32_t{1}).put(std::string_view("zstd")).put(std::uint64_t{0});
  const std::string file =
      std::string(kMagic) + record(Op::kHeader, header.text()) + record(Op::kChunk, chunk.text());

  EXPECT_THAT(read(file).contents.problems, Contains(HasSubstr("is too large")));
}

TEST(Foreign, RecordsOfLaterVersionsArePassedOver) {
  std::string file = written(some(3), Compression::kNone, 10'000);
  file.insert(kMagic.size(), record(static_cast<Op>(0x77), "whatever"));

  EXPECT_EQ(read(file).messages, some(3));
}

TEST(Foreign, MessagesWithoutAChannelAreTold) {
  Bytes message;
  message.put(ChannelId{9}).put(std::uint32_t{1}).put(std::uint64_t{1}).put(std::uint64_t{1});
  const std::string file = std::string(kMagic) + record(Op::kMessage, message.text());

  const Read back = read(file);

  EXPECT_THAT(back.messages, IsEmpty());
  EXPECT_THAT(back.contents.problems, Contains(HasSubstr("channel 9, which is not declared")));
}

TEST(Foreign, ProblemsAreToldUpToALimitAndCounted) {
  Bytes message;
  message.put(ChannelId{9}).put(std::uint32_t{1}).put(std::uint64_t{1}).put(std::uint64_t{1});
  std::string file(kMagic);
  for (int i = 0; i < 150; ++i) file += record(Op::kMessage, message.text());

  const Contents contents = read(file).contents;

  EXPECT_EQ(contents.problems.size(), 100U);
  EXPECT_GE(contents.more_problems, 50U);
}

}  // namespace
}  // namespace skein::mcap
