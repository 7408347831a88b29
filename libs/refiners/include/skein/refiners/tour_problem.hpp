// SPDX-License-Identifier: Apache-2.0
// The ordering problem inside a tour: every stop once, by one of its gates, at the least cost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "skein/refiners/budget.hpp"
#include "skein/refiners/refinement.hpp"

namespace skein::refiners {

/// Whole units, so that sums are exact and the same everywhere: the service counts nanoseconds.
using TourCost = std::int64_t;
/// No way: as much as 52 days in nanoseconds, so that the sum of a thousand of them still fits.
inline constexpr TourCost kNoWay = TourCost{1} << 52U;
/// Most stops, for the same reason.
inline constexpr std::size_t kMostStops = 1000;

/// Stops with gates (ways of visiting them), between a fixed start and an end. Gates are numbered
/// through all stops. The costs need not be symmetrical, nor keep the triangle inequality.
/// A closed tour over n places is one place as the start and the end, and n - 1 stops.
struct TourProblem {
  std::vector<std::size_t> stop_of;  ///< of each gate; ascending from 0 without gaps
  std::vector<TourCost> inside;      ///< of each gate: what the visit takes, [0, kNoWay]
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

/// What the whole order costs. Cost: O(stops).
TourCost cost_of(const TourProblem& problem, const std::vector<std::size_t>& gates);

/// The best gate of each stop along an order of stops, exactly. Cost: O(stops × gates each²).
std::vector<std::size_t> choose_gates(const TourProblem& problem,
                                      const std::vector<std::size_t>& stops);

/// Transitions that the exact search would make. Twelve stops of eight gates each: 9 million.
std::uint64_t exact_tour_steps(const TourProblem& problem);
/// Up to so many stops the exact search is made whatever it takes up to kMostExactSteps
/// (twelve stops of eighty gates); beyond, only when it is quick.
inline constexpr std::size_t kExactStops = 12;
inline constexpr std::uint64_t kMostExactSteps = 1'000'000'000;
inline constexpr std::uint64_t kMostQuickSteps = 30'000'000;

/// The best order, or the best found. Exact (see TourOrder::exact) up to twelve stops, and up to
/// some eighteen with one gate each; the rest by iterated local search. A step of the budget is: in
/// the exact search, one set of stops; in the search with one gate a stop and the same costs both
/// ways, one perturbation with its descent; else all moves of one stop.
///
/// Without bounds the search ends by itself after default_tour_steps: the same order for the same
/// seed everywhere. With a clock it goes on until the clock or the steps end it. At any time there
/// is an order: one that is cut at once is what cheapest insertion gives, and, where there is one
/// gate a stop and the same costs both ways, one descent from there (1 ms for 200 stops, 24 ms for
/// 1,000). Precondition: at least one stop, at most kMostStops, each with a gate; sizes agree.
/// Source: spec 4.2 (tour).
TourOrder solve_tour(const TourProblem& problem, const Budget& budget, std::uint64_t seed);

/// Of the iterated search: 100 perturbations a stop, or 20,000 stops looked at. Measured on 200
/// stops of seven kinds (bench/tour_bench.cpp): 19 to 58 ms of CPU where the costs are the same
/// both ways, 62 to 65 ms where not.
std::uint64_t default_tour_steps(const TourProblem& problem);

}  // namespace skein::refiners
