// SPDX-License-Identifier: Apache-2.0
// The ground station as the one that says when UAVs come to meet each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"
#include "skein/temporal/team_supervisor.hpp"

namespace skein::ground {

/// The supervisor of CIP, where the scenario has it (`planning: {consistency: cip}`): UAVs tell it
/// the networks of their plans, and it tells each when the others come. Without contact to it a UAV
/// goes on with what it was told last. Source: M 4.1; spec 5.3.
class TemporalDesk {
 public:
  /// `roster` outlives it. Not `supervises`: nothing is done with what comes.
  TemporalDesk(const node::Roster& roster, bool supervises);

  /// Nothing: what came is not for it, or not for it alone.
  std::optional<node::Effects> hear(const node::Input& input, MissionTime now);

 private:
  node::Effects tell(const std::vector<temporal::TeamSupervisor::Word>& words,
                     MissionTime now) const;

  const node::Roster& roster_;
  std::optional<temporal::TeamSupervisor> supervisor_;
};

}  // namespace skein::ground
