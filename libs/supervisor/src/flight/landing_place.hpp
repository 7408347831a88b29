// SPDX-License-Identifier: Apache-2.0
// Where a UAV can land.
#pragma once

#include <optional>
#include <string>

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Why it cannot land there, with all that it may be off by: the ground (landing_ground.hpp), or a
/// volume of air that is closed at some time of `when` between the ground and where it comes from.
/// Nothing when it can. Cost: of a landing_problem.
std::optional<std::string> landing_problem(const Knowledge& knowledge, const world::World& world,
                                           world::TimeWindow when, const world::Vector3& at);

/// `wanted` itself when it can land there, else the ground nearest to it where it can, of equals
/// that nearest to `from`; nothing within 600 m: nothing. On the ground [m] ENU. Cost: some
/// thousand landing problems at most.
std::optional<world::Vector3> landing_place(const Knowledge& knowledge, const world::World& world,
                                            world::TimeWindow when, const world::Vector3& from,
                                            const world::Vector3& wanted);

}  // namespace skein::supervisor
