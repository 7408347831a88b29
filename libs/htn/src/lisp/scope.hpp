// SPDX-License-Identifier: Apache-2.0
// The variables of a unit.
#pragma once

#include <optional>
#include <unordered_set>
#include <vector>

#include "lisp/source.hpp"
#include "lisp/writer.hpp"

namespace skein::htn::lisp {

/// Those in scope, and those of the unit around, which are captured when they are named. Lifetime:
/// refers to its arguments.
class Scope {
 public:
  struct Variable {
    Term name;
    std::uint32_t local = 0;
    bool boxed = false;  ///< assigned somewhere while lambdas may share it
  };

  Scope(Program& program, Source& source, Writer& writer)
      : program_(program), source_(source), writer_(writer) {}
  /// Of a lambda inside.
  Scope(Scope& outer, Source& source, Writer& writer)
      : program_(outer.program_),
        source_(source),
        writer_(writer),
        outer_(&outer),
        assignments_(outer.assignments_) {}

  /// What is known of the whole expression before its parts are compiled.
  void note_assignments(NodeIndex root);

  std::optional<Variable> find(Term name);
  void declare(NodeIndex name, std::uint32_t local);
  /// The value on the stack is that of a new variable.
  void bind(NodeIndex name);
  void assign(NodeIndex name);
  void read(const Variable& variable);

  std::size_t size() const { return variables_.size(); }
  /// Only the first so many are left in scope.
  void leave(std::size_t size) { variables_.resize(size); }

 private:
  struct Assignments {
    bool lambda = false;
    std::unordered_set<Term> names;
  };
  void note_steps(NodeIndex bindings);

  Program& program_;
  Source& source_;
  Writer& writer_;
  Scope* outer_ = nullptr;
  Assignments assignments_;
  std::vector<Variable> variables_;  ///< those in scope, the innermost last
  std::vector<Variable> captured_;
};

}  // namespace skein::htn::lisp
