// SPDX-License-Identifier: Apache-2.0
#include "skein/state_tool/state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/store/sqlite_input_log.hpp"
#include "temporary_folder.hpp"

namespace skein::state_tool {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::json;

class State : public ::testing::Test {
 protected:
  State() {
    const auto opened = store::SqliteInputLog::open(folder_, {"karma", "detection 5"});
    wire::TaskRequest request;
    request.id = 4;
    (void)opened->log->append({MissionTime(), node::Started{3}});
    (void)opened->log->append(
        {MissionTime::seconds(2), node::Received{node::NodeNumber(1), request}});
    (void)opened->log->append({MissionTime::seconds(9), node::Resumed{}});
  }

  int run(StateOptions::What what, bool json = false) {
    out.str("");
    err.str("");
    return state({what, (folder_ / "karma.state").string(), json}, out, err);
  }
  void with_log(const std::function<void(store::SqliteInputLog&)>& change) {
    change(*store::SqliteInputLog::open(folder_, {"karma", "detection 5"})->log);
  }

  const skein::testing::TemporaryFolder own_;
  const fs::path folder_ = own_.path();
  std::ostringstream out, err;
};

TEST_F(State, ShowsWhoseItIsAndWhatIsInIt) {
  EXPECT_EQ(run(StateOptions::What::kShow), 0);

  EXPECT_THAT(out.str(), HasSubstr("karma in mission detection 5"));
  EXPECT_THAT(out.str(), HasSubstr("3 inputs in 2 lives, mission time 0 s to 9 s"));
  EXPECT_THAT(out.str(), HasSubstr("1  received TaskRequest"));
  EXPECT_THAT(out.str(), HasSubstr("a daemon would go on from it"));
}

TEST_F(State, ShowsItToPrograms) {
  EXPECT_EQ(run(StateOptions::What::kShow, true), 0);

  const Json shown = Json::parse(out.str());
  EXPECT_EQ(shown["node"], "karma");
  EXPECT_EQ(shown["lives"], 2);
  EXPECT_EQ(shown["kinds"]["received TaskRequest"], 1);
}

TEST_F(State, ExportsEveryInput) {
  EXPECT_EQ(run(StateOptions::What::kExport), 0);

  std::istringstream lines(out.str());
  std::vector<Json> found;
  for (std::string line; std::getline(lines, line);) found.push_back(Json::parse(line));
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[1]["at"], 2);
  EXPECT_EQ(found[1]["slot"], "TaskRequest");
  EXPECT_EQ(found[1]["sample"]["id"], 4);
  EXPECT_EQ(found[2]["kind"], "resumed");
}

TEST_F(State, ChecksWhetherADaemonWouldGoOnFromIt) {
  EXPECT_EQ(run(StateOptions::What::kCheck), 0);
  EXPECT_THAT(out.str(), HasSubstr("sound, 3 inputs"));

  with_log([](store::SqliteInputLog& log) { log.conclude(); });

  EXPECT_EQ(run(StateOptions::What::kCheck), 1);
  EXPECT_THAT(err.str(), HasSubstr("its mission is over"));
}

TEST_F(State, FindsWhatIsDamaged) {
  std::ofstream(folder_ / "karma.state", std::ios::trunc) << "no longer a database, just words";
  fs::remove(folder_ / "karma.state-wal");

  EXPECT_EQ(run(StateOptions::What::kCheck), 1);
  EXPECT_THAT(err.str(), HasSubstr("karma.state: damaged"));
  EXPECT_THAT(err.str(), HasSubstr("; a daemon sets it aside and begins anew"));
  EXPECT_EQ(run(StateOptions::What::kShow), 2);
}

TEST_F(State, SaysWhyThereIsNothingToRead) {
  const auto said_of = [&](const fs::path& file) {
    err.str("");
    EXPECT_EQ(state({StateOptions::What::kCheck, file.string(), false}, out, err), 2);
    return err.str();
  };
  EXPECT_THAT(said_of(folder_ / "heliv.state"), HasSubstr("heliv.state: no such file\n"));
  EXPECT_THAT(said_of(folder_),
              HasSubstr(": a folder; the state of a node is its file NODE.state"));
  EXPECT_THAT(said_of("/dev/null"), HasSubstr("/dev/null: no regular file\n"));
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(said_of(folder_ / "pipe"), HasSubstr("pipe: no regular file\n"))
      << "nobody waits for somebody who writes into it";
}

}  // namespace
}  // namespace skein::state_tool
