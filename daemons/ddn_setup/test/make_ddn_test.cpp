// SPDX-License-Identifier: Apache-2.0
#include "skein/ddn_setup/make_ddn.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/deliberation_setup/knowledge.hpp"

namespace skein::ddn_setup {
namespace {

scenario::Scenario scenario_at(const std::string& name) {
  auto scenario =
      scenario::read_scenario(std::string(SKEIN_SOURCE_DIR) + "/scenarios/" + name + ".yaml");
  if (!scenario) ADD_FAILURE() << to_text(scenario.error());
  return scenario ? *scenario : scenario::Scenario();
}

/// What the node says of its autonomy when it starts; nothing where it says nothing.
std::optional<wire::AutonomyDegree> degree_said_by(node::Node& node) {
  for (const node::Effect& effect : node.handle(node::Started{1, true}, MissionTime())) {
    const auto* send = std::get_if<node::Send>(&effect);
    if (send == nullptr) continue;
    if (const auto* degree = std::get_if<wire::AutonomyDegree>(&send->sample)) return *degree;
  }
  return std::nullopt;
}

TEST(DecisionNode, OfEveryUavOfAScenarioWithPlanningMayDeliberate) {
  scenario::Scenario scenario = scenario_at("mref/nominal");
  ASSERT_TRUE(deliberation_setup::planning_problems(scenario).empty());

  for (scenario::UavSpec& uav : scenario.uavs) {
    uav.degree = 4;
    const auto degree = degree_said_by(*make_ddn(scenario, uav));
    ASSERT_TRUE(degree) << uav.name;
    EXPECT_EQ(degree->uav, uav.name);
    EXPECT_EQ(degree->degree, 4);
  }
}

TEST(DecisionNode, HasTheContactPolicyOfItsUav) {
  scenario::Scenario scenario = scenario_at("comets/confirmed");
  scenario.uavs[1].contact_loss.policy = scenario::ContactLoss::Policy::kHold;

  const auto degree = degree_said_by(*make_ddn(scenario, scenario.uavs[1]));

  ASSERT_TRUE(degree);
  EXPECT_EQ(degree->contact_policy, "hold");
}

}  // namespace
}  // namespace skein::ddn_setup
