// SPDX-License-Identifier: Apache-2.0
// From a tour's query to the ordering problem and back; private.
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

/// The ordering problem of a query, whose costs are what straight flights take until the real ways
/// are looked for: none is too high, and they only rise.
class TourLegs {
 public:
  TourLegs(const TourQuery& query, Travel& travel);

  /// A place where the vehicle cannot be; of a stop only when it has no other gate. First of all.
  std::optional<Refusal> find_closed();
  /// Costs as far as they are known. After find_closed.
  const TourProblem& problem() const { return problem_; }
  /// False when the time is up before: then there is no problem.
  bool start_optimistic(const Budget& budget);

  /// Looks for the ways along an order and puts in what they take. False when the time is up
  /// before all of them are known.
  bool settle(const std::vector<std::size_t>& gates);
  bool are_known(const std::vector<std::size_t>& gates) const;
  /// Only with ways that are known or straight; of these only those found before the time is up.
  /// Nothing when that leaves none.
  std::optional<TourProblem> known_only(const Budget& budget) const;

  /// Which stop has no way to it, or on from it; looks for more ways to tell.
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
