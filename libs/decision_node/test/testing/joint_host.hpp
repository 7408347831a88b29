// SPDX-License-Identifier: Apache-2.0
// A decision node as far as joint tasks need one.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "interaction/interaction.hpp"
#include "testing/stood_in.hpp"

namespace skein::decision_node::testing {

/// The node of "marvin", as far as joint tasks need it.
class LoneJointHost final : public JointHost {
 public:
  explicit LoneJointHost(Config config = stood_in_config("relay")) : config_(std::move(config)) {}
  Bus& bus() override { return bus_; }
  const Config& config() const override { return config_; }
  Partners& partners() override { return partners_; }
  std::shared_ptr<const world::World> world() const override { return config_.world; }
  void run(executive::Input input) override { inputs.push_back(std::move(input)); }
  bool stops(executive::TaskId) const override { return false; }
  std::vector<mission::HeldTask> held() const override { return {}; }
  executive::TaskId first_role_id() const override { return functional::kFirstRoleId; }
  void serves(executive::TaskId, executive::TaskId) override {}
  void answered(const supervisor::JointTaskAnswered& answer) override {
    if (!answer.loaded) not_loaded.push_back(answer.why);
  }
  world::VehicleState when_it_begins(executive::TaskId,
                                     const world::VehicleState& seen) const override {
    return seen;
  }
  std::vector<executive::TaskId> joint_tasks_before(executive::TaskId joint) const override {
    return {plan.begin(), std::find(plan.begin(), plan.end(), joint)};
  }
  std::string why_not(const Joint&, const std::string&) const override { return ""; }

  std::vector<executive::TaskId> plan;   ///< its joint tasks, in order
  std::vector<std::string> not_loaded;   ///< why
  std::vector<executive::Input> inputs;  ///< to its executive

 private:
  Bus bus_;
  Config config_;
  Partners partners_{config_.partner_lease};
};

}  // namespace skein::decision_node::testing
