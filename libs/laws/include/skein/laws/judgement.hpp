// SPDX-License-Identifier: Apache-2.0
// A run judged by everything that can be said of its event log: laws of truth, of the protocol, of
// links that heal, and of contacts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/journal/record.hpp"
#include "skein/laws/violation.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::laws {

/// Names of laws that are judged, and their statements. Several names share one statement when they
/// are of one kind.
struct Statement {
  std::vector<std::string> names;
  std::string says;
};

/// What `judge` judges by: `all_laws`, "protocol", "healing" and "contact".
std::vector<Statement> judged_by();

struct Judging {
  std::vector<std::string> only = {};  ///< names of laws; all if empty
  /// Played over DDS, in real time: so much mission time may clocks of nodes differ, and may what
  /// passes between them be late, beside what the scenario's radio says. Nodes hear each other
  /// before such a mission begins, so "contact" is not judged (contact.hpp); nor is what depends on
  /// the simulator's word of links if the radio is silent: then nodes are not cut by it.
  std::optional<Duration> over_dds = {};
};

/// Every violation of every law: those of truth in the order of time, then "protocol", "healing"
/// and "contact", whose sentences begin with their instants. Cost: a few times that of reading the
/// log.
std::vector<Violation> judge(const scenario::Scenario& scenario,
                             const std::vector<journal::Record>& records,
                             const Judging& judging = {});

}  // namespace skein::laws
