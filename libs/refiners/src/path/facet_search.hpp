// SPDX-License-Identifier: Apache-2.0
// The search of the way-point graph, with what it leaves for other searches.
#pragma once

#include <optional>

#include "path/facet_table.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {

/// How far voxels are from the start of a search of the graph, as far as it came. Only for
/// airspaces with one crossing cost everywhere.
class GraphDistances {
 public:
  /// `cost`: of the way found, in units of FacetCosts. `size`: of the grid.
  GraphDistances(FacetTable table, const world::Voxel& from, const world::Voxel& to,
                 std::int64_t cost, const std::array<std::int32_t, 3>& size)
      : table_(std::move(table)), size_(size), from_start_(from, 1), to_goal_(to, 1), cost_(cost) {}

  /// Along the graph [voxels], but for about one; at least that where the search did not come.
  double from_start(const world::Voxel& voxel);

 private:
  FacetTable table_;
  std::array<std::int32_t, 3> size_;
  FacetHeuristic from_start_, to_goal_;
  std::int64_t cost_;
};

struct GraphSearch {
  GraphWay way;
  std::optional<GraphDistances> distances;  ///< where a way was found, between two voxels
  /// It was found by the search from the goal to the start: the distances are from the goal.
  bool backwards = false;
};

/// As search_graph.
GraphSearch search_graph_widely(const world::Airspace& airspace, const world::Voxel& from,
                                const world::Voxel& to, const Budget& budget);

}  // namespace skein::refiners
