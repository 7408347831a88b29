// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/markup.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace skein {
namespace {

TEST(Markup, MarkupCharactersBecomeEntities) {
  EXPECT_EQ(escaped_markup("<script>alert('a' & \"b\")</script>"),
            "&lt;script&gt;alert(&#39;a&#39; &amp; &quot;b&quot;)&lt;/script&gt;");
}

TEST(Markup, GoodUtf8IsKept) {
  EXPECT_EQ(escaped_markup("Lousã – détection ✓ 🚁"), "Lousã – détection ✓ 🚁");
  EXPECT_EQ(escaped_markup("a\tb\nc\rd"), "a\tb\nc\rd");
}

TEST(Markup, WhatXmlForbidsIsReplaced) {
  const std::string bad = "\xEF\xBF\xBD";

  EXPECT_EQ(escaped_markup(std::string("a\0b", 3)), "a" + bad + "b");
  EXPECT_EQ(escaped_markup("\x1b[31m"), bad + "[31m");
  EXPECT_EQ(escaped_markup("\xff"), bad);
  EXPECT_EQ(escaped_markup("\xc0\xaf"), bad + bad);                      // overlong '/'
  EXPECT_EQ(escaped_markup("\xed\xa0\x80"), bad + bad + bad);            // a surrogate
  EXPECT_EQ(escaped_markup("\xef\xbf\xbf"), bad + bad + bad);            // U+FFFF
  EXPECT_EQ(escaped_markup("\xf4\x90\x80\x80"), bad + bad + bad + bad);  // beyond Unicode
  EXPECT_EQ(escaped_markup("\xe2\x82"), bad + bad);                      // cut off
}

RC_GTEST_PROP(Markup, NoBytesCanOpenAnElementOrCloseAnAttribute, (const std::string& text)) {
  const std::string safe = escaped_markup(text);

  RC_ASSERT(safe.find_first_of("<>\"'") == std::string::npos);
  for (const char c : safe) {
    RC_ASSERT(static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n' || c == '\r');
  }
}

RC_GTEST_PROP(Markup, EveryAmpersandBeginsAnEntity, (const std::string& text)) {
  const std::string safe = escaped_markup(text + "&" + text);

  for (std::size_t i = safe.find('&'); i != std::string::npos; i = safe.find('&', i + 1)) {
    const std::string entity = safe.substr(i, safe.find(';', i) - i + 1);
    RC_ASSERT(entity == "&amp;" || entity == "&lt;" || entity == "&gt;" || entity == "&quot;" ||
              entity == "&#39;");
  }
}

}  // namespace
}  // namespace skein
