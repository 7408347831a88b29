// SPDX-License-Identifier: Apache-2.0
#include "tour/ring_costs.hpp"

#include <algorithm>
#include <cstdint>

namespace skein::refiners {
namespace {

constexpr std::size_t kNeighbours = 10;
/// In a plane no place has more others around it, each nearer to it than to the rest of them.
constexpr std::size_t kMostDirections = 6;
/// Keeps the start and the end of an open tour side by side on the ring.
constexpr TourCost kBond = TourCost{1} << 57U;

/// Which places are near a place. Those nearest are not enough where places lie in heaps: then all
/// are of the same heap, and no exchange joins another. A stop in a new direction is one that is
/// nearer to the place than to any that is listed; with these, whatever the costs, there is a way
/// from each place to each other along the lists, as long as none is full.
class NearPlaces {
 public:
  NearPlaces(const RingCosts& cost, const TourProblem& problem,
             const std::vector<std::size_t>& order)
      : cost_(cost), problem_(problem), order_(order), numbers_(order.size()) {
    for (City city = 0; city < stops(); ++city) numbers_[order_[city]] = city;
    gates_.reserve(order.size());
  }

  /// Until the next call.
  const std::vector<Near>& around(City city) {
    near_.clear();
    list_nearest(city);
    list_directions(city);
    return near_;
  }

 private:
  City stops() const { return static_cast<City>(order_.size()); }

  /// What it costs from a place to each gate.
  const TourCost* row(City city) const {
    if (city < stops()) return &problem_.between[order_[city] * problem_.gates()];
    return city == cost_.start() ? problem_.from_start.data() : problem_.to_end.data();
  }

  void list_nearest(City city) {
    const TourCost* const costs = row(city);
    if (city < stops())
      for (City gate = 0; gate < stops(); ++gate)
        if (numbers_[gate] != city) offer({costs[gate], numbers_[gate]});
    for (City other = city < stops() ? stops() : 0; other < cost_.size(); ++other)
      if (other != city) offer({cost_(city, other), other});
  }
  /// Few are nearer than those that were found already.
  void offer(const Near& near) {
    if (near_.size() == kNeighbours) {
      if (near >= near_.back()) return;
      near_.pop_back();
    }
    near_.insert(std::upper_bound(near_.begin(), near_.end(), near), near);
  }

  void list_directions(City city) {
    const TourCost* const costs = row(city);
    const std::size_t nearest = near_.size();
    look_beyond(costs);
    for (std::size_t i = 0; i < nearest && !gates_.empty(); ++i) leave_out(near_[i].second, costs);
    while (!gates_.empty() && near_.size() < nearest + kMostDirections) {
      const City gate = *std::min_element(gates_.begin(), gates_.end(),
                                          [&](City a, City b) { return costs[a] < costs[b]; });
      near_.emplace_back(costs[gate], numbers_[gate]);
      leave_out(numbers_[gate], costs);
    }
  }
  /// The gates behind the nearest places, without those that are seen at once to be in the
  /// direction of two of these.
  void look_beyond(const TourCost* costs) {
    const auto some = [&](std::size_t i) {
      const Near& near = near_[std::min(i, near_.size() - 1)];
      return shows(near.second) ? row(near.second) : costs;
    };
    const TourCost* const from_one = some(1);
    const TourCost* const from_other = some(near_.size() / 2);
    const TourCost least = near_.back().first;
    gates_.resize(stops());
    std::size_t count = 0;
    for (City gate = 0; gate < stops(); ++gate) {
      const TourCost cost = costs[gate];
      gates_[count] = gate;
      count += static_cast<std::size_t>(cost >= least) & static_cast<std::size_t>(cost < kNoWay) &
               static_cast<std::size_t>(cost <= from_one[gate]) &
               static_cast<std::size_t>(cost <= from_other[gate]);
    }
    gates_.resize(count);
  }
  /// Start and end of an open tour have one neighbour only, and a free end is near to all: others
  /// are not left out for them.
  bool shows(City listed) const { return listed < stops() || cost_.closed(); }
  /// Of the gates that are looked at, those nearer to that place, and the place itself.
  void leave_out(City listed, const TourCost* costs) {
    if (!shows(listed)) return;
    const TourCost* const from_there = row(listed);
    const City gate = listed < stops() ? static_cast<City>(order_[listed]) : stops();
    std::erase_if(gates_,
                  [&](City other) { return other == gate || from_there[other] < costs[other]; });
  }

  const RingCosts& cost_;
  const TourProblem& problem_;
  const std::vector<std::size_t>& order_;
  std::vector<City> numbers_;  // of the stop of each gate
  std::vector<City> gates_;    // not shown yet to be in the direction of one that is listed
  std::vector<Near> near_;
};

}  // namespace

RingCosts::RingCosts(const TourProblem& problem, const std::vector<std::size_t>& order)
    : stops_(static_cast<City>(problem.stops())),
      closed_(problem.from_start == problem.to_end),
      size_(stops_ + (closed_ ? 1 : 2)),
      cost_(std::make_unique_for_overwrite<TourCost[]>(row(size_))) {
  keep_costs(problem, order);
  list_neighbours(problem, order);
}

void RingCosts::keep_costs(const TourProblem& problem, const std::vector<std::size_t>& order) {
  for (City a = 0; a < stops_; ++a) {
    for (City b = 0; b < a; ++b) cost_[row(a) + b] = problem.cost(order[a], order[b]);
    cost_[row(start()) + a] = problem.from_start[order[a]];
    if (!closed_) cost_[row(end_place()) + a] = problem.to_end[order[a]];
  }
  for (City a = 0; a < size_; ++a) cost_[row(a) + a] = 0;
  if (!closed_) cost_[row(start()) + end_place()] = -kBond;
}

void RingCosts::list_neighbours(const TourProblem& problem, const std::vector<std::size_t>& order) {
  NearPlaces near(*this, problem, order);
  neighbours_.reserve(size_ * (kNeighbours + 1));
  first_.reserve(size_ + 1);
  first_.push_back(0);
  for (City city = 0; city < size_; ++city) {
    const std::vector<Near>& around = near.around(city);
    neighbours_.insert(neighbours_.end(), around.begin(), around.end());
    first_.push_back(neighbours_.size());
  }
}

}  // namespace skein::refiners
