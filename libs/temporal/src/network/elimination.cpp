// SPDX-License-Identifier: Apache-2.0
// Elimination: oriented max-plus, least degree first.
#include "elimination.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace skein::temporal {
namespace {

/// Beyond what a time can be, a sum is cut to the nearest weaker one.
Ticks sum_of(Ticks a, Ticks b) {
  const Ticks sum = a + b;
  if (sum < -kLargest) return kMinusInfinite;
  return std::min(sum, kLargest);
}

bool is_positive_cycle(const Elimination::Edge& edge) {
  return edge.forward != kMinusInfinite && edge.backward != kMinusInfinite &&
         edge.forward + edge.backward > 0;
}

void combine(Ticks& weight, Ticks a, Ticks b, std::uint64_t& checks) {
  if (a == kMinusInfinite || b == kMinusInfinite) return;
  ++checks;
  weight = std::max(weight, sum_of(a, b));
}

}  // namespace

/// Chooses the order and creates the edges.
class Elimination::Planner {
 public:
  Planner(Elimination& plan, std::uint32_t nodes) : plan_(plan), neighbours_(nodes) {}

  std::uint32_t edge_between(std::uint32_t a, std::uint32_t b) {
    const auto place = neighbours_[a].find(b);
    if (place != neighbours_[a].end()) return place->second;
    const auto edge = static_cast<std::uint32_t>(plan_.edges_.size());
    plan_.edges_.push_back({a, b, kMinusInfinite, kMinusInfinite});
    neighbours_[a].emplace(b, edge);
    neighbours_[b].emplace(a, edge);
    return edge;
  }

  void eliminate(std::uint32_t inner) {
    std::set<std::pair<std::size_t, std::uint32_t>> order;
    for (std::uint32_t node = 0; node < inner; ++node) {
      order.emplace(neighbours_[node].size(), node);
    }
    while (!order.empty()) {
      const std::uint32_t node = order.begin()->second;
      order.erase(order.begin());
      const auto around = neighbours_[node];
      for (const auto& [other, edge] : around) {
        if (other < inner) order.erase({neighbours_[other].size(), other});
      }
      add_step(node, around);
      for (const auto& [other, edge] : around) {
        neighbours_[other].erase(node);
        if (other < inner) order.emplace(neighbours_[other].size(), other);
      }
    }
  }

 private:
  void add_step(std::uint32_t node, const std::map<std::uint32_t, std::uint32_t>& around) {
    Step step;
    for (const auto& [other, edge] : around) step.spokes.push_back(spoke(edge, node));
    for (auto i = around.begin(); i != around.end(); ++i) {
      for (auto j = std::next(i); j != around.end(); ++j) {
        const std::uint32_t edge = edge_between(i->first, j->first);
        step.pairs.push_back({spoke(i->second, node), spoke(j->second, node), edge,
                              plan_.edges_[edge].first != i->first});
      }
    }
    plan_.steps_.push_back(std::move(step));
  }

  Spoke spoke(std::uint32_t edge, std::uint32_t node) const {
    return {edge, plan_.edges_[edge].first == node};
  }

  Elimination& plan_;
  std::vector<std::map<std::uint32_t, std::uint32_t>> neighbours_;
};

Elimination::Elimination(std::uint32_t inner, std::uint32_t nodes,
                         const std::vector<std::pair<std::uint32_t, std::uint32_t>>& arcs) {
  Planner planner(*this, nodes);
  for (const auto& [from, to] : arcs) {
    const std::uint32_t edge = planner.edge_between(from, to);
    edge_of_arc_.push_back(edge);
    arc_reversed_.push_back(edges_[edge].first != from);
  }
  planner.eliminate(inner);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    if (edges_[i].first >= inner && edges_[i].second >= inner) outer_.push_back(i);
  }
}

bool Elimination::run(const std::vector<std::pair<Ticks, Ticks>>& weights, std::uint64_t& checks) {
  std::vector<Edge> edges = edges_;
  for (Edge& edge : edges) edge.forward = edge.backward = kMinusInfinite;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    Edge& edge = edges[edge_of_arc_[i]];
    Ticks& along = arc_reversed_[i] ? edge.backward : edge.forward;
    Ticks& against = arc_reversed_[i] ? edge.forward : edge.backward;
    along = std::max(along, weights[i].first);
    against = std::max(against, weights[i].second);
  }
  for (const Step& step : steps_) {
    if (!run_step(step, edges, checks)) return false;
  }
  for (const std::uint32_t i : outer_) {
    if (is_positive_cycle(edges[i])) return false;
  }
  edges_ = std::move(edges);
  return true;
}

bool Elimination::run_step(const Step& step, std::vector<Edge>& edges,
                           std::uint64_t& checks) const {
  for (const Spoke& spoke : step.spokes) {
    if (is_positive_cycle(edges[spoke.edge])) return false;
  }
  const auto inward = [&](const Spoke& s) {
    return s.reversed ? edges[s.edge].backward : edges[s.edge].forward;
  };
  const auto outward = [&](const Spoke& s) {
    return s.reversed ? edges[s.edge].forward : edges[s.edge].backward;
  };
  for (const Pair& pair : step.pairs) {
    Edge& edge = edges[pair.edge];
    combine(pair.reversed ? edge.backward : edge.forward, inward(pair.from), outward(pair.to),
            checks);
    combine(pair.reversed ? edge.forward : edge.backward, inward(pair.to), outward(pair.from),
            checks);
  }
  return true;
}

}  // namespace skein::temporal
