// SPDX-License-Identifier: Apache-2.0
#include "json_document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::temporal {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

JsonValue parsed(std::string_view text) {
  Problems problems("");
  std::optional<JsonValue> value = parse_json(text, problems);
  EXPECT_TRUE(value) << to_text(problems.take());
  return value.value_or(JsonValue{});
}

std::string problem_of(std::string_view text) {
  Problems problems("");
  EXPECT_FALSE(parse_json(text, problems));
  return to_text(problems.take());
}

std::pair<int, int> where(const JsonValue& value) { return {value.line, value.column}; }

TEST(ParseJson, KnowsWhereEachValueBegins) {
  const JsonValue root = parsed("\n {\"a\" :\t[1,-2.50e3 , null],\n\"\\u00e9\\n\":\"x\",\"b\":{}}");

  EXPECT_EQ(where(root), std::pair(2, 2));
  const JsonValue& numbers = root.items.at(0);
  EXPECT_EQ(where(numbers), std::pair(2, 9));
  EXPECT_EQ(where(numbers.items.at(0)), std::pair(2, 10));
  EXPECT_EQ(where(numbers.items.at(1)), std::pair(2, 12));
  EXPECT_EQ(where(numbers.items.at(2)), std::pair(2, 22));
  EXPECT_EQ(where(root.items.at(1)), std::pair(3, 12));
  EXPECT_EQ(where(root.items.at(2)), std::pair(3, 20));
}

TEST(ParseJson, KeepsNumbersAsTheyAreWritten) {
  const JsonValue root = parsed("[1.10, -0, 123456789012345678901234567890, 1e-400]");

  std::vector<std::string> texts;
  for (const JsonValue& one : root.items) texts.push_back(one.text);
  EXPECT_THAT(texts,
              testing::ElementsAre("1.10", "-0", "123456789012345678901234567890", "1e-400"));
}

TEST(ParseJson, NamesKeysThatComeTwiceInOneObjectOnly) {
  EXPECT_THAT(problem_of(R"({"a":{"b":1,"b":2},"a":3})"),
              testing::AllOf(HasSubstr("1:13: key 'b' comes twice"),
                             HasSubstr("1:20: key 'a' comes twice")));
  EXPECT_EQ(parsed(R"([{"a":1},{"a":{"a":2}}])").items.size(), 2U);
}

TEST(ParseJson, NamesWhatIsNotJson) {
  EXPECT_THAT(problem_of(""), HasSubstr("ends too early"));
  EXPECT_THAT(problem_of("[1,"), HasSubstr("ends too early"));
  EXPECT_THAT(problem_of("[1 2]"), HasSubstr("1:4: not JSON at '2]'"));
  EXPECT_THAT(problem_of("[01]"), HasSubstr("not JSON"));
  EXPECT_THAT(problem_of("{} {}"), HasSubstr("1:4: not JSON"));
  EXPECT_THAT(problem_of("[Infinity]"), HasSubstr("'Inf' is not a number"));
  EXPECT_THAT(problem_of("[\"\xFF\"]"), HasSubstr("not JSON"));
  EXPECT_THAT(problem_of("[-1e999]"), HasSubstr("a number out of range"));
  EXPECT_THAT(problem_of("// no comments\n{}"), HasSubstr("not JSON"));
}

TEST(ParseJson, BoundsItsNesting) {
  EXPECT_EQ(parsed(std::string(16, '[') + std::string(16, ']')).items.size(), 1U);
  EXPECT_THAT(problem_of(std::string(100'000, '[')), HasSubstr("nested more than 16 deep"));
}

TEST(JsonNode, ComplainsOfWhatIsAskedAndNotThere) {
  Problems problems("");
  const JsonValue value = parsed(R"({"name": 3, "list": "x", "at": null, "place": 7})");
  const JsonNode root(value, "", problems);

  EXPECT_FALSE(root.at("missing"));
  EXPECT_FALSE(root.at("name")->name());
  EXPECT_THAT(root.at("list")->items(), IsEmpty());
  EXPECT_FALSE(root.at("at")->seconds());
  EXPECT_EQ(root.at("at")->bound(kInfinite), kInfinite);
  EXPECT_FALSE(root.at("place")->position(6));
  EXPECT_EQ(root.at("place")->position(7), 7U);
  EXPECT_TRUE(root.is_object_of({"name", "list", "at"}));  // with an unknown key

  EXPECT_EQ(problems.take().size(), 6U);
}

TEST(JsonNode, FindsWhatMayBeMissingWithoutComplaint) {
  Problems problems("");
  const JsonValue value = parsed(R"({"a": [true, 1.5]})");
  const JsonNode root(value, "", problems);

  EXPECT_FALSE(root.find("b"));
  const std::vector<JsonNode> items = root.find("a")->items();
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[1].place().path, "a[1]");
  EXPECT_EQ(items[1].seconds(), 1'500'000'000);
  EXPECT_TRUE(problems.none());
}

TEST(JsonString, EscapesWhatMustBe) {
  EXPECT_EQ(json_string("a\"\\é"), R"("a\"\\é")");
  EXPECT_EQ(json_bound(kInfinite), "null");
  EXPECT_EQ(json_bound(-1), "-0.000000001");
}

}  // namespace
}  // namespace skein::temporal
