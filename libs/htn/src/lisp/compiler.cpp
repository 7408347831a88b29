// SPDX-License-Identifier: Apache-2.0
#include "lisp/compiler.hpp"

#include <numbers>

#include "lisp/forms.hpp"
#include "lisp/patterns.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::htn::lisp {

namespace {

// Values of SBCL, the Lisp of SHOP3.
std::optional<Number> named_constant(std::string_view name) {
  constexpr std::int64_t kMostPositiveFixnum = (std::int64_t{1} << 62) - 1;
  if (name == "pi") return real(std::numbers::pi);
  if (name == "most-positive-fixnum") return integer(kMostPositiveFixnum);
  if (name == "most-negative-fixnum") return integer(-kMostPositiveFixnum - 1);
  return std::nullopt;
}

}  // namespace

Compiler::Compiler(Program& program, const Document& document, const SlotOf& slot_of,
                   Diagnostics& errors)
    : program_(program),
      source_(program, document, slot_of, errors),
      writer_(program, document),
      scope_(program, source_, writer_) {}

Compiler::Compiler(Compiler& outer, NodeIndex place)
    : program_(outer.program_),
      source_(outer.source_),
      writer_(outer.program_, outer.source_.document()),
      scope_(outer.scope_, source_, writer_),
      nesting_(outer.nesting_) {
  writer_.set_place(place);
}

void Compiler::value(NodeIndex at) {
  const NodeIndex outer_place = writer_.place();
  writer_.set_place(at);
  if (!deeper()) {
    if (nesting_ == kNestingLimit + 1) source_.error(at, "expression nested too deeply");
    writer_.emit_constant(kNil);
  } else if (source_.node(at).list) {
    list(at);
  } else {
    atom(at);
  }
  shallower();
  writer_.set_place(outer_place);
}

void Compiler::atom(NodeIndex at) {
  const Term term = source_.node(at).atom;
  if (!term.is(TermKind::kSymbol)) {
    writer_.emit_constant(term);
    return;
  }
  if (const auto variable = scope_.find(term)) {
    scope_.read(*variable);
    return;
  }
  if (const auto global = term == kNil ? std::nullopt : program_.global(term)) {
    writer_.emit_global(*global, term);
    return;
  }
  const auto constant = named_constant(source_.symbol(at));
  writer_.emit_constant(constant ? program_.store().number(*constant) : source_.datum_atom(at));
}

void Compiler::list(NodeIndex at) {
  const std::vector<NodeIndex> parts = source_.children(at);
  if (parts.empty()) {
    writer_.emit_constant(kNil);
  } else if (source_.node(at).dotted) {
    source_.error(at, "a dotted list has no value",
                  "a function and its arguments, or a quoted list");
    writer_.emit_constant(kNil);
  } else {
    form(at, parts);
  }
}

void Compiler::form(NodeIndex at, Parts parts) {
  NodeIndex head = parts.front();
  if (source_.is_form(head, "quote") || source_.is_form(head, "function")) {
    const std::vector<NodeIndex> inside = source_.children(head);
    if (inside.size() == 2) head = inside[1];
  }
  if (source_.is_form(head, "lambda")) {
    lambda(head, source_.children(head));
    for (const NodeIndex argument : parts.subspan(1)) value(argument);
    writer_.emit(Op::kFuncall, 0, static_cast<std::uint32_t>(parts.size() - 1));
    return;
  }
  if (!source_.is_symbol(head)) {
    source_.error(head, "this is not the name of a function",
                  "a function name or a lambda expression");
    writer_.emit_constant(kNil);
    return;
  }
  const Form* special = find_form(source_.symbol(head));
  if (special == nullptr) {
    named_call(head, parts);
    return;
  }
  const std::size_t before = source_.errors().size();
  source_.check_count(at, source_.symbol(head), parts.size() - 1, special->least, special->most);
  if (source_.errors().size() != before) {
    writer_.emit_constant(kNil);
    return;
  }
  special->compile(*this, at, parts);
}

void Compiler::named_call(NodeIndex head, Parts parts) {
  const auto count = static_cast<std::uint32_t>(parts.size() - 1);
  for (const NodeIndex argument : parts.subspan(1)) value(argument);
  const auto index = program_.find(source_.node(head).atom);
  if (index) {
    check_arguments(head, program_.callable(*index), count);
    program_.want(*index);
    writer_.emit(Op::kCall, *index, count);
    return;
  }
  unknown_function(head, source_.symbol(head));
  writer_.emit(Op::kList, 0, count);
}

void Compiler::unknown_function(NodeIndex at, std::string_view name) {
  std::vector<std::string> known = program_.function_names();
  const std::vector<std::string> forms = form_names();
  known.insert(known.end(), forms.begin(), forms.end());
  source_.error(at, "unknown function '" + std::string(name) + "'", {}, nearest_name(name, known));
}

void Compiler::check_arguments(NodeIndex at, const Callable& callable, std::size_t given) {
  if (callable.builtin != nullptr) {
    source_.check_count(at, callable.name, given, callable.builtin->least, callable.builtin->most);
  } else if (callable.host != nullptr) {
    source_.check_count(at, callable.name, given, callable.host->least_arguments,
                        callable.host->most_arguments);
  } else if (callable.definition != nullptr) {
    const ArgumentCount count = argument_count(program_.store(), *callable.definition);
    source_.check_count(at, callable.name, given, count.least, count.most);
  }
  if (callable.unit != nullptr && callable.unit->broken) {
    source_.error(at, "function '" + callable.name + "' has errors");
  }
}

void Compiler::body(Parts parts) {
  if (parts.empty()) writer_.emit_constant(kNil);
  for (std::size_t at = 0; at < parts.size(); ++at) {
    if (at > 0) writer_.emit(Op::kPop);
    value(parts[at]);
  }
}

void Compiler::expression(NodeIndex at) {
  scope_.note_assignments(at);
  value(at);
}

void Compiler::call(NodeIndex at) {
  scope_.note_assignments(at);
  writer_.set_place(at);
  const std::vector<NodeIndex> parts = source_.children(at);
  if (parts.size() < 2) {
    source_.error(at, "a call without function", "(call function arguments)");
    writer_.emit_constant(kNil);
    return;
  }
  form(at, Parts(parts).subspan(1));
}

void Compiler::definition(const FunctionDefinition& definition) {
  if (definition.parameters) scope_.note_assignments(definition.parameters.node);
  std::vector<NodeIndex> parts;
  for (const Expression& expression : definition.body) {
    if (expression.document != &source_.document()) continue;
    scope_.note_assignments(expression.node);
    parts.push_back(expression.node);
  }
  if (definition.parameters) {
    writer_.set_place(definition.parameters.node);
    Patterns(*this).parameters(definition.parameters.node);
  }
  writer_.begin_block(program_.store().symbol(definition.name));
  body(parts);
  writer_.end_block();
}

void Compiler::task_template(NodeIndex at) {
  if (nesting_ == 0) scope_.note_assignments(at);
  if (source_.is_form(at, "call")) {
    value(at);
    return;
  }
  if (!source_.contains_call(at)) {
    quoted(at);
    return;
  }
  if (!deeper()) {
    source_.error(at, "task nested too deeply");
    writer_.emit_constant(kNil);
  } else {
    const std::vector<NodeIndex> items = source_.children(at);
    for (const NodeIndex item : items) task_template(item);
    writer_.emit(source_.node(at).dotted ? Op::kListStar : Op::kList, 0,
                 static_cast<std::uint32_t>(items.size()));
  }
  shallower();
}

void Compiler::function(NodeIndex at) {
  scope_.note_assignments(at);
  writer_.set_place(at);
  if (source_.is_symbol(at) && !source_.datum_atom(at).is(TermKind::kSlot)) {
    function_value(at);
    return;
  }
  const std::vector<NodeIndex> parts = source_.children(at);
  if (source_.is_form(at, "quote") && parts.size() == 2) {
    function_value(parts[1]);
    return;
  }
  value(at);
}

void Compiler::function_value(NodeIndex at) {
  if (source_.is_form(at, "lambda")) {
    lambda(at, source_.children(at));
    return;
  }
  const auto index = source_.is_symbol(at) ? program_.find(source_.node(at).atom) : std::nullopt;
  if (index) {
    program_.want(*index);
  } else if (source_.is_symbol(at)) {
    unknown_function(at, source_.symbol(at));
  } else {
    source_.error(at, "this designates no function", "a function name or a lambda expression");
  }
  writer_.emit_constant(source_.is_symbol(at) ? source_.node(at).atom : kNil);
}

void Compiler::lambda(NodeIndex at, Parts parts) {
  if (parts.size() < 2) {
    source_.error(at, "a lambda without parameters", "(lambda (parameters) body)");
    writer_.emit_constant(kNil);
    return;
  }
  Compiler inner(*this, at);
  Patterns(inner).parameters(parts[1]);
  inner.body(parts.subspan(2));
  const std::uint32_t unit = program_.add_unit(inner.finish("lambda"));
  writer_.emit(Op::kClosure, unit);
}

}  // namespace skein::htn::lisp
