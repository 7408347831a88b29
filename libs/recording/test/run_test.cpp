// SPDX-License-Identifier: Apache-2.0
// The folder of a run is read again, or every reason told why not.
#include "skein/recording/run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "temporary_folder.hpp"

namespace skein::recording {
namespace {

using ::testing::HasSubstr;

class ReadRun : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  void write_info() const {
    report::RunInfo info;
    info.scenario = "search";
    info.epoch = "2026-01-01T00:00:00Z";
    info.uavs = {{"marvin", "helicopter", 4}};
    write("run.json", report::to_json(info));
  }
  auto read() const { return read_run(folder_.path().string()); }
  std::string reasons() const {
    const auto run = read();
    return run ? "none" : to_text(run.error());
  }

  skein::testing::TemporaryFolder folder_;
};

TEST_F(ReadRun, GivesInfoAndRecordsInTheOrderOfTime) {
  write_info();
  write("events.jsonl",
        "{\"at\":5,\"node\":\"sim\",\"kind\":\"phase\"}\n\n{\"at\":2,\"node\":\"sim\",\"kind\":"
        "\"mission\"}\n");

  const auto run = read();

  ASSERT_TRUE(run.has_value()) << to_text(run.error());
  EXPECT_EQ(run->info.scenario, "search");
  ASSERT_EQ(run->records.size(), 2U);
  EXPECT_EQ(run->records[0].kind(), "mission");
  EXPECT_EQ(run->until(), MissionTime::seconds(5));
  EXPECT_TRUE(run->damaged.empty());
}

TEST_F(ReadRun, LeavesOutLinesThatAreDamagedAndTellsTheirNumbers) {
  write_info();
  write("events.jsonl", "{\"at\":5,\"node\":\"sim\",\"kind\":\"phase\"}\nnonsense\n{\"at\":6,\"no");

  const auto run = read();

  ASSERT_TRUE(run.has_value());
  EXPECT_EQ(run->records.size(), 1U);
  ASSERT_EQ(run->damaged.size(), 2U);
  EXPECT_EQ(run->damaged.all()[0].line, 2);
  EXPECT_EQ(run->damaged.all()[1].line, 3);
}

TEST_F(ReadRun, TellsEverythingThatIsMissingAtOnce) {
  EXPECT_THAT(reasons(), HasSubstr("run.json: it is not there"));
  EXPECT_THAT(reasons(), HasSubstr("events.jsonl: it is not there"));
}

TEST_F(ReadRun, RefusesFilesOfSomebodyElse) {
  write("run.json", "{\"scenario\": 3}");
  write("events.jsonl", "time,x,y\n1,2,3\n");

  EXPECT_THAT(reasons(), HasSubstr("run.json"));
  EXPECT_THAT(reasons(), HasSubstr("events.jsonl:1: "));
  EXPECT_THAT(reasons(), HasSubstr("no line can be read"));
}

TEST_F(ReadRun, RefusesWhatIsNoFolderOrNoFile) {
  EXPECT_FALSE(read_run("/no/such/run").has_value());
  std::filesystem::create_directory(folder_.path() / "run.json");
  EXPECT_THAT(reasons(), HasSubstr("it is no file"));
}

}  // namespace
}  // namespace skein::recording
