// SPDX-License-Identifier: Apache-2.0
// Dijkstra's algorithm with a limit on the true distance.
#include "link_search.hpp"

namespace skein::temporal {

void LinkSearch::add_node() {
  queue_.grow();
  reached_.push_back(kUnseen);
  distance_.emplace_back();
  via_.emplace_back();
}

void LinkSearch::reset() {
  for (const NodeIndex node : touched_) reached_[node] = kUnseen;
  touched_.clear();
  settled_.clear();
  queue_.clear();
}

std::uint32_t LinkSearch::run(const LoGraph& graph, const BestCaseSchedule& schedule,
                              std::uint32_t link, const std::vector<std::uint8_t>* ready) {
  reset();
  const NodeIndex end = graph.link(link).end;
  const Ticks spread = graph.link(link).spread();
  reached_[end] = kQueued;
  touched_.push_back(end);
  queue_.lower(end, 0);
  while (!queue_.empty()) {
    const NodeIndex node = queue_.pop();
    const Ticks distance = queue_.key(node) - schedule.date(node) + schedule.date(end);
    reached_[node] = kSettled;
    distance_[node] = distance;
    settled_.push_back(node);
    if (distance >= spread) continue;
    if (ready != nullptr) {
      for (const std::uint32_t other : graph.links_activated(node)) {
        if ((*ready)[other] == 0) return other;
      }
    }
    pass(graph, schedule, node, link);
  }
  return kNone;
}

void LinkSearch::pass(const LoGraph& graph, const BestCaseSchedule& schedule, NodeIndex node,
                      std::uint32_t link) {
  const Ticks key = queue_.key(node);
  const Ticks date = schedule.date(node);
  for_each_edge_into(graph, node, link, [&](NodeIndex from, Ticks weight, EdgeRef edge) {
    ++relaxations_;
    if (reached_[from] == kSettled) return;
    const Ticks candidate = key + (weight + schedule.date(from) - date);
    if (reached_[from] == kUnseen) {
      reached_[from] = kQueued;
      touched_.push_back(from);
    }
    if (queue_.lower(from, candidate)) via_[from] = {node, edge};
  });
}

std::vector<PathStep> LinkSearch::Table::path_from(NodeIndex node, NodeIndex end) const {
  std::vector<PathStep> path;
  while (node != end) {
    path.push_back({node, via[node].next, via[node].edge});
    node = via[node].next;
  }
  return path;
}

std::vector<LoGraph::Edge> LinkSearch::derived_edges(const LoGraph::Link& link) const {
  std::vector<LoGraph::Edge> edges;
  for (const NodeIndex node : settled_) {
    if (!derives_edge(link, node, distance_[node])) continue;
    edges.push_back({node, derived_weight(link, distance_[node])});
  }
  return edges;
}

}  // namespace skein::temporal
