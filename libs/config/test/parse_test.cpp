// SPDX-License-Identifier: Apache-2.0
#include "skein/config/parse.hpp"

#include <gtest/gtest.h>

namespace skein::config {
namespace {

std::string errors_of(const std::string& text) {
  const auto value = parse_yaml(text, "f.yaml");
  return value ? "" : to_text(value.error());
}

TEST(ParseYaml, KeepsOrderTextAndPosition) {
  const auto value = parse_yaml("b: 1\na:\n  - x\n  - \"7\"\n", "f.yaml");

  ASSERT_TRUE(value.has_value());
  EXPECT_EQ(value->entries[0].key, "b");
  const Value* list = value->find("a");
  ASSERT_NE(list, nullptr);
  EXPECT_EQ(list->items[0].line, 3);
  EXPECT_EQ(list->items[0].column, 5);
  EXPECT_TRUE(list->items[1].quoted);
  EXPECT_FALSE(list->items[0].quoted);
}

TEST(ParseYaml, AKeyGivenTwiceIsAnError) {
  EXPECT_EQ(errors_of("a: {b: 1, b: 2}"), "f.yaml:1:11: a.b: key 'b' given twice\n");
}

TEST(ParseYaml, SyntaxErrorsNameLineAndColumn) {
  EXPECT_EQ(errors_of("a: [1, 2").substr(0, 9), "f.yaml:1:");
}

TEST(ParseYaml, EmptyAndSeveralDocumentsAreErrors) {
  EXPECT_EQ(errors_of(""), "f.yaml:1:1: the file is empty\n");
  EXPECT_NE(errors_of("a: 1\n---\nb: 2\n"), "");
}

// yaml-cpp 0.7 reads such text as documents without end.
TEST(ParseYaml, WhatFollowsAClosedMapOrListIsAnErrorNotAnEndlessFile) {
  for (const char* text : {"{a: 1}}", "{\"a\": 1} x", "[1] ]", "{a: 1}\n}\n", "[a]: b]"})
    EXPECT_NE(errors_of(text), "") << text;
  EXPECT_EQ(errors_of("{a: 1}\n\n}"), "f.yaml:3:1: not YAML: illegal flow end\n");
}

// yaml-cpp 0.7 takes the rest of the file for text, and expectations that follow are never read.
TEST(ParseYaml, AQuoteThatNothingClosesIsAnErrorWhereItBegins) {
  EXPECT_EQ(errors_of("a: 1\nb: 'two\nc: 3\n"), "f.yaml:2:4: a quote that nothing closes\n");
  EXPECT_EQ(errors_of("a: \"x\nb: \\\"\n"), "f.yaml:1:4: a quote that nothing closes\n");
  EXPECT_EQ(errors_of("é: ü\n'a: it''s\n").substr(0, 8), "f.yaml:2");
  for (const char* text :
       {"a: 'it''s'\n", "a: \"\\\"\"\n", "a: ''\n", "é: 'ü'\n", "'a': \"b\"  # it's\n",
        "\xef\xbb\xbf"
        "a: 'b'\n",
        "a: |\n  it's\n"})
    EXPECT_EQ(errors_of(text), "") << text;
}

TEST(ParseYaml, LinesThatBeginElsewhereAreToldWhatIsWanted) {
  const std::string wanted =
      "; expected this line to begin as far to the right as those of its kind above it, with "
      "spaces "
      "(no tabs)\n";
  EXPECT_EQ(errors_of("a: 1\n\tb: 2\n"),
            "f.yaml:2:1: not YAML: illegal tab when looking for indentation; expected spaces\n");
  EXPECT_EQ(errors_of("a:\n  b: 1\n c: 2\n"),
            "f.yaml:3:2: not YAML: end of map not found" + wanted);
  EXPECT_EQ(
      errors_of("a: say: yes\n"),
      "f.yaml:1:7: not YAML: illegal map value; expected quotes around a text with ': ' in it\n");
}

TEST(ParseYaml, DeepNestingIsRefusedNotFollowed) {
  const std::string deep = std::string(100, '[') + std::string(100, ']');
  EXPECT_NE(errors_of(deep).find("nested too deeply"), std::string::npos);
  EXPECT_NE(errors_of(std::string(200000, '[')), "");
}

TEST(ParseYaml, AliasesThatMultiplyAreBounded) {
  std::string bomb = "a0: &a0 [x,x,x,x,x,x,x,x,x,x]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 10; ++k) bomb += (k > 0 ? "," : "") + before;
    bomb += "]\n";
  }
  EXPECT_NE(errors_of(bomb).find("too large"), std::string::npos);
}

TEST(ParseYaml, AFileThatIsNotThereIsADiagnostic) {
  const auto value = parse_yaml_file("/nowhere/at/all.yaml");
  ASSERT_FALSE(value.has_value());
  EXPECT_EQ(to_text(value.error()), "/nowhere/at/all.yaml: cannot be read\n");
}

}  // namespace
}  // namespace skein::config
