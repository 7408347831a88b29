// SPDX-License-Identifier: Apache-2.0
// Ways over the voxels of the airspace: the way-point graph of the thesis, searched by A*, then
// pulled straight.
#pragma once

#include <cstdint>

#include "skein/refiners/path.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// What a search of the graph came to. The graph: nodes at the centres of voxel facets, edges
/// between the facets of one voxel, labelled with length × crossing cost of that voxel; and from
/// the centres of the first and the last voxel to their facets. Source: spec 4.1, T IV.2.2.
struct GraphWay {
  bool found = false;
  double cost = 0;  ///< [m × cost], from the centre of the first voxel to the last one's
  Way way;          ///< facet centres, with the two voxel centres at the ends
  std::uint64_t expanded = 0;  ///< nodes
  bool out_of_budget = false;  ///< not found, and there may be a way
  bool cut_short = false;      ///< out of budget by the clock
};

/// The least costly way between two voxels: as a Dijkstra search on the same graph, within 1e-5 of
/// the cost (it sums whole numbers whose ratio is sqrt(1/2) within 8.8e-6). A* with a consistent
/// heuristic. Steps of the budget: nodes expanded. Memory: 8 bytes for each voxel of the blocks of
/// 8³ that are reached, and some 16 for each node of the front. Precondition: both voxels are free.
GraphWay search_graph(const world::Airspace& airspace, const world::Voxel& from,
                      const world::Voxel& to, const Budget& budget);

/// The same way with corners left out, moved and cut wherever the straight line is free and costs
/// less; never dearer. Ends stay. Stops early, with what it has, when the time of the budget is up.
/// Cost: some 10 ms for 300 way-points over 300 voxels.
Way pull_straight(const world::Airspace& airspace, const Way& way, const Budget& budget = {});

/// The cheaper of the graph's least costly way and of one whose legs may have any direction (the
/// graph measures lengths by its own directions, up to 22 % too long, so that its best way may pass
/// on the wrong side of things), both pulled straight.
struct VoxelWay {
  bool found = false;
  double graph_cost = 0;       ///< of the least costly way of the graph [m × cost]
  Way way;                     ///< from the one place to the other
  Way graph_way;               ///< of the graph, pulled straight
  double cost = 0;             ///< integral of the crossing cost along `way` [m × cost]
  Effort effort;               ///< nodes expanded by both searches
  bool out_of_budget = false;  ///< not found, and there may be a way
};
/// How much is searched for a way.
enum class WaySearch : std::uint8_t {
  kThorough,  ///< the graph of the thesis, and ways of any direction
  kQuick,     ///< the latter alone, half as long: no `graph_cost`, and `graph_way` is `way`
};
/// Precondition: both places are free. Steps of the budget: nodes expanded. Memory: the greater of
/// what the two searches take, 8 bytes for each voxel reached.
VoxelWay find_way(const world::Airspace& airspace, const world::Vector3& from,
                  const world::Vector3& to, const Budget& budget,
                  WaySearch search = WaySearch::kThorough);

/// The airspace as this query may use it: ground with clearance, the vehicle's body and ceiling,
/// volumes and reserved ones, radio contact (a voxel is closed unless one and the same of the
/// places to talk to has a link to all of its points, which is found exactly, not by samples).
/// `flight`: how long the vehicle flies at most. Of the volumes with a time window those count that
/// it can meet in that time, however fast it comes and however late it leaves; and they count from
/// beginning to end. Refused: a query that makes no sense.
Result<world::Airspace, Refusal> airspace_of(const PathQuery& query, const Setting& setting,
                                             Duration flight = Duration::max());

/// Refused: as airspace_of; ends in closed air (kBlocked, kNoContact, kBeyondVehicle: where the
/// ceiling or the vehicle is what closes it); no way (kUnreachable; kNoContact where there is one
/// without contact); more energy than the reserve leaves, no flyable way, a wind too strong
/// (kBeyondVehicle); kBudgetExhausted.
///
/// A place that is free though its voxel is not joins the graph through voxels of an eighth of the
/// side around it.
///
/// Time windows: first with the volumes that count in the straight flight, then, as long as the way
/// found can take so long that others count, with these too. So the way given is clear of all
/// volumes at all times, and a refusal may be of a flight that would have been in time by luck.
class VoxelPathPlanner final : public PathPlanner {
 public:
  VoxelPathPlanner() = default;
  /// Through that airspace, instead of one built for each query (which takes longer than most
  /// searches): for services that ask for many ways. It comes from airspace_of, for a query with
  /// the same vehicle, clearance, reserved volumes and contact in the same world, and must outlive
  /// the planner. The volumes it has count whenever a query departs.
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
