// SPDX-License-Identifier: Apache-2.0
// The claims of M 5.1 as checkable statements about the experiment's figures.
#pragma once

#include <string>
#include <vector>

#include "skein/mastn_experiment/experiment_cells.hpp"

namespace skein::temporal {

enum class ClaimKind {
  kExact,        ///< holds by construction, in every row of both modes; gates
  kStatistical,  ///< holds in the means of mode K, with a margin; gates
  kReported,     ///< not reproduced unconditionally: said, never gates
};
/// "exact", "statistical", "reported".
std::string to_text(ClaimKind kind);

struct Claim {
  ClaimKind kind = ClaimKind::kExact;
  std::string statement;
  bool holds = false;
  std::string evidence;  ///< the figures that decided
};

/// All claims of section 4 of the notes, 4.1 and 4.2 first. A claim about parameter sets that were
/// not measured is left out. Precondition: at least one row.
std::vector<Claim> check_claims(const std::vector<ExperimentRow>& rows);

/// Whether all the claims that gate hold.
bool all_gates_hold(const std::vector<Claim>& claims);

}  // namespace skein::temporal
