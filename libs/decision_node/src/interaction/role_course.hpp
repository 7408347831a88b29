// SPDX-License-Identifier: Apache-2.0
// What the parts of a role that is played ask of the whole.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interaction/joint_host.hpp"
#include "interaction/places.hpp"
#include "interaction/role_play.hpp"
#include "interaction/sightings.hpp"
#include "skein/negotiation/joint_task_status.hpp"

namespace skein::decision_node {

class Interaction;
class JointTask;

/// The message to a role that a member left, or is lost.
inline constexpr const char* kMemberLost = "member lost";

/// The holders of the roles of a joint task, and this UAV's phase in it.
struct Membership {
  Joint joint;
  interaction::JointPhase phase = interaction::JointPhase::kLoading;
  std::string why = {};
  Holders holders = {};
  std::string allocation = {};  ///< the session in which the roles were agreed

  /// The parties of a coordination action: `self`, which plays `role`, and all holders of roles
  /// that share the action, by name.
  std::vector<std::string> parties_of(const std::string& role, const std::string& action,
                                      const std::string& self) const;
};

/// Around a role that is played. References that must outlive it.
struct PlaySurroundings {
  JointHost& host;
  Interaction& interaction;
  const Sightings& sightings;
  JointTask& task;
  Membership& my;
};

/// The course of a role: inputs for its automaton, and its tasks.
class RoleCourse {
 public:
  RoleCourse() = default;
  RoleCourse(const RoleCourse&) = delete;
  RoleCourse& operator=(const RoleCourse&) = delete;
  virtual ~RoleCourse() = default;

  /// Precondition: a role has begun.
  virtual RolePlay& play() = 0;
  virtual Outlook outlook() const = 0;
  /// Queues an input for the role, behind those already queued.
  virtual void tell(const interaction::Input& input) = 0;
  /// Gives the executive a task of the role, which looks `along` a flight; returns its id.
  virtual executive::TaskId give(const std::string& componel, executive::Task task,
                                 std::optional<executive::TaskId> along = {}) = 0;
  /// Ends a componel whose task cannot be carried out.
  virtual void fail(const std::string& componel, const std::string& why) = 0;

  void tell_status(const std::string& componel, interaction::Status::Word word) {
    tell(interaction::Status{componel, word});
  }
};

}  // namespace skein::decision_node
