// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <optional>

#include "skein/foundation/contract.hpp"
#include "tour/search.hpp"

namespace skein::refiners {
namespace {

/// An order that grows, with what each of its hops costs: from the start to the first gate, on from
/// gate to gate, and to the end.
class GrowingOrder {
 public:
  GrowingOrder(const TourProblem& problem, bool symmetrical)
      : problem_(problem), symmetrical_(symmetrical) {}

  /// Puts in the gate among [begin, end) that adds least, where it does.
  void insert_one_of(std::size_t begin, std::size_t end) {
    Place best;
    for (std::size_t gate = begin; gate < end; ++gate) look_at_gate(gate, best);
    order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(best.position), best.gate);
    hops_.insert(hops_.begin() + static_cast<std::ptrdiff_t>(best.position), 0);
    measure(best.position);
    measure(best.position + 1);
  }
  const std::vector<std::size_t>& order() const { return order_; }

 private:
  struct Place {
    std::size_t position = 0, gate = 0;
    TourCost added = std::numeric_limits<TourCost>::max();
  };

  void look_at_gate(std::size_t gate, Place& best) const {
    const auto offer = [&](std::size_t at, TourCost added) {
      if (added < best.added) best = {at, gate, added};
    };
    const std::size_t last = order_.size();
    TourCost before = problem_.inside[gate] + problem_.from_start[gate];
    for (std::size_t at = 0; at < last; ++at) {
      offer(at, before + problem_.cost(gate, order_[at]) - hops_[at]);
      before = problem_.inside[gate] + cost_from(order_[at], gate);
    }
    offer(last, before + problem_.to_end[gate] - hops_[last]);
  }
  /// The row of the gate, where it says the same as the column, stays in the cache.
  TourCost cost_from(std::size_t other, std::size_t gate) const {
    return symmetrical_ ? problem_.cost(gate, other) : problem_.cost(other, gate);
  }
  void measure(std::size_t hop) {
    const bool first = hop == 0, last = hop == order_.size();
    hops_[hop] = first  ? problem_.from_start[order_[0]]
                 : last ? problem_.to_end[order_.back()]
                        : problem_.cost(order_[hop - 1], order_[hop]);
  }

  const TourProblem& problem_;
  bool symmetrical_;
  std::vector<std::size_t> order_;
  std::vector<TourCost> hops_ = {0};
};

std::uint64_t sets_of(const TourProblem& problem) {
  return std::uint64_t{1} << std::min<std::size_t>(problem.stops(), 63);
}

bool fits_exact_search(const TourProblem& problem, std::uint64_t steps) {
  return steps <= (problem.stops() <= kExactStops ? kMostExactSteps : kMostQuickSteps);
}

std::optional<TourOrder> try_exactly(const TourProblem& problem, std::uint64_t steps,
                                     const Budget& budget) {
  const std::uint64_t steps_a_set = steps / sets_of(problem) + 1;
  Countdown countdown(budget, static_cast<std::uint32_t>(30'000 / steps_a_set + 1));
  return solve_exactly(problem, countdown);
}

Budget within_default_steps(const Budget& budget, const TourProblem& problem) {
  return {budget.time_is_up, std::min(budget.steps, default_tour_steps(problem))};
}

TourOrder search(const TourProblem& problem, const Budget& budget, std::uint64_t seed) {
  TourOrder order;
  const bool quick = is_symmetrical(problem);
  order.gates = insert_cheaply(problem, quick);
  // Late or not: one descent of the quick search takes some milliseconds, and without it the order
  // is up to a third longer.
  const bool late = budget.expired();
  order.effort.cut_short = late;
  if (!late || quick) {
    const bool bounds_given =
        budget.time_is_up || budget.steps != std::numeric_limits<std::uint64_t>::max();
    const Budget bounded = bounds_given ? budget : within_default_steps(budget, problem);
    Countdown countdown(bounded, 16);
    (quick ? improve_symmetrical : improve_any)(problem, order, countdown, seed);
    order.effort = {countdown.steps(), late || countdown.cut_short()};
  }
  order.cost = cost_of(problem, order.gates);
  return order;
}

}  // namespace

std::vector<std::size_t> insert_cheaply(const TourProblem& problem, bool symmetrical) {
  const StopGates gates_of(problem);
  GrowingOrder growing(problem, symmetrical);
  for (std::size_t stop = 0; stop < problem.stops(); ++stop)
    growing.insert_one_of(gates_of.begin(stop), gates_of.end(stop));
  return growing.order();
}

bool is_symmetrical(const TourProblem& problem) {
  if (problem.gates() != problem.stops()) return false;
  // In squares, which stay in the cache both ways.
  constexpr std::size_t kSide = 32;
  const std::size_t count = problem.gates();
  for (std::size_t top = 0; top < count; top += kSide)
    for (std::size_t left = 0; left <= top; left += kSide)
      for (std::size_t a = top; a < std::min(top + kSide, count); ++a)
        for (std::size_t b = left; b < std::min(left + kSide, a); ++b)
          if (problem.cost(a, b) != problem.cost(b, a)) return false;
  return true;
}

std::uint64_t default_tour_steps(const TourProblem& problem) {
  const std::uint64_t stops = problem.stops();
  return is_symmetrical(problem) ? 100 * stops : 20'000 + 20 * stops;
}

std::uint64_t exact_sets(const TourProblem& problem) {
  return fits_exact_search(problem, exact_tour_steps(problem)) ? sets_of(problem) : 0;
}

TourOrder solve_tour(const TourProblem& problem, const Budget& budget, std::uint64_t seed) {
  SKEIN_EXPECTS(problem.stops() >= 1 && problem.stops() <= kMostStops);
  SKEIN_EXPECTS(problem.between.size() == problem.gates() * problem.gates());
  const std::uint64_t exact_steps = exact_tour_steps(problem);
  const bool small = exact_steps <= kMostQuickSteps;
  const bool exact = fits_exact_search(problem, exact_steps) && sets_of(problem) <= budget.steps;
  if (exact && small)
    if (auto order = try_exactly(problem, exact_steps, budget)) return *order;
  TourOrder order = search(problem, exact ? within_default_steps(budget, problem) : budget, seed);
  if (exact && !small && !order.effort.cut_short)
    if (auto best = try_exactly(problem, exact_steps, budget)) return *best;
  order.effort.cut_short = order.effort.cut_short || exact;
  return order;
}

}  // namespace skein::refiners
