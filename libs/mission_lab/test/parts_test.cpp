// SPDX-License-Identifier: Apache-2.0
// Single parts of missions: their figures lie in the ranges that are declared, and both ends of a
// range are neared; their texts are those of scenario files.
#include "parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "skein/mission_lab/troubles.hpp"
#include "testing/drawn_mission.hpp"

namespace skein::mission_lab {
namespace {

using test::Names;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

/// What was seen of each figure, over many draws.
class Seen {
 public:
  void add(const std::string& name, double value) {
    const auto [at, is_new] = ranges_.emplace(name, Range{value, value});
    if (is_new) return;
    at->second.least = std::min(at->second.least, value);
    at->second.most = std::max(at->second.most, value);
  }
  void add_all(const YAML::Node& map) {
    for (const auto& entry : map) {
      if (entry.second.IsMap()) add_all(entry.second);
      double value = 0;
      if (entry.second.IsScalar() && YAML::convert<double>::decode(entry.second, value))
        add(entry.first.as<std::string>(), value);
    }
  }
  /// Inside [least, most], and within a tenth of the width of either end.
  void expect_fills(const std::string& name, double least, double most) const {
    SCOPED_TRACE(name);
    ASSERT_EQ(ranges_.count(name), 1U);
    const Range& seen = ranges_.at(name);
    EXPECT_GE(seen.least, least);
    EXPECT_LE(seen.most, most);
    EXPECT_LE(seen.least, least + 0.1 * (most - least));
    EXPECT_GE(seen.most, most - 0.1 * (most - least));
  }

 private:
  struct Range {
    double least = 0, most = 0;
  };
  std::map<std::string, Range> ranges_;
};

template <class Draw>
std::vector<YAML::Node> drawn(const Draw& draw, int count = 200) {
  Random random(7, "parts");
  std::vector<YAML::Node> nodes;
  for (; count > 0; --count) nodes.push_back(YAML::Load(draw(random)));
  return nodes;
}

TEST(Numbers, AreRoundedToTheNearestAndWrittenWithTheirDigits) {
  EXPECT_EQ(whole(2.5), "3");
  EXPECT_EQ(whole(-2.5), "-3");
  EXPECT_EQ(tenths(0.04), "0.0");
  EXPECT_EQ(tenths(1.25), "1.3");
  EXPECT_EQ(tenths(-12.31), "-12.3");
  EXPECT_EQ(hundredths(0.125), "0.13");
  EXPECT_EQ(hundredths(7), "7.00");
  EXPECT_EQ(point(10.4, -19.6), "[10, -20]");
}

TEST(DrawnPlaces, AreNumberedOnAndLieOnTheGround) {
  Random random(1);
  Mission mission;
  Seen seen;
  for (int number = 1; number <= 200; ++number) {
    EXPECT_EQ(add_place(random, mission), "P" + std::to_string(number));
    const YAML::Node place = YAML::Load(mission.places.back())["P" + std::to_string(number)];
    seen.add("x", place[0].as<double>());
    seen.add("y", place[1].as<double>());
    EXPECT_EQ(place[2].as<double>(), 0);
  }
  seen.expect_fills("x", -50, 450);
  seen.expect_fills("y", -50, 450);
}

TEST(DrawnZones, AreRectanglesThatAreTurnedByHalfARadianAtMost) {
  Seen seen;
  for (const YAML::Node& zone : drawn(draw_zone)) {
    ASSERT_EQ(zone.size(), 4U);
    const auto side = [&](std::size_t from, std::size_t to) {
      return std::pair(zone[to][0].as<double>() - zone[from][0].as<double>(),
                       zone[to][1].as<double>() - zone[from][1].as<double>());
    };
    const auto [ax, ay] = side(0, 1);
    const auto [bx, by] = side(0, 3);
    seen.add("length", std::hypot(ax, ay));
    seen.add("width", std::hypot(bx, by));
    seen.add("turn", std::atan2(ay, ax));
    // Corners are whole metres: sides are square to about one in the shorter.
    EXPECT_NEAR((ax * bx + ay * by) / (std::hypot(ax, ay) * std::hypot(bx, by)), 0, 0.03);
    EXPECT_NEAR(zone[2][0].as<double>(), zone[1][0].as<double>() + bx, 1.01);
    EXPECT_NEAR(zone[2][1].as<double>(), zone[1][1].as<double>() + by, 1.01);
  }
  seen.expect_fills("length", 69, 221);
  seen.expect_fills("width", 59, 181);
  seen.expect_fills("turn", -0.02, 0.52);
}

TEST(DrawnCuts, BeginInTimeAndLastUpToAHundredAndFiftySeconds) {
  Seen seen;
  for (const YAML::Node& cut :
       drawn([](Random& random) { return draw_cut(random, "karma", "ground", 300); })) {
    EXPECT_THAT(cut["between"].as<std::vector<std::string>>(), ElementsAre("karma", "ground"));
    seen.add("from", cut["from"].as<double>());
    seen.add("lasts", cut["until"].as<double>() - cut["from"].as<double>());
  }
  seen.expect_fills("from", 10, 300);
  seen.expect_fills("lasts", 4, 151);
}

TEST(DrawnCuts, OfATeamAreFewerThanTheLimitAndNeverWithOneself) {
  const std::vector<Member> team{{"one", "m", "", 40, 1}, {"two", "m", "", 40, 1000}};
  std::set<std::size_t> counts;
  Names ends;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const std::vector<std::string> cuts = draw_cuts(random, team, 4, 100);
    counts.insert(cuts.size());
    for (const std::string& text : cuts) {
      const auto between = YAML::Load(text)["between"].as<std::vector<std::string>>();
      EXPECT_NE(between[0], between[1]);
      ends.insert(between.begin(), between.end());
    }
  }
  EXPECT_THAT(counts, UnorderedElementsAre(0U, 1U, 2U, 3U));
  EXPECT_THAT(ends, UnorderedElementsAre("one", "two", "ground"));
}

TEST(DrawnFaults, AreOfFourKindsWithFiguresInTheirRanges) {
  Seen seen;
  Names kinds;
  const auto device = [](Random&) { return std::string("visible"); };
  for (const YAML::Node& fault :
       drawn([&](Random& random) { return draw_fault(random, "karma", device, 500); }, 600)) {
    seen.add_all(fault);
    for (const auto& part : fault) {
      const auto kind = part.first.as<std::string>();
      if (kind == "at") continue;
      kinds.insert(kind);
      EXPECT_EQ(part.second["uav"].as<std::string>(), "karma");
      if (kind == "sensor") {
        EXPECT_EQ(part.second["device"].as<std::string>(), "visible");
      }
    }
  }
  EXPECT_THAT(kinds, UnorderedElementsAre("slow", "abort", "sensor", "energy"));
  seen.expect_fills("at", 10, 500);
  seen.expect_fills("factor", 1.2, 4);
  seen.expect_fills("for", 20, 200);
  seen.expect_fills("left", 0.12, 0.6);
}

TEST(DrawnFaults, OfAVehicleOfCometsBreakADeviceThatItHas) {
  const std::map<std::string, Names> devices{
      {"karma", {"mapping"}}, {"heliv", {"visible", "ir"}}, {"marvin", {"visible", "fire-sensor"}}};
  for (const auto& [model, has] : devices) {
    const Member member{"uav", model, "", 40, 100};
    Names broken;
    for (const YAML::Node& fault :
         drawn([&member](Random& random) { return draw_fault(random, member, 100); }))
      if (fault["sensor"]) broken.insert(fault["sensor"]["device"].as<std::string>());
    EXPECT_EQ(broken, has) << model;
  }
}

TEST(DrawnRefusals, LastForAWhileOrForGood) {
  Seen seen;
  int for_good = 0;
  for (const YAML::Node& fault :
       drawn([](Random& random) { return draw_refusals(random, "karma", 400); }, 400)) {
    const double lasts = fault["abort"]["for"].as<double>();
    seen.add("at", fault["at"].as<double>());
    if (lasts < 5000) seen.add("for", lasts);
    for_good += lasts >= 5000 ? 1 : 0;
  }
  seen.expect_fills("at", 5, 400);
  seen.expect_fills("for", 5, 200);
  EXPECT_NEAR(for_good, 0.3 * 400, 40);
}

TEST(DrawnJointTasks, HaveTheInsideOfAFireAndACentreAsFarAsARelayReaches) {
  Random random(3);
  Seen seen;
  for (int count = 0; count < 200; ++count) {
    const JointTask task = draw_joint_task(random, {"one", "two"});
    ASSERT_EQ(task.places.size(), 3U);
    std::vector<std::pair<double, double>> at;
    for (const std::string& text : task.places) {
      const YAML::Node place = YAML::Load(text).begin()->second;
      at.emplace_back(place[0].as<double>(), place[1].as<double>());
    }
    seen.add("inside", std::hypot(at[1].first - at[0].first, at[1].second - at[0].second));
    seen.add("centre", std::hypot(at[2].first - at[0].first, at[2].second - at[0].second));
    const YAML::Node words = YAML::Load(task.words);
    EXPECT_EQ(words[0].as<std::string>(), "monitoring-with-relay");
    seen.add("seconds", words[4].as<double>());
    EXPECT_THAT(words[5].as<std::vector<std::string>>(), ElementsAre("one", "two"));
  }
  // Places are whole metres: half a diagonal more, or less, on either side.
  seen.expect_fills("inside", 18.5, 41.5);
  seen.expect_fills("centre", 58.5, 111.5);
  seen.expect_fills("seconds", 20, 150);
}

TEST(DrawnLooks, AmidAMappingAreWantedAfterTheyAreAskedFor) {
  Random random(4);
  int hurried = 0;
  for (int count = 0; count < 100; ++count) {
    const double at = random.uniform(4, 60);
    const auto tasks = draw_look_amid_mapping(random, at);
    ASSERT_EQ(tasks.size(), 2U);
    EXPECT_THAT(tasks[0].first, HasSubstr("perform-mapping, Z"));
    EXPECT_THAT(tasks[1].first, HasSubstr("perceive, P"));
    const YAML::Node look = YAML::Load("{" + tasks[1].second + "}");
    EXPECT_GE(look["end_before"].as<double>(), std::floor(at + 80 + 60));
    if (look["start_after"]) {
      EXPECT_LE(look["start_after"].as<double>() + 59, look["end_before"].as<double>());
    }
    hurried += tasks[0].second.empty() ? 0 : 1;
  }
  EXPECT_GT(hurried, 25);
  EXPECT_LT(hurried, 75);
}

TEST(Forgetting, IsAddedInsideTheFault) {
  EXPECT_EQ(forgetting("{at: 3.0, kill: sim, restart_after: 1.5}"),
            "{at: 3.0, kill: sim, restart_after: 1.5, forgets: true}");
}

// ---- troubles of a mission that somebody else wrote -----------------------------------------

Stage stage(double until) {
  return {{{"karma", {"mapping"}}, {"marvin", {}}}, {"ground", "sim", "karma"}, until};
}

TEST(DrawnTroubles, AreAtLeastOneAndFourAtMost) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Troubles troubles = draw_troubles(seed, stage(600));
    const std::size_t count =
        troubles.faults.size() + troubles.cuts.size() + (troubles.loss ? 1U : 0U);
    EXPECT_GE(count, 1U) << seed;
    EXPECT_LE(count, 4U) << seed;
  }
}

TEST(DrawnTroubles, HappenToWhatIsOnTheStageWhileItPlays) {
  Seen seen;
  Names killed, broken;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Troubles troubles = draw_troubles(seed, stage(300));
    for (const std::string& text : troubles.faults) {
      const YAML::Node fault = YAML::Load(text);
      seen.add("at", fault["at"].as<double>());
      if (fault["kill"]) killed.insert(fault["kill"].as<std::string>());
      if (fault["sensor"]) broken.insert(fault["sensor"]["uav"].as<std::string>());
    }
    if (troubles.loss) seen.add("loss", *troubles.loss);
  }
  seen.expect_fills("at", 3, 300);
  seen.expect_fills("loss", 0.01, 0.3);
  EXPECT_THAT(killed, UnorderedElementsAre("ground", "sim", "karma"));
  EXPECT_THAT(broken, Each("karma")) << "marvin has no device that could break";
}

TEST(DrawnTroubles, GiveHalfOfTheMissionsWithPlanningSlowComputersAndLeaveTheRestAsItIs) {
  Stage planned = stage(600);
  planned.plans = true;
  Seen seen;
  int slow = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Troubles troubles = draw_troubles(seed, planned),
                   others = draw_troubles(seed, stage(600));
    EXPECT_EQ(troubles.faults, others.faults) << seed;
    EXPECT_EQ(others.planning_takes, std::nullopt);
    if (!troubles.planning_takes) continue;
    ++slow;
    seen.add("takes", *troubles.planning_takes);
  }
  seen.expect_fills("takes", 0.5, 8);
  EXPECT_NEAR(slow, 150, 50);
}

TEST(DrawnTroubles, OfAShortMissionStillHaveTwentySecondsToHappenIn) {
  Seen seen;
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
    for (const std::string& text : draw_troubles(seed, stage(1)).faults)
      seen.add("at", YAML::Load(text)["at"].as<double>());

  seen.expect_fills("at", 3, 20);
}

TEST(DrawnTroubles, AreTheSameForOneSeed) {
  const auto text = [](std::uint64_t seed) {
    const Troubles troubles = draw_troubles(seed, stage(600));
    std::string all = troubles.loss ? std::to_string(*troubles.loss) : "";
    for (const std::string& fault : troubles.faults) all += fault + "\n";
    for (const std::string& cut : troubles.cuts) all += cut + "\n";
    return all;
  };
  EXPECT_EQ(text(5), text(5));
  EXPECT_NE(text(5), text(6));
}

TEST(LongDeaths, AreOfDecisionNodesForMinutesAndLeaveTheRestAsItIs) {
  std::size_t twice = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Mission mission = generate_meetings(seed, kClean);
    const Mission before = mission;
    let_die_for_long(mission);
    const Names uavs = test::DrawnMission(mission).uavs();
    for (const std::string& fault : mission.faults) {
      const YAML::Node drawn = YAML::Load(fault);
      EXPECT_TRUE(uavs.contains(drawn["kill"].as<std::string>()));
      EXPECT_GE(drawn["at"].as<double>(), 5);
      EXPECT_LE(drawn["at"].as<double>(), 700);
      EXPECT_GE(drawn["restart_after"].as<double>(), 60);
      EXPECT_LE(drawn["restart_after"].as<double>(), 600);
    }
    ASSERT_GE(mission.faults.size(), 1U);
    twice += mission.faults.size() - 1;
    mission.faults.clear();
    EXPECT_EQ(to_yaml(mission, ".."), to_yaml(before, ".."));
  }
  EXPECT_GT(twice, 20U);
  EXPECT_LT(twice, 80U);
}

}  // namespace
}  // namespace skein::mission_lab
