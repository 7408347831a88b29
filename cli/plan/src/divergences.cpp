// SPDX-License-Identifier: Apache-2.0
#include "divergences.hpp"

#include <algorithm>
#include <unordered_set>

#include "skein/foundation/nearest.hpp"
#include "skein/htn/predicates.hpp"
#include "skein/htn/syntax.hpp"

namespace skein::plan_tool {

namespace {

using htn::Change;
using htn::Divergence;
using htn::Document;
using htn::NodeIndex;
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

/// Tells of names in what changed that neither the files nor the plan know.
class DivergenceCheck {
 public:
  DivergenceCheck(Library& library, const ChosenProblem& chosen, const htn::GivenPlan& plan)
      : store_(library.store()),
        predicates_(htn::predicates_of(library.definitions(), *chosen.domain, *chosen.problem,
                                       library.store())) {
    for (const auto& document : library.definitions().documents) {
      for (const htn::Node& node : document->nodes) take(node.atom);
    }
    for (const htn::GivenStep& step : plan.steps) take(step.action);
  }

  void check(const std::vector<Divergence>& divergences, Diagnostics& errors,
             Diagnostics& warnings) {
    for (const Divergence& divergence : divergences) {
      for (const Change& change : divergence.changes) check(change.fact, errors, warnings);
    }
  }

 private:
  void take(Term term) {
    for (; term.is(htn::TermKind::kPair); term = store_.cdr(term)) take(store_.car(term));
    known_.insert(term.bits());
  }

  void check(Term fact, Diagnostics& errors, Diagnostics& warnings) const {
    Diagnostic wrong;
    wrong.file = "--diverge";
    const std::string text = store_.to_text(fact);
    if (!fact.is(htn::TermKind::kPair) || !store_.car(fact).is(htn::TermKind::kSymbol)) {
      wrong.message = text + " is no fact";
      wrong.expected = "(predicate argument…)";
      return errors.add(wrong);
    }
    check_predicate(fact, wrong, errors);
    for (const Term argument : store_.items(store_.cdr(fact))) {
      if (!argument.is(htn::TermKind::kSymbol) || known_.contains(argument.bits())) continue;
      wrong.message = text + ": '" + store_.to_text(argument) + "' is named nowhere else";
      wrong.expected = wrong.nearest = "";
      warnings.add(wrong);
    }
  }

  void check_predicate(Term fact, Diagnostic& wrong, Diagnostics& errors) const {
    if (predicates_.any) return;
    const std::string name(store_.name(store_.car(fact)));
    const std::size_t given = store_.items(store_.cdr(fact)).size();
    const auto known = predicates_.arities.find(name);
    if (known == predicates_.arities.end()) {
      std::vector<std::string> names;
      for (const auto& [one, arities] : predicates_.arities) names.push_back(one);
      wrong.message = store_.to_text(fact) + ": the domain knows no predicate '" + name + "'";
      wrong.nearest = nearest_name(name, names);
    } else if (!known->second.contains(given)) {
      wrong.message = store_.to_text(fact) + " has " + std::to_string(given) + " arguments";
      for (const std::size_t one : known->second) {
        wrong.expected += (wrong.expected.empty() ? "" : " or ") + std::to_string(one);
      }
    } else {
      return;
    }
    errors.add(wrong);
  }

  htn::TermStore& store_;
  htn::Predicates predicates_;
  std::unordered_set<std::uint32_t> known_;
};

}  // namespace

std::vector<Divergence> read_divergences(const std::vector<std::string>& forms,
                                         htn::StepIndex executed, htn::TermStore& store,
                                         Diagnostics& errors) {
  return DivergenceReader(store, errors).read(forms, executed);
}

void check_divergences(const std::vector<Divergence>& divergences, Library& library,
                       const ChosenProblem& chosen, const htn::GivenPlan& plan, Diagnostics& errors,
                       Diagnostics& warnings) {
  DivergenceCheck(library, chosen, plan).check(divergences, errors, warnings);
}

}  // namespace skein::plan_tool
