// SPDX-License-Identifier: Apache-2.0
// The ordering problem inside a tour: every stop once, by one of its gates, at the least cost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "skein/refiners/budget.hpp"
#include "skein/refiners/refinement.hpp"

namespace skein::refiners {

/// Costs are integers, so that sums are exact on every machine; the tour service uses nanoseconds.
using TourCost = std::int64_t;
/// Cost of an impossible leg: 52 days in nanoseconds, so that the sum of a thousand still fits.
inline constexpr TourCost kNoWay = TourCost{1} << 52U;
/// Most stops, so that sums of costs fit.
inline constexpr std::size_t kMostStops = 1000;

/// Stops with gates (alternative visits), between a fixed start and an end. Gates are numbered
/// consecutively over all stops. Costs need neither be symmetrical nor satisfy the triangle
/// inequality. A closed tour over n places: one place as start and end, and n - 1 stops.
struct TourProblem {
  std::vector<std::size_t> stop_of;  ///< of each gate; ascending from 0 without gaps
  std::vector<TourCost> inside;      ///< of each gate: cost of the visit, [0, kNoWay]
  std::vector<TourCost> between;     ///< gates × gates, row by row: from the exit of one to the
                                     ///< entry of another, [0, kNoWay]; within a stop unused
  std::vector<TourCost> from_start;  ///< to the entry of each gate, [0, kNoWay]
  std::vector<TourCost> to_end;      ///< from the exit of each gate; all 0 when the end is free

  std::vector<std::size_t> turned;  ///< of each gate: the gate of the same stop that goes through
                                    ///< it the other way; itself if none. Empty: all themselves

  std::size_t gates() const { return stop_of.size(); }
  std::size_t stops() const { return stop_of.empty() ? 0 : stop_of.back() + 1; }
  TourCost cost(std::size_t from, std::size_t to) const { return between[from * gates() + to]; }
};

/// An order of gates, one of each stop.
struct TourOrder {
  std::vector<std::size_t> gates;
  TourCost cost = 0;   ///< kNoWay or more: no order without a closed way was found
  bool exact = false;  ///< proved to be the best
  Effort effort;
};

/// Total cost of an order. Cost: O(stops).
TourCost cost_of(const TourProblem& problem, const std::vector<std::size_t>& gates);

/// The best gate of each stop along an order of stops, exactly. Cost: O(stops × gates each²).
std::vector<std::size_t> choose_gates(const TourProblem& problem,
                                      const std::vector<std::size_t>& stops);

/// Number of transitions of the exact search. Twelve stops of eight gates each: 9 million.
std::uint64_t exact_tour_steps(const TourProblem& problem);
/// Up to kExactStops stops the exact search is used if it needs at most kMostExactSteps transitions
/// (twelve stops of eighty gates); for more stops only if it is quick.
inline constexpr std::size_t kExactStops = 12;
inline constexpr std::uint64_t kMostExactSteps = 1'000'000'000;
inline constexpr std::uint64_t kMostQuickSteps = 30'000'000;

/// The best order found. Exact (see TourOrder::exact) up to twelve stops, and up to some eighteen
/// with one gate each; beyond that by iterated local search. A step of the budget is: in the exact
/// search, one set of stops; with one gate per stop and symmetrical costs, one perturbation with
/// its descent; else all moves of one stop.
///
/// Without bounds the search ends after default_tour_steps, with the same order for the same seed
/// on every machine. With a clock it continues until the clock or the steps end it. It always
/// returns an order: at least that of cheapest insertion, followed, with one gate per stop and
/// symmetrical costs, by one descent (1 ms for 200 stops, 24 ms for 1,000). Precondition: 1 to
/// kMostStops stops, each with a gate; sizes agree. Source: spec 4.2 (tour).
TourOrder solve_tour(const TourProblem& problem, const Budget& budget, std::uint64_t seed);

/// Default number of steps of the iterated search: 100 perturbations per stop with symmetrical
/// costs, else 20,000 + 20 per stop. Measured on 200 stops of seven kinds (bench/tour_bench.cpp):
/// 19 to 58 ms of CPU with symmetrical costs, 62 to 65 ms otherwise.
std::uint64_t default_tour_steps(const TourProblem& problem);

}  // namespace skein::refiners
