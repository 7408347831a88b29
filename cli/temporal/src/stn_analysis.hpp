// SPDX-License-Identifier: Apache-2.0
// Analyses of a network, with results in terms of its links.
#pragma once

#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/temporal/stnu_fault.hpp"
#include "skein/temporal_files/drawing.hpp"

namespace skein::temporal_tool {

enum class LinkBound : std::uint8_t { kMin, kMax };

/// One bound of a link that a conflict needs.
struct ConflictPart {
  temporal::LinkRef link;
  LinkBound bound = LinkBound::kMin;
  bool operator==(const ConflictPart&) const = default;
};

struct Consistency {
  bool consistent = false;
  std::vector<ConflictPart> conflict;         ///< a negative cycle, in order; empty iff consistent
  std::vector<temporal::DateWindow> windows;  ///< of each node; empty unless consistent
};

struct Controllability {
  bool consistent = false;
  bool controllable = false;
  std::vector<ConflictPart> conflict;  ///< empty iff controllable
};

/// Fails when a date overflows.
Result<Consistency, Failure> analyse_consistency(const temporal::Stnu& network);

/// Fails when a distance overflows.
Result<Controllability, Failure> analyse_controllability(const temporal::Stnu& network);

std::vector<temporal::LinkRef> links_of(const std::vector<ConflictPart>& conflict);

}  // namespace skein::temporal_tool
