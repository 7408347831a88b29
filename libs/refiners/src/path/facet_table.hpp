// SPDX-License-Identifier: Apache-2.0
// The least known cost to each facet of a grid.
#pragma once

#include <cstdint>

#include "path/blocked_words.hpp"
#include "path/facet_graph.hpp"

namespace skein::refiners {

/// Eight bytes a voxel, for its three lower facets: 21 bits each, of which one tells that there is
/// a cost and twenty are the cost modulo 2^20. That is enough, since the costs of two facets of one
/// voxel that are both known never differ by more than three of the dearest steps
/// (3 × 478 × 255 < 2^19) in a search with a consistent heuristic.
class FacetTable {
 public:
  explicit FacetTable(const world::AirspaceGrid& grid) : words_(grid) {}

  bool usable() const { return words_.usable(); }

  /// The cost of a facet of a voxel. Precondition: there is a voxel on both sides.
  class Slot {
   public:
    bool known() const { return (*word_ >> shift_ & kKnown) != 0; }
    /// How much greater the cost kept is than this one. Precondition: known.
    std::int64_t above(std::int64_t cost) const {
      const auto difference = (*word_ >> shift_) - static_cast<std::uint64_t>(cost);
      constexpr std::uint64_t kHalf = kKnown / 2;
      return static_cast<std::int64_t>((difference + kHalf) & kCost) -
             static_cast<std::int64_t>(kHalf);
    }
    void keep(std::int64_t cost) {
      constexpr std::uint64_t kAll = kKnown | kCost;
      *word_ = (*word_ & ~(kAll << shift_)) | (kKnown | (static_cast<std::uint64_t>(cost) & kCost))
                                                  << shift_;
    }

   private:
    friend class FacetTable;
    Slot(std::uint64_t* word, std::size_t axis)
        : word_(word), shift_(static_cast<unsigned>(21 * axis)) {}

    static constexpr std::uint64_t kKnown = 1U << 20U;
    static constexpr std::uint64_t kCost = kKnown - 1;

    std::uint64_t* word_;
    unsigned shift_;
  };

  Slot slot(world::Voxel voxel, Facet facet) {
    voxel[axis_of(facet)] += is_upper(facet) ? 1 : 0;
    return {&words_.at(voxel), axis_of(facet)};
  }

 private:
  BlockedWords words_;
};

}  // namespace skein::refiners
