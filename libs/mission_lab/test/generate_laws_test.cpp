// SPDX-License-Identifier: Apache-2.0
// Laws that hold for the missions of every generator: names that are used exist, ids are unique,
// figures lie in the world, and what was not asked for is not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "test_cases.hpp"
#include "testing/drawn_mission.hpp"

namespace skein::mission_lab {
namespace {

using test::DrawnMission;
using test::keys;
using test::Names;
using test::numbers;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSubsetOf;
using ::testing::Not;

const std::uint64_t kSeeds = skein::testing::cases(4, 40);

class Generators : public ::testing::TestWithParam<test::Generator> {
 protected:
  template <class Law>
  void for_all(const Law& law, const Kinds& kinds = {}) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      law(DrawnMission(GetParam().draw(seed, kinds)));
    }
  }
};

TEST_P(Generators, DrawATeamOfTheSizeThatTheyDeclare) {
  for_all([&](const DrawnMission& drawn) {
    EXPECT_GE(drawn.uavs().size(), GetParam().least);
    EXPECT_LE(drawn.uavs().size(), GetParam().most);
    EXPECT_EQ(drawn.uavs().size(), drawn.mission.team.size()) << "two of one name";
  });
}

TEST_P(Generators, GiveEachVehicleIdsThatNoOtherHas) {
  for_all([](const DrawnMission& drawn) {
    std::map<int, std::string> begins;
    for (const auto& entry : drawn.yaml["planning"]["first_ids"])
      EXPECT_TRUE(begins.emplace(entry.second.as<int>(), entry.first.as<std::string>()).second);
    EXPECT_EQ(begins.size(), drawn.mission.team.size());
    EXPECT_EQ(keys(drawn.yaml["planning"]["altitudes"]), drawn.uavs());
  });
}

TEST_P(Generators, NumberTheGoalsOfAVehicleOnceEach) {
  for_all([](const DrawnMission& drawn) {
    std::set<std::pair<std::string, int>> seen;
    for (const YAML::Node& mission : drawn.missions())
      for (const auto& task : mission["tasks"]) {
        const auto id = std::make_pair(mission["uav"].as<std::string>(), task["id"].as<int>());
        EXPECT_TRUE(seen.insert(id).second) << id.first << " " << id.second;
      }
  });
}

TEST_P(Generators, NumberTheMissionsOfAVehicleUpwardsInTheOrderOfTheScript) {
  for_all([](const DrawnMission& drawn) {
    std::map<std::string, int> last;
    for (const YAML::Node& mission : drawn.missions()) {
      int& before = last[mission["uav"].as<std::string>()];
      EXPECT_GT(mission["id"].as<int>(), before);
      before = mission["id"].as<int>();
    }
  });
}

TEST_P(Generators, NameEachStepOnceAndWaitForNoStepThatIsNotThere) {
  for_all([](const DrawnMission& drawn) {
    const Names steps = drawn.steps();
    EXPECT_EQ(steps.size(), drawn.script().size());
    test::walk(drawn.script(), [&](const YAML::Node& node) {
      if (!node.IsMap() || !node["when"]) return;
      test::walk(node["when"], [&](const YAML::Node& trigger) {
        if (trigger.IsMap() && trigger["step"]) {
          EXPECT_THAT(steps, Contains(trigger["step"].as<std::string>()));
        }
      });
    });
  });
}

TEST_P(Generators, SpeakOfVehiclesOfTheTeamOnly) {
  for_all([](const DrawnMission& drawn) {
    const Names uavs = drawn.uavs();
    for (const char* part : {"ground", "faults", "team"})
      test::walk(drawn.yaml[part], [&](const YAML::Node& node) {
        if (!node.IsMap()) return;
        for (const char* key : {"uav", "by"})
          if (node[key] && node[key].IsScalar()) {
            EXPECT_THAT(uavs, Contains(node[key].as<std::string>()));
          }
      });
    Names nodes = uavs;
    nodes.insert("ground");
    for (const auto& cut : drawn.yaml["radio"]["cuts"]) {
      const auto between = cut["between"].as<std::vector<std::string>>();
      ASSERT_EQ(between.size(), 2U);
      EXPECT_NE(between[0], between[1]);
      EXPECT_THAT(between, IsSubsetOf(nodes));
    }
    for (const auto& relay : drawn.yaml["radio"]["relays"])
      EXPECT_THAT(nodes, Contains(relay.as<std::string>()));
  });
}

TEST_P(Generators, SendTasksToPlacesAndZonesOfTheWorldOnly) {
  static const std::regex kNamed("[PAZJ][0-9]+");
  for_all([](const DrawnMission& drawn) {
    Names known = drawn.places();
    const Names zones = drawn.zones();
    known.insert(zones.begin(), zones.end());
    for (const YAML::Node& task : drawn.tasks())
      test::walk(task["task"], [&](const YAML::Node& word) {
        if (!word.IsScalar() || !std::regex_match(word.as<std::string>(), kNamed)) return;
        EXPECT_THAT(known, Contains(word.as<std::string>())) << YAML::Dump(task);
      });
  });
}

TEST_P(Generators, WaitForGoalsAndMissionsThatAreGiven) {
  for_all([](const DrawnMission& drawn) {
    std::set<std::pair<std::string, int>> goals, missions;
    for (const YAML::Node& mission : drawn.missions()) {
      const auto uav = mission["uav"].as<std::string>();
      missions.emplace(uav, mission["id"].as<int>());
      for (const auto& task : mission["tasks"]) goals.emplace(uav, task["id"].as<int>());
    }
    test::walk(drawn.script(), [&](const YAML::Node& node) {
      if (!node.IsMap()) return;
      for (const auto& [key, given] : {std::pair("goal", &goals), std::pair("mission", &missions)})
        if (node[key] && node[key].IsMap() && node[key]["state"]) {
          EXPECT_THAT(*given, Contains(std::make_pair(node[key]["uav"].as<std::string>(),
                                                      node[key]["id"].as<int>())));
        }
    });
  });
}

TEST_P(Generators, BoundTimesThatCanBeMet) {
  for_all([](const DrawnMission& drawn) {
    for (const YAML::Node& task : drawn.tasks()) {
      const auto at = [&](const char* key, double otherwise) {
        return task[key] ? task[key].as<double>() : otherwise;
      };
      EXPECT_LT(at("start_after", 0), at("start_before", 1e9)) << YAML::Dump(task);
      EXPECT_LT(at("start_after", 0), at("end_before", 1e9)) << YAML::Dump(task);
    }
    for (const char* part : {"radio", "world"})
      test::walk(drawn.yaml[part], [&](const YAML::Node& node) {
        if (!node.IsMap() || !node["from"] || !node["until"]) return;
        EXPECT_LT(node["from"].as<double>(), node["until"].as<double>()) << YAML::Dump(node);
      });
  });
}

double doubled_area(const YAML::Node& corners) {
  double area = 0;
  for (std::size_t at = 0; at < corners.size(); ++at) {
    const YAML::Node one = corners[at], next = corners[(at + 1) % corners.size()];
    area += one[0].as<double>() * next[1].as<double>() - next[0].as<double>() * one[1].as<double>();
  }
  return area;
}

TEST_P(Generators, DrawZonesAndClosedAirAsPolygonsThatTurnLeft) {
  for_all([](const DrawnMission& drawn) {
    for (const auto& zone : drawn.yaml["world"]["zones"]) {
      ASSERT_GE(zone.second.size(), 3U);
      EXPECT_GT(doubled_area(zone.second), 2 * 100.0) << YAML::Dump(zone.second);
    }
    test::walk(drawn.yaml, [](const YAML::Node& node) {
      if (node.IsMap() && node["polygon"]) {
        EXPECT_GT(doubled_area(node["polygon"]), 2 * 100.0);
      }
    });
  });
}

TEST_P(Generators, PutEverythingOnTheTerrain) {
  for_all([](const DrawnMission& drawn) {
    const YAML::Node terrain = drawn.yaml["world"]["terrain"];
    const auto inside = [&](const YAML::Node& position) {
      const double x = position[0].as<double>(), y = position[1].as<double>();
      return x >= terrain["west"].as<double>() && x <= terrain["east"].as<double>() &&
             y >= terrain["south"].as<double>() && y <= terrain["north"].as<double>();
    };
    for (const auto& place : drawn.yaml["world"]["places"])
      EXPECT_TRUE(inside(place.second)) << YAML::Dump(place.second);
    for (const auto& uav : drawn.yaml["uavs"])
      EXPECT_TRUE(inside(uav.second["start"])) << YAML::Dump(uav.second);
    for (const auto& zone : drawn.yaml["world"]["zones"])
      for (const auto& corner : zone.second) EXPECT_TRUE(inside(corner)) << YAML::Dump(corner);
  });
}

TEST_P(Generators, LeaveOutWhatIsNotAskedFor) {
  Kinds nothing = kClean;
  nothing.merged = nothing.questions = nothing.joint = false;
  const bool is_about_joint_tasks = GetParam().name == "Sharing" || GetParam().name == "Escorts";
  const bool is_about_closed_air = std::string(GetParam().name) == "Closures";
  for_all(
      [&](const DrawnMission& drawn) {
        EXPECT_FALSE(drawn.yaml["faults"]) << YAML::Dump(drawn.yaml["faults"]);
        // Who hears whom past relays alone is cut for good, before anybody flies.
        for (const auto& cut : drawn.yaml["radio"]["cuts"])
          EXPECT_EQ(cut["from"].as<double>(), 0) << YAML::Dump(cut);
        EXPECT_TRUE(is_about_closed_air || !drawn.yaml["world"]["volumes"]);
        EXPECT_EQ(drawn.mission.joint, is_about_joint_tasks) << "other kinds have them if asked";
        const std::string text = to_yaml(drawn.mission, "..");
        for (const char* word : {"kill", "evaluate: true", "close_air", "energy: 0", "degree: {"})
          EXPECT_THAT(text, Not(HasSubstr(word)));
      },
      nothing);
}

TEST_P(Generators, DrawDeathsOfTheirOwnDaemonsOnly) {
  Kinds deaths;
  deaths.deaths = true;
  int killed = 0;
  for_all(
      [&, this](const DrawnMission& drawn) {
        Names daemons = drawn.uavs();
        daemons.insert({"ground", "sim"});
        const int before = killed;
        for (const auto& fault : drawn.yaml["faults"]) {
          if (!fault["kill"]) continue;
          ++killed;
          EXPECT_THAT(daemons, Contains(fault["kill"].as<std::string>()));
          EXPECT_GE(fault["at"].as<double>(), 3.0);
          // Partners may stay away for longer than anybody waits, or for good.
          const bool partners =
              std::set<std::string>{"Partners", "Sharing", "Escorts"}.contains(GetParam().name);
          const auto away = fault["restart_after"];
          EXPECT_TRUE(away || partners);
          if (away) {
            EXPECT_GE(away.as<double>(), 0.0);
            EXPECT_LE(away.as<double>(), partners ? 500.0 : 15.0);
          }
          if (fault["forgets"]) {
            EXPECT_EQ(fault["kill"].as<std::string>(), "sim");
          }
        }
        EXPECT_LE(killed, before + 3);
      },
      deaths);
  EXPECT_GE(killed, static_cast<int>(kSeeds) / 2);
}

INSTANTIATE_TEST_SUITE_P(Each, Generators, ::testing::ValuesIn(test::generators()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace skein::mission_lab
