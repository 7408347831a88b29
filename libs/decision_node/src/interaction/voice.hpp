// SPDX-License-Identifier: Apache-2.0
// Relays messages of a role that the ground station plays for this UAV.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "component.hpp"
#include "skein/negotiation/joint_task_status.hpp"

namespace skein::decision_node {

class Core;

/// While the ground station plays a role for this UAV, the partners address this node as usual. It
/// passes the ground's messages on to them and theirs about the joint task to the ground, and tells
/// them this UAV's position. When the ground has been silent for a minute, or the contact-loss
/// policy takes over, this node leaves the joint task on behalf of the ground. Tasks of a role that
/// nobody plays any more are aborted: after leaving so, or when a restarted ground station does not
/// know the joint task.
class Voice final : public Component {
 public:
  explicit Voice(Core& core) : core_(core) {}

  void say(const GroundNegotiates& said);
  void say(const GroundPlays& said);
  /// Passes the message on if it is about a joint task that the ground plays; false if it is not.
  bool passes_on(const interaction::SessionMessage& message);
  bool passes_on(const JointTaskTold& told);
  bool passes_on(const PartnerSeen& seen);
  void contact(const Contact& contact);
  /// Whether the ground plays a role for this UAV.
  bool plays() const { return !played_.empty(); }
  /// Leaves all joint tasks played by the ground; partners and the ground are told.
  void give_up(const std::string& why);

  void task_changed(const executive::TaskEvent& event) override;
  void vehicle_told(const world::Telemetry& telemetry) override;
  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;

 private:
  bool is_negotiated_for(const std::string& about) const;
  void abort_begun();

  Core& core_;
  std::map<std::string, interaction::JointTaskStatus> played_;  ///< by subject, until they are over
  std::set<std::string> negotiated_;  ///< subjects of the ground's sessions
  std::map<std::string, interaction::JointTaskStatus> given_up_;  ///< until the ground confirms it
  std::set<executive::TaskId> begun_;        ///< unfinished tasks of roles that the ground started
  std::optional<MissionTime> silent_since_;  ///< of the ground
};

}  // namespace skein::decision_node
