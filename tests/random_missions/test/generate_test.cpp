// SPDX-License-Identifier: Apache-2.0
// Missions drawn are scenarios, the same for one seed, and have in them what there is to be met.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/assembly/assembly.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kFile = SKEIN_SOURCE_DIR "/scenarios/comets/drawn.yaml";

std::string text_of(std::uint64_t seed, const Kinds& kinds = {}) {
  return to_yaml(generate(seed, kinds), "..");
}

std::string problems_of(const std::string& yaml) {
  const auto scenario = scenario::read_scenario_text(yaml, kFile);
  return scenario ? to_text(assembly::check_assembly(*scenario)) : to_text(scenario.error());
}

/// Of the missions with seeds 1 to 60: each is a scenario, and one seed gives one text.
std::string texts_of(Mission (*draw)(std::uint64_t, const Kinds&), const Kinds& kinds) {
  std::string all;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::string text = to_yaml(draw(seed, kinds), "..");
    EXPECT_EQ(to_yaml(draw(seed, kinds), ".."), text);
    EXPECT_THAT(problems_of(text), IsEmpty()) << "seed " << seed;
    all += text;
  }
  return all;
}

TEST(Generate, OneSeedGivesOneMissionAndAnotherAnother) {
  EXPECT_EQ(text_of(5), text_of(5));
  EXPECT_NE(text_of(5), text_of(6));
}

class DeathsOfDaemons : public ::testing::TestWithParam<Mission (*)(std::uint64_t, const Kinds&)> {
};

TEST_P(DeathsOfDaemons, AreAddedToTheSameMission) {
  Kinds deaths;
  deaths.deaths = true;
  std::string daemons;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Mission without = GetParam()(seed, {});
    Mission with = GetParam()(seed, deaths);
    ASSERT_GT(with.faults.size(), without.faults.size());
    for (std::size_t i = without.faults.size(); i < with.faults.size(); ++i)
      daemons += with.faults[i] + "\n";
    with.faults.resize(without.faults.size());
    EXPECT_EQ(to_yaml(with, ".."), to_yaml(without, ".."));
  }
  for (const char* daemon : {"kill: sim", "kill: ground"})
    EXPECT_NE(daemons.find(daemon), std::string::npos) << daemon;
  EXPECT_THAT(daemons,
              AnyOf(HasSubstr("kill: karma"), HasSubstr("kill: uav"), HasSubstr("kill: ressac")));
}
INSTANTIATE_TEST_SUITE_P(Missions, DeathsOfDaemons,
                         ::testing::Values(generate, generate_crossing, generate_sweeps,
                                           generate_meetings, generate_robots, generate_relays,
                                           generate_fires, generate_orders, generate_mixed,
                                           generate_anything));

TEST(Generate, CrossingMissionsAreScenariosInWhichSomeUavsShareAPad) {
  int shared = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Mission mission = generate_crossing(seed, {});
    EXPECT_THAT(problems_of(to_yaml(mission, "..")), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(to_yaml(generate_crossing(seed, {}), ".."), to_yaml(mission, ".."));
    EXPECT_THAT(to_yaml(mission, ".."), HasSubstr("separation: {merge: true}"));
    ASSERT_GE(mission.team.size(), 2U);
    ASSERT_LE(mission.team.size(), 8U);
    shared += mission.shared_pads;
  }
  EXPECT_GT(shared, 10);
}

TEST(Generate, PartnersThatStayAwayAreScenariosInWhichOneDiesIsCutOffOrIsDeclaredLost) {
  Kinds kinds;
  kinds.deaths = true;
  const std::string all = texts_of(generate_partners, kinds);
  for (const char* part :
       {"monitoring-with-relay, J1", "synchro, 500", "restart_after", "kill: uav",
        "declare_lost: {uav: uav", "between: [uav", "partner_lease: 600"})
    EXPECT_THAT(all, HasSubstr(part));
}

TEST(Generate, SharedMappingsAreScenariosInWhichWhoTakesPartIsCutOffDiesOrIsTakenInHand) {
  Kinds kinds;
  kinds.deaths = true;
  const std::string all = texts_of(generate_sharing, kinds);
  for (const char* part : {"cooperative-mapping, OstWiese, C1", "cooperative-mapping, Z1b, C2",
                           "restart_after", "kill: uav", "take_in_hand: {uav: uav", "between: [uav",
                           "capacity: 9600", "separation: {merge: true}"})
    EXPECT_THAT(all, HasSubstr(part));
}

TEST(Generate, EscortsAreScenariosOfEachModelInWhichTheGroundMayPlayForOne) {
  Kinds kinds;
  kinds.deaths = true;
  const std::string all = texts_of(generate_escorts, kinds);
  for (const char* part :
       {"monitoring-around.yaml", "monitoring-by-chain.yaml", "monitoring-with-ground.yaml",
        "monitoring-with-relay.yaml", "escorting.yaml", "vehicle-pursuit.yaml", "degree: 2",
        "play: {uav: uav2", "know_place: {name: T", "take_in_hand: {uav: uav", "kill: uav",
        "separation: {merge: true}", "hills: "})
    EXPECT_THAT(all, HasSubstr(part));
}

TEST(Generate, ClosuresAreScenariosInWhichAirClosesAndOpensOverWhatIsAskedFor) {
  const std::string all = texts_of(generate_closures, {});
  for (const char* part : {"perform-tour, [P1, P2, P3", "perform-mapping, Z1", "from: 0, until: ",
                           "close_air: {name: smoke-1", "open_air: {name: smoke-1"})
    EXPECT_THAT(all, HasSubstr(part));
}

TEST(Generate, SweepsOfCrossingMissionsChangeNothingElse) {
  Kinds kinds;
  kinds.sweeps = true;
  std::string all;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Mission swept = generate_crossing(seed, kinds);
    EXPECT_THAT(problems_of(to_yaml(swept, "..")), IsEmpty()) << "seed " << seed;
    all += to_yaml(swept, "..");
    const Mission plain = generate_crossing(seed, {});
    ASSERT_EQ(swept.team.size(), plain.team.size());
    for (std::size_t i = 0; i < plain.team.size(); ++i)
      EXPECT_EQ(swept.team[i].more, plain.team[i].more);
  }
  EXPECT_THAT(all, HasSubstr("[perform-mapping, Z"));
  EXPECT_THAT(all, HasSubstr("[perform-detection, Z"));
}

TEST(Generate, SweepingMissionsAreScenariosWithSeveralSweepsAtATime) {
  std::string all;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Mission mission = generate_sweeps(seed, {});
    EXPECT_THAT(problems_of(to_yaml(mission, "..")), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(to_yaml(generate_sweeps(seed, {}), ".."), to_yaml(mission, ".."));
    EXPECT_GE(mission.zones.size(), 2U);
    all += to_yaml(mission, "..");
  }
  EXPECT_THAT(all, HasSubstr("[perform-mapping, Z"));
  EXPECT_THAT(all, HasSubstr("[perform-detection, Z"));
  EXPECT_THAT(all, HasSubstr("[general-gotoxyz, A"));
}

TEST(Generate, MixedMissionsAreScenariosThatHaveAllOfIt) {
  const std::string all = texts_of(generate_mixed, {});
  for (const char* part :
       {"degree: 5", "degree: 4", "global_mission: {id: 1, state: done}", "[synchro, ",
        "[monitoring-with-relay, ", "action/models/mana", "comets/models/karma", "kind: fire",
        "separation: {merge: true}", "relays: [", "take_in_hand", "give_back", "cancel: ",
        "close_air: ", "contact_loss", "interrupt: true", "consistency: cip", "abort: "})
    EXPECT_THAT(all, HasSubstr(part));
}

TEST(Generate, InCleanMixedMissionsNothingGoesWrong) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::string text = to_yaml(generate_mixed(seed, kClean), "..");
    EXPECT_THAT(problems_of(text), IsEmpty()) << "seed " << seed;
    for (const char* part :
         {"faults:", "cuts:", "close_air", "take_in_hand", "end_before", "hills"})
      EXPECT_THAT(text, Not(HasSubstr(part))) << "seed " << seed;
  }
}

/// What the format of scenarios offers to whoever writes one.
constexpr const char* kAnything[]{"models/marvin.",
                                  "models/heliv.",
                                  "comets/models/karma.",
                                  "iros2005/models/karma.",
                                  "models/plane.",
                                  "models/ressac.",
                                  "models/heron.",
                                  "models/crow.",
                                  "models/mana.",
                                  "models/effibot.",
                                  "degree: 2}",
                                  "degree: 3}",
                                  "degree: 4}",
                                  "degree: 5}",
                                  "energy: 0.1",
                                  "hills: ",
                                  "policy: hold",
                                  "policy: return",
                                  "policy: continue",
                                  "separation: {merge: true}",
                                  "consistency: dip-l",
                                  "consistency: dip-g",
                                  "consistency: cip",
                                  "partner_lease: ",
                                  "members: [",
                                  "equity: ",
                                  "ahead: 3",
                                  "not_by: [",
                                  "by: ",
                                  "after: [",
                                  "repeatable: true",
                                  "capacity: 9600",
                                  "capacity: 19200",
                                  "silent: true",
                                  "heartbeat: 2",
                                  "links:",
                                  "cuts:",
                                  "relays: [",
                                  "volumes:",
                                  "until: ",
                                  "floor: ",
                                  "ceiling: ",
                                  "close_air: ",
                                  "open_air: ",
                                  "take_in_hand: ",
                                  "give_back: ",
                                  "type: goto, mode: VUT",
                                  "resume_plan: ",
                                  "held: ",
                                  "repeats: true",
                                  "cancel: ",
                                  "interrupt: true",
                                  "plan: {",
                                  "type: takeoff",
                                  "type: land",
                                  "type: perceive",
                                  "[synchro, ",
                                  "[monitoring-with-relay, ",
                                  "[general-combined-goto-and-synchro-and-takeshot, ",
                                  "[perform-detection, ",
                                  "[perform-mapping, ",
                                  "[perform-tour, ",
                                  "[perform-monitoring, ",
                                  "[perceive, alarm:1, ",
                                  "[takeshot-while-waiting, ",
                                  "[general-land]",
                                  "achieve: any",
                                  "placement: tour",
                                  "engine: ",
                                  "sensor: ",
                                  "slow: ",
                                  "abort: ",
                                  ", energy: {",
                                  "kill: sim",
                                  "kill: ground",
                                  "forgets: true",
                                  "start_after: ",
                                  "end_before: "};

TEST(Generate, AnythingIsAScenarioAndHasAllThatTheFormatOffers) {
  Kinds kinds;
  kinds.deaths = true;
  std::string all;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Kinds& asked = seed % 2 == 0 ? kinds : Kinds{};
    const std::string text = to_yaml(generate_anything(seed, asked), "..");
    EXPECT_THAT(problems_of(text), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(to_yaml(generate_anything(seed, asked), ".."), text);
    EXPECT_THAT(problems_of(to_yaml(generate_anything(seed, kClean), "..")), IsEmpty());
    all += text;
  }
  for (const char* part : kAnything) EXPECT_THAT(all.find(part), Not(std::string::npos)) << part;
}

TEST(Generate, MeetingsAreScenariosInWhichSomeAreToBeDoneByADate) {
  int bounded = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::string text = to_yaml(generate_meetings(seed, {}), "..");
    EXPECT_THAT(problems_of(text), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(to_yaml(generate_meetings(seed, {}), ".."), text);
    EXPECT_THAT(text, HasSubstr("[synchro, 500, "));
    bounded += text.find("end_before") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(bounded, 10);
}

TEST(Generate, MeetingsMayHaveAJointTaskOfTwoAmongThem) {
  Kinds kinds;
  kinds.gatherings = true;
  int gatherings = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Mission mission = generate_meetings(seed, kinds);
    const std::string text = to_yaml(mission, "..");
    EXPECT_THAT(problems_of(text), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(to_yaml(generate_meetings(seed, kinds), ".."), text);
    int asked = 0;
    for (const Step& step : mission.steps) {
      for (const Task& task : step.tasks)
        asked += task.words.starts_with("[monitoring-with-relay") ? 1 : 0;
    }
    EXPECT_EQ(asked, mission.joint ? 2 : 0) << "seed " << seed;
    gatherings += mission.joint ? 1 : 0;
  }
  EXPECT_GT(gatherings, 10);
}

TEST(Generate, PeopleChangeTheirMindsBesideEverythingElse) {
  Kinds kinds;
  kinds.minds = true;
  int again = 0, moved = 0, taken = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Mission mission = generate_anything(seed, kinds), before = generate_anything(seed, {});
    const std::string text = to_yaml(mission, "..");
    EXPECT_THAT(problems_of(text), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(to_yaml(generate_anything(seed, kinds), ".."), text);
    for (std::size_t i = 0; i < before.steps.size(); ++i)
      EXPECT_EQ(mission.steps.at(i).when, before.steps[i].when) << "seed " << seed;
    again += text.find("again-") != std::string::npos ? 1 : 0;
    moved += text.find("know_place: ") != std::string::npos ? 1 : 0;
    taken += text.find("drop_plan: ") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(again, 10);
  EXPECT_GT(moved, 10);
  EXPECT_GT(taken, 5);
}

TEST(Generate, AnOperatorIsBusyBesideEverythingElse) {
  Kinds kinds;
  kinds.busy = true;
  int by_hand = 0, thinks = 0, opens = 0, people = 0, unheard = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Mission mission = generate_anything(seed, kinds), before = generate_anything(seed, {});
    const std::string text = to_yaml(mission, "..");
    EXPECT_THAT(problems_of(text), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(to_yaml(generate_anything(seed, kinds), ".."), text);
    for (std::size_t i = 0; i < before.steps.size(); ++i)
      EXPECT_EQ(mission.steps.at(i).when, before.steps[i].when) << "seed " << seed;
    const auto has = [&](const char* what) { return text.find(what) != std::string::npos ? 1 : 0; };
    by_hand += has("{id: 500, type: ");
    thinks += has("exit: [[{message: on-");
    opens += has("open_air: {name: tfr-");
    people += has("  operator:\n    - does: busy-");
    unheard += mission.cuts.size() > before.cuts.size() ? 1 : 0;
  }
  EXPECT_GT(by_hand, 15);
  EXPECT_GT(thinks, 5);
  EXPECT_GT(opens, 10);
  EXPECT_GT(people, 20);
  EXPECT_GT(unheard, 5);
}

TEST(Generate, FiresAreFollowedAndSomeAreWatchedJointly) {
  int joint = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Mission mission = generate_fires(seed, {});
    const std::string text = to_yaml(mission, "..");
    EXPECT_THAT(problems_of(text), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(to_yaml(generate_fires(seed, {}), ".."), text);
    EXPECT_THAT(text, HasSubstr("spread: {rate: "));
    EXPECT_EQ(mission.followed.size(), mission.objects.size());
    joint += mission.joint ? 1 : 0;
  }
  EXPECT_GT(joint, 5);
}

TEST(Generate, RobotsAreInEachMissionThatIsToHaveThemAndAreOfBothKinds) {
  int wheeled = 0, tracked = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::string text = to_yaml(generate_robots(seed, {}), "..");
    EXPECT_THAT(problems_of(text), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(to_yaml(generate_robots(seed, {}), ".."), text);
    const bool mana = text.find("models/mana.yaml") != std::string::npos;
    const bool effibot = text.find("models/effibot.yaml") != std::string::npos;
    EXPECT_TRUE(mana || effibot) << "seed " << seed;
    wheeled += mana ? 1 : 0;
    tracked += effibot ? 1 : 0;
  }
  EXPECT_GT(wheeled, 10);
  EXPECT_GT(tracked, 10);
}

TEST(Generate, OperatorsGiveTasksOfAllKindsAndWrongOnesAtAllDegreesButTheLast) {
  std::string all;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::string text = to_yaml(generate_orders(seed, {}), "..");
    EXPECT_EQ(to_yaml(generate_orders(seed, {}), ".."), text);
    all += text;
  }
  for (const char* word :
       {"degree: 1}",        "degree: 2}", "degree: 3}",     "{merge: true}",  "type: takeoff",
        "type: land",        "type: wait", "type: perceive", "type: takeshot", "type: rendezvous",
        "type: synchronise", "mode: VUT",  "mode: SEQ",      "mode: NUT",      "pre: [[",
        "exit: [[",          "5000]",      "-30]",           "[99000,",        "take_in_hand",
        "give_back",         "abort: {",   "update: {",      "message: {",     "close_air"})
    EXPECT_THAT(all, HasSubstr(word));
}

TEST(Generate, InMissionsWithRelaysTheLastUavNeverHearsTheGroundStation) {
  int chains = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Mission mission = generate_relays(seed, {});
    const std::string text = to_yaml(mission, "..");
    EXPECT_THAT(problems_of(text), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(to_yaml(generate_relays(seed, {}), ".."), text);
    EXPECT_THAT(text, HasSubstr("  relays: [uav1"));
    EXPECT_THAT(text, HasSubstr("{between: [ground, " + mission.team.back().name +
                                "], from: 0, until: 4000}"));
    chains += mission.relays.size() >= 3 ? 1 : 0;
  }
  EXPECT_GT(chains, 10);
}

TEST(Generate, SomeMissionsAskTwoUavsForOneJointTask) {
  int joint = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const Mission mission = generate(seed, {});
    int asked = 0;
    for (const Step& step : mission.steps) {
      for (const Task& task : step.tasks) {
        asked += task.words.starts_with("[monitoring-with-relay") ? 1 : 0;
      }
    }
    EXPECT_EQ(asked, mission.joint ? 2 : 0) << "seed " << seed;
    joint += mission.joint ? 1 : 0;
  }
  EXPECT_GT(joint, 3);
}

TEST(Generate, SomeMissionsWantALookOverBeforeAMappingCouldBe) {
  int amid = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    for (const Step& step : generate(seed, {}).steps) {
      if (step.name != "amid") continue;
      ++amid;
      ASSERT_EQ(step.tasks.size(), 2U);
      EXPECT_THAT(step.tasks[0].words, HasSubstr("perform-mapping"));
      EXPECT_THAT(step.tasks[1].times, HasSubstr("end_before"));
    }
  }
  EXPECT_GT(amid, 5);
}

TEST(Generate, EveryMissionIsAScenario) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    EXPECT_EQ(problems_of(text_of(seed)), "") << "seed " << seed;
    EXPECT_EQ(problems_of(text_of(seed, kClean)), "") << "clean, seed " << seed;
  }
}

TEST(Generate, InCleanMissionsNothingGoesWrong) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const Mission mission = generate(seed, kClean);
    EXPECT_THAT(mission.faults, IsEmpty());
    EXPECT_THAT(mission.cuts, IsEmpty());
    EXPECT_THAT(mission.volumes, IsEmpty());
    const std::string text = to_yaml(mission, "..");
    for (const char* trouble : {"cancel: {", "close_air", "degree: {", "interrupt: true", "_before",
                                "_after:", "energy"}) {
      EXPECT_THAT(text, Not(HasSubstr(trouble))) << "seed " << seed;
    }
  }
}

class Drawn : public ::testing::TestWithParam<const char*> {};

TEST_P(Drawn, ComesUpSooner) {
  bool seen = false;
  for (std::uint64_t seed = 1; seed <= 400 && !seen; ++seed)
    seen = text_of(seed).find(GetParam()) != std::string::npos;

  EXPECT_TRUE(seen);
}

INSTANTIATE_TEST_SUITE_P(
    Tasks, Drawn,
    ::testing::Values("[general-takeoff]", "[general-land]", "[general-gotoxyz,", "[perceive,",
                      "[general-combined-goto-and-takeshot,", "[perform-detection,",
                      "[perform-mapping,", "[perform-tour,", "[perform-monitoring,",
                      "[takeshot-while-waiting,", "[general-wait,", "[wait-for-orders]",
                      "[synchro,", "[wait-until-synchro,", "[monitor-until,", "[send-signal,",
                      "[general-combined-goto-and-synchro-and-takeshot,"));
INSTANTIATE_TEST_SUITE_P(Happenings, Drawn,
                         ::testing::Values("placement: first", "interrupt: true", "placement: tour",
                                           "placement: in-time", "cancel: {", "close_air: {",
                                           "open_air: {", "volumes:", "start_after:",
                                           "start_before:", "end_after:", "end_before:", "slow: {",
                                           "abort: {", "sensor: {", "energy: {", "degree: {uav",
                                           "cuts:", "hills:", "start_after_goal:",
                                           "end_after_goal:", "objects:", "perceive, alarm:1",
                                           "evaluate: true", ", for: "));

TEST(Smaller, EachIsThereWithOnePartLess) {
  const Mission whole = generate(3, {});
  const std::vector<Mission> all = smaller(whole);

  EXPECT_GE(all.size(), whole.steps.size() + whole.faults.size());
  for (const Mission& less : all)
    EXPECT_LT(to_yaml(less, "..").size(), to_yaml(whole, "..").size());
}

}  // namespace
}  // namespace skein::mission_lab
