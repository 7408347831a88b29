// SPDX-License-Identifier: Apache-2.0
#include "link_tables.hpp"

#include <algorithm>
#include <map>

#include "seconds_text.hpp"
#include "skein/temporal_files/network_text.hpp"

namespace skein::temporal {

namespace {

std::uint64_t pair_key(NodeIndex from, NodeIndex to) {
  return (static_cast<std::uint64_t>(from) << 32U) | to;
}

std::string bound_text(Ticks ticks) {
  if (ticks == kInfinite) return "inf";
  return ticks == kMinusInfinite ? "-inf" : seconds_text(ticks);
}

}  // namespace

void NameTable::add(const std::string& name, const Place& place) {
  const auto position = static_cast<std::uint32_t>(names_.size());
  if (!positions_.emplace(name, position).second) {
    return problems_.add(place, kind_ + " " + in_quotes(name) + " is there twice");
  }
  names_.push_back(name);
}

std::uint32_t NameTable::find_or_add(const std::string& name) {
  const auto position = static_cast<std::uint32_t>(names_.size());
  const auto [found, added] = positions_.emplace(name, position);
  if (added) names_.push_back(name);
  return found->second;
}

std::optional<std::uint32_t> NameTable::find(std::string_view name) const {
  const auto found = positions_.find(std::string(name));
  if (found == positions_.end()) return std::nullopt;
  return found->second;
}

std::optional<std::uint32_t> NameTable::find(std::string_view name, const Place& place) const {
  const std::optional<std::uint32_t> found = find(name);
  if (!found) problems_.add_unknown(place, kind_, name, names_);
  return found;
}

std::string LinkTable::between(NodeIndex from, NodeIndex to) const {
  return "from " + in_quotes(nodes_.names()[from]) + " to " + in_quotes(nodes_.names()[to]);
}

bool LinkTable::joins_two_nodes(NodeIndex from, NodeIndex to, const Place& place) {
  if (from == to) {
    problems_.add(place, "a link from " + in_quotes(nodes_.names()[from]) + " to itself");
  }
  return from != to;
}

// min <= 0 <= max holds always.
void LinkTable::add_loop(const Arc& arc, const Place& place) {
  if (arc.min <= 0 && arc.max >= 0) {
    return problems_.warn(
        place, "a link from " + in_quotes(nodes_.names()[arc.from]) + " to itself says nothing");
  }
  arcs_.push_back(arc);
}

void LinkTable::add(const Arc& arc, const Place& place) {
  if (arc.from == arc.to && rules_ == LinkRules::kOthers) return add_loop(arc, place);
  if (!joins_two_nodes(arc.from, arc.to, place)) return;
  if (arc.min > arc.max) {
    problems_.add(place,
                  "min " + bound_text(arc.min) + " is greater than max " + bound_text(arc.max));
  }
  if (!joined_.insert(pair_key(arc.from, arc.to)).second) {
    problems_.add(place, "the arc " + between(arc.from, arc.to) + " is there twice");
  }
  arcs_.push_back(arc);
}

void LinkTable::add(const ContingentLink& link, const Place& place) {
  if (!joins_two_nodes(link.activation, link.contingent, place)) return;
  ContingentLink taken = link;
  const bool fixed = link.min == link.max;
  if (rules_ == LinkRules::kOthers && link.min <= 0 && (fixed || link.max > 0)) {
    problems_.warn(place, "the contingent min " + bound_text(link.min) + " is not positive; " +
                              (fixed ? "the link is a requirement"
                                     : "it is read as one nanosecond: the end may come at once"));
    if (fixed) return add_fixed(link, place);
    taken.min = 1;
  }
  add_contingent(taken, place);
}

void LinkTable::add_contingent(const ContingentLink& link, const Place& place) {
  if (link.min <= 0) {
    problems_.add(place, "the contingent min " + bound_text(link.min) + " is not positive");
  }
  if (link.max == kInfinite) problems_.add(place, "the contingent max is infinite");
  if (link.min > link.max) {
    problems_.add(place,
                  "min " + bound_text(link.min) + " is greater than max " + bound_text(link.max));
  }
  if (link.contingent == origin_) {
    problems_.add(place, "a contingent link ends in the origin " +
                             in_quotes(nodes_.names()[link.contingent]));
  }
  if (!uncontrolled_.insert(link.contingent).second) {
    problems_.add(place,
                  "a second contingent link ends in " + in_quotes(nodes_.names()[link.contingent]));
  }
  if (link.min == link.max) return add_fixed(link, place);
  contingent_.push_back(link);
}

// Beside an arc between the same nodes it stands the other way round.
void LinkTable::add_fixed(const ContingentLink& link, const Place& place) {
  const Arc arc{link.activation, link.contingent, link.min, link.max};
  const bool beside = joined_.count(pair_key(arc.from, arc.to)) > 0;
  add(beside ? Arc{arc.to, arc.from, -arc.max, -arc.min} : arc, place);
}

std::vector<Arc> arcs_from(const std::vector<Edge>& edges, const NameTable& nodes,
                           Problems& problems) {
  std::vector<Arc> arcs;
  std::unordered_map<std::uint64_t, std::size_t> arc_of;  // by the ordered pair of its first edge
  std::unordered_set<std::uint64_t> seen;
  for (const Edge& edge : edges) {
    const auto name = [&](NodeIndex node) { return in_quotes(nodes.names()[node]); };
    if (edge.source == edge.target && edge.weight >= 0) {
      problems.warn(edge.place,
                    "an edge from " + name(edge.source) + " to itself that says nothing");
      continue;
    }
    if (!seen.insert(pair_key(edge.source, edge.target)).second) {
      problems.add(edge.place, "the edge from " + name(edge.source) + " to " + name(edge.target) +
                                   " is there twice");
      continue;
    }
    const auto opposite = arc_of.find(pair_key(edge.target, edge.source));
    if (opposite != arc_of.end() && -edge.weight <= arcs[opposite->second].max) {
      arcs[opposite->second].min = -edge.weight;
      continue;
    }
    arc_of.emplace(pair_key(edge.source, edge.target), arcs.size());
    arcs.push_back({edge.source, edge.target, kMinusInfinite, edge.weight});
  }
  // What is only bounded by a negative weight reads better the other way round.
  for (Arc& arc : arcs) {
    const bool alone = arc_of.count(pair_key(arc.to, arc.from)) == 0;
    if (alone && arc.min == kMinusInfinite && arc.max <= 0) {
      arc = {arc.to, arc.from, -arc.max, kInfinite};
    }
  }
  return arcs;
}

void append_fixed(std::vector<Arc>& arcs, const std::vector<Arc>& fixed) {
  if (fixed.empty()) return;
  std::unordered_set<std::uint64_t> joined;
  for (const Arc& arc : arcs) joined.insert(pair_key(arc.from, arc.to));
  for (const Arc& arc : fixed) {
    if (joined.insert(pair_key(arc.from, arc.to)).second) {
      arcs.push_back(arc);
    } else if (joined.insert(pair_key(arc.to, arc.from)).second) {
      arcs.push_back({arc.to, arc.from, -arc.max, -arc.min});
    }
  }
}

std::vector<Edge> edges_from(const std::vector<Arc>& arcs) {
  std::map<std::pair<NodeIndex, NodeIndex>, Ticks> tightest;
  const auto add = [&](NodeIndex source, NodeIndex target, Ticks weight) {
    const auto [found, added] = tightest.emplace(std::pair(source, target), weight);
    if (!added) found->second = std::min(found->second, weight);
  };
  for (const Arc& arc : arcs) {
    if (arc.max != kInfinite) add(arc.from, arc.to, arc.max);
    if (arc.min != kMinusInfinite) add(arc.to, arc.from, -arc.min);
  }
  std::vector<Edge> edges;
  edges.reserve(tightest.size());
  for (const auto& [pair, weight] : tightest)
    edges.push_back({pair.first, pair.second, weight, {}});
  return edges;
}

void choose_origin(Stnu& network, const std::string& name) {
  const auto found = std::find(network.nodes.begin(), network.nodes.end(), name);
  network.origin = static_cast<NodeIndex>(found - network.nodes.begin());
  if (found != network.nodes.end()) return;
  std::vector<bool> follows(network.nodes.size(), false);
  for (const Arc& arc : network.arcs) {
    if (arc.min >= 0) follows[arc.to] = true;
    if (arc.max <= 0) follows[arc.from] = true;
  }
  for (const ContingentLink& link : network.contingent) follows[link.contingent] = true;
  network.nodes.push_back(name);
  for (NodeIndex node = 0; node < network.origin; ++node) {
    if (!follows[node]) network.arcs.push_back({network.origin, node, 0, kInfinite});
  }
}

void put_origin_first(Stnu& network) {
  const NodeIndex origin = network.origin;
  std::unordered_map<NodeIndex, std::size_t> from_origin;
  std::unordered_map<NodeIndex, std::size_t> to_origin;
  for (std::size_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    if (arc.from == origin) from_origin.emplace(arc.to, i);
    if (arc.to == origin) to_origin.emplace(arc.from, i);
  }
  for (NodeIndex node = 0; node < network.nodes.size(); ++node) {
    if (node == origin) continue;
    const auto out = from_origin.find(node);
    const auto in = to_origin.find(node);
    const bool is_out = out != from_origin.end();
    const bool is_in = in != to_origin.end();
    if (is_out && network.arcs[out->second].max >= 0) {
      Ticks& min = network.arcs[out->second].min;
      min = std::max<Ticks>(min, 0);
    } else if (is_in && network.arcs[in->second].min <= 0) {
      Ticks& max = network.arcs[in->second].max;
      max = std::min<Ticks>(max, 0);
    } else if (is_out) {
      network.arcs.push_back({node, origin, kMinusInfinite, 0});
    } else {
      network.arcs.push_back({origin, node, 0, kInfinite});
    }
  }
}

}  // namespace skein::temporal
