// SPDX-License-Identifier: Apache-2.0
// A domain as the search works on it: clauses with numbered variables, goals with their indexes,
// task networks with their ways of being forced. Everything is an index into a vector.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "compile/indexed_position.hpp"
#include "skein/htn/domain.hpp"
#include "skein/htn/lisp.hpp"

namespace skein::htn {

using GoalIndex = std::uint32_t;
using ConditionIndex = std::uint32_t;
inline constexpr std::uint32_t kAbsent = 0xFFFFFFFFU;

enum class GoalKind : std::uint8_t {
  kAtom,
  kAnd,         ///< conditions[0]: all its satisfiers, then one after the other
  kOr,          ///< conditions: the alternatives
  kNot,         ///< conditions[0]
  kImply,       ///< conditions[0]: (or (not a) b)
  kForall,      ///< conditions: bounds, then what must hold
  kExists,      ///< conditions: bounds, then what must hold for one
  kEval,        ///< code is not nil
  kAssign,      ///< pattern: the variable; code: its value
  kAssignEach,  ///< assign*: the value is a list of alternatives
  kSetOf,       ///< pattern: the variable for the list; term: what to collect; conditions[0]
  kBagOf,
  kEnforce,  ///< conditions[0]; an error if it does not hold
  kVariable  ///< pattern: a variable that is bound to an expression when the goal comes up
};

struct Axiom;

struct Goal {
  GoalKind kind = GoalKind::kAtom;
  Term pattern;
  Term term;
  Term predicate;               ///< kAtom
  std::vector<Term> arguments;  ///< kAtom
  bool flat = false;            ///< kAtom: the name and a proper list of not too many arguments
  std::vector<IndexedPosition> positions;      ///< kAtom: where a value may be known
  const std::vector<Axiom>* axioms = nullptr;  ///< kAtom: of its predicate, if any
  bool facts_only = false;                     ///< kAtom: not by axioms
  bool logical = false;                        ///< as Condition::logical; kAtom: its axioms too
  bool finite = false;                         ///< as Condition::finite
  std::vector<ConditionIndex> conditions;
  CodeIndex code = kNoCode;
  std::string text;  ///< kEnforce: the message
  Expression where;
};

/// Most arguments of an atom that is Goal::flat.
inline constexpr std::size_t kMostFlatArguments = 12;

/// Whether an atom is a name with a proper list of not too many arguments; these are appended.
inline bool flat_arguments(const TermStore& store, Term atom, std::vector<Term>& arguments) {
  if (!atom.is(TermKind::kPair) || !store.car(atom).is(TermKind::kSymbol)) return false;
  std::size_t count = 0;
  for (Term at = store.cdr(atom); at.is(TermKind::kPair); at = store.cdr(at)) ++count;
  arguments.reserve(arguments.size() + count);
  Term rest = store.cdr(atom);
  for (; rest.is(TermKind::kPair); rest = store.cdr(rest)) arguments.push_back(store.car(rest));
  return rest == kNil && arguments.size() <= kMostFlatArguments;
}

/// A conjunction with how its satisfiers are wanted.
struct Condition {
  std::vector<GoalIndex> goals;
  std::vector<std::uint32_t> slots;  ///< variables a satisfier gives values to
  std::vector<Term> variables;       ///< the same for a condition met as a value
  bool first = false;                ///< :first
  bool sorted = false;               ///< :sort-by
  /// Nothing but facts, axioms, connectives and quantifiers: how many proofs are found does not
  /// matter where only one is wanted.
  bool logical = false;
  /// Logical, and no axiom leads back to itself: a proof ends in whatever order goals are tried.
  bool finite = false;
  CodeIndex sort_key = kNoCode;
  CodeIndex compare = kNoCode;  ///< kNoCode: <
  Expression where;
};

/// What clauses have in common: numbered variables.
struct Clause {
  Term head;                ///< pattern (name argument…)
  std::vector<Term> items;  ///< the arguments, if the head is flat as Goal::flat
  std::uint32_t slots = 0;
  std::vector<Term> names;  ///< symbol of each slot
};

enum class EffectKind : std::uint8_t {
  kAtom,
  kProtection,
  kList,
  kForall,
  kWhen,
  kNegated,
  kGroup
};

/// A part of what an operator adds or deletes.
struct Effect {
  EffectKind kind = EffectKind::kAtom;
  Term pattern;                        ///< kAtom, kProtection: an atom; kList: a variable
  bool flat = false;                   ///< kAtom, kProtection: as Goal::flat
  std::vector<Term> arguments;         ///< of a flat one
  ConditionIndex condition = kAbsent;  ///< kForall, kWhen
  std::vector<Effect> parts;           ///< kForall, kWhen, kNegated, kGroup
};

struct Operator : Clause {
  ConditionIndex precondition = kAbsent;
  std::vector<Effect> deletions;
  std::vector<Effect> additions;
  Effect effect;  ///< of an action
  bool action = false;
  CodeIndex cost = kNoCode;  ///< kNoCode: fixed_cost
  Number fixed_cost = single(1.0);
  Expression where;
};

/// A node of a method's task network, in the order of the text, parents first.
struct BodyNode {
  NetworkKind kind = NetworkKind::kTask;
  std::uint32_t parent = kAbsent;
  bool immediate = false;
  Term task;                 ///< pattern, when no call stands in it
  CodeIndex code = kNoCode;  ///< template, when one does
  std::uint8_t skipped = 0;  ///< words before the name in what the template makes
};

/// Which leaves of a network are immediate in one way of forcing it (by position in the body).
using Forcing = std::vector<std::uint32_t>;

struct Branch {
  std::string label;
  ConditionIndex precondition = kAbsent;
  std::vector<BodyNode> body;
  std::vector<std::uint32_t> leaves;  ///< the tasks among the body
  std::vector<Forcing> forcings;      ///< at least one
  Expression where;
};

struct Method : Clause {
  std::vector<Branch> branches;
};

struct AxiomTail {
  std::string label;
  std::vector<GoalIndex> goals;
  bool first = false;
};

struct Axiom : Clause {
  std::vector<AxiomTail> tails;
};

struct CompiledDomain {
  CompiledDomain(TermStore& terms, const Functions& host,
                 const std::vector<FunctionDefinition>& functions)
      : store(terms), defined(functions), lisp(terms, host, defined) {}

  std::string name;
  TermStore& store;
  std::vector<FunctionDefinition> defined;
  Lisp lisp;
  std::deque<Goal> goals;  // grows during a search, by goals met as values
  std::deque<Condition> conditions;
  std::vector<Term> fluents;        // functions with numbers as values: facts (= (name …) value)
  std::deque<Document> made_texts;  // of terms that stand for others: see fluents.cpp
  std::unordered_map<Term, Operator> operators;
  std::unordered_map<Term, std::vector<Method>> methods;
  std::unordered_map<Term, std::vector<Axiom>> axioms;
  std::unordered_map<Term, GoalIndex> goals_of_terms;  // of expressions met as values
  std::unordered_map<Term, ConditionIndex> conditions_of_atoms;
};

/// Axioms of the goal's predicate; for goals made after the domain was compiled too.
inline void link_axioms(CompiledDomain& domain, Goal& goal) {
  const auto axioms = domain.axioms.find(goal.predicate);
  if (goal.kind == GoalKind::kAtom && !goal.facts_only && axioms != domain.axioms.end())
    goal.axioms = &axioms->second;
}

/// Sets `logical` and `finite` of all goals and conditions, once axioms are linked.
void mark_logical(CompiledDomain& domain);

/// Primitive tasks: names that begin with `!`; internal ones with `!!`.
inline bool primitive(const TermStore& store, Term name) {
  return name.is(TermKind::kSymbol) && store.name(name).starts_with('!');
}
inline bool internal(const TermStore& store, Term name) {
  return name.is(TermKind::kSymbol) && store.name(name).starts_with("!!");
}

}  // namespace skein::htn
