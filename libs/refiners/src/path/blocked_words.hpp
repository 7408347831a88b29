// SPDX-License-Identifier: Apache-2.0
// One word for each voxel of a grid, without memory for the parts that are never used.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// Voxels lie in blocks of 8 × 8 × 8, one page of memory, and the system gives the pages of a large
/// allocation only when they are first written. All zero at first.
class BlockedWords {
 public:
  explicit BlockedWords(const world::AirspaceGrid& grid);

  /// False when there was no memory for it.
  bool usable() const { return words_ != nullptr; }
  std::uint64_t& at(const world::Voxel& voxel) { return words_.get()[offset(voxel)]; }
  std::uint64_t at(const world::Voxel& voxel) const { return words_.get()[offset(voxel)]; }

 private:
  struct Free {
    void operator()(std::uint64_t* words) const { std::free(words); }
  };

  std::size_t offset(const world::Voxel& voxel) const {
    return offsets_[0][static_cast<std::size_t>(voxel[0])] +
           offsets_[1][static_cast<std::size_t>(voxel[1])] +
           offsets_[2][static_cast<std::size_t>(voxel[2])];
  }

  std::array<std::vector<std::size_t>, 3> offsets_;  // in words, along each axis
  std::unique_ptr<std::uint64_t, Free> words_;
};

}  // namespace skein::refiners
