// SPDX-License-Identifier: Apache-2.0
#include "repair.hpp"

#include <algorithm>
#include <ostream>

#include "divergences.hpp"
#include "given_plans.hpp"
#include "show_diagnostics.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/htn_tools/repair_text.hpp"

namespace skein::plan_tool {

namespace {

using htn::Repair;
using htn::RepairVerdict;

int exit_code(RepairVerdict verdict, bool interrupted) {
  if (interrupted) return kExitInterrupted;
  switch (verdict) {
    case RepairVerdict::kStands:
    case RepairVerdict::kRepaired:
      return kExitOk;
    case RepairVerdict::kNoPlan:
      return kExitNegative;
    case RepairVerdict::kLimit:
      return kExitTimeout;
    default:
      return kExitBadInput;
  }
}

Diagnostic about(const std::string& file, std::string message, std::string expected) {
  Diagnostic diagnostic;
  diagnostic.file = file;
  diagnostic.message = std::move(message);
  diagnostic.expected = std::move(expected);
  return diagnostic;
}

bool same_terms(const htn::Plan& left, const htn::Plan& right) {
  return std::equal(left.tree.begin(), left.tree.end(), right.tree.begin(), right.tree.end(),
                    [](const htn::TreeNode& one, const htn::TreeNode& other) {
                      return one.task == other.task && one.support == other.support;
                    });
}

/// A request and the plan it points to.
struct Work {
  htn::Plan plan;
  htn::RepairRequest request;
};

// A file does not say of which precision its floats are.
Repair repair(const htn::Domain& domain, const htn::Problem& problem, const htn::GivenPlan& given,
              Work& work, const htn::RepairOptions& options, const htn::Host& host) {
  auto& [plan, request] = work;
  plan = htn::to_plan(given, false, domain.store());
  request.plan = &plan;
  Repair made = htn::repair(domain, problem, request, options, host);
  if (!made.plan.tree.empty() || made.verdict == RepairVerdict::kLimit) return made;
  htn::Plan other = htn::to_plan(given, true, domain.store());
  if (same_terms(plan, other)) return made;
  std::swap(plan, other);
  Repair again = htn::repair(domain, problem, request, options, host);
  if (again.verdict != RepairVerdict::kError) return again;
  std::swap(plan, other);
  return made;
}

}  // namespace

int repair_plan(Library& library, const std::vector<ChosenProblem>& problems,
                const PlanOptions& options, const Surroundings& surroundings,
                const Streams& streams) {
  Diagnostics errors;
  const auto plans = plans_of(options.repair, library, problems, streams.in, errors);
  Work work;
  htn::RepairRequest& request = work.request;
  request.executed = options.executed;
  request.divergences =
      read_divergences(options.diverge, request.executed, library.store(), errors);
  if (errors.empty() && plans.size() != 1) {
    errors.add(
        about(options.repair, "there are " + std::to_string(plans.size()) + " plans in it", "one"));
  }
  if (errors.empty() && plans[0].without_internal) {
    errors.add(about(options.repair, "the plan was written without its internal steps",
                     "what --json --tree writes without --no-internal"));
  }
  Diagnostics warnings;
  if (errors.empty()) {
    check_divergences(request.divergences, library, *problem_of(plans[0], problems), plans[0],
                      errors, warnings);
  }
  const bool colour = surroundings.colour_err;
  if (!options.quiet) {
    show(warnings, Severity::kWarning, library.definitions(),
         colour ? htn::kTerminalText : htn::kPlainText, streams.err);
  }
  show(errors, Severity::kError, library.definitions(),
       colour ? htn::kTerminalText : htn::kPlainText, streams.err);
  if (!errors.empty()) {
    if (options.json) streams.out << to_json_line(errors);
    return kExitBadInput;
  }

  const ChosenProblem& chosen = *problem_of(plans[0], problems);
  const htn::Problem problem = htn::make_problem(*chosen.problem, library.store());
  htn::Host host;
  host.cpu_seconds = surroundings.cpu_seconds;
  host.cancelled = surroundings.interrupted;
  htn::RepairOptions searched;
  searched.limits = options.search.limits;
  const Repair made =
      repair(*library.compiled(*chosen.domain), problem, plans[0], work, searched, host);
  const htn::TextStyle& style = surroundings.colour_out ? htn::kTerminalText : htn::kPlainText;
  streams.out << (options.json
                      ? to_json(chosen.problem->name, request, made, library.store()) + '\n'
                      : to_text(chosen.problem->name, request, made, library.store(), style));
  return exit_code(made.verdict, surroundings.interrupted && surroundings.interrupted());
}

}  // namespace skein::plan_tool
