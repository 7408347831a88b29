// SPDX-License-Identifier: Apache-2.0
// The macro-STN of an agent: constraints between its frontier nodes, as published to the others.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "network/elimination.hpp"
#include "skein/temporal/message.hpp"
#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Components are those of the local network without its frontier nodes, of which v0 is one
/// (erratum 13). A change re-eliminates the component it touches; a macro-constraint is the
/// strongest of the direct arcs and of the components between its two nodes. While a component has
/// a positive cycle its last macro-constraints stay, and the status flag is false.
class MacroNetwork {
 public:
  MacroNetwork(const Mastn& network, AgentIndex self);

  /// `arc`: position in `Mastn::arcs` of an own local arc.
  void set_arc(std::uint32_t arc, Ticks min, Ticks max);
  /// The macro-constraints that changed since the last update, or nothing.
  std::optional<MacroUpdates> update();
  /// The last published value of every macro-constraint ever published.
  MacroUpdates published() const;
  std::uint64_t checks() const { return checks_; }

 private:
  struct LocalArc {
    NodeIndex from;
    NodeIndex to;
    Ticks forward;
    Ticks backward;
    std::uint32_t component;  ///< kNone: a direct arc
    std::uint32_t place;      ///< in the component, or in pairs_
  };
  struct Component {
    Elimination elimination;
    std::vector<NodeIndex> nodes;
    std::vector<std::pair<Ticks, Ticks>> weights;
    std::vector<std::uint32_t> pairs;  ///< of each outer edge
    bool consistent = true;
    bool touched = true;
  };
  struct Part {
    std::uint32_t component;
    std::uint32_t edge;
    bool reversed;
  };
  /// Two frontier nodes, the first the smaller.
  struct Pair {
    NodeIndex first;
    NodeIndex second;
    std::vector<Part> parts;
    std::vector<std::uint32_t> direct;  ///< in arcs_
    Ticks forward = kMinusInfinite;     ///< as published
    Ticks backward = kMinusInfinite;
    bool forward_known = false;  ///< ever published
    bool backward_known = false;
    bool touched = true;
  };

  void read_arcs(const Mastn& network, AgentIndex self);
  void find_components();
  std::vector<NodeIndex> inner_nodes_from(NodeIndex start, std::vector<bool>& reached) const;
  void add_component(const std::vector<NodeIndex>& inner);
  void add_pairs_of(std::uint32_t index);
  void add_direct_arcs();
  std::uint32_t pair_of(NodeIndex a, NodeIndex b);
  void eliminate(Component& component);
  void publish(Pair& pair, MacroUpdates& updates) const;

  std::vector<bool> frontier_;
  std::vector<std::vector<std::uint32_t>> arcs_at_;  ///< of a node, in arcs_
  std::map<std::uint32_t, std::uint32_t> local_;     ///< position in Mastn::arcs to arcs_
  std::vector<LocalArc> arcs_;
  std::vector<Component> components_;
  std::vector<Pair> pairs_;
  std::map<std::pair<NodeIndex, NodeIndex>, std::uint32_t> pair_index_;
  std::vector<std::uint32_t> touched_components_;
  std::vector<std::uint32_t> touched_pairs_;
  bool consistent_published_ = true;
  std::uint32_t inconsistent_components_ = 0;
  std::uint64_t checks_ = 0;
};

/// Nodes with an external arc, and v0.
std::vector<bool> frontier_of(const Mastn& network);

}  // namespace skein::temporal
