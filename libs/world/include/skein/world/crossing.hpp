// SPDX-License-Identifier: Apache-2.0
// Does a way go through a closed volume?
#pragma once

#include <vector>

#include "skein/world/volume.hpp"

namespace skein::world {

/// True when the straight segment comes closer than `margin` [m] to the volume: horizontally to
/// its polygon where it is between floor and ceiling, both widened by the margin. A volume whose
/// window does not matter here is the caller's business. Cost: O(corners).
bool crosses(const Volume& volume, double margin, const Vector3& from, const Vector3& to);

/// Any piece of the way, or its only point.
bool crosses(const Volume& volume, double margin, const std::vector<Vector3>& way);

/// What is left of a way for who is at `position`: from there to the end of the nearest piece, and
/// on.
std::vector<Vector3> rest_of(const std::vector<Vector3>& way, const Vector3& position);

}  // namespace skein::world
