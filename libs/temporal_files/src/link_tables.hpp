// SPDX-License-Identifier: Apache-2.0
// Checks of nodes, arcs and contingent links, common to the readers of all formats.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "problems.hpp"
#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Names with their positions.
class NameTable {
 public:
  /// `kind` is what messages call one: "node", "agent".
  NameTable(std::string kind, Problems& problems) : kind_(std::move(kind)), problems_(problems) {}

  /// A name that is there already is a problem.
  void add(const std::string& name, const Place& place);
  /// Its position; it is added if it is not there.
  std::uint32_t find_or_add(const std::string& name);
  std::optional<std::uint32_t> find(std::string_view name) const;
  /// A name that is not there is a problem, with the nearest one.
  std::optional<std::uint32_t> find(std::string_view name, const Place& place) const;

  const std::vector<std::string>& names() const { return names_; }

 private:
  std::string kind_;
  Problems& problems_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::uint32_t> positions_;
};

/// Rules for links: strict for our formats. In foreign formats a link from a node to itself is a
/// constraint like any other, and a contingent min may be 0 or less.
enum class LinkRules : std::uint8_t { kOurs, kOthers };

/// Arcs and contingent links that are right: known nodes, min <= max, none from a node to itself,
/// none twice; durations with 0 < min < max < ∞ (min = max makes an arc), at most one into a node.
///
/// Of files of others: a link from a node to itself that holds says nothing and is left out with a
/// warning, one that does not hold is kept; a contingent min that is not positive means that the
/// end may come at once: it becomes the least duration there is, one nanosecond, with a warning.
/// (Bounds in steps coarser than the number of such links, in nanoseconds, give the same verdicts
/// as 0.)
class LinkTable {
 public:
  LinkTable(const NameTable& nodes, Problems& problems, LinkRules rules = LinkRules::kOurs)
      : nodes_(nodes), problems_(problems), rules_(rules) {}

  void add(const Arc& arc, const Place& place);
  void add(const ContingentLink& link, const Place& place);
  /// Sets the origin, in which no contingent link may end.
  void set_origin(NodeIndex origin) { origin_ = origin; }

  std::vector<Arc> take_arcs() { return std::move(arcs_); }
  std::vector<ContingentLink> take_contingent() { return std::move(contingent_); }

 private:
  void add_fixed(const ContingentLink& link, const Place& place);
  bool joins_two_nodes(NodeIndex from, NodeIndex to, const Place& place);
  void add_loop(const Arc& arc, const Place& place);
  void add_contingent(const ContingentLink& link, const Place& place);
  std::string between(NodeIndex from, NodeIndex to) const;

  const NameTable& nodes_;
  Problems& problems_;
  LinkRules rules_;
  std::optional<NodeIndex> origin_;
  std::vector<Arc> arcs_;
  std::vector<ContingentLink> contingent_;
  std::unordered_set<std::uint64_t> joined_;    ///< (from, to) of the arcs
  std::unordered_set<NodeIndex> uncontrolled_;  ///< where contingent links end
};

/// target - source <= weight.
struct Edge {
  NodeIndex source = 0;
  NodeIndex target = 0;
  Ticks weight = 0;
  Place place;
};

/// Edges as arcs, an edge and its opposite as one, in the order in which they first come; a pair
/// whose interval would be empty stays two arcs: the network is read, and is inconsistent. Edges
/// given twice are problems. An edge from a node to itself of negative weight is kept as an arc
/// that nothing keeps; any other says nothing and is left out with a warning.
std::vector<Arc> arcs_from(const std::vector<Edge>& edges, const NameTable& nodes,
                           Problems& problems);

/// Adds arcs with min = max, each the other way round where there is an arc between its nodes. (It
/// is left out where there are two: these come from arcs_from(), and leave no room.)
void append_fixed(std::vector<Arc>& arcs, const std::vector<Arc>& fixed);

/// The tightest edge of each ordered pair of nodes that the arcs give, sorted by source and target.
std::vector<Edge> edges_from(const std::vector<Arc>& arcs);

/// Makes the node of that name the origin of a network whose format has a fixed name for it. If
/// there is none it is added, before every node that follows no other one.
void choose_origin(Stnu& network, const std::string& name);

}  // namespace skein::temporal
