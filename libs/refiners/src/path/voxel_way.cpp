// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "common/plain_way.hpp"
#include "path/any_angle_search.hpp"
#include "path/string_puller.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {
namespace {

Budget less(Budget budget, std::uint64_t steps) {
  budget.steps -= std::min(budget.steps, steps);
  return budget;
}

/// Of the second search: the way of the graph is there already.
Budget for_second(const Budget& budget, std::uint64_t steps) {
  constexpr std::uint64_t kMostNodes = 300'000;
  Budget rest = less(budget, steps);
  rest.steps = std::min(rest.steps, kMostNodes);
  return rest;
}

/// Where the graph was searched far and wide, its dead ends would be searched again.
AnyAngleHelp help_of(GraphSearch& searched) {
  constexpr std::uint64_t kWide = 300'000;
  constexpr double kGreed = 1.02;
  if (!searched.distances || searched.way.expanded < kWide) return {.greed = kGreed};
  return {.known = &*searched.distances};
}

}  // namespace

VoxelWay find_way(const world::Airspace& airspace, const world::Vector3& from,
                  const world::Vector3& to, const Budget& budget, WaySearch search) {
  const auto first = airspace.free_voxel_at(from), last = airspace.free_voxel_at(to);
  SKEIN_EXPECTS(first && last);
  const auto with_ends = [&](Way way) {
    if (way.size() == 1) return Way{from, way.front(), to};
    if ((way.front() - from).norm() > kSamePoint) way.insert(way.begin(), from);
    if ((way.back() - to).norm() > kSamePoint) way.push_back(to);
    way.front() = from;
    way.back() = to;
    return way;
  };
  const StringPuller puller(airspace, budget);
  if (search == WaySearch::kQuick) {
    constexpr double kNoBound = 1e15;
    AnyAngleWay any = search_any_angle(airspace, *first, *last, kNoBound, budget);
    VoxelWay found;
    found.found = !any.way.empty();
    found.effort = {any.expanded, any.cut_short || budget.expired()};
    found.out_of_budget = !found.found && (any.cut_short || any.expanded > budget.steps);
    if (!found.found) return found;
    found.way = found.graph_way = puller.pulled(with_ends(std::move(any.way)));
    found.cost = puller.cost(found.way);
    return found;
  }
  GraphSearch searched = search_graph_widely(airspace, *first, *last, budget);
  GraphWay& graph = searched.way;
  VoxelWay found;
  found.found = graph.found;
  found.graph_cost = graph.cost;
  found.effort = {graph.expanded, graph.cut_short};
  found.out_of_budget = graph.out_of_budget;
  if (!found.found) return found;
  found.way = found.graph_way = puller.pulled(with_ends(std::move(graph.way)));
  found.cost = puller.cost(found.way);

  // The other search goes from centre to centre, and is pulled straight afterwards.
  const double bound = 1.02 * found.cost + 2 * airspace.grid().voxel;
  const world::Voxel &begin = searched.backwards ? *last : *first,
                     &end = searched.backwards ? *first : *last;
  AnyAngleWay other = search_any_angle(airspace, begin, end, bound,
                                       for_second(budget, graph.expanded), help_of(searched));
  if (searched.backwards) std::reverse(other.way.begin(), other.way.end());
  found.effort.steps += other.expanded;
  if (!other.way.empty()) {
    Way pulled = puller.pulled(with_ends(std::move(other.way)));
    const double cost = puller.cost(pulled);
    if (cost < found.cost) {
      found.way = std::move(pulled);
      found.cost = cost;
    }
  }
  found.effort.cut_short = other.cut_short || budget.expired();
  return found;
}

}  // namespace skein::refiners
