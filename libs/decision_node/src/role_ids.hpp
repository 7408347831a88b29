// SPDX-License-Identifier: Apache-2.0
// Which tasks belong to roles of joint tasks.
#pragma once

#include "skein/functional/task.hpp"

namespace skein::decision_node {

/// Whether the task is of a role, played by the ground station or by the UAV itself.
inline bool is_of_role(functional::TaskId id) {
  return id >= functional::kFirstPlayedId && id < functional::kFirstOwnId;
}

}  // namespace skein::decision_node
