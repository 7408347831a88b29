// SPDX-License-Identifier: Apache-2.0
// Whether corners given from outside make a polygon.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "skein/world/geometry.hpp"

namespace skein::world {

/// Most corners of a polygon from outside, so that checking it stays quick.
inline constexpr std::size_t kMostCorners = 2000;
/// Edges closer than this touch, and corners closer than this are one [m].
inline constexpr double kTouching = 1e-6;

/// Why those corners are no simple polygon, as a sentence that counts corners from 1; nothing when
/// they are one: 3 to kMostCorners finite corners, an area, no edges that cross, touch or fold
/// back. Cost: O(corners²), no more than some 20 ms.
std::optional<std::string> problem_of(const Polygon& polygon);

}  // namespace skein::world
