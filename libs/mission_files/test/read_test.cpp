// SPDX-License-Identifier: Apache-2.0
#include "skein/mission_files/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace skein::mission_files {
namespace {

using ::testing::HasSubstr;

TEST(ReadText, TheFormatFollowsFromTheNameOrTheText) {
  EXPECT_EQ(format_of("a.PLAN", ""), Format::kPlan);
  EXPECT_EQ(format_of("a.txt", "QGC WPL 110\n"), Format::kWaypoints);
  EXPECT_EQ(format_of("a", "\xef\xbb\xbf  <kml/>"), Format::kKml);
  EXPECT_EQ(format_of("a.json", "{}"), Format::kPlan);
  EXPECT_EQ(format_of("a.kmz", "PK\x03\x04"), std::nullopt);
}

TEST(ReadText, AnUnknownFormatIsRefusedWithThoseThatAreKnown) {
  const auto read = read_text("PK\x03\x04", "a.kmz");

  ASSERT_FALSE(read);
  EXPECT_THAT(to_text(read.error()), HasSubstr("a.kmz: its format is not known; expected a plan"));
}

TEST(ReadText, TextOverSixteenMebibytesIsRefused) {
  const auto read = read_text(std::string(kMostBytes + 1, ' '), "a.kml");

  ASSERT_FALSE(read);
  EXPECT_THAT(to_text(read.error()), HasSubstr("larger than 16 MiB"));
}

TEST(ReadFile, AFileThatIsNotThereIsRefused) {
  const auto read = read_file("/no/such.plan");

  ASSERT_FALSE(read);
  EXPECT_EQ(to_text(read.error()), "/no/such.plan: cannot be read\n");
}

/// Well-formed beginnings with a piece of anything in the middle.
RC_GTEST_PROP(ReadText, AnyTextIsReadOrRefusedWithAReason, ()) {
  const auto begin =
      *rc::gen::element<std::string>("", "QGC WPL 110\n1 0 3 16 0 0 0 0 ",
                                     "{\"fileType\": \"Plan\", \"version\": 1, \"mission\": ",
                                     "<kml><Placemark><Point><coordinates>", "<kml><Folder>");
  const auto middle = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
  const auto end = *rc::gen::element<std::string>(
      "", "}", "</coordinates></Point></Placemark></kml>", "</Folder></kml>");

  const auto read = read_text(begin + middle + end, "any");

  RC_ASSERT(read.has_value() || !read.error().empty());
}

}  // namespace
}  // namespace skein::mission_files
