// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/tour_problem.hpp"

#include <algorithm>
#include <limits>

#include "skein/foundation/contract.hpp"
#include "tour/search.hpp"

namespace skein::refiners {

StopGates::StopGates(const TourProblem& problem) : first_(problem.stops() + 1, 0) {
  for (std::size_t gate = 0; gate < problem.gates(); ++gate)
    first_[problem.stop_of[gate] + 1] = gate + 1;
}

TourCost cost_of(const TourProblem& problem, const std::vector<std::size_t>& gates) {
  SKEIN_EXPECTS(!gates.empty());
  TourCost total = problem.from_start[gates.front()] + problem.to_end[gates.back()];
  for (const std::size_t gate : gates) total += problem.inside[gate];
  for (std::size_t i = 1; i < gates.size(); ++i) total += problem.cost(gates[i - 1], gates[i]);
  return total;
}

std::vector<std::size_t> choose_gates(const TourProblem& problem,
                                      const std::vector<std::size_t>& stops) {
  SKEIN_EXPECTS(!stops.empty());
  const StopGates gates_of(problem);
  // From the back: what the rest costs from the exit of each gate, and by which next gate.
  std::vector<TourCost> rest = problem.to_end;
  std::vector<std::size_t> next(problem.gates(), problem.gates());
  for (std::size_t i = stops.size() - 1; i-- > 0;)
    for (std::size_t gate = gates_of.begin(stops[i]); gate < gates_of.end(stops[i]); ++gate) {
      rest[gate] = std::numeric_limits<TourCost>::max();
      for (std::size_t to = gates_of.begin(stops[i + 1]); to < gates_of.end(stops[i + 1]); ++to) {
        const TourCost cost = problem.cost(gate, to) + problem.inside[to] + rest[to];
        if (cost < rest[gate]) rest[gate] = cost, next[gate] = to;
      }
    }
  std::size_t best = gates_of.begin(stops.front());
  const auto whole = [&](std::size_t gate) {
    return problem.from_start[gate] + problem.inside[gate] + rest[gate];
  };
  for (std::size_t gate = best; gate < gates_of.end(stops.front()); ++gate)
    if (whole(gate) < whole(best)) best = gate;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < stops.size(); ++i, best = next[best]) chosen.push_back(best);
  return chosen;
}

}  // namespace skein::refiners
