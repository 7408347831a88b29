// SPDX-License-Identifier: Apache-2.0
#include "recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/replay_tool/replay.hpp"
#include "temporary_folder.hpp"

namespace skein::replay_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RunFolder : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder.path() / name) << text;
  }
  std::string problem() const {
    const auto read = read_recording(folder.path());
    return read ? "" : read.error().why;
  }
  skein::testing::TemporaryFolder folder;
};

constexpr const char* kWorld = R"({"scenario": "two", "uavs": [{"name": "b"}, {"name": "a"}]})";
constexpr const char* kLine = R"({"at":2.0,"node":"ground","kind":"phase","name":"Search"})";

TEST_F(RunFolder, IsReadInTheOrderOfTimeWithTheUavsOfItsWorld) {
  write("world.json", kWorld);
  write("events.jsonl", std::string(kLine) + "\n" +
                            R"({"at":1.0,"node":"sim","kind":"mission","state":"started"})");

  const auto read = read_recording(folder.path());

  ASSERT_TRUE(read.has_value()) << read.error().why;
  EXPECT_THAT(read->uavs, ElementsAre("b", "a"));
  ASSERT_EQ(read->records.size(), 2U);
  EXPECT_EQ(read->records[0].kind(), "mission");
  EXPECT_EQ(nlohmann::json::parse(read->world)["replay"]["until"], 2.0);
}

TEST_F(RunFolder, LinesThatCannotBeReadAreCounted) {
  write("world.json", kWorld);
  write("events.jsonl", std::string(kLine) + "\n{\"at\":3.0,\"no\n\nrubbish\n");

  const auto read = read_recording(folder.path());

  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->records.size(), 1U);
  EXPECT_EQ(read->unreadable, 2U);
}

TEST_F(RunFolder, WhatIsMissingOrDamagedIsNamed) {
  EXPECT_THAT(problem(), HasSubstr("world.json is not there"));
  write("world.json", "[1, 2");
  EXPECT_THAT(problem(), HasSubstr("world.json: expected an object with a list `uavs`"));
  write("world.json", R"({"uavs": [{"name": 3}]})");
  EXPECT_THAT(problem(), HasSubstr("world.json: a UAV without a name"));
  write("world.json", kWorld);
  EXPECT_THAT(problem(), HasSubstr("events.jsonl is not there"));
  write("events.jsonl", "rubbish\n");
  EXPECT_THAT(problem(), HasSubstr("no line that can be read"));
}

TEST_F(RunFolder, TheCommandEndsWithTwoAndTheReason) {
  std::ostringstream out, err;

  EXPECT_EQ(replay({folder.path().string()}, out, err), kExitBadInput);

  EXPECT_THAT(err.str(), HasSubstr("world.json is not there"));
}

}  // namespace
}  // namespace skein::replay_tool
