// SPDX-License-Identifier: Apache-2.0
// The dispatchable form, from Morris's algorithm, with the cut nodes A' folded back into A.
#include "skein/temporal/dispatchable_network.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "back_propagation.hpp"
#include "implied_edges.hpp"
#include "skein/temporal/stnu_controllability.hpp"

namespace skein::temporal {

namespace {

/// Gathers edges and waits; of each pair of nodes the strongest stays.
class Gathering {
 public:
  explicit Gathering(const BackPropagation& result) : result_(result) {}

  void add_walk(NodeIndex source) {
    const bool cut = source >= result_.node_count();
    for (const BackPropagation::Found& found : result_.found_from(source)) {
      if (cut && found.distance < 0) {
        add_wait(source, found);
      } else {
        add_edge(found.from, source, found.distance);
      }
    }
  }

  /// A' is A + min, so distances to and from it are distances to and from A.
  void add_edge(NodeIndex from, NodeIndex to, Ticks weight) {
    const auto [source, source_offset] = folded(from);
    const auto [target, target_offset] = folded(to);
    if (source == target) return;
    edges_.push_back({source, target, weight + source_offset - target_offset});
  }

  void finish(DispatchableNetwork& out) {
    out.edges = strongest_edges();
    for (const auto& [key, delay] : waits_) {
      if (!implied(out.edges, key, delay))
        out.waits.push_back({key.first, result_.given()[key.second], delay});
    }
    out.edges = without_implied_edges(out.edges, out.plan.nodes.size());
  }

 private:
  std::pair<NodeIndex, Ticks> folded(NodeIndex node) const {
    if (node < result_.node_count()) return {node, 0};
    const ContingentLink& link = result_.links()[node - result_.node_count()];
    return {link.activation, link.min};
  }

  void add_wait(NodeIndex cut, const BackPropagation::Found& found) {
    const auto link = static_cast<std::uint32_t>(cut - result_.node_count());
    const ContingentLink& facts = result_.links()[link];
    const auto [node, offset] = folded(found.from);
    if (node == facts.contingent || node == facts.activation) return;
    const Ticks asked = facts.min - found.distance - offset;
    if (asked <= facts.min) return;  // no end comes before: an ordinary edge says as much
    Ticks& delay = waits_[{node, link}];
    delay = std::max(delay, asked);
  }

  std::vector<DistanceEdge> strongest_edges() {
    std::sort(edges_.begin(), edges_.end(), [](const DistanceEdge& a, const DistanceEdge& b) {
      return std::tie(a.from, a.to, a.weight) < std::tie(b.from, b.to, b.weight);
    });
    const auto last =
        std::unique(edges_.begin(), edges_.end(), [](const DistanceEdge& a, const DistanceEdge& b) {
          return a.from == b.from && a.to == b.to;
        });
    edges_.erase(last, edges_.end());
    return std::move(edges_);
  }

  bool implied(const std::vector<DistanceEdge>& edges, std::pair<NodeIndex, std::uint32_t> wait,
               Ticks delay) const {
    const NodeIndex activation = result_.links()[wait.second].activation;
    const auto at =
        std::lower_bound(edges.begin(), edges.end(), std::pair{wait.first, activation},
                         [](const DistanceEdge& edge, const std::pair<NodeIndex, NodeIndex>& pair) {
                           return std::pair{edge.from, edge.to} < pair;
                         });
    return at != edges.end() && at->from == wait.first && at->to == activation &&
           -at->weight >= delay;
  }

  const BackPropagation& result_;
  std::vector<DistanceEdge> edges_;
  std::map<std::pair<NodeIndex, std::uint32_t>, Ticks> waits_;
};

Stnu after_origin(const Stnu& network) {
  Stnu started = network;
  for (NodeIndex node = 0; node < network.nodes.size(); ++node) {
    if (node != network.origin) started.arcs.push_back({network.origin, node, 0, kInfinite});
  }
  return started;
}

void add_given_edges(const Stnu& network, Gathering& gathering) {
  const auto add = [&](NodeIndex from, NodeIndex to, Ticks min, Ticks max) {
    if (max != kInfinite) gathering.add_edge(from, to, max);
    if (min != kMinusInfinite) gathering.add_edge(to, from, -min);
  };
  for (const Arc& arc : network.arcs) add(arc.from, arc.to, arc.min, arc.max);
  for (const ContingentLink& link : network.contingent) {
    add(link.activation, link.contingent, link.min, link.max);
  }
}

}  // namespace

Result<DispatchableNetwork, StnuError> make_dispatchable(const Stnu& network) {
  if (const auto fault = find_fault(network)) return tl::unexpected(*fault);
  for (std::uint32_t i = 0; i < network.contingent.size(); ++i) {
    if (network.contingent[i].contingent == network.origin) {
      return tl::unexpected<StnuError>(
          {StnuFault::kContingentOrigin, LinkRef{LinkKind::kContingent, i}});
    }
  }
  const Stnu started = after_origin(network);
  // Back-propagation saturates; whether all distances fit is for the check to say.
  const auto checked = check_dynamic_controllability(started);
  if (!checked) return tl::unexpected(checked.error());
  BackPropagation propagation(started, true);
  if (!propagation.run())
    return tl::unexpected<StnuError>({StnuFault::kNotControllable, std::nullopt});
  DispatchableNetwork out;
  out.plan = network;
  Gathering gathering(propagation);
  const std::size_t all = propagation.node_count() + propagation.links().size();
  for (NodeIndex source = 0; source < all; ++source) gathering.add_walk(source);
  add_given_edges(started, gathering);
  gathering.finish(out);
  return out;
}

}  // namespace skein::temporal
