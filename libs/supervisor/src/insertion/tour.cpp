// SPDX-License-Identifier: Apache-2.0
// (c): by spatial compatibility, through a tour over places.
#include <algorithm>

#include "insertion/orders.hpp"
#include "insertion/places.hpp"
#include "skein/refiners/tour_problem.hpp"

namespace skein::supervisor {
namespace {

using refiners::Gate;
using world::Vector3;

refiners::TourQuery query_over(const Blocks& placed, const Movable& movable,
                               const PlanningRequest& base) {
  refiners::TourQuery query;
  query.vehicle = base.knowledge->vehicle;
  query.start = in_the_air(base);
  if (!movable.landings.empty()) query.end = over_home(base);
  for (const Block& block : placed)
    query.stops.push_back({to_text(block.goals.front().id), block.gates});
  query.depart = base.situation.origin + base.situation.motion.free.least;
  return query;
}

/// The problem of the query when all flights are straight.
class StraightTour {
 public:
  explicit StraightTour(const refiners::TourQuery& query) : query_(query) {
    for (std::size_t stop = 0; stop < query.stops.size(); ++stop)
      for (const Gate& gate : query.stops[stop].gates) {
        gates_.push_back(&gate);
        problem_.stop_of.push_back(stop);
      }
    for (const Gate* gate : gates_) {
      problem_.inside.push_back(gate->inside.count());
      problem_.from_start.push_back(cost(query.start, gate->entry));
      problem_.to_end.push_back(query.end ? cost(gate->exit, *query.end) : 0);
    }
    for (const Gate* from : gates_)
      for (const Gate* to : gates_) problem_.between.push_back(cost(from->exit, to->entry));
  }

  std::vector<std::size_t> solve(std::uint64_t seed) const {
    std::vector<std::size_t> stops;
    for (const std::size_t gate : refiners::solve_tour(problem_, {}, seed).gates)
      stops.push_back(problem_.stop_of[gate]);
    return stops;
  }

 private:
  refiners::TourCost cost(const Vector3& from, const Vector3& to) const {
    const double speed = std::max(query_.vehicle.cruise_speed, 1e-3);
    return std::min(Duration::seconds((to - from).norm() / speed).count(), refiners::kNoWay);
  }

  const refiners::TourQuery& query_;
  std::vector<const Gate*> gates_;
  refiners::TourProblem problem_;
};

std::vector<std::size_t> visits_of(const refiners::TourQuery& query, const PlanningRequest& base) {
  const refiners::Setting setting{
      .world = *base.world, .budget = {}, .seed = base.seed, .paths = nullptr};
  const auto tour = refiners::refine(query, setting);
  if (!tour) return StraightTour(query).solve(base.seed);
  std::vector<std::size_t> stops;
  for (const refiners::Visit& visit : tour->task.visits) stops.push_back(visit.stop);
  return stops;
}

}  // namespace

Blocks tour_over(const Movable& movable, const PlanningRequest& base) {
  Blocks placed, behind, order;
  for (const Block& block : all_blocks(movable)) {
    // Only a list without any place has a block without one.
    if (!block.gates.empty())
      placed.push_back(block);
    else
      (block.added ? behind : order).push_back(block);
  }
  if (!placed.empty()) {
    Blocks toured;
    for (const std::size_t stop : visits_of(query_over(placed, movable, base), base))
      toured.push_back(placed[stop]);
    for (const Blocks* list : {&movable.planned, &movable.added}) keep_shared(toured, *list);
    order.insert(order.end(), toured.begin(), toured.end());
  }
  order.insert(order.end(), behind.begin(), behind.end());
  return order;
}

}  // namespace skein::supervisor
