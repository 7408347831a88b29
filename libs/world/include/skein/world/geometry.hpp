// SPDX-License-Identifier: Apache-2.0
// Points and polygons in the scenario's local frame.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace skein::world {

/// East, north [m], local ENU.
using Vector2 = Eigen::Vector2d;
/// East, north, up [m], local ENU; velocities [m/s] in the same frame.
using Vector3 = Eigen::Vector3d;

/// Corners in order, either sense, last joined to first; simple (no crossing edges).
using Polygon = std::vector<Vector2>;

/// The same angle in (-π, π] [rad].
double wrapped(double angle);

/// The unit vector that looks along `heading` (ENU, counter-clockwise from east) and `pitch` (up
/// from the horizon; straight down is -π/2) [rad].
Vector3 direction_of(double heading, double pitch);

/// True inside and on the edges. Cost: O(corners).
bool contains(const Polygon& polygon, const Vector2& point);

/// [m²], never negative; 0 with fewer than three corners.
double area(const Polygon& polygon);

}  // namespace skein::world
