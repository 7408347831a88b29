// SPDX-License-Identifier: Apache-2.0
// JUnit and the summary.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "builders.hpp"
#include "skein/report/report.hpp"
#include "synthetic_mission.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::expectation;
using testing::stamp;
using testing::task;
using testing::telemetry;

RunInfo info() {
  RunInfo result;
  result.scenario = "s";
  result.wall_seconds = 75.25;
  return result;
}

TEST(Junit, OneCasePerExpectationAndWhatWasSeenInEachFailure) {
  Journal j;
  j.expectations = {expectation("lands", true, "at 12:00"),
                    expectation("home < 22 min", false, "late & \"tired\"")};

  EXPECT_EQ(junit(info(), j),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites>\n"
            "<testsuite name=\"s\" tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"0\" "
            "time=\"75.25\">\n"
            "<testcase classname=\"s\" name=\"lands\"></testcase>\n"
            "<testcase classname=\"s\" name=\"home &lt; 22 min\">"
            "<failure message=\"late &amp; &quot;tired&quot;\">late &amp; &quot;tired&quot;"
            "</failure></testcase>\n"
            "</testsuite>\n"
            "</testsuites>\n");
}

TEST(Junit, ARunThatCheckedNothingIsNoSuccess) {
  const std::string xml = junit(info(), {});

  EXPECT_EQ(count(xml, "tests=\"1\" failures=\"1\""), 1U);
  EXPECT_EQ(count(xml, "none was checked"), 2U);
}

TEST(Junit, AnIndependentParserFindsItWellFormed) {
  if (std::system("command -v xmllint >/dev/null 2>&1") != 0) GTEST_SKIP() << "no xmllint";
  Journal j;
  j.expectations = {expectation(std::string("\x01<script>\xff]]>", 12), false, "a\0b&"),
                    expectation("é", true, "ok")};
  const std::string path = ::testing::TempDir() + "skein_report_junit.xml";
  std::ofstream(path) << junit(info(), j);

  EXPECT_EQ(std::system(("xmllint --noout " + path).c_str()), 0);
  std::remove(path.c_str());
}

TEST(Summary, SaysVerdictFiguresAndExpectations) {
  Journal j;
  j.telemetry = {telemetry(0, "m", {0, 0, 5}), telemetry(10, "m", {30, 40, 25}, true, 0.5)};
  j.tasks = {task(1, "m", 1, TaskState::kRunning), task(2, "m", 1, TaskState::kEnded)};
  j.missions = {{stamp(0), "started"}, {stamp(12), "finished"}};
  j.expectations = {expectation("e", true, "yes")};

  const auto result = nlohmann::json::parse(summary_json(info(), j));

  EXPECT_EQ(result.at("scenario"), "s");
  EXPECT_EQ(result.at("passed"), true);
  EXPECT_EQ(result.at("outcome"), "finished");
  EXPECT_EQ(result.at("mission_seconds"), 12.0);
  EXPECT_EQ(result.at("wall_seconds"), 75.25);
  EXPECT_EQ(result.at("runtime"), "virtual");
  EXPECT_EQ(result.at("expectations"),
            (nlohmann::json::array({{{"name", "e"}, {"passed", true}, {"seen", "yes"}}})));
  EXPECT_EQ(result.at("uavs").at(0).at("distance_m"), 53.852);
  EXPECT_EQ(result.at("uavs").at(0).at("max_altitude_m"), 25.0);
  EXPECT_EQ(result.at("uavs").at(0).at("energy_used"), 0.5);
  EXPECT_EQ(result.at("uavs").at(0).at("ended"), 1);
  EXPECT_TRUE(result.at("separation").is_null());
}

TEST(Summary, NamesTheClosestPair) {
  Journal j;
  j.telemetry = {telemetry(3, "a", {0, 0, 0}), telemetry(3, "b", {0, 0, 20})};

  const auto result = nlohmann::json::parse(summary_json(info(), j));

  EXPECT_EQ(result.at("separation"),
            (nlohmann::json{{"metres", 20.0}, {"at_s", 3.0}, {"between", {"a", "b"}}}));
}

TEST(Summary, OfTheSyntheticMissionAddsUp) {
  const Journal j = testing::salvage(testing::comets_journal()).journal;

  const auto result = nlohmann::json::parse(summary_json(testing::comets_info(), j));

  EXPECT_EQ(result.at("passed"), false);
  EXPECT_EQ(result.at("expectations").size(), 6U);
  EXPECT_EQ(result.at("uavs").size(), 3U);
  EXPECT_GT(result.at("uavs").at(2).at("distance_m"), 3000.0);
  for (const auto& uav : result.at("uavs")) {
    EXPECT_EQ(uav.at("tasks"), uav.at("ended").get<int>() + uav.at("aborted").get<int>());
  }
}

TEST(Summary, OfNothingIsStillADocument) {
  const auto result = nlohmann::json::parse(summary_json({}, {}));

  EXPECT_EQ(result.at("passed"), false);
  EXPECT_EQ(result.at("outcome"), "");
}

RC_GTEST_PROP(Summary, AnyNamesGiveJson, (const std::string& name, const std::string& seen)) {
  Journal j;
  j.expectations = {expectation(name, true, seen)};
  j.telemetry = {telemetry(1, name, {})};

  RC_ASSERT(!nlohmann::json::parse(summary_json(info(), j), nullptr, false).is_discarded());
}

}  // namespace
}  // namespace skein::report
