// SPDX-License-Identifier: Apache-2.0
// Where a UAV can land.
#pragma once

#include <optional>
#include <string>

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Why the vehicle cannot land at `at`, considering its position errors: the ground
/// (landing_ground.hpp), or a volume that is closed at some time in `when` above that place, up to
/// the height from which the vehicle comes. Absent if it can land. Cost: that of checking the
/// ground.
std::optional<std::string> landing_problem(const Knowledge& knowledge, const world::World& world,
                                           world::TimeWindow when, const world::Vector3& at);

/// The volume that closes the air over a place at some time in `when`, up to the height from which
/// the vehicle comes; null if there is none.
const world::Volume* closed_over(const Knowledge& knowledge, const world::World& world,
                                 world::TimeWindow when, const world::Vector3& at);

/// The landing place nearest to `wanted`, of equally near ones the nearest to `from`; `wanted`
/// itself if the vehicle can land there. Another one is as far from closed air as a way that ends
/// over it must be, if there is such a one. On the ground [m] ENU; absent: none within 600 m. Cost:
/// some thousand calls of landing_problem() at most.
std::optional<world::Vector3> landing_place(const Knowledge& knowledge, const world::World& world,
                                            world::TimeWindow when, const world::Vector3& from,
                                            const world::Vector3& wanted);

}  // namespace skein::supervisor
