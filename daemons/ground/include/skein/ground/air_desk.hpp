// SPDX-License-Identifier: Apache-2.0
// The ground station as witness of plan merging.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/merging/witness.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"

namespace skein::ground {

/// Answers requests of UAVs for air (merging::Witness), so that no UAV waits for another that is
/// dead, late or cut off. Source: docs/decisions/0052-two-of-three.md.
class AirDesk {
 public:
  /// `roster` outlives this object. Without members all inputs are ignored.
  AirDesk(const node::Roster& roster, const std::vector<std::string>& members);

  /// Handles an input. Nothing: the input is not for plan merging, or others need it too.
  std::optional<node::Effects> hear(const node::Input& input, MissionTime now);

 private:
  const node::Roster& roster_;
  merging::Witness witness_;
};

}  // namespace skein::ground
