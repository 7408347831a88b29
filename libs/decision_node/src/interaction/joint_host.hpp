// SPDX-License-Identifier: Apache-2.0
// What joint tasks ask of the one whose they are.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bus.hpp"
#include "interaction/joint.hpp"
#include "skein/decision_node/config.hpp"
#include "skein/executive/executive.hpp"
#include "skein/mission/autonomy.hpp"

namespace skein::decision_node {

/// Of the decision node of a UAV, or of a stand-in for it.
class JointHost {
 public:
  JointHost() = default;
  JointHost(const JointHost&) = delete;
  JointHost& operator=(const JointHost&) = delete;
  virtual ~JointHost() = default;

  virtual Bus& bus() = 0;
  virtual const Config& config() const = 0;
  /// As believed; null: places are not known here, and nothing is played.
  virtual std::shared_ptr<const world::World> world() const = 0;
  /// Tasks of roles, and what becomes of a joint task that is due.
  virtual void run(executive::Input input) = 0;
  /// The joint task is being aborted.
  virtual bool stops(executive::TaskId joint) const = 0;
  /// Tasks that are not over, those of roles among them.
  virtual std::vector<mission::HeldTask> held() const = 0;
  /// Tasks of roles are numbered from here on, below kFirstOwnId, by the millisecond.
  virtual executive::TaskId first_role_id() const = 0;
  virtual void serves(executive::TaskId role_task, executive::TaskId joint) = 0;
  /// It is loaded, or will not be.
  virtual void answered(const supervisor::JointTaskAnswered& answer) = 0;
  /// What is seen now, as the plan has it when the joint task begins.
  virtual world::VehicleState when_it_begins(executive::TaskId joint,
                                             const world::VehicleState& seen) const = 0;
  /// Where it could stay beside others that merge their ways with it; none: nobody does.
  virtual std::function<bool(const world::Vector3&)> free_to_stay() const { return {}; }
  /// Why a role may not be played by this one, whatever its vehicle can; empty: it may.
  virtual std::string why_not(const Joint& joint, const std::string& role) const = 0;
};

}  // namespace skein::decision_node
