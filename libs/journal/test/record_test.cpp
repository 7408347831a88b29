// SPDX-License-Identifier: Apache-2.0
#include "skein/journal/record.hpp"

#include <gtest/gtest.h>

#include <limits>

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

TEST(Rounded, ToAThousandth) {
  EXPECT_EQ(rounded(1.23456), 1.235);
  EXPECT_EQ(rounded(std::vector<double>{-0.0004, 2}), (std::vector<double>{0, 2}));
}

}  // namespace
}  // namespace skein::journal
