// SPDX-License-Identifier: Apache-2.0
#include "skein/journal/kinds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

namespace skein::journal {
namespace {

using ::testing::IsNull;
using ::testing::NotNull;

/// "`uav`, `why`?" of a row, by kind.
std::map<std::string, std::string> described_on_the_page() {
  std::ifstream page(std::string(SKEIN_SOURCE_DIR) + "/docs/journal.md");
  EXPECT_TRUE(page.is_open());
  const std::regex row(R"(\| `([a-z-]+)` \|[^|]*\| ([^|]*) \|.*)");
  std::map<std::string, std::string> fields;
  for (std::string line; std::getline(page, line);) {
    std::smatch match;
    if (std::regex_match(line, match, row)) fields[match[1]] = match[2];
  }
  return fields;
}

std::string as_on_the_page(const Kind& kind) {
  std::string text;
  for (const Kind::Field& field : kind.fields) {
    text += (text.empty() ? "`" : ", `") + field.name + (field.optional ? "`?" : "`");
  }
  return text;
}

TEST(Kinds, AreOnThePageWithTheirFieldsInOrder) {
  std::map<std::string, std::string> page = described_on_the_page();

  for (const Kind& kind : kinds()) {
    EXPECT_EQ(page[kind.name], as_on_the_page(kind)) << kind.name;
    page.erase(kind.name);
  }

  EXPECT_THAT(page, ::testing::IsEmpty()) << "described, and no kind of record";
}

TEST(Kinds, WordsOfFieldsAreOnThePage) {
  std::ifstream file(std::string(SKEIN_SOURCE_DIR) + "/docs/journal.md");
  std::map<std::string, std::string> rows;
  const std::regex row(R"(\| `([a-z-]+)` \|.*)");
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    if (std::regex_match(line, match, row)) rows[match[1]] = line;
  }

  std::size_t counted = 0;
  for (const Kind& kind : kinds()) {
    for (const Kind::Field& field : kind.fields) {
      for (const std::string& word : field.words) {
        EXPECT_THAT(rows[kind.name], ::testing::ContainsRegex("[ (;:]" + word + "[ ,;.|)]"))
            << kind.name << " " << field.name;
        ++counted;
      }
    }
  }
  EXPECT_GT(counted, 40U);
}

TEST(Kinds, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Kind& kind : kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    std::set<std::string> fields;
    for (const Kind::Field& field : kind.fields)
      EXPECT_TRUE(fields.insert(field.name).second) << kind.name << " " << field.name;
  }
}

TEST(Kinds, NoFieldHasTheNameOfWhatEveryLineHas) {
  for (const Kind& kind : kinds()) {
    for (const Kind::Field& field : kind.fields)
      EXPECT_THAT(field.name, ::testing::Not(::testing::AnyOf("at", "node", "kind"))) << kind.name;
  }
}

TEST(Kinds, AreFoundByName) {
  EXPECT_THAT(find_kind("role-task"), NotNull());
  EXPECT_THAT(find_kind("roletask"), IsNull());
  EXPECT_THAT(find_kind(""), IsNull());
}

}  // namespace
}  // namespace skein::journal
