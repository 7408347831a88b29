// SPDX-License-Identifier: Apache-2.0
// A situation and high-level tasks as a problem of the planning language, in the form of the seeds.
#pragma once

#include <memory>
#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/domain.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor::testing {

/// What problem_of() gives the planner, written down for its reader by code of its own.
std::string problem_text(const PlanningRequest& request, const std::string& name);

/// The one problem of a text; null, with errors, if there is none.
std::unique_ptr<htn::Problem> read_problem(const std::string& text, htn::TermStore& store,
                                           Diagnostics& errors);

}  // namespace skein::supervisor::testing
