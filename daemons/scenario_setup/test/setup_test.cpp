// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario_setup/setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/scenario_setup/overrides.hpp"

namespace skein::scenario_setup {
namespace {

using ::testing::HasSubstr;

std::string file_of(const std::string& name) {
  return std::string(SKEIN_SOURCE_DIR) + "/scenarios/" + name;
}

scenario::Scenario comets() {
  auto scenario = scenario::read_scenario(file_of("comets/confirmed.yaml"));
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

scenario::LinkSpec a_link(double capacity) {
  scenario::LinkSpec link;
  link.a = "marvin";
  link.b = "ground";
  link.from = MissionTime();
  link.until = MissionTime::seconds(1e6);
  link.capacity = capacity;
  return link;
}

TEST(Setup, ALinkThatHasItsCapacityAllTheTimeHasItBothWays) {
  scenario::Scenario scenario = comets();
  scenario.radio.links = {a_link(19'200)};

  const node::RadioCapacity capacity = capacity_of(scenario);

  EXPECT_EQ(capacity.of_links.at({"marvin", "ground"}), 19'200);
  EXPECT_EQ(capacity.of_links.at({"ground", "marvin"}), 19'200);
}

TEST(Setup, ALinkOfOneWayHasItThatWay) {
  scenario::Scenario scenario = comets();
  scenario.radio.links = {a_link(19'200)};
  scenario.radio.links[0].one_way = true;

  EXPECT_EQ(capacity_of(scenario).of_links.size(), 1U);
}

TEST(Setup, WhatIsSoForAWhileIsTheSimulatorsToSay) {
  scenario::Scenario scenario = comets();
  scenario.radio.links = {a_link(19'200)};
  scenario.radio.links[0].from = MissionTime::seconds(10);

  EXPECT_TRUE(capacity_of(scenario).of_links.empty());
}

TEST(Setup, ChannelsThatHeartbeatsFillAreNamedAllAtOnce) {
  scenario::Scenario scenario = comets();
  scenario.radio.model.capacity = 10;
  scenario.radio.links = {a_link(20)};

  const Diagnostics problems = radio_problems(scenario);

  ASSERT_EQ(problems.size(), 2U);
  EXPECT_THAT(to_text(problems), HasSubstr("of the radio"));
  EXPECT_THAT(to_text(problems), HasSubstr("between marvin and ground"));
  EXPECT_THAT(to_text(problems), HasSubstr("confirmed.yaml"));
}

TEST(Setup, WordsOfATeamLiveAsLongAsAnAnswerIsWaitedFor) {
  scenario::Scenario scenario = comets();
  const auto lifespan = [&](wire::Slot slot) {
    return *roster_of(scenario).slots().lifespans()[static_cast<std::size_t>(slot)];
  };
  const Duration alone = lifespan(wire::Slot::kTeamMessage);
  const Duration of_air = lifespan(wire::Slot::kMergeMessage);
  scenario.team.emplace().limits.sale.answer_within = Duration::seconds(9);

  EXPECT_LT(alone, Duration::seconds(9));
  EXPECT_EQ(lifespan(wire::Slot::kTeamMessage), Duration::seconds(9));
  EXPECT_EQ(lifespan(wire::Slot::kTeamSale), Duration::seconds(9));
  EXPECT_EQ(lifespan(wire::Slot::kMergeMessage), of_air);
  scenario.team->limits.sale.answer_within = Duration::seconds(1);
  EXPECT_EQ(lifespan(wire::Slot::kTeamMessage), alone);
}

TEST(Setup, WhatIsWrongInTheTableOfSlotsIsAmongTheProblemsOfEveryDaemon) {
  scenario::Scenario scenario = comets();
  config::Value row, table, document;
  row.kind = table.kind = document.kind = config::Value::Kind::kMap;
  table.entries.push_back({"Telemetri", row});
  document.entries.push_back({"slots", table});
  scenario.slots = document;

  EXPECT_THAT(to_text(radio_problems(scenario)), HasSubstr("slots.Telemetri: no slot"));
  EXPECT_EQ(&roster_of(scenario).slots(), &roster_of(comets()).slots()) << "the one that ships";
}

TEST(Setup, ChannelsWithRoomAreNoProblem) { EXPECT_TRUE(radio_problems(comets()).empty()); }

TEST(LoadedScenario, IsGivenToTheCheckAfterTheOverrides) {
  Overrides overrides;
  overrides.seed = 77;
  std::uint64_t seen = 0;

  const auto loaded = load_scenario(file_of("comets/confirmed.yaml"), overrides,
                                    [&](const scenario::Scenario& scenario) {
                                      seen = scenario.seed;
                                      return Diagnostics();
                                    });

  EXPECT_TRUE(loaded.has_value());
  EXPECT_EQ(seen, 77U);
}

TEST(LoadedScenario, IsNoneWhenTheCheckFindsSomething) {
  const auto loaded =
      load_scenario(file_of("comets/confirmed.yaml"), {}, [](const scenario::Scenario& scenario) {
        return radio_problems([&] {
          scenario::Scenario narrow = scenario;
          narrow.radio.model.capacity = 1;
          return narrow;
        }());
      });

  ASSERT_FALSE(loaded.has_value());
  EXPECT_THAT(to_text(loaded.error()), HasSubstr("heartbeats take"));
}

TEST(LoadedScenario, ThatIsNoFileIsSaidWithItsName) {
  const auto loaded = load_scenario("/nowhere/nothing.yaml", {}, {});

  ASSERT_FALSE(loaded.has_value());
  EXPECT_THAT(to_text(loaded.error()), HasSubstr("/nowhere/nothing.yaml"));
}

}  // namespace
}  // namespace skein::scenario_setup
