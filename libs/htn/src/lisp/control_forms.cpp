// SPDX-License-Identifier: Apache-2.0
#include "lisp/forms.hpp"

namespace skein::htn::lisp {

// The values one after the other until one ends it by `jump`, which keeps it; the last stays too.
void ControlForms::short_circuit(Parts parts, Op jump, Term empty) {
  if (parts.size() == 1) writer_.emit_constant(empty);
  std::vector<std::size_t> exits;
  for (std::size_t at = 1; at < parts.size(); ++at) {
    value(parts[at]);
    if (at + 1 < parts.size()) exits.push_back(writer_.emit(jump));
  }
  for (const std::size_t exit : exits) writer_.patch(exit);
}

void ControlForms::and_form(NodeIndex /*form*/, Parts parts) {
  short_circuit(parts, Op::kJumpIfNilKeep, kTrue);
}

void ControlForms::or_form(NodeIndex /*form*/, Parts parts) {
  short_circuit(parts, Op::kJumpIfTrueKeep, kNil);
}

void ControlForms::if_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  const std::size_t otherwise = writer_.emit(Op::kJumpIfNil);
  value(parts[2]);
  const std::size_t end = writer_.emit(Op::kJump);
  writer_.patch(otherwise);
  writer_.drop();
  body(parts.subspan(3));
  writer_.patch(end);
}

void ControlForms::when_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  if (source_.symbol(parts[0]) == "unless") writer_.emit_function("not", 1);
  const std::size_t otherwise = writer_.emit(Op::kJumpIfNil);
  body(parts.subspan(2));
  const std::size_t end = writer_.emit(Op::kJump);
  writer_.patch(otherwise);
  writer_.drop();
  writer_.emit_constant(kNil);
  writer_.patch(end);
}

void ControlForms::cond_form(NodeIndex /*form*/, Parts parts) {
  std::vector<std::size_t> exits;
  for (const NodeIndex at : parts.subspan(1)) {
    const std::vector<NodeIndex> clause = source_.children(at);
    if (clause.empty()) {
      source_.error(at, "a clause of cond without test", "(test values)");
      continue;
    }
    value(clause[0]);
    if (clause.size() == 1) {
      exits.push_back(writer_.emit(Op::kJumpIfTrueKeep));
      continue;
    }
    const std::size_t next = writer_.emit(Op::kJumpIfNil);
    body(Parts(clause).subspan(1));
    exits.push_back(writer_.emit(Op::kJump));
    writer_.drop();
    writer_.patch(next);
  }
  writer_.emit_constant(kNil);
  for (const std::size_t exit : exits) writer_.patch(exit);
}

void ControlForms::case_form(NodeIndex form, Parts parts) {
  const std::uint32_t key = writer_.new_local();
  value(parts[1]);
  writer_.set_hidden(key);
  std::vector<std::size_t> exits;
  for (const NodeIndex at : parts.subspan(2)) {
    const std::vector<NodeIndex> clause = source_.children(at);
    if (clause.empty()) {
      source_.error(at, "a clause of case without keys", "(keys values)");
      continue;
    }
    case_keys(clause[0], key);
    const std::size_t next = writer_.emit(Op::kJumpIfNil);
    body(Parts(clause).subspan(1));
    exits.push_back(writer_.emit(Op::kJump));
    writer_.drop();
    writer_.patch(next);
  }
  if (source_.symbol(parts[0]) == "ecase") {
    writer_.set_place(form);
    writer_.emit_constant(store().string("no case for this value"));
    writer_.emit_function("error", 1);
  } else {
    writer_.emit_constant(kNil);
  }
  for (const std::size_t exit : exits) writer_.patch(exit);
}

void ControlForms::case_keys(NodeIndex keys, std::uint32_t local) {
  if (source_.symbol(keys) == "t" || source_.symbol(keys) == "otherwise") {
    writer_.emit_constant(kTrue);
    return;
  }
  const bool many =
      source_.node(keys).list || source_.node(keys).atom == kNil;  // nil: the list of no keys
  writer_.emit(Op::kLocal, local);
  compiler_.quoted(keys);
  writer_.emit_function(many ? "member" : "eql", 2);
}

void ControlForms::progn_form(NodeIndex /*form*/, Parts parts) { body(parts.subspan(1)); }

void ControlForms::prog1_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  for (const NodeIndex at : parts.subspan(2)) {
    value(at);
    writer_.emit(Op::kPop);
  }
}

void ControlForms::declare_form(NodeIndex /*form*/, Parts /*parts*/) {
  writer_.emit_constant(kNil);
}

void ControlForms::the_form(NodeIndex /*form*/, Parts parts) { value(parts[2]); }

void ControlForms::block_form(NodeIndex /*form*/, Parts parts) {
  writer_.begin_block(source_.node(parts[1]).atom);
  body(parts.subspan(2));
  writer_.end_block();
}

void ControlForms::return_form(NodeIndex form, Parts parts) {
  body(parts.subspan(1));
  leave_block(form, kNil);
}

void ControlForms::return_from_form(NodeIndex form, Parts parts) {
  body(parts.subspan(2));
  leave_block(form, source_.node(parts[1]).atom);
}

void ControlForms::leave_block(NodeIndex at, Term name) {
  if (writer_.leave_block(name)) return;
  source_.error(at, "return without a block of that name in the same function",
                "a surrounding block, dolist, dotimes or defun");
}

}  // namespace skein::htn::lisp
