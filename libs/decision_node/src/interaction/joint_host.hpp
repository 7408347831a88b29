// SPDX-License-Identifier: Apache-2.0
// What joint tasks need of the node that plays them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bus.hpp"
#include "interaction/joint.hpp"
#include "partners.hpp"
#include "skein/decision_node/config.hpp"
#include "skein/executive/executive.hpp"
#include "skein/mission/autonomy.hpp"

namespace skein::decision_node {

/// Implemented by the decision node of a UAV, and by a stand-in for it at the ground.
class JointHost {
 public:
  JointHost() = default;
  JointHost(const JointHost&) = delete;
  JointHost& operator=(const JointHost&) = delete;
  virtual ~JointHost() = default;

  virtual Bus& bus() = 0;
  virtual const Config& config() const = 0;
  virtual Partners& partners() = 0;
  /// The world as believed; null: it is unknown here, and no role can be played.
  virtual std::shared_ptr<const world::World> world() const = 0;
  /// Passes an input to the executive: tasks of roles, and states of the joint tasks themselves.
  virtual void run(executive::Input input) = 0;
  /// Whether the joint task is being aborted.
  virtual bool stops(executive::TaskId joint) const = 0;
  /// All unfinished tasks, including those of roles.
  virtual std::vector<mission::HeldTask> held() const = 0;
  /// The first id for tasks of roles, which are numbered by the millisecond, below kFirstOwnId.
  virtual executive::TaskId first_role_id() const = 0;
  virtual void serves(executive::TaskId role_task, executive::TaskId joint) = 0;
  /// The joint task was loaded, or cannot be.
  virtual void answered(const supervisor::JointTaskAnswered& answer) = 0;
  /// The vehicle's state at the planned beginning of the joint task, given its state now.
  virtual world::VehicleState when_it_begins(executive::TaskId joint,
                                             const world::VehicleState& seen) const = 0;
  /// The joint tasks of this UAV's plan that come before this one; it may have no plan.
  virtual std::vector<executive::TaskId> joint_tasks_before(executive::TaskId) const { return {}; }
  /// Whether this UAV could stay at a place beside the reservations of others (plan merging); an
  /// empty function: ways are not merged.
  virtual std::function<bool(const world::Vector3&)> free_to_stay() const { return {}; }
  /// Why this node may not play a role, apart from the vehicle's abilities; empty: it may.
  virtual std::string why_not(const Joint& joint, const std::string& role) const = 0;
};

}  // namespace skein::decision_node
