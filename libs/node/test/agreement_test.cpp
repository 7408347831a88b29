// SPDX-License-Identifier: Apache-2.0
// Who lives by whose mission time, when scenarios differ.
#include "skein/node/agreement.hpp"

#include <gtest/gtest.h>

#include "skein/blackboard/program_description.hpp"
#include "skein/foundation/fingerprint.hpp"

namespace skein::node {
namespace {

SectionPrints prints(const std::string& zones, const std::string& places = "p") {
  SectionPrints prints;
  prints.add("zones", Fingerprint().put(zones).value());
  prints.add("places", Fingerprint().put(places).value());
  return prints;
}

std::string flying(const SectionPrints& scenario) {
  return to_text(blackboard::program_description(scenario.text()));
}

class Agreements : public ::testing::Test {
 protected:
  Agreement of(const std::string& self, SectionPrints own = prints("z")) const {
    return {roster_, *roster_.find(self), std::move(own),
            [this](const std::string& node) -> std::optional<std::string> {
              const auto found = programs_.find(node);
              return found == programs_.end() ? std::nullopt : std::optional(found->second);
            }};
  }
  NodeNumber number(const std::string& node) const { return roster_.find(node)->number; }

  const Roster roster_{{"alpha", "bravo"}, {{"bravo", "autopilot"}}};
  std::map<std::string, std::string> programs_;
};

TEST_F(Agreements, NameWhoDiffersWhere) {
  programs_ = {{"sim", flying(prints("z"))},
               {"alpha", flying(prints("other"))},
               {"bravo", flying(prints("other", "others"))}};
  const Agreement ground = of("ground");
  EXPECT_TRUE(ground.agrees(number("sim")));
  EXPECT_EQ(ground.difference(number("alpha")), "differs in zones");
  EXPECT_EQ(ground.difference(number("bravo")), "differs in zones, places");
  EXPECT_EQ(ground.differences(),
            "the scenario of alpha differs in zones; that of bravo differs in zones, places");
}

TEST_F(Agreements, NameThoseWhoDifferAlikeTogether) {
  programs_ = {{"ground", flying(prints("z"))}, {"sim", flying(prints("z"))}};
  EXPECT_EQ(of("alpha", prints("odd")).differences(),
            "the scenario of ground, sim differs in zones");
}

TEST_F(Agreements, AreNotBrokenByWhoIsNotKnownAndByWhoFliesNothing) {
  programs_ = {{"operator", ""}, {"runner", "skein 0.1.0 layout 77"}, {"visitor", ""}};
  EXPECT_EQ(of("ground").differences(), "");
  EXPECT_TRUE(of("ground").agrees(NodeNumber(4711)));
  EXPECT_TRUE(of("ground").agrees(number("alpha")));
}

TEST_F(Agreements, ANodeThatSaysNothingOfItsScenarioDiffers) {
  programs_ = {{"alpha", "skein 0.0.9 layout 77"}, {"bravo", ""}};
  const Agreement ground = of("ground");
  EXPECT_EQ(ground.difference(number("alpha")),
            "is not known: its program does not say it (skein 0.0.9)");
  EXPECT_EQ(ground.difference(number("bravo")), "is not known: its program does not say it");
}

// That of a vehicle's maker knows of no scenario; ours does.
TEST_F(Agreements, AFunctionalLayerMaySayNothingOfItsScenarioButNotAnother) {
  for (const char* says : {"", "skein 0.1.0 layout 77"}) {
    programs_ = {{"autopilot", says}};
    EXPECT_TRUE(of("bravo").agrees(number("autopilot"))) << says;
  }
  programs_ = {{"autopilot", flying(prints("other"))}};
  EXPECT_FALSE(of("bravo").agrees(number("autopilot")));
}

TEST_F(Agreements, WhatAnotherVersionSaysCannotBeCompared) {
  programs_ = {{"alpha", "skein 9.9 layout 77 scenario 2abc"}};
  EXPECT_EQ(of("ground").difference(number("alpha")), "cannot be compared: it is of skein 9.9");
}

TEST_F(Agreements, ANodeWithoutAScenarioAgreesWithAll) {
  programs_ = {{"alpha", flying(prints("z"))}, {"ground", ""}};
  EXPECT_EQ(of("sim", {}).differences(), "");
}

TEST_F(Agreements, TimeIsThatOfWhoAgrees) {
  programs_ = {{"ground", flying(prints("z"))}, {"alpha", flying(prints("other"))}};
  const Agreement bravo = of("bravo");
  const Agreement::Times heard{{number("ground"), MissionTime::seconds(100)},
                               {number("alpha"), MissionTime::seconds(200)}};
  EXPECT_EQ(bravo.latest(heard), MissionTime::seconds(100));
  EXPECT_EQ(bravo.latest({{number("alpha"), MissionTime::seconds(200)}}), MissionTime());
}

TEST_F(Agreements, OneThatDiffersIsRefusedOnceTheOthersFly) {
  programs_ = {{"ground", flying(prints("z"))}, {"alpha", flying(prints("z"))}};
  const Agreement bravo = of("bravo", prints("odd"));
  EXPECT_EQ(bravo.refusal({}), std::nullopt);
  EXPECT_EQ(bravo.refusal({{number("ground"), MissionTime()}}), std::nullopt);
  EXPECT_EQ(bravo.refusal(
                {{number("ground"), MissionTime()}, {number("alpha"), MissionTime::seconds(1)}}),
            "a mission is under way, and the scenario of alpha differs in zones: this node takes "
            "no part in it");
}

TEST_F(Agreements, OneThatAgreesIsNotRefusedForAnotherThatWaits) {
  programs_ = {{"ground", flying(prints("z"))}, {"alpha", flying(prints("odd"))}};
  EXPECT_EQ(of("bravo").refusal(
                {{number("ground"), MissionTime::seconds(100)}, {number("alpha"), MissionTime()}}),
            std::nullopt);
}

}  // namespace
}  // namespace skein::node
