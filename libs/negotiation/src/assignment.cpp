// SPDX-License-Identifier: Apache-2.0
#include "assignment.hpp"

#include <algorithm>
#include <map>

namespace skein::interaction {

namespace {

/// How many rows from one on are to be in each column.
using Counts = std::vector<int>;

struct Best {
  double cost = 0;
  std::size_t column = 0;
};

/// From the last row back: for each way of counts that the rows from there on can make, the least
/// cost and the column of the first of them.
class Backwards {
 public:
  Backwards(const std::vector<std::vector<std::optional<double>>>& costs,
            const std::vector<Arity>& arities)
      : costs_(costs), arities_(arities), layers_(costs.size() + 1) {
    layers_[costs.size()][Counts(arities.size(), 0)] = {};
    for (std::size_t row = costs.size(); row-- > 0;) extend(row);
  }

  std::optional<Assignment> best() const {
    const std::pair<const Counts, Best>* found = nullptr;
    std::optional<Assignment> assignment;
    for (const auto& one : layers_.front()) {
      if (!enough(one.first)) continue;
      if (found != nullptr && one.second.cost > found->second.cost) continue;
      Assignment way = way_of(one.first);
      const bool better = found == nullptr || one.second.cost < found->second.cost;
      if (better || way < *assignment) assignment = std::move(way);
      found = &one;
    }
    return assignment;
  }

 private:
  void extend(std::size_t row) {
    for (const auto& [counts, rest] : layers_[row + 1]) {
      for (std::size_t column = 0; column < arities_.size(); ++column) {
        if (!costs_[row][column]) continue;
        Counts more = counts;
        if (++more[column] > arities_[column].most.value_or(more[column])) continue;
        const Best best{*costs_[row][column] + rest.cost, column};
        const auto [at, fresh] = layers_[row].emplace(std::move(more), best);
        if (!fresh && best.cost < at->second.cost) at->second = best;
        if (!fresh && best.cost == at->second.cost) {
          at->second.column = std::min(at->second.column, column);
        }
      }
    }
  }

  bool enough(const Counts& counts) const {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (counts[i] < arities_[i].least) return false;
    }
    return true;
  }

  Assignment way_of(Counts counts) const {
    Assignment way;
    for (std::size_t row = 0; row < costs_.size(); ++row) {
      way.push_back(layers_[row].at(counts).column);
      --counts[way.back()];
    }
    return way;
  }

  const std::vector<std::vector<std::optional<double>>>& costs_;
  const std::vector<Arity>& arities_;
  std::vector<std::map<Counts, Best>> layers_;
};

}  // namespace

std::optional<Assignment> assign(const std::vector<std::vector<std::optional<double>>>& costs,
                                 const std::vector<Arity>& arities) {
  return Backwards(costs, arities).best();
}

}  // namespace skein::interaction
