// SPDX-License-Identifier: Apache-2.0
// Operators at shells of their own, in a mission whose daemons run.
#include <gmock/gmock.h>

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

  Answered skein(std::vector<std::string> words) { return run_.skein(std::move(words)); }

  json uav(const std::string& name) {
    const Answered answered = skein({"status", "--json"});
    const json status = json::parse(answered.text, nullptr, false);
    EXPECT_TRUE(status.is_object()) << answered.text;
    for (const json& one : status.value("uavs", json::array()))
      if (one.at("uav") == name) return one;
    ADD_FAILURE() << answered.text;
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

TEST_F(Operators, WhatCannotBeReadIsRefusedWithItsPlaceAndNothingIsDone) {
  start_comets();
  std::ofstream(run_.file("request.json")) << R"([{"take_in_hand": {"uav": "nobody"}}])";

  const Answered answered = skein({"operate", "do", run_.file("request.json").string()});

  EXPECT_EQ(answered.code, 1) << answered.text;
  EXPECT_THAT(answered.text, HasSubstr("nobody"));
}

}  // namespace
}  // namespace skein::testing
