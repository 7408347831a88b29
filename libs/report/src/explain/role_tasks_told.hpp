// SPDX-License-Identifier: Apache-2.0
// Elementary tasks that roles of joint tasks requested: role, block, condition, and outcome.
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
  std::uint64_t of = 0;  ///< id of the plan's task that stands for the joint task
  std::string joint, role, componel, block;
  std::string because;                  ///< the condition under which the block began; empty: none
  double asked = 0.0;                   ///< when the role requested the task [s]
  std::optional<double> started, over;  ///< [s]
  std::string outcome, reason;          ///< from the UAV's executive
};

/// Of all UAVs, in the order of the requests. Precondition: the journal is in time order.
std::vector<RoleTaskStory> tell_role_tasks(const Journal& journal);

void write_role_task(std::ostream& out, const RoleTaskStory& story);

}  // namespace skein::report
