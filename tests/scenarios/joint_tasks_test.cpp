// SPDX-License-Identifier: Apache-2.0
// The reference example of joint tasks (spec 7.7, 8.6) and what may befall it, teams at degree 5
// (spec 6.3, 8.9), and UAVs whose ways cross (spec 6.4), over many seeds: each draws other winds,
// speeds, delays, losses and sensor noise.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/laws/protocol.hpp"
#include "test_cases.hpp"
#include "testing/deliberation_laws.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

class Teamwork : public ::testing::TestWithParam<std::string> {};

TEST_P(Teamwork, MeetsEveryExpectationAndKeepsTheLawsWhateverTheSeed) {
  const auto seeds = cases<std::uint64_t>(2, 500);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Mission mission = play(scenario_at(GetParam(), with(seed)));

    EXPECT_EQ(mission.end, End::kFinished) << "seed " << seed;
    EXPECT_EQ(mission.failures(), "") << "seed " << seed;
    EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "") << "seed " << seed;
    EXPECT_EQ(mission.untrue, "") << "seed " << seed;
  }
}

TEST_P(Teamwork, IsTheSameByteForByteForOneSeed) {
  const std::string once = play(scenario_at(GetParam(), with(1))).log();
  const std::string again = play(scenario_at(GetParam(), with(1))).log();

  EXPECT_TRUE(once == again);
}

std::string name_of(const ::testing::TestParamInfo<std::string>& one) {
  std::string name = one.param;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    JointTasks, Teamwork,
    ::testing::Values("mref/nominal", "mref/small-move", "mref/larger-move", "mref/very-large-move",
                      "mref/relay-lost", "mref/radio-cut", "mref/interrupted",
                      "mref/spreading-fire", "mref/front-unseen", "mref/taken-in-hand",
                      "mref/ground-plays", "mref/ground-plays-taken", "mref/ground-plays-up",
                      "mref/ground-plays-cut", "mref/seen-past-relay", "mref/planned-places"),
    name_of);
INSTANTIATE_TEST_SUITE_P(AgreedPlaces, Teamwork,
                         ::testing::Values("agreed-places/around", "agreed-places/around-cut",
                                           "agreed-places/around-lost-cut", "agreed-places/chain",
                                           "agreed-places/escort",
                                           "agreed-places/escort-ground-plays",
                                           "agreed-places/pursuit"),
                         name_of);
INSTANTIATE_TEST_SUITE_P(AreaSharing, Teamwork,
                         ::testing::Values("area-sharing/negotiated", "area-sharing/one-leaves",
                                           "area-sharing/air-closes", "area-sharing/one-lost",
                                           "area-sharing/one-back", "area-sharing/a-second-in-hand",
                                           "area-sharing/central", "area-sharing/proportional",
                                           "area-sharing/alone", "area-sharing/two-in-a-row"),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Degree5, Teamwork,
                         ::testing::Values("team/two", "team/five", "team/comets", "team/mixed",
                                           "team/out-of-reach", "team/found-again", "team/wall",
                                           "team/delays", "team/abilities", "team/too-late"),
                         name_of);

// Nobody has the energy for its mission, so nobody goes.
TEST(MissionsOfTheReferenceExample, ThatAreRefusedAtOnceAreNotWaitedFor) {
  for (const char* name : {"mref/nominal", "mref/very-large-move", "mref/relay-lost"}) {
    scenario::Scenario scenario = scenario_at(name, with(1));
    for (scenario::UavSpec& uav : scenario.uavs) uav.model.energy.capacity = 100;

    const Mission mission = play(scenario);

    EXPECT_EQ(mission.count({{"kind", "answer"}, {"planned", "false"}}), 2U) << name;
    EXPECT_EQ(mission.end, End::kFinished) << name;
    EXPECT_LT(mission.records.back().at(), MissionTime::seconds(60)) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(WaysThatCross, Teamwork, ::testing::Values("team/crossing"), name_of);

// Found by a storm (agreed-places/pursuit, seed 70003): its loop began the look anew in the same
// instant, for ever, and mission time stood still.
// Of three who are to map a field the node of one dies before anything is agreed: for two there is
// a variant too.
TEST(AMemberThatNeverComes, IsDoneWithoutByThoseWhoAreThere) {
  scenario::Scenario scenario = scenario_at("area-sharing/one-lost");
  ASSERT_EQ(scenario.faults.kills.size(), 1U);
  scenario.faults.kills.front().at = MissionTime::seconds(8);

  const Mission mission = play(scenario);

  EXPECT_EQ(mission.find({{"kind", "goal"}, {"goal", "12"}, {"state", "achieved"}}).size(), 1U);
  EXPECT_EQ(mission.find({{"kind", "goal"}, {"goal", "32"}, {"state", "achieved"}}).size(), 1U);
  const auto agreed =
      mission.find({{"kind", "negotiation"}, {"modality", "role-allocation"}, {"state", "agreed"}});
  ASSERT_FALSE(agreed.empty());
  EXPECT_LE(agreed.front().at(), MissionTime::seconds(120)) << "it was out of reach for a minute";
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "") << "as that all of the field was in view";
}

// Found by a scenario written from the manual: it offered nothing for ten minutes, three times, in
// the air, though a camera that is not on board does not come.
TEST(AVehicleThatFitsNoRole, SaysSoAtOnceAndGoesOn) {
  scenario::Scenario scenario = scenario_at("area-sharing/one-lost");
  scenario.faults.kills.clear();
  scenario.duration_limit = MissionTime::seconds(200);
  for (scenario::UavSpec& uav : scenario.uavs) {
    if (uav.name == "wren") uav.model.sensors.clear();
  }

  const Mission mission = play(scenario);

  const auto failed = mission.find({{"kind", "goal"}, {"goal", "22"}, {"state", "failed"}});
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_LE(failed.front().at(), MissionTime::seconds(90));
  EXPECT_NE(failed.front().text("why").find("it can play no role: "), std::string::npos);
  EXPECT_EQ(mission.count({{"kind", "goal"}, {"goal", "23"}, {"state", "achieved"}}), 1U);
}

// Found by storms of the shipped scenarios: who perceived stayed where it was until its energy was
// short, and its partner with it, since its role waited for a message that need not come.
TEST(ATaskOfARoleThatTheVehicleGivesUp, IsBegunAgain) {
  scenario::Scenario scenario = scenario_at("mref/nominal");
  scenario.faults.aborts.push_back({MissionTime::seconds(300), "uav2", "perceive"});

  const Mission mission = play(scenario);

  EXPECT_EQ(mission.count(
                {{"kind", "task"}, {"uav", "uav2"}, {"type", "perceive"}, {"state", "aborted"}}),
            1U);
  EXPECT_EQ(mission.count({{"kind", "goal"}, {"goal", "12"}, {"state", "achieved"}}), 1U);
  EXPECT_EQ(mission.count({{"kind", "goal"}, {"goal", "22"}, {"state", "achieved"}}), 1U);
  EXPECT_EQ(mission.untrue, "");
}

// Found by random missions (--merged 960024): the role's flight was aborted, and it did nothing
// more.
TEST(AFlightOfARoleWhoseWayCloses, IsBegunAgainAroundTheClosedAir) {
  scenario::Scenario scenario = scenario_at("mref/nominal");
  const world::Volume smoke{"smoke", {{30, 20}, {60, 20}, {60, 80}, {30, 80}}, -10, 120, {}};
  ground_station::Step closes;
  closes.name = "close";
  closes.when.what = ground_station::AtTime{MissionTime::seconds(51)};
  closes.actions = {ground_station::CloseAir{smoke}};
  scenario.ground.script.steps.push_back(closes);

  const Mission mission = play(scenario);

  EXPECT_FALSE(mission
                   .find({{"kind", "notice"},
                          {"uav", "uav2"},
                          {"text",
                           "goto 500047500 of a role is given up: volume 'smoke' closes "
                           "on its way"}})
                   .empty());
  EXPECT_EQ(mission.count({{"kind", "goal"}, {"goal", "12"}, {"state", "achieved"}}), 1U);
  EXPECT_EQ(mission.count({{"kind", "goal"}, {"goal", "22"}, {"state", "achieved"}}), 1U);
  EXPECT_EQ(mission.untrue, "");
}

// Found by the same: of three who form a chain one dies, and hangs where another has to pass, which
// leaves; the last one waited for both until the mission's limit.
TEST(AMeetingOfRoles, DoesNotWaitForWhoHasLeft) {
  scenario::Scenario scenario = scenario_at("agreed-places/chain", with(1));
  scenario.separation->merge = true;

  const Mission mission = play(scenario);

  const auto left = mission.find({{"kind", "joint"}, {"uav", "uav1"}, {"phase", "aborted"}});
  const auto met =
      mission.find({{"kind", "task"}, {"uav", "uav2"}, {"type", "rendezvous"}, {"state", "ended"}});
  ASSERT_FALSE(left.empty());
  ASSERT_FALSE(met.empty());
  EXPECT_GT(met.back().at(), left.front().at());
  EXPECT_LT(met.back().at(), left.front().at() + Duration::seconds(30));
  EXPECT_EQ(mission.end, End::kFinished);
  EXPECT_EQ(mission.untrue, "");
}

// Found by the same: it knew nothing of the mapping, and its partner waited for it to be done.
TEST(AMemberThatComesBackWithoutItsMemory, SaysThatItPlaysNoRole) {
  scenario::Scenario scenario = scenario_at("area-sharing/one-lost", with(1));
  scenario::KillSpec dies = scenario.faults.kills.front();
  dies.at = MissionTime::seconds(1600);
  dies.node = "swift";
  dies.restart_after = Duration::seconds(5);
  dies.forgets = true;
  scenario.faults.kills.push_back(dies);

  const Mission mission = play(scenario);

  const auto said = mission.find({{"kind", "joint"},
                                  {"uav", "swift"},
                                  {"phase", "aborted"},
                                  {"why", "it knows nothing of this any more"}});
  ASSERT_FALSE(said.empty());
  EXPECT_LT(said.front().at(), MissionTime::seconds(1620));
  EXPECT_EQ(mission.count({{"kind", "goal"}, {"goal", "12"}, {"state", "achieved"}}), 1U);
  EXPECT_EQ(mission.untrue, "");
}

// Found by the same (agreed-places/chain 415): who was to perceive did not get to its place, met
// the others as if it had perceived, and all told the mission achieved.
TEST(ARoleWhoseFirstFlightIsGivenUp, IsNotPlayedToItsEnd) {
  scenario::Scenario scenario = scenario_at("agreed-places/chain", with(1));
  scenario.faults.kills.clear();
  scenario::AbortSpec refused{MissionTime::seconds(17), "uav2", "goto"};
  refused.lasts = Duration::seconds(200);
  scenario.faults.aborts.push_back(refused);

  const Mission mission = play(scenario);

  const auto left = mission.find({{"kind", "joint"}, {"uav", "uav2"}, {"phase", "aborted"}});
  ASSERT_FALSE(left.empty());
  EXPECT_LT(left.front().at(), MissionTime::seconds(100));
  EXPECT_EQ(mission.untrue, "") << "as that it perceived";
}

// Its partner has had both roles by then.
TEST(AMemberThatComesBackWithoutItsMemory, IsLostToOneThatHadAnotherRoleBefore) {
  scenario::Scenario scenario = scenario_at("mref/very-large-move", with(1));
  scenario::KillSpec dies{MissionTime::seconds(1077), "uav2", Duration::seconds(12)};
  dies.forgets = true;
  scenario.faults.kills.push_back(dies);

  const Mission mission = play(scenario);

  EXPECT_EQ(mission.count({{"kind", "joint"}, {"uav", "uav1"}, {"phase", "leaving"}}), 1U);
  EXPECT_EQ(mission.untrue, "");
}

TEST(ARoleWhoseTaskFailsAgainAndAgain, IsLeftWithTheReasonAndAnotherTakesIt) {
  scenario::Scenario scenario = scenario_at("mref/nominal");
  scenario.faults.breaks.push_back({MissionTime::seconds(300), "uav2", "visible"});

  const Mission mission = play(scenario);

  const auto left = mission.find({{"kind", "joint"}, {"uav", "uav2"}, {"phase", "leaving"}});
  ASSERT_FALSE(left.empty());
  EXPECT_LT(left.front().at(), MissionTime::seconds(310));
  EXPECT_EQ(left.front().text("why"), "t13: device 'visible' has failed");
  EXPECT_EQ(mission.count({{"kind", "goal"}, {"goal", "12"}, {"state", "achieved"}}), 1U);
  EXPECT_EQ(mission.untrue, "");
}

TEST(ARoleWhoseDeviceHasFailed, IsLeftWithTheReason) {
  scenario::Scenario scenario = scenario_at("agreed-places/pursuit");
  scenario.faults.breaks.push_back({MissionTime::seconds(79), "uav1", "visible"});

  const Mission mission = play(scenario);

  const auto looks = mission.find({{"kind", "task"},
                                   {"uav", "uav1"},
                                   {"type", "perceive"},
                                   {"state", "aborted"},
                                   {"reason", "device 'visible' has failed"}});
  EXPECT_GE(looks.size(), 2U);
  EXPECT_LE(looks.size(), 8U) << "until its telemetry says so, it offers a role that needs it";
  EXPECT_EQ(mission.end, End::kFinished);
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
}

}  // namespace
}  // namespace skein::testing
