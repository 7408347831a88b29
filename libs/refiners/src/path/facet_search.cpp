// SPDX-License-Identifier: Apache-2.0
// A* over the way-point graph.
#include "path/facet_search.hpp"

#include <bit>
#include <cmath>
#include <numbers>

#include "path/bucket_queue.hpp"
#include "path/facet_graph.hpp"
#include "path/free_voxels.hpp"
#include "path/voxel_flood.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {
namespace {

using world::Airspace;
using world::Voxel;

/// One search. A facet is expanded only into the voxel it was reached for: going back into the one
/// it was reached from never pays, since two steps in one voxel cost more than one.
class FacetSearch {
 public:
  /// `countdown`: of this search and any beside it.
  FacetSearch(const Airspace& airspace, const Voxel& from, const Voxel& to, const Budget& budget,
              Countdown& countdown)
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
        countdown_(countdown) {
    if (table_.usable()) start();
  }

  enum class State { kUnderWay, kFound, kNoWay, kOutOfBudget };

  /// Goes on until so many nodes have been expanded by this search.
  State run(std::uint64_t most) {
    if (!table_.usable()) return State::kOutOfBudget;
    while (!queue_.empty()) {
      if (steps_ >= most) return State::kUnderWay;
      const std::uint64_t word = queue_.pop();
      if (word == kArrived) {
        cost_ = queue_.priority();
        return State::kFound;
      }
      const Passage passage = unpacked(word);
      const std::int64_t cost = queue_.priority() - heuristic_(passage.into, passage.facet);
      if (table_.slot(passage.into, passage.facet).above(cost) != 0) continue;
      if (!countdown_.step()) return State::kOutOfBudget;
      ++steps_;
      if (is_hopeless()) return State::kNoWay;
      expand(passage, cost);
    }
    return State::kNoWay;
  }

  /// After a run that found it.
  void trace(GraphWay& answer) {
    answer.found = true;
    trace(cost_ - FacetCosts::kToCentre * crossing_cost(to_), answer);
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
    constexpr int kFirstLook = 14, kLastLook = 22, kApart = 2;  // as powers of 2
    const int power = std::countr_zero(steps_);
    if (!std::has_single_bit(steps_) || power < kFirstLook || power > kLastLook ||
        (power - kFirstLook) % kApart != 0)
      return false;
    const std::size_t most = power == kLastLook ? airspace_.voxels().size() : steps_;
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
  std::uint64_t steps_ = 0;
  const Budget& budget_;
  Countdown& countdown_;
};

/// Dead ends are dead ends from one side only: what floods them from there is often led straight
/// out of them from the other. So where a search is long, that from the other end gets a share.
class Race {
 public:
  Race(const Airspace& airspace, const Voxel& from, const Voxel& to, const Budget& budget)
      : airspace_(airspace),
        from_(from),
        to_(to),
        budget_(budget),
        countdown_(budget),
        forth_(airspace, from, to, budget, countdown_) {}

  GraphSearch run() {
    State state = forth_.run(kAlone);
    for (std::uint64_t most = 2 * kAlone; state == State::kUnderWay; most *= 2) {
      state = run_back(most / (2 * kShare));
      if (state == State::kUnderWay) state = forth_.run(most);
    }
    GraphSearch found;
    found.way.expanded = countdown_.steps();
    found.way.out_of_budget = state == State::kOutOfBudget;
    found.way.cut_short = countdown_.cut_short();
    if (state != State::kFound) return found;
    found.backwards = back_won_;
    FacetSearch& winner = back_won_ ? *back_ : forth_;
    winner.trace(found.way);
    if (back_won_) std::reverse(found.way.way.begin(), found.way.way.end());
    found.distances = winner.take_distances();
    return found;
  }

 private:
  using State = FacetSearch::State;
  static constexpr std::uint64_t kAlone = 1U << 17U;  ///< nodes
  static constexpr std::uint64_t kShare = 4;
  /// From then on it would be the longer one, and take as much memory again.
  static constexpr std::uint64_t kMostBack = 1U << 19U;

  State run_back(std::uint64_t most) {
    if (most > kMostBack) {
      back_.reset();
      return State::kUnderWay;
    }
    if (!back_) back_.emplace(airspace_, to_, from_, budget_, countdown_);
    const State state = back_->run(most);
    back_won_ = state == State::kFound;
    return state;
  }

  const Airspace& airspace_;
  Voxel from_, to_;
  const Budget& budget_;
  Countdown countdown_;
  FacetSearch forth_;
  std::optional<FacetSearch> back_;
  bool back_won_ = false;
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
  return Race(airspace, from, to, budget).run();
}

GraphWay search_graph(const Airspace& airspace, const Voxel& from, const Voxel& to,
                      const Budget& budget) {
  return search_graph_widely(airspace, from, to, budget).way;
}

}  // namespace skein::refiners
