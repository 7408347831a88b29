// SPDX-License-Identifier: Apache-2.0
// Plans of a file, and the problem each belongs to.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "library.hpp"
#include "skein/htn_tools/given_plan.hpp"

namespace skein::plan_tool {

/// The plans of a file ("-": standard input). What is wrong with it, and plans of problems that
/// were not read, go to `errors`.
std::vector<htn::GivenPlan> plans_of(const std::string& file, Library& library,
                                     const std::vector<ChosenProblem>& problems, std::istream& in,
                                     Diagnostics& errors);

/// The problem the plan names, or the only one if it names none; null if there is none.
const ChosenProblem* problem_of(const htn::GivenPlan& plan,
                                const std::vector<ChosenProblem>& problems);

}  // namespace skein::plan_tool
