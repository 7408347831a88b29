// SPDX-License-Identifier: Apache-2.0
// `skein batch` from its options to its exit code.
#include "skein/batch_tool/batch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "temporary_folder.hpp"

namespace skein::batch_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
namespace fs = std::filesystem;

const std::string kScenarios = SKEIN_SOURCE_DIR "/scenarios";

struct Told {
  int code = 0;
  std::string out, err;
};

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Batch : public ::testing::Test {
 protected:
  Batch() {
    options_.scenarios = {kScenarios + "/karma/detection.yaml"};
    options_.seeds = "1..3";
    options_.out = folder_.path().string();
    options_.quiet = true;
  }

  Told run() const {
    std::ostringstream out, err;
    const int code = batch(options_, out, err);
    return {code, out.str(), err.str()};
  }
  std::size_t lines() const {
    std::ifstream in(folder_.path() / "runs.csv");
    std::size_t n = 0;
    for (std::string line; std::getline(in, line);) ++n;
    return n;
  }

  skein::testing::TemporaryFolder folder_;
  BatchOptions options_;
};

TEST_F(Batch, PlaysOnceASeedAndLeavesTableLinesAndPicture) {
  const Told told = run();

  EXPECT_EQ(told.code, kExitOk) << told.out << told.err;
  EXPECT_THAT(told.out, HasSubstr("3 of 3 runs passed, 0 break a law"));
  EXPECT_EQ(lines(), 4U);
  EXPECT_THAT(text_of(folder_.path() / "summary.svg"), StartsWith("<svg"));
  EXPECT_EQ(told.err, "");
}

TEST_F(Batch, GivesTheSameBytesHoweverManyAreAtWork) {
  run();
  const std::string one = text_of(folder_.path() / "runs.csv");
  const std::string picture = text_of(folder_.path() / "summary.svg");
  options_.limits.jobs = 3;

  run();

  EXPECT_EQ(text_of(folder_.path() / "runs.csv"), one);
  EXPECT_EQ(text_of(folder_.path() / "summary.svg"), picture);
}

TEST_F(Batch, SweepsValuesAndKeepsEachRun) {
  options_.seeds = "7";
  options_.sets = {"duration_limit=30,40"};
  options_.keep = true;
  options_.json = true;

  const Told told = run();

  EXPECT_EQ(told.code, kExitNegative);
  const auto json = nlohmann::json::parse(told.out);
  EXPECT_EQ(json.at("series").size(), 2U);
  EXPECT_EQ(json.at("series").at(1).at("set").at("duration_limit"), "40");
  std::size_t folders = 0;
  for (const auto& entry : fs::directory_iterator(folder_.path()))
    folders += fs::exists(entry.path() / "events.jsonl") ? 1 : 0;
  EXPECT_EQ(folders, 2U);
}

TEST_F(Batch, WritesItsCsvWhereItIsTold) {
  options_.seeds = "1";
  options_.sets = {"duration_limit=20"};
  options_.csv = (folder_.path() / "mine.csv").string();

  run();

  EXPECT_THAT(text_of(options_.csv), StartsWith("scenario,duration_limit,seed,"));
  EXPECT_FALSE(fs::exists(folder_.path() / "runs.csv"));
}

TEST_F(Batch, SaysEverythingThatIsWrongBeforeItPlays) {
  options_.scenarios = {"/no/such.yaml", kScenarios + "/karma/detection.yaml"};
  options_.sets = {"rate=-4,2,fast"};

  const Told told = run();

  EXPECT_EQ(told.code, kExitBadInput);
  EXPECT_THAT(told.err, HasSubstr("/no/such.yaml"));
  EXPECT_THAT(told.err, HasSubstr("with rate=-4:"));
  EXPECT_THAT(told.err, HasSubstr("with rate=fast:"));
  EXPECT_EQ(lines(), 0U);
}

TEST_F(Batch, RefusesSeedsAndSweepsThatAreNone) {
  options_.seeds = "4..2";
  options_.sets = {"loss"};

  const Told told = run();

  EXPECT_EQ(told.code, kExitBadInput);
  EXPECT_THAT(told.err, HasSubstr("expected A..B"));
  EXPECT_THAT(told.err, HasSubstr("PATH=VALUE"));
}

TEST_F(Batch, RefusesTwoScenariosOfOneName) {
  options_.scenarios.push_back(options_.scenarios[0]);

  EXPECT_THAT(run().err, HasSubstr("another scenario is called"));
}

TEST_F(Batch, SaysWhatItCannotWrite) {
  options_.out = "/dev/null/batch";

  EXPECT_EQ(run().code, kExitSystem);
}

}  // namespace
}  // namespace skein::batch_tool
