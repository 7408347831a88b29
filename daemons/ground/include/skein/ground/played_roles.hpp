// SPDX-License-Identifier: Apache-2.0
// The roles of joint tasks that the ground station plays for UAVs that do not deliberate.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/decision_node/stand_in.hpp"
#include "skein/ground_station/ground_control.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"

namespace skein::ground {

/// One stand-in (decision_node::StandIn) for each UAV, with its samples and records. Its messages
/// go to the UAV's decision node, which forwards them to the partners and their answers back: see
/// decision_node/src/interaction/voice.
class PlayedRoles {
 public:
  using Control = ground_station::GroundControl::Input;
  /// Samples to send, records to log, and inputs for GroundControl.
  struct Outcome {
    node::Effects out;
    std::vector<Control> control;
  };

  /// `uavs`: those for which an interaction model lets the ground station play a role.
  PlayedRoles(std::vector<decision_node::Config> uavs, const node::Roster& roster);

  /// Passes an input to the stand-in of a UAV; no effect for a UAV without stand-in.
  Outcome tell(const std::string& uav, const decision_node::StandInInput& input, MissionTime now);
  /// Tells all that play that an operator declared a partner lost.
  Outcome declare_lost(const std::string& lost, MissionTime now);
  /// Result of a sample of a decision node (forwarded messages of partners, telemetry, tasks).
  /// `only_here`: the sample concerns nothing but played roles.
  struct Heard {
    Outcome outcome;
    bool only_here = false;
  };
  Heard hear(const std::string& uav, const wire::Sample& sample, MissionTime now);
  /// Handles the timers that are due.
  Outcome time_passes(MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

 private:
  Outcome outcome_of(const std::string& uav, const decision_node::StandInEffects& effects,
                     MissionTime now) const;

  node::Roster roster_;
  std::map<std::string, decision_node::StandIn> uavs_;
};

}  // namespace skein::ground
