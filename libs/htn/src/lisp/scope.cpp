// SPDX-License-Identifier: Apache-2.0
#include "lisp/scope.hpp"

namespace skein::htn::lisp {

// One look at the whole expression: a variable that is assigned anywhere while there are lambdas
// is kept in a box, which the lambdas share. Too many boxes do no harm.
void Scope::note_assignments(NodeIndex root) {
  std::vector<NodeIndex> open{root};
  while (!open.empty()) {
    const NodeIndex at = open.back();
    open.pop_back();
    if (!source_.node(at).list || source_.node(at).first_child == kNoNode) continue;
    const std::string_view head = source_.symbol(source_.node(at).first_child);
    const bool every_second = head == "setq" || head == "setf";
    const bool second = head == "push" || head == "pushnew";
    const bool first = head == "pop" || head == "incf" || head == "decf";
    if (head == "do" || head == "do*") note_steps(source_.node(source_.node(at).first_child).next);
    if (head == "lambda") assignments_.lambda = true;
    std::size_t position = 0;
    for (NodeIndex child = source_.node(at).first_child; child != kNoNode;
         child = source_.node(child).next) {
      const bool target = (every_second && position % 2 == 1) || (second && position == 2) ||
                          (first && position == 1);
      if (target && source_.is_symbol(child)) assignments_.names.insert(source_.node(child).atom);
      if (source_.node(child).list) open.push_back(child);
      ++position;
    }
  }
}

// The variables of do that its steps assign.
void Scope::note_steps(NodeIndex bindings) {
  if (bindings == kNoNode || !source_.node(bindings).list) return;
  for (const NodeIndex binding : source_.children(bindings)) {
    const std::vector<NodeIndex> parts = source_.children(binding);
    if (parts.size() == 3 && source_.is_symbol(parts[0]))
      assignments_.names.insert(source_.node(parts[0]).atom);
  }
}

std::optional<Scope::Variable> Scope::find(Term name) {
  for (const auto* known : {&variables_, &captured_}) {
    for (auto at = known->rbegin(); at != known->rend(); ++at) {
      if (at->name == name) return *at;
    }
  }
  if (outer_ == nullptr) return std::nullopt;
  std::optional<Variable> variable = outer_->find(name);
  if (!variable) return std::nullopt;
  variable->local = writer_.capture(variable->local);
  captured_.push_back(*variable);
  return variable;
}

// The variable holds what its local holds at this point of the code.
void Scope::declare(NodeIndex name, std::uint32_t local) {
  if (!source_.is_variable_name(name)) {
    source_.error(name, "this cannot be a variable", "a symbol");
    return;
  }
  const Term symbol = source_.node(name).atom;
  const bool boxed = assignments_.lambda && assignments_.names.contains(symbol);
  if (boxed) writer_.emit(Op::kBoxLocal, local);
  variables_.push_back({symbol, local, boxed});
}

// A new variable takes the value on the stack.
void Scope::bind(NodeIndex name) {
  const std::uint32_t local = writer_.new_local();
  writer_.set_hidden(local);
  declare(name, local);
}

void Scope::read(const Variable& variable) {
  writer_.emit(variable.boxed ? Op::kBoxed : Op::kLocal, variable.local);
}

// The value on the stack stays there.
void Scope::assign(NodeIndex name) {
  const auto variable = source_.is_symbol(name) ? find(source_.node(name).atom) : std::nullopt;
  const auto global = !variable && source_.is_variable_name(name)
                          ? program_.global(source_.node(name).atom)
                          : std::nullopt;
  if (global) {
    writer_.emit(Op::kSetGlobal, *global);
    return;
  }
  if (!variable) {
    source_.error(name, "only a variable of the code can be assigned",
                  "a variable of let, lambda or defun, one of defvar or defparameter, or a *name*");
    return;
  }
  writer_.emit(variable->boxed ? Op::kSetBoxed : Op::kSetLocal, variable->local);
}

}  // namespace skein::htn::lisp
