// SPDX-License-Identifier: Apache-2.0
// Where things stand in a file, by the format's own words.
#include "skein/mcap/writer.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "bytes.hpp"
#include "recorded.hpp"

namespace skein::mcap {
namespace {

std::uint64_t number_at(const std::string& file, std::size_t at) {
  std::uint64_t number = 0;
  std::memcpy(&number, file.data() + at, sizeof number);
  return number;
}

struct Footer {
  std::uint64_t summary = 0, offsets = 0;
};

Footer footer_of(const std::string& file) {
  const std::size_t at = file.size() - kMagic.size() - 20;
  return {number_at(file, at), number_at(file, at + 8)};
}

/// Offsets of the records of that kind from `from` on.
std::vector<std::size_t> records_of(const std::string& file, Op op, std::size_t from) {
  std::vector<std::size_t> found;
  while (from + kRecordHead <= file.size() - kMagic.size()) {
    if (file[from] == static_cast<char>(op)) found.push_back(from);
    from += kRecordHead + number_at(file, from + 1);
  }
  return found;
}

std::string many() {
  std::vector<Told> messages;
  for (std::uint64_t i = 0; i < 50; ++i)
    messages.push_back({i % 2 == 0 ? "a" : "b", 1000 - i, i, std::string(20, 'x')});
  return written(messages, Compression::kNone, 400);
}

TEST(Writer, PutsEveryChunkIntoTheIndexWithItsPlace) {
  const std::string file = many();
  const auto chunks = records_of(file, Op::kChunk, kMagic.size());
  const auto indexes = records_of(file, Op::kChunkIndex, footer_of(file).summary);

  ASSERT_GT(chunks.size(), 3U);
  ASSERT_EQ(indexes.size(), chunks.size());
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const std::size_t content = indexes[i] + kRecordHead;
    EXPECT_EQ(number_at(file, content + 16), chunks[i]);
    EXPECT_EQ(number_at(file, content + 24), kRecordHead + number_at(file, chunks[i] + 1));
    EXPECT_LE(number_at(file, content), number_at(file, content + 8));
  }
}

TEST(Writer, IndexesEveryMessageOfAChunkByItsPlace) {
  const std::string file = many();
  const std::size_t chunk = records_of(file, Op::kChunk, kMagic.size()).front();
  const std::size_t after = chunk + kRecordHead + number_at(file, chunk + 1);
  ASSERT_EQ(file[after], static_cast<char>(Op::kMessageIndex));
  const std::size_t records = chunk + kRecordHead + 28 + 4 + 8;  // no compression: an empty name
  const std::size_t entries = after + kRecordHead + 2 + 4;

  const std::uint64_t time = number_at(file, entries);
  const std::size_t message = records + number_at(file, entries + 8);

  EXPECT_EQ(file[message], static_cast<char>(Op::kMessage));
  EXPECT_EQ(number_at(file, message + kRecordHead + 6), time);
}

TEST(Writer, TellsWhereEachGroupOfTheSummaryIs) {
  const std::string file = many();
  const auto offsets = records_of(file, Op::kSummaryOffset, footer_of(file).offsets);

  ASSERT_EQ(offsets.size(), 4U);
  for (const std::size_t at : offsets) {
    const std::size_t content = at + kRecordHead;
    EXPECT_EQ(file[number_at(file, content + 1)], file[content]);
  }
}

TEST(Writer, CountsMessagesAndSpansTheirTimes) {
  const std::string file = many();
  const std::size_t statistics =
      records_of(file, Op::kStatistics, footer_of(file).summary).at(0) + kRecordHead;

  EXPECT_EQ(number_at(file, statistics), 50U);
  EXPECT_EQ(number_at(file, statistics + 26), 951U);
  EXPECT_EQ(number_at(file, statistics + 34), 1000U);
}

TEST(Writer, GivesTheSinkTheWholeFileInOrder) {
  std::string file;
  Writer writer({}, [&](std::string_view bytes) { file.append(bytes); });
  const ChannelId channel = writer.add(Channel{0, "t", "json"});
  writer.write(channel, 1, "{}");
  EXPECT_EQ(writer.bytes(), file.size());

  writer.close();
  writer.close();

  EXPECT_EQ(writer.bytes(), file.size());
  EXPECT_EQ(writer.messages(), 1U);
  EXPECT_TRUE(file.ends_with(kMagic));
  EXPECT_TRUE(file.starts_with(kMagic));
}

}  // namespace
}  // namespace skein::mcap
