// SPDX-License-Identifier: Apache-2.0
// Area sharing (annex B of the thesis, spec 8.7): three unlike UAVs map one area, divided on the
// ground or by negotiation. That all of it was in view is a law that every run keeps
// (joint_tasks_test.cpp); here is who is done when.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>

#include "test_cases.hpp"
#include "testing/drawn_area.hpp"
#include "testing/mapping_ends.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

constexpr double kTogether = 0.05;

Mission mission(const std::string& name, std::uint64_t seed) {
  return play(scenario_at("area-sharing/" + name, with(seed)));
}

class InCalmAir : public ::testing::TestWithParam<std::string> {};

TEST_P(InCalmAir, AllThreeAreDoneWithinFivePerCentOfEachOther) {
  const auto seeds = cases<std::uint64_t>(2, 50);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const MappingEnds ends = mapping_ends(mission(GetParam(), seed).records);

    ASSERT_EQ(ends.ends.size(), 3U);
    EXPECT_LE(ends.spread(), kTogether) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(AreaSharing, InCalmAir, ::testing::Values("central", "negotiated"));

void expect_mapped_together(const scenario::Scenario& area, std::uint64_t seed) {
  const Mission mapping = play(area);
  const MappingEnds ends = mapping_ends(mapping.records);

  ASSERT_EQ(ends.ends.size(), 3U) << area.name << ", area " << seed;
  EXPECT_EQ(mapping.untrue, "") << area.name << ", area " << seed;
  EXPECT_LE(ends.spread(), kTogether) << area.name << ", area " << seed;
}

TEST(AreaSharing, OverAnyAreaTheyAreDoneWithinFivePerCentOfEachOther) {
  const auto areas = cases<std::uint64_t>(2, 12);
  for (std::uint64_t seed = 301; seed < 301 + areas; ++seed) {
    for (const auto& area : {drawn_area(seed), drawn_central_area(seed)})
      expect_mapped_together(area, seed);
  }
}

// In 21 a gap of 1 % between lanes was not seen in thought; over 48 all that was flown in thought
// had the same gap, and they ended 6 % apart.
TEST(AreaSharing, AnAreaWhoseLanesLeaveGapsIsMappedTogetherAllTheSame) {
  for (const std::uint64_t seed : {21, 48}) expect_mapped_together(drawn_central_area(seed), seed);
}

TEST(AreaSharing, ThreeAreDoneBeforeOneAloneAndBeforeSharesInProportion) {
  const double negotiated = mapping_ends(mission("negotiated", 1).records).makespan();
  const double central = mapping_ends(mission("central", 1).records).makespan();
  const double proportional = mapping_ends(mission("proportional", 1).records).makespan();
  const double alone = mapping_ends(mission("alone", 1).records).makespan();

  EXPECT_LT(negotiated, 0.75 * alone);
  EXPECT_LT(negotiated, proportional);
  EXPECT_LT(central, proportional);
  EXPECT_NEAR(negotiated, central, 0.1 * central);
}

TEST(AreaSharing, WhatOneLeavesTheOthersFinishTogether) {
  const auto seeds = cases<std::uint64_t>(2, 50);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const MappingEnds ends = mapping_ends(mission("one-leaves", seed).records);

    EXPECT_LE(ends.spread({"heron", "wren"}), 2 * kTogether) << "seed " << seed;
  }
}

// Found by storms (one-lost 844): they struck each other, and one of them the third.
TEST(AreaSharing, TwoOfThreeThatDoNotHearEachOtherForAWhileCountOnEachOther) {
  scenario::Scenario area = scenario_at("area-sharing/negotiated", with(1));
  area.radio.cuts.push_back(
      {"wren", "swift", MissionTime::seconds(189), MissionTime::seconds(330)});

  const Mission mapping = play(area);

  EXPECT_EQ(mapping.count({{"kind", "joint"}, {"holders", "heron map, wren map"}}), 0U);
  EXPECT_EQ(mapping.count({{"kind", "joint"}, {"holders", "heron map, swift map"}}), 0U);
  EXPECT_EQ(mapping.count({{"kind", "joint"}, {"phase", "ended"}}), 3U);
  EXPECT_EQ(mapping.untrue, "");
}

// Found by storms (302, 509): the third one took each of them for lost, on the other's word.
TEST(AreaSharing, TwoOfThreeThatLoseEachOtherMapItToTheEndAllTheSame) {
  scenario::Scenario area = scenario_at("area-sharing/negotiated", with(1));
  area.planning->partner_lease = Duration::seconds(60);
  area.radio.cuts.push_back(
      {"heron", "wren", MissionTime::seconds(1098), MissionTime::seconds(1187)});

  const Mission mapping = play(area);

  const auto gone_without =
      mapping.find({{"kind", "joint"}, {"uav", "swift"}, {"holders", "heron map, swift map"}});
  EXPECT_FALSE(gone_without.empty());
  EXPECT_EQ(mapping.count({{"kind", "joint"}, {"phase", "ended"}}), 3U);
  EXPECT_EQ(mapping.untrue, "");
}

// The failure of the look had stayed with the role, which aborted once it was through with all.
TEST(AreaSharing, ALookThatFailsOnceIsBegunAgainAndTheTaskEnds) {
  scenario::Scenario area = scenario_at("area-sharing/negotiated", with(1));
  area.faults.aborts.push_back({MissionTime::seconds(500), "heron", "takeshot"});

  const Mission mapping = play(area);

  EXPECT_EQ(mapping.count({{"kind", "task"},
                           {"uav", "heron"},
                           {"type", "takeshot"},
                           {"reason", "aborted by the functional layer"}}),
            1U);
  EXPECT_EQ(mapping.count({{"kind", "joint"}, {"phase", "ended"}}), 3U);
  EXPECT_EQ(mapping.untrue, "");
}

/// As a zone is written in a scenario.
std::string text_of(const world::Polygon& polygon) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  for (const world::Vector2& corner : polygon)
    text << (text.tellp() > 0 ? ", [" : "[") << corner.x() << ", " << corner.y() << "]";
  return text.str();
}

TEST(AreaSharing, TheZonesOfTheCentralScenariosAreWhatThePartitionRefinerGives) {
  for (const auto& [name, mode] :
       {std::pair("area-sharing/central", refiners::ShareMode::kBalanced),
        std::pair("area-sharing/proportional", refiners::ShareMode::kProportional)}) {
    const scenario::Scenario scenario = scenario_at(name);
    for (const refiners::Part& part : divided(scenario, mode).parts) {
      for (const world::Zone& zone : scenario.world.zones) {
        if (zone.name != "part-" + part.uav) continue;
        EXPECT_EQ(text_of(zone.polygon), text_of(part.polygon)) << name << " " << zone.name;
      }
    }
  }
}

}  // namespace
}  // namespace skein::testing
