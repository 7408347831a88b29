// SPDX-License-Identifier: Apache-2.0
#include "language/review.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "language/condition_checker.hpp"
#include "language/domain_reader.hpp"
#include "language/effect_checker.hpp"
#include "language/task_checker.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::htn {

namespace {

struct Arity {
  std::size_t arguments = 0;
  bool open = false;  ///< at least so many
};

/// The names and shapes of what can be a task of a domain.
class TaskTable {
 public:
  TaskTable(const ReadContext& context, const DomainDefinition& domain) {
    for (const OperatorDefinition& made : domain.operators) {
      const Term name = operator_name(made, context.store);
      const bool typed = made.action && made.parameters;
      add(context, name, typed ? typed_arity(context, made.parameters) : arity(made.head));
    }
    for (const MethodDefinition& made : domain.methods) {
      add(context, (*first(made.head)).atom, arity(made.head));
    }
    add(context, context.store.symbol("!!inop"), {});
  }

  const std::vector<Arity>* find(Term name) const {
    const auto at = arities_.find(name.bits());
    return at == arities_.end() ? nullptr : &at->second;
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  static Arity arity(Expression head) {
    if (!(*head).list) return {};
    const bool open = (*head).dotted;
    return {count(head) - (open ? 2 : 1), open};
  }
  static Arity typed_arity(const ReadContext& context, Expression parameters) {
    Arity out;
    for (Expression at = first(parameters); at; at = next(at)) {
      if (context.is_variable(at)) ++out.arguments;
    }
    return out;
  }
  void add(const ReadContext& context, Term name, Arity made) {
    std::vector<Arity>& known = arities_[name.bits()];
    if (known.empty()) names_.push_back(context.name(name));
    known.push_back(made);
  }

  std::map<std::uint32_t, std::vector<Arity>> arities_;
  std::vector<std::string> names_;
};

bool may_match(const Arity& head, const TaskUse& use) {
  if (head.open) return use.open || use.arguments >= head.arguments;
  return use.open ? use.arguments <= head.arguments : use.arguments == head.arguments;
}

std::string numbers_of(const std::vector<Arity>& arities) {
  std::set<std::string> texts;
  for (const Arity& one : arities) {
    texts.insert(std::to_string(one.arguments) + (one.open ? " or more" : ""));
  }
  std::string out;
  for (const std::string& text : texts) out += (out.empty() ? "" : " or ") + text;
  return out;
}

/// A domain as a whole. What it asks the reader's parts again is well formed: nothing is reported
/// twice.
class Review {
 public:
  Review(const ReadContext& context, const DomainDefinition& domain)
      : context_(context),
        muted_{context.store,       context.words, context.include,
               context.definitions, ignored_,      ignored_},
        domain_(domain),
        tasks_(context, domain) {}

  void check_tasks(Expression tasks);
  void check_methods();
  void check_statics();
  void check_predicates(const std::vector<const ProblemDefinition*>& problems);

 private:
  void check_task(const TaskUse& use);
  std::vector<Expression> used_atoms() const;
  void collect_provided(const std::vector<const ProblemDefinition*>& problems);
  void provide_inside(Expression tasks);
  void provide_by(const OperatorDefinition& made, bool& anything);
  void provide(Term predicate) {
    provided_.emplace(predicate.bits(), predicate);
    any_arity_.insert(predicate.bits());
  }
  void provide(Expression atom) {
    const Term predicate = context_.head(atom);
    provided_.emplace(predicate.bits(), predicate);
    if ((*atom).dotted) any_arity_.insert(predicate.bits());
    arities_.emplace(std::pair(predicate.bits(), count(atom) - 1), Expression());
  }
  /// Without looking for the predicate twice: facts are many.
  void provide_fact(Expression fact) {
    const Term predicate = context_.head(fact);
    provided_.emplace(predicate.bits(), predicate);
    if ((*fact).dotted) any_arity_.insert(predicate.bits());
    arities_.emplace(std::pair(predicate.bits(), count(fact) - 1), fact);
  }
  bool check_arity(Expression atom);
  void check_facts(const std::vector<Expression>& used);

  const ReadContext& context_;
  Diagnostics ignored_;
  ReadContext muted_;
  const DomainDefinition& domain_;
  TaskTable tasks_;
  std::set<std::pair<std::uint32_t, std::size_t>> reported_;
  std::map<std::uint32_t, Term> provided_;  // by the bits of the predicate
  std::set<std::uint32_t> any_arity_;
  // Of what is provided: the first fact of that arity, nothing where something else provides it.
  std::map<std::pair<std::uint32_t, std::size_t>, Expression> arities_;
};

void Review::check_tasks(Expression tasks) {
  TaskChecker checker(muted_);
  checker.check(tasks);
  for (const TaskUse& use : checker.tasks()) check_task(use);
}

void Review::check_task(const TaskUse& use) {
  const std::vector<Arity>* known = tasks_.find(use.name);
  const auto matches = [&use](const Arity& head) { return may_match(head, use); };
  if (known != nullptr && std::any_of(known->begin(), known->end(), matches)) return;
  if (!reported_.insert({use.name.bits(), use.arguments}).second) return;
  const std::string name = "task '" + context_.name(use.name) + "'";
  if (known == nullptr) {
    return context_.warn(use.task, name + " has neither method nor operator",
                         "a task of domain '" + domain_.name + "'",
                         nearest_name(context_.name(use.name), tasks_.names()));
  }
  context_.warn(use.task, name + " with " + counted(use.arguments, "argument") + " matches no head",
                numbers_of(*known));
}

void Review::check_methods() {
  for (const MethodDefinition& method : domain_.methods) {
    for (const BranchDefinition& branch : method.branches) {
      reported_.clear();
      check_tasks(branch.tasks);
    }
  }
  reported_.clear();
}

void Review::check_statics() {
  const auto is_static = [this](Expression atom) {
    const auto& all = domain_.static_predicates;
    return std::find(all.begin(), all.end(), context_.head(atom)) != all.end();
  };
  for (const OperatorDefinition& made : domain_.operators) {
    EffectChecker changes(muted_);
    changes.check_list(made.deletions);
    changes.check_list(made.additions);
    changes.check_effect(made.effect);
    for (const Expression atom : changes.atoms()) {
      if (!is_static(atom)) continue;
      context_.warn(atom, "an operator changes '" + context_.name(context_.head(atom)) + "'",
                    "no change of a predicate of :static");
    }
  }
}

// Predicates

std::vector<Expression> Review::used_atoms() const {
  ConditionChecker conditions(muted_);
  EffectChecker effects(muted_);
  check_conditions_and_effects(domain_, conditions, effects);
  std::vector<Expression> out = conditions.atoms();
  out.insert(out.end(), effects.condition_atoms().begin(), effects.condition_atoms().end());
  return out;
}

void Review::provide_by(const OperatorDefinition& made, bool& anything) {
  EffectChecker changes(muted_);
  changes.check_list(made.additions);
  changes.check_effect(made.effect);
  for (const Expression atom : changes.atoms()) provide(atom);
  anything = anything || changes.anything();
}

// An operator that adds what a variable holds adds what tasks pass to it.
void Review::provide_inside(Expression tasks) {
  if (!tasks) return;
  const std::vector<Node>& nodes = tasks.document->nodes;
  for (NodeIndex at = tasks.node; at < nodes.size() && nodes[at].begin < (*tasks).end; ++at) {
    provide(context_.head({tasks.document, at}));
  }
}

void Review::collect_provided(const std::vector<const ProblemDefinition*>& problems) {
  bool anything = false;
  for (const OperatorDefinition& made : domain_.operators) provide_by(made, anything);
  for (const AxiomDefinition& made : domain_.axioms) provide(made.head);
  for (const TypeDefinition& type : domain_.types) {
    provide(type.name);
    provide(type.super);
  }
  if (domain_.pddl) {
    for (const char* word : {"object", "=", "<", ">", "<=", ">="}) {
      provide(context_.store.symbol(word));
    }
  }
  for (const MethodDefinition& made : domain_.methods) {
    for (const BranchDefinition& branch : made.branches) {
      if (anything) provide_inside(branch.tasks);
    }
  }
  for (const ProblemDefinition* problem : problems) {
    for (Expression fact = first(problem->facts); fact; fact = next(fact)) {
      provide_fact(fact);
    }
    if (anything) provide_inside(problem->tasks);
  }
}

// Types may follow the arguments of declared heads: PDDL declares its arities elsewhere.
bool Review::check_arity(Expression atom) {
  const std::uint32_t bits = context_.head(atom).bits();
  const std::size_t given = count(atom) - 1;
  if (domain_.pddl || (*atom).dotted || any_arity_.contains(bits)) return true;
  if (arities_.contains({bits, given}) || !reported_.insert({bits, given}).second) return true;
  std::string known;
  for (auto at = arities_.lower_bound({bits, 0}); at != arities_.end() && at->first.first == bits;
       ++at) {
    known += (known.empty() ? "" : " or ") + std::to_string(at->first.second);
  }
  context_.warn(atom,
                "(" + context_.name(context_.head(atom)) + " …) with " +
                    counted(given, "argument") + " is never provided",
                known);
  return false;
}

// Facts of a predicate that is asked for with other numbers of arguments alone. Where one of those
// is provided by nobody that is told already.
void Review::check_facts(const std::vector<Expression>& used) {
  if (domain_.pddl) return;
  std::map<std::uint32_t, std::set<std::size_t>> asked;
  std::set<std::uint32_t> open;
  for (const Expression atom : used) {
    const std::uint32_t bits = context_.head(atom).bits();
    if ((*atom).dotted) open.insert(bits);
    asked[bits].insert(count(atom) - 1);
  }
  for (const auto& [made, fact] : arities_) {
    const std::uint32_t bits = made.first;
    const std::size_t given = made.second;
    const auto known = asked.find(bits);
    if (!fact || known == asked.end() || open.contains(bits)) continue;
    const std::set<std::size_t>& arities = known->second;
    if (arities.contains(given)) continue;
    if (!std::all_of(arities.begin(), arities.end(), [&](std::size_t one) {
          return arities_.contains({bits, one});
        }))
      continue;
    std::string expected;
    for (const std::size_t one : arities)
      expected += (expected.empty() ? "" : " or ") + std::to_string(one);
    context_.warn(fact,
                  "(" + context_.name(context_.head(fact)) + " …) with " +
                      counted(given, "argument") + " is never asked for",
                  expected);
  }
}

void Review::check_predicates(const std::vector<const ProblemDefinition*>& problems) {
  collect_provided(problems);
  std::vector<std::string> names;
  for (const auto& [bits, predicate] : provided_) names.push_back(context_.name(predicate));
  std::set<std::uint32_t> reported;
  const std::vector<Expression> used = used_atoms();
  check_facts(used);
  for (const Expression atom : used) {
    const Term predicate = context_.head(atom);
    if (provided_.contains(predicate.bits()) && !check_arity(atom)) continue;
    if (provided_.contains(predicate.bits()) || !reported.insert(predicate.bits()).second) continue;
    const std::string name = context_.name(predicate);
    context_.warn(atom, "nothing provides (" + name + " …)",
                  "a fact, an axiom or an operator that adds it", nearest_name(name, names));
  }
}

// The domain a problem names, or the last one; null if there is no such.
const DomainDefinition* domain_of(const ReadContext& context, const ProblemDefinition& problem) {
  const std::vector<DomainDefinition>& all = context.definitions.domains;
  if (problem.domain.empty()) return all.empty() ? nullptr : &all.back();
  const auto at = std::find_if(all.rbegin(), all.rend(), [&problem](const DomainDefinition& one) {
    return one.name == problem.domain;
  });
  return at == all.rend() ? nullptr : &*at;
}

void warn_unknown_domain(const ReadContext& context, const ProblemDefinition& problem) {
  std::vector<std::string> names;
  for (const DomainDefinition& domain : context.definitions.domains) names.push_back(domain.name);
  context.warn(problem.facts,
               "problem '" + problem.name + "' of unknown domain '" + problem.domain + "'",
               "a domain that is read with it", nearest_name(problem.domain, names));
}

}  // namespace

void review(const ReadContext& context, std::size_t domains, std::size_t problems) {
  const Definitions& all = context.definitions;
  if (!context.errors.empty() || all.domains.empty()) return;
  for (std::size_t i = problems; i < all.problems.size(); ++i) {
    if (domain_of(context, all.problems[i]) == nullptr)
      warn_unknown_domain(context, all.problems[i]);
  }
  for (std::size_t i = 0; i < all.domains.size(); ++i) {
    const bool fresh = i >= domains;
    std::vector<const ProblemDefinition*> own;
    std::size_t old = 0;
    for (std::size_t p = 0; p < all.problems.size(); ++p) {
      if (domain_of(context, all.problems[p]) != &all.domains[i]) continue;
      own.push_back(&all.problems[p]);
      old += p < problems ? 1 : 0;
    }
    if (!fresh && old == own.size()) continue;
    Review one(context, all.domains[i]);
    if (fresh) one.check_statics();
    if (fresh) one.check_methods();
    for (std::size_t p = fresh ? 0 : old; p < own.size(); ++p) one.check_tasks(own[p]->tasks);
    if (!own.empty() && (fresh || old == 0)) one.check_predicates(own);
  }
}

}  // namespace skein::htn
