// SPDX-License-Identifier: Apache-2.0
#include "path/blocked_words.hpp"

#include <algorithm>
#include <bit>

namespace skein::refiners {

BlockedWords::BlockedWords(const world::AirspaceGrid& grid) {
  std::array<unsigned, 3> bits{};  // of the coordinate within a block; fewer where the grid is thin
  std::array<std::size_t, 3> blocks{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto size = static_cast<std::size_t>(grid.size[i]);
    bits[i] = static_cast<unsigned>(std::min(3, static_cast<int>(std::bit_width(size - 1))));
    blocks[i] = (size + (std::size_t{1} << bits[i]) - 1) >> bits[i];
  }
  const std::size_t block = std::size_t{1} << (bits[0] + bits[1] + bits[2]);
  const std::array<std::size_t, 3> block_strides = {block, block * blocks[0],
                                                    block * blocks[0] * blocks[1]};
  const std::array<unsigned, 3> shifts = {0, bits[0], bits[0] + bits[1]};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t at = 0; at < static_cast<std::size_t>(grid.size[i]); ++at)
      offsets_[i].push_back((at >> bits[i]) * block_strides[i] +
                            ((at & ((std::size_t{1} << bits[i]) - 1)) << shifts[i]));
  const std::size_t count = block_strides[2] * blocks[2];
  words_.reset(static_cast<std::uint64_t*>(std::calloc(count, sizeof(std::uint64_t))));
}

}  // namespace skein::refiners
