// SPDX-License-Identifier: Apache-2.0
// The macro-STN of one agent, kept up to date component by component.
#include "macro_network.hpp"

#include <algorithm>

#include "network/propagation.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/temporal/agent.hpp"

namespace skein::temporal {

std::vector<bool> frontier_of(const Mastn& network) {
  std::vector<bool> frontier(network.nodes.size(), false);
  frontier[0] = true;
  for (const Arc& arc : network.arcs) {
    if (is_external(network, arc)) frontier[arc.from] = frontier[arc.to] = true;
  }
  return frontier;
}

MacroNetwork::MacroNetwork(const Mastn& network, AgentIndex self)
    : frontier_(frontier_of(network)), arcs_at_(network.nodes.size()) {
  read_arcs(network, self);
  find_components();
  add_direct_arcs();
}

void MacroNetwork::read_arcs(const Mastn& network, AgentIndex self) {
  for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    if (is_external(network, arc) || owner_of(network, arc) != self) continue;
    const auto local = static_cast<std::uint32_t>(arcs_.size());
    local_.emplace(i, local);
    arcs_.push_back({arc.from, arc.to, weight_of_min(arc.min), weight_of_max(arc.max), kNone, 0});
    arcs_at_[arc.from].push_back(local);
    arcs_at_[arc.to].push_back(local);
  }
}

void MacroNetwork::find_components() {
  std::vector<bool> reached = frontier_;
  for (NodeIndex node = 0; node < arcs_at_.size(); ++node) {
    if (reached[node] || arcs_at_[node].empty()) continue;
    add_component(inner_nodes_from(node, reached));
  }
}

std::vector<NodeIndex> MacroNetwork::inner_nodes_from(NodeIndex start,
                                                      std::vector<bool>& reached) const {
  std::vector<NodeIndex> inner{start};
  reached[start] = true;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    for (const std::uint32_t a : arcs_at_[inner[i]]) {
      for (const NodeIndex other : {arcs_[a].from, arcs_[a].to}) {
        if (reached[other]) continue;
        reached[other] = true;
        inner.push_back(other);
      }
    }
  }
  return inner;
}

void MacroNetwork::add_component(const std::vector<NodeIndex>& inner) {
  const auto index = static_cast<std::uint32_t>(components_.size());
  std::vector<NodeIndex> nodes = inner;
  std::map<NodeIndex, std::uint32_t> place;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) place.emplace(nodes[i], i);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  std::vector<std::pair<Ticks, Ticks>> weights;
  const auto place_of = [&](NodeIndex node) {
    const auto [found, is_new] = place.emplace(node, static_cast<std::uint32_t>(nodes.size()));
    if (is_new) nodes.push_back(node);
    return found->second;
  };
  for (const NodeIndex node : inner) {
    for (const std::uint32_t a : arcs_at_[node]) {
      LocalArc& arc = arcs_[a];
      if (arc.component != kNone) continue;  // seen from its other end
      arc.component = index;
      arc.place = static_cast<std::uint32_t>(weights.size());
      const std::uint32_t from = place_of(arc.from);
      ends.emplace_back(from, place_of(arc.to));
      weights.emplace_back(arc.forward, arc.backward);
    }
  }
  Elimination elimination(static_cast<std::uint32_t>(inner.size()),
                          static_cast<std::uint32_t>(nodes.size()), ends);
  components_.push_back({std::move(elimination), std::move(nodes), std::move(weights), {}});
  add_pairs_of(index);
  touched_components_.push_back(index);
}

void MacroNetwork::add_pairs_of(std::uint32_t index) {
  Component& component = components_[index];
  for (const std::uint32_t e : component.elimination.outer_edges()) {
    const Elimination::Edge& edge = component.elimination.edge(e);
    const NodeIndex first = component.nodes[edge.first];
    const std::uint32_t pair = pair_of(first, component.nodes[edge.second]);
    component.pairs.push_back(pair);
    pairs_[pair].parts.push_back({index, e, pairs_[pair].first != first});
  }
}

void MacroNetwork::add_direct_arcs() {
  for (std::uint32_t a = 0; a < arcs_.size(); ++a) {
    LocalArc& arc = arcs_[a];
    if (arc.component != kNone) continue;
    arc.place = pair_of(arc.from, arc.to);
    pairs_[arc.place].direct.push_back(a);
  }
}

std::uint32_t MacroNetwork::pair_of(NodeIndex a, NodeIndex b) {
  const auto next = static_cast<std::uint32_t>(pairs_.size());
  const auto [found, is_new] = pair_index_.emplace(std::minmax(a, b), next);
  if (is_new) {
    Pair pair{};
    pair.first = std::min(a, b);
    pair.second = std::max(a, b);
    pairs_.push_back(std::move(pair));
    touched_pairs_.push_back(next);
  }
  return found->second;
}

void MacroNetwork::set_arc(std::uint32_t position, Ticks min, Ticks max) {
  SKEIN_EXPECTS(local_.contains(position));
  LocalArc& arc = arcs_[local_.at(position)];
  arc.forward = weight_of_min(min);
  arc.backward = weight_of_max(max);
  if (arc.component == kNone) {
    if (!std::exchange(pairs_[arc.place].touched, true)) touched_pairs_.push_back(arc.place);
    return;
  }
  Component& component = components_[arc.component];
  component.weights[arc.place] = {arc.forward, arc.backward};
  if (!std::exchange(component.touched, true)) touched_components_.push_back(arc.component);
}

std::optional<MacroUpdates> MacroNetwork::update() {
  for (const std::uint32_t component : touched_components_) eliminate(components_[component]);
  touched_components_.clear();
  std::sort(touched_pairs_.begin(), touched_pairs_.end());
  MacroUpdates updates;
  for (const std::uint32_t pair : touched_pairs_) publish(pairs_[pair], updates);
  touched_pairs_.clear();
  updates.consistent = inconsistent_components_ == 0;
  const bool flag_changed = updates.consistent != consistent_published_;
  consistent_published_ = updates.consistent;
  if (updates.constraints.empty() && !flag_changed) return std::nullopt;
  return updates;
}

void MacroNetwork::eliminate(Component& component) {
  component.touched = false;
  const bool before =
      std::exchange(component.consistent, component.elimination.run(component.weights, checks_));
  if (before && !component.consistent) ++inconsistent_components_;
  if (!before && component.consistent) --inconsistent_components_;
  if (!component.consistent) return;
  for (const std::uint32_t pair : component.pairs) {
    if (!std::exchange(pairs_[pair].touched, true)) touched_pairs_.push_back(pair);
  }
}

void MacroNetwork::publish(Pair& pair, MacroUpdates& updates) const {
  pair.touched = false;
  Ticks forward = kMinusInfinite;
  Ticks backward = kMinusInfinite;
  const auto combine = [&](Ticks along, Ticks against, bool reversed) {
    forward = std::max(forward, reversed ? against : along);
    backward = std::max(backward, reversed ? along : against);
  };
  for (const Part& part : pair.parts) {
    const Elimination::Edge& edge = components_[part.component].elimination.edge(part.edge);
    combine(edge.forward, edge.backward, part.reversed);
  }
  for (const std::uint32_t a : pair.direct) {
    combine(arcs_[a].forward, arcs_[a].backward, arcs_[a].from != pair.first);
  }
  if (forward != pair.forward) {
    updates.constraints.push_back({pair.first, pair.second, forward});
    pair.forward_known = true;
  }
  if (backward != pair.backward) {
    updates.constraints.push_back({pair.second, pair.first, backward});
    pair.backward_known = true;
  }
  pair.forward = forward;
  pair.backward = backward;
}

MacroUpdates MacroNetwork::published() const {
  MacroUpdates all;
  for (const Pair& pair : pairs_) {
    if (pair.forward_known) all.constraints.push_back({pair.first, pair.second, pair.forward});
    if (pair.backward_known) all.constraints.push_back({pair.second, pair.first, pair.backward});
  }
  all.consistent = consistent_published_;
  return all;
}

}  // namespace skein::temporal
