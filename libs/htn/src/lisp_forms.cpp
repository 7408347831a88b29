// SPDX-License-Identifier: Apache-2.0
// Forms whose arguments are not simply evaluated.
#include <array>
#include <map>
#include <span>

#include "lisp_compiler.hpp"

namespace skein::htn::lisp {

const Compiler::Form* Compiler::find_form(std::string_view name) {
  using C = Compiler;
  static const std::map<std::string_view, Form> kForms{
      {"and", {&C::and_form, 0, kAnyCount}},
      {"backquote", {&C::backquote_form, 1, 1}},
      {"block", {&C::block_form, 1, kAnyCount}},
      {"call", {&C::call_form, 1, kAnyCount}},
      {"case", {&C::case_form, 1, kAnyCount}},
      {"cond", {&C::cond_form, 0, kAnyCount}},
      {"declare", {&C::declare_form, 0, kAnyCount}},
      {"decf", {&C::increment_form, 1, 2}},
      {"destructuring-bind", {&C::destructuring_form, 2, kAnyCount}},
      {"do", {&C::do_form, 2, kAnyCount}},
      {"do*", {&C::do_form, 2, kAnyCount}},
      {"dolist", {&C::dolist_form, 1, kAnyCount}},
      {"dotimes", {&C::dotimes_form, 1, kAnyCount}},
      {"ecase", {&C::case_form, 1, kAnyCount}},
      {"eval", {&C::eval_form, 1, 1}},
      {"funcall", {&C::funcall_form, 1, kAnyCount}},
      {"function", {&C::function_form, 1, 1}},
      {"if", {&C::if_form, 2, 3}},
      {"incf", {&C::increment_form, 1, 2}},
      {"lambda", {&C::lambda_form, 1, kAnyCount}},
      {"let", {&C::let_form, 1, kAnyCount}},
      {"let*", {&C::let_star_form, 1, kAnyCount}},
      {"or", {&C::or_form, 0, kAnyCount}},
      {"pop", {&C::pop_form, 1, 1}},
      {"prog1", {&C::prog1_form, 1, kAnyCount}},
      {"progn", {&C::progn_form, 0, kAnyCount}},
      {"push", {&C::push_form, 2, 2}},
      {"pushnew", {&C::push_form, 2, 2}},
      {"quote", {&C::quote_form, 1, 1}},
      {"return", {&C::return_form, 0, 1}},
      {"return-from", {&C::return_from_form, 1, 2}},
      {"setf", {&C::set_form, 0, kAnyCount}},
      {"setq", {&C::set_form, 0, kAnyCount}},
      {"the", {&C::the_form, 2, 2}},
      {"unless", {&C::when_form, 1, kAnyCount}},
      {"when", {&C::when_form, 1, kAnyCount}},
  };
  const auto at = kForms.find(name);
  return at == kForms.end() ? nullptr : &at->second;
}

std::vector<std::string> Compiler::form_names() {
  return {"and",    "case",    "cond",        "destructuring-bind",
          "dolist", "dotimes", "eval",        "if",
          "incf",   "lambda",  "let",         "let*",
          "or",     "prog1",   "progn",       "push",
          "do",     "quote",   "return-from", "return",
          "setq",   "unless",  "when",        "funcall",
          "decf"};
}

// The values one after the other until one ends it by `jump`, which keeps it; the last stays too.
void Compiler::short_circuit(Parts parts, Op jump, Term empty) {
  if (parts.size() == 1) emit_constant(empty);
  std::vector<std::size_t> exits;
  for (std::size_t at = 1; at < parts.size(); ++at) {
    value(parts[at]);
    if (at + 1 < parts.size()) exits.push_back(emit(jump));
  }
  for (const std::size_t exit : exits) patch(exit);
}

void Compiler::and_form(NodeIndex /*form*/, Parts parts) {
  short_circuit(parts, Op::kJumpIfNilKeep, kTrue);
}

void Compiler::or_form(NodeIndex /*form*/, Parts parts) {
  short_circuit(parts, Op::kJumpIfTrueKeep, kNil);
}

void Compiler::if_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  const std::size_t otherwise = emit(Op::kJumpIfNil);
  value(parts[2]);
  const std::size_t end = emit(Op::kJump);
  patch(otherwise);
  --height_;
  body(parts.subspan(3));
  patch(end);
}

void Compiler::when_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  if (symbol(parts[0]) == "unless") emit_function("not", 1);
  const std::size_t otherwise = emit(Op::kJumpIfNil);
  body(parts.subspan(2));
  const std::size_t end = emit(Op::kJump);
  patch(otherwise);
  --height_;
  emit_constant(kNil);
  patch(end);
}

void Compiler::cond_form(NodeIndex /*form*/, Parts parts) {
  std::vector<std::size_t> exits;
  for (const NodeIndex at : parts.subspan(1)) {
    const std::vector<NodeIndex> clause = children(document_, at);
    if (clause.empty()) {
      error(at, "a clause of cond without test", "(test values)");
      continue;
    }
    value(clause[0]);
    if (clause.size() == 1) {
      exits.push_back(emit(Op::kJumpIfTrueKeep));
      continue;
    }
    const std::size_t next = emit(Op::kJumpIfNil);
    body(Parts(clause).subspan(1));
    exits.push_back(emit(Op::kJump));
    --height_;
    patch(next);
  }
  emit_constant(kNil);
  for (const std::size_t exit : exits) patch(exit);
}

void Compiler::case_form(NodeIndex form, Parts parts) {
  const std::uint32_t key = new_local();
  value(parts[1]);
  set_hidden(key);
  std::vector<std::size_t> exits;
  for (const NodeIndex at : parts.subspan(2)) {
    const std::vector<NodeIndex> clause = children(document_, at);
    if (clause.empty()) {
      error(at, "a clause of case without keys", "(keys values)");
      continue;
    }
    case_keys(clause[0], key);
    const std::size_t next = emit(Op::kJumpIfNil);
    body(Parts(clause).subspan(1));
    exits.push_back(emit(Op::kJump));
    --height_;
    patch(next);
  }
  if (symbol(parts[0]) == "ecase") {
    place_ = form;
    emit_constant(program_.store().string("no case for this value"));
    emit_function("error", 1);
  } else {
    emit_constant(kNil);
  }
  for (const std::size_t exit : exits) patch(exit);
}

void Compiler::case_keys(NodeIndex keys, std::uint32_t local) {
  if (symbol(keys) == "t" || symbol(keys) == "otherwise") {
    emit_constant(kTrue);
    return;
  }
  const bool many = node(keys).list || node(keys).atom == kNil;  // nil: the list of no keys
  emit(Op::kLocal, local);
  quoted(keys);
  emit_function(many ? "member" : "eql", 2);
}

void Compiler::progn_form(NodeIndex /*form*/, Parts parts) { body(parts.subspan(1)); }

void Compiler::prog1_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  for (const NodeIndex at : parts.subspan(2)) {
    value(at);
    emit(Op::kPop);
  }
}

void Compiler::call_form(NodeIndex at, Parts parts) { form(at, parts.subspan(1)); }

void Compiler::declare_form(NodeIndex /*form*/, Parts /*parts*/) { emit_constant(kNil); }

void Compiler::the_form(NodeIndex /*form*/, Parts parts) { value(parts[2]); }

// Values are never evaluated again, but a quoted expression is one.
void Compiler::eval_form(NodeIndex /*form*/, Parts parts) {
  const std::vector<NodeIndex> inside = children(document_, parts[1]);
  const bool expression = is_form(parts[1], "quote") && inside.size() == 2 && node(inside[1]).list;
  value(expression ? inside[1] : parts[1]);
}

void Compiler::funcall_form(NodeIndex /*form*/, Parts parts) {
  const std::vector<NodeIndex> inside = children(document_, parts[1]);
  const bool named = is_form(parts[1], "quote") && inside.size() == 2 && is_symbol(inside[1]) &&
                     !datum_atom(inside[1]).is(TermKind::kSlot);
  if (named) {
    function_value(inside[1]);
  } else {
    value(parts[1]);
  }
  for (const NodeIndex at : parts.subspan(2)) value(at);
  emit(Op::kFuncall, 0, static_cast<std::uint32_t>(parts.size() - 2));
}

NodeIndex Compiler::let_name(NodeIndex binding) const {
  return node(binding).list ? node(binding).first_child : binding;
}

void Compiler::let_value(NodeIndex binding) {
  const std::vector<NodeIndex> parts = children(document_, binding);
  if (node(binding).list && (parts.empty() || parts.size() > 2)) {
    error(binding, "malformed variable of let", "name or (name value)");
  }
  if (parts.size() == 2) {
    value(parts[1]);
  } else {
    emit_constant(kNil);
  }
}

void Compiler::let_form(NodeIndex /*form*/, Parts parts) {
  const std::size_t scope = variables_.size();
  const std::vector<NodeIndex> bindings = children(document_, parts[1]);
  for (const NodeIndex binding : bindings) let_value(binding);
  for (auto at = bindings.rbegin(); at != bindings.rend(); ++at) {
    const NodeIndex name = let_name(*at);
    if (name == kNoNode) {
      emit(Op::kPop);
    } else {
      bind(name);
    }
  }
  body(parts.subspan(2));
  variables_.resize(scope);
}

void Compiler::let_star_form(NodeIndex /*form*/, Parts parts) {
  const std::size_t scope = variables_.size();
  for (const NodeIndex binding : children(document_, parts[1])) {
    let_value(binding);
    const NodeIndex name = let_name(binding);
    if (name == kNoNode) {
      emit(Op::kPop);
    } else {
      bind(name);
    }
  }
  body(parts.subspan(2));
  variables_.resize(scope);
}

void Compiler::begin_block(Term name) { blocks_.push_back({name, height_, {}}); }

void Compiler::end_block() {
  for (const std::size_t exit : blocks_.back().exits) patch(exit);
  blocks_.pop_back();
}

// The value on the stack becomes that of the block.
void Compiler::leave_block(NodeIndex at, Term name) {
  for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block) {
    if (block->name != name) continue;
    emit(Op::kSlide, block->height);
    block->exits.push_back(emit(Op::kJump));
    return;
  }
  error(at, "return without a block of that name in the same function",
        "a surrounding block, dolist, dotimes or defun");
}

void Compiler::block_form(NodeIndex /*form*/, Parts parts) {
  begin_block(node(parts[1]).atom);
  body(parts.subspan(2));
  end_block();
}

void Compiler::return_form(NodeIndex form, Parts parts) {
  body(parts.subspan(1));
  leave_block(form, kNil);
}

void Compiler::return_from_form(NodeIndex form, Parts parts) {
  body(parts.subspan(2));
  leave_block(form, node(parts[1]).atom);
}

void Compiler::dolist_form(NodeIndex form, Parts parts) {
  const std::vector<NodeIndex> header = children(document_, parts[1]);
  if (header.size() < 2 || header.size() > 3) {
    error(form, "malformed dolist", "(dolist (variable list [result]) body)");
    emit_constant(kNil);
    return;
  }
  const std::size_t scope = variables_.size();
  begin_block(kNil);
  const std::uint32_t rest = new_local();
  value(header[1]);
  set_hidden(rest);
  const std::uint32_t start = here();
  emit(Op::kLocal, rest);
  const std::size_t end = emit(Op::kJumpIfNil);
  emit(Op::kLocal, rest);
  emit_function("car", 1);
  bind(header[0]);
  emit(Op::kLocal, rest);
  emit_function("cdr", 1);
  set_hidden(rest);
  body(parts.subspan(2));
  emit(Op::kPop);
  emit(Op::kJump, start);
  patch(end);
  loop_result(header, std::nullopt);
  variables_.resize(scope);
  end_block();
}

// The result sees the variable as well: the number of rounds, or nil after the last item.
void Compiler::loop_result(Parts header, std::optional<std::uint32_t> index) {
  if (header.size() > 2) {
    if (index) {
      emit(Op::kLocal, *index);
    } else {
      emit_constant(kNil);
    }
    bind(header[0]);
  }
  body(header.subspan(2));
}

void Compiler::dotimes_form(NodeIndex form, Parts parts) {
  const std::vector<NodeIndex> header = children(document_, parts[1]);
  if (header.size() < 2 || header.size() > 3) {
    error(form, "malformed dotimes", "(dotimes (variable count [result]) body)");
    emit_constant(kNil);
    return;
  }
  const std::size_t scope = variables_.size();
  begin_block(kNil);
  const std::uint32_t count = new_local();
  const std::uint32_t index = new_local();
  value(header[1]);
  set_hidden(count);
  emit_constant(program_.store().integer(0));
  set_hidden(index);
  const std::uint32_t start = here();
  emit(Op::kLocal, index);
  emit(Op::kLocal, count);
  emit_function("<", 2);
  const std::size_t end = emit(Op::kJumpIfNil);
  emit(Op::kLocal, index);
  bind(header[0]);
  emit(Op::kLocal, index);
  emit_function("1+", 1);
  set_hidden(index);
  body(parts.subspan(2));
  emit(Op::kPop);
  emit(Op::kJump, start);
  patch(end);
  loop_result(header, index);
  variables_.resize(scope);
  end_block();
}

// (do ((variable first [step])…) (end result…) body…): all steps are worked out before any variable
// changes; with do* one after the other.
void Compiler::do_form(NodeIndex form, Parts parts) {
  const std::vector<NodeIndex> bindings = children(document_, parts[1]);
  const std::vector<NodeIndex> end = children(document_, parts[2]);
  if (end.empty()) {
    error(form, "malformed do", "(do ((variable first step)…) (end result…) body…)");
    emit_constant(kNil);
    return;
  }
  const bool at_once = symbol(parts[0]) == "do";
  const std::size_t scope = variables_.size();
  begin_block(kNil);
  for (const NodeIndex binding : bindings) {
    const std::vector<NodeIndex> of = children(document_, binding);
    if (of.size() > 1) {
      value(of[1]);
    } else {
      emit_constant(kNil);
    }
    if (!at_once) bind(of.empty() ? binding : of[0]);
  }
  for (auto at = bindings.rbegin(); at_once && at != bindings.rend(); ++at) {
    const NodeIndex name = let_name(*at);
    bind(name == kNoNode ? *at : name);
  }
  const std::uint32_t start = here();
  value(end[0]);
  const std::size_t done = emit(Op::kJumpIfTrueKeep);
  body(parts.subspan(3));
  emit(Op::kPop);
  do_steps(bindings, at_once);
  emit(Op::kJump, start);
  patch(done);
  raise(1);
  emit(Op::kPop);
  body(Parts(end).subspan(1));
  variables_.resize(scope);
  end_block();
}

void Compiler::do_steps(Parts bindings, bool at_once) {
  std::vector<NodeIndex> waiting;
  for (const NodeIndex binding : bindings) {
    const std::vector<NodeIndex> of = children(document_, binding);
    if (of.size() < 3) continue;
    value(of[2]);
    waiting.push_back(of[0]);
    if (at_once) continue;
    assign(of[0]);
    emit(Op::kPop);
  }
  for (auto at = waiting.rbegin(); at_once && at != waiting.rend(); ++at) {
    assign(*at);
    emit(Op::kPop);
  }
}

}  // namespace skein::htn::lisp
