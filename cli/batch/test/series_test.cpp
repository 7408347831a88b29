// SPDX-License-Identifier: Apache-2.0
// Runs of one kind, counted together.
#include "series.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace skein::batch_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Row row(std::uint64_t seed, const std::string& outcome, std::optional<double> duration,
        const std::string& loss = "") {
  Row row;
  row.scenario = "search";
  if (!loss.empty()) row.combination = {{"radio.loss", loss}};
  row.seed = seed;
  row.outcome = outcome;
  row.expectations = {{"found", outcome == "passed"}, {"down", true}};
  row.measures = {{"mission-duration", duration}};
  if (outcome != "passed") row.reason = "found: never";
  return row;
}

TEST(SeriesOf, CountsRunsOfOneScenarioAndCombination) {
  const auto all = series_of({row(1, "passed", 100, "0"), row(2, "failed", {}, "0"),
                              row(1, "passed", 120, "0.5"), row(2, "interrupted", 7, "0.5")});

  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].label(), "search, radio.loss=0");
  EXPECT_EQ(all[0].runs, 2U);
  EXPECT_EQ(all[0].passed, 1U);
  EXPECT_EQ(all[0].expectations[0].met, 1U);
  EXPECT_EQ(all[0].expectations[1].met, 2U);
  EXPECT_THAT(all[0].measures[0].second, ElementsAre(100));
  EXPECT_EQ(all[1].runs, 1U);
}

TEST(SeriesOf, ARunThatBreaksALawIsNoGoodOne) {
  Row lawless = row(1, "passed", 100);
  lawless.laws = {"energy"};

  const auto all = series_of({lawless});

  EXPECT_EQ(all[0].passed, 1U);
  EXPECT_EQ(all[0].lawless, 1U);
  EXPECT_EQ(all[0].bad.size(), 1U);
}

TEST(Print, SaysWhichLawARunBreaksAndWhatWasSeen) {
  Row lawless = row(7, "passed", 100);
  lawless.laws = {"energy"};
  lawless.breaks = {"12 s, karma: energy: it fell"};
  std::ostringstream out;

  print(out, series_of({lawless}), 1);

  EXPECT_THAT(out.str(), HasSubstr("seed 7: passed; breaks the law energy\n"
                                   "    12 s, karma: energy: it fell\n"));
}

TEST(Print, ShowsSharesFiguresAndTheFirstThatDidNotPass) {
  std::ostringstream out;
  print(out,
        series_of({row(1, "passed", 100), row(2, "passed", 110), row(3, "failed", 130),
                   row(4, "failed", 140)}),
        1);

  EXPECT_THAT(out.str(), HasSubstr("search: 2 of 4 runs passed, 0 break a law"));
  EXPECT_THAT(out.str(), HasSubstr("2 of 4     found"));
  EXPECT_THAT(out.str(), HasSubstr("mission-duration [s]"));
  EXPECT_THAT(out.str(), HasSubstr("120.0"));
  EXPECT_THAT(out.str(), HasSubstr("seed 3: failed: found: never"));
  EXPECT_THAT(out.str(), Not(HasSubstr("seed 4")));
  EXPECT_THAT(out.str(), HasSubstr("and 1 more"));
}

TEST(SummaryJson, HasTheSameFigures) {
  const auto json = nlohmann::json::parse(
      summary_json(series_of({row(1, "passed", 100), row(2, "failed", std::nullopt)})));

  const auto& series = json.at("series").at(0);
  EXPECT_EQ(series.at("passed"), 1);
  EXPECT_EQ(series.at("measures").at("mission-duration").at("mean"), 100);
  EXPECT_EQ(series.at("expectations").at(0).at("met"), 1);
  EXPECT_EQ(series.at("bad").at(0).at("seed"), 2);
}

TEST(SummarySvg, HasAPanelForEachMeasureAndARowForEachSeries) {
  const std::string svg =
      summary_svg(series_of({row(1, "passed", 100, "0"), row(1, "passed", 120, "0.5")}));

  EXPECT_THAT(svg, HasSubstr(">mission-duration<"));
  EXPECT_THAT(svg, HasSubstr(">search, radio.loss=0.5<"));
}

}  // namespace
}  // namespace skein::batch_tool
