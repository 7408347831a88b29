// SPDX-License-Identifier: Apache-2.0
#include "lisp/patterns.hpp"

#include <vector>

namespace skein::htn::lisp {

void Patterns::parameters(NodeIndex list) {
  if (!source_.node(list).list || source_.node(list).dotted) {
    if (source_.node(list).list || source_.node(list).atom != kNil)
      source_.error(list, "malformed parameters", "a list");
    return;
  }
  std::vector<NodeIndex> required;
  std::vector<NodeIndex> optional;
  std::vector<NodeIndex> rest;
  std::vector<NodeIndex>* kind = &required;
  for (const NodeIndex at : source_.children(list)) {
    if (source_.symbol(at) == "&optional") {
      kind = &optional;
    } else if (source_.symbol(at) == "&rest" || source_.symbol(at) == "&body") {
      kind = &rest;
    } else if (source_.is_marker(at) || rest.size() == 1) {
      source_.error(at, "parameters of this kind are not supported",
                    "&optional, and &rest with one name");
    } else {
      kind->push_back(at);
    }
  }
  writer_.set_parameters(required.size(), optional.size(), !rest.empty());
  std::uint32_t local = 0;
  for (const NodeIndex at : required) scope_.declare(at, local++);
  for (const NodeIndex at : optional) optional_parameter(at, local++);
  if (!rest.empty()) scope_.declare(rest.front(), local);
}

void Patterns::optional_parameter(NodeIndex at, std::uint32_t index) {
  if (!source_.node(at).list) {
    scope_.declare(at, index);
    return;
  }
  const std::vector<NodeIndex> parts = source_.children(at);
  if (parts.empty() || parts.size() > 2) {
    source_.error(at, "malformed optional parameter", "name or (name default)");
    return;
  }
  if (parts.size() == 2) {
    const std::size_t given = writer_.emit(Op::kJumpIfGiven, 0, index);
    compiler_.value(parts[1]);
    writer_.set_hidden(index);
    writer_.patch(given);
  }
  scope_.declare(parts[0], index);
}

void Patterns::copy_local(std::uint32_t from, NodeIndex to) {
  writer_.emit(Op::kLocal, from);
  bind(to);
}

// The value on the stack goes into the variables of the pattern: a name, or a list of patterns.
void Patterns::bind(NodeIndex at) {
  if (source_.is_symbol(at) && source_.node(at).atom != kNil) {
    scope_.bind(at);
    return;
  }
  if (!source_.node(at).list) {
    source_.error(at, "this cannot be a pattern", "variables and lists of them");
    writer_.emit(Op::kPop);
    return;
  }
  const std::uint32_t source = writer_.new_local();
  writer_.set_hidden(source);
  if (!compiler_.deeper()) {
    source_.error(at, "pattern nested too deeply");
  } else {
    list(at, source);
  }
  compiler_.shallower();
}

void Patterns::list(NodeIndex at, std::uint32_t source) {
  const std::vector<NodeIndex> all = source_.children(at);
  bool optional = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool last = i + 1 == all.size();
    if (source_.symbol(all[i]) == "&optional") {
      optional = true;
    } else if ((last && source_.node(at).dotted) ||
               (i > 0 && source_.is_marker(all[i - 1]) && !optional)) {
      copy_local(source, all[i]);
      return;
    } else if (source_.symbol(all[i]) == "&rest" || source_.symbol(all[i]) == "&body") {
      optional = false;
    } else if (source_.is_marker(all[i])) {
      source_.error(all[i], "patterns of this kind are not supported", "&optional or &rest");
    } else if (optional) {
      optional_item(all[i], source);
    } else {
      next_item(source);
      bind(all[i]);
    }
  }
  writer_.emit(Op::kLocal, source);
  writer_.emit_constant(kNil);
  writer_.emit_function("destructuring-bind", 2);
  writer_.emit(Op::kPop);
}

// Pushes the first item of what is left of the list, and goes on to the next.
void Patterns::next_item(std::uint32_t source) {
  writer_.emit(Op::kLocal, source);
  writer_.emit_function("destructuring-bind", 1);
  writer_.emit(Op::kLocal, source);
  writer_.emit_function("cdr", 1);
  writer_.set_hidden(source);
}

void Patterns::optional_item(NodeIndex at, std::uint32_t source) {
  const std::vector<NodeIndex> parts = source_.children(at);
  writer_.emit(Op::kLocal, source);
  const std::size_t missing = writer_.emit(Op::kJumpIfNil);
  next_item(source);
  const std::size_t done = writer_.emit(Op::kJump);
  writer_.patch(missing);
  writer_.drop();
  if (source_.node(at).list && parts.size() > 1) {
    compiler_.value(parts[1]);
  } else {
    writer_.emit_constant(kNil);
  }
  writer_.patch(done);
  bind(source_.node(at).list && !parts.empty() ? parts[0] : at);
}

}  // namespace skein::htn::lisp
