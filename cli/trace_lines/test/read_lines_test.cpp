// SPDX-License-Identifier: Apache-2.0
#include "skein/trace_lines/read_lines.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace skein::trace_lines {
namespace {

struct Seen {
  std::vector<std::string> lines;
  bool whole = false;
};

Seen seen_in(const std::string& text) {
  Seen seen;
  std::istringstream in(text);
  std::ostringstream out;
  seen.whole = read_lines(
      in, out,
      [&](std::size_t number, const std::string& line) {
        seen.lines.push_back(std::to_string(number) + ": " + line);
      },
      [&](std::size_t number, const std::string& why) {
        seen.lines.push_back(std::to_string(number) + ": wrong: " + why);
      });
  return seen;
}

TEST(ReadLines, GivesEachLineWithItsNumberAndSkipsBlankOnes) {
  const Seen seen = seen_in("a\n\n \t\r\nb");

  EXPECT_EQ(seen.lines, (std::vector<std::string>{"1: a", "4: b"}));
  EXPECT_TRUE(seen.whole);
}

TEST(ReadLines, ALineThatIsTooLongIsWrongAndTheRestGoesOn) {
  const Seen seen = seen_in(std::string((1 << 20) + 1, 'x') + "\nb\n");

  EXPECT_EQ(seen.lines, (std::vector<std::string>{"1: wrong: longer than 1048576 bytes", "2: b"}));
}

TEST(ReadLines, AnEmptyTraceHasNoLines) { EXPECT_TRUE(seen_in("").lines.empty()); }

}  // namespace
}  // namespace skein::trace_lines
