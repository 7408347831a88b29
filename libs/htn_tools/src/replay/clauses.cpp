// SPDX-License-Identifier: Apache-2.0
#include "replay/clauses.hpp"

#include "replay/clause_reader.hpp"

namespace skein::htn::replay {

namespace {

/// Reads all clauses of a domain.
class DomainReader {
 public:
  DomainReader(TermStore& store, Lisp& lisp, Diagnostics& errors)
      : store_(store), lisp_(lisp), errors_(errors) {}

  Clauses read(const DomainDefinition& domain) {
    add_no_operation();
    if (domain.pddl) add_equality();
    for (const TypeDefinition& type : domain.types) add_type(type);
    for (const AxiomDefinition& axiom : domain.axioms) add_axiom(axiom);
    for (const OperatorDefinition& definition : domain.operators) {
      if (definition.action) {
        add_action(definition);
      } else {
        add_operator(definition);
      }
    }
    for (const MethodDefinition& method : domain.methods) add_method(method);
    return std::move(clauses_);
  }

 private:
  void add_no_operation() {
    OperatorClause clause;
    const Term name = store_.symbol(kNoOperation);
    clause.head = store_.list(std::vector<Term>{name});
    clauses_.operators.emplace(name.bits(), clause);
  }
  void add_equality() {
    const Term equal = store_.symbol("=");
    const Term slot{TermKind::kSlot, 0};
    AxiomClause clause{1, store_.list(std::vector<Term>{equal, slot, slot}), {Condition{}}};
    clauses_.axioms[equal.bits()].push_back(std::move(clause));
  }
  void add_type(const TypeDefinition& type) {
    const Term super = type.super == kNil ? store_.symbol("object") : type.super;
    const Term slot{TermKind::kSlot, 0};
    Goal goal;
    goal.kind = GoalKind::kAtom;
    goal.pattern = store_.list(std::vector<Term>{type.name, slot});
    Condition tail;
    tail.goals.push_back(goal);
    AxiomClause clause{1, store_.list(std::vector<Term>{super, slot}), {tail}};
    clauses_.axioms[super.bits()].push_back(std::move(clause));
  }
  void add_axiom(const AxiomDefinition& definition) {
    ClauseReader reader(store_, lisp_, errors_);
    AxiomClause clause;
    clause.head = reader.pattern(definition.head);
    for (const BranchDefinition& tail : definition.tails) {
      clause.tails.push_back(reader.condition(tail.precondition));
    }
    if (clause.tails.empty()) clause.tails.emplace_back();
    clause.slots = reader.slots();
    if (!clause.head.is(TermKind::kPair)) return;
    clauses_.axioms[store_.car(clause.head).bits()].push_back(std::move(clause));
  }
  void add_operator(const OperatorDefinition& definition) {
    ClauseReader reader(store_, lisp_, errors_);
    OperatorClause clause;
    clause.head = reader.pattern(definition.head);
    const std::uint32_t of_head = reader.slots();
    clause.precondition = reader.condition(definition.precondition);
    clause.effects = reader.effects(definition.deletions, EffectKind::kDelete);
    for (Effect& effect : reader.effects(definition.additions, EffectKind::kAdd)) {
      clause.effects.push_back(std::move(effect));
    }
    if (definition.cost) clause.cost = reader.code(definition.cost);
    clause.slots = reader.slots();
    clause.chooses = clause.slots > of_head;
    if (!clause.head.is(TermKind::kPair)) return;
    clauses_.operators.insert_or_assign(store_.car(clause.head).bits(), std::move(clause));
  }
  void add_action(const OperatorDefinition& definition) {
    ClauseReader reader(store_, lisp_, errors_);
    OperatorClause clause;
    clause.action = true;
    std::vector<Term> head{action_name((*definition.head).atom)};
    Goal types;
    types.where = definition.parameters;
    types.parts.push_back(reader.type_goals(definition.parameters, true, &head));
    Goal rest;
    rest.where = definition.precondition;
    rest.parts.push_back(reader.sequence(definition.precondition));
    clause.precondition.goals = {types, rest};
    clause.effects.push_back(reader.pddl_effect(definition.effect));
    if (definition.cost) clause.cost = reader.code(definition.cost);
    clause.head = store_.list(head);
    clause.slots = reader.slots();
    clauses_.operators.insert_or_assign(head[0].bits(), std::move(clause));
  }
  void add_method(const MethodDefinition& definition) {
    ClauseReader reader(store_, lisp_, errors_);
    MethodClause clause;
    clause.name = definition.name;
    clause.head = reader.pattern(definition.head);
    for (const BranchDefinition& branch : definition.branches) {
      clause.branches.push_back(
          {branch.label, reader.condition(branch.precondition), reader.network(branch.tasks)});
    }
    clause.slots = reader.slots();
    if (!clause.head.is(TermKind::kPair)) return;
    clauses_.methods[store_.car(clause.head).bits()].push_back(std::move(clause));
  }
  Term action_name(Term name) {
    const std::string text(store_.name(name));
    return text.starts_with('!') ? name : store_.symbol('!' + text);
  }

  TermStore& store_;
  Lisp& lisp_;
  Diagnostics& errors_;
  Clauses clauses_;
};

}  // namespace

const OperatorClause* Clauses::operator_named(Term name) const {
  const auto found = operators.find(name.bits());
  return found == operators.end() ? nullptr : &found->second;
}

const std::vector<MethodClause>& Clauses::methods_for(Term name) const {
  static const std::vector<MethodClause> none;
  const auto found = methods.find(name.bits());
  return found == methods.end() ? none : found->second;
}

const std::vector<AxiomClause>& Clauses::axioms_for(Term name) const {
  static const std::vector<AxiomClause> none;
  const auto found = axioms.find(name.bits());
  return found == axioms.end() ? none : found->second;
}

Clauses read_clauses(const DomainDefinition& domain, TermStore& store, Lisp& lisp,
                     Diagnostics& errors) {
  return DomainReader(store, lisp, errors).read(domain);
}

NetworkClause read_tasks(const ProblemDefinition& problem, TermStore& store, Lisp& lisp,
                         std::uint32_t& slots, Diagnostics& errors) {
  ClauseReader reader(store, lisp, errors);
  NetworkClause out = reader.network(problem.tasks);
  slots = reader.slots();
  return out;
}

Term term_of(Expression expression, TermStore& store) {
  if (!expression) return kNil;
  const Node& node = *expression;
  if (!node.list) return node.atom;
  std::vector<Term> items;
  for (const NodeIndex child : children(*expression.document, expression.node)) {
    items.push_back(term_of({expression.document, child}, store));
  }
  if (!node.dotted || items.empty()) return store.list(items);
  const Term tail = items.back();
  items.pop_back();
  return store.list(items, tail);
}

}  // namespace skein::htn::replay
