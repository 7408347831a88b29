// SPDX-License-Identifier: Apache-2.0
// The ground station as supervisor of temporal consistency (CIP).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"
#include "skein/temporal/team_supervisor.hpp"

namespace skein::ground {

/// The supervisor of CIP, if the scenario uses it (`planning: {consistency: cip}`): UAVs send the
/// networks of their plans, and it sends each UAV the dates of its partners. Without contact to it
/// a UAV continues with the last dates it received. Source: M 4.1; spec 5.3.
class TemporalDesk {
 public:
  /// `roster` outlives this object. Not `supervises`: all inputs are ignored.
  TemporalDesk(const node::Roster& roster, bool supervises);

  /// Handles an input. Nothing: the input is not for CIP, or others need it too.
  std::optional<node::Effects> hear(const node::Input& input, MissionTime now);

 private:
  node::Effects tell(const std::vector<temporal::TeamSupervisor::Word>& words,
                     MissionTime now) const;

  const node::Roster& roster_;
  std::optional<temporal::TeamSupervisor> supervisor_;
};

}  // namespace skein::ground
