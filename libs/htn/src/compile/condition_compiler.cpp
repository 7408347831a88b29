// SPDX-License-Identifier: Apache-2.0
#include "compile/condition_compiler.hpp"

#include <algorithm>
#include <array>

namespace skein::htn {

namespace {

constexpr int kDeepestNesting = 400;
constexpr std::uint8_t kMostIndexedItems = 4;

Expression child(Expression list, NodeIndex node) { return {list.document, node}; }

std::string_view symbol_name(const TermStore& store, Expression expression) {
  if (!expression || (*expression).list || !(*expression).atom.is(TermKind::kSymbol)) return {};
  return store.name((*expression).atom);
}

bool empty(Expression expression) {
  if (!expression) return true;
  const Node& node = *expression;
  return node.list ? node.first_child == kNoNode : node.atom == kNil;
}

// Items of the list argument at `outer` that may be known.
void add_inner_positions(const TermStore& store, Term argument, std::uint8_t outer,
                         std::vector<IndexedPosition>& out) {
  std::uint8_t inner = 0;
  for (Term rest = argument; rest.is(TermKind::kPair) && inner < kMostIndexedItems;
       rest = store.cdr(rest), ++inner) {
    const Term item = store.car(rest);
    if (inner > 0 && !item.is(TermKind::kPair)) out.push_back({{outer, inner}, item});
  }
}

}  // namespace

bool is_variable(const TermStore& store, Term term) {
  return term.is(TermKind::kSymbol) && store.name(term).starts_with('?');
}

std::uint32_t ClauseScope::fresh(Term variable) {
  names_.push_back(variable);
  return static_cast<std::uint32_t>(names_.size() - 1);
}

std::uint32_t ClauseScope::slot(Term variable) {
  if (store_.name(variable).starts_with("?_")) return fresh(variable);
  for (auto scope = hidden_.rbegin(); scope != hidden_.rend(); ++scope) {
    const auto known = scope->find(variable);
    if (known != scope->end()) return known->second;
  }
  const auto known = slots_.find(variable);
  if (known != slots_.end()) return known->second;
  const std::uint32_t made = fresh(variable);
  slots_.emplace(variable, made);
  return made;
}

void ClauseScope::hide(Expression variables) {
  hidden_.emplace_back();
  const auto add = [this](Expression part) {
    if ((*part).list || !is_variable(store_, (*part).atom)) return;
    hidden_.back()[(*part).atom] = fresh((*part).atom);
  };
  add(variables);
  for (const Expression part : parts(variables)) add(part);
}

void ClauseScope::reveal() { hidden_.pop_back(); }

SlotOf ClauseScope::slot_of() {
  return [this](Term variable) -> std::optional<std::uint32_t> {
    if (!is_variable(store_, variable)) return std::nullopt;
    return slot(variable);
  };
}

void ClauseScope::finish(Clause& clause) const {
  clause.slots = static_cast<std::uint32_t>(names_.size());
  clause.names = names_;
  if (!flat_arguments(store_, clause.head, clause.items)) clause.items.clear();
}

Goal atom_goal(const TermStore& store, Term pattern, Expression where) {
  Goal goal;
  goal.kind = GoalKind::kAtom;
  goal.pattern = pattern;
  goal.predicate = store.car(pattern);
  goal.where = where;
  goal.flat = flat_arguments(store, pattern, goal.arguments);
  if (!goal.predicate.is(TermKind::kSymbol)) goal.arguments = store.items(store.cdr(pattern));
  goal.positions.reserve(goal.arguments.size());
  for (std::size_t at = 0; at < std::min<std::size_t>(goal.arguments.size(), Path::kWhole); ++at) {
    const auto outer = static_cast<std::uint8_t>(at);
    goal.positions.push_back({{outer, Path::kWhole}, goal.arguments[at]});
    add_inner_positions(store, goal.arguments[at], outer, goal.positions);
  }
  return goal;
}

void ConditionCompiler::error(Expression where, std::string message, std::string expected) {
  Diagnostic diagnostic;
  if (where.document != nullptr) {
    diagnostic.file = where.document->file;
    if (where) {
      const Place place = place_of(*where.document, (*where).begin);
      diagnostic.line = place.line;
      diagnostic.column = place.column;
    }
  }
  diagnostic.message = std::move(message);
  diagnostic.expected = std::move(expected);
  errors_.add(clipped(std::move(diagnostic)));
}

Term ConditionCompiler::pattern(Expression expression, ClauseScope& scope) {
  TermStore& store = domain_.store;
  const auto leaf = [&](Term atom) {
    return is_variable(store, atom) ? Term(TermKind::kSlot, scope.slot(atom)) : atom;
  };
  return term_of(expression, store, leaf, scratch_);
}

CodeIndex ConditionCompiler::code(Expression expression, ClauseScope& scope) {
  return domain_.lisp.compile(expression, scope.slot_of(), errors_);
}

ConditionIndex ConditionCompiler::add_condition(std::vector<GoalIndex> goals, Expression where) {
  Condition condition;
  condition.goals = std::move(goals);
  condition.where = where;
  set_slots(domain_, condition);
  domain_.conditions.push_back(std::move(condition));
  return static_cast<ConditionIndex>(domain_.conditions.size() - 1);
}

std::vector<GoalIndex> ConditionCompiler::rest_goals(Expression list, std::size_t skip,
                                                     ClauseScope& scope) {
  const std::vector<Expression> all = parts(list);
  std::vector<GoalIndex> goals;
  // What remains may be the parts of a conjunction or, if it begins with a name, one goal.
  if (all.size() > skip && !(*all[skip]).list && !is_variable(domain_.store, (*all[skip]).atom)) {
    error(all[skip], "a condition was expected here", "(predicate …) or a connective");
    return goals;
  }
  for (std::size_t at = skip; at < all.size(); ++at) append_goals(all[at], scope, goals);
  return goals;
}

// A conjunction as the whole of a condition: nothing, one goal, or a list of goals.
std::vector<GoalIndex> ConditionCompiler::conjunction(Expression expression, ClauseScope& scope) {
  std::vector<GoalIndex> goals;
  if (empty(expression)) return goals;
  const bool several = (*expression).list && (*child(expression, (*expression).first_child)).list;
  if (!several) {
    append_goals(expression, scope, goals);
    return goals;
  }
  for (const Expression part : parts(expression)) append_goals(part, scope, goals);
  return goals;
}

// One member of a conjunction; a list of goals among them is an implicit `and`.
void ConditionCompiler::append_goals(Expression expression, ClauseScope& scope,
                                     std::vector<GoalIndex>& out) {
  if (empty(expression)) return;
  if (nesting_ > kDeepestNesting) {
    error(expression, "conditions are nested too deeply", "at most 400 levels");
    return;
  }
  ++nesting_;
  const Node& node = *expression;
  const bool list_of_goals = node.list && (*child(expression, node.first_child)).list;
  if (!list_of_goals) {
    out.push_back(goal(expression, scope));
  } else if (parts(expression).size() == 1) {
    append_goals(parts(expression).front(), scope, out);
  } else {
    Goal together;
    together.kind = GoalKind::kAnd;
    together.where = expression;
    together.conditions.push_back(add_condition(conjunction(expression, scope), expression));
    out.push_back(add(std::move(together)));
  }
  --nesting_;
}

ConditionIndex ConditionCompiler::condition(Expression expression, ClauseScope& scope) {
  if (empty(expression)) return kAbsent;
  Expression first_part;
  if ((*expression).list) first_part = child(expression, (*expression).first_child);
  const std::string_view name = symbol_name(domain_.store, first_part);
  Condition condition;
  condition.where = expression;
  if (name == ":first") {
    condition.first = true;
    condition.goals = rest_goals(expression, 1, scope);
  } else if (name == ":sort-by") {
    sort_by(expression, scope, condition);
  } else {
    condition.goals = conjunction(expression, scope);
  }
  set_slots(domain_, condition);
  domain_.conditions.push_back(std::move(condition));
  return static_cast<ConditionIndex>(domain_.conditions.size() - 1);
}

void ConditionCompiler::sort_by(Expression expression, ClauseScope& scope, Condition& condition) {
  const std::vector<Expression> all = parts(expression);
  if (all.size() != 3 && all.size() != 4) {
    error(expression, ":sort-by with " + std::to_string(all.size() - 1) + " parts",
          "(:sort-by value [function] condition)");
    return;
  }
  condition.sorted = true;
  condition.sort_key = code(all[1], scope);
  if (all.size() == 4) {
    condition.compare = domain_.lisp.compile_function(all[2], scope.slot_of(), errors_);
  }
  condition.goals = conjunction(all.back(), scope);
}

AxiomTail ConditionCompiler::tail(const BranchDefinition& definition, ClauseScope& scope) {
  AxiomTail tail;
  tail.label = definition.label;
  const std::vector<Expression> all = parts(definition.precondition);
  tail.first = !all.empty() && symbol_name(domain_.store, all.front()) == ":first";
  std::vector<GoalIndex> goals;
  if (tail.first) {
    goals = rest_goals(definition.precondition, 1, scope);
  } else {
    append_goals(definition.precondition, scope, goals);
  }
  if (goals.size() >
      1) {  // a tail is one goal: of several the answers are found first, as of `and`
    Goal together;
    together.kind = GoalKind::kAnd;
    together.where = definition.precondition;
    together.conditions.push_back(add_condition(std::move(goals), definition.precondition));
    goals.assign(1, add(std::move(together)));
  }
  tail.goals = std::move(goals);
  return tail;
}

GoalIndex ConditionCompiler::goal(Expression expression, ClauseScope& scope) {
  const Node& node = *expression;
  if (!node.list) {
    Goal value;
    value.kind = GoalKind::kVariable;
    value.pattern = pattern(expression, scope);
    value.where = expression;
    if (!value.pattern.is(TermKind::kSlot)) {
      error(expression, "'" + domain_.store.to_text(node.atom) + "' is no condition",
            "(predicate argument …), a connective or a variable");
    }
    return add(std::move(value));
  }
  const std::string_view name = symbol_name(domain_.store, child(expression, node.first_child));
  if (name == "and") return connective(GoalKind::kAnd, expression, scope);
  if (name == ":external") return connective(GoalKind::kAnd, expression, scope);
  if (name == "or") return alternatives(expression, scope);
  if (name == "not") return connective(GoalKind::kNot, expression, scope);
  if (name == "imply") return implication(expression, scope);
  if (name == "forall" || name == "shop-forall")
    return quantified(GoalKind::kForall, expression, scope);
  if (name == "exists") return quantified(GoalKind::kExists, expression, scope);
  if (name == "eval") return evaluation(expression, scope, false);
  if (name == "call") return evaluation(expression, scope, true);
  if (name == "assign") return assignment(GoalKind::kAssign, expression, scope);
  if (name == "assign*") return assignment(GoalKind::kAssignEach, expression, scope);
  if (name == "setof") return collection(GoalKind::kSetOf, expression, scope);
  if (name == "bagof") return collection(GoalKind::kBagOf, expression, scope);
  if (name == "enforce") return enforcement(expression, scope);
  if (compares_fluents(expression, name)) return fluent_comparison(expression, scope);
  return atom(expression, scope);
}

GoalIndex ConditionCompiler::atom(Expression expression, ClauseScope& scope) {
  return add(atom_goal(domain_.store, pattern(expression, scope), expression));
}

GoalIndex ConditionCompiler::connective(GoalKind kind, Expression expression, ClauseScope& scope) {
  Goal made;
  made.kind = kind;
  made.where = expression;
  made.conditions.push_back(add_condition(rest_goals(expression, 1, scope), expression));
  return add(std::move(made));
}

GoalIndex ConditionCompiler::alternatives(Expression expression, ClauseScope& scope) {
  Goal made;
  made.kind = GoalKind::kOr;
  made.where = expression;
  const std::vector<Expression> all = parts(expression);
  for (std::size_t at = 1; at < all.size(); ++at) {
    made.conditions.push_back(add_condition(conjunction(all[at], scope), all[at]));
  }
  return add(std::move(made));
}

GoalIndex ConditionCompiler::implication(Expression expression, ClauseScope& scope) {
  const std::vector<Expression> all = parts(expression);
  if (all.size() != 3) {
    error(expression, "imply with " + std::to_string(all.size() - 1) + " parts",
          "(imply condition condition)");
    return connective(GoalKind::kAnd, expression, scope);
  }
  Goal never;
  never.kind = GoalKind::kNot;
  never.where = all[1];
  never.conditions.push_back(add_condition(conjunction(all[1], scope), all[1]));
  Goal either;
  either.kind = GoalKind::kOr;
  either.where = expression;
  const GoalIndex negation = add(std::move(never));
  either.conditions.push_back(add_condition({negation}, all[1]));
  either.conditions.push_back(add_condition(conjunction(all[2], scope), all[2]));
  Goal made;
  made.kind = GoalKind::kImply;
  made.where = expression;
  const GoalIndex inner = add(std::move(either));
  made.conditions.push_back(add_condition({inner}, expression));
  return add(std::move(made));
}

GoalIndex ConditionCompiler::quantified(GoalKind kind, Expression expression, ClauseScope& scope) {
  const std::vector<Expression> all = parts(expression);
  if (all.size() == 3) return typed_quantified(kind, expression, scope);
  if (all.size() != 4) {
    error(expression, "a quantifier with " + std::to_string(all.size() - 1) + " parts",
          "(forall (variable …) bounds condition)");
    return connective(GoalKind::kAnd, expression, scope);
  }
  scope.hide(all[1]);
  Goal made;
  made.kind = kind;
  made.where = expression;
  made.conditions.push_back(add_condition(conjunction(all[2], scope), all[2]));
  made.conditions.push_back(add_condition(conjunction(all[3], scope), all[3]));
  scope.reveal();
  return add(std::move(made));
}

// PDDL: (forall (?x - type …) condition); the types are the bounds.
GoalIndex ConditionCompiler::typed_quantified(GoalKind kind, Expression expression,
                                              ClauseScope& scope) {
  const std::vector<Expression> all = parts(expression);
  scope.hide(all[1]);
  std::vector<Term> typed;
  Goal made;
  made.kind = kind;
  made.where = expression;
  made.conditions.push_back(add_condition(type_goals(all[1], scope, typed), all[1]));
  made.conditions.push_back(add_condition(conjunction(all[2], scope), all[2]));
  scope.reveal();
  return add(std::move(made));
}

// A variable is of a type, or of one of (either type …); nothing where that is so of any object.
std::optional<GoalIndex> ConditionCompiler::type_goal(Expression type, std::uint32_t variable) {
  TermStore& store = domain_.store;
  const auto of_one = [&](Expression name) {
    const std::array<Term, 2> typed{(*name).atom, Term(TermKind::kSlot, variable)};
    return add(atom_goal(store, store.list(typed), name));
  };
  const Term object = store.symbol("object");
  if (!(*type).list) {
    return (*type).atom == object ? std::nullopt : std::optional<GoalIndex>(of_one(type));
  }
  const std::vector<Expression> either = parts(type);
  Goal made;
  made.kind = GoalKind::kOr;
  made.where = type;
  for (std::size_t at = 1; at < either.size(); ++at) {
    if ((*either[at]).atom == object) return std::nullopt;
    made.conditions.push_back(add_condition({of_one(either[at])}, either[at]));
  }
  return add(std::move(made));
}

std::vector<GoalIndex> ConditionCompiler::type_goals(Expression typed_list, ClauseScope& scope,
                                                     std::vector<Term>& variables) {
  TermStore& store = domain_.store;
  std::vector<GoalIndex> goals;
  std::vector<Term> waiting;
  bool type_follows = false;
  for (const Expression part : parts(typed_list)) {
    const Term atom = (*part).atom;
    if (type_follows) {
      for (const Term variable : waiting) {
        const std::optional<GoalIndex> typed = type_goal(part, scope.slot(variable));
        if (typed) goals.push_back(*typed);
      }
      waiting.clear();
      type_follows = false;
    } else if (symbol_name(store, part) == "-") {
      type_follows = true;
    } else if (is_variable(store, atom)) {
      waiting.push_back(atom);
      variables.push_back(atom);
    }
  }
  return goals;
}

ConditionIndex ConditionCompiler::typed_condition(Expression typed_list, Expression expression,
                                                  ClauseScope& scope) {
  std::vector<Term> variables;
  std::vector<GoalIndex> goals = type_goals(typed_list, scope, variables);
  const std::vector<GoalIndex> rest = conjunction(expression, scope);
  goals.insert(goals.end(), rest.begin(), rest.end());
  return goals.empty() ? kAbsent : add_condition(std::move(goals), expression);
}

GoalIndex ConditionCompiler::evaluation(Expression expression, ClauseScope& scope, bool call) {
  Goal made;
  made.kind = GoalKind::kEval;
  made.where = expression;
  const std::vector<Expression> all = parts(expression);
  // (eval f a b) is met in old domains and means (eval (f a b)).
  if (call || all.size() > 2) {
    made.code = domain_.lisp.compile_call(expression, scope.slot_of(), errors_);
  } else if (all.size() == 2) {
    made.code = code(all[1], scope);
  } else {
    error(expression, "eval of nothing", "(eval term)");
  }
  return add(std::move(made));
}

GoalIndex ConditionCompiler::assignment(GoalKind kind, Expression expression, ClauseScope& scope) {
  Goal made;
  made.kind = kind;
  made.where = expression;
  const std::vector<Expression> all = parts(expression);
  if (all.size() != 3) {
    error(expression, "an assignment with " + std::to_string(all.size() - 1) + " parts",
          "(assign ?variable term)");
    return add(std::move(made));
  }
  made.pattern = pattern(all[1], scope);
  made.code = code(all[2], scope);
  return add(std::move(made));
}

GoalIndex ConditionCompiler::collection(GoalKind kind, Expression expression, ClauseScope& scope) {
  Goal made;
  made.kind = kind;
  made.where = expression;
  const std::vector<Expression> all = parts(expression);
  if (all.size() != 4) {
    error(expression, "a collection with " + std::to_string(all.size() - 1) + " parts",
          "(setof term condition ?variable)");
    return connective(GoalKind::kAnd, expression, scope);
  }
  made.term = pattern(all[1], scope);
  made.pattern = pattern(all[3], scope);
  made.conditions.push_back(add_condition(conjunction(all[2], scope), all[2]));
  return add(std::move(made));
}

GoalIndex ConditionCompiler::enforcement(Expression expression, ClauseScope& scope) {
  const std::vector<Expression> all = parts(expression);
  Goal made;
  made.kind = GoalKind::kEnforce;
  made.where = expression;
  if (all.size() < 2) {
    error(expression, "enforce without a condition", "(enforce condition message …)");
    return add(std::move(made));
  }
  made.conditions.push_back(add_condition(conjunction(all[1], scope), all[1]));
  if (all.size() > 2 && (*all[2]).atom.is(TermKind::kString)) {
    made.text = domain_.store.text((*all[2]).atom);
  }
  return add(std::move(made));
}

}  // namespace skein::htn
