// SPDX-License-Identifier: Apache-2.0
// Lays the edges of a network out by the node they end in.
#include "lo_graph.hpp"

namespace skein::temporal {

struct LoGraph::Draft {
  NodeIndex from;
  NodeIndex to;
  Ticks weight;
  ConflictTerm term;
};

namespace {

Ticks negated(Ticks bound) { return bound == kMinusInfinite ? kInfinite : -bound; }

}  // namespace

LoGraph::LoGraph(const Stnu& network, OpenBounds open) {
  std::vector<Draft> drafts;
  drafts.reserve(2 * (network.arcs.size() + network.contingent.size()));
  const auto add = [&](NodeIndex from, NodeIndex to, Ticks weight, ConflictTerm term) {
    if (weight == kInfinite && open == OpenBounds::kDrop) return;
    drafts.push_back({from, to, weight, term});
  };
  for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    const LinkRef ref{LinkKind::kRequirement, i};
    add(arc.to, arc.from, negated(arc.min), {ref, LinkBound::kMin});
    add(arc.from, arc.to, arc.max, {ref, LinkBound::kMax});
  }
  for (std::uint32_t i = 0; i < network.contingent.size(); ++i) {
    const ContingentLink& given = network.contingent[i];
    const LinkRef ref{LinkKind::kContingent, i};
    add(given.contingent, given.activation, -given.min, {ref, LinkBound::kMin});
    if (given.min == given.max) {
      add(given.activation, given.contingent, given.max, {ref, LinkBound::kMax});
    }
  }
  sort_in(drafts, network.nodes.size(), network.arcs.size());
  if (open == OpenBounds::kKeep) sort_out();
  add_links(network);
}

void LoGraph::sort_in(const std::vector<Draft>& drafts, std::size_t nodes, std::size_t arcs) {
  begin_.assign(nodes + 1, 0);
  for (const Draft& draft : drafts) ++begin_[draft.to + 1];
  for (std::size_t node = 0; node < nodes; ++node) begin_[node + 1] += begin_[node];
  edges_.resize(drafts.size());
  terms_.resize(drafts.size());
  ends_.resize(drafts.size());
  of_arc_.assign(arcs, {kNone, kNone});
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (const Draft& draft : drafts) {
    const std::uint32_t at = next[draft.to]++;
    edges_[at] = {draft.from, draft.weight};
    terms_[at] = draft.term;
    ends_[at] = draft.to;
    if (draft.term.link.kind == LinkKind::kRequirement) {
      of_arc_[draft.term.link.index][draft.term.bound == LinkBound::kMax ? 1 : 0] = at;
    }
  }
}

void LoGraph::add_links(const Stnu& network) {
  const std::size_t nodes = network.nodes.size();
  ending_.assign(nodes, kNone);
  activated_begin_.assign(nodes + 1, 0);
  for (std::uint32_t i = 0; i < network.contingent.size(); ++i) {
    const ContingentLink& given = network.contingent[i];
    if (given.min == given.max) continue;
    ending_[given.contingent] = static_cast<std::uint32_t>(links_.size());
    links_.push_back({given.activation, given.contingent, given.min, given.max, i});
    ++activated_begin_[given.activation + 1];
  }
  for (std::size_t node = 0; node < nodes; ++node)
    activated_begin_[node + 1] += activated_begin_[node];
  activated_.resize(links_.size());
  std::vector<std::uint32_t> next(activated_begin_.begin(), activated_begin_.end() - 1);
  for (std::uint32_t link = 0; link < links_.size(); ++link) {
    activated_[next[links_[link].activation]++] = link;
  }
  derived_.resize(links_.size());
}

void LoGraph::sort_out() {
  out_begin_.assign(node_count() + 1, 0);
  for (const Edge& edge : edges_) ++out_begin_[edge.from + 1];
  for (std::size_t node = 0; node < node_count(); ++node) out_begin_[node + 1] += out_begin_[node];
  out_.resize(edges_.size());
  std::vector<std::uint32_t> next(out_begin_.begin(), out_begin_.end() - 1);
  for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) out_[next[edges_[edge].from]++] = edge;
}

}  // namespace skein::temporal
