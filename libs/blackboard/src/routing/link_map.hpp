// SPDX-License-Identifier: Apache-2.0
// The links of all nodes, and the ways over them.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard::routing {

/// How samples go to a node: first to `next`, past so many relays altogether.
struct Way {
  NodeNumber next;
  std::size_t relays = 0;
  bool operator==(const Way&) const = default;
};

/// What everybody says of whom he hears, and shortest ways over it. Links have a direction.
///
/// A report counts only while there is a way from its author to here on which it could have come:
/// what somebody out of reach said last may be long past. So a node that dies or leaves takes its
/// links along as soon as those who heard it say so, and nothing has to be repeated or to run out.
/// Reports come past relays only, as all else. Nobody can use a link out of him that he has not
/// been told of, so one counts only if what its end says can come back to its beginning. Then
/// whoever is on the best way to a node knows the rest of it, and ways get shorter at each step: no
/// loops once reports have come. Cost of ways(): links times the logarithm of nodes.
class LinkMap {
 public:
  /// `relays`: who passes on what is not for him.
  LinkMap(NodeNumber self, std::set<NodeNumber> relays) : self_(self), relays_(std::move(relays)) {}

  /// Instead of what it said before; of this node itself too.
  void learn(NodeNumber author, const std::vector<wire::Neighbour>& hears);

  /// The best way to each node that there is one to: few links, and rather steady ones; of equal
  /// ones that which begins as in `before`, else with the smallest number.
  std::map<NodeNumber, Way> ways(const std::map<NodeNumber, Way>& before = {}) const;
  /// From whom there is a way to here past a relay at least.
  std::set<NodeNumber> heard_of() const;

 private:
  using Hears = std::map<NodeNumber, bool>;  ///< steady
  /// Who hears a node directly, as far as is credible here: by node, then by who hears it.
  using Links = std::map<NodeNumber, Hears>;
  /// Of the author, if there is any.
  const Hears* report(NodeNumber author) const;
  bool hears(NodeNumber author, NodeNumber node) const;
  /// From whom there is any way to `at`: whose reports it has.
  std::set<NodeNumber> known_to(NodeNumber at) const;
  /// Links that the node at their beginning knows of, too: it would not use others.
  Links links() const;

  NodeNumber self_;
  std::set<NodeNumber> relays_;
  std::map<NodeNumber, Hears> reports_;
};

}  // namespace skein::blackboard::routing
