// SPDX-License-Identifier: Apache-2.0
// A domain ready for planning: compiled once, used by any number of searches.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/definitions.hpp"
#include "skein/htn/functions.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn {

struct CompiledDomain;  // private: src/compiled_domain.hpp

/// Compiled operators, methods, axioms and Lisp terms of one domain. Thread rule: one search at a
/// time, for evaluation shares scratch memory and terms.
class Domain {
 public:
  /// Unknown functions and what else the reader cannot know go to `errors`; null then. The
  /// definitions and the store must outlive the domain.
  static std::shared_ptr<Domain> compile(const DomainDefinition& definition,
                                         const std::vector<FunctionDefinition>& functions,
                                         const Functions& host, TermStore& store,
                                         Diagnostics& errors);
  ~Domain();
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  const std::string& name() const;
  TermStore& store() const;
  CompiledDomain& compiled() const { return *compiled_; }

 private:
  Domain();
  std::unique_ptr<CompiledDomain> compiled_;
};

enum class NetworkKind : std::uint8_t { kOrdered, kUnordered, kTask };

/// Tasks to accomplish: a tree of orderings with tasks as leaves.
struct TaskNetwork {
  NetworkKind kind = NetworkKind::kOrdered;
  std::vector<TaskNetwork> children;
  Term task;               ///< for kTask: (name argument…); variables are kLocal terms
  bool immediate = false;  ///< for kTask
  bool operator==(const TaskNetwork&) const = default;
};

/// Something that has happened already: an executed step, or a change that no step made.
struct Event {
  enum class Kind : std::uint8_t { kStep, kAdded, kDeleted };
  Kind kind = Kind::kStep;
  Term term;  ///< the action, or the ground fact
  bool operator==(const Event&) const = default;
};

/// An initial state and the tasks to accomplish from it.
struct Problem {
  std::string name;
  std::vector<Term> facts;  ///< ground atoms in the order of the text
  TaskNetwork tasks;
  /// What has happened since `facts` held, in order. Plans begin with these steps, which are no
  /// part of `tasks`; what they protect stays protected, unless an outside change made it false.
  std::vector<Event> past;
};

/// The problem as written; errors (not ground, malformed) are the reader's and found there.
Problem make_problem(const ProblemDefinition& definition, TermStore& store);

}  // namespace skein::htn
