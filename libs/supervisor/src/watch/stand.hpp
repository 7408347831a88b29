// SPDX-License-Identifier: Apache-2.0
// Where the vehicle keeps itself, and where a task of its plan would keep it.
#pragma once

#include <optional>

#include "book/book.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

/// What one that cannot hover circles over: where its last motion led, while it is near that.
std::optional<world::Vector3> circled(const Book& book, const Beliefs& beliefs);

/// The middle of its circle, else where it is.
world::Vector3 place_of_vehicle(const Book& book, const Beliefs& beliefs);

/// Where the task keeps it: the end of the last way before it. Nothing on the ground, and of what
/// rides along with a flight.
std::optional<world::Vector3> stand_of(const Entry& entry, const Book& book,
                                       const Beliefs& beliefs);

}  // namespace skein::supervisor
