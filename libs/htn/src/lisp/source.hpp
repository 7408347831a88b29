// SPDX-License-Identifier: Apache-2.0
// Access to the text of a unit during compilation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lisp/program.hpp"

namespace skein::htn::lisp {

/// Nodes of one document, their symbols and values, and errors at their positions. Lifetime: refers
/// to its arguments.
class Source {
 public:
  Source(Program& program, const Document& document, const SlotOf& slot_of, Diagnostics& errors)
      : program_(program), document_(document), slot_of_(slot_of), errors_(errors) {}

  const Document& document() const { return document_; }
  const SlotOf& slot_of() const { return slot_of_; }
  Diagnostics& errors() { return errors_; }

  const Node& node(NodeIndex index) const { return document_[index]; }
  std::vector<NodeIndex> children(NodeIndex index) const;
  std::string_view symbol(NodeIndex index) const;
  bool is_symbol(NodeIndex index) const;
  bool is_form(NodeIndex index, std::string_view head) const;
  /// Whether the symbol is a marker of a parameter list: &optional, &rest, …
  bool is_marker(NodeIndex at) const { return symbol(at).starts_with('&'); }
  bool is_variable_name(NodeIndex at) const;
  bool contains_call(NodeIndex index) const;
  /// The quoted term; variables of the planner become slots.
  Term datum(NodeIndex at) const;
  Term datum_atom(NodeIndex at) const;

  void error(NodeIndex at, std::string message, std::string expected = {},
             std::string nearest = {});
  void check_count(NodeIndex at, std::string_view name, std::size_t given, std::size_t least,
                   std::size_t most);

 private:
  Program& program_;
  const Document& document_;
  const SlotOf& slot_of_;
  Diagnostics& errors_;
};

}  // namespace skein::htn::lisp
