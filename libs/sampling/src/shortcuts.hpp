// SPDX-License-Identifier: Apache-2.0
// Shortens paths by shortcuts.
#pragma once

#include <functional>

#include "skein/foundation/random.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::sampling {

/// Joins random points of the path (corners or between them) directly where that is free, until
/// `tries` in a row gain nothing or `is_over` returns true; then cuts corners. Never longer; keeps
/// the ends.
refiners::Way shortened(
    const refiners::Way& way,
    const std::function<bool(const world::Vector3&, const world::Vector3&)>& is_free,
    const std::function<bool()>& is_over, Random& random, int tries = 40);

}  // namespace skein::sampling
