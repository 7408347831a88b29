// SPDX-License-Identifier: Apache-2.0
// Morris's cubic algorithm: decides controllability and makes a network dispatchable.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Shares nothing with DcEngine, which it is compared with in tests. Works on the normal form: each
/// contingent link A -> C is cut at A' = A + min, so that it lasts between 0 and max - min. From
/// each node that negative edges enter, it goes backwards along edges that are not negative until
/// the distance is not negative either, and writes down what it finds; a walk that comes upon a
/// node whose own walk is unfinished closes a semi-reducible negative cycle. O(n³). No recursion.
/// Source: Morris 2014.
class BackPropagation {
 public:
  /// What a walk found: `from` is at `distance` from the node the walk started at.
  struct Found {
    NodeIndex from = 0;
    Ticks distance = 0;
  };

  /// Precondition: find_fault(network) is absent. `keep` writes down negative distances too, which
  /// the decision does not need and the dispatchable form does.
  BackPropagation(const Stnu& network, bool keep);

  /// True iff dynamically controllable. To be called once.
  bool run();

  // After run() said true, with `keep`. Nodes from node_count() on are the A' in the order of
  // links.
  std::size_t node_count() const { return given_nodes_; }
  const std::vector<ContingentLink>& links() const { return links_; }
  /// Positions in Stnu::contingent of the links that have min < max.
  const std::vector<std::uint32_t>& given() const { return given_; }
  /// Of a walk from an A', a negative distance is a wait.
  const std::vector<Found>& found_from(NodeIndex source) const { return found_[source]; }

 private:
  struct Edge {
    NodeIndex from = 0;
    Ticks weight = 0;
    bool lower = false;  ///< the lower-case edge of the link that ends in the target
  };
  enum class State : std::uint8_t { kFresh, kOpen, kClosed };
  struct Walk;
  enum class Step : std::uint8_t { kGoOn, kFinished, kInterrupted, kBroken };

  void add(NodeIndex from, NodeIndex to, Ticks weight);
  void add_link(const ContingentLink& link, std::uint32_t given);
  bool walk_from(NodeIndex source);
  Walk begin(NodeIndex source);
  Step advance(Walk& walk);
  void settle(Walk& walk, NodeIndex node);
  void pass(Walk& walk, NodeIndex node);

  bool keep_;
  std::size_t given_nodes_;
  std::vector<ContingentLink> links_;
  std::vector<std::uint32_t> given_;
  std::vector<std::vector<Edge>> plus_;   ///< edges into a node that are not negative
  std::vector<std::vector<Edge>> minus_;  ///< negative edges into a node
  std::vector<std::uint32_t> waits_for_;  ///< of an A', its link + 1; otherwise 0
  std::vector<State> state_;
  std::vector<std::vector<Found>> found_;
  NodeIndex interrupting_ = 0;
};

}  // namespace skein::temporal
