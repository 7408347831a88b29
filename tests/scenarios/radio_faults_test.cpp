// SPDX-License-Identifier: Apache-2.0
// The fault scripts of tests/network in virtual time, over many seeds: COMETS over a radio that
// misbehaves and tells nobody. What tests/network does with packets is done with samples here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "skein/foundation/contract.hpp"
#include "skein/laws/healing.hpp"
#include "skein/laws/protocol.hpp"
#include "skein/scenario_text/scenario_text.hpp"
#include "test_cases.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

using ::testing::IsEmpty;

const std::string kSources = SKEIN_SOURCE_DIR;

std::string text_in(const std::string& file) {
  std::ifstream in(file);
  SKEIN_EXPECTS(in.good());
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Run {
  std::string scenario, faults;
  double may_fail = 0;  ///< share of seeds
};
void PrintTo(const Run& run, std::ostream* out) { *out << run.scenario << ", " << run.faults; }

/// With nobody told of what the radio does.
scenario::Scenario silent(const Run& run, std::uint64_t seed) {
  const std::string file = kSources + "/scenarios/" + run.scenario + ".yaml";
  std::string text = text_in(file);
  for (const std::string& faults :
       {text_in(kSources + "/tests/network/faults/" + run.faults + ".yaml"),
        std::string("radio: {silent: true}")}) {
    const auto changed = scenario_text::with_radio(text, faults);
    SKEIN_EXPECTS(changed.has_value());
    text = *changed;
  }
  auto scenario = scenario::read_scenario_text(text, file);
  SKEIN_EXPECTS(scenario.has_value());
  SKEIN_EXPECTS(scenario_setup::apply(with(seed), *scenario).empty());
  return std::move(*scenario);
}

/// Sensors may miss the fire, or see it wrongly, whatever the radio does.
bool is_met_without_faults(const Run& run, std::uint64_t seed) {
  return play(scenario_at(run.scenario, with(seed))).failures().empty();
}

class RadioFaults : public ::testing::TestWithParam<Run> {};

TEST_P(RadioFaults, NeitherHinderTheMissionNorLoseAnything) {
  const auto seeds = cases<std::uint64_t>(3, 300);
  std::string unmet;
  double count = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const scenario::Scenario scenario = silent(GetParam(), seed);
    const Mission mission = play(scenario);

    EXPECT_THAT(laws::broken_protocol(mission.records), IsEmpty()) << "seed " << seed;
    EXPECT_THAT(laws::broken_healing(mission.records, laws::healing_limits(scenario)), IsEmpty())
        << "seed " << seed;
    EXPECT_EQ(mission.untrue, "") << "seed " << seed;
    if (mission.failures().empty() || !is_met_without_faults(GetParam(), seed)) continue;
    ++count;
    unmet += "seed " + std::to_string(seed) + ": " + mission.failures();
  }
  EXPECT_LE(count, GetParam().may_fail * static_cast<double>(seeds)) << unmet;
}

// Of looks that saw nothing three of ten are lost still, so that an alarm may be infirmed later.
INSTANTIATE_TEST_SUITE_P(
    Comets, RadioFaults,
    ::testing::Values(Run{"comets/confirmed", "cuts"}, Run{"comets/confirmed", "one-way"},
                      Run{"comets/confirmed", "flapping"}, Run{"comets/confirmed", "slow-flapping"},
                      Run{"comets/confirmed", "halves"}, Run{"comets/confirmed", "loss", 0.01},
                      Run{"comets/serial-radio", "none"}),
    [](const auto& one) {
      std::string name = one.param.scenario.substr(7) + "_" + one.param.faults;
      for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
      return name;
    });

class LostLooks : public ::testing::TestWithParam<const char*> {};

// Three of ten looks are lost. What an alarm rests on comes all the same: looks that find something
// are events, as long as that is news.
TEST_P(LostLooks, CostNoAlarmAndNoTime) {
  const auto first_alarm = [](const Mission& mission) {
    return mission.first({{"kind", "alarm"}, {"state", "raised"}});
  };
  const auto seeds = cases<std::uint64_t>(5, 300);
  std::size_t raised = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const auto without = first_alarm(play(silent({GetParam(), "none"}, seed)));
    const auto with = first_alarm(play(silent({GetParam(), "loss"}, seed)));
    if (!without) continue;
    ++raised;
    ASSERT_TRUE(with) << "seed " << seed << ": no alarm, raised without losses at " << *without;
    EXPECT_LE(*with, *without + 5) << "seed " << seed;
  }
  EXPECT_GE(static_cast<double>(raised), 0.8 * static_cast<double>(seeds)) << "nothing to judge";
}

INSTANTIATE_TEST_SUITE_P(Fires, LostLooks, ::testing::Values("comets/confirmed", "iros2005/fire"),
                         [](const auto& one) { return std::string(one.param).substr(0, 4); });

// What is judged does happen: who is cut off is found to be, by silence alone.
TEST(SilentCuts, AreFoundOut) {
  const Mission mission = play(silent({"comets/confirmed", "cuts"}, 1));

  for (const char* uav : {"marvin", "heliv", "karma"})
    EXPECT_GE(mission.count(
                  {{"node", uav}, {"kind", "reach"}, {"peer", "ground"}, {"reachable", "false"}}),
              1U)
        << uav;
}

}  // namespace
}  // namespace skein::testing
