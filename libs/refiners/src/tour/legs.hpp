// SPDX-License-Identifier: Apache-2.0
// Converts a tour query to the ordering problem, and the order to a tour; private.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/deadline.hpp"
#include "skein/refiners/tour.hpp"
#include "skein/refiners/tour_problem.hpp"
#include "tour/travel.hpp"

namespace skein::refiners {

/// The ordering problem of a query. Costs are those of straight flights until the real paths are
/// planned, so they are lower bounds and only increase.
class TourLegs {
 public:
  TourLegs(const TourQuery& query, Travel& travel);

  /// The refusal of a place where the vehicle cannot be (of a stop: if all its gates are closed).
  /// Must be called first.
  std::optional<Refusal> find_closed();
  /// The problem with the costs known so far. Precondition: find_closed() was called.
  const TourProblem& problem() const { return problem_; }
  /// Fills the problem with lower bounds. False: the time is up before, and there is no problem.
  bool start_optimistic(const Budget& budget);

  /// Plans the paths along an order and updates their costs. False if the time is up before all of
  /// them are known.
  bool settle(const std::vector<std::size_t>& gates);
  bool are_known(const std::vector<std::size_t>& gates) const;
  /// The problem restricted to known or straight paths (those found before the time is up). Nothing
  /// if none remain.
  std::optional<TourProblem> known_only(const Budget& budget) const;

  /// The refusal that names a stop without a path to it or from it; plans further paths to find it.
  Refusal why_impossible();
  /// Precondition: are_known.
  Refined<Tour> tour(const TourOrder& order) const;

 private:
  struct GatePlaces {
    std::size_t stop, index;
    Travel::Id entry, exit;
    bool open = true;
  };
  using Hop = std::pair<Travel::Id, Travel::Id>;
  std::vector<Hop> hops_of(const std::vector<std::size_t>& gates) const;
  TourCost cost(Travel::Id from, Travel::Id to) const;
  void put(const Hop& hop);
  bool put_all(Deadline& deadline);
  std::vector<std::pair<TourCost, Hop>> hops_at(std::size_t stop, bool entering) const;
  std::optional<Refusal> why_cut_off(std::size_t stop, bool entering);
  std::string named(std::size_t stop) const;
  std::size_t turned(const GatePlaces& gate) const;
  void fly(const Way& way, Refined<Tour>& refined) const;
  void stay(Duration inside, Refined<Tour>& refined) const;

  const TourQuery& query_;
  Travel& travel_;
  Travel::Id start_;
  std::optional<Travel::Id> end_;
  std::vector<GatePlaces> gates_;
  std::vector<std::vector<std::size_t>> entered_, left_;  // of each place: gates there
  TourProblem problem_;
  std::size_t shut_off_ = 0;  // of the travel, when all costs were put in
  bool late_ = false;         // they were not, for want of time
};

}  // namespace skein::refiners
