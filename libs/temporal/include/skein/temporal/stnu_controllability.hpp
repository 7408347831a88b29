// SPDX-License-Identifier: Apache-2.0
// Is a network with uncertainty dynamically controllable, and if not, which links break it?
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/temporal/stnu_fault.hpp"

namespace skein::temporal {

enum class LinkBound : std::uint8_t { kMin, kMax };

/// One bound of one link. Of a contingent link, kMin: nature may be that fast (or, read as a
/// requirement, is never faster); kMax: nature may be that slow.
struct ConflictTerm {
  LinkRef link;
  LinkBound bound = LinkBound::kMin;
  auto operator<=>(const ConflictTerm&) const = default;
};

/// Work done by a check; the same on every machine.
struct DcCounters {
  std::uint64_t searches = 0;  ///< shortest-path searches from contingent ends, restarts included
  std::uint64_t relaxations = 0;    ///< edges looked at in those searches
  std::uint64_t derived_edges = 0;  ///< edges that follow from contingent links
  bool operator==(const DcCounters&) const = default;
};

struct DcResult {
  bool consistent = false;    ///< as if all contingent links were requirements
  bool controllable = false;  ///< implies `consistent`
  /// Empty iff controllable. The bounds that make a semi-reducible negative cycle, each once, in
  /// the order in which a walk along the cycle meets them. The links named, alone in a network, are
  /// not dynamically controllable (not consistent if this is not); a change that loosens none of
  /// these bounds cannot help.
  std::vector<ConflictTerm> conflict;
  DcCounters counters;
};

/// Dynamic controllability with instantaneous reaction: an event may be executed at the very
/// instant of an observation. Contingent links with min = max are requirements. Cost: O(m n + k² n
/// + k n log n) for n nodes, m arcs, k contingent links. No recursion. Errors: what `find_fault`
/// finds, and kOverflow when a distance does not fit. Source: spec 5.2; Cairo, Hunsberger, Rizzi
/// 2018 (rules); Hunsberger, Posenato 2022.
Result<DcResult, StnuError> check_dynamic_controllability(const Stnu& network);

/// "min of a -> b", for people.
std::string to_text(const ConflictTerm& term, const Stnu& network);

}  // namespace skein::temporal
