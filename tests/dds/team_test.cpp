// SPDX-License-Identifier: Apache-2.0
// Teams over real DDS: what is shared out at degree 5 (spec 6.3, 8.9), ways that cross (6.4).
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using nlohmann::json;

TEST(DdsTeam, AGlobalMissionIsSharedOut) { expect_all_met("team/two", "10"); }

TEST(DdsTeam, UavsAtDifferentDegreesDoNotDisturbEachOther) { expect_all_met("team/mixed", "10"); }

TEST(DdsTeam, CometsIsOneGlobalMission) { expect_all_met("team/comets", "20"); }

TEST(DdsTeam, UavsWhoseWaysCrossMergeThem) { expect_all_met("team/crossing", "10"); }

TEST(DdsTeam, TwoHelicoptersAndSixRobotsPatrol) { expect_all_met("action/patrol", "15"); }

TEST(DdsTeam, OperatorsSeeWhoHasWhat) {
  DdsRun run;
  run.take_scenario_of("team/two");
  run.start({"--rate", "10"});
  json team;

  run.wait_until("all tasks of the team are done", [&] {
    const json status = json::parse(run.skein({"status", "--json"}).text, nullptr, false);
    if (!status.is_object()) return false;
    team = status.value("team", json::array());
    return !team.empty() && std::all_of(team.begin(), team.end(), [](const json& task) {
      return task.value("stage", "") == "done";
    });
  });
  const Answered tables = run.skein({"status"});

  for (const json& task : team) {
    EXPECT_EQ(task.at("owners").size(), 1U) << task;
    EXPECT_THAT(task.value("statement", ""), ::testing::HasSubstr("perceive"));
  }
  EXPECT_THAT(tables.text, ::testing::HasSubstr("TASKS OF THE TEAM"));
  EXPECT_TRUE(run.wait().has_value());
}

}  // namespace
}  // namespace skein::testing
