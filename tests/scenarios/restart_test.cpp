// SPDX-License-Identifier: Apache-2.0
// Daemons that are killed in mid-mission and come back with what they knew (issue: nothing is
// lost).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <set>

#include "skein/foundation/random.hpp"
#include "skein/laws/protocol.hpp"
#include "skein/laws/waiting.hpp"
#include "test_cases.hpp"
#include "testing/mission.hpp"
#include "testing/reasons.hpp"

namespace skein::testing {
namespace {

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

std::vector<std::string> daemons_of(const scenario::Scenario& scenario) {
  std::vector<std::string> names = scenario.uav_names();
  names.emplace_back("ground");
  names.emplace_back("sim");
  return names;
}

/// Every instant at which anything happened that is not a matter of course.
std::vector<double> instants_of(const Mission& mission) {
  static const std::set<std::string> kOfCourse{"telemetry", "object", "link"};
  std::set<double> instants;
  for (const journal::Record& record : mission.records)
    if (!kOfCourse.contains(record.kind())) instants.insert(record.at().to_seconds());
  return {instants.begin(), instants.end()};
}

bool tells_of_a_restart(const journal::Record& record) {
  if (record.kind() == "fault" || record.kind() == "resumed") return true;
  // What lies between meetings is a state: who is back says it again, and others hear it again.
  return record.kind() == "frontier" && record.text("direction") == "received";
}

/// The log without what tells of the restart itself.
std::string without_restarts(const Mission& mission) {
  std::string log;
  for (const journal::Record& record : mission.records)
    if (!tells_of_a_restart(record)) log += to_json(record) + "\n";
  return log;
}

Mission killed(scenario::Scenario scenario, const std::string& daemon, MissionTime when,
               Duration away) {
  scenario.faults.kills.push_back({when, daemon, away});
  return play(scenario);
}

bool ended(const Mission& mission) {
  return mission.count({{"kind", "mission"}, {"state", "finished"}}) == 1;
}

bool ends_or_says_why_not(const scenario::Scenario& scenario, const Mission& mission) {
  return ended(mission) || is_explained(laws::waiting_lines(
                               laws::waits_of(scenario, mission.records), MissionTime()));
}

/// `n` of them, spread.
std::vector<double> some(const std::vector<double>& all, std::size_t n, std::uint64_t seed) {
  if (all.size() <= n) return all;
  Random random(seed, "instants");
  std::vector<double> picked;
  for (std::size_t i = 0; i < n; ++i)
    picked.push_back(all[(i * all.size() + random.below(all.size())) / n]);
  return picked;
}

/// The first line in which two logs differ, with both.
std::string first_difference(const std::string& one, const std::string& other) {
  std::istringstream a(one), b(other);
  std::string of_a, of_b;
  for (int line = 1;; ++line) {
    const bool more_a = static_cast<bool>(std::getline(a, of_a));
    const bool more_b = static_cast<bool>(std::getline(b, of_b));
    if (!more_a && !more_b) return "none";
    if (more_a != more_b || of_a != of_b)
      return "line " + std::to_string(line) + ":\n  " + of_a + "\n  " + of_b;
  }
}

/// "comets/confirmed" as a word.
std::string word_of(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
  return text;
}

std::string name_of_case(const ::testing::TestParamInfo<std::string>& info) {
  return word_of(info.param);
}

// ---- a restart that takes no time ----

/// Instants in the middle of times in which nothing happens and nothing is under way.
std::vector<double> quiet_instants_of(const Mission& mission) {
  constexpr double kQuiet = 2.2;  // two heartbeats and a message's way
  std::vector<double> quiet;
  double last = 0;
  for (const double instant : instants_of(mission)) {
    // Not at the beat of telemetry, which is each second.
    if (instant - last > 2 * kQuiet) quiet.push_back(std::floor((last + instant) / 2) + 0.55);
    last = instant;
  }
  return quiet;
}

class DeadForNoTime : public ::testing::TestWithParam<std::string> {};

// All of its state is back: byte for byte the same mission, whichever daemon dies.
TEST_P(DeadForNoTime, WhileNothingHappensMakesNoDifferenceAtAll) {
  scenario::Scenario scenario = scenario_at(GetParam());
  scenario.radio.model.loss = 0;  // which samples of streams are lost is drawn anew in each life
  const Mission reference = play(scenario);
  const std::string expected = without_restarts(reference);
  const std::vector<double> instants = quiet_instants_of(reference);
  ASSERT_GT(instants.size(), 5U);
  std::uint64_t seed = 0;
  for (const std::string& daemon : daemons_of(scenario)) {
    for (const double instant : some(instants, cases<std::size_t>(2, 10'000), ++seed)) {
      const Mission mission = killed(scenario, daemon, at(instant), Duration());
      ASSERT_EQ(mission.count({{"kind", "resumed"}, {"node", daemon}}), 1U);
      const std::string log = without_restarts(mission);
      ASSERT_TRUE(log == expected)
          << daemon << " at " << instant << ", " << first_difference(log, expected);
    }
  }
}

// What is under way then comes a heartbeat later, and that is all.
TEST_P(DeadForNoTime, AtAnyEventChangesNothingOfWhatTheMissionComesTo) {
  const scenario::Scenario scenario = scenario_at(GetParam());
  const std::vector<double> instants = instants_of(play(scenario));
  std::uint64_t seed = 50;
  for (const std::string& daemon : daemons_of(scenario)) {
    for (const double instant : some(instants, cases<std::size_t>(2, 10'000), ++seed)) {
      const Mission mission = killed(scenario, daemon, at(instant), Duration());
      const std::string what = daemon + " at " + std::to_string(instant);
      EXPECT_EQ(mission.failures(), "") << what;
      EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "") << what;
      EXPECT_EQ(mission.untrue, "") << what;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Missions, DeadForNoTime,
                         ::testing::Values("comets/confirmed", "comets/mixed", "karma/detection",
                                           "iros2005/fire", "handover/radio",
                                           "heliv-marvin/monitoring"),
                         name_of_case);

// ---- a daemon that is away for a while ----

struct Away {
  const char* mission;
  double seconds;
};

/// The long form kills each daemon at every single event.
class KilledInAPhase : public ::testing::TestWithParam<Away> {};

TEST_P(KilledInAPhase, TheMissionEndsAsSpecifiedOrSaysWhyNot) {
  const Away away = GetParam();
  const scenario::Scenario scenario = scenario_at(away.mission);
  const std::vector<double> instants = instants_of(play(scenario));
  std::uint64_t seed = 100;
  int as_specified = 0, finished = 0, all = 0;
  for (const std::string& daemon : daemons_of(scenario)) {
    for (const double instant : some(instants, cases<std::size_t>(2, 10'000), ++seed)) {
      const Mission mission =
          killed(scenario, daemon, at(instant), Duration::seconds(away.seconds));
      const std::string what = daemon + " at " + std::to_string(instant);
      EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "") << what;
      EXPECT_EQ(mission.untrue, "") << what;
      const bool met = mission.failures().empty();
      EXPECT_TRUE(met || says_why(mission.records)) << what << "\n" << mission.failures();
      EXPECT_TRUE(ends_or_says_why_not(scenario, mission)) << what;
      finished += ended(mission) ? 1 : 0;
      as_specified += met ? 1 : 0;
      ++all;
    }
  }
  const std::string counted = std::to_string(as_specified) + " of " + std::to_string(all);
  std::printf("as specified: %s; finished: %d\n", counted.c_str(), finished);
  RecordProperty("as_specified", counted);
}
INSTANTIATE_TEST_SUITE_P(
    Missions, KilledInAPhase,
    ::testing::Values(Away{"comets/confirmed", 5}, Away{"comets/confirmed", 60},
                      Away{"karma/detection", 5}, Away{"karma/detection", 60},
                      Away{"heliv-marvin/monitoring", 5}, Away{"heliv-marvin/monitoring", 60},
                      Away{"iros2005/fire", 5}, Away{"iros2005/fire", 60},
                      Away{"handover/radio", 5}, Away{"handover/radio", 60}),
    [](const auto& one) {
      return word_of(one.param.mission) + "_" + std::to_string(static_cast<int>(one.param.seconds));
    });

// ---- a UAV that is dead for good ----

class DeadForGood : public ::testing::TestWithParam<std::string> {};

// Nobody asks it for anything, so nothing expires: scripts see that it is silent, bring the others
// home and end.
TEST_P(DeadForGood, IsGivenUpAndTheMissionEnds) {
  const scenario::Scenario scenario = scenario_at(GetParam());
  const std::vector<double> instants = instants_of(play(scenario));
  std::uint64_t seed = 150;
  for (const std::string& uav : scenario.uav_names()) {
    for (const double instant : some(instants, cases<std::size_t>(1, 20), ++seed)) {
      scenario::Scenario killed = scenario;
      killed.faults.kills.push_back({at(instant), uav, std::nullopt});

      const Mission mission = play(killed);

      const std::string what = uav + " at " + std::to_string(instant);
      EXPECT_EQ(mission.count({{"kind", "mission"}, {"state", "finished"}}), 1U) << what;
      EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "") << what;
      EXPECT_EQ(mission.untrue, "") << what;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Missions, DeadForGood,
                         ::testing::Values("comets/confirmed", "comets/mixed", "karma/detection",
                                           "heliv-marvin/monitoring", "iros2005/fire",
                                           "handover/radio", "handover/synchronised",
                                           "handover/held-tasks", "handover/cut",
                                           "handover/cancelled-at-ground"),
                         name_of_case);

// Found by the long form: the vehicle goes on with a wait that its decision node began before it
// died, and nobody begins the look that belongs to it.
TEST(DeadWhileAWaitBegins, TheLookThatWasMissedIsTakenBeforeItsGoalIsAchieved) {
  const Mission reference = play(scenario_at("heliv-marvin/monitoring"));
  for (const char* wait : {"22", "27"}) {
    const auto began = reference.first({{"kind", "functional"}, {"uav", "heliv"}, {"task", wait}});
    for (const char* daemon : {"heliv", "sim"}) {
      const Mission mission = killed(scenario_at("heliv-marvin/monitoring"), daemon,
                                     at(began.value() - 0.1), Duration::seconds(60));

      const std::string what = std::string(daemon) + " at the begin of " + wait;
      EXPECT_EQ(mission.untrue, "") << what;
      EXPECT_EQ(mission.count({{"kind", "goal"}, {"uav", "heliv"}, {"state", "achieved"}}), 4U)
          << what;
      EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "") << what;
    }
  }
}

// Found by the long form: what happened meanwhile is told while the plan goes back on board, and
// for a quarter of a second both have a task.
TEST(DeadDuringAHandOver, TheSimulatorLeavesATaskThatIsBegunOnce) {
  const Mission mission =
      killed(scenario_at("handover/radio"), "sim", at(87.459668), Duration::seconds(60));

  EXPECT_EQ(mission.count(
                {{"kind", "functional"}, {"uav", "marvin"}, {"task", "106"}, {"state", "running"}}),
            1U);
  EXPECT_EQ(mission.untrue, "");
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
}

// ---- a functional layer that comes back with nothing it knew ----

class LayerForgets : public ::testing::TestWithParam<std::string> {};

// Vehicles are where they are. What was under way is begun anew or fails into repair, by what its
// type says; nothing stays "running" that nobody carries out.
TEST_P(LayerForgets, NothingStaysUnderWayThatNobodyCarriesOut) {
  const scenario::Scenario scenario = scenario_at(GetParam());
  const std::vector<double> instants = instants_of(play(scenario));
  std::uint64_t seed = 200;
  for (const double away : {0.0, 5.0}) {
    for (const double instant : some(instants, cases<std::size_t>(4, 60), ++seed)) {
      scenario::Scenario killed = scenario;
      killed.faults.kills.push_back({at(instant), "sim", Duration::seconds(away), true});

      const Mission mission = play(killed);

      const std::string what = std::to_string(instant);
      EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "") << what;
      EXPECT_EQ(mission.untrue, "") << what;
      EXPECT_TRUE(mission.failures().empty() || says_why(mission.records)) << what << "\n"
                                                                           << mission.failures();
      EXPECT_EQ(left_under_way(mission.records), "") << what;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Missions, LayerForgets,
                         ::testing::Values("comets/confirmed", "karma/detection", "iros2005/fire",
                                           "heliv-marvin/monitoring"),
                         name_of_case);

// Found by a storm (comets/confirmed, seed 628): the decision node is dead when the functional
// layer comes back, and sends again what that has not acknowledged, since it knows nothing any
// more.
TEST(ForgetfulLayer, WhileItsDecisionNodeIsDeadWhatWasDoneIsNotAskedForAgain) {
  scenario::Scenario scenario = scenario_at("comets/confirmed");
  scenario.faults.kills.push_back({at(206.7), "sim", Duration::seconds(2.3), true});
  scenario.faults.kills.push_back({at(208.4), "marvin", Duration::seconds(12.7)});

  const Mission mission = play(scenario);

  for (const journal::Record& record : mission.records) {
    EXPECT_EQ(record.text("text").find("which is ended, does not fit"), std::string_view::npos)
        << to_json(record);
  }
  EXPECT_EQ(mission.untrue, "");
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
}

// ---- a UAV that is dead while its degree is asked for ----

/// The step that asks, and whom.
struct Asks {
  const char* step;
  const char* uav;
};

class AskedWhileDead : public ::testing::TestWithParam<Asks> {
 protected:
  /// Killed just before it is asked.
  static Mission dead_when_asked(std::optional<Duration> away) {
    scenario::Scenario scenario = scenario_at("handover/radio");
    const auto asked = play(scenario).first({{"kind", "step"}, {"name", GetParam().step}});
    scenario.faults.kills.push_back({at(asked.value() - 1), GetParam().uav, away});
    return play(scenario);
  }
};

TEST_P(AskedWhileDead, IsAskedAgainAndTheMissionGoesOn) {
  const Mission mission = dead_when_asked(Duration::seconds(75));

  const std::string step = GetParam().step;
  EXPECT_EQ(mission.count({{"kind", "command"}, {"state", "expired"}}), 1U);
  EXPECT_EQ(mission.count({{"kind", "step"}, {"name", step + "-again"}}), 1U);
  EXPECT_EQ(mission.count({{"kind", "mission"}, {"state", "finished"}}), 1U);
  EXPECT_EQ(mission.count({{"kind", "goal"}, {"state", "failed"}}), 0U);
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
}

TEST_P(AskedWhileDead, ForGoodIsGivenUpAndTheMissionEnds) {
  const Mission mission = dead_when_asked(std::nullopt);

  const std::string given_up = std::string(GetParam().uav) + "-given-up";
  EXPECT_EQ(mission.count({{"kind", "step"}, {"name", given_up}}), 1U);
  EXPECT_EQ(mission.count({{"kind", "mission"}, {"state", "finished"}}), 1U);
  EXPECT_TRUE(says_why(mission.records));
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
}
INSTANTIATE_TEST_SUITE_P(Steps, AskedWhileDead,
                         ::testing::Values(Asks{"marvin-to-3", "marvin"},
                                           Asks{"marvin-in-hand", "marvin"},
                                           Asks{"marvin-given-back", "marvin"},
                                           Asks{"marvin-to-4", "marvin"},
                                           Asks{"karma-in-hand", "karma"}),
                         [](const auto& one) { return word_of(one.param.step); });

// ---- a ground station that is away for longer than UAVs go on without it ----

struct AwayTooLong {
  const char* mission;
  double at;
};

class AwayForLong : public ::testing::TestWithParam<AwayTooLong> {};

// They hold, and hand over what they were to do. The script gives it to them again.
TEST_P(AwayForLong, TheGroundStationGivesAgainWhatUavsHandedOver) {
  scenario::Scenario scenario = scenario_at(GetParam().mission);
  scenario.faults.kills.push_back({at(GetParam().at), "ground", Duration::seconds(80)});

  const Mission mission = play(scenario);

  EXPECT_GE(mission.count({{"kind", "contact"}, {"policy", "hold"}}), 2U);
  EXPECT_EQ(mission.count({{"kind", "mission"}, {"state", "finished"}}), 1U);
  for (const std::string& uav : scenario.uav_names())
    EXPECT_EQ(mission.count({{"kind", "task"}, {"type", "land"}, {"uav", uav}, {"state", "ended"}}),
              1U)
        << uav;
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
}
INSTANTIATE_TEST_SUITE_P(
    Missions, AwayForLong,
    ::testing::Values(AwayTooLong{"heliv-marvin/monitoring", 105},
                      AwayTooLong{"heliv-marvin/monitoring", 225},
                      AwayTooLong{"comets/confirmed", 268}, AwayTooLong{"comets/confirmed", 446},
                      AwayTooLong{"iros2005/fire", 446}, AwayTooLong{"iros2005/fire", 900}),
    [](const auto& one) {
      return word_of(one.param.mission) + "_" + std::to_string(static_cast<int>(one.param.at));
    });

// The look that would have found the fire was not taken, or nobody heard of it: the detection ends,
// and with it the mission.
TEST(BlindWhileDetecting, AMissionThatFindsNothingEnds) {
  for (const char* daemon : {"marvin", "sim"}) {
    const Mission mission =
        killed(scenario_at("comets/confirmed"), daemon, at(223.4), Duration::seconds(60));

    EXPECT_EQ(mission.count({{"kind", "alarm"}}), 0U) << daemon;
    EXPECT_EQ(mission.count({{"kind", "mission"}, {"state", "finished"}}), 1U) << daemon;
    EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "") << daemon;
    EXPECT_EQ(mission.untrue, "") << daemon;
  }
}

// What was asked of a UAV while it was dead has expired: the others do not wait for it for ever.
TEST(NotAskedAgain, InCometsTheOperatorEndsTheMonitoring) {
  const Mission mission =
      killed(scenario_at("comets/confirmed"), "marvin", at(387), Duration::seconds(67));

  EXPECT_EQ(mission.count({{"kind", "operator"}, {"does", "end-monitoring"}}), 1U);
  EXPECT_EQ(mission.count({{"kind", "mission"}, {"state", "finished"}}), 1U);
  EXPECT_EQ(mission.count({{"kind", "task"}, {"task", "32"}, {"state", "ended"}}), 3U);
  EXPECT_EQ(mission.untrue, "");
}

// ---- two deaths in one run ----

class TwoDeaths : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(TwoDeaths, LeaveNothingUndoneThatIsNotExplained) {
  Random random(GetParam(), "two deaths");
  scenario::Scenario scenario =
      scenario_at(random.chance(0.5) ? "comets/confirmed" : "iros2005/fire");
  const std::vector<std::string> daemons = daemons_of(scenario);
  for (int i = 0; i < 2; ++i)
    scenario.faults.kills.push_back({at(random.uniform(1, 700)),
                                     daemons[random.below(daemons.size())],
                                     Duration::seconds(random.uniform(0, 20))});

  const Mission mission = play(scenario);

  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
  EXPECT_TRUE(mission.failures().empty() || says_why(mission.records)) << mission.failures();
}
INSTANTIATE_TEST_SUITE_P(Seeds, TwoDeaths,
                         ::testing::Range<std::uint64_t>(1, cases<std::uint64_t>(9, 501)));

}  // namespace
}  // namespace skein::testing
