// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/domain.hpp"

#include <algorithm>
#include <array>

#include "compile/condition_compiler.hpp"
#include "compile/network_compiler.hpp"
#include "language/read_context.hpp"

namespace skein::htn {

namespace {

class DomainCompiler {
 public:
  DomainCompiler(CompiledDomain& domain, const DomainDefinition& definition, Diagnostics& errors)
      : domain_(domain), definition_(definition), conditions_(domain, errors) {}

  void compile() {
    if (definition_.pddl) add_equality();
    domain_.fluents = definition_.functions;
    for (const AxiomDefinition& axiom : definition_.axioms) add_axiom(axiom);
    // SHOP3 has the axioms of types after those of the text, the last type first.
    for (auto type = definition_.types.rbegin(); type != definition_.types.rend(); ++type) {
      add_type(*type);
    }
    add_nothing();
    for (const OperatorDefinition& operation : definition_.operators) add_operator(operation);
    for (const MethodDefinition& method : definition_.methods) add_method(method);
    for (Goal& goal : domain_.goals) link_axioms(domain_, goal);
    mark_logical(domain_);
  }

 private:
  Term slot(std::uint32_t index) const { return {TermKind::kSlot, index}; }
  Term atom(std::string_view name, std::initializer_list<Term> arguments) {
    std::vector<Term> items{domain_.store.symbol(name)};
    items.insert(items.end(), arguments);
    return domain_.store.list(items);
  }

  // PDDL: (= ?x ?x) holds.
  void add_equality() {
    Axiom axiom;
    axiom.head = atom("=", {slot(0), slot(0)});
    axiom.slots = 1;
    axiom.names = {domain_.store.symbol("?x")};
    flat_arguments(domain_.store, axiom.head, axiom.items);
    axiom.tails.emplace_back();
    domain_.axioms[domain_.store.symbol("=")].push_back(std::move(axiom));
  }

  void add_type(const TypeDefinition& type) {
    if (type.super == kNil) return;
    Axiom axiom;
    const std::array<Term, 2> head{type.super, slot(0)};
    const std::array<Term, 2> body{type.name, slot(0)};
    axiom.head = domain_.store.list(head);
    axiom.slots = 1;
    axiom.names = {domain_.store.symbol("?x")};
    flat_arguments(domain_.store, axiom.head, axiom.items);
    domain_.goals.push_back(atom_goal(domain_.store, domain_.store.list(body), {}));
    AxiomTail tail;
    tail.goals = {static_cast<GoalIndex>(domain_.goals.size() - 1)};
    axiom.tails.push_back(std::move(tail));
    domain_.axioms[type.super].push_back(std::move(axiom));
  }

  void add_axiom(const AxiomDefinition& definition) {
    Axiom axiom;
    ClauseScope scope(domain_.store);
    std::vector<GoalIndex> types;
    axiom.head = definition.derived ? typed_head(definition.head, scope, types)
                                    : conditions_.pattern(definition.head, scope);
    for (const BranchDefinition& tail : definition.tails) {
      axiom.tails.push_back(conditions_.tail(tail, scope));
    }
    if (axiom.tails.empty()) axiom.tails.emplace_back();
    for (AxiomTail& tail : axiom.tails) {
      tail.goals.insert(tail.goals.begin(), types.begin(), types.end());
    }
    scope.finish(axiom);
    domain_.axioms[domain_.store.car(axiom.head)].push_back(std::move(axiom));
  }

  // (:derived (name ?variable - type …) …): the types become goals before those of the body.
  Term typed_head(Expression head, ClauseScope& scope, std::vector<GoalIndex>& types) {
    std::vector<Term> variables;
    types = conditions_.type_goals(head, scope, variables);
    std::vector<Term> items{(*first(head)).atom};
    for (const Term variable : variables) items.push_back(slot(scope.slot(variable)));
    return domain_.store.list(items);
  }

  // The step of an empty reduction: it does nothing, costs nothing and is left out of plans.
  void add_nothing() {
    Operator nothing;
    nothing.head = atom("!!inop", {});
    nothing.fixed_cost = integer(0);
    domain_.operators.emplace(domain_.store.symbol("!!inop"), std::move(nothing));
  }

  void add_operator(const OperatorDefinition& definition) {
    Operator operation;
    operation.where = definition.head;
    ClauseScope scope(domain_.store);
    if (definition.action) {
      compile_action(definition, scope, operation);
    } else {
      operation.head = conditions_.pattern(definition.head, scope);
      operation.precondition = conditions_.condition(definition.precondition, scope);
      operation.deletions = effects(definition.deletions, scope);
      operation.additions = effects(definition.additions, scope);
    }
    compile_cost(definition.cost, scope, operation);
    scope.finish(operation);
    const Term name = domain_.store.car(operation.head);
    domain_.operators.insert_or_assign(name, std::move(operation));
  }

  void compile_action(const OperatorDefinition& definition, ClauseScope& scope,
                      Operator& operation) {
    operation.action = true;
    std::string name(domain_.store.name((*definition.head).atom));
    if (!name.starts_with('!')) name.insert(name.begin(), '!');
    std::vector<Term> head{domain_.store.symbol(name)};
    std::vector<Term> variables;
    for (const Expression part : parts(definition.parameters)) {
      const Term word = (*part).atom;
      if (is_variable(domain_.store, word)) head.push_back(slot(scope.slot(word)));
    }
    operation.head = domain_.store.list(head);
    operation.precondition =
        conditions_.typed_condition(definition.parameters, definition.precondition, scope);
    operation.effect.kind = EffectKind::kGroup;  // an action without effects has an empty one
    if (definition.effect) operation.effect = action_effect(definition.effect, scope);
  }

  void compile_cost(Expression cost, ClauseScope& scope, Operator& operation) {
    if (!cost) return;
    const Node& node = *cost;
    if (!node.list && node.atom.is(TermKind::kNumber)) {
      operation.fixed_cost = domain_.store.value(node.atom);
    } else {
      operation.cost = conditions_.code(cost, scope);
    }
  }

  std::string_view head_of(Expression expression) const {
    const Expression head = first(expression);
    if (!head || !(*head).atom.is(TermKind::kSymbol) || (*head).list) return {};
    return domain_.store.name((*head).atom);
  }

  // An add or delete list: atoms, or a variable that will hold such a list, or one atom.
  std::vector<Effect> effects(Expression list, ClauseScope& scope) {
    std::vector<Effect> out;
    if (!list) return out;
    const Node& node = *list;
    if (!node.list) {
      if (node.atom == kNil) return out;
      Effect effect;
      effect.kind = EffectKind::kList;
      effect.pattern = conditions_.pattern(list, scope);
      return {effect};
    }
    if (!head_of(list).empty() && !head_of(list).starts_with('?')) return {effect_of(list, scope)};
    for (const Expression part : parts(list)) {
      const bool nothing = (*part).list ? !first(part) : (*part).atom == kNil;
      if (!nothing) out.push_back(effect_of(part, scope));
    }
    return out;
  }

  Effect effect_of(Expression expression, ClauseScope& scope) {
    Effect effect;
    const std::string_view name = head_of(expression);
    const std::vector<Expression> all = parts(expression);
    if (name == ":protection" && all.size() == 2) {
      effect.kind = EffectKind::kProtection;
      effect.pattern = conditions_.pattern(all[1], scope);
      effect.flat = flat_arguments(domain_.store, effect.pattern, effect.arguments);
    } else if ((name == "forall" || name == "shop-forall") && all.size() == 4) {
      return quantified_effect(all, scope);
    } else {
      effect.pattern = conditions_.pattern(expression, scope);
      effect.flat = flat_arguments(domain_.store, effect.pattern, effect.arguments);
    }
    return effect;
  }

  Effect quantified_effect(const std::vector<Expression>& all, ClauseScope& scope) {
    Effect effect;
    effect.kind = EffectKind::kForall;
    scope.hide(all[1]);
    effect.condition = bounds(conditions_.condition(all[2], scope), all[2]);
    effect.parts = effects(all[3], scope);
    scope.reveal();
    return effect;
  }

  ConditionIndex bounds(ConditionIndex condition, Expression where) {
    return condition == kAbsent ? conditions_.add_condition({}, where) : condition;
  }

  // PDDL effects: and, not, when, forall with a typed list, atoms.
  Effect action_effect(Expression expression, ClauseScope& scope) {
    Effect effect;
    const std::string_view name = head_of(expression);
    const std::vector<Expression> all = parts(expression);
    if (std::optional<Effect> change = conditions_.fluent_effect(expression, scope)) return *change;
    const bool list = !all.empty() && (*all.front()).list;  // ((p) (not (q))): without the `and`
    if (name == "and" || list || all.empty()) {
      effect.kind = EffectKind::kGroup;
      for (std::size_t at = list ? 0 : 1; at < all.size(); ++at) {
        effect.parts.push_back(action_effect(all[at], scope));
      }
    } else if (name == "not" && all.size() == 2) {
      effect.kind = EffectKind::kNegated;
      effect.parts.push_back(action_effect(all[1], scope));
    } else if (name == "when" && all.size() == 3) {
      effect.kind = EffectKind::kWhen;
      effect.condition = bounds(conditions_.condition(all[1], scope), all[1]);
      effect.parts.push_back(action_effect(all[2], scope));
    } else if (name == "forall" && all.size() >= 3) {
      effect = typed_forall(all, scope);
    } else {
      effect = effect_of(expression, scope);
    }
    return effect;
  }

  Effect typed_forall(const std::vector<Expression>& all, ClauseScope& scope) {
    Effect effect;
    effect.kind = EffectKind::kForall;
    scope.hide(all[1]);
    std::vector<Term> typed;
    effect.condition =
        conditions_.add_condition(conditions_.type_goals(all[1], scope, typed), all[1]);
    effect.parts.push_back(action_effect(all.back(), scope));
    scope.reveal();
    return effect;
  }

  void add_method(const MethodDefinition& definition) {
    Method method;
    ClauseScope scope(domain_.store);
    method.head = conditions_.pattern(definition.head, scope);
    for (const BranchDefinition& branch : definition.branches) {
      Branch compiled;
      compiled.label = branch.label;
      compiled.where = branch.precondition ? branch.precondition : definition.head;
      compiled.precondition = conditions_.condition(branch.precondition, scope);
      compile_network(branch.tasks, conditions_, domain_, scope, compiled);
      method.branches.push_back(std::move(compiled));
    }
    scope.finish(method);
    domain_.methods[domain_.store.car(method.head)].push_back(std::move(method));
  }

  CompiledDomain& domain_;
  const DomainDefinition& definition_;
  ConditionCompiler conditions_;
};

}  // namespace

Domain::Domain() = default;
Domain::~Domain() = default;

std::shared_ptr<Domain> Domain::compile(const DomainDefinition& definition,
                                        const std::vector<FunctionDefinition>& functions,
                                        const Functions& host, TermStore& store,
                                        Diagnostics& errors) {
  Diagnostics found;
  std::shared_ptr<Domain> domain(new Domain);
  domain->compiled_ = std::make_unique<CompiledDomain>(store, host, functions);
  domain->compiled_->name = definition.name;
  DomainCompiler(*domain->compiled_, definition, found).compile();
  errors.append(found);
  return found.empty() ? domain : nullptr;
}

const std::string& Domain::name() const { return compiled_->name; }
TermStore& Domain::store() const { return compiled_->store; }

}  // namespace skein::htn
