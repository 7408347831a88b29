// SPDX-License-Identifier: Apache-2.0
// What is told of each thing that can be wrong with a file, and at which byte. The bytes are put
// together by hand, after the specification of MCAP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bytes.hpp"
#include "recorded.hpp"

namespace skein::mcap {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// 8 bytes, where the first record begins; a header has 9 + 4 + 4 bytes, so the next begins at 25.
std::string begun() {
  return std::string(kMagic) +
         record(Op::kHeader, Bytes().put(std::string_view()).put(std::string_view()).text());
}

std::string footer(std::uint64_t summary = 0, std::uint32_t crc = 0) {
  return record(Op::kFooter, Bytes().put(summary).put(std::uint64_t{0}).put(crc).text());
}

std::string whole(const std::string& records) {
  return begun() + records + footer() + std::string(kMagic);
}

std::string channel_and_schema() {
  return record_of(SchemaId{1}, Schema{"S", "jsonschema", "{}"}) +
         record_of(ChannelId{1}, Channel{SchemaId{1}, "t", "json", {}});
}

std::string message(std::string_view data) {
  Bytes bytes;
  bytes.put(ChannelId{1}).put(std::uint32_t{7}).put(std::uint64_t{20}).put(std::uint64_t{10});
  return record(Op::kMessage, bytes.raw(data).text());
}

struct ChunkOf {
  std::string records;
  std::string compression = "";
  std::uint32_t crc = 0;
  std::int64_t size_off = 0;  ///< what it says of its size beyond the truth
};
std::string chunk(const ChunkOf& what) {
  Bytes bytes;
  bytes.put(std::uint64_t{0}).put(std::uint64_t{0});
  bytes.put(what.records.size() + static_cast<std::uint64_t>(what.size_off)).put(what.crc);
  bytes.put(std::string_view(what.compression)).put(std::uint64_t{what.records.size()});
  return record(Op::kChunk, bytes.raw(what.records).text());
}

TEST(Problems, OfAWholeFileThereAreNone) {
  const Read back = read(whole(channel_and_schema() + message("x") + chunk({message("y")})));

  EXPECT_THAT(back.contents.problems, IsEmpty());
  EXPECT_TRUE(back.contents.complete);
  EXPECT_EQ(back.messages, (std::vector<Told>{{"t", 20, 10, "x"}, {"t", 20, 10, "y"}}));
}

struct Problem {
  const char* what;
  std::string file;
  const char* told;
};

std::vector<Problem> problems_of_records() {
  const std::string crc_of_y = message("y");
  return {
      {"no record of a schema is shorter than its id", whole(record(Op::kSchema, "\x01")),
       "byte 25: a schema that is too short"},
      {"a channel without its topic", whole(record(Op::kChannel, std::string(4, '\0'))),
       "byte 25: a channel that is too short"},
      {"a message without its times", whole(record(Op::kMessage, std::string(6, '\0'))),
       "byte 25: a message that is too short"},
      {"metadata without facts",
       whole(record(Op::kMetadata, Bytes().put(std::string_view("run")).text())),
       "byte 25: metadata that are too short"},
      {"a chunk of nothing at all", whole(record(Op::kChunk, "")),
       "byte 25: a chunk that is too short"},
      {"a compression that nobody knows", whole(chunk({"", "brotli"})),
       "byte 25: a chunk compressed by 'brotli'"},
      {"a chunk that says it is longer", whole(chunk({crc_of_y, "", 0, 5})),
       "byte 25: a chunk that does not come out of its compression"},
      {"text that is no zstd", whole(chunk({"not compressed", "zstd"})),
       "byte 25: a chunk that does not come out of its compression"},
      {"text that is no lz4", whole(chunk({"not compressed", "lz4"})),
       "byte 25: a chunk that does not come out of its compression"},
      {"a chunk whose checksum is another", whole(chunk({crc_of_y, "", 1})),
       "byte 25: a chunk whose checksum is wrong"},
      {"an end of data without checksum", whole(record(Op::kDataEnd, "\x01")),
       "byte 25: an end of data that is too short"},
      {"an end of data with another checksum",
       whole(record(Op::kDataEnd, Bytes().put(std::uint32_t{1}).text())),
       "byte 25: the checksum of the data is wrong"},
      {"a summary before which there is nothing", begun() + footer(1000, 5) + std::string(kMagic),
       "byte 25: the checksum of the summary is wrong"},
      {"a summary with another checksum", begun() + footer(25, 5) + std::string(kMagic),
       "byte 25: the checksum of the summary is wrong"},
      {"something behind the end", whole("") + "x",
       "byte 54: the end of the file is missing, or something follows it"},
      {"no magic at the end", begun() + footer(),
       "byte 54: the end of the file is missing, or something follows it"},
      {"no footer", begun(), "byte 25: it ends without a footer"},
      {"another beginning", "\x89MCAP1\r\n", "byte 0: this does not begin as an MCAP file does"},
      {"half a record", begun() + "\x04\x01", "byte 25: it was cut off within a record"},
      {"messages that are missing",
       whole(record(Op::kStatistics, Bytes().put(std::uint64_t{3}).text())),
       "byte 79: 0 messages were read of 3 that were written"},
  };
}

TEST(Problems, AreToldWithTheByteWhereTheyAre) {
  for (const Problem& one : problems_of_records())
    EXPECT_THAT(read(one.file).contents.problems, ElementsAre(one.told)) << one.what;
}

TEST(Problems, AnIdThatIsGivenAgainMustMeanTheSame) {
  const std::string other = record_of(SchemaId{1}, Schema{"Other", "jsonschema", "{}"});

  EXPECT_THAT(read(whole(channel_and_schema() + channel_and_schema())).contents.problems,
              IsEmpty());
  const Read back = read(whole(channel_and_schema() + other));
  const std::size_t at = begun().size() + channel_and_schema().size();
  EXPECT_THAT(back.contents.problems,
              ElementsAre("byte " + std::to_string(at) + ": schema 1 again, and another"));
  EXPECT_EQ(back.contents.schemas.at(SchemaId{1}).name, "S") << "the first counts";
}

TEST(Problems, OfOneRecordDoNotHideTheNext) {
  const Read back = read(whole(channel_and_schema() + record(Op::kMessage, "") + message("x")));

  EXPECT_EQ(back.messages.size(), 1U);
  EXPECT_EQ(back.contents.problems.size(), 1U);
}

TEST(Problems, AChunkWithinAChunkIsPassedOver) {
  const Read back = read(whole(channel_and_schema() + chunk({chunk({message("inner")})})));

  EXPECT_THAT(back.messages, IsEmpty());
  EXPECT_THAT(back.contents.problems, IsEmpty());
}

TEST(Problems, WhatStandsInTheSummaryIsNoMessageOfTheData) {
  const std::string end = record(Op::kDataEnd, Bytes().put(std::uint32_t{0}).text());
  const Read back = read(whole(channel_and_schema() + message("x") + end + message("again")));

  EXPECT_EQ(back.messages, (std::vector<Told>{{"t", 20, 10, "x"}}));
}

// The check value of CRC-32/ISO-HDLC for "123456789".
TEST(Crc32, IsThatOfTheCatalogueWholeOrInPieces) {
  EXPECT_EQ(crc32_of("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc32_of("56789", crc32_of("1234")), 0xCBF43926U);
  EXPECT_EQ(crc32_of(""), 0U);
}

// ---- maps of metadata ----

RC_GTEST_PROP(Bytes, AMapIsReadBackAndNothingBehindIt, ()) {
  const auto map = *rc::gen::arbitrary<std::map<std::string, std::string>>();
  const std::string text = Bytes().put(map).raw("rest").text();

  Taker taker(text);

  RC_ASSERT(taker.map() == map);
  RC_ASSERT(taker.good());
  RC_ASSERT(taker.left() == "rest");
}

RC_GTEST_PROP(Bytes, AMapThatIsCutIsNotGood, ()) {
  auto map = *rc::gen::arbitrary<std::map<std::string, std::string>>();
  map["key"] = "value";
  const std::string text = Bytes().put(map).text();
  const auto size = *rc::gen::inRange<std::size_t>(0, text.size());

  Taker taker(std::string_view(text).substr(0, size));
  taker.map();

  RC_ASSERT(!taker.good());
  RC_ASSERT(taker.take<std::uint8_t>() == 0);  // once something is not there, nothing is
}

TEST(Bytes, AMapWhoseLastEntryIsBrokenIsNotGood) {
  Bytes entries;
  entries.put(std::string_view("a")).put(std::string_view("1")).put(std::string_view("b"));
  const std::string text = Bytes().put(std::string_view(entries.text())).text();

  Taker taker(text);

  EXPECT_EQ(taker.map(), (std::map<std::string, std::string>{{"a", "1"}}));
  EXPECT_FALSE(taker.good());
}

}  // namespace
}  // namespace skein::mcap
