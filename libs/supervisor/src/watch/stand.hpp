// SPDX-License-Identifier: Apache-2.0
// Where the vehicle waits, and where a task of its plan keeps it.
#pragma once

#include <optional>

#include "book/book.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

/// The place that a vehicle that cannot hover circles around: the end of its last motion, if it is
/// near that; at its own height if it got out of the way of others upwards or downwards. Absent for
/// a vehicle that hovers, flies along a way, or is on the ground.
std::optional<world::Vector3> circled(const Book& book, const Beliefs& beliefs);

/// Whether a vehicle that cannot hover was stopped in its last motion: it circles where that was,
/// and nobody knows around what. It may be a circle's width from where it is.
bool was_stopped(const Book& book, const Beliefs& beliefs);

/// circled(), else the vehicle's position [m, ENU].
world::Vector3 place_of_vehicle(const Book& book, const Beliefs& beliefs);

/// Where the vehicle is during the task: the end of the last way before it [m, ENU]. Absent if it
/// is on the ground then, or if the task has a way or runs along with a flight.
std::optional<world::Vector3> stand_of(const Entry& entry, const Book& book,
                                       const Beliefs& beliefs);

}  // namespace skein::supervisor
