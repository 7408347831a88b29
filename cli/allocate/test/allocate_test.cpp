// SPDX-License-Identifier: Apache-2.0
#include "skein/allocate_tool/allocate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace skein::allocate_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Json = nlohmann::json;

struct Ran {
  int code = -1;
  std::string out, err;
  Json line(int number = 0) const {
    std::istringstream lines(out);
    std::string text;
    for (int i = 0; i <= number; ++i) std::getline(lines, text);
    return Json::parse(text);
  }
};

Ran run(const std::string& input, AllocateOptions options = {}) {
  std::istringstream in(input);
  std::ostringstream out, err;
  Ran done;
  done.code = allocate(options, in, out, err);
  done.out = out.str();
  done.err = err.str();
  return done;
}

constexpr const char* kTours = R"({"vehicles":[[0,0],[100,0]],"tasks":[[10,0],[90,0],[20,0]]})";
// Two robots, a task that needs both skills, and one before it.
constexpr const char* kRobots =
    R"({"skills":[[1,0],[0,1]],"needs":[[0,0],[1,0],[1,1],[0,0]],"duration":[0,10,20,0],)"
    R"("at":[[0,0],[10,0],[20,0],[30,0]],"before":[[1,2]]})";

TEST(Allocate, ToursAreGivenByVehicleWithTheirSum) {
  const Ran done = run(kTours);

  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.line()["aim"], "sum");
  EXPECT_EQ(done.line()["value"], 30);
  EXPECT_EQ(done.line()["tours"], Json::parse("[[0,2],[1]]"));
  EXPECT_GT(done.line()["messages"], 0);
  EXPECT_GT(done.line()["rounds"], 0);
}

TEST(Allocate, TheLongestTourIsAnAimOfItsOwn) {
  const Ran done = run(kTours, {"", true, 1});

  EXPECT_EQ(done.line()["aim"], "longest");
  EXPECT_EQ(done.line()["value"], 20);
}

TEST(Allocate, RobotsMeetForWhatNoneCanDoAlone) {
  const Ran done = run(kRobots);

  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.line()["aim"], "makespan");
  EXPECT_EQ(done.line()["schedule"], Json::parse(R"({"0":[[1,10.0],[2,30.0]],"1":[[2,30.0]]})"));
  EXPECT_EQ(done.line()["value"], 60);
}

TEST(Allocate, OneSeedIsOneAnswer) {
  const std::string input = std::string(kTours) + "\n" + kRobots + "\n";

  EXPECT_EQ(run(input, {"", false, 3}).out, run(input, {"", false, 3}).out);
}

TEST(Allocate, FiftyRequestsHaveFiftyAnswers) {
  std::string input;
  for (int i = 0; i < 50; ++i) {
    input += R"({"vehicles":[[0,0],[9,9]],"tasks":[[)" + std::to_string(i) + ",0]]}\n";
  }

  const Ran done = run(input);

  EXPECT_EQ(done.code, 0);
  EXPECT_EQ(std::count(done.out.begin(), done.out.end(), '\n'), 50);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(done.line(i)["unsold"], Json()) << i;
}

TEST(Allocate, ATaskNobodyCanDoIsNamedWithTheReasonOfEach) {
  std::string input = kRobots;
  input.replace(input.find("[0,1]"), 5, "[0,0]");

  const Ran done = run(input);

  EXPECT_EQ(done.code, 1);
  EXPECT_EQ(done.line()["unsold"][0]["task"], 2);
  EXPECT_THAT(done.line()["unsold"][0]["together"], HasSubstr("lack an ability"));
}

TEST(Allocate, ACircleOfPrecedencesIsNamed) {
  std::string input = kRobots;
  input.replace(input.find("[[1,2]]"), 7, "[[1,2],[2,1]]");

  const Ran done = run(input);

  EXPECT_EQ(done.code, 1);
  EXPECT_EQ(done.line()["unsold"][0]["tasks"].size(), 3U);
}

TEST(Allocate, EverythingWrongIsSaidAtOnceAndNothingIsSold) {
  const Ran done =
      run(std::string(kTours) + "\n" + R"({"vehicles":[[0]],"tasks":[[1,"x"]],"speeds":[]})" +
              "\nnonsense\n" +
              R"({"skills":[[1,2]],"needs":[[0,0],[1]],"duration":[0],"at":[[0,0],[1,1]],)" +
              R"("before":[[1,0],[5,6]]})" + "\n[]\n",
          {"team.jsonl", false, 1});

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.out, IsEmpty());
  for (const char* said :
       {"team.jsonl:2: vehicles[0]: not a place", "team.jsonl:2: tasks[0][1]: not a number",
        "team.jsonl:2: speeds: unknown key", "team.jsonl:3: ",
        "team.jsonl:4: skills[0][1]: not a skill", "team.jsonl:4: needs[1]: 1 skills",
        "team.jsonl:4: duration: not as many", "team.jsonl:4: before[0]: cannot hold",
        "team.jsonl:4: before[1]: not a pair", "team.jsonl:5: not an object"}) {
    EXPECT_THAT(done.err, HasSubstr(said));
  }
}

// The tasks that are missing are told; that no pair can be of them needs not be said too.
TEST(Allocate, PrecedencesOfNoTasksAreNotCountedToTheirEnd) {
  const Ran done = run(R"({"skills":[[1]],"needs":[],"duration":[],"at":[[0,0],[1,1]],)"
                       R"("before":[[0,1]]})");

  EXPECT_THAT(done.err, HasSubstr("needs: not as many as places"));
  EXPECT_THAT(done.err, Not(HasSubstr("before")));
}

TEST(Allocate, NobodyAndNothingAreTold) {
  EXPECT_THAT(run(R"({"vehicles":[],"tasks":[]})").err, HasSubstr("at least one"));
  const Ran idle = run(R"({"vehicles":[[0,0]],"tasks":[]})");
  EXPECT_EQ(idle.code, 0);
  EXPECT_EQ(idle.line()["tours"], Json::parse("[[]]"));
}

}  // namespace
}  // namespace skein::allocate_tool
