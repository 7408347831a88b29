// SPDX-License-Identifier: Apache-2.0
#include "skein/journal/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "skein/foundation/random.hpp"

namespace skein::journal {
namespace {

Record a_record() { return Record(MissionTime::nanoseconds(12'500'000'001), "marvin", "task"); }

TEST(Record, KeysComeInTheOrderGiven) {
  const Record record = a_record()
                            .with("uav", "marvin")
                            .with("task", 2)
                            .with("ok", true)
                            .with("position", std::vector<double>{1, 2.5, -3});

  EXPECT_EQ(to_json(record),
            R"({"at":12.500000001,"node":"marvin","kind":"task","uav":"marvin","task":2,"ok":true,)"
            R"("position":[1,2.5,-3]})");
}

TEST(Record, ReadsBackWhatItWrote) {
  const Record record = a_record().with("t", "quotes \" and \n lines").with("x", 0.1).with("n", -7);

  const auto again = parse_record(to_json(record));

  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(*again, record);
}

TEST(Record, WhatIsNotANumberOrNotUtf8DoesNotBreakTheLine) {
  const Record record = a_record()
                            .with("x", std::numeric_limits<double>::quiet_NaN())
                            .with("bad", std::string("\xff\xfe"));

  EXPECT_TRUE(parse_record(to_json(record)).has_value());
}

TEST(Record, HugeIdsKeepTheirDigits) {
  EXPECT_NE(to_json(a_record().with("id", std::uint64_t{18446744073709551615U}))
                .find("\"18446744073709551615\""),
            std::string::npos);
}

TEST(Record, LinesThatAreNoRecordsSayWhy) {
  EXPECT_EQ(parse_record("[]").error().why, "not a JSON object");
  EXPECT_EQ(parse_record("{").error().why, "not a JSON object");
  EXPECT_EQ(parse_record("{}").error().why, "'at' is missing or not a number");
  EXPECT_EQ(parse_record(R"({"at":1,"kind":"x"})").error().why, "'node' is missing or not text");
}

TEST(Record, FieldsAreFoundByKeyAndKind) {
  const Record record =
      a_record().with("n", 4).with("t", "x").with("b", true).with("p", std::vector<double>{1, 2});

  EXPECT_EQ(record.number("n"), 4);
  EXPECT_EQ(record.number("t", -1), -1);
  EXPECT_EQ(record.text("t"), "x");
  EXPECT_EQ(record.text("n"), "");
  EXPECT_TRUE(record.truth("b"));
  EXPECT_FALSE(record.truth("n"));
  EXPECT_EQ(record.numbers("p").size(), 2U);
  EXPECT_EQ(record.find("absent"), nullptr);
}

Value any_value(Random& random) {
  switch (random.below(5)) {
    case 0:
      return random.chance(0.5);
    case 1:
      return static_cast<std::int64_t>(random.bits() >> random.below(64));
    case 2:
      return random.normal() * std::pow(10.0, random.uniform(-12, 12));
    case 3: {
      std::string text;
      for (std::uint64_t i = random.below(12); i > 0; --i)
        text += static_cast<char>(1 + random.below(127));
      return text;
    }
    default:
      break;
  }
  std::vector<double> list;
  for (std::uint64_t i = random.below(4); i > 0; --i) list.push_back(random.uniform(-1e4, 1e4));
  return list;
}

// A whole double is written without a point and reads back as an integer of the same value.
bool same_meaning(const Value& a, const Value& b) {
  if (const auto* number = std::get_if<double>(&a)) {
    const auto* whole = std::get_if<std::int64_t>(&b);
    if (whole != nullptr) return static_cast<double>(*whole) == *number;
  }
  return a == b;
}

TEST(RecordLaws, EveryRecordReadsBackWithTheSameMeaning) {
  Random random(11);
  for (int trial = 0; trial < 2000; ++trial) {
    Record record(
        MissionTime::nanoseconds(static_cast<std::int64_t>(random.below(8'000'000'000'000))),
        "marvin", "task");
    for (int i = 0; i < 4; ++i) record.with("k" + std::to_string(i), any_value(random));

    const auto again = parse_record(to_json(record));

    ASSERT_TRUE(again.has_value()) << to_json(record);
    EXPECT_EQ(again->at(), record.at());
    ASSERT_EQ(again->fields().size(), record.fields().size()) << to_json(record);
    for (std::size_t i = 0; i < record.fields().size(); ++i) {
      EXPECT_TRUE(same_meaning(record.fields()[i].second, again->fields()[i].second))
          << to_json(record);
    }
    EXPECT_EQ(to_json(*again), to_json(record));
  }
}

TEST(RecordLaws, FieldsThatNoRecordHasAreDropped) {
  const auto record = parse_record(
      R"({"at":1,"node":"n","kind":"k","object":{"a":1},"mixed":[1,"x"],"nothing":null,"ok":2})");

  ASSERT_TRUE(record.has_value());
  ASSERT_EQ(record->fields().size(), 1U);
  EXPECT_EQ(record->number("ok"), 2);
}

TEST(RecordLaws, InstantsOutOfRangeSaturateAndDoNotTrap) {
  for (const char* at : {"1e300", "-1e300", "9223372036.9", "0.0000000001"}) {
    const auto record = parse_record(std::string(R"({"at":)") + at + R"(,"node":"n","kind":"k"})");
    EXPECT_TRUE(record.has_value()) << at;
  }
  EXPECT_FALSE(parse_record(R"({"at":"1","node":"n","kind":"k"})").has_value());
}

struct Wrong {
  const char* line;
  const char* why;
};

TEST(Record, EveryPartThatEachLineMustHaveIsAskedFor) {
  const std::vector<Wrong> all = {
      {"", "not a JSON object"},
      {"12", "not a JSON object"},
      {R"("text")", "not a JSON object"},
      {R"({"at":1} {"at":2})", "not a JSON object"},
      {R"({"at":1,"node":"n","kind":"k")", "not a JSON object"},
      {R"({"node":"n","kind":"k"})", "'at' is missing or not a number"},
      {R"({"at":null,"node":"n","kind":"k"})", "'at' is missing or not a number"},
      {R"({"at":[1],"node":"n","kind":"k"})", "'at' is missing or not a number"},
      {R"({"at":true,"node":"n","kind":"k"})", "'at' is missing or not a number"},
      {R"({"at":1,"node":4,"kind":"k"})", "'node' is missing or not text"},
      {R"({"at":1,"node":"n"})", "'kind' is missing or not text"},
      {R"({"at":1,"node":"n","kind":null})", "'kind' is missing or not text"},
  };
  for (const Wrong& one : all) {
    const auto read = parse_record(one.line);
    ASSERT_FALSE(read.has_value()) << one.line;
    EXPECT_EQ(read.error().why, one.why) << one.line;
  }
}

TEST(Record, NoPrefixOfALineIsALine) {
  const std::string whole = to_json(
      a_record().with("t", "x \" y").with("p", std::vector<double>{1, 2.5}).with("b", true));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(parse_record(whole.substr(0, size)).has_value()) << whole.substr(0, size);
}

TEST(Rounded, ToAThousandth) {
  EXPECT_EQ(rounded(1.23456), 1.235);
  EXPECT_EQ(rounded(std::vector<double>{-0.0004, 2}), (std::vector<double>{0, 2}));
}

}  // namespace
}  // namespace skein::journal
