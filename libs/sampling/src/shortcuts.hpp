// SPDX-License-Identifier: Apache-2.0
// Crooked ways made shorter.
#pragma once

#include <functional>

#include "skein/foundation/random.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::sampling {

/// Points of the way, corners or in between, are joined directly wherever that is free, until
/// `tries` in a row gain nothing or `is_over` says so; then corners are pulled tight. Never longer;
/// the ends stay.
refiners::Way shortened(
    const refiners::Way& way,
    const std::function<bool(const world::Vector3&, const world::Vector3&)>& is_free,
    const std::function<bool()>& is_over, Random& random, int tries = 40);

}  // namespace skein::sampling
