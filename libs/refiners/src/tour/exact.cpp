// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "tour/search.hpp"

namespace skein::refiners {
namespace {

constexpr TourCost kNever = std::numeric_limits<TourCost>::max();

/// least(set, gate): the least that visiting the stops of the set takes, the last by that gate.
class ExactSearch {
 public:
  explicit ExactSearch(const TourProblem& problem)
      : problem_(problem),
        gates_of_(problem),
        hop_(problem.between),
        least_((std::size_t{1} << problem.stops()) * problem.gates(), kNever) {
    for (std::size_t i = 0; i < hop_.size(); ++i) hop_[i] += problem.inside[i % problem.gates()];
  }

  /// Nothing when the countdown ends first; a step is a set.
  std::optional<TourOrder> run(Countdown& countdown) {
    for (std::size_t gate = 0; gate < problem_.gates(); ++gate)
      row(bit(problem_.stop_of[gate]))[gate] = problem_.from_start[gate] + problem_.inside[gate];
    const std::size_t everything = (std::size_t{1} << problem_.stops()) - 1;
    for (std::size_t set = 1; set < everything; ++set) {
      if (!countdown.step()) return std::nullopt;
      extend(set);
    }
    TourOrder order = read_back(everything);
    order.effort.steps = countdown.steps();
    return order;
  }

 private:
  static std::size_t bit(std::size_t stop) { return std::size_t{1} << stop; }
  TourCost* row(std::size_t set) { return least_.data() + set * problem_.gates(); }

  /// One stop more, from every gate that the set may end with.
  void extend(std::size_t set) {
    for (std::size_t gate = 0; gate < problem_.gates(); ++gate) {
      const TourCost before = row(set)[gate];
      if (before == kNever) continue;
      const TourCost* hop = hop_.data() + gate * problem_.gates();
      for (std::size_t stop = 0; stop < problem_.stops(); ++stop) {
        if ((set & bit(stop)) != 0) continue;
        TourCost* after = row(set | bit(stop));
        for (std::size_t to = gates_of_.begin(stop); to < gates_of_.end(stop); ++to)
          after[to] = std::min(after[to], before + hop[to]);
      }
    }
  }

  TourOrder read_back(std::size_t set) {
    TourOrder order;
    order.exact = true;
    std::vector<TourCost> onward = problem_.to_end;
    order.cost = kNever;
    while (set != 0) {
      const std::size_t gate = last_gate(set, onward);
      if (order.gates.empty()) order.cost = row(set)[gate] + onward[gate];
      order.gates.push_back(gate);
      set &= ~bit(problem_.stop_of[gate]);
      for (std::size_t from = 0; from < problem_.gates(); ++from)
        onward[from] = problem_.cost(from, gate);
    }
    std::reverse(order.gates.begin(), order.gates.end());
    return order;
  }

  std::size_t last_gate(std::size_t set, const std::vector<TourCost>& onward) {
    std::size_t best = problem_.gates();
    TourCost best_cost = kNever;
    for (std::size_t gate = 0; gate < problem_.gates(); ++gate) {
      const TourCost before = row(set)[gate];
      if (before == kNever || before + onward[gate] >= best_cost) continue;
      best = gate;
      best_cost = before + onward[gate];
    }
    return best;
  }

  const TourProblem& problem_;
  StopGates gates_of_;
  std::vector<TourCost> hop_;  // gates × gates: onward, and the visit there
  std::vector<TourCost> least_;
};

}  // namespace

std::uint64_t exact_tour_steps(const TourProblem& problem) {
  const std::size_t stops = problem.stops();
  if (stops > 24) return std::numeric_limits<std::uint64_t>::max();
  // A pair of gates of different stops counts in a quarter of the sets.
  std::uint64_t pairs = 0;
  const StopGates gates_of(problem);
  for (std::size_t stop = 0; stop < stops; ++stop) {
    const std::size_t own = gates_of.end(stop) - gates_of.begin(stop);
    pairs += own * (problem.gates() - own);
  }
  const std::uint64_t sets = std::uint64_t{1} << stops;
  return std::max<std::uint64_t>(sets * pairs / 4, sets * problem.gates());
}

std::optional<TourOrder> solve_exactly(const TourProblem& problem, Countdown& countdown) {
  return ExactSearch(problem).run(countdown);
}

}  // namespace skein::refiners
