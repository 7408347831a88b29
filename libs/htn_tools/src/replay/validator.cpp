// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/validator.hpp"

#include <algorithm>
#include <cmath>

#include "replay/tree.hpp"

namespace skein::htn {

namespace {

using replay::Application;
using replay::World;

constexpr std::size_t kMostApplications = 200;
constexpr double kCostTolerance = 1e-6;  // relative: files give costs with their own rounding

std::optional<std::size_t> length(const TermStore& store, Term list) {
  if (!store.is_list(list)) return {};
  return store.items(list).size();
}

bool same_cost(const Number& left, const Number& right) {
  const double one = to_double(left);
  const double other = to_double(right);
  return std::abs(one - other) <= kCostTolerance * std::max({1.0, std::abs(one), std::abs(other)});
}

/// One replay of the steps of a plan. Steps whose precondition leaves a choice are kept with their
/// other applications, and taken back when a later step does not apply.
class Replay {
 public:
  Replay(replay::ProofContext& context, World& world, const GivenPlan& plan, std::size_t retries)
      : context_(context), world_(world), plan_(plan), retries_left_(retries) {}

  /// The first step that does not apply, for the choices that lead furthest.
  std::optional<Fault> run() {
    while (tried_.size() < plan_.steps.size()) {
      if (std::optional<Fault> fault = extend()) {
        if (!furthest_ || furthest_->step < fault->step) furthest_ = std::move(fault);
        if (context_.error || !take_back()) return furthest_;
      }
    }
    return {};
  }

  /// Undoes steps up to the last that can be applied otherwise, and applies it so.
  bool take_back() {
    while (!tried_.empty() && retries_left_ > 0) {
      Tried last = std::move(tried_.back());
      tried_.pop_back();
      world_.undo(last.mark);
      if (!last.clause->chooses) continue;
      --retries_left_;
      const GivenStep& step = plan_.steps[tried_.size()];
      if (!proceed(std::move(last), step)) return true;
    }
    return false;
  }

  std::vector<Application> done() const {
    std::vector<Application> out;
    for (const Tried& tried : tried_) out.push_back(tried.applications[tried.next - 1]);
    return out;
  }

 private:
  struct Tried {
    const replay::OperatorClause* clause;
    std::size_t mark;  ///< of the world before the step
    std::vector<Application> applications;
    std::size_t next = 0;
    bool all = false;  ///< applications are all there are
  };

  Fault fault(FaultKind kind, std::string why) const {
    const std::size_t step = tried_.size();
    return {context_.error ? FaultKind::kEvaluation : kind, step, plan_.steps[step].line,
            context_.error ? "cannot be evaluated: " + *context_.error : std::move(why)};
  }

  std::optional<Fault> extend() {
    const GivenStep& step = plan_.steps[tried_.size()];
    const Term name = replay::predicate_of(context_.store, step.action);
    const replay::OperatorClause* clause = context_.clauses.operator_named(name);
    if (clause == nullptr) {
      return fault(FaultKind::kUnknownOperator, "unknown operator " + context_.store.to_text(name));
    }
    const auto wanted = length(context_.store, clause->head);
    const auto given = length(context_.store, step.action);
    if (wanted && given && *wanted != *given) {
      return fault(FaultKind::kArity, context_.store.to_text(name) + " takes " +
                                          std::to_string(*wanted - 1) + " arguments, not " +
                                          std::to_string(*given - 1));
    }
    const Term action = free_action(step.action);
    Tried tried{clause, world_.mark(), applications(context_, *clause, action, 1), 0, false};
    if (tried.applications.empty()) {
      const std::string unmet = unmet_conjunct(context_, *clause, action);
      return fault(FaultKind::kPrecondition, "precondition unmet: " + unmet);
    }
    return proceed(std::move(tried), step);
  }

  /// Applies the next application that may be; the step then counts as tried.
  std::optional<Fault> proceed(Tried tried, const GivenStep& step) {
    std::optional<Fault> first;
    while (true) {
      if (tried.next == tried.applications.size() && !expand(tried, step)) {
        return first ? first : fault(FaultKind::kPrecondition, "no other way to apply it");
      }
      const Application& application = tried.applications[tried.next++];
      std::optional<Fault> problem;
      if (step.cost && !same_cost(*step.cost, application.cost)) {
        problem = fault(FaultKind::kCost,
                        "costs " + to_text(application.cost) + ", not " + to_text(*step.cost));
      } else if (auto reason = apply(context_, world_, application)) {
        problem = fault(FaultKind::kEffect, *reason);
      }
      if (!problem) break;
      if (!first) first = std::move(problem);
    }
    tried_.push_back(std::move(tried));
    return {};
  }

  bool expand(Tried& tried, const GivenStep& step) {
    if (tried.all || !tried.clause->chooses || retries_left_ == 0) return false;
    --retries_left_;
    tried.all = true;
    for (Application& one :
         applications(context_, *tried.clause, free_action(step.action), kMostApplications)) {
      const auto known = std::find(tried.applications.begin(), tried.applications.end(), one);
      if (known == tried.applications.end()) tried.applications.push_back(std::move(one));
    }
    return tried.next < tried.applications.size();
  }

  // Variables that the planner left unbound may be anything.
  Term free_action(Term action) {
    if (context_.store.ground(action)) return action;
    std::map<std::uint32_t, std::uint32_t> fresh;
    return replay::replace_variables(context_.store, action, [&](Term variable) {
      const auto [at, isNew] = fresh.try_emplace(variable.index(), 0);
      if (isNew) at->second = context_.bindings.fresh(1);
      return Term{TermKind::kVariable, at->second};
    });
  }

  replay::ProofContext& context_;
  World& world_;
  const GivenPlan& plan_;
  std::size_t retries_left_;
  std::vector<Tried> tried_;
  std::optional<Fault> furthest_;
};

/// The same plan with its floats as single precision where their text allows it.
GivenPlan in_single_precision(const GivenPlan& plan, TermStore& store);

}  // namespace

class Validator::Implementation {
 public:
  Implementation(const DomainDefinition& domain, const std::vector<FunctionDefinition>& functions,
                 const Functions& host, TermStore& store, Diagnostics& errors)
      : store_(store),
        lisp_(store, host, functions),
        clauses_(replay::read_clauses(domain, store, lisp_, errors)) {}

  Validation validate(const ProblemDefinition& problem, const GivenPlan& plan,
                      const Limits& limits) {
    if (plan.without_internal && has_internal_operators()) {
      Validation out;
      out.fault = Fault{FaultKind::kInternalLeftOut, 0, 0,
                        "the plan was written without its internal steps (!!name), so it cannot "
                        "be replayed"};
      return out;
    }
    Validation out = validate_once(problem, plan, limits);
    if (!out.fault || out.fault->kind == FaultKind::kUnknownOperator) return out;
    const GivenPlan single = in_single_precision(plan, store_);
    if (same_actions(plan, single)) return out;
    Validation other = validate_once(problem, single, limits);
    return !other.fault || other.steps > out.steps ? other : out;
  }

 private:
  static bool same_actions(const GivenPlan& one, const GivenPlan& other) {
    return std::equal(one.steps.begin(), one.steps.end(), other.steps.begin(),
                      [](const GivenStep& a, const GivenStep& b) { return a.action == b.action; });
  }

  bool has_internal_operators() const {
    return std::any_of(clauses_.operators.begin(), clauses_.operators.end(), [&](const auto& one) {
      const std::string text = store_.to_text(store_.car(one.second.head));
      return text.starts_with("!!") && text != replay::kNoOperation;
    });
  }

  World initial_world(const ProblemDefinition& problem) {
    World world(store_);
    if (!problem.facts) return world;
    for (const NodeIndex fact : children(*problem.facts.document, problem.facts.node)) {
      if (!is_fact({problem.facts.document, fact})) continue;
      world.add(replay::term_of({problem.facts.document, fact}, store_));
    }
    return world;
  }

  Validation validate_once(const ProblemDefinition& problem, const GivenPlan& plan,
                           const Limits& limits) {
    lisp_.begin();
    World world = initial_world(problem);
    replay::Bindings bindings(store_);
    replay::ProofContext context{store_, clauses_, world, lisp_, bindings, limits.inferences, {}};
    Replay replay(context, world, plan, limits.retries);
    Validation out;
    std::optional<Fault> first;
    do {
      out = outcome(replay, problem, plan, context);
      if (!out.fault) return out;
      if (!first) first = out.fault;
    } while (out.fault->kind == FaultKind::kTree && !context.error && replay.take_back());
    out.fault = first;
    out.steps = first->kind == FaultKind::kTree ? plan.steps.size() : first->step;
    return out;
  }

  Validation outcome(Replay& replay, const ProblemDefinition& problem, const GivenPlan& plan,
                     replay::ProofContext& context) {
    Validation out;
    out.fault = replay.run();
    if (out.fault) return out;
    const std::vector<Application> done = replay.done();
    out.steps = done.size();
    out.cost = integer(0);
    for (const Application& application : done) {
      out.cost = add(out.cost, application.cost).value_or(out.cost);
    }
    if (plan.cost && !same_cost(*plan.cost, out.cost)) {
      out.fault =
          Fault{FaultKind::kCost, done.empty() ? 0 : done.size() - 1, 0,
                "the steps cost " + to_text(out.cost) + ", the plan says " + to_text(*plan.cost)};
    } else if (!plan.tree.empty()) {
      out.tree_checked = true;
      out.fault = tree_fault(problem, plan, done, context);
    }
    return out;
  }

  std::optional<Fault> tree_fault(const ProblemDefinition& problem, const GivenPlan& plan,
                                  const std::vector<Application>& done,
                                  replay::ProofContext& context) {
    std::uint32_t slots = 0;
    Diagnostics errors;
    const replay::NetworkClause tasks = replay::read_tasks(problem, store_, lisp_, slots, errors);
    World world = initial_world(problem);
    replay::ProofContext here{store_,           clauses_,           world, lisp_,
                              context.bindings, context.steps_left, {}};
    const auto fault = replay::check_tree(here, world, tasks, slots, plan, done);
    context.steps_left = here.steps_left;
    if (!fault) return {};
    return Fault{FaultKind::kTree, fault->node, 0, fault->why};
  }

  TermStore& store_;
  Lisp lisp_;
  replay::Clauses clauses_;
};

namespace {

GivenPlan in_single_precision(const GivenPlan& plan, TermStore& store) {
  // Numbers are no variables, so the terms are taken apart by hand; lists of arguments are short.
  const std::function<Term(Term, int)> convert = [&](Term term, int depth) -> Term {
    if (term.is(TermKind::kPair) && depth < 200) {
      std::vector<Term> items;
      for (; term.is(TermKind::kPair); term = store.cdr(term)) {
        items.push_back(convert(store.car(term), depth + 1));
      }
      return store.list(items, term);
    }
    if (!term.is(TermKind::kNumber)) return term;
    const Number number = store.value(term);
    if (number.kind != NumberKind::kDouble) return term;
    const Term other = store.number(single(number.real));
    return store.to_text(other) == store.to_text(term) ? other : term;
  };
  GivenPlan out = plan;
  for (GivenStep& step : out.steps) step.action = convert(step.action, 0);
  for (GivenNode& node : out.tree) node.task = convert(node.task, 0);
  return out;
}

}  // namespace

Validator::Validator(const DomainDefinition& domain,
                     const std::vector<FunctionDefinition>& functions, const Functions& host,
                     TermStore& store, Diagnostics& errors)
    : implementation_(std::make_unique<Implementation>(domain, functions, host, store, errors)) {}

Validator::~Validator() = default;

Validation Validator::validate(const ProblemDefinition& problem, const GivenPlan& plan,
                               const Limits& limits) const {
  return implementation_->validate(problem, plan, limits);
}

std::string to_text(const Validation& validation) {
  if (!validation.fault) {
    return "valid: " + std::to_string(validation.steps) + " steps, cost " +
           to_text(validation.cost) + (validation.tree_checked ? ", tree checked" : "");
  }
  const Fault& fault = *validation.fault;
  if (fault.kind == FaultKind::kInternalLeftOut || fault.kind == FaultKind::kTasks) {
    return fault.why;
  }
  const char* what = fault.kind == FaultKind::kTree ? "tree node " : "step ";
  const std::size_t number = fault.kind == FaultKind::kTree ? fault.step : fault.step + 1;
  std::string out = what + std::to_string(number);
  if (fault.line > 0) out += " (line " + std::to_string(fault.line) + ")";
  return out + ": " + fault.why;
}

}  // namespace skein::htn
