// SPDX-License-Identifier: Apache-2.0
// Results of plan repair as text and JSON.
#pragma once

#include <string>

#include "skein/htn_tools/repair.hpp"
#include "skein/htn_tools/text_style.hpp"

namespace skein::htn {

/// Heading, what was lost, which tasks are accomplished otherwise, and the whole plan: executed
/// steps marked with a dot, new ones with +; below it the steps that were dropped.
std::string to_text(const std::string& problem, const RepairRequest& request, const Repair& repair,
                    const TermStore& store, const TextStyle& style);

/// One line (without its end): {"problem":…,"result":"stands"|"repaired"|"no-plan"|"limit"|"error",
/// "why":…,"executed":N,"plans":[the plan with its tree],"kept":[position…],"added":[…],
/// "dropped":[position in the old plan…],"redone":[{"task":[…],"begun":true}],
/// "lost":{"fact":[…],"task":[…]},"attempts":…,"expansions":…,"inferences":…}. `read_plans`
/// reads the plan back.
std::string to_json(const std::string& problem, const RepairRequest& request, const Repair& repair,
                    const TermStore& store);

}  // namespace skein::htn
