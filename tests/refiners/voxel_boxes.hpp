// SPDX-License-Identifier: Apache-2.0
// The blocked voxels of an airspace as boxes of FCL, for tests.
#pragma once

#include <memory>

#include "skein/refiners/flight.hpp"
#include "skein/world/airspace.hpp"

namespace skein::sampling {

class VoxelBoxes {
 public:
  explicit VoxelBoxes(const world::Airspace& airspace);
  ~VoxelBoxes();

  /// Whether a leg goes deeper than kHair into a blocked voxel, or leaves the grid.
  bool meets(const refiners::Way& way) const;

  static constexpr double kHair = 1e-4;  ///< [voxels]

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace skein::sampling
