// SPDX-License-Identifier: Apache-2.0
#include "text.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>
#include <limits>

namespace skein::report {
namespace {

TEST(Escape, MarkupCharactersBecomeEntities) {
  EXPECT_EQ(escape("<script>alert('a' & \"b\")</script>"),
            "&lt;script&gt;alert(&#39;a&#39; &amp; &quot;b&quot;)&lt;/script&gt;");
}

TEST(Escape, GoodUtf8IsKept) {
  EXPECT_EQ(escape("Lousã – détection ✓ 🚁"), "Lousã – détection ✓ 🚁");
  EXPECT_EQ(escape("a\tb\nc\rd"), "a\tb\nc\rd");
}

TEST(Escape, WhatXmlForbidsIsReplaced) {
  const std::string bad = "\xEF\xBF\xBD";

  EXPECT_EQ(escape(std::string("a\0b", 3)), "a" + bad + "b");
  EXPECT_EQ(escape("\x1b[31m"), bad + "[31m");
  EXPECT_EQ(escape("\xff"), bad);
  EXPECT_EQ(escape("\xc0\xaf"), bad + bad);                      // overlong '/'
  EXPECT_EQ(escape("\xed\xa0\x80"), bad + bad + bad);            // a surrogate
  EXPECT_EQ(escape("\xef\xbf\xbf"), bad + bad + bad);            // U+FFFF
  EXPECT_EQ(escape("\xf4\x90\x80\x80"), bad + bad + bad + bad);  // beyond Unicode
  EXPECT_EQ(escape("\xe2\x82"), bad + bad);                      // cut off
}

RC_GTEST_PROP(Escape, NoBytesCanOpenAnElementOrCloseAnAttribute, (const std::string& text)) {
  const std::string safe = escape(text);

  RC_ASSERT(safe.find_first_of("<>\"'") == std::string::npos);
  for (const char c : safe) {
    RC_ASSERT(static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n' || c == '\r');
  }
}

RC_GTEST_PROP(Escape, EveryAmpersandBeginsAnEntity, (const std::string& text)) {
  const std::string safe = escape(text + "&" + text);

  for (std::size_t i = safe.find('&'); i != std::string::npos; i = safe.find('&', i + 1)) {
    const std::string entity = safe.substr(i, safe.find(';', i) - i + 1);
    RC_ASSERT(entity == "&amp;" || entity == "&lt;" || entity == "&gt;" || entity == "&quot;" ||
              entity == "&#39;");
  }
}

TEST(ShortNumber, HasNoTrailingZerosAndNoNegativeZero) {
  EXPECT_EQ(short_number(12.0), "12");
  EXPECT_EQ(short_number(12.34, 1), "12.3");
  EXPECT_EQ(short_number(12.5, 3), "12.5");
  EXPECT_EQ(short_number(-0.01, 1), "0");
  EXPECT_EQ(short_number(100, 0), "100");
}

TEST(ShortNumber, WhatIsNotFiniteIsZero) {
  EXPECT_EQ(short_number(std::nan("")), "0");
  EXPECT_EQ(short_number(std::numeric_limits<double>::infinity()), "0");
}

TEST(FixedNumber, KeepsItsDecimals) {
  EXPECT_EQ(fixed_number(12.0, 1), "12.0");
  EXPECT_EQ(fixed_number(-0.001, 1), "0.0");
  EXPECT_EQ(fixed_number(std::nan(""), 1), "–");
}

TEST(Grouped, PutsThinSpacesBetweenThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1\u202F000");
  EXPECT_EQ(grouped(1234567), "1\u202F234\u202F567");
}

TEST(ClockText, ShowsHoursOnlyWhenThereAreAny) {
  EXPECT_EQ(clock_text(0), "0:00");
  EXPECT_EQ(clock_text(65.9), "1:05");
  EXPECT_EQ(clock_text(3607), "1:00:07");
  EXPECT_EQ(clock_text(-10), "-0:10");
  EXPECT_EQ(clock_text(-0.4), "0:00");
  EXPECT_EQ(clock_text(std::nan("")), "–");
}

TEST(LengthText, ChoosesItsUnit) {
  EXPECT_EQ(length_text(3.14159), "3.1 m");
  EXPECT_EQ(length_text(850.2), "850 m");
  EXPECT_EQ(length_text(12345), "12.3 km");
}

TEST(SpanText, ChoosesItsUnit) {
  EXPECT_EQ(span_text(0.0021), "2.1 ms");
  EXPECT_EQ(span_text(0.035), "35 ms");
  EXPECT_EQ(span_text(4.24), "4.2 s");
  EXPECT_EQ(span_text(725), "12 min 05 s");
}

TEST(Shortened, CutsAtCharactersNotBytes) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "ab…");
  EXPECT_EQ(shortened("ãéîõ", 3), "ãé…");
  EXPECT_EQ(character_count("ãéî…"), 4U);
}

TEST(Counted, OneIsSingular) {
  EXPECT_EQ(counted(1, "link"), "1 link");
  EXPECT_EQ(counted(0, "link"), "0 links");
}

}  // namespace
}  // namespace skein::report
