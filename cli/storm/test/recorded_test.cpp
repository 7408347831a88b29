// SPDX-License-Identifier: Apache-2.0
// `skein judge` from its options to its exit code.
#include "skein/storm_tool/recorded.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/run_tool/run.hpp"
#include "temporary_folder.hpp"

namespace skein::storm_tool {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace fs = std::filesystem;

struct Answer {
  int code = 0;
  std::string out, err;
};

class Judged : public ::testing::Test {
 protected:
  /// Karma's detection, played in virtual time.
  void fly(const std::string& name, const std::vector<std::string>& degrees = {}) const {
    run_tool::RunOptions run;
    run.scenario = SKEIN_SOURCE_DIR "/scenarios/karma/detection.yaml";
    run.virtual_time = true;
    run.quiet = true;
    run.out = folder(name);
    run.overrides.degrees = degrees;
    std::ostringstream nobody;
    run_tool::run(run, nobody, nobody);
  }
  std::string folder(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string events(const std::string& name) const {
    std::ifstream in(fs::path(folder(name)) / "events.jsonl");
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write_events(const std::string& name, const std::string& text) const {
    std::ofstream(fs::path(folder(name)) / "events.jsonl") << text;
  }
  Answer judge_them(const std::vector<std::string>& names) {
    options_.folders.clear();
    for (const std::string& name : names) options_.folders.push_back(folder(name));
    std::ostringstream out, err;
    const int code = judge_runs(options_, out, err);
    return {code, out.str(), err.str()};
  }

  skein::testing::TemporaryFolder folder_;
  JudgeRunsOptions options_;
};

/// The log without the lines in which all of `words` stand.
std::string without(const std::string& events, const std::vector<std::string>& words) {
  std::string rest;
  std::istringstream in(events);
  for (std::string line; std::getline(in, line);) {
    const bool there = std::all_of(words.begin(), words.end(), [&](const std::string& word) {
      return line.find(word) != std::string::npos;
    });
    if (!there) rest += line + "\n";
  }
  return rest;
}

TEST_F(Judged, ARunThatKeepsTheLawsGivesZero) {
  fly("karma");

  const Answer told = judge_them({"karma"});

  EXPECT_EQ(told.code, kExitOk) << told.out << told.err;
  EXPECT_THAT(told.out, HasSubstr("no law was broken"));
  EXPECT_THAT(told.err, IsEmpty());
}

TEST_F(Judged, ALogInWhichTheLooksOfItsGoalsAreMissingBreaksALaw) {
  fly("karma");
  const std::string all = events("karma");
  write_events("karma", without(all, {"\"type\":\"takeshot\""}));
  ASSERT_NE(all, events("karma"));

  const Answer told = judge_them({"karma"});

  EXPECT_EQ(told.code, kExitNegative) << told.out;
  EXPECT_THAT(told.out, HasSubstr("perceived: "));
}

TEST_F(Judged, AsJsonEachFolderIsTold) {
  fly("a");
  fly("b");
  options_.json = true;

  const auto told = nlohmann::json::parse(judge_them({"a", "b"}).out);

  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[1].at("folder"), folder("b"));
  EXPECT_EQ(told[1].at("goals").at("all"), told[0].at("goals").at("all"));
  EXPECT_THAT(told[1].at("violations"), IsEmpty());
}

TEST_F(Judged, TheScenarioIsThatOfTheRunWithItsDegrees) {
  fly("karma", {"2"});

  const auto recorded = read_recorded(folder("karma"));

  ASSERT_TRUE(recorded.has_value()) << to_text(recorded.error());
  EXPECT_EQ(recorded->scenario.uavs.front().degree, 2);
}

TEST_F(Judged, FoldersThatAreNoneAndLawsThatAreNoneAreAllNamed) {
  options_.only = {"separatoin"};

  const Answer told = judge_them({"nowhere", "neither"});

  EXPECT_EQ(told.code, kExitBadInput);
  EXPECT_THAT(told.err, AllOf(HasSubstr("nowhere"), HasSubstr("neither"),
                              HasSubstr("did you mean 'separation'")));
  EXPECT_THAT(told.out, IsEmpty());
}

TEST_F(Judged, LinesThatCannotBeReadAreNamedAndTheRestIsJudged) {
  fly("karma");
  write_events("karma", events("karma") + "{\"t\": 12\n");

  const Answer told = judge_them({"karma"});

  EXPECT_EQ(told.code, kExitOk) << told.out;
  EXPECT_THAT(told.err, HasSubstr("events.jsonl:"));
}

}  // namespace
}  // namespace skein::storm_tool
