// SPDX-License-Identifier: Apache-2.0
// Forms whose arguments are not simply evaluated.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lisp/compiler.hpp"

namespace skein::htn::lisp {

/// A form by name. `compile` emits code that pushes exactly one value.
struct Form {
  void (*compile)(Compiler& compiler, NodeIndex form, Parts parts);
  std::size_t least;  ///< arguments
  std::size_t most;
};
/// Null: there is none of this name.
const Form* find_form(std::string_view name);
/// Names of all forms, as suggestions for an unknown name.
std::vector<std::string> form_names();

/// Common base of the form compilers. Lifetime: refers to the compiler.
class FormWriter {
 public:
  explicit FormWriter(Compiler& compiler)
      : compiler_(compiler),
        source_(compiler.source()),
        writer_(compiler.writer()),
        scope_(compiler.scope()) {}

 protected:
  TermStore& store() const { return compiler_.program().store(); }
  void value(NodeIndex at) { compiler_.value(at); }
  void body(Parts parts) { compiler_.body(parts); }

  Compiler& compiler_;
  Source& source_;
  Writer& writer_;
  Scope& scope_;
};

/// Forms of control flow.
class ControlForms : public FormWriter {
 public:
  using FormWriter::FormWriter;
  void and_form(NodeIndex form, Parts parts);
  void block_form(NodeIndex form, Parts parts);
  void case_form(NodeIndex form, Parts parts);
  void cond_form(NodeIndex form, Parts parts);
  void declare_form(NodeIndex form, Parts parts);
  void if_form(NodeIndex form, Parts parts);
  void or_form(NodeIndex form, Parts parts);
  void prog1_form(NodeIndex form, Parts parts);
  void progn_form(NodeIndex form, Parts parts);
  void return_form(NodeIndex form, Parts parts);
  void return_from_form(NodeIndex form, Parts parts);
  void the_form(NodeIndex form, Parts parts);
  void when_form(NodeIndex form, Parts parts);

 private:
  void short_circuit(Parts parts, Op jump, Term empty);
  void case_keys(NodeIndex keys, std::uint32_t local);
  void leave_block(NodeIndex at, Term name);
};

/// Forms that bind variables, and loops.
class BindingForms : public FormWriter {
 public:
  using FormWriter::FormWriter;
  void destructuring_form(NodeIndex form, Parts parts);
  void do_form(NodeIndex form, Parts parts);
  void dolist_form(NodeIndex form, Parts parts);
  void dotimes_form(NodeIndex form, Parts parts);
  void let_form(NodeIndex form, Parts parts);
  void let_star_form(NodeIndex form, Parts parts);

 private:
  void let_value(NodeIndex binding);
  NodeIndex let_name(NodeIndex binding) const;
  void do_steps(Parts bindings, bool at_once);
  std::vector<NodeIndex> loop_header(NodeIndex form, Parts parts, const std::string& word,
                                     const char* what);
  void end_loop(Parts header, std::optional<std::uint32_t> index, std::size_t scope);
};

/// Forms that assign a place: a variable, an item of a table or of an array.
class PlaceForms : public FormWriter {
 public:
  using FormWriter::FormWriter;
  void increment_form(NodeIndex form, Parts parts);
  void pop_form(NodeIndex form, Parts parts);
  void push_form(NodeIndex form, Parts parts);
  void set_form(NodeIndex form, Parts parts);

 private:
  void set_element(NodeIndex element, NodeIndex what);
};

/// Forms for data and functions: quoting, lambdas, evaluation.
class DataForms : public FormWriter {
 public:
  using FormWriter::FormWriter;
  void backquote_form(NodeIndex form, Parts parts);
  void call_form(NodeIndex form, Parts parts);
  void eval_form(NodeIndex form, Parts parts);
  void funcall_form(NodeIndex form, Parts parts);
  void function_form(NodeIndex form, Parts parts);
  void lambda_form(NodeIndex form, Parts parts);
  void quote_form(NodeIndex form, Parts parts);

 private:
  void backquoted(NodeIndex at);
  void backquoted_list(NodeIndex at);
};

}  // namespace skein::htn::lisp
