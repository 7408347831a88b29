// SPDX-License-Identifier: Apache-2.0
// `skein compare` from its options to its exit code.
#include "skein/compare_tool/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "story.hpp"
#include "temporary_folder.hpp"

namespace skein::compare_tool {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class Compare : public ::testing::Test {
 protected:
  void keep(const std::string& name, const std::vector<Record>& records) const {
    const auto run = run_of(records);
    fs::create_directories(folder_.path() / name);
    std::ofstream(folder_.path() / name / "events.jsonl") << run.events;
    report::RunInfo info;
    info.scenario = "search";
    info.epoch = "2026-01-01T00:00:00Z";
    info.version = "0.1.0";
    std::ofstream(folder_.path() / name / "run.json") << report::to_json(info);
  }
  int compare_them() {
    out_.str("");
    err_.str("");
    options_.first = (folder_.path() / "a").string();
    options_.second = (folder_.path() / "b").string();
    return compare(options_, out_, err_);
  }

  skein::testing::TemporaryFolder folder_;
  CompareOptions options_;
  std::ostringstream out_, err_;
};

TEST_F(Compare, RunsThatAreTheSameSaysSo) {
  keep("a", {task(5, "started"), finished(9)});
  keep("b", {task(5, "started"), finished(9)});

  EXPECT_EQ(compare_them(), kExitOk);
  EXPECT_THAT(out_.str(), HasSubstr("same to the byte"));
}

TEST_F(Compare, RunsThatDifferSaysInWhatAndWhere) {
  keep("a", {task(5, "started"), task(8, "ended"), finished(9)});
  keep("b", {task(5, "started"), task(12.5, "ended"), finished(13)});

  EXPECT_EQ(compare_them(), kExitNegative);
  EXPECT_THAT(out_.str(), HasSubstr("tasks: 1 of 2 differ"));
  EXPECT_THAT(out_.str(), HasSubstr("A: ended at 8 s"));
  EXPECT_THAT(out_.str(), HasSubstr("B: ended at 12.5 s (+4.5 s)"));
  EXPECT_THAT(out_.str(), HasSubstr("the event logs part in line 2"));
}

TEST_F(Compare, WithinATimeWhatIsLeftCounts) {
  keep("a", {task(5, "started"), finished(9)});
  keep("b", {task(5.25, "started"), finished(9)});
  options_.within = 1;

  EXPECT_EQ(compare_them(), kExitOk);
  EXPECT_THAT(out_.str(), HasSubstr("the same in outcome"));
}

TEST_F(Compare, AsJsonTheSameIsTold) {
  keep("a", {goal(5, "achieved"), finished(9)});
  keep("b", {goal(5, "failed"), finished(9)});
  options_.json = true;

  EXPECT_EQ(compare_them(), kExitNegative);
  const auto json = nlohmann::json::parse(out_.str());
  EXPECT_FALSE(json.at("same"));
  EXPECT_EQ(json.at("differences").at("goals").at(0).at("b").at("text"), "failed");
  EXPECT_EQ(json.at("divergence").at("line"), 1);
}

TEST_F(Compare, ManyDifferencesAreShortenedUnlessAllAreAskedFor) {
  std::vector<Record> many;
  for (int id = 0; id < 30; ++id)
    many.push_back(line(id, "marvin", "task")
                       .with("uav", "marvin")
                       .with("task", id)
                       .with("type", "goto")
                       .with("state", "started"));
  keep("a", many);
  keep("b", {finished(9)});

  compare_them();
  EXPECT_THAT(out_.str(), HasSubstr("more (--all)"));
  options_.all = true;
  compare_them();
  EXPECT_THAT(out_.str(), HasSubstr("task 29 goto"));
}

TEST_F(Compare, FoldersThatAreNoneOrDamagedAreRefusedWithEveryReason) {
  keep("b", {finished(9)});
  std::ofstream(folder_.path() / "b/events.jsonl", std::ios::app) << "{\"at\": 1, \"no";

  EXPECT_EQ(compare_them(), kExitBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("a: no such folder"));
  EXPECT_THAT(err_.str(), HasSubstr("b/events.jsonl:2: "));
}

}  // namespace
}  // namespace skein::compare_tool
