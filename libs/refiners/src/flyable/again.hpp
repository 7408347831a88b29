// SPDX-License-Identifier: Apache-2.0
// A way that can be flown, made shorter.
#pragma once

#include "flyable/leg.hpp"

namespace skein::refiners {

/// As asked for [rad]; absent: any.
struct EndHeadings {
  std::optional<double> from, to;
};

/// The way again through places along itself, leaving out as many as makes it shortest: circles
/// whose climb is not needed, turns that another leg has no need of. Never longer; its ends stay,
/// and the headings asked for there.
Way flown_again(const Way& way, FlyableLegs& legs, double radius, const EndHeadings& headings);

/// Points of a way that stand closer than `least` [m] to the one before are left out where the leg
/// between their neighbours is free and what is left can be flown; where not, they are moved apart.
/// The ends stay.
Way without_tiny_legs(const Way& way, double least, double radius,
                      const FlyableLegs::IsFree& is_free,
                      const std::function<bool(const Way&)>& is_flyable);

}  // namespace skein::refiners
