// SPDX-License-Identifier: Apache-2.0
// PDDL's numbers: comparisons of functions in conditions, and effects that change them. The value
// of a function is the fact (= (name argument…) value); a term with functions in it is compiled as
// one with variables in their places, which goals before it bind.
#include <algorithm>
#include <array>

#include "compile/condition_compiler.hpp"
#include "language/read_context.hpp"

namespace skein::htn {

namespace {

struct Operation {
  std::string_view name;
  std::string_view sign;  // empty: the new value alone
};

constexpr std::array<Operation, 5> kOperations{
    {{"assign", ""}, {"increase", "+"}, {"decrease", "-"}, {"scale-up", "*"}, {"scale-down", "/"}}};

std::string source(Expression expression) {
  const Node& node = *expression;
  return expression.document->text.substr(node.begin, node.end - node.begin);
}

bool symbol(const TermStore& store, Expression expression, std::string_view name) {
  return expression && !(*expression).list && (*expression).atom.is(TermKind::kSymbol) &&
         store.name((*expression).atom) == name;
}

}  // namespace

bool ConditionCompiler::names_fluent(Expression expression) const {
  const Expression head = first(expression);
  return head && !(*head).list &&
         std::find(domain_.fluents.begin(), domain_.fluents.end(), (*head).atom) !=
             domain_.fluents.end();
}

bool ConditionCompiler::compares_fluents(Expression expression, std::string_view name) const {
  constexpr std::array<std::string_view, 5> kComparisons{"<", "<=", "=", ">=", ">"};
  if (domain_.fluents.empty()) return false;
  if (std::find(kComparisons.begin(), kComparisons.end(), name) == kComparisons.end()) return false;
  std::vector<Expression> open{expression};
  while (!open.empty()) {
    const Expression at = open.back();
    open.pop_back();
    if (names_fluent(at)) return true;
    const std::vector<Expression> inner = parts(at);
    open.insert(open.end(), inner.begin(), inner.end());
  }
  return false;
}

// The variable that stands for the value of a function; a goal that binds it goes to `goals`.
Term ConditionCompiler::fluent_value(Expression fluent, ClauseScope& scope,
                                     std::vector<GoalIndex>& goals) {
  TermStore& store = domain_.store;
  const Term variable = store.symbol("?value-of-function-" + std::to_string(++made_variables_));
  const std::array<Term, 3> equation{store.symbol("="), pattern(fluent, scope),
                                     Term(TermKind::kSlot, scope.slot(variable))};
  Goal goal = atom_goal(store, store.list(equation), fluent);
  goal.facts_only = true;
  goals.push_back(add(std::move(goal)));
  return variable;
}

std::string ConditionCompiler::render(Expression expression, ClauseScope& scope,
                                      std::vector<GoalIndex>& goals) {
  if (names_fluent(expression)) {
    return std::string(domain_.store.name(fluent_value(expression, scope, goals)));
  }
  if (!(*expression).list) return source(expression);
  std::string out = "(";
  for (const Expression part : parts(expression)) out += render(part, scope, goals) + " ";
  return out + ")";
}

CodeIndex ConditionCompiler::made_code(std::string text, Expression where, ClauseScope& scope) {
  Diagnostics none;
  Document made = read_document(where.document->file, std::move(text), domain_.store, none);
  domain_.made_texts.push_back(std::move(made));
  const Document& document = domain_.made_texts.back();
  return code({&document, document.top.front()}, scope);
}

GoalIndex ConditionCompiler::fluent_comparison(Expression expression, ClauseScope& scope) {
  std::vector<GoalIndex> goals;
  std::string text = render(expression, scope, goals);
  Goal test;
  test.kind = GoalKind::kEval;
  test.where = expression;
  test.code = made_code(std::move(text), expression, scope);
  goals.push_back(add(std::move(test)));
  Goal together;
  together.kind = GoalKind::kAnd;
  together.where = expression;
  together.conditions.push_back(add_condition(std::move(goals), expression));
  return add(std::move(together));
}

// (when (and (= (name …) ?old) (assign ?new (sign ?old term))) the old value goes, the new one
// comes). A function without a value is left without, as a total cost that no problem mentions.
std::optional<Effect> ConditionCompiler::fluent_effect(Expression expression, ClauseScope& scope) {
  const std::vector<Expression> all = parts(expression);
  if (all.size() != 3 || !(*all[1]).list) return std::nullopt;
  const auto operation = std::find_if(
      kOperations.begin(), kOperations.end(),
      [&](const Operation& candidate) { return symbol(domain_.store, all[0], candidate.name); });
  if (operation == kOperations.end()) return std::nullopt;
  if (operation->sign.empty() && !names_fluent(all[1])) return std::nullopt;
  TermStore& store = domain_.store;
  std::vector<GoalIndex> goals;
  const Term old_value = fluent_value(all[1], scope, goals);
  std::string text = render(all[2], scope, goals);
  if (!operation->sign.empty()) {
    text = "(" + std::string(operation->sign) + " " + std::string(store.name(old_value)) + " " +
           text + ")";
  }
  const Term new_value = store.symbol("?value-of-function-" + std::to_string(++made_variables_));
  Goal assignment;
  assignment.kind = GoalKind::kAssign;
  assignment.where = expression;
  assignment.pattern = Term(TermKind::kSlot, scope.slot(new_value));
  assignment.code = made_code(std::move(text), expression, scope);
  goals.push_back(add(std::move(assignment)));
  const auto equation = [&](Term value) {
    const std::array<Term, 3> items{store.symbol("="), pattern(all[1], scope),
                                    Term(TermKind::kSlot, scope.slot(value))};
    Effect effect;
    effect.pattern = store.list(items);
    return effect;
  };
  Effect gone;
  gone.kind = EffectKind::kNegated;
  gone.parts.push_back(equation(old_value));
  Effect change;
  change.kind = EffectKind::kWhen;
  change.condition = add_condition(std::move(goals), expression);
  change.parts = {gone, equation(new_value)};
  return change;
}

}  // namespace skein::htn
