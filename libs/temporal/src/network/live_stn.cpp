// SPDX-License-Identifier: Apache-2.0
// Each link is one or two difference constraints; of those between two nodes the strongest counts.
#include "skein/temporal/live_stn.hpp"

#include <algorithm>
#include <string>

#include "skein/foundation/contract.hpp"

namespace skein::temporal {

Ticks LiveStn::Constraint::weight() const {
  Ticks strongest = kMinusInfinite;
  for (const Bound& bound : bounds) strongest = std::max(strongest, bound.weight);
  return strongest;
}

void LiveStn::bound(Pair pair, LinkId link, Ticks weight) {
  constraints_[pair].bounds.push_back({link, weight});
  touched_.insert(pair);
}

void LiveStn::free(Pair pair, LinkId link) {
  std::vector<Bound>& bounds = constraints_.at(pair).bounds;
  bounds.erase(std::find_if(bounds.begin(), bounds.end(),
                            [&](const Bound& one) { return one.link == link; }));
  touched_.insert(pair);
}

void LiveStn::drop(LinkId link, const Arc& arc) {
  if (arc.min != kMinusInfinite) free(pair_of(arc.from, arc.to), link);
  if (arc.max != kInfinite) free(pair_of(arc.to, arc.from), link);
}

void LiveStn::set(LinkId link, const Arc& arc) {
  SKEIN_EXPECTS(arc.from != arc.to);
  const auto known = links_.find(link);
  if (known != links_.end()) {
    if (known->second == arc) return;
    drop(link, known->second);
  }
  links_[link] = arc;
  nodes_ = std::max({nodes_, arc.from + 1, arc.to + 1});
  if (arc.min != kMinusInfinite) bound(pair_of(arc.from, arc.to), link, arc.min);
  if (arc.max != kInfinite) bound(pair_of(arc.to, arc.from), link, -arc.max);
}

void LiveStn::erase(LinkId link) {
  const auto known = links_.find(link);
  if (known == links_.end()) return;
  drop(link, known->second);
  links_.erase(known);
}

void LiveStn::apply(Pair pair, std::vector<ArcBounds>& changed, std::vector<ArcId>& removed) {
  Constraint& constraint = constraints_.at(pair);
  const Ticks weight = constraint.weight();
  if (constraint.arc && weight != constraint.applied) {
    changed.push_back({*constraint.arc, weight, kInfinite});
    constraint.applied = weight;
  }
  if (!constraint.bounds.empty()) return;
  if (constraint.arc) removed.push_back(*constraint.arc);
  constraints_.erase(pair);
}

void LiveStn::insert(Pair pair) {
  const auto found = constraints_.find(pair);
  if (found == constraints_.end() || found->second.arc) return;
  Constraint& constraint = found->second;
  constraint.applied = constraint.weight();
  const auto from = static_cast<NodeIndex>(pair >> 32U), to = static_cast<NodeIndex>(pair);
  const auto arc = engine_.add_arc({from, to, constraint.applied, kInfinite});
  if (arc) {
    constraint.arc = *arc;
  } else {
    overflowed_ = true;
  }
}

// First what was there, weaker and stronger at once, then what is new.
void LiveStn::settle() {
  if (touched_.empty()) return;
  constexpr std::size_t kFew = 24;
  if (overflowed_ || touched_.size() > constraints_.size() / 2 + kFew) return rebuild();
  while (engine_.node_count() < nodes_) engine_.add_node();
  std::vector<ArcBounds> changed;
  std::vector<ArcId> removed;
  for (const Pair pair : touched_) apply(pair, changed, removed);
  overflowed_ = engine_.set_arcs(changed).has_value();
  for (const ArcId arc : removed) engine_.remove_arc(arc);
  for (const Pair pair : touched_) insert(pair);
  touched_.clear();
  if (overflowed_) rebuild();
}

void LiveStn::rebuild() {
  Stn network;
  network.nodes.resize(nodes_);
  std::vector<Pair> pairs;
  for (auto it = constraints_.begin(); it != constraints_.end();) {
    it = it->second.bounds.empty() ? constraints_.erase(it) : std::next(it);
  }
  pairs.reserve(constraints_.size());
  for (const auto& [pair, constraint] : constraints_) pairs.push_back(pair);
  std::sort(pairs.begin(), pairs.end());
  for (const Pair pair : pairs) {
    Constraint& constraint = constraints_.at(pair);
    constraint.arc = static_cast<ArcId>(network.arcs.size());
    constraint.applied = constraint.weight();
    network.arcs.push_back({static_cast<NodeIndex>(pair >> 32U), static_cast<NodeIndex>(pair),
                            constraint.applied, kInfinite});
  }
  auto made = StnEngine::make(network);
  overflowed_ = !made.has_value();
  if (made) engine_ = std::move(*made);
  touched_.clear();
}

Ticks LiveStn::earliest(NodeIndex node) const {
  return node < engine_.node_count() ? engine_.earliest(node) : kMinusInfinite;
}

Ticks LiveStn::latest(NodeIndex node) const {
  return node < engine_.node_count() ? engine_.latest(node) : kInfinite;
}

}  // namespace skein::temporal
