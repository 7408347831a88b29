// SPDX-License-Identifier: Apache-2.0
// Cutting convex polygons [m, ENU].
#pragma once

#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::decision_node {

/// An area that is none [m²].
inline constexpr double kNoArea = 1;

/// The part of a convex polygon in which `lowest` <= its distance along `normal` <= `highest`.
world::Polygon between(const world::Polygon& polygon, const world::Vector2& normal, double lowest,
                       double highest);

/// The area that two convex polygons have in common [m²].
double common_area(const world::Polygon& one, const world::Polygon& other);

/// Cuts a polygon, with `margin` [m] around it, out of convex `areas`, which are what lies beside
/// it then, in convex pieces; appends what lies in it to `within`. One that is not convex counts as
/// its bounding box.
void cut_out(const world::Polygon& hole, double margin, std::vector<world::Polygon>& areas,
             std::vector<world::Polygon>& within);

}  // namespace skein::decision_node
