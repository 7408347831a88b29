// SPDX-License-Identifier: Apache-2.0
// Daemons that die by kill -9 over DDS, in every kind of mission, and come back with what they
// knew: the mission ends as specified or says why not, and the laws of the event log hold.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "test_cases.hpp"
#include "testing/clocks_apart.hpp"
#include "testing/dds_run.hpp"
#include "testing/reasons.hpp"

namespace skein::testing {
namespace {

constexpr double kRate = 20;
constexpr const char* kLibrary = SKEIN_BINARY_DIR "/lib/libskein_adversity.so";

struct Death {
  std::string daemon;
  double at = 0, away = 0;  ///< [s] of the mission
};

struct Mission {
  std::string scenario;
  std::vector<std::string> daemons;
  double seconds = 0;  ///< that it takes when nothing happens
};

const std::vector<Mission>& missions() {
  static const std::vector<Mission> all{
      {"comets/confirmed", {"marvin", "sim", "ground", "heliv", "karma"}, 775},
      {"karma/detection", {"karma", "sim", "ground"}, 625},
      {"heliv-marvin/monitoring", {"heliv", "ground", "sim", "marvin"}, 360},
      {"iros2005/fire", {"marvin", "karma", "sim", "ground", "heliv"}, 1250},
      {"handover/radio", {"marvin", "ground", "karma", "sim"}, 430}};
  return all;
}

std::string as_faults(const std::vector<Death>& deaths) {
  std::string faults = "\nfaults:\n";
  for (const Death& death : deaths) {
    faults += "  - {at: " + std::to_string(death.at) + ", kill: " + death.daemon +
              ", restart_after: " + std::to_string(death.away) + "}\n";
  }
  return faults;
}

std::vector<std::string> those_who_came_back(const std::vector<journal::Record>& records) {
  std::vector<std::string> names;
  for (const journal::Record& record : records)
    if (record.kind() == "resumed") names.push_back(record.node());
  return names;
}

std::vector<std::string> those_who_die(const std::vector<Death>& deaths) {
  std::vector<std::string> names;
  for (const Death& death : deaths) names.push_back(death.daemon);
  return names;
}

std::string breaches_of(const std::vector<journal::Record>& records) {
  constexpr double kApart = kClocksApartWithoutLeader;
  return breaches_beyond_clocks(with_last_messages(records, kRate, kApart), kRate, kApart);
}

/// Plays it and expects what is to be expected of every mission in which daemons die.
void expect_nothing_lost(const std::string& scenario, const std::vector<Death>& deaths) {
  DdsRun run;
  run.take_scenario_of(scenario, as_faults(deaths));
  run.start({"--rate", std::to_string(kRate)});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  ASSERT_THAT(status->code, ::testing::AnyOf(0, 1)) << run.output();
  const std::vector<journal::Record> records = run.records();
  EXPECT_EQ(those_who_came_back(records), those_who_die(deaths));
  EXPECT_TRUE(status->code == 0 || says_why(records)) << run.output();
  EXPECT_TRUE(is_explained(records)) << run.output();
  EXPECT_EQ(breaches_of(records), "");
  EXPECT_EQ(left_under_way(records), "");
  EXPECT_TRUE(run.nothing_runs());
  EXPECT_THAT(run.left_in_shared_memory(), ::testing::IsEmpty());
}

// ---- all daemons of a mission, one after the other ----

class DdsDeaths : public ::testing::TestWithParam<Mission> {};

TEST_P(DdsDeaths, OfAllDaemonsInTurnLoseNothing) {
  std::vector<Death> deaths;
  double at = 40;
  for (const std::string& daemon : GetParam().daemons) {
    deaths.push_back({daemon, at, 5});
    at += 70;
  }
  expect_nothing_lost(GetParam().scenario, deaths);
}

std::string word_of(std::string scenario) {
  std::replace_if(
      scenario.begin(), scenario.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
  return scenario;
}

INSTANTIATE_TEST_SUITE_P(Missions, DdsDeaths, ::testing::ValuesIn(missions()),
                         [](const auto& one) { return word_of(one.param.scenario); });

// ---- one daemon, in one phase, for a while ----

struct OneDeath {
  std::string scenario;
  Death death;
};

/// Of every daemon of every mission, in so many phases of it, away for 5 s and for 60 s, and back
/// before it ends without the one who is away. The short
/// form takes the ground station of two missions, away for the longer time.
std::vector<OneDeath> deaths_one_by_one() {
  constexpr int kPhases = 4;
  constexpr double kLongest = 60;
  std::vector<OneDeath> all;
  for (const Mission& mission : missions()) {
    for (const std::string& daemon : mission.daemons) {
      for (int phase = 0; phase < kPhases; ++phase) {
        const double at = (mission.seconds - kLongest) * (phase + 0.5) / kPhases;
        for (const double away : {5.0, kLongest})
          all.push_back({mission.scenario, {daemon, at, away}});
      }
    }
  }
  if (long_tests()) return all;
  std::erase_if(all, [](const OneDeath& one) {
    const bool chosen =
        one.scenario == "heliv-marvin/monitoring" || one.scenario == "handover/radio";
    return !chosen || one.death.daemon != "ground" || one.death.away != 60 || one.death.at < 200 ||
           one.death.at > 300;
  });
  return all;
}

class DdsDeath : public ::testing::TestWithParam<OneDeath> {};

TEST_P(DdsDeath, LosesNothing) { expect_nothing_lost(GetParam().scenario, {GetParam().death}); }

INSTANTIATE_TEST_SUITE_P(OneByOne, DdsDeath, ::testing::ValuesIn(deaths_one_by_one()),
                         [](const auto& one) {
                           const Death& death = one.param.death;
                           return word_of(one.param.scenario) + "_" + death.daemon + "_at_" +
                                  std::to_string(static_cast<int>(death.at)) + "_for_" +
                                  std::to_string(static_cast<int>(death.away));
                         });

// ---- a UAV that is dead for good ----

struct ForGood {
  std::string uav;
  double at = 0;
  std::vector<std::string> in_the_air;  ///< the others, that have to come home
};

void PrintTo(const ForGood& one, std::ostream* out) { *out << one.uav << " at " << one.at << " s"; }

std::optional<double> first_of(const std::vector<journal::Record>& records,
                               const std::function<bool(const journal::Record&)>& wanted) {
  const auto found = std::find_if(records.begin(), records.end(), wanted);
  if (found == records.end()) return std::nullopt;
  return found->at().to_seconds();
}

std::optional<double> reached(const std::vector<journal::Record>& records,
                              const std::string& step) {
  return first_of(records, [&](const journal::Record& record) {
    return record.kind() == "step" && record.text("name") == step;
  });
}

std::optional<double> ended(const std::vector<journal::Record>& records) {
  return first_of(records, [](const journal::Record& record) {
    return record.kind() == "mission" && record.text("state") == "finished";
  });
}

std::vector<std::string> those_who_landed(const std::vector<journal::Record>& records) {
  std::vector<std::string> names;
  for (const journal::Record& record : records) {
    if (record.kind() == "task" && record.text("type") == "land" && record.text("state") == "ended")
      names.emplace_back(record.text("uav"));
  }
  return names;
}

class DdsDeadForGood : public ::testing::TestWithParam<ForGood> {};

// Nobody asks it for anything, so nothing expires: the script of COMETS sees that it is silent.
TEST_P(DdsDeadForGood, IsGivenUpWhenItWasSilentSoLongAndTheOthersLand) {
  const ForGood& dead = GetParam();
  DdsRun run;
  run.take_scenario_of("comets/confirmed", "\nfaults: [{at: " + std::to_string(dead.at) +
                                               ", kill: " + dead.uav + "}]\n");
  run.start({"--rate", std::to_string(kRate)});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  ASSERT_EQ(status->code, 1) << "not all that the scenario expects can be\n" << run.output();
  const std::vector<journal::Record> records = run.records();
  const bool others_go_on = dead.uav == "karma";
  const auto given_up = others_go_on ? ended(records) : reached(records, "return");
  ASSERT_TRUE(given_up.has_value()) << run.output();
  // The last heartbeat was heard before the death, and the silence is known three of them later.
  const double silence = others_go_on ? 600 : 180;
  EXPECT_GE(*given_up, dead.at + silence - 1);
  EXPECT_LE(*given_up, dead.at + silence + 5 + kRate) << "with a second of the wall to spare";
  EXPECT_TRUE(ended(records).has_value());
  EXPECT_THAT(those_who_landed(records), ::testing::UnorderedElementsAreArray(dead.in_the_air));
  EXPECT_EQ(breaches_of(records), "");
  EXPECT_TRUE(run.nothing_runs());
}

std::vector<ForGood> deaths_for_good() {
  if (!long_tests()) return {{"heliv", 330, {"marvin"}}};
  return {{"marvin", 250, {}},
          {"heliv", 330, {"marvin"}},
          {"marvin", 450, {"heliv", "karma"}},
          {"karma", 480, {"marvin", "heliv"}}};
}

INSTANTIATE_TEST_SUITE_P(Uavs, DdsDeadForGood, ::testing::ValuesIn(deaths_for_good()),
                         [](const auto& one) {
                           return one.param.uav + "_at_" +
                                  std::to_string(static_cast<int>(one.param.at));
                         });

// ---- between the write and the answer, and between the answer and the write ----

/// A decision node whose first life ends in the moment after its write of that number to its state
/// file, before anything follows from it, as when the power goes, or, of a negative number, instead
/// of that write; who started it starts it again.
std::string dies_after_write(int number) {
  return R"(
case "$*" in *"--uav marvin"*) ;; *) exec "$programs/skein-ddn" "$@" ;; esac
for word in "$@"; do
  shift
  [ "$before" != --exit-with-parent ] || word=$$  # the daemon's parent is this shell
  set -- "$@" "$word"
  before=$word
done
trap 'kill -TERM "$daemon"' TERM
ADVERSITY_DEATH=)" +
         std::to_string(number) + " LD_PRELOAD='" + kLibrary + R"(' "$programs/skein-ddn" "$@" &
daemon=$!
wait "$daemon"
[ $? = 137 ] || exit 9
"$programs/skein-ddn" "$@" &
daemon=$!
wait "$daemon"
)";
}

/// States of its tasks that the event log has twice.
std::string said_twice(const std::vector<journal::Record>& records, const std::string& node) {
  std::map<std::string, int> times;
  for (const journal::Record& record : records)
    if (record.node() == node && record.kind() == "task") ++times[journal::to_json(record)];
  std::string twice;
  for (const auto& [line, number] : times)
    if (number > 1) twice += line + "\n";
  return twice;
}

class DdsPowerCut : public ::testing::TestWithParam<int> {};

TEST_P(DdsPowerCut, AtAWriteLosesNothingAndSaysNothingTwice) {
  if (!fs::exists(kLibrary)) GTEST_SKIP() << "not with sanitizers";
  DdsRun run;
  run.take_scenario_of("comets/confirmed");
  run.start({"--rate", std::to_string(kRate), "--daemons",
             run.programs_with({"skein-ddn"}, dies_after_write(GetParam()))});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  const std::vector<journal::Record> records = run.records();
  EXPECT_THAT(those_who_came_back(records), ::testing::ElementsAre("marvin"));
  EXPECT_TRUE(status->code == 0 || says_why(records)) << run.output();
  EXPECT_EQ(breaches_of(records), "");
  EXPECT_EQ(left_under_way(records), "");
  EXPECT_EQ(said_twice(records, "marvin"), "");
  EXPECT_TRUE(run.nothing_runs());
}

std::vector<int> writes() {
  if (!long_tests()) return {700};
  return {40,   150,  300,  450,  600,  750,  900,  1050, 1200, 1500, 1800, 2100,
          -300, -301, -302, -303, -600, -601, -602, -603, -900, -901, -902, -903};
}

INSTANTIATE_TEST_SUITE_P(Writes, DdsPowerCut, ::testing::ValuesIn(writes()));

}  // namespace
}  // namespace skein::testing
