// SPDX-License-Identifier: Apache-2.0
// The variables of a unit.
#pragma once

#include <optional>
#include <unordered_set>
#include <vector>

#include "lisp/source.hpp"
#include "lisp/writer.hpp"

namespace skein::htn::lisp {

/// The variables in scope; variables of the enclosing unit are captured on first use. Lifetime:
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
  /// The scope of a lambda inside `outer`.
  Scope(Scope& outer, Source& source, Writer& writer)
      : program_(outer.program_),
        source_(source),
        writer_(writer),
        outer_(&outer),
        assignments_(outer.assignments_) {}

  /// Records which variables the expression assigns. Precondition: before its parts are compiled.
  void note_assignments(NodeIndex root);

  std::optional<Variable> find(Term name);
  void declare(NodeIndex name, std::uint32_t local);
  /// Binds a new variable to the value on top of the stack.
  void bind(NodeIndex name);
  void assign(NodeIndex name);
  void read(const Variable& variable);

  std::size_t size() const { return variables_.size(); }
  /// Leaves only the first `size` variables in scope.
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
