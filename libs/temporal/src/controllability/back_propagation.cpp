// SPDX-License-Identifier: Apache-2.0
// Walks backwards from negative nodes, with a stack of its own.
#include "back_propagation.hpp"

#include <functional>
#include <optional>
#include <queue>
#include <utility>

namespace skein::temporal {

struct BackPropagation::Walk {
  using Entry = std::pair<Ticks, NodeIndex>;
  NodeIndex source;
  std::vector<Ticks> distance;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::optional<NodeIndex> waiting;  ///< settled, to be passed when its own walk is finished

  void reach(NodeIndex node, Ticks candidate) {
    if (candidate >= distance[node]) return;
    distance[node] = candidate;
    queue.emplace(candidate, node);
  }
};

BackPropagation::BackPropagation(const Stnu& network, bool keep)
    : keep_(keep),
      given_nodes_(network.nodes.size()),
      plus_(given_nodes_),
      minus_(given_nodes_),
      waits_for_(given_nodes_, 0) {
  for (const Arc& arc : network.arcs) {
    if (arc.max != kInfinite) add(arc.from, arc.to, arc.max);
    if (arc.min != kMinusInfinite) add(arc.to, arc.from, -arc.min);
  }
  for (std::uint32_t i = 0; i < network.contingent.size(); ++i) add_link(network.contingent[i], i);
  state_.assign(plus_.size(), State::kFresh);
  found_.resize(plus_.size());
}

void BackPropagation::add(NodeIndex from, NodeIndex to, Ticks weight) {
  (weight < 0 ? minus_ : plus_)[to].push_back({from, weight, false});
}

void BackPropagation::add_link(const ContingentLink& link, std::uint32_t given) {
  if (link.min == link.max) {
    add(link.activation, link.contingent, link.max);
    add(link.contingent, link.activation, -link.min);
    return;
  }
  const auto middle = static_cast<NodeIndex>(plus_.size());
  const Ticks spread = link.max - link.min;
  links_.push_back(link);
  given_.push_back(given);
  plus_.emplace_back();
  minus_.emplace_back();
  waits_for_.push_back(static_cast<std::uint32_t>(links_.size()));
  add(link.activation, middle, link.min);
  add(middle, link.activation, -link.min);
  add(link.contingent, middle, 0);
  plus_[link.contingent].push_back({middle, 0, true});
  minus_[middle].push_back({link.contingent, -spread, false});
}

bool BackPropagation::run() {
  for (NodeIndex node = 0; node < plus_.size(); ++node) {
    if (!minus_[node].empty() && state_[node] == State::kFresh && !walk_from(node)) return false;
  }
  return true;
}

bool BackPropagation::walk_from(NodeIndex source) {
  std::vector<Walk> walks;
  walks.push_back(begin(source));
  while (!walks.empty()) {
    switch (advance(walks.back())) {
      case Step::kGoOn:
        break;
      case Step::kFinished:
        state_[walks.back().source] = State::kClosed;
        walks.pop_back();
        break;
      case Step::kInterrupted:
        walks.push_back(begin(interrupting_));
        break;
      case Step::kBroken:
        return false;
    }
  }
  return true;
}

BackPropagation::Walk BackPropagation::begin(NodeIndex source) {
  state_[source] = State::kOpen;
  Walk walk{source, std::vector<Ticks>(plus_.size(), kInfinite), {}, std::nullopt};
  for (const Edge& edge : minus_[source]) walk.reach(edge.from, edge.weight);
  return walk;
}

BackPropagation::Step BackPropagation::advance(Walk& walk) {
  if (walk.waiting) {
    pass(walk, *std::exchange(walk.waiting, std::nullopt));
    return Step::kGoOn;
  }
  if (walk.queue.empty()) return Step::kFinished;
  const auto [distance, node] = walk.queue.top();
  walk.queue.pop();
  if (distance != walk.distance[node]) return Step::kGoOn;
  settle(walk, node);
  if (distance >= 0) return Step::kGoOn;
  if (!minus_[node].empty()) {
    if (state_[node] == State::kOpen) return Step::kBroken;
    if (state_[node] == State::kFresh) {
      walk.waiting = node;
      interrupting_ = node;
      return Step::kInterrupted;
    }
  }
  pass(walk, node);
  return Step::kGoOn;
}

void BackPropagation::settle(Walk& walk, NodeIndex node) {
  if (node == walk.source) return;
  const Ticks distance = walk.distance[node];
  if (distance >= 0) plus_[walk.source].push_back({node, distance, false});
  if (keep_) found_[walk.source].push_back({node, distance});
}

void BackPropagation::pass(Walk& walk, NodeIndex node) {
  const std::uint32_t own = waits_for_[walk.source];
  for (const Edge& edge : plus_[node]) {
    // Nature does not end a link early to suit the wait for that same end.
    if (edge.lower && own != 0 && links_[own - 1].contingent == node) continue;
    walk.reach(edge.from, walk.distance[node] + edge.weight);
  }
}

}  // namespace skein::temporal
