// SPDX-License-Identifier: Apache-2.0
// From expressions to the instructions of one unit.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lisp/program.hpp"
#include "lisp/scope.hpp"
#include "lisp/source.hpp"
#include "lisp/writer.hpp"

namespace skein::htn::lisp {

using Parts = std::span<const NodeIndex>;  ///< head and arguments of a form

/// Compiles one unit; a lambda inside is a unit of its own with this one around it. Every method
/// that compiles a value emits code that pushes exactly one, errors or not.
class Compiler {
 public:
  Compiler(Program& program, const Document& document, const SlotOf& slot_of, Diagnostics& errors);
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;

  // ---- whole units ----

  void expression(NodeIndex node);
  /// The children of `call` from the second on are function and arguments.
  void call(NodeIndex call);
  void task_template(NodeIndex node);
  void function(NodeIndex node);
  void definition(const FunctionDefinition& definition);
  Unit finish(std::string name) { return writer_.finish(std::move(name)); }

  // ---- parts of them, for forms and patterns ----

  Program& program() { return program_; }
  Source& source() { return source_; }
  Writer& writer() { return writer_; }
  Scope& scope() { return scope_; }

  void value(NodeIndex at);
  /// The values one after the other; the last one stays.
  void body(Parts parts);
  void form(NodeIndex at, Parts parts);
  void quoted(NodeIndex at) { writer_.emit_constant(source_.datum(at)); }
  void function_value(NodeIndex at);
  void lambda(NodeIndex at, Parts parts);

  /// One level deeper. False: that is too deep. Each call is ended by shallower().
  bool deeper() { return ++nesting_ <= kNestingLimit; }
  void shallower() { --nesting_; }

 private:
  Compiler(Compiler& outer, NodeIndex place);

  void atom(NodeIndex at);
  void list(NodeIndex at);
  void named_call(NodeIndex at, Parts parts);
  void unknown_function(NodeIndex at, std::string_view name);
  void check_arguments(NodeIndex at, const Callable& callable, std::size_t given);

  static constexpr int kNestingLimit = 400;

  Program& program_;
  Source source_;
  Writer writer_;
  Scope scope_;
  int nesting_ = 0;
};

}  // namespace skein::htn::lisp
