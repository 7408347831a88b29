// SPDX-License-Identifier: Apache-2.0
#include "text/path.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "text/hexadecimal.hpp"

namespace skein::spy_tool {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Json> values(const Json& document, const std::string& text) {
  const auto path = parse_path(text);
  EXPECT_TRUE(path.has_value()) << text;
  std::vector<Json> found;
  for (const Json* one : values_at(document, *path)) found.push_back(*one);
  return found;
}

TEST(Path, IsNamesWithDotsAndElementsInBrackets) {
  EXPECT_EQ(*parse_path("a.b[2].c"), (Path{{"a", {}}, {"b", {}}, {"", 2}, {"c", {}}}));
  for (const char* wrong :
       {"", ".", "a.", ".a", "a..b", "[0]", "a[", "a[]", "a[x]", "a[1", "a[-1]", "a b", "a[0]b"})
    EXPECT_FALSE(parse_path(wrong).has_value()) << wrong;
}

TEST(Path, FindsWhatIsThere) {
  const Json document = Json::parse(R"({"a":{"b":[{"c":1},{"c":2}]},"t":"x"})");
  EXPECT_EQ(values(document, "t"), std::vector<Json>{"x"});
  EXPECT_EQ(values(document, "a.b[1].c"), std::vector<Json>{2});
  EXPECT_EQ(values(document, "a.b.c"), (std::vector<Json>{1, 2}));
  EXPECT_TRUE(values(document, "a.x").empty());
  EXPECT_TRUE(values(document, "t.x").empty());
  EXPECT_TRUE(values(document, "a.b[2]").empty());
}

TEST(Path, IsKnownWhereASlotHasTheField) {
  const auto check = [](const std::string& text, std::vector<wire::Slot> slots) {
    return check_path(*parse_path(text), text, slots);
  };
  EXPECT_TRUE(check("header.origin", {wire::Slot::kClock}).empty());
  EXPECT_TRUE(check("tasks.state", {wire::Slot::kPlanBoard}).empty()) << "in an empty list";
  EXPECT_TRUE(check("rate", {wire::Slot::kTelemetry, wire::Slot::kClock}).empty())
      << "in one of them";
  const Diagnostics wrong = check("header.orign", {wire::Slot::kClock});
  ASSERT_EQ(wrong.size(), 1U);
  EXPECT_EQ(wrong.all().front().nearest, "origin");
  EXPECT_EQ(check("phase.more", {wire::Slot::kClock}).size(), 1U);
}

TEST(Hexadecimal, ShowsBytesWithTheirPlacesAndLetters) {
  const std::vector<std::uint8_t> bytes{0x00, 0x01, 'A', 0xff};
  EXPECT_EQ(hexadecimal(bytes), "000141ff");
  EXPECT_EQ(hexadecimal_lines(bytes), "  0000  00 01 41 ff" + std::string(36, ' ') + "  ..A.\n");
  EXPECT_EQ(hexadecimal_lines({}), "");
}

TEST(Hexadecimal, SaysHowMuchItLeavesOut) {
  const std::string text = hexadecimal_lines(std::vector<std::uint8_t>(300, 7));
  EXPECT_NE(text.find("  00f0  "), std::string::npos);
  EXPECT_EQ(text.find("  0100  "), std::string::npos);
  EXPECT_NE(text.find("… 44 more"), std::string::npos);
}

}  // namespace
}  // namespace skein::spy_tool
