// SPDX-License-Identifier: Apache-2.0
// Intersection of ways with closed volumes.
#pragma once

#include <vector>

#include "skein/world/volume.hpp"

namespace skein::world {

/// True when the straight segment comes closer than `margin` [m] to the volume: horizontally to
/// its polygon where it is between floor and ceiling, both widened by the margin. A volume whose
/// window does not matter here is the caller's business. Cost: O(corners).
bool crosses(const Volume& volume, double margin, const Vector3& from, const Vector3& to);

/// The same for any segment of the way, or its only point.
bool crosses(const Volume& volume, double margin, const std::vector<Vector3>& way);

/// The rest of a way for a vehicle at `position`: from there to the end of the nearest segment, and
/// on.
std::vector<Vector3> rest_of(const std::vector<Vector3>& way, const Vector3& position);

}  // namespace skein::world
