// SPDX-License-Identifier: Apache-2.0
// Whatever the encoding of a file, it says the same.
#include "text_encoding.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "diagnostics_text.hpp"
#include "skein/temporal_files/network_text.hpp"

namespace skein::temporal {
namespace {

using ::testing::HasSubstr;

enum class Order { kBig, kLittle };

/// By the definition of UTF-16, from code points.
std::string utf16_of(const std::vector<std::uint32_t>& codes, Order order, bool mark) {
  std::string text;
  const auto add = [&](std::uint32_t unit) {
    const std::string bytes{static_cast<char>(unit >> 8U), static_cast<char>(unit & 0xFFU)};
    text += order == Order::kBig ? bytes : std::string(bytes.rbegin(), bytes.rend());
  };
  if (mark) add(0xFEFF);
  for (const std::uint32_t code : codes) {
    if (code < 0x10000) {
      add(code);
    } else {
      add(0xD800 + ((code - 0x10000) >> 10U));
      add(0xDC00 + ((code - 0x10000) & 0x3FFU));
    }
  }
  return text;
}

std::string utf16_of(const std::string& ascii, Order order, bool mark) {
  return utf16_of(std::vector<std::uint32_t>(ascii.begin(), ascii.end()), order, mark);
}

TEST(TextEncoding, GivesTheCharactersOfEveryPlane) {
  Problems problems("");
  const std::vector<std::uint32_t> codes{'{', 0xE9, 0x221E, 0x1F681};
  for (const Order order : {Order::kBig, Order::kLittle}) {
    for (const bool mark : {true, false}) {
      const std::string text = utf16_of(codes, order, mark);

      ASSERT_TRUE(is_utf16(text));
      EXPECT_EQ(utf8_from_utf16(text, problems), "{é∞\xF0\x9F\x9A\x81");
    }
  }
  EXPECT_TRUE(problems.none());
}

TEST(TextEncoding, RefusesHalvesOfCharacters) {
  for (const std::string& half :
       {std::string("\xFE\xFF\0{\xD8\x00", 6), std::string("\xFE\xFF\xDC\x00\0{", 6),
        std::string("\xFE\xFF\xD8\x00\0{", 6), std::string("\xFE\xFF\0{\0", 5)}) {
    EXPECT_THAT(errors_of(read_network(half)), HasSubstr("not UTF-16"));
  }
}

TEST(TextEncoding, TakesNoUtf8ForUtf16) {
  EXPECT_FALSE(is_utf16(""));
  EXPECT_FALSE(is_utf16("{"));
  EXPECT_FALSE(is_utf16("{}"));
  EXPECT_FALSE(is_utf16("\xEF\xBB\xBF{}"));
  EXPECT_FALSE(is_utf16(std::string(4, '\0')));
}

RC_GTEST_PROP(TextEncoding, NoFormatReadsOtherwiseInUtf16, ()) {
  const Stnu network{{"Z", "a", "b"}, 0, {{0, 1, 0, 9 * kTicksPerSecond}}, {{1, 2, 5, 7}}};
  for (const Format format : {Format::kJson, Format::kHeatlab, Format::kGraphml, Format::kPlain}) {
    const std::string text = write_network(network, format).value();
    std::string ascii = text;
    for (std::size_t at; (at = ascii.find("⊡")) != std::string::npos;) ascii.erase(at, 3);
    const auto order = *rc::gen::element(Order::kBig, Order::kLittle);
    const bool mark = *rc::gen::arbitrary<bool>();

    const auto read = read_network(utf16_of(ascii, order, mark));

    RC_ASSERT(errors_of(read) == "");
    RC_ASSERT(read->network == read_network(text)->network);
  }
}

TEST(TextEncoding, AnXmlDeclarationMayNameIt) {
  const std::string text =
      "<?xml version='1.0' encoding='UTF-16'?><graphml><graph><node id='Z'/></graph></graphml>";

  EXPECT_EQ(errors_of(read_network(utf16_of(text, Order::kLittle, true))), "");
}

}  // namespace
}  // namespace skein::temporal
