// SPDX-License-Identifier: Apache-2.0
// Ways without points that say nothing; private.
#pragma once

#include "skein/refiners/flight.hpp"

namespace skein::refiners {

/// Points that close are one [m].
inline constexpr double kSamePoint = 1e-6;

/// The way with no point twice in succession; its first and last stay as they are. Of a way that
/// stays where it begins, that one point.
Way without_repeats(const Way& way);

}  // namespace skein::refiners
