// SPDX-License-Identifier: Apache-2.0
#include "text/condition.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace skein::spy_tool {
namespace {

using Json = nlohmann::ordered_json;

const Json kSample = Json::parse(
    R"({"id":4,"uav":"marvin","state":"running","airborne":true,"held":false,"energy":0.75,
        "task":{"id":18446744073709551615,"type":"goto"},
        "tasks":[{"id":1,"state":"ended"},{"id":2,"state":"running"}],"empty":[]})");

bool holds(const std::string& text) {
  auto condition = Condition::parse(text);
  EXPECT_TRUE(condition.has_value()) << text << ": " << (condition ? "" : condition.error().why);
  return condition && condition->holds(kSample);
}

std::string wrong(const std::string& text) {
  auto condition = Condition::parse(text);
  EXPECT_FALSE(condition.has_value()) << text;
  return condition ? "" : condition.error().why;
}

TEST(Condition, ComparesNumbersAsNumbers) {
  EXPECT_TRUE(holds("id > 3"));
  EXPECT_TRUE(holds("id >= 4 "));
  EXPECT_FALSE(holds("id > 10"));
  EXPECT_TRUE(holds("energy < 1e0"));
  EXPECT_TRUE(holds("energy > -1.5"));
  EXPECT_TRUE(holds("id == 4.0"));
}

TEST(Condition, ComparesWholeNumbersOfSixtyFourBitsExactly) {
  EXPECT_TRUE(holds("task.id == 18446744073709551615"));
  EXPECT_FALSE(holds("task.id == 18446744073709551614"));
}

TEST(Condition, ComparesWordsAndTexts) {
  EXPECT_TRUE(holds("state == running"));
  EXPECT_TRUE(holds("uav == 'marvin'"));
  EXPECT_TRUE(holds("uav == \"marvin\""));
  EXPECT_TRUE(holds("uav != karma"));
  EXPECT_TRUE(holds("uav < 'n'"));
}

TEST(Condition, WithoutAComparisonAsksWhetherItIsTrueOrThere) {
  EXPECT_TRUE(holds("airborne"));
  EXPECT_FALSE(holds("held"));
  EXPECT_TRUE(holds("task.type"));
  EXPECT_FALSE(holds("task.colour"));
  EXPECT_TRUE(holds("airborne == true && held == false"));
}

TEST(Condition, BindsNotBeforeAndBeforeOr) {
  EXPECT_TRUE(holds("airborne || held && held"));
  EXPECT_FALSE(holds("(airborne || held) && held"));
  EXPECT_TRUE(holds("!held && airborne"));
  EXPECT_FALSE(holds("!(held || airborne)"));
}

TEST(Condition, IsFulfilledByOneElementOfAListThatNamesNone) {
  EXPECT_TRUE(holds("tasks.state == running"));
  EXPECT_TRUE(holds("tasks[0].state == ended"));
  EXPECT_FALSE(holds("tasks[0].state == running"));
  EXPECT_FALSE(holds("tasks[7].state == running"));
  EXPECT_FALSE(holds("empty == 1"));
}

TEST(Condition, WhatIsNotThereFulfilsNoComparison) {
  EXPECT_FALSE(holds("colour == 1"));
  EXPECT_FALSE(holds("colour != 1"));
  EXPECT_TRUE(holds("!(colour == 1)"));
}

TEST(Condition, SaysWhereItIsWrongAndWhatWasExpected) {
  EXPECT_EQ(wrong("id >"),
            "column 5: expected a number, a word, true, false or 'text', not the end");
  EXPECT_EQ(wrong("id > 3 uav"), "column 8: expected && or || or the end, not 'uav'");
  EXPECT_EQ(wrong("(id > 3"), "column 8: expected ')', not the end");
  EXPECT_EQ(wrong(""), "column 1: expected a field, not the end");
  EXPECT_EQ(wrong("id = 3"), "column 4: expected && or || or the end, not '='");
  EXPECT_EQ(wrong("3 == id"), "column 1: expected a field, not '3'");
  EXPECT_EQ(wrong("uav == 'marvin"),
            "column 8: expected a number, a word, true, false or 'text', not ''marvin'");
  EXPECT_EQ(wrong("a..b"), "column 1: expected a field, not 'a..b'");
}

TEST(Condition, IsNoProgram) {
  wrong("__import__('os')");
  wrong("id; rm");
  wrong("$(id)");
  wrong(std::string(100'000, '!') + "id");
  wrong(std::string(100'000, '(') + "id");
}

TEST(Condition, TellsWhichFieldsItMentions) {
  const auto condition = Condition::parse("task.id > 3 && (uav == marvin || !held)");
  ASSERT_TRUE(condition.has_value());
  EXPECT_EQ(condition->paths(), (std::vector<std::string>{"task.id", "uav", "held"}));
}

}  // namespace
}  // namespace skein::spy_tool
