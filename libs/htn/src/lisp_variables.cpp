// SPDX-License-Identifier: Apache-2.0
// Local variables of Lisp terms: parameters, patterns, assignment, sharing with lambdas.
#include <algorithm>

#include "lisp_builtins.hpp"
#include "lisp_compiler.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::htn::lisp {

// One look at the whole expression: a variable that is assigned anywhere while there are lambdas
// is kept in a box, which the lambdas share. Too many boxes do no harm.
void Compiler::note_assignments(NodeIndex root) {
  std::vector<NodeIndex> open{root};
  while (!open.empty()) {
    const NodeIndex at = open.back();
    open.pop_back();
    if (!node(at).list || node(at).first_child == kNoNode) continue;
    const std::string_view head = symbol(node(at).first_child);
    const bool every_second = head == "setq" || head == "setf";
    const bool second = head == "push" || head == "pushnew";
    const bool first = head == "pop" || head == "incf" || head == "decf";
    if (head == "do" || head == "do*") note_steps(node(node(at).first_child).next);
    if (head == "lambda") assignments_.lambda = true;
    std::size_t position = 0;
    for (NodeIndex child = node(at).first_child; child != kNoNode; child = node(child).next) {
      const bool target = (every_second && position % 2 == 1) || (second && position == 2) ||
                          (first && position == 1);
      if (target && is_symbol(child)) assignments_.names.insert(node(child).atom);
      if (node(child).list) open.push_back(child);
      ++position;
    }
  }
}

// The variables of do that its steps assign.
void Compiler::note_steps(NodeIndex bindings) {
  if (bindings == kNoNode || !node(bindings).list) return;
  for (const NodeIndex binding : children(document_, bindings)) {
    const std::vector<NodeIndex> parts = children(document_, binding);
    if (parts.size() == 3 && is_symbol(parts[0])) assignments_.names.insert(node(parts[0]).atom);
  }
}

std::optional<Compiler::Variable> Compiler::find(Term name) {
  for (const auto* known : {&variables_, &captured_}) {
    for (auto at = known->rbegin(); at != known->rend(); ++at) {
      if (at->name == name) return *at;
    }
  }
  if (outer_ == nullptr) return std::nullopt;
  std::optional<Variable> variable = outer_->find(name);
  if (!variable) return std::nullopt;
  const std::uint32_t inner = new_local();
  unit_.captures.push_back({variable->local, inner});
  variable->local = inner;
  captured_.push_back(*variable);
  return variable;
}

bool Compiler::is_variable_name(NodeIndex at) const {
  return is_symbol(at) && node(at).atom != kNil && node(at).atom != kTrue &&
         !symbol(at).starts_with(':') && !symbol(at).starts_with('&');
}

// The variable holds what its local holds at this point of the code.
void Compiler::declare(NodeIndex name, std::uint32_t local) {
  if (!is_variable_name(name)) {
    error(name, "this cannot be a variable", "a symbol");
    return;
  }
  const Term symbol = node(name).atom;
  const bool boxed = assignments_.lambda && assignments_.names.contains(symbol);
  if (boxed) emit(Op::kBoxLocal, local);
  variables_.push_back({symbol, local, boxed});
}

// A new variable takes the value on the stack.
void Compiler::bind(NodeIndex name) {
  const std::uint32_t local = new_local();
  set_hidden(local);
  declare(name, local);
}

void Compiler::set_hidden(std::uint32_t local) {
  emit(Op::kSetLocal, local);
  emit(Op::kPop);
}

void Compiler::copy_local(std::uint32_t from, NodeIndex to) {
  emit(Op::kLocal, from);
  bind_pattern(to);
}

void Compiler::read(const Variable& variable) {
  emit(variable.boxed ? Op::kBoxed : Op::kLocal, variable.local);
}

// The value on the stack stays there.
void Compiler::assign(NodeIndex name) {
  const auto variable = is_symbol(name) ? find(node(name).atom) : std::nullopt;
  const auto global =
      !variable && is_variable_name(name) ? program_.global(node(name).atom) : std::nullopt;
  if (global) {
    emit(Op::kSetGlobal, *global);
    return;
  }
  if (!variable) {
    error(name, "only a variable of the code can be assigned",
          "a variable of let, lambda or defun, one of defvar or defparameter, or a *name*");
    return;
  }
  emit(variable->boxed ? Op::kSetBoxed : Op::kSetLocal, variable->local);
}

bool Compiler::is_marker(NodeIndex at) const { return symbol(at).starts_with('&'); }

void Compiler::parameters(NodeIndex list) {
  if (!node(list).list || node(list).dotted) {
    if (node(list).list || node(list).atom != kNil) error(list, "malformed parameters", "a list");
    return;
  }
  std::vector<NodeIndex> required;
  std::vector<NodeIndex> optional;
  std::vector<NodeIndex> rest;
  std::vector<NodeIndex>* kind = &required;
  for (const NodeIndex at : children(document_, list)) {
    if (symbol(at) == "&optional") {
      kind = &optional;
    } else if (symbol(at) == "&rest" || symbol(at) == "&body") {
      kind = &rest;
    } else if (is_marker(at) || rest.size() == 1) {
      error(at, "parameters of this kind are not supported", "&optional, and &rest with one name");
    } else {
      kind->push_back(at);
    }
  }
  unit_.required = static_cast<std::uint32_t>(required.size());
  unit_.optional = static_cast<std::uint32_t>(optional.size());
  unit_.rest = !rest.empty();
  unit_.locals += unit_.required + unit_.optional + (unit_.rest ? 1 : 0);
  for (std::uint32_t at = 0; at < unit_.required; ++at) declare(required[at], at);
  for (std::uint32_t at = 0; at < unit_.optional; ++at) {
    optional_parameter(optional[at], unit_.required + at);
  }
  if (unit_.rest) declare(rest.front(), unit_.required + unit_.optional);
}

void Compiler::optional_parameter(NodeIndex at, std::uint32_t index) {
  if (!node(at).list) {
    declare(at, index);
    return;
  }
  const std::vector<NodeIndex> parts = children(document_, at);
  if (parts.empty() || parts.size() > 2) {
    error(at, "malformed optional parameter", "name or (name default)");
    return;
  }
  if (parts.size() == 2) {
    const std::size_t given = emit(Op::kJumpIfGiven, 0, index);
    value(parts[1]);
    set_hidden(index);
    patch(given);
  }
  declare(parts[0], index);
}

// The value on the stack goes into the variables of the pattern: a name, or a list of patterns.
void Compiler::bind_pattern(NodeIndex at) {
  if (is_symbol(at) && node(at).atom != kNil) {
    bind(at);
    return;
  }
  if (!node(at).list) {
    error(at, "this cannot be a pattern", "variables and lists of them");
    emit(Op::kPop);
    return;
  }
  const std::uint32_t source = new_local();
  set_hidden(source);
  if (++nesting_ > kNestingLimit) {
    error(at, "pattern nested too deeply");
  } else {
    pattern_list(at, source);
  }
  --nesting_;
}

void Compiler::pattern_list(NodeIndex at, std::uint32_t source) {
  const std::vector<NodeIndex> all = children(document_, at);
  bool optional = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool last = i + 1 == all.size();
    if (symbol(all[i]) == "&optional") {
      optional = true;
    } else if ((last && node(at).dotted) || (i > 0 && is_marker(all[i - 1]) && !optional)) {
      copy_local(source, all[i]);
      return;
    } else if (symbol(all[i]) == "&rest" || symbol(all[i]) == "&body") {
      optional = false;
    } else if (is_marker(all[i])) {
      error(all[i], "patterns of this kind are not supported", "&optional or &rest");
    } else if (optional) {
      pattern_optional(all[i], source);
    } else {
      next_item(source);
      bind_pattern(all[i]);
    }
  }
  emit(Op::kLocal, source);
  emit_constant(kNil);
  emit_function("destructuring-bind", 2);
  emit(Op::kPop);
}

// Pushes the first item of what is left of the list, and goes on to the next.
void Compiler::next_item(std::uint32_t source) {
  emit(Op::kLocal, source);
  emit_function("destructuring-bind", 1);
  emit(Op::kLocal, source);
  emit_function("cdr", 1);
  set_hidden(source);
}

void Compiler::pattern_optional(NodeIndex at, std::uint32_t source) {
  const std::vector<NodeIndex> parts = children(document_, at);
  emit(Op::kLocal, source);
  const std::size_t missing = emit(Op::kJumpIfNil);
  next_item(source);
  const std::size_t done = emit(Op::kJump);
  patch(missing);
  --height_;
  if (node(at).list && parts.size() > 1) {
    value(parts[1]);
  } else {
    emit_constant(kNil);
  }
  patch(done);
  bind_pattern(node(at).list && !parts.empty() ? parts[0] : at);
}

void Compiler::destructuring_form(NodeIndex /*form*/, Parts parts) {
  const std::size_t scope = variables_.size();
  value(parts[2]);
  bind_pattern(parts[1]);
  body(parts.subspan(3));
  variables_.resize(scope);
}

void Compiler::set_form(NodeIndex form, Parts parts) {
  if (parts.size() % 2 == 0) error(form, "a variable without value", "pairs of variable and value");
  if (parts.size() < 3) emit_constant(kNil);
  for (std::size_t at = 1; at + 1 < parts.size(); at += 2) {
    if (at > 1) emit(Op::kPop);
    if (is_form(parts[at], "gethash") || is_form(parts[at], "aref")) {
      set_element(parts[at], parts[at + 1]);
    } else {
      value(parts[at + 1]);
      assign(parts[at]);
    }
  }
}

// (setf (aref array index…) value): the arguments, then the value.
void Compiler::set_element(NodeIndex element, NodeIndex what) {
  const std::vector<NodeIndex> parts = children(document_, element);
  const bool table = symbol(parts[0]) == "gethash";
  check_count(element, symbol(parts[0]), parts.size() - 1, table ? 2 : 1, table ? 3 : kAnyCount);
  const std::size_t given = table ? std::min<std::size_t>(parts.size(), 3) : parts.size();
  for (std::size_t at = 1; at < given; ++at) value(parts[at]);
  value(what);
  const Builtin& setter = table ? hash_setter() : array_setter();
  const auto index = program_.find(program_.store().symbol(setter.name));
  SKEIN_ENSURES(index.has_value());
  emit(Op::kCall, *index, static_cast<std::uint32_t>(given));
}

void Compiler::increment_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  if (parts.size() > 2) {
    value(parts[2]);
  } else {
    emit_constant(program_.store().integer(1));
  }
  emit_function(symbol(parts[0]) == "incf" ? "+" : "-", 2);
  assign(parts[1]);
}

void Compiler::push_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  value(parts[2]);
  emit_function(symbol(parts[0]) == "push" ? "cons" : "adjoin", 2);
  assign(parts[2]);
}

void Compiler::pop_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  emit_function("car", 1);
  value(parts[1]);
  emit_function("cdr", 1);
  assign(parts[1]);
  emit(Op::kPop);
}

}  // namespace skein::htn::lisp
