// SPDX-License-Identifier: Apache-2.0
// Domains and problems as written, checked for shape: what the compiler of domains works from.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/htn/syntax.hpp"

namespace skein::htn {

/// An expression in its document (an included item lies in another document than its domain).
struct Expression {
  const Document* document = nullptr;
  NodeIndex node = kNoNode;
  explicit operator bool() const { return node != kNoNode; }
  const Node& operator*() const { return (*document)[node]; }
};

/// (:operator head pre delete add [cost]), its older form without pre, (:op head :precond …), or a
/// PDDL (:action name :parameters … :precondition … :effect … [:cost …]).
struct OperatorDefinition {
  Expression head;          ///< (!name args…); for an action its name
  Expression parameters;    ///< action only: the typed list
  Expression precondition;  ///< may be absent
  Expression deletions;     ///< list of atoms, one atom, or a variable; absent for an action
  Expression additions;     ///< as deletions
  Expression effect;        ///< action only
  Expression cost;          ///< absent: 1.0
  bool action = false;
};

/// One branch of a method: taken when its precondition has a satisfier and no earlier one has.
struct BranchDefinition {
  std::string label;  ///< given or made: "name-2"
  Expression precondition;
  Expression tasks;  ///< without its quote; absent when the text has none: nothing to do
};

/// (:method [name] head [label] pre tasks …) or (:pddl-method …).
struct MethodDefinition {
  std::string name;
  Expression head;
  std::vector<BranchDefinition> branches;
  bool pddl = false;
};

/// (:- head [label] body …), the bodies as if-then-else; no body: a fact. Or PDDL's (:derived
/// (predicate ?x - type …) condition).
struct AxiomDefinition {
  Expression head;
  std::vector<BranchDefinition> tails;  ///< `tasks` is not used
  bool derived = false;                 ///< the head's arguments are a typed list
};

/// (defun name (args) body…), for call, eval, assign and :sort-by; or a global variable,
/// (defvar name value) and its like, whose body gives its first value.
struct FunctionDefinition {
  bool variable = false;
  std::string name;
  Expression parameters;
  std::vector<Expression> body;
};

/// A type of PDDL (:types a b - c): every `name` is a `super`.
struct TypeDefinition {
  Term name;
  Term super;  ///< kNil when none is given
};

struct DomainDefinition {
  std::string name;
  bool pddl = false;  ///< a PDDL domain class was named, or actions or PDDL methods occur
  std::vector<OperatorDefinition> operators;
  std::vector<MethodDefinition> methods;
  std::vector<AxiomDefinition> axioms;  ///< in the order of the text
  std::vector<TypeDefinition> types;
  std::vector<Term> static_predicates;
  std::vector<Term> functions;  ///< of PDDL :functions: what has a number as its value
};

struct ProblemDefinition {
  std::string name;
  std::string domain;  ///< empty when not given
  Expression facts;    ///< a list of atoms
  Expression tasks;    ///< a task, a list of tasks, or (:unordered …), (:ordered …)
};

/// Whether an expression among the facts of a problem is one: a list that begins with a name. What
/// is stray there is left out, with a warning.
bool is_fact(Expression expression);

/// A definition in a language that is not read here: PDDL or HDDL.
struct ForeignDefinition {
  std::string language;  ///< "PDDL", "HDDL"
  Expression form;       ///< (define (domain …) …) or (define (problem …) …)
};

/// What one or several files define. Documents outlive the expressions in them.
struct Definitions {
  std::vector<std::unique_ptr<Document>> documents;
  std::vector<DomainDefinition> domains;
  std::vector<ProblemDefinition> problems;
  std::vector<FunctionDefinition> functions;
  std::vector<ForeignDefinition> foreign;
};

/// Gives the text of an included file, named as in the (:include name "file") item or, without a
/// file, "name.lisp"; `from` is the file that includes it.
using IncludeReader =
    std::function<Result<std::string, Failure>(const std::string& name, const std::string& from)>;

/// A text and the name that diagnostics give it.
struct SourceFile {
  std::string name;
  std::string text;
};

/// Reads one file and adds what it defines. defdomain, defproblem, make-problem and defun are found
/// at any depth; other Lisp forms are skipped. The errors of the file go into `errors` in the order
/// of the text, two hundred at most; what is merely suspicious (variables used once, tasks without
/// method, arity that never matches) into `warnings`. A problem is compared with its domain in the
/// call that reads the second of the two. On errors `definitions` holds what was sound: an item
/// with an error is left out. Definitions nested more than 1,000 deep are errors, so that what
/// works on them may recur. What each construct may look like: docs/planning-language.md.
void read_definitions(SourceFile file, TermStore& store, const IncludeReader& include,
                      Definitions& definitions, Diagnostics& errors, Diagnostics& warnings);
/// The same, but nobody wants to know what is merely suspicious: it is not looked for.
void read_definitions(SourceFile file, TermStore& store, const IncludeReader& include,
                      Definitions& definitions, Diagnostics& errors);

}  // namespace skein::htn
