// SPDX-License-Identifier: Apache-2.0
// A* over the way-point graph.
#include "facet_search.hpp"

#include <bit>
#include <cmath>
#include <numbers>

#include "bucket_queue.hpp"
#include "facet_graph.hpp"
#include "free_voxels.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/refiners/voxel_path_planner.hpp"
#include "voxel_flood.hpp"

namespace skein::refiners {
namespace {

using world::Airspace;
using world::Voxel;

/// One search. A facet is expanded only into the voxel it was reached for: going back into the one
/// it was reached from never pays, since two steps in one voxel cost more than one.
class FacetSearch {
 public:
  FacetSearch(const Airspace& airspace, const Voxel& from, const Voxel& to, const Budget& budget)
      : airspace_(airspace),
        free_(airspace),
        from_(from),
        to_(to),
        even_(airspace.least_cost() == airspace.greatest_cost()),
        heuristic_(to, even_ ? 1 : airspace.least_cost()),
        table_(airspace.grid()),
        queue_(FacetCosts::kOpposite *
               (even_ ? 2 : airspace.least_cost() + airspace.greatest_cost())),
        budget_(budget),
        countdown_(budget) {}

  GraphWay run() {
    GraphWay answer;
    if (!table_.usable()) {
      answer.out_of_budget = true;
      return answer;
    }
    start();
    std::int64_t cost = 0;
    while (!queue_.empty()) {
      const std::uint64_t word = queue_.pop();
      if (word == kArrived) {
        answer.found = true;
        cost_ = queue_.priority();
        trace(cost_ - FacetCosts::kToCentre * crossing_cost(to_), answer);
        break;
      }
      const Passage passage = unpacked(word);
      cost = queue_.priority() - heuristic_(passage.into, passage.facet);
      if (table_.slot(passage.into, passage.facet).above(cost) != 0) continue;
      if (!countdown_.step() || is_hopeless()) break;
      expand(passage, cost);
    }
    answer.expanded = countdown_.steps();
    answer.out_of_budget = countdown_.over();
    answer.cut_short = countdown_.cut_short();
    return answer;
  }

  /// After a run that found a way: what else it knows, once.
  std::optional<GraphDistances> take_distances() {
    if (!even_) return std::nullopt;
    return GraphDistances(std::move(table_), from_, to_, cost_, airspace_.grid().size);
  }

 private:
  static constexpr std::uint64_t kArrived = ~std::uint64_t{0};

  /// In sixteenths; 1 where all crossing costs are the same.
  std::int64_t crossing_cost(const Voxel& voxel) const {
    if (even_) return 1;
    return airspace_.voxels()[airspace_.grid().index(voxel[0], voxel[1], voxel[2])];
  }

  void start() {
    const std::array<std::int64_t, 3> centre = {2 * std::int64_t{from_[0]} + 1,
                                                2 * std::int64_t{from_[1]} + 1,
                                                2 * std::int64_t{from_[2]} + 1};
    queue_.start_at(heuristic_.from(centre));
    const std::int64_t step = FacetCosts::kToCentre * crossing_cost(from_);
    for (Facet facet = 0; facet < 6; ++facet) reach(from_, facet, step);
  }

  /// Asked after so many expansions that a look from the other end costs little beside them: true
  /// when the goal is shut off.
  bool is_hopeless() const {
    constexpr int kFirstLook = 14, kLastLook = 23, kApart = 3;  // as powers of 2
    const std::uint64_t steps = countdown_.steps();
    const int power = std::countr_zero(steps);
    if (!std::has_single_bit(steps) || power < kFirstLook || power > kLastLook ||
        (power - kFirstLook) % kApart != 0)
      return false;
    const std::size_t most = power == kLastLook ? airspace_.voxels().size() : steps;
    return !connected(airspace_, to_, from_, most, budget_).value_or(true);
  }

  void expand(const Passage& passage, std::int64_t cost) {
    const std::int64_t scale = crossing_cost(passage.into);
    if (passage.into == to_) queue_.push(cost + FacetCosts::kToCentre * scale, kArrived);
    const std::int64_t turning = cost + FacetCosts::kAdjacent * scale;
    for (Facet facet = 0; facet < 6; ++facet)
      if (axis_of(facet) != axis_of(passage.facet)) reach(passage.into, facet, turning);
    reach(passage.into, opposite(passage.facet), cost + FacetCosts::kOpposite * scale);
  }

  /// The facet of that voxel can be reached at that cost, to go on into the voxel beyond.
  void reach(const Voxel& voxel, Facet facet, std::int64_t cost) {
    const Voxel into = beyond(voxel, facet);
    if (!free_(into)) return;
    FacetTable::Slot slot = table_.slot(voxel, facet);
    if (slot.known() && slot.above(cost) <= 0) return;
    slot.keep(cost);
    queue_.push(cost + heuristic_(voxel, facet), packed({into, opposite(facet)}));
  }

  /// Follows the costs back from a goal whose last facet has that cost.
  void trace(std::int64_t cost, GraphWay& answer) {
    answer.way = {airspace_.centre(to_)};
    answer.cost = 0.5 * metres(to_);
    Voxel voxel = to_;
    Facet facet = entry_of(to_, cost);
    while (true) {
      answer.way.push_back(centre_of(voxel, facet));
      voxel = beyond(voxel, facet);
      facet = opposite(facet);
      if (voxel == from_ && cost == FacetCosts::kToCentre * crossing_cost(from_)) break;
      const Facet next = facet_before(voxel, facet, cost);
      const bool straight = next == opposite(facet);
      cost -= (straight ? FacetCosts::kOpposite : FacetCosts::kAdjacent) * crossing_cost(voxel);
      answer.cost += (straight ? 1 : std::numbers::sqrt2 / 2) * metres(voxel);
      facet = next;
    }
    answer.cost += 0.5 * metres(from_);
    answer.way.push_back(airspace_.centre(from_));
    std::reverse(answer.way.begin(), answer.way.end());
  }

  bool is_known(const Voxel& voxel, Facet facet, std::int64_t cost) {
    if (!free_(beyond(voxel, facet))) return false;
    const FacetTable::Slot slot = table_.slot(voxel, facet);
    return slot.known() && slot.above(cost) == 0;
  }
  Facet entry_of(const Voxel& voxel, std::int64_t cost) {
    Facet facet = 0;
    while (facet < 6 && !is_known(voxel, facet, cost)) ++facet;
    SKEIN_ENSURES(facet < 6);
    return facet;
  }
  /// The facet of that voxel from which one was reached at that cost.
  Facet facet_before(const Voxel& voxel, Facet facet, std::int64_t cost) {
    const std::int64_t scale = crossing_cost(voxel);
    if (is_known(voxel, opposite(facet), cost - FacetCosts::kOpposite * scale))
      return opposite(facet);
    for (Facet other = 0; other < 6; ++other)
      if (axis_of(other) != axis_of(facet) &&
          is_known(voxel, other, cost - FacetCosts::kAdjacent * scale))
        return other;
    SKEIN_ENSURES(!"a facet that was reached from nowhere");
    return facet;
  }

  world::Vector3 centre_of(const Voxel& voxel, Facet facet) const {
    world::Vector3 centre = airspace_.centre(voxel);
    centre[static_cast<Eigen::Index>(axis_of(facet))] +=
        outward(facet) * airspace_.grid().voxel / 2;
    return centre;
  }
  /// Cost of a straight crossing [m × cost].
  double metres(const Voxel& voxel) const {
    const auto index = airspace_.grid().index(voxel[0], voxel[1], voxel[2]);
    return airspace_.grid().voxel * airspace_.voxels()[index] * Airspace::kCostStep;
  }

  const Airspace& airspace_;
  FreeVoxels free_;
  Voxel from_, to_;
  bool even_;  // one crossing cost everywhere
  FacetHeuristic heuristic_;
  FacetTable table_;
  BucketQueue queue_;
  std::int64_t cost_ = 0;  // of the way found
  const Budget& budget_;
  Countdown countdown_;
};

}  // namespace

double GraphDistances::from_start(const Voxel& voxel) {
  constexpr std::int64_t kAhead = (1 << 19) - 1;  // of what is kept to 20 bits
  const auto in_voxels = [](std::int64_t cost) {
    return static_cast<double>(cost) / FacetCosts::kOpposite;
  };
  // The lower ones first: they lie in one word.
  for (const Facet facet : {0U, 2U, 4U, 1U, 3U, 5U}) {
    const std::size_t axis = axis_of(facet);
    if (is_upper(facet) && voxel[axis] + 1 >= size_[axis]) continue;
    const FacetTable::Slot slot = table_.slot(voxel, facet);
    if (!slot.known()) continue;
    const std::int64_t about = from_start_(voxel, facet) + kAhead;
    return in_voxels(about + slot.above(about));
  }
  const std::array<std::int64_t, 3> centre = {2 * std::int64_t{voxel[0]} + 1,
                                              2 * std::int64_t{voxel[1]} + 1,
                                              2 * std::int64_t{voxel[2]} + 1};
  return in_voxels(cost_ - to_goal_.from(centre));
}

GraphSearch search_graph_widely(const Airspace& airspace, const Voxel& from, const Voxel& to,
                                const Budget& budget) {
  SKEIN_EXPECTS(airspace.is_free(from) && airspace.is_free(to));
  if (from == to) {
    GraphSearch here;
    here.way.found = true;
    here.way.way = {airspace.centre(from)};
    return here;
  }
  FacetSearch search(airspace, from, to, budget);
  GraphSearch found{search.run(), std::nullopt};
  if (found.way.found) found.distances = search.take_distances();
  return found;
}

GraphWay search_graph(const Airspace& airspace, const Voxel& from, const Voxel& to,
                      const Budget& budget) {
  return search_graph_widely(airspace, from, to, budget).way;
}

}  // namespace skein::refiners
