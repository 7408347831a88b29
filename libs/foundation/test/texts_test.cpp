// SPDX-License-Identifier: Apache-2.0
// Texts for people: joined, printable, and times to a tenth.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "skein/foundation/joined.hpp"
#include "skein/foundation/printable.hpp"
#include "skein/foundation/random.hpp"
#include "skein/foundation/rounded_seconds.hpp"

namespace skein {
namespace {

TEST(Joined, HasTheSeparatorOnlyBetween) {
  EXPECT_EQ(joined({}, ", "), "");
  EXPECT_EQ(joined({"a"}, ", "), "a");
  EXPECT_EQ(joined({"a", "b", "c"}, "; "), "a; b; c");
}

TEST(Joined, EmptyTextsLeaveNothingAtTheFrontAndASeparatorBehind) {
  EXPECT_EQ(joined({"", "", "a"}, ", "), "a");
  EXPECT_EQ(joined({"a", "", "b"}, ", "), "a, , b");
}

const std::string kReplaced = "\xEF\xBF\xBD";

TEST(Printable, TakesWhatMovesTheCursorOrColours) {
  EXPECT_EQ(printable("\x1b[31mred\x1b[0m"), kReplaced + "[31mred" + kReplaced + "[0m");
  EXPECT_EQ(printable("a\rb\bc\x7f"), "a" + kReplaced + "b" + kReplaced + "c" + kReplaced);
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a" + kReplaced + "b");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            kReplaced + "31m")
      << "CSI as one character of C1";
  EXPECT_EQ(printable("\xC2"), "\xC2") << "the end of the text is no C1";
}

TEST(Printable, LeavesTextAsItIs) {
  for (const std::string text :
       {"", "Lousã 🚁 détection", "a\tb\nc", "\xC2\xA0no-break", "\xC2\xBF"})
    EXPECT_EQ(printable(text), text);
}

TEST(PrintableLaws, DoneTwiceIsAsDoneOnceAndNothingControlsIsLeft) {
  Random random(5);
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text;
    for (std::uint64_t i = random.below(20); i > 0; --i)
      text += static_cast<char>(random.chance(0.3) ? 0xC2 : random.below(256));

    const std::string shown = printable(text);

    EXPECT_EQ(printable(shown), shown);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const auto byte = static_cast<unsigned char>(shown[i]);
      EXPECT_TRUE(byte >= ' ' || byte == '\t' || byte == '\n');
      EXPECT_NE(byte, 0x7F);
      const bool introduces = byte == 0xC2 && i + 1 < shown.size();
      const auto next = static_cast<unsigned char>(introduces ? shown[i + 1] : ' ');
      EXPECT_FALSE(introduces && next >= 0x80 && next < 0xA0);
    }
  }
}

TEST(InSeconds, IsRoundedToATenthWithoutNoughts) {
  EXPECT_EQ(in_seconds(Duration::seconds(12.34)), "12.3 s");
  EXPECT_EQ(in_seconds(Duration::seconds(12.36)), "12.4 s");
  EXPECT_EQ(in_seconds(Duration::seconds(12.04)), "12 s");
  EXPECT_EQ(in_seconds(Duration::seconds(-0.04)), "0 s");
  EXPECT_EQ(in_seconds(Duration::seconds(-1.25)), "-1.3 s");
  EXPECT_EQ(in_seconds(MissionTime::seconds(3600)), "3600 s");
}

TEST(InSeconds, TheGreatestIsForEverAndWhatIsNearlySoGreatIsANumber) {
  EXPECT_EQ(in_seconds(Duration::max()), "for ever");
  EXPECT_EQ(in_seconds(MissionTime::max()), "for ever");
  const std::int64_t most = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(in_seconds(Duration::nanoseconds(most - 1)).substr(0, 10), "9223372036");
  EXPECT_EQ(in_seconds(Duration::nanoseconds(-most)).substr(0, 11), "-9223372036");
}

TEST(InSecondsLaws, IsWithinATwentiethOfTheTime) {
  Random random(6);
  for (int trial = 0; trial < 2000; ++trial) {
    const double seconds = random.uniform(-1e5, 1e5);
    const std::string text = in_seconds(Duration::seconds(seconds));
    EXPECT_LE(std::abs(std::stod(text) - seconds), 0.05 + 1e-6) << text;
    const std::size_t point = text.find('.');
    EXPECT_TRUE(point == std::string::npos || text.size() == point + 4) << text;
  }
}

}  // namespace
}  // namespace skein
