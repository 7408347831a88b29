// SPDX-License-Identifier: Apache-2.0
// Keeps the edges of a network by the node they end in.
#include "lo_graph.hpp"

#include <algorithm>

namespace skein::temporal {

namespace {

Ticks negated(Ticks bound) { return bound == kMinusInfinite ? kInfinite : -bound; }

constexpr ConflictTerm term_of(LinkKind kind, std::uint32_t index, LinkBound bound) {
  return {{kind, index}, bound};
}

}  // namespace

LoGraph::LoGraph(const Stnu& network, OpenBounds open)
    : keeps_open_(open == OpenBounds::kKeep),
      into_(network.nodes.size()),
      out_(network.nodes.size()),
      ending_(network.nodes.size(), kNone),
      activated_(network.nodes.size()) {
  for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    const auto add = [&](NodeIndex from, NodeIndex to, Ticks weight, LinkBound bound) {
      if (weight == kInfinite && !keeps_open_) return kNone;
      return add_edge(from, to, weight, term_of(LinkKind::kRequirement, i, bound));
    };
    const std::uint32_t min = add(arc.to, arc.from, negated(arc.min), LinkBound::kMin);
    const std::uint32_t max = add(arc.from, arc.to, arc.max, LinkBound::kMax);
    of_arc_.push_back({min, max});
  }
  add_links(network);
}

void LoGraph::add_links(const Stnu& network) {
  for (std::uint32_t i = 0; i < network.contingent.size(); ++i) {
    const ContingentLink& given = network.contingent[i];
    const std::uint32_t base = add_edge(given.contingent, given.activation, -given.min,
                                        term_of(LinkKind::kContingent, i, LinkBound::kMin));
    if (given.min == given.max) {
      add_edge(given.activation, given.contingent, given.max,
               term_of(LinkKind::kContingent, i, LinkBound::kMax));
      of_contingent_.push_back(kNone);
      continue;
    }
    of_contingent_.push_back(static_cast<std::uint32_t>(links_.size()));
    links_.push_back({given.activation, given.contingent, given.min, given.max, i, base});
    derived_.emplace_back();
    activate(of_contingent_.back());
  }
}

std::uint32_t LoGraph::add_edge(NodeIndex from, NodeIndex to, Ticks weight, ConflictTerm term) {
  std::uint32_t edge = static_cast<std::uint32_t>(places_.size());
  if (free_edges_.empty()) {
    places_.emplace_back();
    terms_.push_back(term);
  } else {
    edge = free_edges_.back();
    free_edges_.pop_back();
    terms_[edge] = term;
  }
  link_edge(edge, from, to, weight);
  return edge;
}

void LoGraph::link_edge(std::uint32_t edge, NodeIndex from, NodeIndex to, Ticks weight) {
  places_[edge] = {to, static_cast<std::uint32_t>(into_[to].size()),
                   static_cast<std::uint32_t>(out_[from].size())};
  into_[to].push_back({from, edge, weight});
  if (keeps_open_) out_[from].push_back(edge);
}

// The last edge at each node takes the place that comes free.
void LoGraph::unlink_edge(std::uint32_t edge) {
  const Place place = places_[edge];
  std::vector<InEdge>& in = into_[place.end];
  std::vector<std::uint32_t>& out = out_[in[place.at].from];
  in[place.at] = in.back();
  places_[in[place.at].number].at = place.at;
  in.pop_back();
  out[place.out_at] = out.back();
  places_[out[place.out_at]].out_at = place.out_at;
  out.pop_back();
}

void LoGraph::add_node() {
  into_.emplace_back();
  out_.emplace_back();
  ending_.push_back(kNone);
  activated_.emplace_back();
}

void LoGraph::add_arc(NodeIndex from, NodeIndex to) {
  const auto arc = static_cast<std::uint32_t>(of_arc_.size());
  const auto term = [&](LinkBound bound) { return term_of(LinkKind::kRequirement, arc, bound); };
  const std::uint32_t min = add_edge(to, from, kInfinite, term(LinkBound::kMin));
  const std::uint32_t max = add_edge(from, to, kInfinite, term(LinkBound::kMax));
  of_arc_.push_back({min, max});
}

void LoGraph::move_arc(std::uint32_t arc, NodeIndex from, NodeIndex to) {
  const auto [min, max] = of_arc_[arc];
  unlink_edge(min);
  unlink_edge(max);
  link_edge(min, to, from, kInfinite);
  link_edge(max, from, to, kInfinite);
}

std::uint32_t LoGraph::add_link(const ContingentLink& given) {
  std::uint32_t link = static_cast<std::uint32_t>(links_.size());
  if (free_links_.empty()) {
    links_.emplace_back();
    derived_.emplace_back();
  } else {
    link = free_links_.back();
    free_links_.pop_back();
  }
  const auto position = static_cast<std::uint32_t>(of_contingent_.size());
  const std::uint32_t base = add_edge(given.contingent, given.activation, kInfinite,
                                      term_of(LinkKind::kContingent, position, LinkBound::kMin));
  links_[link] = {given.activation, given.contingent, given.min, given.max, position, base};
  of_contingent_.push_back(link);
  return link;
}

void LoGraph::activate(std::uint32_t link) {
  ending_[links_[link].end] = link;
  activated_[links_[link].activation].push_back(link);
}

void LoGraph::remove_link(std::uint32_t link) {
  const Link& gone = links_[link];
  ending_[gone.end] = kNone;
  std::vector<std::uint32_t>& activated = activated_[gone.activation];
  activated.erase(std::remove(activated.begin(), activated.end(), link), activated.end());
  unlink_edge(gone.base);
  free_edges_.push_back(gone.base);
  const std::uint32_t last = static_cast<std::uint32_t>(of_contingent_.size()) - 1;
  const std::uint32_t position = gone.given;
  if (position != last) put(of_contingent_[last], position);
  of_contingent_.pop_back();
  free_links_.push_back(link);
}

void LoGraph::put(std::uint32_t link, std::uint32_t position) {
  of_contingent_[position] = link;
  links_[link].given = position;
  terms_[links_[link].base].link.index = position;
}

void LoGraph::exchange(std::uint32_t one, std::uint32_t other) {
  const std::uint32_t first = of_contingent_[one], second = of_contingent_[other];
  put(first, other);
  put(second, one);
}

}  // namespace skein::temporal
