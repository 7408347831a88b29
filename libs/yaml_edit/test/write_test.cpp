// SPDX-License-Identifier: Apache-2.0
#include "write.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "skein/config/parse.hpp"
#include "skein/yaml_edit/edit.hpp"

namespace skein::yaml_edit {
namespace {

RC_GTEST_PROP(WriteLaw, AScalarIsReadAsItWasMeantInEveryPlace, (const std::string& drawn)) {
  std::string text;
  for (const char c : drawn) text += static_cast<char>(0x20 + static_cast<unsigned char>(c) % 0x5f);
  const std::string written = scalar_text(text, false);

  for (const std::string& place : {written, "[a, " + written + ", b]", "{k: " + written + "}",
                                   "k: " + written + "\n", "- " + written + " # c\n"}) {
    const auto read = config::parse_yaml(place, "");
    RC_ASSERT(read.has_value());
    const config::Value* value = &*read;
    if (!value->items.empty()) value = &value->items[value->items.size() > 1 ? 1 : 0];
    if (!value->entries.empty()) value = &value->entries[0].value;
    RC_ASSERT(value->kind == config::Value::Kind::kScalar);
    RC_ASSERT(value->scalar == text);
  }
}

TEST(Write, WordsNumbersAndCallsNeedNoQuotes) {
  for (const char* plain :
       {"goto", "R*", "0.5236", "-3", "valid-position()", "member lost", "p4"}) {
    EXPECT_EQ(scalar_text(plain, false), plain);
  }
}

TEST(Write, WhatWouldBeReadOtherwiseIsQuoted) {
  EXPECT_EQ(scalar_text(">", false), "\">\"");
  EXPECT_EQ(scalar_text("best-view(a, b)", false), "\"best-view(a, b)\"");
  EXPECT_EQ(scalar_text("null", false), "\"null\"");
  EXPECT_EQ(scalar_text("a\n\"b\"", false), R"("a\n\"b\"")");
}

}  // namespace
}  // namespace skein::yaml_edit
