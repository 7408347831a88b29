// SPDX-License-Identifier: Apache-2.0
// Roles of joint tasks, played in the name of a UAV that does not deliberate.
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

/// Take part in a joint task; its number is that of the task on the UAV's board.
struct PlayJointTask {
  mission::HighLevelTask task;
};
/// What is played ends here, and partners are told: one joint task, or all.
struct StopPlaying {
  std::optional<executive::TaskId> task;
  std::string why;
};
/// The UAV did not take a task that it was asked for, or does not answer when it is to stop it.
struct TaskRefused {
  executive::TaskId task;
  std::string why;
};

/// Telemetry is the UAV's own. Whatever partners say comes through its decision node.
using StandInInput =
    std::variant<PlayJointTask, StopPlaying, TaskRefused, executive::TaskEvent, world::Telemetry,
                 PartnerSeen, JointTaskTold, interaction::SessionMessage, PlaceTold, Tick>;

/// What it asks of the UAV's executive, what becomes of the joint tasks (running, ended, aborted),
/// and what it says and notes: SendNegotiation, JointTaskChanged and notes of a decision node.
struct StandInEffects {
  std::vector<mission::Request> asked;
  std::vector<executive::TaskEvent> changed;
  Effects said;
};

/// What a decision node does with a joint task, at the ground station for a UAV at a degree below
/// 4: the same interaction manager negotiates in that UAV's name and plays its role. It offers only
/// roles that the model lets the ground play; a role's tasks are requests to the UAV's executive,
/// numbered from kFirstPlayedId on by the millisecond of the mission. Who is not heard for 5 s is
/// out of reach, so a UAV that is itself out of reach loses all its partners.
///
/// `now` never decreases. Deterministic. Not safe to share between threads.
/// Source: T II.2, IV.3, V; spec 1.2, 7.3.
class StandIn {
 public:
  static constexpr executive::TaskId kFirstPlayedId = functional::kFirstPlayedId;

  /// Of the UAV's Config: its name, `others`, knowledge, world and interaction, none of them null.
  explicit StandIn(Config uav);
  ~StandIn();
  StandIn(StandIn&&) noexcept;
  StandIn& operator=(StandIn&&) noexcept;

  StandInEffects handle(const StandInInput& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  /// Some joint task is loading or played.
  bool plays() const;
  /// This one is.
  bool plays(executive::TaskId task) const;

 private:
  class Host;
  std::unique_ptr<Host> host_;
};

}  // namespace skein::decision_node
