// SPDX-License-Identifier: Apache-2.0
// The parts of the search for an order; private.
#pragma once

#include <optional>
#include <vector>

#include "skein/refiners/tour_problem.hpp"

namespace skein::refiners {

/// Which gates a stop has: [begin, end).
class StopGates {
 public:
  explicit StopGates(const TourProblem& problem);
  std::size_t begin(std::size_t stop) const { return first_[stop]; }
  std::size_t end(std::size_t stop) const { return first_[stop + 1]; }

 private:
  std::vector<std::size_t> first_;
};

/// By dynamic programming over sets of stops; nothing when the clock cut it.
/// Source: Held and Karp 1962.
std::optional<TourOrder> solve_exactly(const TourProblem& problem, Countdown& countdown);

/// Sets of stops that the exact search of solve_tour steps through; 0 when it is never made.
std::uint64_t exact_sets(const TourProblem& problem);

/// Each stop in turn where, and by the gate by which, it adds least. `symmetrical`: is_symmetrical,
/// which makes it quicker.
std::vector<std::size_t> insert_cheaply(const TourProblem& problem, bool symmetrical = false);

/// Searches on from an order, with any costs and gates.
void improve_any(const TourProblem& problem, TourOrder& order, Countdown& countdown,
                 std::uint64_t seed);

/// True when there is one gate a stop and both senses cost the same between stops.
bool is_symmetrical(const TourProblem& problem);
/// The same for such problems, much faster.
void improve_symmetrical(const TourProblem& problem, TourOrder& order, Countdown& countdown,
                         std::uint64_t seed);

}  // namespace skein::refiners
