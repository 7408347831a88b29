// SPDX-License-Identifier: Apache-2.0
#include "run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/scenario_copy.hpp"

namespace skein::run_tool {
namespace {

using testing::Folder;
using testing::read_text;
using testing::write_text;
using testing::fs::exists;

scenario::Scenario comets() {
  auto scenario = scenario::read_scenario(testing::kComets + "confirmed.yaml");
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

std::vector<journal::Record> two_records() {
  std::vector<journal::Record> records;
  records.emplace_back(MissionTime(), "runner", "mission").with("state", "started");
  records.emplace_back(MissionTime::seconds(9), "runner", "expectation")
      .with("name", "it ends")
      .with("passed", true)
      .with("seen", "1 time");
  return records;
}

TEST(PrepareFolder, MakesItWithItsParents) {
  const Folder folder;

  ASSERT_TRUE(prepare_folder((folder / "a/b/c").string()).has_value());

  EXPECT_TRUE(exists(folder / "a/b/c/logs"));
}

TEST(PrepareFolder, RemovesTheResultsOfAnEarlierRunAndNothingElse) {
  const Folder folder;
  ASSERT_TRUE(prepare_folder(folder.text()).has_value());
  for (const char* name : {"events.jsonl", "run.json", "report.html", "junit.xml", "result.json",
                           "logs/sim.log", "notes.txt", "logs/notes.txt"}) {
    write_text(folder / name, "old");
  }

  ASSERT_TRUE(prepare_folder(folder.text()).has_value());

  for (const char* name :
       {"events.jsonl", "run.json", "report.html", "junit.xml", "result.json", "logs/sim.log"}) {
    EXPECT_FALSE(exists(folder / name)) << name;
  }
  EXPECT_TRUE(exists(folder / "notes.txt"));
  EXPECT_TRUE(exists(folder / "logs/notes.txt"));
}

TEST(PrepareFolder, LeavesARunThatGoesOnThereAsItIs) {
  const Folder folder;
  {
    const auto first = prepare_folder(folder.text());
    ASSERT_TRUE(first.has_value());
    write_text(folder / "logs/sim.log", "its own");

    const auto second = prepare_folder(folder.text());

    ASSERT_FALSE(second.has_value());
    EXPECT_THAT(second.error().why, ::testing::HasSubstr("a run goes on there"));
    EXPECT_TRUE(exists(folder / "logs/sim.log"));
  }
  EXPECT_TRUE(prepare_folder(folder.text()).has_value());
}

TEST(PrepareFolder, WhereNoFolderCanBeIsAFailureThatNamesIt) {
  const auto prepared = prepare_folder("/dev/null/out");

  ASSERT_FALSE(prepared.has_value());
  EXPECT_THAT(prepared.error().why, ::testing::HasSubstr("/dev/null/out"));
}

TEST(WriteFolder, LeavesTheLogTheScenarioAndTheThreeDocuments) {
  const Folder folder;
  const scenario::Scenario scenario = comets();

  const auto summary =
      write_folder(folder.text(), scenario, run_info(scenario, true, 0), two_records());

  ASSERT_TRUE(summary.has_value()) << summary.error().why;
  EXPECT_EQ(
      read_text(folder / "events.jsonl"),
      R"({"at":0,"node":"runner","kind":"mission","state":"started"})"
      "\n"
      R"({"at":9,"node":"runner","kind":"expectation","name":"it ends","passed":true,"seen":"1 time"})"
      "\n");
  EXPECT_THAT(read_text(folder / "scenario.yaml"), ::testing::StartsWith("# COMETS"));
  EXPECT_EQ(read_text(folder / "result.json"), *summary);
  EXPECT_THAT(read_text(folder / "report.html"), ::testing::HasSubstr("comets-confirmed"));
  EXPECT_THAT(read_text(folder / "junit.xml"), ::testing::HasSubstr("it ends"));
}

// Its models and its world are where they were.
TEST(WriteFolder, LeavesAScenarioThatCanBeRunFromThere) {
  const Folder folder;
  const scenario::Scenario scenario = comets();
  ASSERT_TRUE(write_folder(folder.text(), scenario, run_info(scenario, true, 0), {}).has_value());

  const auto copy = scenario::read_scenario(folder / "scenario.yaml");

  ASSERT_TRUE(copy.has_value()) << to_text(copy.error());
  EXPECT_EQ(copy->uavs.at(0).model.name, scenario.uavs.at(0).model.name);
  EXPECT_EQ(copy->world.places, scenario.world.places);
}

TEST(WriteFolder, WhereNothingCanBeWrittenIsAFailure) {
  const scenario::Scenario scenario = comets();

  EXPECT_FALSE(write_folder("/dev/null", scenario, run_info(scenario, true, 0), {}).has_value());
}

TEST(WriteReport, GivesTheSameDocumentsAgain) {
  const Folder folder;
  const scenario::Scenario scenario = comets();
  const auto summary =
      write_folder(folder.text(), scenario, run_info(scenario, false, 61.5), two_records());
  const std::string html = read_text(folder / "report.html");
  write_text(folder / "report.html", "spoilt");

  const auto again = write_report(folder.text());

  ASSERT_TRUE(again.has_value()) << again.error().why;
  EXPECT_EQ(*again, *summary);
  EXPECT_EQ(read_text(folder / "report.html"), html);
}

TEST(WriteReport, WithoutARunIsAFailure) {
  const Folder folder;

  EXPECT_FALSE(write_report(folder.text()).has_value());
}

TEST(WriteReport, OfASpoiltLogIsAFailureThatNamesTheFile) {
  const Folder folder;
  const scenario::Scenario scenario = comets();
  ASSERT_TRUE(write_folder(folder.text(), scenario, run_info(scenario, true, 0), {}).has_value());
  write_text(folder / "run.json", "{");

  const auto report = write_report(folder.text());

  ASSERT_FALSE(report.has_value());
  EXPECT_THAT(report.error().why, ::testing::HasSubstr("run.json"));
}

TEST(RunInfo, TellsWhatTheReportNeedsOfTheScenario) {
  const report::RunInfo info = run_info(comets(), false, 61.5);

  EXPECT_EQ(info.scenario, "comets-confirmed");
  EXPECT_EQ(info.runtime, report::RuntimeKind::kDds);
  EXPECT_EQ(info.rate, 20);
  EXPECT_EQ(info.wall_seconds, 61.5);
  ASSERT_EQ(info.uavs.size(), 3U);
  EXPECT_EQ(info.uavs[1].name, "heliv");
  EXPECT_EQ(info.zones.size(), 1U);
  ASSERT_TRUE(info.terrain.has_value());
  EXPECT_EQ(info.terrain->values.size(), info.terrain->width * info.terrain->height);
}

TEST(RunInfo, OfVirtualTimeHasNoRate) {
  const report::RunInfo info = run_info(comets(), true, 0);

  EXPECT_EQ(info.runtime, report::RuntimeKind::kVirtual);
  EXPECT_EQ(info.rate, 0);
}

}  // namespace
}  // namespace skein::run_tool
