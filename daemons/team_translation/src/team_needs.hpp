// SPDX-License-Identifier: Apache-2.0
// What tasks of a team need of their members, on the wire.
#pragma once

#include "skein/blackboard/wire_team.hpp"
#include "skein/interaction/requirement.hpp"

namespace skein::translation {

wire::TeamNeed to_wire(const interaction::Requirement& need);
interaction::Requirement from_wire(const wire::TeamNeed& need);

}  // namespace skein::translation
