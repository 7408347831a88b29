// SPDX-License-Identifier: Apache-2.0
// Path planning over the voxels of the airspace: the way-point graph of the thesis, searched by A*,
// with the result pulled straight.
#pragma once

#include <cstdint>

#include "skein/refiners/path.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// Result of a search of the graph. The graph: nodes at the centres of voxel facets, edges
/// between the facets of one voxel, labelled with length × crossing cost of that voxel; and from
/// the centres of the first and the last voxel to their facets. Source: spec 4.1, T IV.2.2.
struct GraphWay {
  bool found = false;
  double cost = 0;  ///< [m × cost], from the centre of the first voxel to that of the last
  Way way;          ///< facet centres, with the two voxel centres at the ends
  std::uint64_t expanded = 0;  ///< nodes
  bool out_of_budget = false;  ///< no path found, but there may be one
  bool cut_short = false;      ///< the clock ended the search
};

/// The least costly path between two voxels: that of a Dijkstra search on the same graph, to 1e-5
/// of the cost (edge lengths are integers, with a ratio of sqrt(1/2) to 8.8e-6). A* with a
/// consistent heuristic. Steps of the budget: nodes expanded. Memory: 8 bytes for each voxel of the
/// blocks of 8³ that are reached, and some 16 for each node of the front. Precondition: both voxels
/// are free.
GraphWay search_graph(const world::Airspace& airspace, const world::Voxel& from,
                      const world::Voxel& to, const Budget& budget);

/// The path with corners removed, moved and cut wherever the straight line is free and costs less;
/// never more costly, with the same ends. When the time of the budget is up, returns the result so
/// far.
/// Cost: some 10 ms for 300 way-points over 300 voxels.
Way pull_straight(const world::Airspace& airspace, const Way& way, const Budget& budget = {});

/// The cheaper of two paths, both pulled straight: the least costly one on the graph, and an
/// any-angle path (the graph overestimates lengths by up to 22 % depending on direction, so that
/// its best path may pass an obstacle on the wrong side).
struct VoxelWay {
  bool found = false;
  double graph_cost = 0;       ///< of the least costly path of the graph [m × cost]
  Way way;                     ///< the cheaper path, between the two places
  Way graph_way;               ///< the path of the graph, pulled straight
  double cost = 0;             ///< integral of the crossing cost along `way` [m × cost]
  Effort effort;               ///< nodes expanded by both searches
  bool out_of_budget = false;  ///< no path found, but there may be one
};
/// Extent of the search.
enum class WaySearch : std::uint8_t {
  kThorough,  ///< the graph of the thesis and an any-angle search
  kQuick,     ///< only the any-angle search: half the time, no `graph_cost`, `graph_way` is `way`
};
/// Precondition: both places are free. Steps of the budget: nodes expanded. Memory: that of the
/// larger of both searches, 8 bytes for each voxel reached.
VoxelWay find_way(const world::Airspace& airspace, const world::Vector3& from,
                  const world::Vector3& to, const Budget& budget,
                  WaySearch search = WaySearch::kThorough);

/// The airspace that is free for this query, given clearance, the vehicle's body and ceiling,
/// no-fly and reserved volumes, and radio contact (a voxel is free only if a single node has a link
/// to all of its points, computed exactly, not by sampling). `flight`: the longest possible flight.
/// A volume with a time window is closed for the whole query if its window overlaps that time.
/// Refused: an invalid query.
Result<world::Airspace, Refusal> airspace_of(const PathQuery& query, const Setting& setting,
                                             Duration flight = Duration::max());

/// Path planning on voxels (find_way), made flyable for the vehicle.
///
/// Refused: as airspace_of; an end in closed air (kBlocked, kNoContact, or kBeyondVehicle if the
/// ceiling or the vehicle closes it); no path (kUnreachable; kNoContact if there is one without
/// contact); more energy than the reserve permits, no flyable path, too strong a wind
/// (kBeyondVehicle); kBudgetExhausted.
///
/// A free place in a voxel that is not free is joined to the graph through voxels of an eighth of
/// the side around it.
///
/// Time windows: planned first with the volumes that can be met in the time of the straight flight,
/// then again as long as the path found takes long enough to meet further ones. The result is clear
/// of each volume during its window; the search is conservative, so a flight that would just have
/// been in time may be refused.
class VoxelPathPlanner final : public PathPlanner {
 public:
  VoxelPathPlanner() = default;
  /// Plans in the given airspace instead of building one for each query (which takes longer than
  /// most searches), for services with many queries. Precondition: `airspace` is from airspace_of
  /// for the same world, vehicle, clearance, reserved volumes and contact as the queries, and
  /// outlives the planner. Its volumes are closed whatever the departure of a query.
  explicit VoxelPathPlanner(const world::Airspace& airspace,
                            WaySearch search = WaySearch::kThorough)
      : airspace_(&airspace), search_(search) {}
  explicit VoxelPathPlanner(world::Airspace&&, WaySearch = WaySearch::kThorough) = delete;

  Outcome<Path> plan(const PathQuery& query, const Setting& setting) const override;

 private:
  const world::Airspace* airspace_ = nullptr;
  WaySearch search_ = WaySearch::kThorough;
};

}  // namespace skein::refiners
