// SPDX-License-Identifier: Apache-2.0
// Costs between the places of a tour, and which places are near which; private.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "skein/refiners/tour_problem.hpp"
#include "tour/ring.hpp"

namespace skein::refiners {

/// Another place and what it costs to go there.
using Near = std::pair<TourCost, City>;

/// The places of a tour as a ring: the stops, then the end unless it is the start, then the start.
/// Stops are numbered by their places in an order that is good already, so that costs between
/// places near each other lie near each other too: the search reads little else.
class RingCosts {
 public:
  /// Of a problem whose costs are the same both ways, one gate a stop. Cost: O(stops²).
  RingCosts(const TourProblem& problem, const std::vector<std::size_t>& order);

  City size() const { return size_; }
  City start() const { return size_ - 1; }
  /// Where the tour ends, unless it is closed.
  City end_place() const { return stops_; }
  bool closed() const { return closed_; }
  TourCost operator()(City a, City b) const {
    return a < b ? cost_[row(b) + a] : cost_[row(a) + b];
  }
  /// The nearest others, and behind them the nearest stop in each direction where the nearest
  /// others are none of those: nearest first.
  std::span<const Near> near(City city) const {
    return {neighbours_.data() + first_[city], neighbours_.data() + first_[city + 1]};
  }

 private:
  /// Each pair once.
  static std::size_t row(City city) { return std::size_t{city} * (std::size_t{city} + 1) / 2; }
  void keep_costs(const TourProblem& problem, const std::vector<std::size_t>& order);
  void list_neighbours(const TourProblem& problem, const std::vector<std::size_t>& order);

  City stops_;
  bool closed_;
  City size_;
  std::unique_ptr<TourCost[]> cost_;
  std::vector<std::size_t> first_;  // of each place in the list of neighbours
  std::vector<Near> neighbours_;
};

}  // namespace skein::refiners
