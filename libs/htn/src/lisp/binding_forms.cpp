// SPDX-License-Identifier: Apache-2.0
#include "lisp/forms.hpp"
#include "lisp/patterns.hpp"

namespace skein::htn::lisp {

NodeIndex BindingForms::let_name(NodeIndex binding) const {
  return source_.node(binding).list ? source_.node(binding).first_child : binding;
}

void BindingForms::let_value(NodeIndex binding) {
  const std::vector<NodeIndex> parts = source_.children(binding);
  if (source_.node(binding).list && (parts.empty() || parts.size() > 2)) {
    source_.error(binding, "malformed variable of let", "name or (name value)");
  }
  if (parts.size() == 2) {
    value(parts[1]);
  } else {
    writer_.emit_constant(kNil);
  }
}

void BindingForms::let_form(NodeIndex /*form*/, Parts parts) {
  const std::size_t scope = scope_.size();
  const std::vector<NodeIndex> bindings = source_.children(parts[1]);
  for (const NodeIndex binding : bindings) let_value(binding);
  for (auto at = bindings.rbegin(); at != bindings.rend(); ++at) {
    const NodeIndex name = let_name(*at);
    if (name == kNoNode) {
      writer_.emit(Op::kPop);
    } else {
      scope_.bind(name);
    }
  }
  body(parts.subspan(2));
  scope_.leave(scope);
}

void BindingForms::let_star_form(NodeIndex /*form*/, Parts parts) {
  const std::size_t scope = scope_.size();
  for (const NodeIndex binding : source_.children(parts[1])) {
    let_value(binding);
    const NodeIndex name = let_name(binding);
    if (name == kNoNode) {
      writer_.emit(Op::kPop);
    } else {
      scope_.bind(name);
    }
  }
  body(parts.subspan(2));
  scope_.leave(scope);
}

// (variable what [result]), or nothing and the error is told.
std::vector<NodeIndex> BindingForms::loop_header(NodeIndex form, Parts parts,
                                                 const std::string& word, const char* what) {
  std::vector<NodeIndex> header = source_.children(parts[1]);
  if (header.size() >= 2 && header.size() <= 3) return header;
  source_.error(form, "malformed " + word, "(" + word + " (variable " + what + " [result]) body)");
  writer_.emit_constant(kNil);
  return {};
}

void BindingForms::dolist_form(NodeIndex form, Parts parts) {
  const std::vector<NodeIndex> header = loop_header(form, parts, "dolist", "list");
  if (header.empty()) return;
  const std::size_t scope = scope_.size();
  writer_.begin_block(kNil);
  const std::uint32_t rest = writer_.new_local();
  value(header[1]);
  writer_.set_hidden(rest);
  const std::uint32_t start = writer_.here();
  writer_.emit(Op::kLocal, rest);
  const std::size_t end = writer_.emit(Op::kJumpIfNil);
  writer_.emit(Op::kLocal, rest);
  writer_.emit_function("car", 1);
  scope_.bind(header[0]);
  writer_.emit(Op::kLocal, rest);
  writer_.emit_function("cdr", 1);
  writer_.set_hidden(rest);
  body(parts.subspan(2));
  writer_.emit(Op::kPop);
  writer_.emit(Op::kJump, start);
  writer_.patch(end);
  end_loop(header, std::nullopt, scope);
}

// The result sees the variable as well: the number of rounds, or nil after the last item.
void BindingForms::end_loop(Parts header, std::optional<std::uint32_t> index, std::size_t scope) {
  if (header.size() > 2) {
    if (index) {
      writer_.emit(Op::kLocal, *index);
    } else {
      writer_.emit_constant(kNil);
    }
    scope_.bind(header[0]);
  }
  body(header.subspan(2));
  scope_.leave(scope);
  writer_.end_block();
}

void BindingForms::dotimes_form(NodeIndex form, Parts parts) {
  const std::vector<NodeIndex> header = loop_header(form, parts, "dotimes", "count");
  if (header.empty()) return;
  const std::size_t scope = scope_.size();
  writer_.begin_block(kNil);
  const std::uint32_t count = writer_.new_local();
  const std::uint32_t index = writer_.new_local();
  value(header[1]);
  writer_.set_hidden(count);
  writer_.emit_constant(store().integer(0));
  writer_.set_hidden(index);
  const std::uint32_t start = writer_.here();
  writer_.emit(Op::kLocal, index);
  writer_.emit(Op::kLocal, count);
  writer_.emit_function("<", 2);
  const std::size_t end = writer_.emit(Op::kJumpIfNil);
  writer_.emit(Op::kLocal, index);
  scope_.bind(header[0]);
  writer_.emit(Op::kLocal, index);
  writer_.emit_function("1+", 1);
  writer_.set_hidden(index);
  body(parts.subspan(2));
  writer_.emit(Op::kPop);
  writer_.emit(Op::kJump, start);
  writer_.patch(end);
  end_loop(header, index, scope);
}

// (do ((variable first [step])…) (end result…) body…): all steps are worked out before any variable
// changes; with do* one after the other.
void BindingForms::do_form(NodeIndex form, Parts parts) {
  const std::vector<NodeIndex> bindings = source_.children(parts[1]);
  const std::vector<NodeIndex> end = source_.children(parts[2]);
  if (end.empty()) {
    source_.error(form, "malformed do", "(do ((variable first step)…) (end result…) body…)");
    writer_.emit_constant(kNil);
    return;
  }
  const bool at_once = source_.symbol(parts[0]) == "do";
  const std::size_t scope = scope_.size();
  writer_.begin_block(kNil);
  for (const NodeIndex binding : bindings) {
    const std::vector<NodeIndex> of = source_.children(binding);
    if (of.size() > 1) {
      value(of[1]);
    } else {
      writer_.emit_constant(kNil);
    }
    if (!at_once) scope_.bind(of.empty() ? binding : of[0]);
  }
  for (auto at = bindings.rbegin(); at_once && at != bindings.rend(); ++at) {
    const NodeIndex name = let_name(*at);
    scope_.bind(name == kNoNode ? *at : name);
  }
  const std::uint32_t start = writer_.here();
  value(end[0]);
  const std::size_t done = writer_.emit(Op::kJumpIfTrueKeep);
  body(parts.subspan(3));
  writer_.emit(Op::kPop);
  do_steps(bindings, at_once);
  writer_.emit(Op::kJump, start);
  writer_.patch(done);
  writer_.raise(1);
  writer_.emit(Op::kPop);
  body(Parts(end).subspan(1));
  scope_.leave(scope);
  writer_.end_block();
}

void BindingForms::do_steps(Parts bindings, bool at_once) {
  std::vector<NodeIndex> waiting;
  for (const NodeIndex binding : bindings) {
    const std::vector<NodeIndex> of = source_.children(binding);
    if (of.size() < 3) continue;
    value(of[2]);
    waiting.push_back(of[0]);
    if (at_once) continue;
    scope_.assign(of[0]);
    writer_.emit(Op::kPop);
  }
  for (auto at = waiting.rbegin(); at_once && at != waiting.rend(); ++at) {
    scope_.assign(*at);
    writer_.emit(Op::kPop);
  }
}

void BindingForms::destructuring_form(NodeIndex /*form*/, Parts parts) {
  const std::size_t scope = scope_.size();
  value(parts[2]);
  Patterns(compiler_).bind(parts[1]);
  body(parts.subspan(3));
  scope_.leave(scope);
}

}  // namespace skein::htn::lisp
