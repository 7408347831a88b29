// SPDX-License-Identifier: Apache-2.0
// The COMETS mission (spec 8.2), both variants, at every mix of degrees, without faults.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>

#include "skein/laws/protocol.hpp"
#include "test_cases.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

struct Team {
  std::string name;
  std::vector<std::string> degrees;
};
void PrintTo(const Team& team, std::ostream* out) { *out << team.name; }

const std::vector<Team>& teams() {
  static const std::vector<Team> kTeams{{"all_3", {"3"}},
                                        {"all_2", {"2"}},
                                        {"all_1", {"1"}},
                                        {"marvin_1", {"3", "marvin=1"}},
                                        {"heliv_2", {"3", "heliv=2"}},
                                        {"karma_1_others_2", {"2", "karma=1"}},
                                        {"marvin_3_others_1", {"1", "marvin=3"}},
                                        {"one_of_each", {"marvin=1", "heliv=2", "karma=3"}}};
  return kTeams;
}

class Comets : public ::testing::TestWithParam<std::tuple<std::string, Team, std::uint64_t>> {
 protected:
  scenario::Scenario scenario() const {
    const auto& [variant, team, seed] = GetParam();
    return comets(variant, with(seed, team.degrees));
  }
};

TEST_P(Comets, MeetsEveryExpectationAndKeepsTheLaws) {
  const Mission mission = play(scenario());

  EXPECT_EQ(mission.end, End::kFinished);
  EXPECT_EQ(mission.failures(), "");
  EXPECT_EQ(laws::to_text(laws::broken_protocol(mission.records)), "");
  EXPECT_EQ(mission.untrue, "");
}

INSTANTIATE_TEST_SUITE_P(
    Virtual, Comets,
    ::testing::Combine(::testing::Values("confirmed", "infirmed"), ::testing::ValuesIn(teams()),
                       ::testing::Range<std::uint64_t>(1, cases<std::uint64_t>(2, 9))),
    [](const auto& one) {
      return std::get<0>(one.param) + "_" + std::get<1>(one.param).name + "_seed_" +
             std::to_string(std::get<2>(one.param));
    });

class CometsLog : public ::testing::TestWithParam<std::tuple<std::string, Team>> {};

TEST_P(CometsLog, IsTheSameByteForByteForOneSeedAndAnotherForAnother) {
  const auto& [variant, team] = GetParam();

  const std::string once = play(comets(variant, with(1, team.degrees))).log();
  const std::string again = play(comets(variant, with(1, team.degrees))).log();
  const std::string other = play(comets(variant, with(2, team.degrees))).log();

  EXPECT_TRUE(once == again);
  EXPECT_FALSE(once == other);
}

INSTANTIATE_TEST_SUITE_P(Virtual, CometsLog,
                         ::testing::Combine(::testing::Values("confirmed", "infirmed"),
                                            ::testing::ValuesIn(teams())),
                         [](const auto& one) {
                           return std::get<0>(one.param) + "_" + std::get<1>(one.param).name;
                         });

// Who runs the plan shows in who writes its task records.
TEST(CometsDegrees, DecideWhereThePlansAreRun) {
  const Mission at_1 = play(comets("confirmed", with(1, {"1"})));
  const Mission at_3 = play(comets("confirmed", with(1, {"3"})));

  EXPECT_EQ(at_1.count({{"kind", "task"}, {"node", "marvin"}}), 0U);
  EXPECT_GT(at_1.count({{"kind", "task"}, {"node", "ground"}}), 0U);
  EXPECT_EQ(at_3.count({{"kind", "task"}, {"node", "ground"}}), 0U);
  EXPECT_GT(at_3.count({{"kind", "task"}, {"node", "marvin"}}), 0U);
}

TEST(CometsDegrees, DecideWhichWaySynchronisationMessagesGo) {
  const Mission::Fields direct{
      {"kind", "message"}, {"slot", "SyncMessage"}, {"from", "marvin"}, {"to", "heliv"}};
  const Mission::Fields through_ground{
      {"kind", "message"}, {"slot", "SyncMessage"}, {"from", "marvin"}, {"to", "ground"}};
  const Mission at_2 = play(comets("confirmed", with(1, {"2"})));
  const Mission at_3 = play(comets("confirmed", with(1, {"3"})));

  EXPECT_EQ(at_2.count(direct), 0U);
  EXPECT_GT(at_2.count(through_ground), 0U);
  EXPECT_GT(at_3.count(direct), 0U);
  EXPECT_EQ(at_3.count(through_ground), 0U);
}

}  // namespace
}  // namespace skein::testing
