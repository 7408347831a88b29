// SPDX-License-Identifier: Apache-2.0
// Ways to cut a convex piece in three by rays from one of its anchors.
#pragma once

#include <array>
#include <vector>

#include "partition/splits.hpp"

namespace skein::refiners::partition {

using Fan = std::array<Piece, 3>;

/// For anchors so far inside that no straight cut leaves every one its share: three UAVs that start
/// together in the middle, for instance. Three rays from an anchor, no two of them more than half a
/// turn apart, with the right area and the right anchors between them; a choice of those that there
/// are. Cost: O(n⁴ v) for n anchors and v corners; nothing for fewer than three anchors.
std::vector<Fan> fans_of(const Piece& piece, const Claims& claims);

}  // namespace skein::refiners::partition
