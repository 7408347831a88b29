// SPDX-License-Identifier: Apache-2.0
#include "lisp/program.hpp"

#include <algorithm>
#include <any>
#include <memory>

#include "lisp/builtins.hpp"
#include "lisp/compiler.hpp"

namespace skein::htn::lisp {

std::string count_text(std::size_t least, std::size_t most) {
  const auto plural = [](std::size_t count) { return count == 1 ? " argument" : " arguments"; };
  const std::string low = std::to_string(least);
  if (most == kAnyCount) return least == 0 ? "any arguments" : "at least " + low + plural(least);
  if (least == most) return least == 0 ? "no arguments" : low + plural(least);
  return low + " to " + std::to_string(most) + " arguments";
}

ArgumentCount argument_count(const TermStore& store, const FunctionDefinition& definition) {
  ArgumentCount count;
  if (!definition.parameters) return count;
  const Document& document = *definition.parameters.document;
  bool optional = false;
  for (const NodeIndex at : children(document, definition.parameters.node)) {
    const Node& node = document[at];
    const bool named = !node.list && node.atom.is(TermKind::kSymbol);
    const std::string_view name = named ? store.name(node.atom) : std::string_view{};
    if (name.starts_with('&')) {
      optional = true;
      if (name != "&optional") count.most = kAnyCount;
    } else if (count.most != kAnyCount) {
      ++count.most;
      if (!optional) ++count.least;
    }
  }
  return count;
}

Program::Program(TermStore& terms, const Functions& host,
                 const std::vector<FunctionDefinition>& defined)
    : store_(terms), host_(host) {
  for (const std::string& name : host.names()) {
    Callable callable;
    callable.name = name;
    callable.host = host.find(name);
    add_callable(std::move(callable), store_.symbol(name));
  }
  // The last definition of a name counts, as when Lisp loads the file.
  for (auto at = defined.rbegin(); at != defined.rend(); ++at) {
    definitions_.push_back(*at);
    if (at->variable) {
      variables_.emplace(store_.symbol(at->name), &definitions_.back());
      continue;
    }
    Callable callable;
    callable.name = at->name;
    callable.definition = &definitions_.back();
    add_callable(std::move(callable), store_.symbol(at->name));
  }
}

// The first function of a name counts; those that are built in come before all others, and are
// added when they are asked for.
void Program::add_callable(Callable callable, Term name) {
  if (callable.builtin == nullptr && builtin_of(store_.name(name)) != nullptr) return;
  const auto index = static_cast<std::uint32_t>(callables_.size());
  if (by_name_.emplace(name, index).second) callables_.push_back(std::move(callable));
}

std::optional<std::uint32_t> Program::find(Term name) {
  const auto at = by_name_.find(name);
  if (at != by_name_.end()) return at->second;
  const Builtin* builtin = builtin_of(store_.name(name));
  if (builtin == nullptr) return std::nullopt;
  Callable callable;
  callable.name = builtin->name;
  callable.builtin = builtin;
  add_callable(std::move(callable), name);
  return by_name_.at(name);
}

std::optional<std::uint32_t> Program::global(Term name) {
  const auto known = global_by_name_.find(name);
  if (known != global_by_name_.end()) return known->second;
  const std::string_view text = store_.name(name);
  const auto defined = variables_.find(name);
  const bool starred = text.size() > 2 && text.front() == '*' && text.back() == '*';
  if (!starred && defined == variables_.end()) return std::nullopt;
  const auto made = static_cast<std::uint32_t>(globals_.size());
  globals_.push_back({name, defined == variables_.end() ? nullptr : defined->second, {}});
  global_by_name_.emplace(name, made);
  pending_globals_.push_back(made);
  return made;
}

void Program::compile_first_value(Global& global, Diagnostics& errors) {
  static const SlotOf kNoSlots;
  if (global.definition == nullptr || global.definition->body.empty()) return;
  const Expression& value = global.definition->body.front();
  Compiler compiler(*this, *value.document, kNoSlots, errors);
  compiler.expression(value.node);
  global.first_value = add_unit(compiler.finish(global.definition->name));
}

std::vector<std::string> Program::function_names() const {
  std::vector<std::string> names;
  for (const std::span<const Builtin> table : all_builtins()) {
    for (const Builtin& builtin : table) names.emplace_back(builtin.name);
  }
  for (const Callable& callable : callables_) {
    if (callable.builtin == nullptr) names.push_back(callable.name);
  }
  return names;
}

void Program::want(std::uint32_t callable) {
  const Callable& wanted = callables_[callable];
  if (wanted.definition != nullptr && wanted.unit == nullptr) pending_.push_back(callable);
}

void Program::compile_pending(Diagnostics& errors) {
  static const SlotOf kNoSlots;
  while (!pending_.empty() || !pending_globals_.empty()) {
    if (!pending_globals_.empty()) {
      const std::uint32_t global = pending_globals_.back();
      pending_globals_.pop_back();
      compile_first_value(globals_[global], errors);
      continue;
    }
    Callable& callable = callables_[pending_.back()];
    pending_.pop_back();
    if (callable.unit != nullptr) continue;
    const FunctionDefinition& definition = *callable.definition;
    const std::size_t before = errors.size();
    const Document* document = definition.parameters     ? definition.parameters.document
                               : definition.body.empty() ? nullptr
                                                         : definition.body.front().document;
    Unit unit;
    unit.name = callable.name;
    if (document != nullptr) {
      Compiler compiler(*this, *document, kNoSlots, errors);
      compiler.definition(definition);
      unit = compiler.finish(callable.name);
    }
    unit.broken = document == nullptr || errors.size() != before;
    callable.unit = &this->unit(add_unit(std::move(unit)));
  }
}

std::uint32_t Program::add_unit(Unit unit) {
  units_.push_back(std::move(unit));
  return static_cast<std::uint32_t>(units_.size() - 1);
}

Term Program::function_object(std::uint32_t unit) {
  const auto known = objects_.find(unit);
  if (known != objects_.end()) return known->second;
  auto reference = std::make_shared<const std::any>(UnitReference{this, unit});
  const Term object = store_.object(std::move(reference), "function");
  objects_.emplace(unit, object);
  return object;
}

std::optional<std::uint32_t> Program::unit_of(Term object) const {
  if (!object.is(TermKind::kObject)) return std::nullopt;
  const auto* reference = std::any_cast<UnitReference>(&store_.host_value(object));
  if (reference == nullptr || reference->program != this) return std::nullopt;
  return reference->unit;
}

}  // namespace skein::htn::lisp
