// SPDX-License-Identifier: Apache-2.0
// Shortens a flyable path.
#pragma once

#include "flyable/leg.hpp"
#include "skein/refiners/flyable.hpp"

namespace skein::refiners {

/// Required headings at the ends [rad]; absent: any.
struct EndHeadings {
  std::optional<double> from, to;
};

/// Replans the path through a subset of its own points so that it becomes shortest: drops circles
/// whose climb is not needed, and unnecessary turns. Passes its points lower, down to the floor,
/// where there is one. Never longer; keeps the ends and the required headings.
Way flown_again(const Way& way, FlyableLegs& legs, const FlightLimits& limits,
                const EndHeadings& headings, const Floor& floor);

/// Removes points closer than `least` [m] to the previous one if the leg between their neighbours
/// is free and the rest flyable; otherwise moves them apart. Keeps the ends.
Way without_tiny_legs(const Way& way, double least, double radius,
                      const FlyableLegs::IsFree& is_free,
                      const std::function<bool(const Way&)>& is_flyable);

}  // namespace skein::refiners
