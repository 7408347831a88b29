// SPDX-License-Identifier: Apache-2.0
// Floyd and Warshall before every decision: for small networks.
#include "hopeful_executor.hpp"

#include <algorithm>

namespace skein::temporal::testing {

bool HopefulExecutor::survives(const std::vector<Ticks>& durations) {
  dates_.assign(network_.nodes.size(), std::nullopt);
  dates_[network_.origin] = 0;
  now_ = 0;
  while (work_out()) {
    const auto end = next_end(durations);
    const auto choice = next_choice();
    if (!end && !choice) return true;
    const Choice& next = end && (!choice || end->at <= choice->at) ? *end : *choice;
    now_ = next.at;
    dates_[next.node] = next.at;
  }
  return false;
}

/// Distances among all nodes: requirements, durations within bounds, dates so far, the rest not
/// before now.
bool HopefulExecutor::work_out() {
  const std::size_t nodes = network_.nodes.size();
  distance_.assign(nodes, std::vector<Ticks>(nodes, kInfinite));
  const auto add = [&](NodeIndex from, NodeIndex to, Ticks min, Ticks max) {
    distance_[from][to] = std::min(distance_[from][to], max);
    if (min != kMinusInfinite) distance_[to][from] = std::min(distance_[to][from], -min);
  };
  for (NodeIndex node = 0; node < nodes; ++node) {
    distance_[node][node] = 0;
    add(network_.origin, node, dates_[node].value_or(now_), dates_[node].value_or(kInfinite));
  }
  for (const Arc& arc : network_.arcs) add(arc.from, arc.to, arc.min, arc.max);
  for (const ContingentLink& link : network_.contingent) {
    add(link.activation, link.contingent, link.min, link.max);
  }
  for (NodeIndex k = 0; k < nodes; ++k) {
    for (NodeIndex i = 0; i < nodes; ++i) {
      for (NodeIndex j = 0; j < nodes; ++j) {
        if (distance_[i][k] == kInfinite || distance_[k][j] == kInfinite) continue;
        distance_[i][j] = std::min(distance_[i][j], distance_[i][k] + distance_[k][j]);
      }
    }
  }
  for (NodeIndex node = 0; node < nodes; ++node) {
    if (distance_[node][node] < 0) return false;
  }
  return true;
}

Ticks HopefulExecutor::earliest(NodeIndex node) const { return -distance_[node][network_.origin]; }
Ticks HopefulExecutor::latest(NodeIndex node) const { return distance_[network_.origin][node]; }

bool HopefulExecutor::is_end(NodeIndex node) const {
  return std::any_of(
      network_.contingent.begin(), network_.contingent.end(),
      [&](const ContingentLink& link) { return link.contingent == node && link.min != link.max; });
}

std::optional<HopefulExecutor::Choice> HopefulExecutor::next_choice() const {
  std::optional<Choice> next;
  for (NodeIndex node = 0; node < dates_.size(); ++node) {
    if (dates_[node] || is_end(node)) continue;
    const Ticks at =
        style_ == Style::kEarliest || latest(node) == kInfinite ? earliest(node) : latest(node);
    if (!next || at < next->at) next = Choice{node, at};
  }
  return next;
}

std::optional<HopefulExecutor::Choice> HopefulExecutor::next_end(
    const std::vector<Ticks>& durations) const {
  std::optional<Choice> next;
  for (std::size_t i = 0; i < durations.size(); ++i) {
    const ContingentLink& link = network_.contingent[i];
    if (link.min == link.max || dates_[link.contingent] || !dates_[link.activation]) continue;
    const Ticks at = *dates_[link.activation] + durations[i];
    if (!next || at < next->at) next = Choice{link.contingent, at};
  }
  return next;
}

}  // namespace skein::temporal::testing
