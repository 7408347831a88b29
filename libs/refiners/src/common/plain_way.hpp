// SPDX-License-Identifier: Apache-2.0
// Removal of repeated points from paths; private.
#pragma once

#include "skein/refiners/flight.hpp"

namespace skein::refiners {

/// Points within this distance [m] count as equal.
inline constexpr double kSamePoint = 1e-6;

/// The path without equal points in succession; its ends are kept. A path that stays at its start
/// becomes a single point.
Way without_repeats(const Way& way);

}  // namespace skein::refiners
