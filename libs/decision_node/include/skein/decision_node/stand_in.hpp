// SPDX-License-Identifier: Apache-2.0
// Plays a role in joint tasks on behalf of a UAV that does not deliberate.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/decision_node/config.hpp"
#include "skein/decision_node/messages.hpp"

namespace skein::decision_node {

// ---- inputs ----

/// Take part in a joint task, numbered as the task on the UAV's board.
struct PlayJointTask {
  mission::HighLevelTask task;
};
/// Stop playing one joint task, or all; partners are told.
struct StopPlaying {
  std::optional<executive::TaskId> task;
  std::string why;
};
/// The UAV refused a task of the role, or does not answer the request to stop it.
struct TaskRefused {
  executive::TaskId task;
  std::string why;
};
/// An operator declared a partner lost.
struct PartnerLost {
  std::string uav;
};

/// Telemetry is the UAV's own. Messages of partners arrive through the UAV's decision node.
using StandInInput = std::variant<PlayJointTask, StopPlaying, TaskRefused, executive::TaskEvent,
                                  world::Telemetry, PartnerSeen, JointTaskTold,
                                  interaction::SessionMessage, PlaceTold, PartnerLost, Tick>;

/// Requests to the UAV's executive, state changes of the joint tasks (running, ended, aborted), and
/// effects of a decision node: SendNegotiation, JointTaskChanged and journal notes.
struct StandInEffects {
  std::vector<mission::Request> asked;
  std::vector<executive::TaskEvent> changed;
  Effects said;
};

/// Does at the ground station, for a UAV at a degree below 4, what a decision node does with joint
/// tasks: the same interaction manager negotiates in that UAV's name and plays its role. It offers
/// only roles that the model lets the ground play. The tasks of a role are requests to the UAV's
/// executive, numbered from kFirstPlayedId on by the millisecond of the mission. A node that is not
/// heard for 5 s counts as out of reach, so a UAV that is itself out of reach loses all partners.
///
/// `now` never decreases. Deterministic. Not safe to share between threads.
/// Source: T II.2, IV.3, V; spec 1.2, 7.3.
class StandIn {
 public:
  static constexpr executive::TaskId kFirstPlayedId = functional::kFirstPlayedId;

  /// Uses of the UAV's Config: name, `others`, knowledge, world and interaction, none of them null.
  explicit StandIn(Config uav);
  ~StandIn();
  StandIn(StandIn&&) noexcept;
  StandIn& operator=(StandIn&&) noexcept;

  StandInEffects handle(const StandInInput& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  /// Whether any joint task is loading or being played.
  bool plays() const;
  /// Whether this joint task is.
  bool plays(executive::TaskId task) const;

 private:
  class Host;
  std::unique_ptr<Host> host_;
};

}  // namespace skein::decision_node
