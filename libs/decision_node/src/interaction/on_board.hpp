// SPDX-License-Identifier: Apache-2.0
// The host of joint tasks on a UAV that deliberates.
#pragma once

#include "interaction/joint_host.hpp"

namespace skein::decision_node {

class Core;

/// Uses the UAV's own executive and supervisor.
class OnBoard final : public JointHost {
 public:
  explicit OnBoard(Core& core) : core_(core) {}

  Bus& bus() override;
  const Config& config() const override;
  Partners& partners() override;
  std::shared_ptr<const world::World> world() const override;
  void run(executive::Input input) override;
  bool stops(executive::TaskId joint) const override;
  std::vector<mission::HeldTask> held() const override;
  executive::TaskId first_role_id() const override { return functional::kFirstRoleId; }
  void serves(executive::TaskId role_task, executive::TaskId joint) override;
  void answered(const supervisor::JointTaskAnswered& answer) override;
  world::VehicleState when_it_begins(executive::TaskId joint,
                                     const world::VehicleState& seen) const override;
  std::vector<executive::TaskId> joint_tasks_before(executive::TaskId joint) const override;
  std::function<bool(const world::Vector3&)> free_to_stay() const override;
  std::string why_not(const Joint&, const std::string&) const override { return ""; }

 private:
  Core& core_;
};

}  // namespace skein::decision_node
