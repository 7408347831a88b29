// SPDX-License-Identifier: Apache-2.0
// The items a domain may have from PDDL: actions, derived predicates, declarations.
#include <algorithm>

#include "language/condition_checker.hpp"
#include "language/domain_reader.hpp"
#include "language/effect_checker.hpp"
#include "language/typed_list.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::htn {

// Every typed list in an expression: what stands behind a '-' in a list is a type only where lists
// are typed, so these are looked for where they belong.
namespace {

void take_types(const std::vector<TypedName>& names, std::vector<Expression>& types) {
  for (const TypedName& name : names)
    types.insert(types.end(), name.types.begin(), name.types.end());
}

}  // namespace

void DomainReader::read_action(Expression item) {
  const std::vector<Expression> all = parts(item);
  if (all.size() < 2 || !context_.is_name(all[1]) || (*item).dotted) {
    return context_.error(item, "an action without a name",
                          "(:action name :parameters (…) :precondition … :effect …)");
  }
  const std::size_t before = context_.errors.size();
  const Words& words = context_.words;
  OperatorDefinition made;
  made.action = true;
  made.head = all[1];
  domain_.pddl = true;
  read_keys(context_, all, 2,
            {{words.parameters, &made.parameters},
             {words.precondition, &made.precondition},
             {words.effect, &made.effect},
             {words.cost, &made.cost}});
  const Term name = operator_name(made, context_.store);
  if (!operator_names_.insert(name.bits()).second) {
    context_.error(made.head, "a second operator '" + context_.name(name) + "'",
                   "one operator or action of a name");
  }
  if (made.parameters) {
    take_types(read_typed_list(context_, made.parameters, TypedNames::kVariables), used_types_);
  }
  check_action(made);
  if (context_.errors.size() == before) domain_.operators.push_back(made);
}

void DomainReader::check_action(const OperatorDefinition& made) const {
  if (made.precondition) ConditionChecker(context_).check(made.precondition);
  EffectChecker(context_).check_effect(made.effect);
}

void DomainReader::read_derived(Expression item) {
  const std::vector<Expression> all = parts(item);
  if (all.size() != 3 || (*item).dotted) {
    return context_.error(item, "a derived predicate of " + counted(all.size() - 1, "part"),
                          "(:derived (predicate ?variable - type …) condition)");
  }
  AxiomDefinition made;
  made.derived = true;
  made.head = all[1];
  if (!check_head(made.head, "a derived predicate")) return;
  const std::size_t before = context_.errors.size();
  const Expression arguments = next(first(made.head));
  if (arguments) {
    take_types(read_typed_list(context_, made.head, TypedNames::kVariables, arguments),
               used_types_);
  }
  ConditionChecker(context_).check(all[2]);
  BranchDefinition tail;
  tail.label = context_.name(first(made.head)) + "-1";
  tail.precondition = all[2];
  made.tails.push_back(std::move(tail));
  if (context_.errors.size() == before) domain_.axioms.push_back(std::move(made));
}

void DomainReader::read_types(Expression item) {
  const Expression begin = next(first(item));
  if (!begin) return;
  for (const TypedName& type : read_typed_list(context_, item, TypedNames::kNames, begin)) {
    const Term name = (*type.name).atom;
    if (type.types.empty()) domain_.types.push_back({name, kNil});
    for (const Expression super : type.types) domain_.types.push_back({name, (*super).atom});
  }
}

void DomainReader::check_types() const {
  for (const Expression type : used_types_) check_type(type);
}

// A type that only ever stands as a super is declared by that. Without any :types the type is
// whatever predicate of that name the problem has.
void DomainReader::check_type(Expression type) const {
  const Term name = (*type).atom;
  const Words& words = context_.words;
  if (domain_.types.empty() || name == words.object || name == words.number) return;
  std::vector<std::string> known = {"object"};
  for (const TypeDefinition& declared : domain_.types) {
    if (declared.name == name || declared.super == name) return;
    known.push_back(context_.name(declared.name));
  }
  context_.error(type, "unknown type '" + context_.name(type) + "'", "a type of :types",
                 nearest_name(context_.name(type), known));
}

void DomainReader::read_predicates(Expression item) {
  const bool functions = context_.head(item) == context_.words.functions;
  for (Expression at = next(first(item)); at; at = next(at)) {
    if (functions && context_.is_symbol(at) && (*at).atom == context_.words.dash && next(at)) {
      at = next(at);
      continue;
    }
    const Expression name = first(at);
    if (!name || !context_.is_name(name)) {
      context_.error(at, text_of(at) + " is no declaration", "(name ?variable - type …)");
      continue;
    }
    if (functions) domain_.functions.push_back((*name).atom);
    if (next(name)) {
      take_types(read_typed_list(context_, at, TypedNames::kVariables, next(name)), used_types_);
    }
  }
}

void DomainReader::read_constants(Expression item) {
  const Expression begin = next(first(item));
  if (begin) take_types(read_typed_list(context_, item, TypedNames::kNames, begin), used_types_);
}

}  // namespace skein::htn
