// SPDX-License-Identifier: Apache-2.0
// All bounds on when tasks begin, and circles of them that contradict each other.
#pragma once

#include <optional>

#include "skein/auction/catalogue.hpp"

namespace skein::auction {

/// Tasks whose windows, durations and delays leave them no dates, with every bound of the circle;
/// none: there are dates, or no delay has a greatest. Whoever does the tasks; ways take no time.
/// Cost: O(tasks × (tasks + precedences)). Source: Bellman 1958; Ford 1956.
std::optional<Contradiction> tight_circle(const Catalogue& catalogue);

}  // namespace skein::auction
