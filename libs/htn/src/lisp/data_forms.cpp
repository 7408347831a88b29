// SPDX-License-Identifier: Apache-2.0
#include "lisp/forms.hpp"

namespace skein::htn::lisp {

void DataForms::quote_form(NodeIndex /*form*/, Parts parts) { compiler_.quoted(parts[1]); }

void DataForms::backquote_form(NodeIndex /*form*/, Parts parts) { backquoted(parts[1]); }

void DataForms::backquoted(NodeIndex at) {
  if (source_.is_form(at, "comma")) {
    const std::vector<NodeIndex> parts = source_.children(at);
    value(parts.back());
    return;
  }
  if (!source_.node(at).list || source_.node(at).first_child == kNoNode) {
    compiler_.quoted(at);
    return;
  }
  const bool too_deep = !compiler_.deeper();
  if (source_.is_form(at, "backquote") || source_.is_form(at, "comma-at") || too_deep) {
    source_.error(at, "this is not understood inside a backquote");
    writer_.emit_constant(kNil);
  } else {
    backquoted_list(at);
  }
  compiler_.shallower();
}

// Runs of plain items become lists; with the spliced ones between them they are appended. A tail
// `. ,x` is read as the two items `comma x`.
void DataForms::backquoted_list(NodeIndex at) {
  std::vector<NodeIndex> items = source_.children(at);
  const bool comma_tail = !source_.node(at).dotted && items.size() > 2 &&
                          source_.symbol(items[items.size() - 2]) == "comma";
  if (comma_tail) items.erase(items.end() - 2);
  std::uint32_t pieces = 0;
  std::uint32_t plain = 0;
  const auto end_run = [&](Op op) {
    if (plain == 0) return;
    writer_.emit(op, 0, plain);
    plain = 0;
    ++pieces;
  };
  for (const NodeIndex item : items) {
    if (comma_tail && item == items.back()) {
      value(item);
      ++plain;
    } else if (source_.is_form(item, "comma-at")) {
      end_run(Op::kList);
      value(source_.children(item).back());
      ++pieces;
    } else {
      backquoted(item);
      ++plain;
    }
  }
  end_run(source_.node(at).dotted || comma_tail ? Op::kListStar : Op::kList);
  if (pieces != 1) writer_.emit_function("append", pieces);
}

void DataForms::function_form(NodeIndex /*form*/, Parts parts) {
  compiler_.function_value(parts[1]);
}

void DataForms::lambda_form(NodeIndex form, Parts parts) { compiler_.lambda(form, parts); }

void DataForms::call_form(NodeIndex at, Parts parts) { compiler_.form(at, parts.subspan(1)); }

// Values are never evaluated again, but a quoted expression is one.
void DataForms::eval_form(NodeIndex /*form*/, Parts parts) {
  const std::vector<NodeIndex> inside = source_.children(parts[1]);
  const bool expression =
      source_.is_form(parts[1], "quote") && inside.size() == 2 && source_.node(inside[1]).list;
  value(expression ? inside[1] : parts[1]);
}

void DataForms::funcall_form(NodeIndex /*form*/, Parts parts) {
  const std::vector<NodeIndex> inside = source_.children(parts[1]);
  const bool named = source_.is_form(parts[1], "quote") && inside.size() == 2 &&
                     source_.is_symbol(inside[1]) &&
                     !source_.datum_atom(inside[1]).is(TermKind::kSlot);
  if (named) {
    compiler_.function_value(inside[1]);
  } else {
    value(parts[1]);
  }
  for (const NodeIndex at : parts.subspan(2)) value(at);
  writer_.emit(Op::kFuncall, 0, static_cast<std::uint32_t>(parts.size() - 2));
}

}  // namespace skein::htn::lisp
