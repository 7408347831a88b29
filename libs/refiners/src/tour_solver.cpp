// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <optional>

#include "skein/foundation/contract.hpp"
#include "tour_search.hpp"

namespace skein::refiners {
namespace {

/// Where a gate would go into an order, and what that adds.
struct Place {
  std::size_t position = 0, gate = 0;
  TourCost added = std::numeric_limits<TourCost>::max();
};

void look_at_gate(const TourProblem& problem, const std::vector<std::size_t>& order,
                  std::size_t gate, Place& best) {
  for (std::size_t at = 0; at <= order.size(); ++at) {
    const bool first = at == 0, last = at == order.size();
    TourCost added = problem.inside[gate];
    added += first ? problem.from_start[gate] : problem.cost(order[at - 1], gate);
    added += last ? problem.to_end[gate] : problem.cost(gate, order[at]);
    if (!first && !last) added -= problem.cost(order[at - 1], order[at]);
    if (first && !last) added -= problem.from_start[order[at]];
    if (last && !first) added -= problem.to_end[order[at - 1]];
    if (added < best.added) best = {at, gate, added};
  }
}

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
  order.gates = insert_cheaply(problem);
  // Late or not: one descent of the quick search takes some milliseconds, and without it the order
  // is up to a third longer.
  const bool late = budget.expired(), quick = is_symmetrical(problem);
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

std::vector<std::size_t> insert_cheaply(const TourProblem& problem) {
  const StopGates gates_of(problem);
  std::vector<std::size_t> order;
  for (std::size_t stop = 0; stop < problem.stops(); ++stop) {
    Place best;
    for (std::size_t gate = gates_of.begin(stop); gate < gates_of.end(stop); ++gate)
      look_at_gate(problem, order, gate, best);
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(best.position), best.gate);
  }
  return order;
}

bool is_symmetrical(const TourProblem& problem) {
  if (problem.gates() != problem.stops()) return false;
  for (std::size_t a = 0; a < problem.gates(); ++a)
    for (std::size_t b = 0; b < a; ++b)
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
