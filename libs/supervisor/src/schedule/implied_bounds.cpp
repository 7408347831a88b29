// SPDX-License-Identifier: Apache-2.0
#include "schedule/implied_bounds.hpp"

#include <deque>

#include "skein/temporal/stn_engine.hpp"

namespace skein::supervisor {

using temporal::kInfinite;
using temporal::NodeIndex;
using temporal::Ticks;

void ImpliedBounds::add(NodeIndex from, NodeIndex to, Ticks weight, bool kept) {
  out_[from].push_back({to, weight, kept});
}

/// Something is to come so long after it at the latest, directly or after its own end.
bool ImpliedBounds::bounds_another(NodeIndex node) const {
  for (const Edge& edge : out_[node]) {
    if (edge.kept) continue;
    for (const Edge& next : out_[edge.to])
      if (next.to != node) return true;
  }
  return false;
}

/// In a network without contradictions each distance settles.
template <class Beyond>
std::vector<Ticks> ImpliedBounds::distances(NodeIndex from, Beyond&& beyond) const {
  std::vector<Ticks> distance(out_.size(), kInfinite);
  std::vector<bool> is_open(out_.size(), false);
  std::deque<NodeIndex> open = {from};
  distance[from] = 0;
  while (!open.empty()) {
    const NodeIndex node = open.front();
    open.pop_front();
    is_open[node] = false;
    for (const Edge& edge : out_[node]) {
      if (is_past_[edge.to] || !beyond(edge, distance[node])) continue;
      const Ticks there = distance[node] + edge.weight;
      if (there >= distance[edge.to]) continue;
      distance[edge.to] = there;
      if (is_open[edge.to]) continue;
      is_open[edge.to] = true;
      open.push_back(edge.to);
    }
  }
  return distance;
}

void ImpliedBounds::may_last(NodeIndex start, NodeIndex end, Ticks least) {
  if (is_past_[start]) return;
  const auto before = distances(end, [&](const Edge& edge, Ticks at) {
    return at >= 0 && edge.to != start;  // what comes before that is reached from there
  });
  for (NodeIndex other = 0; other < out_.size(); ++other)
    if (before[other] < 0) out_[start].push_back({other, least + before[other], false});
}

std::vector<ImpliedBounds::Bound> ImpliedBounds::of(NodeIndex node) const {
  std::vector<Bound> result;
  if (!bounds_another(node)) return result;
  const auto by_all = [](const Edge&, Ticks) { return true; };
  const auto by_kept = [](const Edge& edge, Ticks) { return edge.kept; };
  const std::vector<Ticks> asked = distances(node, by_all), kept = distances(node, by_kept);
  for (NodeIndex other = 0; other < out_.size(); ++other) {
    if (other == node || asked[other] > 0 || asked[other] >= kept[other]) continue;
    // Two that come together do not wait for each other.
    if (asked[other] == 0 && distances(other, by_kept)[node] <= 0) continue;
    result.push_back({other, -asked[other]});
  }
  return result;
}

}  // namespace skein::supervisor
