// SPDX-License-Identifier: Apache-2.0
// Exogenous changes given by --diverge.
#pragma once

#include <string>
#include <vector>

#include "library.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/htn_tools/given_plan.hpp"
#include "skein/htn_tools/repair.hpp"

namespace skein::plan_tool {

/// Forms (:add fact…), (:delete fact…), (:after N (:add fact…)…), in the order of when they were
/// noticed; `executed`: when, where a form does not say.
std::vector<htn::Divergence> read_divergences(const std::vector<std::string>& forms,
                                              htn::StepIndex executed, htn::TermStore& store,
                                              Diagnostics& errors);

/// Predicates that neither domain nor problem has are errors; other names that neither the files
/// nor the plan have are suspicious.
void check_divergences(const std::vector<htn::Divergence>& divergences, Library& library,
                       const ChosenProblem& chosen, const htn::GivenPlan& plan, Diagnostics& errors,
                       Diagnostics& warnings);

}  // namespace skein::plan_tool
