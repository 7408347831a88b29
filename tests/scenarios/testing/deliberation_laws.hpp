// SPDX-License-Identifier: Apache-2.0
// Laws that the event log keeps of any run with UAVs at degree 4.
#pragma once

#include <string>
#include <vector>

#include "skein/journal/record.hpp"

namespace skein::testing {

/// Looks at the log alone. Gives each breach, with its instant; empty when all laws hold:
/// - goals: each state follows from the one before (received, planned, under-way, then settled;
/// back
///   to planned or received only by a repair or a hand-over), and nothing follows a settled one;
/// - plans: revisions count up by one; with each come the tasks that are new or changed in it, no
///   more than it has; no task is to end before it starts;
/// - origin: a task that a plan once had belongs to the same goal ever after;
/// - promises: at degree 4, a UAV in the air has a motion task that is not over, or another one
///   under way, but for `moment` seconds between two, or says why not in a decision or notice;
/// - decisions: numbered without gap; each repair names its cause.
std::vector<std::string> broken_deliberation_laws(const std::vector<journal::Record>& records,
                                                  double moment = 5);

}  // namespace skein::testing
