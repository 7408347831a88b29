// SPDX-License-Identifier: Apache-2.0
// Laws that the event log of any run keeps, whatever the scenario and its faults.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/journal/record.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::laws {

/// Checks the log alone, so that it shares no code with the nodes. A node's memory ends with a
/// scripted kill of it. Returns each breach, with its instant; empty when all laws hold:
/// - tasks: only the transitions of spec 2.1, so at most one terminal state, and that the last;
///   when a UAV's degree changes, the executive that takes a task over continues from its state;
/// - commands: issued once, then delivered at most once, then settled exactly once (acknowledged,
///   refused or expired), at the latest `command_limit` after their issue, in which does not count
///   that the ground station is dead; what is acknowledged was delivered before;
/// - synchronisation: nothing is received that was not sent before (over DDS, where lines and what
///   they tell of take ways of their own, but for what its sender said when it was killed);
/// - messages: each is received at most once, in the order of its sequence, after it was sent;
/// - samples: none breaks the rules of the wire, none is too long for it;
/// - links: nothing is received over a link that has been down for more than a moment, unless there
///   is a way past nodes that `route` lines have named before.
/// `late`: how long after a link went down something may still come over it, beside a moment (see
/// History::late); absent: `link` lines say nothing of what the samples really pass.
std::vector<std::string> broken_protocol(const std::vector<journal::Record>& records,
                                         Duration command_limit = Duration::seconds(66),
                                         std::optional<Duration> late = Duration());

/// The `command_limit` of a scenario: the lifetime of its commands, and a tenth of a minute in
/// which what came of them is told.
Duration command_limit(const scenario::Scenario& scenario);

/// For messages of tests: one per line.
std::string to_text(const std::vector<std::string>& breaches);

}  // namespace skein::laws
