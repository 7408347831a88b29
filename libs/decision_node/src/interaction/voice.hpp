// SPDX-License-Identifier: Apache-2.0
// What the ground station says to other UAVs in this one's name.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "component.hpp"
#include "skein/negotiation/joint_task_status.hpp"

namespace skein::decision_node {

class Core;

/// While the ground station plays a role for this UAV, its partners talk with this node as with any
/// other: what the ground says goes on to them, what they say about the joint task goes to the
/// ground, and they are told where this UAV is. When the ground is not heard for a minute, or the
/// contact-loss policy takes over, this node leaves the joint task in the ground's place. Tasks of
/// a role that nobody plays any more are aborted: of one left so, or of a ground station that was
/// restarted and knows nothing of it.
class Voice final : public Component {
 public:
  explicit Voice(Core& core) : core_(core) {}

  void say(const GroundNegotiates& said);
  void say(const GroundPlays& said);
  /// What is about a joint task that is played here is passed on. False: it is not.
  bool passes_on(const interaction::SessionMessage& message);
  bool passes_on(const JointTaskTold& told);
  bool passes_on(const PartnerSeen& seen);
  void contact(const Contact& contact);
  /// Partners and the ground are told.
  void give_up(const std::string& why);

  void task_changed(const executive::TaskEvent& event) override;
  void vehicle_told(const world::Telemetry& telemetry) override;
  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;

 private:
  bool is_negotiated_for(const std::string& about) const;
  void abort_begun();

  Core& core_;
  std::map<std::string, interaction::JointTaskStatus> played_;  ///< by subject; not over
  std::set<std::string> negotiated_;  ///< subjects of the ground's sessions
  std::map<std::string, interaction::JointTaskStatus> given_up_;  ///< until the ground says so too
  std::set<executive::TaskId> begun_;        ///< of the role, by the ground's requests; not over
  std::optional<MissionTime> silent_since_;  ///< the ground
};

}  // namespace skein::decision_node
