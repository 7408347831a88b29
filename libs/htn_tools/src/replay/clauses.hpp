// SPDX-License-Identifier: Apache-2.0
// A domain as the validator keeps it: a plain tree for every clause, close to the text.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/definitions.hpp"
#include "skein/htn/lisp.hpp"
#include "skein/htn/plan.hpp"

namespace skein::htn::replay {

enum class GoalKind : std::uint8_t {
  kAtom,        ///< pattern
  kVariable,    ///< pattern is a variable that will be bound to a goal
  kAnd,         ///< parts[0]
  kOr,          ///< one of parts
  kNot,         ///< no proof of parts[0]
  kImply,       ///< no proof of parts[0], or parts[1]
  kForall,      ///< parts[1] for every proof of parts[0]
  kExists,      ///< parts[1] for some proof of parts[0]
  kAssign,      ///< pattern is the value of code
  kAssignEach,  ///< pattern is one of the items of the value of code
  kEval,        ///< code is not nil
  kSetof,       ///< result is the list of pattern for all proofs of parts[0], none twice
  kBagof,       ///< the same with repetitions
  kEnforce      ///< parts[0], an error otherwise
};

struct Goal {
  GoalKind kind = GoalKind::kAnd;
  Term pattern;
  Term result;
  std::vector<std::vector<Goal>> parts;
  CodeIndex code = kNoCode;
  Expression where;
};

/// A conjunction; the options apply to preconditions of methods and tails of axioms.
struct Condition {
  std::vector<Goal> goals;
  bool first = false;  ///< (:first …): one proof is enough
  bool sorted = false;
  CodeIndex key = kNoCode;    ///< :sort-by: what the proofs are compared by
  CodeIndex order = kNoCode;  ///< the function that compares; absent: <
};

enum class EffectKind : std::uint8_t {
  kAdd,       ///< pattern; (:protection atom) included
  kDelete,    ///< pattern
  kAddItems,  ///< every item of the list that pattern is bound to
  kDeleteItems,
  kForall,  ///< parts for every proof of condition
  kWhen     ///< parts if condition has a proof
};

struct Effect {
  EffectKind kind = EffectKind::kAdd;
  Term pattern;
  std::vector<Goal> condition;
  std::vector<Effect> parts;
};

/// An operator or a PDDL action (its name then starts with ! even where the text leaves it out).
struct OperatorClause {
  std::uint32_t slots = 0;
  Term head;
  Condition precondition;
  std::vector<Effect> effects;  ///< deletions before additions, but for an action
  CodeIndex cost = kNoCode;     ///< absent: 1.0
  bool action = false;
  bool chooses = false;  ///< the precondition binds variables that the head does not
};

struct AxiomClause {
  std::uint32_t slots = 0;
  Term head;
  std::vector<Condition> tails;
};

/// A task network with variables. A task without arguments to evaluate is all in `pattern`;
/// otherwise `items` gives the value of each element.
struct NetworkClause {
  struct Item {
    Term pattern;
    CodeIndex code = kNoCode;
  };
  TreeNodeKind kind = TreeNodeKind::kOrdered;
  std::vector<NetworkClause> children;
  bool immediate = false;
  Term pattern;
  std::vector<Item> items;
};

struct BranchClause {
  std::string label;
  Condition precondition;
  NetworkClause tasks;
};

struct MethodClause {
  std::uint32_t slots = 0;
  std::string name;
  Term head;
  std::vector<BranchClause> branches;
};

/// All clauses by the symbol they are looked up with, in the order of the text.
struct Clauses {
  std::map<std::uint32_t, OperatorClause> operators;
  std::map<std::uint32_t, std::vector<MethodClause>> methods;
  std::map<std::uint32_t, std::vector<AxiomClause>> axioms;
  bool typed = false;

  const OperatorClause* operator_named(Term name) const;
  const std::vector<MethodClause>& methods_for(Term name) const;
  const std::vector<AxiomClause>& axioms_for(Term name) const;
};

/// Errors are those of the Lisp terms and of nesting beyond reason; clauses with errors are left
/// out.
Clauses read_clauses(const DomainDefinition& domain, TermStore& store, Lisp& lisp,
                     Diagnostics& errors);

/// The tasks of a problem; `slots` receives how many variables they have.
NetworkClause read_tasks(const ProblemDefinition& problem, TermStore& store, Lisp& lisp,
                         std::uint32_t& slots, Diagnostics& errors);

/// The term an expression without variables stands for (variables stay symbols).
Term term_of(Expression expression, TermStore& store);

/// The task of an empty network.
inline constexpr const char* kNoOperation = "!!inop";

}  // namespace skein::htn::replay
