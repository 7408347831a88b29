// SPDX-License-Identifier: Apache-2.0
// Operators at shells of their own, in a mission whose daemons run.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class Operators : public ::testing::Test {
 protected:
  void start_comets(const std::string& faults = "") {
    run_.take_scenario("confirmed", faults);
    run_.start({"--rate", "5"});
    run_.wait_for_output("the mission starts");
  }

  /// Karma, which plans for itself; the script waits for an operator to say "begin".
  void start_karma(const std::string& more = "") {
    run_.take_scenario_of("karma/detection", more);
    run_.change("when: {time: 5}", "when: {operator: begin}");
    run_.start({"--rate", "10"});
    run_.wait_for_output("the mission starts");
  }

  Answered skein(std::vector<std::string> words) { return run_.skein(std::move(words)); }

  json status() {
    const Answered answered = skein({"status", "--json"});
    json status = json::parse(answered.text, nullptr, false);
    EXPECT_TRUE(status.is_object()) << answered.text;
    return status;
  }

  /// The state of a high-level task of Karma's, or "".
  std::string goal(int id) {
    for (const json& one : uav("karma").value("goals", json::array()))
      if (one.at("id") == id) return one.at("state");
    return "";
  }

  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(run_.file(name)) << text;
    return run_.file(name).string();
  }

  json uav(const std::string& name) {
    const json all = status();
    for (const json& one : all.value("uavs", json::array()))
      if (one.at("uav") == name) return one;
    ADD_FAILURE() << all;
    return {};
  }

  DdsRun run_;
};

TEST_F(Operators, AUavIsTakenInHandKnownToAllAndGivenBack) {
  start_comets();

  const Answered taken = skein({"operate", "take", "marvin", "--as", "ada"});
  EXPECT_EQ(taken.code, 0) << taken.text;
  EXPECT_THAT(taken.text, HasSubstr("marvin: DEGREE 1: acknowledged"));
  const json held = uav("marvin");
  EXPECT_EQ(held.value("holder", ""), "ada");
  EXPECT_EQ(held.value("degree", 0), 1);

  const Answered other = skein({"operate", "degree", "marvin", "2", "--as", "bo"});
  EXPECT_EQ(other.code, 1) << other.text;
  EXPECT_THAT(other.text, HasSubstr("ada"));

  const Answered back = skein({"operate", "give-back", "marvin", "--as", "ada"});
  EXPECT_EQ(back.code, 0) << back.text;
  const json free = uav("marvin");
  EXPECT_EQ(free.value("holder", "?"), "");
  EXPECT_EQ(free.value("degree", 0), 3);
}

TEST_F(Operators, ARequestOfOneNumberIsDoneOnceHoweverOftenItIsSaid) {
  start_comets();
  const std::vector<std::string> take = {"operate", "take",     "karma", "--as",
                                         "ada",     "--number", "7"};

  EXPECT_EQ(skein(take).code, 0);
  EXPECT_EQ(skein({"operate", "give-back", "karma", "--as", "ada", "--number", "8"}).code, 0);
  EXPECT_EQ(skein(take).code, 0);  // the answer of before

  EXPECT_EQ(uav("karma").value("holder", "?"), "");
}

TEST_F(Operators, AGroundStationThatDiesAndComesBackKnowsWhoHasWhatInHand) {
  start_comets("faults: [{at: 40, kill: ground, restart_after: 5}]\n");
  ASSERT_EQ(skein({"operate", "take", "marvin", "--as", "ada"}).code, 0);

  run_.wait_until("restart of the ground station", [&] {
    std::ifstream log(run_.folder() / "logs" / "ground.log");
    const std::string text{std::istreambuf_iterator<char>(log), {}};
    return text.find("resumed") != std::string::npos;
  });

  EXPECT_EQ(uav("marvin").value("holder", ""), "ada");
  EXPECT_EQ(skein({"operate", "give-back", "marvin", "--as", "ada"}).code, 0);
}

TEST_F(Operators, AMissionFromAFileIsCarriedOutOnceAndWhatIsLeftOfItCancelled) {
  start_karma();
  const std::string file =
      write("mission.yaml",
            "uav: karma\n"
            "id: 901\n"
            "tasks:\n"
            "  - {id: 9001, task: [general-takeoff]}\n"
            "  - {id: 9002, task: [general-combined-goto-and-takeshot, P1, 600]}\n");
  const std::vector<std::string> give = {"operate", "mission",  file, "--as",
                                         "ada",     "--number", "3",  "--json"};

  const Answered given = skein(give);
  const json reply = json::parse(given.text, nullptr, false);
  EXPECT_EQ(given.code, 0) << given.text;
  ASSERT_TRUE(reply.is_object()) << given.text;
  EXPECT_EQ(reply["commands"][0]["state"], "acknowledged");
  EXPECT_EQ(json::parse(skein(give).text, nullptr, false)["commands"], reply["commands"])
      << "the same number is the same request";

  run_.wait_until("take-off", [&] { return goal(9001) == "achieved"; });
  const Answered cancelled = skein({"operate", "cancel", "karma", "9002", "--as", "bo"});
  EXPECT_EQ(cancelled.code, 0) << cancelled.text;
  run_.wait_until("cancellation", [&] { return goal(9002) == "cancelled"; });
}

TEST_F(Operators, AMissionThatMakesNoSenseIsRefusedWithEveryReason) {
  start_karma();
  const std::string file = write("mission.yaml",
                                 "uav: karma\n"
                                 "id: 901\n"
                                 "tasks:\n"
                                 "  - {id: 9001, task: [general-takeof]}\n"
                                 "  - {id: 9002, task: [perform-detection, nowhere, P2, 300]}\n");

  const Answered refused = skein({"operate", "mission", file});

  EXPECT_EQ(refused.code, 1) << refused.text;
  EXPECT_THAT(refused.text, HasSubstr("general-takeoff")) << "the nearest name";
  EXPECT_THAT(refused.text, HasSubstr("nowhere"));
}

TEST_F(Operators, AMissionForAUavThatIsGoneIsSaidToHaveExpired) {
  start_karma("faults: [{at: 30, kill: karma}]\n");
  const auto hears_karma = [&] { return uav("karma").value("reachable", false); };
  run_.wait_until("word of Karma", hears_karma);
  run_.wait_until("silence of Karma", [&] { return !hears_karma(); });
  const std::string file = write(
      "mission.yaml", "{uav: karma, id: 901, tasks: [{id: 9001, task: [general-takeoff]}]}\n");

  const Answered given = skein({"operate", "mission", file});

  EXPECT_EQ(given.code, 1) << given.text;
  EXPECT_THAT(given.text, HasSubstr("issued"));
  EXPECT_THAT(given.text, HasSubstr("expired: not delivered: no contact in its lifetime"));
  EXPECT_EQ(goal(9001), "") << "nothing is believed of a mission that never came";
}

TEST_F(Operators, WhatTheScriptWaitsForIsAnswered) {
  start_karma();
  EXPECT_EQ(status().value("answers", json::array()), json::array({"begin"}));

  const Answered other = skein({"operate", "answer", "begni"});
  EXPECT_EQ(other.code, 1) << other.text;
  EXPECT_THAT(other.text, HasSubstr("begin"));
  EXPECT_EQ(skein({"operate", "answer", "begin"}).code, 0);

  run_.wait_until("phase", [&] { return status().value("phase", "") == "Detection"; });
}

TEST_F(Operators, AUavInHandFliesWhereItIsToldAndAnAlarmIsJudgedByAPerson) {
  start_comets();
  run_.wait_until("flight", [&] { return uav("marvin").value("airborne", false); });
  const std::vector<std::string> go = {"operate", "go", "marvin", "60,40", "--altitude", "50"};
  const Answered early = skein(go);
  EXPECT_EQ(early.code, 1) << "it is in nobody's hand: " << early.text;

  run_.wait_until(
      "alarm", [&] { return !status()["alarms"].empty(); }, 120);
  const Answered judged = skein({"operate", "judge", "1", "infirmed"});
  EXPECT_EQ(judged.code, 0) << judged.text;
  run_.wait_until("judgement", [&] { return status()["alarms"][0]["state"] == "infirmed"; });

  ASSERT_EQ(skein({"operate", "take", "marvin"}).code, 0);
  const Answered flies = skein(go);
  EXPECT_EQ(flies.code, 0) << flies.text;
  const auto is_there = [&] {
    const json at = uav("marvin")["position"];
    return std::hypot(at["x"].get<double>() - 60, at["y"].get<double>() - 40) < 10;
  };
  run_.wait_until("arrival", is_there, 120);
}

TEST_F(Operators, WhatCannotBeReadIsRefusedWithItsPlaceAndNothingIsDone) {
  start_comets();
  std::ofstream(run_.file("request.json")) << R"([{"take_in_hand": {"uav": "nobody"}}])";

  const Answered answered = skein({"operate", "do", run_.file("request.json").string()});

  EXPECT_EQ(answered.code, 1) << answered.text;
  EXPECT_THAT(answered.text, HasSubstr("nobody"));
}

}  // namespace
}  // namespace skein::testing
