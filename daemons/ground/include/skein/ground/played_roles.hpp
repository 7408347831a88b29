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

/// One stand-in for each UAV, with samples and records around it. What it says goes to the UAV's
/// decision node, which passes it on to partners and back: see decision_node/src/interaction/voice.
class PlayedRoles {
 public:
  using Control = ground_station::GroundControl::Input;
  /// What is to be sent and logged, and what GroundControl is to be told.
  struct Outcome {
    node::Effects out;
    std::vector<Control> control;
  };

  /// Of each UAV for which a model lets the ground play some role.
  PlayedRoles(std::vector<decision_node::Config> uavs, const node::Roster& roster);

  /// Of a UAV for which nothing can be played nothing follows.
  Outcome tell(const std::string& uav, const decision_node::StandInInput& input, MissionTime now);
  /// A sample of a decision node: what it passes on of partners, its telemetry, its tasks. Nothing:
  /// it is for others, or for others too.
  struct Heard {
    Outcome outcome;
    bool only_here = false;
  };
  Heard hear(const std::string& uav, const wire::Sample& sample, MissionTime now);
  /// Instants that have come.
  Outcome time_passes(MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

 private:
  Outcome outcome_of(const std::string& uav, const decision_node::StandInEffects& effects,
                     MissionTime now) const;

  node::Roster roster_;
  std::map<std::string, decision_node::StandIn> uavs_;
};

}  // namespace skein::ground
