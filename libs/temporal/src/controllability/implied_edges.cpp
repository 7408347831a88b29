// SPDX-License-Identifier: Apache-2.0
// Looks, for each target, at the edges into it as a column of a matrix.
#include "implied_edges.hpp"

#include <cstdint>

namespace skein::temporal {

namespace {

class Implied {
 public:
  Implied(const std::vector<DistanceEdge>& edges, std::size_t nodes) : edges_(edges) {
    to_target_.assign(nodes, kInfinite);
    begin_.assign(nodes + 1, 0);
    for (const DistanceEdge& edge : edges) ++begin_[edge.from + 1];
    for (std::size_t node = 0; node < nodes; ++node) begin_[node + 1] += begin_[node];
  }

  /// Among the edges into one target, given by their numbers.
  void mark(const std::vector<std::uint32_t>& into, std::vector<bool>& implied) {
    for (const std::uint32_t i : into) to_target_[edges_[i].from] = edges_[i].weight;
    for (const std::uint32_t i : into) implied[i] = replaced(edges_[i]);
    for (const std::uint32_t i : into) to_target_[edges_[i].from] = kInfinite;
  }

 private:
  bool replaced(const DistanceEdge& edge) const {
    for (std::uint32_t i = begin_[edge.from]; i < begin_[edge.from + 1]; ++i) {
      const Ticks first = edges_[i].weight;
      const Ticks second = to_target_[edges_[i].to];
      if (second == kInfinite) continue;
      if (edge.weight < 0 ? first < 0 && second < 0 && first + second <= edge.weight
                          : second >= 0 && first + second < edge.weight) {
        return true;
      }
    }
    return false;
  }

  const std::vector<DistanceEdge>& edges_;
  std::vector<std::uint32_t> begin_;  ///< of the edges out of each node
  std::vector<Ticks> to_target_;      ///< weight of each node's edge to the present target
};

}  // namespace

std::vector<DistanceEdge> without_implied_edges(const std::vector<DistanceEdge>& edges,
                                                std::size_t nodes) {
  std::vector<std::vector<std::uint32_t>> into;
  into.resize(nodes);
  for (std::uint32_t i = 0; i < edges.size(); ++i) into[edges[i].to].push_back(i);
  Implied search(edges, nodes);
  std::vector<bool> implied(edges.size(), false);
  for (const std::vector<std::uint32_t>& numbers : into) search.mark(numbers, implied);
  std::vector<DistanceEdge> kept;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (!implied[i]) kept.push_back(edges[i]);
  }
  return kept;
}

}  // namespace skein::temporal
