// SPDX-License-Identifier: Apache-2.0
// Lines of CSV.
#include "csv.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <sstream>

namespace skein::batch_tool {
namespace {

Row row(const std::string& scenario, std::uint64_t seed) {
  Row row;
  row.scenario = scenario;
  row.seed = seed;
  row.outcome = "passed";
  row.duration = 700;
  return row;
}

/// RFC 4180 by the book: the fields of a whole text, line by line.
std::vector<std::vector<std::string>> parsed(const std::string& csv) {
  std::vector<std::vector<std::string>> lines{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    std::string& field = lines.back().back();
    if (quoted && csv[i] == '"' && i + 1 < csv.size() && csv[i + 1] == '"') {
      field += csv[++i];
    } else if (csv[i] == '"') {
      quoted = !quoted;
    } else if (!quoted && csv[i] == ',') {
      lines.back().emplace_back();
    } else if (!quoted && csv[i] == '\n') {
      lines.push_back({""});
    } else {
      field += csv[i];
    }
  }
  lines.pop_back();
  return lines;
}

TEST(Csv, HasAColumnForEachKeyAndEachMeasureOfAnyRun) {
  Row first = row("a", 1), second = row("b", 2);
  first.combination = {{"radio.loss", "0.1"}};
  first.measures = {{"energy-left", 0.25}};
  first.expectations = {{"x", true}, {"y", false}};
  second.measures = {{"energy-left", std::nullopt}, {"minimum-separation marvin heliv", 20.125}};
  second.laws = {"energy", "held"};

  EXPECT_EQ(
      to_csv({first, second}),
      "scenario,radio.loss,seed,outcome,reason,duration,goals,goals_achieved,goals_failed,"
      "expectations_met,expectations,energy-left,minimum-separation marvin heliv,laws_broken\n"
      "a,0.1,1,passed,,700,0,0,0,1,2,0.25,,\n"
      "b,,2,passed,,700,0,0,0,0,0,,20.125,energy held\n");
}

TEST(Csv, OfNoRunsIsALineOfNames) { EXPECT_EQ(parsed(to_csv({})).size(), 1U); }

RC_GTEST_PROP(Csv, AnyTextIsReadBackByTheBook, (const std::string& name, const std::string& why)) {
  Row one = row(name, 1);
  one.reason = why;

  const auto lines = parsed(to_csv({one}));

  RC_ASSERT(lines.size() == 2U);
  RC_ASSERT(lines[1].size() == lines[0].size());
  RC_ASSERT(lines[1][0] == name);
  RC_ASSERT(lines[1][3] == why);
}

}  // namespace
}  // namespace skein::batch_tool
