// SPDX-License-Identifier: Apache-2.0
// The check from scratch.
#include "skein/temporal/stnu_controllability.hpp"

#include "dc_engine.hpp"

namespace skein::temporal {

Result<DcResult, StnuError> check_dynamic_controllability(const Stnu& network) {
  if (const auto fault = find_fault(network)) return tl::unexpected(*fault);
  return DcEngine(network, LoGraph::OpenBounds::kDrop).decide();
}

std::string to_text(const ConflictTerm& term, const Stnu& network) {
  const bool contingent = term.link.kind == LinkKind::kContingent;
  const NodeIndex from = contingent ? network.contingent[term.link.index].activation
                                    : network.arcs[term.link.index].from;
  const NodeIndex to = contingent ? network.contingent[term.link.index].contingent
                                  : network.arcs[term.link.index].to;
  return std::string(term.bound == LinkBound::kMin ? "min" : "max") + " of " +
         (contingent ? "contingent " : "") + network.nodes[from] + " -> " + network.nodes[to];
}

}  // namespace skein::temporal
