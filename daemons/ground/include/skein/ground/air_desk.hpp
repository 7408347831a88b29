// SPDX-License-Identifier: Apache-2.0
// The ground station as the third of any two UAVs that merge their ways.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/merging/witness.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"

namespace skein::ground {

/// Answers UAVs that ask for air (merging::Witness), so that none waits for another that is dead,
/// late or cut off. Source: docs/decisions/0052-two-of-three.md.
class AirDesk {
 public:
  /// `roster` outlives it. Without members nothing is done with what comes.
  AirDesk(const node::Roster& roster, const std::vector<std::string>& members);

  /// Nothing: what came is not for it, or not for it alone.
  std::optional<node::Effects> hear(const node::Input& input, MissionTime now);

 private:
  const node::Roster& roster_;
  merging::Witness witness_;
};

}  // namespace skein::ground
