// SPDX-License-Identifier: Apache-2.0
#include "validate.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "file_text.hpp"
#include "show_diagnostics.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/htn/text_style.hpp"
#include "skein/htn/validator.hpp"

namespace skein::plan_tool {

namespace {

using htn::GivenPlan;
using htn::Validation;

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

const ChosenProblem* problem_of(const GivenPlan& plan, const std::vector<ChosenProblem>& problems) {
  if (plan.problem.empty()) return problems.size() == 1 ? &problems.front() : nullptr;
  const auto found = std::find_if(problems.begin(), problems.end(), [&](const auto& one) {
    return one.problem->name == plan.problem;
  });
  return found == problems.end() ? nullptr : &*found;
}

nlohmann::ordered_json to_json(const std::string& problem, const Validation& validation) {
  nlohmann::ordered_json out;
  out["problem"] = problem;
  out["result"] = validation.fault ? "invalid" : "valid";
  out["steps"] = validation.steps;
  out["cost"] = htn::to_double(validation.cost);
  out["tree_checked"] = validation.tree_checked;
  if (!validation.fault) return out;
  out["step"] = validation.fault->step;
  if (validation.fault->line > 0) out["line"] = validation.fault->line;
  out["why"] = to_text(validation);
  return out;
}

class Checker {
 public:
  Checker(Library& library, const PlanOptions& options, const Surroundings& surroundings,
          std::ostream& out)
      : library_(library),
        options_(options),
        style_(surroundings.colour_out ? htn::kTerminalText : htn::kPlainText),
        out_(out) {}

  void check(const ChosenProblem& chosen, const GivenPlan& plan) {
    const htn::Validator* validator = validator_of(*chosen.domain);
    if (validator == nullptr) return;
    const Validation validation = validator->validate(*chosen.problem, plan);
    all_valid_ = all_valid_ && !validation.fault;
    if (options_.json) {
      const auto replace = nlohmann::ordered_json::error_handler_t::replace;
      out_ << to_json(chosen.problem->name, validation).dump(-1, ' ', false, replace) << '\n';
      return;
    }
    out_ << style_.mark(style_.bold, chosen.problem->name) << ": "
         << style_.mark(validation.fault ? style_.bad : style_.good, to_text(validation)) << '\n';
  }

  bool all_valid() const { return all_valid_; }
  const Diagnostics& errors() const { return errors_; }

 private:
  const htn::Validator* validator_of(const htn::DomainDefinition& domain) {
    auto& validator = validators_[&domain];
    if (validator) return validator.get();
    const std::size_t before = errors_.size();
    validator = std::make_unique<htn::Validator>(domain, library_.definitions().functions,
                                                 library_.functions(), library_.store(), errors_);
    return errors_.size() == before ? validator.get() : nullptr;
  }

  Library& library_;
  const PlanOptions& options_;
  const htn::TextStyle& style_;
  std::ostream& out_;
  Diagnostics errors_;
  bool all_valid_ = true;
  std::map<const htn::DomainDefinition*, std::unique_ptr<htn::Validator>> validators_;
};

std::vector<GivenPlan> plans_of(const std::string& file, Library& library, std::istream& in,
                                Diagnostics& errors) {
  const Result<std::string, Failure> text = text_of_file(file, in);
  std::vector<GivenPlan> plans;
  if (text) plans = htn::read_plans(file, *text, library.store(), errors);
  if ((text && !plans.empty()) || !errors.empty()) return plans;
  Diagnostic diagnostic;
  diagnostic.file = file;
  diagnostic.message = text ? "there is no plan in it" : text.error().why;
  errors.add(diagnostic);
  return plans;
}

}  // namespace

int validate_plans(Library& library, const std::vector<ChosenProblem>& problems,
                   const PlanOptions& options, const Surroundings& surroundings,
                   const Streams& streams) {
  Diagnostics errors;
  const std::vector<GivenPlan> plans = plans_of(options.validate, library, streams.in, errors);
  for (const GivenPlan& plan : plans) {
    if (problem_of(plan, problems) == nullptr) errors.add(no_problem(options.validate, plan));
  }
  Checker checker(library, options, surroundings, streams.out);
  if (errors.empty()) {
    for (const GivenPlan& plan : plans) checker.check(*problem_of(plan, problems), plan);
    errors.append(checker.errors());
  }
  const htn::TextStyle& style = surroundings.colour_err ? htn::kTerminalText : htn::kPlainText;
  show(errors, Severity::kError, library.definitions(), style, streams.err);
  if (!errors.empty()) return kExitBadInput;
  return checker.all_valid() ? kExitOk : kExitNegative;
}

}  // namespace skein::plan_tool
