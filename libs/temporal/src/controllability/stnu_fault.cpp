// SPDX-License-Identifier: Apache-2.0
// Checks that a network with uncertainty is well formed.
#include "skein/temporal/stnu_fault.hpp"

#include <vector>

namespace skein::temporal {

namespace {

bool too_large(Ticks bound) {
  return bound != kInfinite && bound != kMinusInfinite && (bound > kLargest || bound < -kLargest);
}

std::string name_of(const Stnu& network, NodeIndex node) {
  return node < network.nodes.size() ? network.nodes[node] : "#" + std::to_string(node);
}

}  // namespace

std::optional<StnuFault> find_fault(const Arc& arc, std::size_t nodes) {
  if (arc.from >= nodes || arc.to >= nodes) return StnuFault::kUnknownNode;
  if (arc.min > arc.max || arc.min == kInfinite || arc.max == kMinusInfinite) {
    return StnuFault::kEmptyInterval;
  }
  if (too_large(arc.min) || too_large(arc.max)) return StnuFault::kOverflow;
  return std::nullopt;
}

std::optional<StnuFault> find_fault(const ContingentLink& link, std::size_t nodes) {
  if (link.activation >= nodes || link.contingent >= nodes) return StnuFault::kUnknownNode;
  if (link.activation == link.contingent) return StnuFault::kContingentLoop;
  if (link.min <= 0) return StnuFault::kContingentNotPositive;
  if (link.max == kInfinite) return StnuFault::kContingentUnbounded;
  if (link.min > link.max) return StnuFault::kEmptyInterval;
  if (too_large(link.max)) return StnuFault::kOverflow;
  return std::nullopt;
}

std::optional<StnuError> find_fault(const Stnu& network) {
  const std::size_t nodes = network.nodes.size();
  if (network.origin >= nodes) return StnuError{StnuFault::kUnknownNode, std::nullopt};
  for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
    if (const auto fault = find_fault(network.arcs[i], nodes)) {
      return StnuError{*fault, LinkRef{LinkKind::kRequirement, i}};
    }
  }
  std::vector<bool> ended(nodes, false);
  for (std::uint32_t i = 0; i < network.contingent.size(); ++i) {
    const LinkRef ref{LinkKind::kContingent, i};
    if (const auto fault = find_fault(network.contingent[i], nodes)) return StnuError{*fault, ref};
    const NodeIndex end = network.contingent[i].contingent;
    if (ended[end]) return StnuError{StnuFault::kSharedContingentEnd, ref};
    ended[end] = true;
  }
  return std::nullopt;
}

std::string to_text(StnuFault fault) {
  switch (fault) {
    case StnuFault::kUnknownLink:
      return "unknown link";
    case StnuFault::kUnknownNode:
      return "unknown node";
    case StnuFault::kEmptyInterval:
      return "the bounds leave no value";
    case StnuFault::kContingentNotPositive:
      return "the least duration of a contingent link must be positive";
    case StnuFault::kContingentUnbounded:
      return "the greatest duration of a contingent link must be finite";
    case StnuFault::kContingentLoop:
      return "a contingent link must join two nodes";
    case StnuFault::kSharedContingentEnd:
      return "another contingent link ends in the same node";
    case StnuFault::kOverflow:
      return "times are too large";
    case StnuFault::kContingentOrigin:
      return "the origin cannot be the end of a contingent link";
    case StnuFault::kNotControllable:
      return "the network is not dynamically controllable";
  }
  return "unknown fault";
}

std::string to_text(const StnuError& error, const Stnu& network) {
  if (!error.link) return to_text(error.fault);
  const LinkRef& link = *error.link;
  if (error.fault == StnuFault::kUnknownLink) {
    return "link #" + std::to_string(link.index) + ": " + to_text(error.fault);
  }
  if (link.kind == LinkKind::kRequirement) {
    const Arc& arc = network.arcs[link.index];
    return "arc " + name_of(network, arc.from) + " -> " + name_of(network, arc.to) + ": " +
           to_text(error.fault);
  }
  const ContingentLink& contingent = network.contingent[link.index];
  return "contingent link " + name_of(network, contingent.activation) + " -> " +
         name_of(network, contingent.contingent) + ": " + to_text(error.fault);
}

}  // namespace skein::temporal
