// SPDX-License-Identifier: Apache-2.0
// The search of the way-point graph, with distances for reuse by other searches.
#pragma once

#include <optional>

#include "path/facet_table.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {

/// Distances of voxels from the start of a graph search, where it expanded them. Only for airspaces
/// with a uniform crossing cost.
class GraphDistances {
 public:
  /// `cost`: of the way found, in units of FacetCosts. `size`: of the grid.
  GraphDistances(FacetTable table, const world::Voxel& from, const world::Voxel& to,
                 std::int64_t cost, const std::array<std::int32_t, 3>& size)
      : table_(std::move(table)), size_(size), from_start_(from, 1), to_goal_(to, 1), cost_(cost) {}

  /// Distance along the graph [voxels], to about one voxel; a lower bound where not expanded.
  double from_start(const world::Voxel& voxel);

 private:
  FacetTable table_;
  std::array<std::int32_t, 3> size_;
  FacetHeuristic from_start_, to_goal_;
  std::int64_t cost_;
};

struct GraphSearch {
  GraphWay way;
  std::optional<GraphDistances> distances;  ///< present if a path between two voxels was found
  /// The path was found by the search from the goal to the start: distances are from the goal.
  bool backwards = false;
};

/// Like search_graph, with distances.
GraphSearch search_graph_widely(const world::Airspace& airspace, const world::Voxel& from,
                                const world::Voxel& to, const Budget& budget);

}  // namespace skein::refiners
