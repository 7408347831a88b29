// SPDX-License-Identifier: Apache-2.0
#include "validate.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "given_plans.hpp"
#include "show_diagnostics.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/htn/text_style.hpp"
#include "skein/htn/validator.hpp"

namespace skein::plan_tool {

namespace {

using htn::GivenPlan;
using htn::Validation;

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

}  // namespace

int validate_plans(Library& library, const std::vector<ChosenProblem>& problems,
                   const PlanOptions& options, const Surroundings& surroundings,
                   const Streams& streams) {
  Diagnostics errors;
  const std::vector<GivenPlan> plans =
      plans_of(options.validate, library, problems, streams.in, errors);
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
