// SPDX-License-Identifier: Apache-2.0
// Two runs side by side.
#include "comparison.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "story.hpp"

namespace skein::compare_tool {
namespace {

std::vector<Difference> differences(const Comparison& comparison, const std::string& section) {
  for (const SectionDifference& one : comparison.sections)
    if (one.name == section) return one.differences;
  return {};
}

TEST(Compared, ARunWithItselfIsTheSameToTheByte) {
  const auto run = run_of({task(5, "started"), finished(9)});
  const Comparison comparison = compared(run, run, 0);

  EXPECT_TRUE(comparison.same_bytes);
  EXPECT_TRUE(comparison.same_facts());
  EXPECT_FALSE(comparison.divergence.has_value());
}

TEST(Compared, TimesCountUnlessTheyAreNear) {
  const auto a = run_of({task(5, "started"), finished(9)});
  const auto b = run_of({task(5.5, "started"), finished(9)});

  EXPECT_EQ(differences(compared(a, b, 0), "tasks").size(), 1U);
  EXPECT_TRUE(compared(a, b, 1).same_facts());
  EXPECT_FALSE(compared(a, b, 1).same_bytes);
}

TEST(Compared, WhatOnlyOneRunHasIsADifference) {
  const auto a = run_of({goal(5, "achieved"), finished(9)});
  const auto b = run_of({task(5, "started"), finished(9)});
  const Comparison comparison = compared(a, b, 100);

  const auto goals = differences(comparison, "goals"), tasks = differences(comparison, "tasks");
  ASSERT_EQ(goals.size(), 1U);
  EXPECT_FALSE(goals[0].second.has_value());
  ASSERT_EQ(tasks.size(), 1U);
  EXPECT_FALSE(tasks[0].first.has_value());
}

TEST(Compared, DifferencesComeInTheOrderOfTime) {
  const auto a = run_of({task(50, "started"), task(60, "ended"), finished(70)});
  const auto b = run_of({task(40, "started"), task(90, "ended"), finished(95)});

  const auto tasks = differences(compared(a, b, 0), "tasks");

  ASSERT_EQ(tasks.size(), 2U);
  EXPECT_EQ(tasks[0].at(), 40);
  EXPECT_EQ(tasks[1].at(), 60);
}

TEST(DivergenceOf, IsTheFirstLineThatIsAnother) {
  EXPECT_EQ(divergence_of("a\nb\nc\n", "a\nx\nc\n"), (Divergence{2, "b", "x"}));
  EXPECT_EQ(divergence_of("a\n", "a\nb\n"), (Divergence{2, std::nullopt, "b"}));
  EXPECT_EQ(divergence_of("", "b\n"), (Divergence{1, std::nullopt, "b"}));
  EXPECT_EQ(divergence_of("ab\n", "a\n"), (Divergence{1, "ab", "a"}));
  EXPECT_EQ(divergence_of("a\nb\n", "a\nb\n"), std::nullopt);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string one; std::getline(in, one);) lines.push_back(one);
  return lines;
}

RC_GTEST_PROP(DivergenceOf, IsWhatGoingLineByLineFinds,
              (const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b)) {
  const auto text = [](const std::vector<std::uint8_t>& from) {
    std::string result;
    for (const std::uint8_t one : from) result += (one % 3 == 0 ? "x\n" : "yy\n");
    return result;
  };
  const auto first = lines_of(text(a)), second = lines_of(text(b));
  std::size_t same = 0;
  while (same < first.size() && same < second.size() && first[same] == second[same]) ++same;

  const auto found = divergence_of(text(a), text(b));

  RC_ASSERT(found.has_value() == (first != second));
  if (!found) return;
  RC_ASSERT(found->line == same + 1);
  RC_ASSERT(found->first.has_value() == (same < first.size()));
  if (found->first) RC_ASSERT(*found->first == first[same]);
  if (found->second) RC_ASSERT(*found->second == second[same]);
}

}  // namespace
}  // namespace skein::compare_tool
