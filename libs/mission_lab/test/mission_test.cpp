// SPDX-License-Identifier: Apache-2.0
// The text of a mission, and missions with one part less: with them a law that is broken is shown
// by the fewest parts that break it.
#include "skein/mission_lab/mission.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "testing/drawn_mission.hpp"

namespace skein::mission_lab {
namespace {

using ::testing::HasSubstr;

Mission small_mission() {
  Mission mission;
  mission.seed = 42;
  mission.limit = 900;
  mission.hills = "{at: [10, 20], height: 5, radius: 30}";
  mission.wind = "toward: 1.0, speed: 2.0, gusts: 0.1";
  mission.zones = {"Z1: [[0, 0], [9, 0], [9, 9]]"};
  mission.places = {"P1: [1, 2, 0]"};
  mission.volumes = {"tower: {polygon: [[0, 0], [1, 0], [1, 1]]}"};
  mission.objects = {"hot: {kind: fire, position: [5, 5], radius: 5}"};
  mission.followed = {"F1: {kind: fire, reach: 60, drift: 0.5}"};
  mission.team = {{"karma", "karma", "start: [0, 0]", 90, 100},
                  {"mana", "mana", "start: [5, 5]", 0, 1100, "action", 2}};
  mission.cuts = {"{between: [karma, ground], from: 30, until: 60}"};
  mission.relays = {"mana"};
  mission.steps = {
      {"first",
       "{time: 5}",
       12,
       "karma",
       1,
       "first, interrupt: true",
       false,
       {{700, "[perceive, P1, 30]", "end_before: 300"}, {701, "[general-land]", ""}},
       ""},
      {"stop", "{time: 50}", 0, "", 0, "", false, {}, "cancel: {uav: karma, mission: 1}"}};
  mission.faults = {"{at: 100, kill: sim, restart_after: 5}"};
  mission.separation = "{merge: true}";
  return mission;
}

const char* const kSmallMission = R"(# Metres, seconds, radians; x east, y north, z up.
scenario: random-42
epoch: 2005-05-19T09:00:00Z
duration_limit: 900
seed: 42

world:
  origin: {latitude: 40.1094, longitude: -8.2361, altitude: 200}
  terrain:
    west: -300
    south: -300
    east: 1200
    north: 900
    cell: 20
    hills: [{at: [10, 20], height: 5, radius: 30}]
  wind: {toward: 1.0, speed: 2.0, gusts: 0.1}
  zones:
    Z1: [[0, 0], [9, 0], [9, 9]]
  places:
    P1: [1, 2, 0]
  volumes:
    tower: {polygon: [[0, 0], [1, 0], [1, 1]]}
  objects:
    hot: {kind: fire, position: [5, 5], radius: 5}

uavs:
  karma: {model: ../comets/models/karma.yaml, start: [0, 0], degree: 4}
  mana: {model: ../action/models/mana.yaml, start: [5, 5], degree: 2}

planning:
  domain: ../domains/comets.lisp
  altitude: 40
  voxel: 20
  risk: 0.2
  altitudes: {karma: 90, mana: 0}
  first_ids: {karma: 100, mana: 1100}

separation: {merge: true}

radio:
  range: 3000
  line_of_sight: true
  latency: 0.02
  loss: 0
  relays: [mana]
  cuts:
    - {between: [karma, ground], from: 30, until: 60}

ground:
  position: [-20, -20, 8]
  objects:
    F1: {kind: fire, reach: 60, drift: 0.5}
  script:
    - step: first
      when: {time: 5}
      after: 12
      do:
        - mission:
            uav: karma
            id: 1
            placement: first
            interrupt: true
            tasks:
              - {id: 700, task: [perceive, P1, 30], end_before: 300}
              - {id: 701, task: [general-land]}
    - step: stop
      when: {time: 50}
      do: [{cancel: {uav: karma, mission: 1}}]
    - step: end
      when:
        all:
          - {any: [{goal: {uav: karma, id: 700, state: achieved}}, {goal: {uav: karma, id: 700, state: failed}}, {goal: {uav: karma, id: 700, state: cancelled}}]}
          - {any: [{goal: {uav: karma, id: 701, state: achieved}}, {goal: {uav: karma, id: 701, state: failed}}, {goal: {uav: karma, id: 701, state: cancelled}}]}
      after: 30
      do: [{finish: true}]

faults:
  - {at: 100, kill: sim, restart_after: 5}
)";

TEST(MissionText, IsTheScenarioThatIsWrittenByHand) {
  EXPECT_EQ(to_yaml(small_mission(), ".."), kSmallMission);
}

TEST(MissionText, OfATeamSharesItsGlobalMissionOutAmongTheBidders) {
  Mission mission = small_mission();
  mission.team[1].degree = 0;
  mission.steps.clear();
  mission.global = {"{id: 11, task: [perceive, P1, 20]}"};
  mission.bidders = {"karma"};
  mission.joint = true;
  mission.consistency = "cip";
  const YAML::Node yaml = YAML::Load(to_yaml(mission, "../.."));

  EXPECT_EQ(yaml["uavs"]["mana"]["degree"].as<int>(), 5);
  EXPECT_EQ(yaml["team"]["members"][0].as<std::string>(), "karma");
  EXPECT_EQ(yaml["planning"]["consistency"].as<std::string>(), "cip");
  EXPECT_EQ(yaml["interaction"].as<std::string>(),
            "../../models/interaction/monitoring-with-relay.yaml");
  const YAML::Node script = yaml["ground"]["script"];
  ASSERT_EQ(script.size(), 2U);
  EXPECT_EQ(script[0]["do"][0]["global_mission"]["tasks"][0]["id"].as<int>(), 11);
  EXPECT_EQ(script[1]["when"]["global_mission"]["state"].as<std::string>(), "done");
}

TEST(MissionText, WithoutAnythingToDoOrWithoutAnEndHasNoLastStep) {
  Mission endless = small_mission();
  endless.finish_after = -1;
  Mission idle = small_mission();
  idle.steps.erase(idle.steps.begin());
  Mission asked = small_mission();
  asked.steps[0].evaluate = true;

  for (const Mission& mission : {endless, idle, asked})
    EXPECT_EQ(to_yaml(mission, "..").find("finish"), std::string::npos);
  EXPECT_THAT(to_yaml(asked, ".."), HasSubstr("            evaluate: true\n"));
}

// ---- with one part less ---------------------------------------------------------------------

/// How many parts could be left out of it.
std::size_t parts(const Mission& mission) {
  std::size_t count = mission.team.size() + mission.steps.size() + mission.faults.size() +
                      mission.cuts.size() + mission.volumes.size() + mission.objects.size() +
                      mission.followed.size() + mission.zones.size() + mission.places.size() +
                      mission.links.size() + mission.radio.size() + mission.global.size() +
                      (mission.hills.empty() ? 0U : 1U);
  for (const Step& step : mission.steps) {
    count += step.tasks.size() + (step.placement.empty() ? 0U : 1U);
    for (const Task& task : step.tasks) count += task.times.empty() ? 0U : 1U;
  }
  return count;
}

TEST(SmallerMissions, AreOneForEachPartThatCanGo) {
  // 2 vehicles, 2 steps, fault, cut, volume, fire, front, zone, place, hills, placement, times, and
  // either of the two tasks.
  EXPECT_EQ(smaller(small_mission()).size(), 16U);

  Mission one_task = small_mission();
  one_task.steps[0].tasks.pop_back();
  EXPECT_EQ(smaller(one_task).size(), 14U) << "a step without tasks would be another action";

  Mission team = small_mission();
  team.global = {"{id: 11}"};
  EXPECT_EQ(smaller(team).size(), 16U) << "the last task of a team stays";
  team.global.emplace_back("{id: 12}");
  EXPECT_EQ(smaller(team).size(), 18U);
  team.planning_takes = 5;
  EXPECT_EQ(smaller(team).size(), 19U);
}

TEST(SmallerMissions, HaveFewerPartsAndAreAllDifferent) {
  for (const test::Generator& generator : test::generators()) {
    const Mission whole = generator.draw(3, {});
    std::set<std::string> texts{to_yaml(whole, "..")};
    for (const Mission& less : smaller(whole)) {
      EXPECT_LT(parts(less), parts(whole)) << generator.name;
      texts.insert(to_yaml(less, ".."));
    }
    // Two of a kind with one text (cuts, say) give one text with either of them away.
    EXPECT_GT(texts.size(), smaller(whole).size() / 2) << generator.name;
  }
}

using Law = std::function<bool(const Mission&)>;

/// The first of the smaller ones that breaks the law still, until there is none.
Mission shrunk(Mission mission, const Law& broken) {
  while (true) {
    const std::vector<Mission> less = smaller(mission);
    const auto next = std::find_if(less.begin(), less.end(), broken);
    if (next == less.end()) return mission;
    mission = *next;
  }
}

TEST(SmallerMissions, LeadToTheFewestPartsThatBreakALaw) {
  for (const test::Generator& generator : test::generators()) {
    const Mission whole = generator.draw(5, {});
    const std::string wanted = whole.team.back().name;
    const Mission least = shrunk(whole, [&](const Mission& mission) {
      return std::any_of(mission.team.begin(), mission.team.end(),
                         [&](const Member& one) { return one.name == wanted; });
    });

    EXPECT_EQ(parts(least), 1U + least.global.size()) << generator.name;
    ASSERT_EQ(least.team.size(), 1U);
    EXPECT_EQ(least.team[0].name, wanted);
    EXPECT_LE(least.global.size(), 1U);
  }
}

TEST(SmallerMissions, KeepTheTwoPartsThatTogetherBreakALaw) {
  const Law broken = [](const Mission& mission) {
    return !mission.faults.empty() && !mission.steps.empty() && !mission.steps[0].tasks.empty() &&
           mission.steps[0].tasks.back().words == "[general-land]";
  };

  const Mission least = shrunk(small_mission(), broken);

  EXPECT_EQ(parts(least), 3U) << "the fault, the step, its task";
  EXPECT_TRUE(broken(least));
}

}  // namespace
}  // namespace skein::mission_lab
