// SPDX-License-Identifier: Apache-2.0
// Tasks that roles of joint tasks asked for: of which role and block, why, and what became of them.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "skein/report/journal.hpp"

namespace skein::report {

struct RoleTaskStory {
  std::string uav;
  std::uint64_t task = 0;
  std::string type;
  std::uint64_t of = 0;  ///< the task of the joint task in the UAV's plan
  std::string joint, role, componel, block;
  std::string because;                  ///< the condition under which the block began; empty: none
  double asked = 0.0;                   ///< [s]
  std::optional<double> started, over;  ///< [s]
  std::string outcome, reason;          ///< as its executive said
};

/// In the order in which they were asked for, of all UAVs. Precondition: the journal is in time
/// order.
std::vector<RoleTaskStory> tell_role_tasks(const Journal& journal);

void write_role_task(std::ostream& out, const RoleTaskStory& story);

}  // namespace skein::report
