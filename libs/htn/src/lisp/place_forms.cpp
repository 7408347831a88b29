// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "lisp/builtins.hpp"
#include "lisp/forms.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::htn::lisp {

void PlaceForms::set_form(NodeIndex form, Parts parts) {
  if (parts.size() % 2 == 0)
    source_.error(form, "a variable without value", "pairs of variable and value");
  if (parts.size() < 3) writer_.emit_constant(kNil);
  for (std::size_t at = 1; at + 1 < parts.size(); at += 2) {
    if (at > 1) writer_.emit(Op::kPop);
    if (source_.is_form(parts[at], "gethash") || source_.is_form(parts[at], "aref")) {
      set_element(parts[at], parts[at + 1]);
    } else {
      value(parts[at + 1]);
      scope_.assign(parts[at]);
    }
  }
}

// (setf (aref array index…) value): the arguments, then the value.
void PlaceForms::set_element(NodeIndex element, NodeIndex what) {
  const std::vector<NodeIndex> parts = source_.children(element);
  const bool table = source_.symbol(parts[0]) == "gethash";
  source_.check_count(element, source_.symbol(parts[0]), parts.size() - 1, table ? 2 : 1,
                      table ? 3 : kAnyCount);
  const std::size_t given = table ? std::min<std::size_t>(parts.size(), 3) : parts.size();
  for (std::size_t at = 1; at < given; ++at) value(parts[at]);
  value(what);
  const Builtin& setter = table ? hash_setter() : array_setter();
  const auto index = compiler_.program().find(store().symbol(setter.name));
  SKEIN_ENSURES(index.has_value());
  writer_.emit(Op::kCall, *index, static_cast<std::uint32_t>(given));
}

void PlaceForms::increment_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  if (parts.size() > 2) {
    value(parts[2]);
  } else {
    writer_.emit_constant(store().integer(1));
  }
  writer_.emit_function(source_.symbol(parts[0]) == "incf" ? "+" : "-", 2);
  scope_.assign(parts[1]);
}

void PlaceForms::push_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  value(parts[2]);
  writer_.emit_function(source_.symbol(parts[0]) == "push" ? "cons" : "adjoin", 2);
  scope_.assign(parts[2]);
}

void PlaceForms::pop_form(NodeIndex /*form*/, Parts parts) {
  value(parts[1]);
  writer_.emit_function("car", 1);
  value(parts[1]);
  writer_.emit_function("cdr", 1);
  scope_.assign(parts[1]);
  writer_.emit(Op::kPop);
}

}  // namespace skein::htn::lisp
