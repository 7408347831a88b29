// SPDX-License-Identifier: Apache-2.0
#include "lisp_compiler.hpp"

#include <algorithm>
#include <numbers>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::htn::lisp {

namespace {

// How much higher the stack is after an instruction that takes `count` values.
int growth(Op op, std::uint32_t count) {
  switch (op) {
    case Op::kConstant:
    case Op::kInstance:
    case Op::kSlot:
    case Op::kLocal:
    case Op::kBoxed:
    case Op::kGlobal:
    case Op::kClosure:
      return 1;
    case Op::kBox:
    case Op::kPop:
    case Op::kJumpIfNil:
    case Op::kJumpIfNilKeep:
    case Op::kJumpIfTrueKeep:
      return -1;
    case Op::kList:
    case Op::kListStar:
    case Op::kCall:
      return 1 - static_cast<int>(count);
    case Op::kFuncall:
      return -static_cast<int>(count);
    default:
      return 0;
  }
}

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
    : program_(program), document_(document), slot_of_(slot_of), errors_(errors) {
  unit_.document = &document;
}

Compiler::Compiler(Compiler& outer, const Document& document)
    : Compiler(outer.program_, document, outer.slot_of_, outer.errors_) {
  outer_ = &outer;
  assignments_ = outer.assignments_;
  place_ = outer.place_;
  nesting_ = outer.nesting_;
}

Unit Compiler::finish(std::string name) {
  emit(Op::kReturn);
  unit_.name = std::move(name);
  return std::move(unit_);
}

std::size_t Compiler::emit(Op op, std::uint32_t operand, std::uint32_t count) {
  unit_.code.push_back({op, operand, count, kNil, place_});
  const int change = growth(op, count);
  SKEIN_ENSURES(static_cast<int>(height_) + change >= 0);
  if (change < 0) height_ -= static_cast<std::uint32_t>(-change);
  if (change > 0) raise(static_cast<std::uint32_t>(change));
  return unit_.code.size() - 1;
}

void Compiler::raise(std::uint32_t by) {
  height_ += by;
  unit_.height = std::max(unit_.height, height_);
}

void Compiler::emit_constant(Term term) {
  if (term.is(TermKind::kSlot)) {
    emit(Op::kSlot, term.index());
    return;
  }
  const bool with_slots = (program_.store().content(term) & kHasSlot) != 0;
  emit(with_slots ? Op::kInstance : Op::kConstant);
  unit_.code.back().term = term;
}

void Compiler::emit_function(std::string_view builtin, std::uint32_t count) {
  const auto index = program_.find(program_.store().symbol(builtin));
  SKEIN_ENSURES(index.has_value());
  emit(Op::kCall, *index, count);
}

void Compiler::patch(std::size_t jump) { unit_.code[jump].operand = here(); }

std::string_view Compiler::symbol(NodeIndex index) const {
  return is_symbol(index) ? program_.store().name(node(index).atom) : std::string_view{};
}

bool Compiler::is_symbol(NodeIndex index) const {
  return !node(index).list && node(index).atom.is(TermKind::kSymbol);
}

bool Compiler::is_form(NodeIndex index, std::string_view head) const {
  const NodeIndex first = node(index).first_child;
  return node(index).list && first != kNoNode && symbol(first) == head;
}

void Compiler::error(NodeIndex at, std::string message, std::string expected, std::string nearest) {
  const Place place = place_of(document_, node(at).begin);
  errors_.add(clipped({document_.file,
                       place.line,
                       place.column,
                       {},
                       std::move(message),
                       std::move(expected),
                       std::move(nearest)}));
}

void Compiler::value(NodeIndex at) {
  const NodeIndex outer_place = place_;
  place_ = at;
  if (++nesting_ > kNestingLimit) {
    if (nesting_ == kNestingLimit + 1) error(at, "expression nested too deeply");
    emit_constant(kNil);
  } else if (node(at).list) {
    list(at);
  } else {
    atom(at);
  }
  --nesting_;
  place_ = outer_place;
}

void Compiler::atom(NodeIndex at) {
  const Term term = node(at).atom;
  if (!term.is(TermKind::kSymbol)) {
    emit_constant(term);
    return;
  }
  if (const auto variable = find(term)) {
    read(*variable);
    return;
  }
  if (const auto global = term == kNil ? std::nullopt : program_.global(term)) {
    emit(Op::kGlobal, *global);
    unit_.code.back().term = term;
    return;
  }
  const auto constant = named_constant(symbol(at));
  emit_constant(constant ? program_.store().number(*constant) : datum_atom(at));
}

void Compiler::list(NodeIndex at) {
  const std::vector<NodeIndex> parts = children(document_, at);
  if (parts.empty()) {
    emit_constant(kNil);
  } else if (node(at).dotted) {
    error(at, "a dotted list has no value", "a function and its arguments, or a quoted list");
    emit_constant(kNil);
  } else {
    form(at, parts);
  }
}

void Compiler::form(NodeIndex at, Parts parts) {
  NodeIndex head = parts.front();
  if (is_form(head, "quote") || is_form(head, "function")) {
    const std::vector<NodeIndex> inside = children(document_, head);
    if (inside.size() == 2) head = inside[1];
  }
  if (is_form(head, "lambda")) {
    lambda(head, children(document_, head));
    for (const NodeIndex argument : parts.subspan(1)) value(argument);
    emit(Op::kFuncall, 0, static_cast<std::uint32_t>(parts.size() - 1));
    return;
  }
  if (!is_symbol(head)) {
    error(head, "this is not the name of a function", "a function name or a lambda expression");
    emit_constant(kNil);
    return;
  }
  const Form* special = find_form(symbol(head));
  if (special == nullptr) {
    named_call(head, parts);
    return;
  }
  const std::size_t before = errors_.size();
  check_count(at, symbol(head), parts.size() - 1, special->least, special->most);
  if (errors_.size() != before) {
    emit_constant(kNil);
    return;
  }
  (this->*special->compile)(at, parts);
}

void Compiler::named_call(NodeIndex head, Parts parts) {
  const auto count = static_cast<std::uint32_t>(parts.size() - 1);
  for (const NodeIndex argument : parts.subspan(1)) value(argument);
  const auto index = program_.find(node(head).atom);
  if (index) {
    check_arguments(head, program_.callable(*index), count);
    program_.want(*index);
    emit(Op::kCall, *index, count);
    return;
  }
  unknown_function(head, symbol(head));
  emit(Op::kList, 0, count);
}

void Compiler::unknown_function(NodeIndex at, std::string_view name) {
  std::vector<std::string> known = program_.function_names();
  const std::vector<std::string> forms = form_names();
  known.insert(known.end(), forms.begin(), forms.end());
  error(at, "unknown function '" + std::string(name) + "'", {}, nearest_name(name, known));
}

void Compiler::check_count(NodeIndex at, std::string_view name, std::size_t given,
                           std::size_t least, std::size_t most) {
  if (given >= least && given <= most) return;
  error(at, "'" + std::string(name) + "' with " + count_text(given, given),
        count_text(least, most));
}

void Compiler::check_arguments(NodeIndex at, const Callable& callable, std::size_t given) {
  if (callable.builtin != nullptr) {
    check_count(at, callable.name, given, callable.builtin->least, callable.builtin->most);
  } else if (callable.host != nullptr) {
    check_count(at, callable.name, given, callable.host->least_arguments,
                callable.host->most_arguments);
  } else if (callable.definition != nullptr) {
    const ArgumentCount count = argument_count(program_.store(), *callable.definition);
    check_count(at, callable.name, given, count.least, count.most);
  }
  if (callable.unit != nullptr && callable.unit->broken) {
    error(at, "function '" + callable.name + "' has errors");
  }
}

void Compiler::body(Parts parts) {
  if (parts.empty()) emit_constant(kNil);
  for (std::size_t at = 0; at < parts.size(); ++at) {
    if (at > 0) emit(Op::kPop);
    value(parts[at]);
  }
}

void Compiler::expression(NodeIndex at) {
  note_assignments(at);
  value(at);
}

void Compiler::call(NodeIndex at) {
  note_assignments(at);
  place_ = at;
  const std::vector<NodeIndex> parts = children(document_, at);
  if (parts.size() < 2) {
    error(at, "a call without function", "(call function arguments)");
    emit_constant(kNil);
    return;
  }
  form(at, Parts(parts).subspan(1));
}

void Compiler::definition(const FunctionDefinition& definition) {
  if (definition.parameters) note_assignments(definition.parameters.node);
  std::vector<NodeIndex> parts;
  for (const Expression& expression : definition.body) {
    if (expression.document != &document_) continue;
    note_assignments(expression.node);
    parts.push_back(expression.node);
  }
  if (definition.parameters) {
    place_ = definition.parameters.node;
    parameters(definition.parameters.node);
  }
  begin_block(program_.store().symbol(definition.name));
  body(parts);
  end_block();
}

}  // namespace skein::htn::lisp
