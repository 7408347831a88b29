// SPDX-License-Identifier: Apache-2.0
#include "drawn_links.hpp"

#include "seconds_text.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {

namespace {

std::string date_text(Ticks ticks) {
  if (ticks == kInfinite) return "∞";
  return ticks == kMinusInfinite ? "-∞" : seconds_text(ticks);
}

}  // namespace

const char* DrawnLink::colour() const {
  if (in_conflict) return kConflictInk;
  return contingent ? kContingentInk : kRequirementInk;
}

bool DrawnLink::is_backwards() const {
  if (min >= 0) return false;
  return max <= 0 || (min != kMinusInfinite && max != kInfinite && max < -min);
}

std::vector<DrawnLink> drawn_links(const Stnu& network, const std::vector<LinkRef>& conflict) {
  std::vector<DrawnLink> links;
  for (const Arc& arc : network.arcs) {
    links.push_back({arc.from, arc.to, arc.min, arc.max, false, false});
  }
  for (const ContingentLink& one : network.contingent) {
    links.push_back({one.activation, one.contingent, one.min, one.max, true, false});
  }
  for (const LinkRef& ref : conflict) {
    const bool contingent = ref.kind == LinkKind::kContingent;
    SKEIN_EXPECTS(ref.index < (contingent ? network.contingent.size() : network.arcs.size()));
    links[contingent ? network.arcs.size() + ref.index : ref.index].in_conflict = true;
  }
  return links;
}

std::vector<DrawnNode> drawn_nodes(const Stnu& network, const std::vector<DrawnLink>& links) {
  std::vector<DrawnNode> nodes(network.nodes.size());
  for (const DrawnLink& link : links) {
    if (link.contingent) nodes[link.to].contingent = true;
    if (link.in_conflict) nodes[link.from].in_conflict = nodes[link.to].in_conflict = true;
  }
  return nodes;
}

std::string window_text(const DateWindow& window) {
  if (window.earliest == window.latest) return date_text(window.earliest);
  return date_text(window.earliest) + " … " + date_text(window.latest);
}

std::string bounds_text(Ticks min, Ticks max) {
  if (min == max) return "= " + seconds_text(min);
  if (min == kMinusInfinite && max == kInfinite) return "free";
  if (max == kInfinite) return "≥ " + seconds_text(min);
  if (min == kMinusInfinite) return "≤ " + seconds_text(max);
  return "[" + seconds_text(min) + ", " + seconds_text(max) + "]";
}

}  // namespace skein::temporal
