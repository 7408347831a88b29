// SPDX-License-Identifier: Apache-2.0
// Quoted data, templates and function values: the parts of expressions that are not evaluated.
#include <algorithm>

#include "lisp_compiler.hpp"

namespace skein::htn::lisp {

Term Compiler::datum_atom(NodeIndex at) {
  const Term term = node(at).atom;
  if (!is_symbol(at) || !symbol(at).starts_with('?') || !slot_of_) return term;
  const auto slot = slot_of_(term);
  return slot ? Term(TermKind::kSlot, *slot) : term;
}

// An explicit stack, as data may be deep: the finished items of each list that is open.
Term Compiler::datum(NodeIndex at) {
  struct Open {
    std::vector<Term> items;
    NodeIndex list = kNoNode;
  };
  std::vector<Open> open;
  while (true) {
    const Node& current = node(at);
    if (current.list && current.first_child != kNoNode) {
      open.push_back({{}, at});
      at = current.first_child;
      continue;
    }
    Term done = current.list ? kNil : datum_atom(at);
    NodeIndex next = current.next;
    while (!open.empty()) {
      Open& last = open.back();
      last.items.push_back(done);
      if (next != kNoNode) break;
      const bool dotted = node(last.list).dotted;
      const Arguments items(last.items);
      done = dotted ? program_.store().list(items.first(items.size() - 1), items.back())
                    : program_.store().list(items);
      next = node(last.list).next;
      open.pop_back();
    }
    if (open.empty()) return done;
    at = next;
  }
}

void Compiler::quoted(NodeIndex at) { emit_constant(datum(at)); }

void Compiler::quote_form(NodeIndex /*form*/, Parts parts) { quoted(parts[1]); }

bool Compiler::contains_call(NodeIndex index) const {
  std::vector<NodeIndex> open{index};
  while (!open.empty()) {
    const NodeIndex at = open.back();
    open.pop_back();
    if (!node(at).list) continue;
    if (is_form(at, "call")) return true;
    for (NodeIndex child = node(at).first_child; child != kNoNode; child = node(child).next) {
      open.push_back(child);
    }
  }
  return false;
}

void Compiler::task_template(NodeIndex at) {
  if (nesting_ == 0) note_assignments(at);
  if (is_form(at, "call")) {
    value(at);
    return;
  }
  if (!contains_call(at)) {
    quoted(at);
    return;
  }
  if (++nesting_ > kNestingLimit) {
    error(at, "task nested too deeply");
    emit_constant(kNil);
  } else {
    const std::vector<NodeIndex> items = children(document_, at);
    for (const NodeIndex item : items) task_template(item);
    emit(node(at).dotted ? Op::kListStar : Op::kList, 0, static_cast<std::uint32_t>(items.size()));
  }
  --nesting_;
}

void Compiler::backquote_form(NodeIndex /*form*/, Parts parts) { backquoted(parts[1]); }

void Compiler::backquoted(NodeIndex at) {
  if (is_form(at, "comma")) {
    const std::vector<NodeIndex> parts = children(document_, at);
    value(parts.back());
    return;
  }
  if (!node(at).list || node(at).first_child == kNoNode) {
    quoted(at);
    return;
  }
  ++nesting_;
  if (is_form(at, "backquote") || is_form(at, "comma-at") || nesting_ > kNestingLimit) {
    error(at, "this is not understood inside a backquote");
    emit_constant(kNil);
  } else {
    backquoted_list(at);
  }
  --nesting_;
}

// Runs of plain items become lists; with the spliced ones between them they are appended. A tail
// `. ,x` is read as the two items `comma x`.
void Compiler::backquoted_list(NodeIndex at) {
  std::vector<NodeIndex> items = children(document_, at);
  const bool comma_tail =
      !node(at).dotted && items.size() > 2 && symbol(items[items.size() - 2]) == "comma";
  if (comma_tail) items.erase(items.end() - 2);
  std::uint32_t pieces = 0;
  std::uint32_t plain = 0;
  const auto end_run = [&](Op op) {
    if (plain == 0) return;
    emit(op, 0, plain);
    plain = 0;
    ++pieces;
  };
  for (const NodeIndex item : items) {
    if (comma_tail && item == items.back()) {
      value(item);
      ++plain;
    } else if (is_form(item, "comma-at")) {
      end_run(Op::kList);
      value(children(document_, item).back());
      ++pieces;
    } else {
      backquoted(item);
      ++plain;
    }
  }
  end_run(node(at).dotted || comma_tail ? Op::kListStar : Op::kList);
  if (pieces != 1) emit_function("append", pieces);
}

void Compiler::function(NodeIndex at) {
  note_assignments(at);
  place_ = at;
  if (is_symbol(at) && !datum_atom(at).is(TermKind::kSlot)) {
    function_value(at);
    return;
  }
  const std::vector<NodeIndex> parts = children(document_, at);
  if (is_form(at, "quote") && parts.size() == 2) {
    function_value(parts[1]);
    return;
  }
  value(at);
}

void Compiler::function_form(NodeIndex /*form*/, Parts parts) { function_value(parts[1]); }

void Compiler::lambda_form(NodeIndex form, Parts parts) { lambda(form, parts); }

void Compiler::function_value(NodeIndex at) {
  if (is_form(at, "lambda")) {
    lambda(at, children(document_, at));
    return;
  }
  const auto index = is_symbol(at) ? program_.find(node(at).atom) : std::nullopt;
  if (index) {
    program_.want(*index);
  } else if (is_symbol(at)) {
    unknown_function(at, symbol(at));
  } else {
    error(at, "this designates no function", "a function name or a lambda expression");
  }
  emit_constant(is_symbol(at) ? node(at).atom : kNil);
}

void Compiler::lambda(NodeIndex at, Parts parts) {
  if (parts.size() < 2) {
    error(at, "a lambda without parameters", "(lambda (parameters) body)");
    emit_constant(kNil);
    return;
  }
  Compiler inner(*this, document_);
  inner.place_ = at;
  inner.parameters(parts[1]);
  inner.body(parts.subspan(2));
  const std::uint32_t unit = program_.add_unit(inner.finish("lambda"));
  emit(Op::kClosure, unit);
}

}  // namespace skein::htn::lisp
