// SPDX-License-Identifier: Apache-2.0
// The spatial constraints of the scenario's interaction models by role and block, for the map.
#pragma once

#include <nlohmann/json.hpp>

#include "skein/interaction/model.hpp"

namespace skein::ground_setup {

/// By model and variant: `arguments` (its parameters in the order of a joint task's subject, lists
/// of UAVs left out), `roles`, and `constraints`: each SCM of each role with the blocks in which it
/// applies and what it says, in words of the variant (a parameter, a role, "R*" or a name) and
/// numbers [m] or [rad].
nlohmann::ordered_json joint_constraints(const interaction::Library& library);

}  // namespace skein::ground_setup
