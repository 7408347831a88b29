// SPDX-License-Identifier: Apache-2.0
// The way-point graph over voxels, in whole numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// Costs are whole numbers, so that sums are exact and a queue of buckets can order them. Lengths
/// in units of which a voxel is 478 wide: between opposite facets 478, between adjacent ones 338,
/// whose ratio is sqrt(1/2) but for 8.8e-6 of it.
struct FacetCosts {
  static constexpr std::int64_t kOpposite = 478;
  static constexpr std::int64_t kAdjacent = 338;
  static constexpr std::int64_t kToCentre = kOpposite / 2;
};

/// The six facets of a voxel, by axis, lower before upper: 0 and 1 look west and east.
using Facet = unsigned;
constexpr Facet opposite(Facet facet) { return facet ^ 1U; }
constexpr std::size_t axis_of(Facet facet) { return facet >> 1U; }
constexpr bool is_upper(Facet facet) { return (facet & 1U) != 0; }
constexpr std::int32_t outward(Facet facet) { return is_upper(facet) ? 1 : -1; }

inline world::Voxel beyond(world::Voxel voxel, Facet facet) {
  voxel[axis_of(facet)] += outward(facet);
  return voxel;
}

/// A facet with the voxel that it leads into.
struct Passage {
  world::Voxel into{};
  Facet facet = 0;  ///< of that voxel
};

/// 20 bits for each coordinate (world::kMostVoxelsAlong) and 3 for the facet.
constexpr std::uint64_t packed(const Passage& passage) {
  return static_cast<std::uint64_t>(passage.into[0]) |
         static_cast<std::uint64_t>(passage.into[1]) << 20U |
         static_cast<std::uint64_t>(passage.into[2]) << 40U |
         static_cast<std::uint64_t>(passage.facet) << 60U;
}
constexpr Passage unpacked(std::uint64_t word) {
  const auto coordinate = [&](unsigned shift) {
    return static_cast<std::int32_t>(word >> shift & 0xFFFFFU);
  };
  return {{coordinate(0), coordinate(20), coordinate(40)}, static_cast<Facet>(word >> 60U)};
}

/// What the least costly way to the centre of a voxel would be, were all free at the least crossing
/// cost. Exact there, so consistent: with offsets a >= b >= c it takes b + c steps between adjacent
/// facets and a - b - c between opposite ones, or only adjacent ones when a < b + c.
class FacetHeuristic {
 public:
  FacetHeuristic(const world::Voxel& goal, std::int64_t least_cost) : scale_(least_cost) {
    for (std::size_t i = 0; i < 3; ++i) goal_[i] = 2 * std::int64_t{goal[i]} + 1;
  }
  std::int64_t operator()(const world::Voxel& voxel, Facet facet) const {
    std::array<std::int64_t, 3> at = {2 * std::int64_t{voxel[0]} + 1,
                                      2 * std::int64_t{voxel[1]} + 1,
                                      2 * std::int64_t{voxel[2]} + 1};
    at[axis_of(facet)] += outward(facet);
    return from(at);
  }
  /// Of the point at those half voxels from the corner of the grid.
  std::int64_t from(const std::array<std::int64_t, 3>& at) const {
    const std::int64_t x = std::abs(at[0] - goal_[0]), y = std::abs(at[1] - goal_[1]);
    const std::int64_t z = std::abs(at[2] - goal_[2]);
    const std::int64_t sum = x + y + z, longest = std::max({x, y, z});
    constexpr std::int64_t kDiagonal = FacetCosts::kAdjacent / 2;
    constexpr std::int64_t kStraight = FacetCosts::kToCentre - kDiagonal;
    return scale_ * (kDiagonal * sum + kStraight * std::max<std::int64_t>(0, 2 * longest - sum));
  }

 private:
  std::array<std::int64_t, 3> goal_{};
  std::int64_t scale_;
};

}  // namespace skein::refiners
