// SPDX-License-Identifier: Apache-2.0
// Who gets how much of an area.
#pragma once

#include <optional>
#include <vector>

namespace skein::refiners::partition {

/// What one member can do.
struct Ability {
  double rate = 0;   ///< swept per second [m²/s], > 0
  double ready = 0;  ///< before it begins to sweep [s]
  double limit = 0;  ///< the most that its energy lets it sweep [m²]
};

/// Areas [m²] that add up to `area`, each in proportion to the time left from `ready` to a common
/// end, no more than its limit, and at least `kLeastPart` of what it would have with all ready at
/// once, so that everybody has a part. Nothing when the limits do not add up to the area.
std::optional<std::vector<double>> fair_areas(const std::vector<Ability>& abilities, double area);

inline constexpr double kLeastPart = 0.01;

}  // namespace skein::refiners::partition
