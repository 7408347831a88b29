// SPDX-License-Identifier: Apache-2.0
#include "given_plans.hpp"

#include <algorithm>

#include "file_text.hpp"

namespace skein::plan_tool {

using htn::GivenPlan;

namespace {

// An object may say that the plan has no steps; a text without steps says nothing.
bool is_json(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string::npos && text[begin] == '{';
}

/// Why there is no problem to check a plan with.
Diagnostic no_problem(const std::string& file, const GivenPlan& plan) {
  Diagnostic out;
  out.file = file;
  out.message = plan.problem.empty() ? "the plan does not say of which problem it is"
                                     : "the plan is of problem '" + plan.problem +
                                           "', which is not among those read";
  out.expected = plan.problem.empty() ? "one problem, chosen with --problem" : "";
  return out;
}

}  // namespace

const ChosenProblem* problem_of(const GivenPlan& plan, const std::vector<ChosenProblem>& problems) {
  if (plan.problem.empty()) return problems.size() == 1 ? &problems.front() : nullptr;
  const auto found = std::find_if(problems.begin(), problems.end(), [&](const auto& one) {
    return one.problem->name == plan.problem;
  });
  return found == problems.end() ? nullptr : &*found;
}

std::vector<GivenPlan> plans_of(const std::string& file, Library& library,
                                const std::vector<ChosenProblem>& problems, std::istream& in,
                                Diagnostics& errors) {
  const Result<std::string, Failure> text = text_of_file(file, in);
  std::vector<GivenPlan> plans;
  if (text) plans = htn::read_plans(file, *text, library.store(), errors);
  if (text && !is_json(*text) && plans.size() == 1 && plans[0].steps.empty()) plans.clear();
  for (const GivenPlan& plan : plans) {
    if (problem_of(plan, problems) == nullptr) errors.add(no_problem(file, plan));
  }
  if ((text && !plans.empty()) || !errors.empty()) return plans;
  Diagnostic diagnostic;
  diagnostic.file = file;
  diagnostic.message = text ? "there is no plan in it" : text.error().why;
  errors.add(diagnostic);
  return plans;
}

}  // namespace skein::plan_tool
