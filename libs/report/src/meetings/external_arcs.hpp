// SPDX-License-Identifier: Apache-2.0
// External arcs between the plans of UAVs, as they were flown.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "story/chronology.hpp"

namespace skein::report {

/// One goes on only after another has come (a synchronisation, a joint task) or has left its air.
struct ExternalArc {
  std::string what;              ///< "sync 500", "joint task", "air"
  std::size_t from = 0, to = 0;  ///< indices into Chronology::uavs: who comes, who waits for it
  double comes = 0, goes_on = 0;
  /// By when others needed it there, as it was told last before it came, and who.
  std::optional<double> needed;
  std::string needed_by;

  /// So much later it could have come without making the other later [s], >= 0; 0: it was waited
  /// for.
  double slack() const { return goes_on - comes; }
};

/// In the order of `goes_on`. Of joint tasks and of air only the one who came, or left, last is
/// known.
std::vector<ExternalArc> external_arcs_of(const Journal& journal, const Chronology& story);

}  // namespace skein::report
