// SPDX-License-Identifier: Apache-2.0
// From expressions to the instructions of one unit.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "lisp_program.hpp"

namespace skein::htn::lisp {

/// Compiles one unit; a lambda inside is a unit of its own with this one around it. Every method
/// that compiles a value emits code that pushes exactly one, errors or not.
class Compiler {
 public:
  Compiler(Program& program, const Document& document, const SlotOf& slot_of, Diagnostics& errors);

  void expression(NodeIndex node);
  /// The children of `call` from the second on are function and arguments.
  void call(NodeIndex call);
  void task_template(NodeIndex node);
  void function(NodeIndex node);
  void definition(const FunctionDefinition& definition);
  Unit finish(std::string name);

 private:
  using Parts = std::span<const NodeIndex>;  ///< head and arguments of a form
  struct Form {
    void (Compiler::*compile)(NodeIndex form, Parts parts);
    std::size_t least;
    std::size_t most;
  };
  struct Variable {
    Term name;
    std::uint32_t local = 0;
    bool boxed = false;  ///< assigned somewhere while lambdas may share it
  };
  struct Block {
    Term name;
    std::uint32_t height = 0;
    std::vector<std::size_t> exits;
  };
  /// What is known of the whole expression before its parts are compiled.
  struct Assignments {
    bool lambda = false;
    std::unordered_set<Term> names;
  };

  Compiler(Compiler& outer, const Document& document);

  // Emitting.
  std::size_t emit(Op op, std::uint32_t operand = 0, std::uint32_t count = 0);
  void emit_constant(Term term);
  void emit_function(std::string_view builtin, std::uint32_t count);
  void patch(std::size_t jump);
  void raise(std::uint32_t by);
  std::uint32_t here() const { return static_cast<std::uint32_t>(unit_.code.size()); }

  // Reading.
  const Node& node(NodeIndex index) const { return document_[index]; }
  std::string_view symbol(NodeIndex index) const;
  bool is_symbol(NodeIndex index) const;
  bool is_form(NodeIndex index, std::string_view head) const;
  bool contains_call(NodeIndex index) const;
  Term datum(NodeIndex index);
  Term datum_atom(NodeIndex index);
  void note_assignments(NodeIndex root);
  void note_steps(NodeIndex bindings);
  void error(NodeIndex at, std::string message, std::string expected = {},
             std::string nearest = {});

  // Values.
  void value(NodeIndex at);
  void atom(NodeIndex at);
  void list(NodeIndex at);
  void form(NodeIndex at, Parts parts);
  void named_call(NodeIndex at, Parts parts);
  void unknown_function(NodeIndex at, std::string_view name);
  void check_count(NodeIndex at, std::string_view name, std::size_t given, std::size_t least,
                   std::size_t most);
  void check_arguments(NodeIndex at, const Callable& callable, std::size_t given);
  void quoted(NodeIndex at);
  void body(Parts parts);
  void function_value(NodeIndex at);
  void lambda(NodeIndex at, Parts parts);
  static const Form* find_form(std::string_view name);
  static std::vector<std::string> form_names();

  // Variables.
  std::optional<Variable> find(Term name);
  std::uint32_t new_local() { return unit_.locals++; }
  void declare(NodeIndex name, std::uint32_t local);
  void bind(NodeIndex name);
  void assign(NodeIndex name);
  void read(const Variable& variable);
  bool is_marker(NodeIndex at) const;
  void parameters(NodeIndex list);
  void optional_parameter(NodeIndex at, std::uint32_t index);
  void bind_pattern(NodeIndex at);
  void pattern_list(NodeIndex at, std::uint32_t source);
  void pattern_optional(NodeIndex at, std::uint32_t source);
  void next_item(std::uint32_t source);
  void copy_local(std::uint32_t from, NodeIndex to);

  // Forms.
  void short_circuit(Parts parts, Op jump, Term empty);
  void and_form(NodeIndex form, Parts parts);
  void backquote_form(NodeIndex form, Parts parts);
  void block_form(NodeIndex form, Parts parts);
  void call_form(NodeIndex form, Parts parts);
  void case_form(NodeIndex form, Parts parts);
  void case_keys(NodeIndex keys, std::uint32_t local);
  void cond_form(NodeIndex form, Parts parts);
  void declare_form(NodeIndex form, Parts parts);
  void destructuring_form(NodeIndex form, Parts parts);
  void do_form(NodeIndex form, Parts parts);
  void dolist_form(NodeIndex form, Parts parts);
  void dotimes_form(NodeIndex form, Parts parts);
  void eval_form(NodeIndex form, Parts parts);
  void funcall_form(NodeIndex form, Parts parts);
  void function_form(NodeIndex form, Parts parts);
  void if_form(NodeIndex form, Parts parts);
  void increment_form(NodeIndex form, Parts parts);
  void lambda_form(NodeIndex form, Parts parts);
  void let_form(NodeIndex form, Parts parts);
  void let_star_form(NodeIndex form, Parts parts);
  void or_form(NodeIndex form, Parts parts);
  void pop_form(NodeIndex form, Parts parts);
  void prog1_form(NodeIndex form, Parts parts);
  void progn_form(NodeIndex form, Parts parts);
  void push_form(NodeIndex form, Parts parts);
  void quote_form(NodeIndex form, Parts parts);
  void return_form(NodeIndex form, Parts parts);
  void return_from_form(NodeIndex form, Parts parts);
  void set_form(NodeIndex form, Parts parts);
  void the_form(NodeIndex form, Parts parts);
  void when_form(NodeIndex form, Parts parts);

  // Parts of forms.
  void backquoted(NodeIndex at);
  void backquoted_list(NodeIndex at);
  void begin_block(Term name);
  void end_block();
  void leave_block(NodeIndex at, Term name);
  void let_value(NodeIndex binding);
  NodeIndex let_name(NodeIndex binding) const;
  bool is_variable_name(NodeIndex at) const;
  void set_hidden(std::uint32_t local);
  void do_steps(Parts bindings, bool at_once);
  void set_element(NodeIndex element, NodeIndex what);
  void loop_result(Parts header, std::optional<std::uint32_t> index);

  static constexpr int kNestingLimit = 400;

  Program& program_;
  const Document& document_;
  const SlotOf& slot_of_;
  Diagnostics& errors_;
  Compiler* outer_ = nullptr;
  Unit unit_;
  Assignments assignments_;
  std::vector<Variable> variables_;  ///< those in scope, the innermost last
  std::vector<Variable> captured_;
  std::vector<Block> blocks_;
  std::uint32_t height_ = 0;  ///< values above the locals at this point of the code
  NodeIndex place_ = kNoNode;
  int nesting_ = 0;
};

}  // namespace skein::htn::lisp
