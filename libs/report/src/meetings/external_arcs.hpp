// SPDX-License-Identifier: Apache-2.0
// Executed external arcs: precedences between tasks of different UAVs, with their actual dates.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "story/chronology.hpp"

namespace skein::report {

/// UAV `to` continues only after UAV `from` has arrived (at a synchronisation or joint task) or has
/// left the air that `to` needs.
struct ExternalArc {
  std::string what;               ///< "sync 500", "joint task", "air"
  std::size_t from = 0, to = 0;   ///< indices into Chronology::uavs
  double comes = 0, goes_on = 0;  ///< [s] arrival of `from`, continuation of `to`
  /// The date [s] by which a UAV (`needed_by`) needed `from` there, as last told before the
  /// arrival.
  std::optional<double> needed;
  std::string needed_by;

  /// How much later `from` could have arrived without delaying `to` [s], >= 0; 0: `to` waited.
  double slack() const { return goes_on - comes; }
};

/// In the order of `goes_on`. For joint tasks and air only the UAV that arrived or left last is
/// known.
std::vector<ExternalArc> external_arcs_of(const Journal& journal, const Chronology& story);

}  // namespace skein::report
