// SPDX-License-Identifier: Apache-2.0
// The COMETS mission with radio cuts, lost streams, killed daemons and drawn faults.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "skein/laws/protocol.hpp"
#include "test_cases.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

using ::testing::AnyOf;
using ::testing::Eq;
using ::testing::HasSubstr;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

const Mission::Fields kAlarm{{"kind", "alarm"}, {"state", "raised"}};

Mission::Fields command(const std::string& uav, const std::string& state) {
  return {{"kind", "command"}, {"uav", uav}, {"state", state}};
}

/// When the alarm is raised in the run without faults; up to there the run with faults is the same
/// if its faults come later.
double alarm_instant(const scenario::Scenario& scenario) {
  const auto instant = play(scenario).first(kAlarm);
  EXPECT_TRUE(instant.has_value());
  return instant.value_or(0);
}

// ---- cuts ----

class AtDegree : public ::testing::TestWithParam<std::string> {
 protected:
  scenario::Scenario scenario() const { return comets("confirmed", with(1, {GetParam()})); }
};
INSTANTIATE_TEST_SUITE_P(Degrees, AtDegree, ::testing::Values("1", "2", "3"));

// The ground asks Heliv to confirm the alarm just then: it is told as soon as it can be.
TEST_P(AtDegree, ACutShorterThanACommandsLifeDelaysTheMissionAndNoMore) {
  scenario::Scenario scenario = this->scenario();
  const double alarm = alarm_instant(scenario);
  scenario.radio.cuts.push_back({"heliv", "ground", at(alarm - 5), at(alarm + 35)});

  const Mission mission = play(scenario);

  EXPECT_EQ(mission.end, End::kFinished);
  EXPECT_EQ(mission.failures(), "");
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
  const auto takeoff = mission.first(
      {{"kind", "task"}, {"uav", "heliv"}, {"type", "takeoff"}, {"state", "running"}});
  ASSERT_TRUE(takeoff.has_value());
  EXPECT_GT(*takeoff, alarm + 35);
  EXPECT_LT(*takeoff, alarm + 45);
}

class WithAnMle : public AtDegree {};
INSTANTIATE_TEST_SUITE_P(Degrees, WithAnMle, ::testing::Values("2", "3"));

TEST_P(WithAnMle, ACutLongerThanACommandsLifeLetsItExpireAndTheLogSaysSo) {
  scenario::Scenario scenario = this->scenario();
  const double alarm = alarm_instant(scenario);
  scenario.radio.cuts.push_back({"heliv", "ground", at(alarm - 5), at(alarm + 95)});

  const Mission mission = play(scenario);

  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
  EXPECT_EQ(mission.count(command("heliv", "expired")), 4U);
  EXPECT_FALSE(mission.find(command("heliv", "expired"))[0].text("why").empty());
  for (const char* never_given : {"1", "2", "3", "4"})
    EXPECT_EQ(mission.count({{"kind", "task"}, {"node", "heliv"}, {"task", never_given}}), 0U);
  EXPECT_EQ(mission.end, End::kFinished) << "the operator ends what cannot come any more";
  EXPECT_THAT(mission.failures(), HasSubstr("no command expires"));
}

// Marvin and Heliv meet while they cannot hear each other; at degree 2 they never needed to.
TEST_P(WithAnMle, ARendezvousWaitsForTheLinkItNeeds) {
  scenario::Scenario scenario = this->scenario();
  const auto confirmed = play(scenario).first({{"kind", "alarm"}, {"state", "confirmed"}});
  ASSERT_TRUE(confirmed.has_value());
  const double until = *confirmed + 150;
  scenario.radio.cuts.push_back({"heliv", "marvin", at(*confirmed), at(until)});

  const Mission mission = play(scenario);

  EXPECT_EQ(mission.end, End::kFinished);
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
  const auto met = mission.first({{"kind", "task"}, {"type", "synchronise"}, {"state", "ended"}});
  ASSERT_TRUE(met.has_value());
  if (GetParam() == "3") {
    EXPECT_GT(*met, until);
    EXPECT_LT(*met, until + 10);
  } else {
    EXPECT_LT(*met, until);
    EXPECT_EQ(mission.failures(), "");
  }
}

// ---- loss of contact with the ground (spec 1.2) ----

TEST_P(AtDegree, OutOfContactForLongKarmaReturnsAndLands) {
  scenario::Scenario scenario = this->scenario();
  const auto karma_flies = play(scenario).first(
      {{"kind", "task"}, {"uav", "karma"}, {"type", "takeoff"}, {"state", "ended"}});
  ASSERT_TRUE(karma_flies.has_value());
  scenario.radio.cuts.push_back(
      {"karma", "ground", at(*karma_flies + 20), scenario.duration_limit});

  const Mission mission = play(scenario);

  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
  EXPECT_EQ(mission.count({{"kind", "contact"}, {"uav", "karma"}, {"policy", "return"}}), 1U);
  const auto last = mission.find({{"kind", "telemetry"}, {"uav", "karma"}}).back();
  EXPECT_FALSE(last.truth("airborne"));
  // A blimp cannot stop over a point and drifts while it comes down: near its pad is home.
  const std::vector<double> position = last.numbers("position");
  EXPECT_LT(std::hypot(position.at(0) - 0, position.at(1) + 90), 80);
}

TEST_P(AtDegree, OutOfContactForLongMarvinHoldsInTheAir) {
  scenario::Scenario scenario = this->scenario();
  scenario.radio.cuts.push_back({"marvin", "ground", at(100), at(400)});

  const Mission mission = play(scenario);

  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
  EXPECT_EQ(mission.count({{"kind", "contact"}, {"uav", "marvin"}, {"policy", "hold"}}), 1U);
  const auto telemetry = mission.find({{"kind", "telemetry"}, {"uav", "marvin"}});
  std::vector<double> here;
  std::vector<double> later;
  for (const journal::Record& one : telemetry) {
    if (one.at() <= at(200)) here = one.numbers("position");
    if (one.at() <= at(390)) later = one.numbers("position");
  }
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(here.at(axis), later.at(axis), 10);
}

TEST_P(AtDegree, ACutShorterThanThePolicysDelayCallsForNoPolicy) {
  scenario::Scenario scenario = this->scenario();
  scenario.radio.cuts.push_back({"marvin", "ground", at(100), at(150)});

  const Mission mission = play(scenario);

  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
  EXPECT_EQ(mission.count({{"kind", "contact"}}), 0U);
}

// ---- losses ----

class WithLoss
    : public ::testing::TestWithParam<std::tuple<std::string, std::string, std::uint64_t>> {};

TEST_P(WithLoss, OfThirtyPercentOfStreamsTheMissionStillMeetsItsExpectations) {
  const auto& [variant, degree, seed] = GetParam();
  scenario::Scenario scenario = comets(variant, with(seed, {degree}));
  scenario.radio.model.loss = 0.3;

  const Mission mission = play(scenario);

  EXPECT_EQ(mission.end, End::kFinished);
  EXPECT_EQ(mission.failures(), "");
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
}

INSTANTIATE_TEST_SUITE_P(
    Virtual, WithLoss,
    ::testing::Combine(::testing::Values("confirmed", "infirmed"), ::testing::Values("1", "3"),
                       ::testing::Range<std::uint64_t>(1, cases<std::uint64_t>(2, 4))));

// ---- kills ----

TEST_P(AtDegree, ADecisionNodeThatForgotAllBeforeItsTurnMakesNoDifferenceToTheMission) {
  scenario::Scenario scenario = this->scenario();
  scenario.faults.kills.push_back({at(30), "karma", Duration::seconds(10), true});

  const Mission mission = play(scenario);

  EXPECT_EQ(mission.end, End::kFinished);
  EXPECT_EQ(mission.failures(), "");
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
  EXPECT_EQ(mission.count({{"kind", "fault"}, {"what", "restart"}, {"target", "karma"}}), 1U);
}

TEST_P(WithAnMle, ADecisionNodeThatForgotItsPlanHasLostItAndTheGroundKnows) {
  scenario::Scenario scenario = this->scenario();
  scenario.faults.kills.push_back({at(150), "marvin", Duration::seconds(5), true});

  const Mission mission = play(scenario);

  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
  const auto notices = mission.find({{"kind", "notice"}, {"node", "ground"}, {"uav", "marvin"}});
  ASSERT_FALSE(notices.empty());
  EXPECT_THAT(std::string(notices[0].text("text")), HasSubstr("restarted"));
}

// At degree 1 the plan is at the ground and survives the decision node; the vehicle has given up
// what it did, so what comes after in the plan is done: Marvin goes home.
TEST(RestartAtDegree1, OfADecisionNodeThatForgotAllLeavesTheGroundToGoOnWithThePlan) {
  scenario::Scenario scenario = comets("confirmed", with(1, {"1"}));
  scenario.faults.kills.push_back({at(150), "marvin", Duration::seconds(5), true});

  const Mission mission = play(scenario);

  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
  EXPECT_EQ(
      mission.count({{"kind", "task"}, {"uav", "marvin"}, {"task", "3"}, {"state", "aborted"}}),
      1U);
  EXPECT_EQ(mission.count({{"kind", "task"}, {"uav", "marvin"}, {"task", "6"}, {"state", "ended"}}),
            1U);
  EXPECT_FALSE(mission.find({{"kind", "telemetry"}, {"uav", "marvin"}}).back().truth("airborne"));
}

TEST_P(AtDegree, ADecisionNodeThatNeverComesBackDoesNotHangTheRun) {
  scenario::Scenario scenario = this->scenario();
  scenario.faults.kills.push_back({at(150), "marvin", std::nullopt, true});

  const Mission mission = play(scenario);

  EXPECT_NE(mission.end, End::kTimeLimit) << "the script gives it up";
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
}

// ---- drawn faults ----

class DrawnFaults : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(DrawnFaults, LetTheRunEndAndBreakNoLaw) {
  const std::uint64_t seed = GetParam();
  const std::vector<std::vector<std::string>> teams{
      {"3"}, {"2"}, {"1"}, {"marvin=1", "heliv=2", "karma=3"}};
  scenario_setup::Overrides none;
  scenario::Scenario scenario = comets(seed % 2 == 0 ? "confirmed" : "infirmed", none);
  scenario.faults.random = {30, 25, 6, 8};
  ASSERT_TRUE(scenario_setup::apply(with(seed, teams[seed % teams.size()]), scenario).empty());

  const Mission mission = play(scenario);

  EXPECT_THAT(mission.end, AnyOf(Eq(End::kFinished), Eq(End::kTimeLimit)));
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
}

INSTANTIATE_TEST_SUITE_P(Seeds, DrawnFaults,
                         ::testing::Range<std::uint64_t>(1, cases<std::uint64_t>(9, 51)));

TEST(DrawnFaults, GiveTheSameLogForTheSameSeed) {
  scenario::Scenario scenario = comets("confirmed");
  scenario.faults.random = {30, 25, 6, 8};
  ASSERT_TRUE(scenario_setup::apply(with(5), scenario).empty());

  EXPECT_TRUE(play(scenario).log() == play(scenario).log());
}

}  // namespace
}  // namespace skein::testing
