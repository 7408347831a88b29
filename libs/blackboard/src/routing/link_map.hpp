// SPDX-License-Identifier: Apache-2.0
// The links between all nodes, and the shortest routes over them.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard::routing {

/// A route to a node: its first hop, and the number of relays on it.
struct Way {
  NodeNumber next;
  std::size_t relays = 0;
  bool operator==(const Way&) const = default;
};

/// The link reports of all nodes (which nodes each one hears), and shortest routes over these
/// directed links.
///
/// A report counts only while there is a route from its author to this node on which it could have
/// come: the last report of a node out of reach may be outdated. So the links of a node that dies
/// or leaves disappear as soon as its neighbours report its loss, and reports need neither
/// repetition nor expiry. Reports come over relays only, like all other samples. A node cannot use
/// a link out of it that it has not been told of, so a link counts only if the report of its end
/// can reach its beginning. Then every node on the best route knows the rest of it, and routes get
/// shorter at each hop: there are no loops once the reports have arrived. Cost of ways(): links
/// times the logarithm of nodes.
class LinkMap {
 public:
  /// `relays`: the nodes that forward samples of other nodes.
  LinkMap(NodeNumber self, std::set<NodeNumber> relays) : self_(self), relays_(std::move(relays)) {}

  /// Replaces the report of `author`, which may be this node.
  void learn(NodeNumber author, const std::vector<wire::Neighbour>& hears);

  /// The best route to each reachable node: with few links, preferably steady ones; of equal routes
  /// the one with the first hop of `before`, otherwise with the smallest first hop.
  std::map<NodeNumber, Way> ways(const std::map<NodeNumber, Way>& before = {}) const;
  /// The nodes from which there is a route to this node over at least one relay.
  std::set<NodeNumber> heard_of() const;

 private:
  using Hears = std::map<NodeNumber, bool>;  ///< steady
  /// Credible links: by the node that is heard, then by the node that hears it.
  using Links = std::map<NodeNumber, Hears>;
  /// The report of the author, or null.
  const Hears* report(NodeNumber author) const;
  bool hears(NodeNumber author, NodeNumber node) const;
  /// The nodes with a route to `at`, whose reports it therefore has.
  std::set<NodeNumber> known_to(NodeNumber at) const;
  /// The links that the node at their beginning knows of; it would not use others.
  Links links() const;

  NodeNumber self_;
  std::set<NodeNumber> relays_;
  std::map<NodeNumber, Hears> reports_;
};

}  // namespace skein::blackboard::routing
