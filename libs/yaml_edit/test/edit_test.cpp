// SPDX-License-Identifier: Apache-2.0
#include "skein/yaml_edit/edit.hpp"

#include <gtest/gtest.h>

#include "skein/config/parse.hpp"

namespace skein::yaml_edit {
namespace {

config::Value value(const char* yaml) { return *config::parse_yaml(yaml, ""); }

const std::string kRole = R"(# of the thesis
roles:
  perceive:
    needs: [hovering]   # and a camera
    automaton:
      block: b10
      content:
        - {task: t11, type: goto}

        # Waits for all.
        - block: b11
          pre: [[{componel: t11, state: ended}]]
          content: [{task: t12, type: wait}]
        - block: b12   # perceives
          type: loop
          # again and again
          content:
            - {task: t13, type: look}
# the end
)";

const Path kContent{"roles", "perceive", "automaton", "content"};
Path content(std::size_t index) {
  Path path = kContent;
  path.emplace_back(index);
  return path;
}
Path below(Path path, const char* key) {
  path.emplace_back(std::string(key));
  return path;
}

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kRole;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST(Edit, AScalarIsReplacedWhereItStands) {
  EXPECT_EQ(edited(kRole, Set{below(content(2), "type"), value("plan")}),
            replaced("type: loop", "type: plan"));
}

TEST(Edit, AListInOneLineStaysInOneLineWithItsComment) {
  EXPECT_EQ(
      edited(kRole, Insert{{"roles", "perceive", "needs"}, 9, "", value("{camera: visible}")}),
      replaced("[hovering] ", "[hovering, {camera: visible}] "));
  EXPECT_EQ(edited(kRole, Remove{{"roles", "perceive", "needs", std::size_t{0}}}),
            replaced("[hovering]", "[]"));
}

TEST(Edit, AnItemGetsALineOfItsOwnBetweenTheOthers) {
  EXPECT_EQ(
      edited(kRole, Insert{kContent, 1, "", value("{task: t9, type: goto, params: {to: p}}")}),
      replaced("\n        # Waits",
               "\n        - {task: t9, type: goto, params: {to: p}}\n        # Waits"));
  EXPECT_EQ(edited(kRole, Insert{kContent, 9, "", value("{task: t9, type: goto}")}),
            replaced("type: look}\n", "type: look}\n        - {task: t9, type: goto}\n"));
}

TEST(Edit, WhatIsLongIsWrittenInLines) {
  EXPECT_EQ(
      edited(
          kRole,
          Insert{
              kContent, 9, "",
              value(
                  "{block: b13, type: loop, content: [{task: a, type: x}, {task: b, type: y}]}")}),
      replaced("type: look}\n", R"(type: look}
        - block: b13
          type: loop
          content:
            - {task: a, type: x}
            - {task: b, type: y}
)"));
}

TEST(Edit, AnEntryComesAndGoes) {
  const auto with = edited(kRole, Insert{content(2), 2, "end", value("immediate")});

  ASSERT_EQ(with, replaced("type: loop\n", "type: loop\n          end: immediate\n"));
  EXPECT_EQ(edited(*with, Remove{below(content(2), "end")}), kRole);
}

TEST(Edit, AnItemGoesWithTheCommentAboveIt) {
  EXPECT_EQ(edited(kRole, Remove{content(1)}), replaced(R"(        # Waits for all.
        - block: b11
          pre: [[{componel: t11, state: ended}]]
          content: [{task: t12, type: wait}]
)",
                                                        ""));
}

TEST(Edit, TheLastItemLeavesAnEmptyList) {
  EXPECT_EQ(edited(kRole, Remove{{"roles", "perceive", "automaton", "content", std::size_t{2},
                                  "content", std::size_t{0}}}),
            replaced("content:\n            - {task: t13, type: look}", "content: []"));
}

TEST(Edit, ABlockMovesIntoAnotherWithItsComments) {
  EXPECT_EQ(edited(kRole, Move{content(1), below(content(2), "content"), 1}), R"(# of the thesis
roles:
  perceive:
    needs: [hovering]   # and a camera
    automaton:
      block: b10
      content:
        - {task: t11, type: goto}

        - block: b12   # perceives
          type: loop
          # again and again
          content:
            - {task: t13, type: look}
            # Waits for all.
            - block: b11
              pre: [[{componel: t11, state: ended}]]
              content: [{task: t12, type: wait}]
# the end
)");
}

TEST(Edit, AnItemMovesUp) {
  const auto moved = edited(kRole, Move{content(2), kContent, 0});

  ASSERT_TRUE(moved.has_value());
  EXPECT_NE(moved->find("      content:\n        - block: b12   # perceives\n"), std::string::npos);
  EXPECT_EQ(edited(*moved, Move{content(0), kContent, 2}), kRole);
}

TEST(Edit, ANameIsReplaced) {
  EXPECT_EQ(edited(kRole, Rename{{"roles", "perceive"}, "see"}), replaced("  perceive:", "  see:"));
}

TEST(Edit, WhatIsNotPlainIsQuoted) {
  EXPECT_EQ(edited(kRole, Set{below(content(2), "block"), value("'a, b'")}),
            replaced("block: b12 ", "block: \"a, b\" "));
}

TEST(Edit, LettersOfMoreBytesDoNotShiftPlaces) {
  const std::string text = "wörter: [ä, ö]  # ü\nb: {c: 1}\n";

  EXPECT_EQ(edited(text, Set{{"b", "c"}, value("2")}), "wörter: [ä, ö]  # ü\nb: {c: 2}\n");
}

TEST(Edit, ATextWithoutALastEndOfLineGetsNone) {
  EXPECT_EQ(edited("a: 1", Insert{{}, 9, "b", value("2")}), "a: 1\nb: 2");
}

struct Wrong {
  const char* name;
  std::string text;
  Edit edit;
  const char* why;
};
class WrongEdit : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongEdit, IsRefusedWithTheReason) {
  const auto result = edited(GetParam().text, GetParam().edit);

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().why, GetParam().why);
}

const char* const kByHand = "this cannot be changed here without changing more: edit the text";

INSTANTIATE_TEST_SUITE_P(
    Edit, WrongEdit,
    ::testing::Values(
        Wrong{"NoYaml", "a: [", Set{{"a"}, {}}, "the text is no YAML: mend it first"},
        Wrong{"NoSuchPlace", "a: 1", Set{{"b"}, {}}, "there is no b"},
        Wrong{"NoSuchItem", "a: [1]", Remove{{"a", std::size_t{3}}}, "there is no a[3]"},
        Wrong{"KeyTwice", "{a: 1, b: 2}", Rename{{"a"}, "b"}, "there is 'b' already"},
        Wrong{"EntryTwice", "a: {b: 1}", Insert{{"a"}, 0, "b", {}}, "a has 'b' already"},
        Wrong{"NoList", "a: 1", Insert{{"a"}, 0, "", {}}, "a is no list"},
        Wrong{"IntoItself", "a: [[1]]", Move{{"a", std::size_t{0}}, {"a", std::size_t{0}}, 0},
              "a[0] cannot be moved into itself"},
        Wrong{"Anchor", "a: &x [1]\nb: *x\n", Insert{{"a"}, 0, "", value("2")}, kByHand},
        Wrong{"CommentWithinBrackets", "a: [1, # one\n  2]\n", Insert{{"a"}, 0, "", value("0")},
              kByHand}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace skein::yaml_edit
