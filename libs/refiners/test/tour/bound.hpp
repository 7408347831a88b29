// SPDX-License-Identifier: Apache-2.0
// What no closed tour can be shorter than, without any search for one. For tests and benches.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "tour/cases.hpp"

namespace skein::refiners::test {

/// A tour is a tree over all places but one, and two hops to that one: the least such 1-tree is no
/// longer. Fees for the use of a place, which each tour pays twice, raise it until most places have
/// two hops. Source: Held and Karp 1970; steps as in Volgenant and Jonker 1982.
class OneTreeBound {
 public:
  explicit OneTreeBound(const TourCase& c) : count_(c.places.size()) {
    for (const Place& a : c.places)
      for (const Place& b : c.places)
        cost_.push_back(&a == &b ? 0 : static_cast<double>(tsplib_distance(c, a, b)));
  }

  /// After so many steps. `good`: the length of some tour. Cost: O(steps × places²).
  double raise(double good, int steps) {
    std::vector<double> fee(count_, 0);
    std::vector<int> before(count_, 0);
    double best = 0, size = 0;
    for (int k = 0; k < steps; ++k) {
      const double bound = least_one_tree(fee);
      best = std::max(best, bound);
      if (k == 0) size = 2 * (good - bound) / static_cast<double>(count_);
      for (std::size_t i = 0; i < count_; ++i) {
        const int excess = hops_[i] - 2;
        fee[i] += size * (0.7 * excess + 0.3 * before[i]);
        before[i] = excess;
      }
      size *= 1 - 6.0 / steps;
    }
    return best;
  }

 private:
  double cost(std::size_t a, std::size_t b, const std::vector<double>& fee) const {
    return cost_[a * count_ + b] + fee[a] + fee[b];
  }

  /// Over all places but the first, whose two least hops are added; fees are taken off again.
  double least_one_tree(const std::vector<double>& fee) {
    hops_.assign(count_, 0);
    double total = 0;
    std::vector<double> nearest(count_, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> by(count_, 1);
    std::vector<bool> in(count_, false);
    in[1] = true;
    for (std::size_t added = 1, last = 1; added + 1 < count_; ++added) {
      std::size_t next = 0;
      for (std::size_t i = 2; i < count_; ++i) {
        if (in[i]) continue;
        if (const double c = cost(last, i, fee); c < nearest[i]) nearest[i] = c, by[i] = last;
        if (next == 0 || nearest[i] < nearest[next]) next = i;
      }
      in[next] = true;
      total += nearest[next];
      ++hops_[next], ++hops_[by[next]];
      last = next;
    }
    std::vector<std::size_t> others;
    for (std::size_t i = 1; i < count_; ++i) others.push_back(i);
    std::partial_sort(others.begin(), others.begin() + 2, others.end(),
                      [&](auto a, auto b) { return cost(0, a, fee) < cost(0, b, fee); });
    for (int k = 0; k < 2; ++k) total += cost(0, others[k], fee), ++hops_[0], ++hops_[others[k]];
    for (const double f : fee) total -= 2 * f;
    return total;
  }

  std::size_t count_;
  std::vector<double> cost_;
  std::vector<int> hops_;
};

}  // namespace skein::refiners::test
