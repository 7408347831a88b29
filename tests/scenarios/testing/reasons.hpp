// SPDX-License-Identifier: Apache-2.0
// What an event log says of a mission that did not end as it was to.
#pragma once

#include <string>
#include <vector>

#include "skein/journal/record.hpp"

namespace skein::testing {

/// Something said that what was to be is not to be: a policy of lost contact, a command that came
/// too late, a task, goal or mission that failed with its reason.
bool says_why(const std::vector<journal::Record>& records);

/// A mission that was not finished says which step of its script waits for what, and at least of
/// one thing why that does not come (lines `waiting` of its runner).
bool is_explained(const std::vector<journal::Record>& records);

/// Tasks that an executive has under way at the end and the vehicle has not: a line each.
std::string left_under_way(const std::vector<journal::Record>& records);

}  // namespace skein::testing
