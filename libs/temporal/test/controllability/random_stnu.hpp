// SPDX-License-Identifier: Apache-2.0
// Small random networks with uncertainty, of the kinds that tell algorithms apart.
#pragma once

#include <algorithm>
#include <set>
#include <string>

#include "skein/foundation/random.hpp"
#include "skein/temporal/stnu_controllability.hpp"

namespace skein::temporal::testing {

struct RandomStnuOptions {
  std::uint32_t nodes = 6;
  std::uint32_t contingent = 2;
  std::uint32_t arcs = 6;
  Ticks longest = 10;     ///< greatest contingent duration
  bool anchored = false;  ///< every node comes at or after the origin, within `horizon`
  Ticks horizon = 100;
};

inline Ticks draw(Ticks low, Ticks high, Random& random) {
  return low + static_cast<Ticks>(random.below(static_cast<std::uint64_t>(high - low + 1)));
}

/// Arcs are drawn around the dates of a hidden best-case schedule, some too tightly, so that about
/// half of the networks are controllable. Contingent links may form chains, share an activation or,
/// rarely, close a loop.
inline Stnu random_stnu(const RandomStnuOptions& options, Random& random) {
  Stnu out;
  std::vector<Ticks> date;
  for (NodeIndex node = 0; node < options.nodes; ++node) {
    out.nodes.push_back("n" + std::to_string(node));
    date.push_back(node == 0 ? 0 : draw(0, 3 * options.longest, random));
  }
  for (std::uint32_t i = 0; i < options.contingent; ++i) {
    const auto from = static_cast<NodeIndex>(random.below(options.nodes));
    const auto to = static_cast<NodeIndex>(1 + random.below(options.nodes - 1));
    const bool taken =
        std::any_of(out.contingent.begin(), out.contingent.end(),
                    [&](const ContingentLink& link) { return link.contingent == to; });
    if (taken || from == to) continue;
    const Ticks min = draw(1, std::max<Ticks>(1, options.longest - 1), random);
    const Ticks max = random.chance(0.1) ? min : draw(min, options.longest, random);
    out.contingent.push_back({from, to, min, max});
    date[to] = date[from] + min;
  }
  for (std::uint32_t i = 0; i < options.arcs; ++i) {
    const auto from = static_cast<NodeIndex>(random.below(options.nodes));
    const auto to = static_cast<NodeIndex>(random.below(options.nodes));
    if (from == to) continue;
    const Ticks apart = date[to] - date[from];
    Arc arc{from, to, apart - draw(0, options.longest, random),
            apart + draw(0, options.longest, random)};
    if (random.chance(0.3)) arc.min = kMinusInfinite;
    if (random.chance(0.3)) arc.max = kInfinite;
    out.arcs.push_back(arc);
  }
  if (options.anchored) {
    for (NodeIndex node = 1; node < options.nodes; ++node) {
      out.arcs.push_back({0, node, 0, options.horizon});
    }
  }
  return out;
}

/// The network of the links that a conflict names.
inline Stnu named_part(const Stnu& network, const std::vector<ConflictTerm>& conflict) {
  Stnu part;
  part.nodes = network.nodes;
  std::set<std::uint32_t> contingent;
  for (const ConflictTerm& term : conflict) {
    if (term.link.kind == LinkKind::kContingent) {
      contingent.insert(term.link.index);
      continue;
    }
    Arc arc = network.arcs[term.link.index];
    (term.bound == LinkBound::kMin ? arc.max : arc.min) =
        term.bound == LinkBound::kMin ? kInfinite : kMinusInfinite;
    part.arcs.push_back(arc);
  }
  for (const std::uint32_t link : contingent) part.contingent.push_back(network.contingent[link]);
  return part;
}

}  // namespace skein::temporal::testing
