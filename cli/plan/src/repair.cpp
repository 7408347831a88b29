// SPDX-License-Identifier: Apache-2.0
#include "repair.hpp"

#include <algorithm>
#include <ostream>

#include "given_plans.hpp"
#include "show_diagnostics.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/htn/repair_text.hpp"
#include "skein/htn/syntax.hpp"

namespace skein::plan_tool {

namespace {

using htn::Change;
using htn::Divergence;
using htn::Document;
using htn::NodeIndex;
using htn::Repair;
using htn::RepairVerdict;
using htn::Term;

constexpr const char* kForms = "(:add fact…), (:delete fact…) or (:after N (:add fact…)…)";

/// Reads what --diverge says.
class DivergenceReader {
 public:
  DivergenceReader(htn::TermStore& store, Diagnostics& errors) : store_(store), errors_(errors) {}

  std::vector<Divergence> read(const std::vector<std::string>& forms, htn::StepIndex executed) {
    for (const std::string& form : forms) {
      const Document document = htn::read_document("--diverge", form, store_, errors_);
      for (const NodeIndex top : document.top) read_form(document, top, executed, true);
    }
    std::stable_sort(out_.begin(), out_.end(), [](const Divergence& left, const Divergence& right) {
      return left.after < right.after;
    });
    return std::move(out_);
  }

 private:
  void wrong(const Document& document, NodeIndex at) {
    const htn::Place place = htn::place_of(document, document[at].begin);
    Diagnostic diagnostic;
    diagnostic.file = document.file;
    diagnostic.line = place.line;
    diagnostic.column = place.column;
    diagnostic.message = "this is no divergence";
    diagnostic.expected = kForms;
    errors_.add(diagnostic);
  }

  void read_form(const Document& document, NodeIndex at, htn::StepIndex after, bool outermost) {
    const std::vector<NodeIndex> parts = htn::children(document, at);
    const std::string_view word =
        parts.empty() || document[parts[0]].list || !is_symbol(document[parts[0]].atom)
            ? std::string_view{}
            : store_.name(document[parts[0]].atom);
    if (word == ":add" || word == ":delete") {
      for (std::size_t part = 1; part < parts.size(); ++part) {
        at_step(after).changes.push_back({word == ":add", term(document, parts[part])});
      }
    } else if (word == ":after" && outermost && parts.size() > 1) {
      const std::optional<htn::StepIndex> step = number(document[parts[1]]);
      if (!step) return wrong(document, parts[1]);
      for (std::size_t part = 2; part < parts.size(); ++part) {
        read_form(document, parts[part], *step, false);
      }
    } else {
      wrong(document, at);
    }
  }

  static bool is_symbol(Term term) { return term.is(htn::TermKind::kSymbol); }

  std::optional<htn::StepIndex> number(const htn::Node& node) const {
    if (node.list || !node.atom.is(htn::TermKind::kNumber)) return {};
    const double value = htn::to_double(store_.value(node.atom));
    if (value < 0 || value > 1e9) return {};
    return static_cast<htn::StepIndex>(value);
  }

  Divergence& at_step(htn::StepIndex after) {
    const auto known = std::find_if(out_.begin(), out_.end(),
                                    [after](const Divergence& one) { return one.after == after; });
    if (known != out_.end()) return *known;
    return out_.emplace_back(Divergence{after, {}});
  }

  // Facts are flat or nearly so; what is nested deeper than this is no fact.
  Term term(const Document& document, NodeIndex at, int depth = 0) {
    if (!document[at].list || depth > 100) return document[at].atom;
    std::vector<Term> items;
    for (const NodeIndex child : htn::children(document, at)) {
      items.push_back(term(document, child, depth + 1));
    }
    return store_.list(items);
  }

  htn::TermStore& store_;
  Diagnostics& errors_;
  std::vector<Divergence> out_;
};

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
      DivergenceReader(library.store(), errors).read(options.diverge, request.executed);
  if (errors.empty() && plans.size() != 1) {
    errors.add(
        about(options.repair, "there are " + std::to_string(plans.size()) + " plans in it", "one"));
  }
  if (errors.empty() && plans[0].without_internal) {
    errors.add(about(options.repair, "the plan was written without its internal steps",
                     "what --json --tree writes without --no-internal"));
  }
  const bool colour = surroundings.colour_err;
  show(errors, Severity::kError, library.definitions(),
       colour ? htn::kTerminalText : htn::kPlainText, streams.err);
  if (!errors.empty()) return kExitBadInput;

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
