// SPDX-License-Identifier: Apache-2.0
// Text for people about a search: trace lines, and reasons for failure.
#pragma once

#include <string>

#include "skein/htn/planner.hpp"
#include "skein/htn_tools/text_style.hpp"

namespace skein::htn {

/// One line with its end: depth, then the event indented by it (up to 30 levels).
std::string to_text(const TraceEvent& event, const TermStore& store, const TextStyle& style);

/// The deepest point of a failed search: the last steps before it, the tasks open there from the
/// top, and for each attempt the condition that nothing satisfied with the facts nearest to it.
std::string to_text(const FailurePoint& failure, const TermStore& store, const TextStyle& style);

/// The point at which a limit ended a search: the last steps, the open tasks, and which of these
/// recur within themselves.
std::string standing_text(const FailurePoint& point, const TermStore& store,
                          const TextStyle& style);

}  // namespace skein::htn
