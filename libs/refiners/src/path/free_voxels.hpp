// SPDX-License-Identifier: Apache-2.0
// Which voxels are free, for the innermost loops of searches.
#pragma once

#include <cstdint>

#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// As Airspace::is_free of a voxel, without a call. The airspace must outlive it unchanged.
class FreeVoxels {
 public:
  explicit FreeVoxels(const world::Airspace& airspace)
      : voxels_(airspace.voxels().data()),
        size_(airspace.grid().size),
        row_(size_[0]),
        layer_(row_ * size_[1]) {}

  bool operator()(const world::Voxel& at) const {
    return is_inside(at) && voxels_[index(at)] != world::Airspace::kBlocked;
  }

  /// Of the 27 voxels around one, itself among them, as bits, the lowest first: x, then y, then z.
  std::uint32_t around(const world::Voxel& at) const {
    std::uint32_t free = 0, bit = 1;
    if (is_inside({at[0] - 1, at[1] - 1, at[2] - 1}) &&
        is_inside({at[0] + 1, at[1] + 1, at[2] + 1})) {
      const std::uint8_t* layer = voxels_ + index({at[0] - 1, at[1] - 1, at[2] - 1});
      for (int z = 0; z < 3; ++z, layer += layer_)
        for (int y = 0; y < 3; ++y)
          for (int x = 0; x < 3; ++x, bit <<= 1U)
            free |= layer[y * row_ + x] != world::Airspace::kBlocked ? bit : 0;
      return free;
    }
    for (std::int32_t z = -1; z <= 1; ++z)
      for (std::int32_t y = -1; y <= 1; ++y)
        for (std::int32_t x = -1; x <= 1; ++x, bit <<= 1U)
          free |= (*this)({at[0] + x, at[1] + y, at[2] + z}) ? bit : 0;
    return free;
  }

 private:
  bool is_inside(const world::Voxel& at) const {
    return at[0] >= 0 && at[1] >= 0 && at[2] >= 0 && at[0] < size_[0] && at[1] < size_[1] &&
           at[2] < size_[2];
  }
  std::int64_t index(const world::Voxel& at) const { return at[2] * layer_ + at[1] * row_ + at[0]; }

  const std::uint8_t* voxels_;
  world::Voxel size_;
  std::int64_t row_, layer_;
};

}  // namespace skein::refiners
