// SPDX-License-Identifier: Apache-2.0
// Why the script of a run did not come to its end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/journal/record.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::laws {

/// One thing that a step of the script still waited for when the run was over.
struct Waiting {
  std::string step;             ///< "step end", "operator end-monitoring"
  std::string awaited;          ///< "task 24 of heliv ended"
  std::string is;               ///< how that stands: "aborted", "never asked for", "not done"
  std::optional<double> since;  ///< when it came to stand so [s]; absent: it never stood otherwise
  std::string why;              ///< what made it so, as far as the log tells; may be empty
};

/// What kept the script from a step that ends the mission: what that waits for, what the steps wait
/// for that would bring it about, and so on. Empty when the mission was finished, or no step ends
/// it. Looks at the log alone. Of a step that waits for one of several things, silences and
/// expiries are left out where there are others. Cost: O(steps × records).
std::vector<Waiting> waits_of(const scenario::Scenario& scenario,
                              const std::vector<journal::Record>& records);

/// The lines of the event log that say it, at the end of the run.
std::vector<journal::Record> waiting_lines(const std::vector<Waiting>& waits, MissionTime at);

/// "step end waits for task 32 of heliv ended: aborted since 480.9 s (its contact-loss policy
/// hold)".
std::string to_text(const Waiting& waiting);

}  // namespace skein::laws
