// SPDX-License-Identifier: Apache-2.0
#include "validate.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "given_plans.hpp"
#include "show_diagnostics.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/htn_tools/text_style.hpp"
#include "skein/htn_tools/tree_finder.hpp"
#include "skein/htn_tools/validator.hpp"

namespace skein::plan_tool {

namespace {

using htn::GivenPlan;
using htn::Validation;

/// What was found about one plan.
struct Verification {
  Validation validation;
  std::string undecided;  ///< why it is not known whether the steps accomplish the tasks
};

std::string text_of(const Verification& made) {
  if (made.undecided.empty()) return to_text(made.validation);
  return "the steps apply, but whether they accomplish the tasks is not known: " + made.undecided;
}

nlohmann::ordered_json to_json(const std::string& problem, const Verification& made) {
  const Validation& validation = made.validation;
  nlohmann::ordered_json out;
  out["problem"] = problem;
  out["result"] = validation.fault ? "invalid" : made.undecided.empty() ? "valid" : "limit";
  out["steps"] = validation.steps;
  out["cost"] = htn::to_double(validation.cost);
  out["tree_checked"] = validation.tree_checked;
  if (!made.undecided.empty()) out["why"] = text_of(made);
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
        out_(out) {
    host_.cpu_seconds = surroundings.cpu_seconds;
    host_.cancelled = surroundings.interrupted;
  }

  void check(const ChosenProblem& chosen, const GivenPlan& plan) {
    const htn::Validator* validator = validator_of(*chosen.domain);
    if (validator == nullptr) return;
    const Verification made = verify(*validator, chosen, plan);
    const bool invalid = made.validation.fault.has_value();
    all_valid_ = all_valid_ && !invalid;
    all_decided_ = all_decided_ && made.undecided.empty();
    if (options_.json) {
      const auto replace = nlohmann::ordered_json::error_handler_t::replace;
      out_ << to_json(chosen.problem->name, made).dump(-1, ' ', false, replace) << '\n';
      return;
    }
    const std::string_view colour = invalid                  ? style_.bad
                                    : made.undecided.empty() ? style_.good
                                                             : style_.accent;
    out_ << style_.mark(style_.bold, chosen.problem->name) << ": "
         << style_.mark(colour, text_of(made)) << '\n';
  }

  bool all_valid() const { return all_valid_; }
  bool all_decided() const { return all_decided_; }
  const Diagnostics& errors() const { return errors_; }

 private:
  // A plan without a tree is given one, if there is one: only with it are the tasks accomplished.
  Verification verify(const htn::Validator& validator, const ChosenProblem& chosen,
                      const GivenPlan& plan) {
    Verification made{validator.validate(*chosen.problem, plan), ""};
    if (made.validation.fault || !plan.tree.empty()) return made;
    const htn::Domain* domain = library_.compiled(*chosen.domain);
    if (domain == nullptr) {
      made.undecided = "the domain cannot be compiled";
      return made;
    }
    const htn::FoundTree found =
        find_tree(*domain, htn::make_problem(*chosen.problem, library_.store()), plan,
                  limits_for(plan), host_);
    switch (found.verdict) {
      case htn::Verdict::kPlan:
        made.validation = validator.validate(*chosen.problem, found.plan);
        break;
      case htn::Verdict::kNoPlan:
        made.validation.fault =
            htn::Fault{htn::FaultKind::kTasks, plan.steps.size(), 0,
                       "the steps apply, but no decomposition of the problem's tasks yields them"};
        break;
      default:
        made.undecided = found.why;
    }
    return made;
  }

  // A domain that recurs for ever has no end otherwise.
  htn::Limits limits_for(const GivenPlan& plan) const {
    constexpr std::uint64_t kExpansions = 1'000'000;
    constexpr std::uint64_t kExpansionsPerStep = 1'000;
    htn::Limits limits = options_.search.limits;
    if (!limits.expansions && !limits.seconds) {
      limits.expansions = kExpansions + kExpansionsPerStep * plan.steps.size();
    }
    return limits;
  }

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
  htn::Host host_;
  Diagnostics errors_;
  bool all_valid_ = true;
  bool all_decided_ = true;
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
  if (!errors.empty()) {
    if (options.json) streams.out << to_json_line(errors);
    return kExitBadInput;
  }
  if (surroundings.interrupted && surroundings.interrupted()) return kExitInterrupted;
  if (!checker.all_decided()) return kExitTimeout;
  return checker.all_valid() ? kExitOk : kExitNegative;
}

}  // namespace skein::plan_tool
