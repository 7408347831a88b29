// SPDX-License-Identifier: Apache-2.0
// Cuts of a convex piece into three parts by rays from one of its anchors.
#pragma once

#include <array>
#include <vector>

#include "partition/splits.hpp"

namespace skein::refiners::partition {

using Fan = std::array<Piece, 3>;

/// For anchors so far inside that no straight cut gives each its share, as for three UAVs that
/// start together in the middle. Three rays from an anchor, neighbours at most half a turn apart,
/// with the right areas and anchors between them; a selection of the existing ones. Cost: O(n⁴ v)
/// for n anchors and v corners; nothing for fewer than three anchors.
std::vector<Fan> fans_of(const Piece& piece, const Claims& claims);

}  // namespace skein::refiners::partition
