// SPDX-License-Identifier: Apache-2.0
// One run of a batch: played, and told over a pipe.
#include "row.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "temporary_folder.hpp"

namespace skein::batch_tool {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

const std::string kFile = SKEIN_SOURCE_DIR "/scenarios/karma/detection.yaml";

Case karma(std::uint64_t seed, const Combination& combination = {}) {
  std::ifstream in(kFile);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return {"karma", kFile, *with_values(text, combination), combination, seed, ""};
}

double measured(const Row& row, const std::string& name) {
  for (const auto& [known, value] : row.measures)
    if (known == name && value) return *value;
  return -1;
}

TEST(PlayCase, JudgesMeasuresAndCounts) {
  const Row row = play_case(karma(3), {});

  EXPECT_EQ(row.outcome, "passed") << row.reason;
  EXPECT_EQ(row.seed, 3U);
  EXPECT_GT(row.goals, 0);
  EXPECT_FALSE(row.expectations.empty());
  EXPECT_GT(measured(row, "mission-duration"), 100);
  EXPECT_GE(row.duration, measured(row, "mission-duration"));
  EXPECT_GT(measured(row, "energy-left"), 0);
  EXPECT_THAT(row.measures, Contains(Pair("minimum-separation", std::nullopt)));
}

TEST(PlayCase, SaysWhyARunDidNotPass) {
  const Row row = play_case(karma(1, {{"duration_limit", "60"}}), {});

  EXPECT_EQ(row.outcome, "failed");
  EXPECT_THAT(row.reason, HasSubstr("never saw"));
  EXPECT_THAT(row.measures, Contains(Pair("mission-duration", std::nullopt)));
}

TEST(PlayCase, ThatExpectsNothingAndDoesNotEndTellsOfTheTimeLimit) {
  EXPECT_EQ(play_case(karma(1, {{"duration_limit", "60"}, {"expect", "[]"}}), {}).outcome,
            "time-limit");
}

TEST(PlayCase, LeavesTheFolderOfARunWhenItIsAskedTo) {
  const skein::testing::TemporaryFolder folder;
  Case what = karma(5, {{"duration_limit", "60"}});
  what.folder = (folder.path() / "run").string();

  play_case(what, {});

  EXPECT_TRUE(std::filesystem::exists(folder.path() / "run/events.jsonl"));
  std::ifstream in(folder.path() / "run/scenario.yaml");
  EXPECT_THAT((std::string{std::istreambuf_iterator<char>(in), {}}), HasSubstr("limit: 60"));
}

TEST(PlayCase, ThatCannotBeKeptSaysSo) {
  Case what = karma(5, {{"duration_limit", "20"}});
  what.folder = "/dev/null/run";

  EXPECT_EQ(play_case(what, {}).outcome, "unwritten");
}

TEST(ScenarioOf, SaysWhatIsWrongWithAValue) {
  const auto scenario = scenario_of(karma(1, {{"rate", "-4"}, {"radioo.loss", "1"}}), {"9"});

  ASSERT_FALSE(scenario.has_value());
  const std::string said = to_text(scenario.error());
  EXPECT_THAT(said, HasSubstr("rate"));
  EXPECT_THAT(said, HasSubstr("radioo"));
}

TEST(Row, IsReadBackAsItWasWritten) {
  Row row;
  row.scenario = "x";
  row.combination = {{"a.b", "[1, 2]"}};
  row.seed = 18'446'744'073'709'551'615U;
  row.outcome = "failed";
  row.reason = "one\ntwo";
  row.duration = 12.5;
  row.goals = 3;
  row.achieved = 2;
  row.failed = 1;
  row.expectations = {{"it flies", true}, {"it lands", false}};
  row.measures = {{"energy-left", 0.1}, {"minimum-separation", std::nullopt}};
  row.laws = {"energy"};
  row.breaks = {"12 s, karma: energy: it fell"};

  const auto back = row_from_json(to_json(row));

  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(to_json(*back), to_json(row));
  EXPECT_EQ(back->seed, row.seed);
  EXPECT_EQ(back->measures, row.measures);
  EXPECT_EQ(back->breaks, row.breaks);
}

TEST(Row, IsNotReadFromWhatADeadProcessLeft) {
  for (const char* text : {"", "{", "{\"scenario\":\"x\"}", "[]", "3"})
    EXPECT_FALSE(row_from_json(text).has_value()) << text;
}

}  // namespace
}  // namespace skein::batch_tool
