// SPDX-License-Identifier: Apache-2.0
// Areas of the members in a balanced partition.
#pragma once

#include <optional>
#include <vector>

namespace skein::refiners::partition {

/// Sweeping capacity of one member.
struct Ability {
  double rate = 0;   ///< swept per second [m²/s], > 0
  double ready = 0;  ///< time before it begins to sweep [s]
  double limit = 0;  ///< largest area that its energy permits [m²]
};

/// Areas [m²] that add up to `area`, each in proportion to the time left from `ready` to a common
/// end, at most its limit, and at least `kLeastPart` of its area if all were ready at once, so that
/// every member has a part. Nothing if the limits do not add up to the area.
std::optional<std::vector<double>> fair_areas(const std::vector<Ability>& abilities, double area);

inline constexpr double kLeastPart = 0.01;

}  // namespace skein::refiners::partition
