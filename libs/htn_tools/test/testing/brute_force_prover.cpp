// SPDX-License-Identifier: Apache-2.0
#include "testing/brute_force_prover.hpp"

#include <algorithm>

#include "replay/bindings.hpp"

namespace skein::htn::oracle {

using replay::AxiomClause;
using replay::Goal;
using replay::GoalKind;

namespace {

/// The first list, then what is new in the second.
template <class T>
std::vector<T> joined(std::vector<T> first, const std::vector<T>& second) {
  const std::size_t size = first.size();
  for (const T& one : second) {
    const auto end = first.begin() + static_cast<std::ptrdiff_t>(size);
    if (std::find(first.begin(), end, one) == end) first.push_back(one);
  }
  return first;
}

Term name_of(const TermStore& store, Term atom) {
  return atom.is(TermKind::kPair) ? store.car(atom) : atom;
}

}  // namespace

Term Substitution::value(Term term, std::uint32_t base) const {
  if (term.is(TermKind::kSlot)) term = {TermKind::kVariable, base + term.index()};
  while (term.is(TermKind::kVariable)) {
    const auto found = values_.find(term.index());
    if (found == values_.end() || found->second == term) break;
    term = found->second;
  }
  return term;
}

Term Substitution::instance(Term pattern, std::uint32_t base) const {
  pattern = value(pattern, base);
  if (!pattern.is(TermKind::kPair) || store_->ground(pattern)) return pattern;
  const Term car = instance(store_->car(pattern), base);
  return store_->pair(car, instance(store_->cdr(pattern), base));
}

bool Substitution::occurs(Term variable, Term term) const {
  term = value(term, 0);
  if (!term.is(TermKind::kPair)) return term == variable;
  return occurs(variable, store_->car(term)) || occurs(variable, store_->cdr(term));
}

bool Substitution::unify(Term left, Term right) {
  left = value(left, 0);
  right = value(right, 0);
  if (left == right) return true;
  if (left.is(TermKind::kVariable)) {
    if (occurs(left, right)) return false;
    set(left, right);
    return true;
  }
  if (right.is(TermKind::kVariable)) return unify(right, left);
  if (!left.is(TermKind::kPair) || !right.is(TermKind::kPair)) return false;
  return unify(store_->car(left), store_->car(right)) &&
         unify(store_->cdr(left), store_->cdr(right));
}

const std::vector<Term>& Facts::of(Term predicate) const {
  static const std::vector<Term> none;
  const auto found = facts_.find(predicate.bits());
  return found == facts_.end() ? none : found->second;
}

std::vector<Term>& Facts::list_of(Term fact) { return facts_[name_of(store_, fact).bits()]; }

bool Facts::holds(Term fact) const {
  const std::vector<Term>& list = of(name_of(store_, fact));
  return std::find(list.begin(), list.end(), fact) != list.end();
}

void Facts::add(Term fact, std::vector<Change>& changes) {
  if (holds(fact)) return;
  list_of(fact).insert(list_of(fact).begin(), fact);
  changes.push_back({true, fact});
}

void Facts::remove(Term fact, std::vector<Change>& changes) {
  if (!holds(fact)) return;
  std::erase(list_of(fact), fact);
  changes.push_back({false, fact});
}

void Facts::undo(const std::vector<Change>& changes) {
  for (auto change = changes.rbegin(); change != changes.rend(); ++change) {
    if (change->added) {
      std::erase(list_of(change->fact), change->fact);
    } else {
      list_of(change->fact).insert(list_of(change->fact).begin(), change->fact);
    }
  }
}

Term Prover::evaluate(CodeIndex code, std::uint32_t base, const Substitution& known) {
  if (code == kNoCode) throw Stop(Stop::Kind::kError, "no code");
  const auto value = lisp_.evaluate(code, [&](std::uint32_t slot) {
    return known.instance({TermKind::kSlot, slot}, base);
  });
  if (!value) throw Stop(Stop::Kind::kError, value.error().why);
  return *value;
}

std::vector<Prover::Item> Prover::items_of(const Goals& goals, std::uint32_t base) const {
  std::vector<Item> out;
  for (const Goal& goal : goals) out.push_back({&goal, base, {}, nullptr});
  return out;
}

// A list of conditions as one condition: itself if it is one, else their conjunction.
const Prover::Goals& Prover::as_element(const Goals& goals) {
  if (goals.size() == 1) return goals;
  Goals& made = made_[&goals];
  if (made.empty()) {
    made.emplace_back();
    made[0].parts.push_back(goals);
  }
  return made;
}

// (imply a b) as ((or (not a) b)).
const Prover::Goals& Prover::as_disjunction(const Goal& imply) {
  Goals& made = made_[&imply];
  if (made.empty()) {
    Goal negation;
    negation.kind = GoalKind::kNot;
    negation.parts.push_back(imply.parts.at(0));
    made.emplace_back();
    made[0].kind = GoalKind::kOr;
    made[0].parts = {{negation}, imply.parts.at(1)};
  }
  return made;
}

void Prover::variables_in(const Goals& goals, std::uint32_t base, const Substitution& known,
                          std::vector<Term>& out) const {
  for (const Goal& goal : goals) {
    if (goal.kind == GoalKind::kForall) continue;
    for (const Term pattern : {goal.pattern, goal.result}) {
      replay::replace_variables(store_, known.instance(pattern, base), [&](Term variable) {
        if (std::find(out.begin(), out.end(), variable) == out.end()) out.push_back(variable);
        return variable;
      });
    }
    for (const Goals& part : goal.parts) variables_in(part, base, known, out);
  }
}

std::vector<Substitution> Prover::find(const Goals& goals, std::uint32_t base,
                                       const Substitution& known, bool just_one) {
  Query query{known, {}, just_one};
  variables_in(goals, base, known, query.variables);
  std::vector<Substitution> out;
  for (const Answer& answer : seek(items_of(goals, base), query)) {
    out.push_back(known);
    for (std::size_t at = 0; at < answer.size(); ++at) {
      if (answer[at] != query.variables[at]) out.back().set(query.variables[at], answer[at]);
    }
  }
  return out;
}

std::vector<Substitution> Prover::find(const replay::Condition& condition, std::uint32_t base,
                                       const Substitution& known, bool just_one) {
  std::vector<Substitution> out = find(condition.goals, base, known, just_one || condition.first);
  if (!condition.sorted) return out;
  std::vector<std::pair<Term, Substitution>> keyed;
  for (Substitution& one : out) {
    const Term key = evaluate(condition.key, base, one);
    keyed.emplace_back(key, std::move(one));
  }
  std::stable_sort(keyed.begin(), keyed.end(), [&](const auto& left, const auto& right) {
    if (condition.order == kNoCode) {
      return less_value(store_.value(left.first), store_.value(right.first));
    }
    const std::vector<Term> arguments{left.first, right.first};
    const auto result = lisp_.apply(condition.order, arguments, [](std::uint32_t) { return kNil; });
    if (!result) throw Stop(Stop::Kind::kError, result.error().why);
    return *result != kNil;
  });
  out.clear();
  for (auto& [key, one] : keyed) out.push_back(std::move(one));
  return out;
}

bool Prover::holds(Term goal, const Substitution& known) {
  return !seek({{nullptr, 0, goal, nullptr}}, {known, {}, true}).empty();
}

std::vector<Prover::Answer> Prover::seek(std::vector<Item> items, const Query& query) {
  if (items.empty()) {
    Answer answer;
    for (const Term variable : query.variables) answer.push_back(query.known.resolve(variable));
    return {answer};
  }
  ++inferences_;
  if (left_-- == 0) throw Stop(Stop::Kind::kBudget, "inferences");
  const Item first = items.front();
  items.erase(items.begin());
  if (first.committed) {
    *first.committed = true;
    return seek(std::move(items), query);
  }
  if (first.term) return seek_atom(query.known.resolve(*first.term), items, query);
  return seek_goal(first, items, query);
}

std::vector<Prover::Answer> Prover::seek_goal(const Item& item, const std::vector<Item>& rest,
                                              const Query& query) {
  const Goal& goal = *item.goal;
  switch (goal.kind) {
    case GoalKind::kAtom:
    case GoalKind::kVariable:
      return seek_atom(query.known.instance(goal.pattern, item.base), rest, query);
    case GoalKind::kNot: {
      const std::vector<Item> inner = items_of(as_element(goal.parts.at(0)), item.base);
      if (!seek(inner, {query.known, {}, true}).empty()) return {};
      return seek(rest, query);
    }
    case GoalKind::kEval:
      if (evaluate(goal.code, item.base, query.known) == kNil) return {};
      return seek(rest, query);
    case GoalKind::kForall:
    case GoalKind::kExists:
      return quantified(item, query) ? seek(rest, query) : std::vector<Answer>{};
    case GoalKind::kAssign:
    case GoalKind::kAssignEach:
      return seek_assigned(item, rest, query);
    default:
      return seek_each(alternatives(item, query), rest, query);
  }
}

std::vector<Substitution> Prover::alternatives(const Item& item, const Query& query) {
  const Goal& goal = *item.goal;
  switch (goal.kind) {
    case GoalKind::kOr: {
      std::vector<Substitution> out;
      for (const Goals& part : goal.parts) {
        for (Substitution& one : find(part, item.base, query.known, false)) {
          out.push_back(std::move(one));
        }
      }
      return out;
    }
    case GoalKind::kImply:
      return find(as_disjunction(goal), item.base, query.known, false);
    case GoalKind::kSetof:
    case GoalKind::kBagof:
      return collected(item, query);
    case GoalKind::kEnforce: {
      auto out = find(as_element(goal.parts.at(0)), item.base, query.known, query.just_one);
      if (out.empty()) throw Stop(Stop::Kind::kError, "enforced in vain");
      return out;
    }
    default:
      return find(goal.parts.at(0), item.base, query.known, false);
  }
}

// The answers of later ways come before those of earlier ones.
std::vector<Prover::Answer> Prover::seek_each(const std::vector<Substitution>& ways,
                                              const std::vector<Item>& rest, const Query& query) {
  std::vector<Answer> out;
  for (const Substitution& way : ways) {
    std::vector<Answer> found = seek(rest, {way, query.variables, query.just_one});
    if (query.just_one && !found.empty()) return found;
    out = joined(std::move(found), out);
  }
  return out;
}

std::vector<Prover::Answer> Prover::seek_atom(Term atom, const std::vector<Item>& rest,
                                              const Query& query) {
  std::vector<Substitution> ways;
  for (const Term fact : facts_.of(name_of(store_, atom))) {
    Substitution way = query.known;
    if (way.unify(atom, fact)) ways.push_back(std::move(way));
  }
  std::vector<Answer> from_facts = seek_each(ways, rest, query);
  if (query.just_one && !from_facts.empty()) return from_facts;
  std::vector<Answer> from_axioms;
  for (const AxiomClause& axiom : clauses_.axioms_for(name_of(store_, atom))) {
    std::vector<Answer> found = seek_axiom(axiom, atom, rest, query);
    if (query.just_one && !found.empty()) return found;
    from_axioms = joined(std::move(found), from_axioms);
  }
  return joined(std::move(from_facts), from_axioms);
}

std::vector<Prover::Answer> Prover::seek_axiom(const AxiomClause& axiom, Term atom,
                                               const std::vector<Item>& rest, const Query& query) {
  const std::uint32_t base = fresh(axiom.slots);
  Substitution known = query.known;
  if (!known.unify(atom, known.instance(axiom.head, base))) return {};
  for (const replay::Condition& tail : axiom.tails) {
    std::vector<Item> items = items_of(as_element(tail.goals), base);
    const auto committed = std::make_shared<bool>(false);
    items.push_back({nullptr, 0, {}, committed});
    items.insert(items.end(), rest.begin(), rest.end());
    std::vector<Answer> found = seek(items, {known, query.variables, query.just_one || tail.first});
    if (!found.empty()) return found;
    if (*committed) break;
  }
  return {};
}

std::vector<Prover::Answer> Prover::seek_assigned(const Item& item, const std::vector<Item>& rest,
                                                  const Query& query) {
  const Term value = evaluate(item.goal->code, item.base, query.known);
  const Term target = query.known.instance(item.goal->pattern, item.base);
  std::vector<Substitution> ways;
  const bool each = item.goal->kind == GoalKind::kAssignEach;
  for (const Term one : each ? store_.items(value) : std::vector<Term>{value}) {
    if (!target.is(TermKind::kVariable) && store_.loose(target) != store_.loose(one)) continue;
    ways.push_back(query.known);
    if (target.is(TermKind::kVariable)) ways.back().set(target, one);
  }
  return seek_each(ways, rest, query);
}

bool Prover::quantified(const Item& item, const Query& query) {
  const Goal& goal = *item.goal;
  const bool exists = goal.kind == GoalKind::kExists;
  for (const Substitution& bound : find(goal.parts.at(0), item.base, query.known, false)) {
    const bool found =
        !seek(items_of(goal.parts.at(1), item.base), {bound, query.variables, true}).empty();
    if (found == exists) return exists;
  }
  return !exists;
}

std::vector<Substitution> Prover::collected(const Item& item, const Query& query) {
  const Goal& goal = *item.goal;
  std::vector<Term> values;
  for (const Substitution& one :
       find(as_element(goal.parts.at(0)), item.base, query.known, false)) {
    const Term value = one.instance(goal.pattern, item.base);
    const bool known = std::find(values.begin(), values.end(), value) != values.end();
    if (!known || goal.kind == GoalKind::kBagof) values.push_back(value);
  }
  Substitution out = query.known;
  const Term target = out.instance(goal.result, item.base);
  if (values.empty()) return {};
  if (target.is(TermKind::kVariable)) out.set(target, store_.list(values));
  return {out};
}

std::string plain_text(TermStore& store, Term term) {
  const Term unknown = store.symbol("?");
  return store.to_text(replay::replace_variables(store, term, [&](Term) { return unknown; }));
}

}  // namespace skein::htn::oracle
