// SPDX-License-Identifier: Apache-2.0
#include "replay/clause_reader.hpp"

#include <algorithm>

namespace skein::htn::replay {

namespace {

constexpr int kDeepest = 500;  // of expressions inside one another in one clause

}  // namespace

std::vector<Expression> ClauseReader::parts(Expression list) {
  std::vector<Expression> out;
  if (!list || !(*list).list) return out;
  for (const NodeIndex child : children(*list.document, list.node)) {
    out.push_back({list.document, child});
  }
  return out;
}

bool ClauseReader::is_symbol(Expression expression, std::string_view name) const {
  return expression && !(*expression).list && (*expression).atom.is(TermKind::kSymbol) &&
         store_.name((*expression).atom) == name;
}

bool ClauseReader::is_nil(Expression expression) {
  return !expression ||
         ((*expression).list ? (*expression).first_child == kNoNode : (*expression).atom == kNil);
}

bool ClauseReader::too_deep(Expression expression, int depth) {
  if (depth < kDeepest) return false;
  const Place place = place_of(*expression.document, (*expression).begin);
  Diagnostic problem;
  problem.file = expression.document->file;
  problem.line = place.line;
  problem.column = place.column;
  problem.message = "expressions nested too deeply";
  errors_.add(std::move(problem));
  return true;
}

Term ClauseReader::pattern(Expression expression, int depth) {
  if (!expression) return kNil;
  const Node& node = *expression;
  if (!node.list) return variable_name(node.atom) ? slot_for(node.atom) : node.atom;
  if (too_deep(expression, depth)) return kNil;
  std::vector<Term> items;
  for (const Expression& part : parts(expression)) items.push_back(pattern(part, depth + 1));
  if (!node.dotted || items.empty()) return store_.list(items);
  const Term tail = items.back();
  items.pop_back();
  return store_.list(items, tail);
}

Condition ClauseReader::condition(Expression expression) {
  Condition out;
  const std::vector<Expression> items = parts(expression);
  if (!items.empty() && is_symbol(items[0], ":first")) {
    out.first = true;
    if (items.size() == 2 || (items.size() > 2 && is_list(items[1]))) {
      for (std::size_t at = 1; at < items.size(); ++at) out.goals.push_back(element(items[at], 1));
    }
    return out;
  }
  if (items.size() >= 3 && is_symbol(items[0], ":sort-by")) {
    out.sorted = true;
    out.goals = sequence(items.back());
    out.key = code(items[1]);
    if (items.size() > 3) out.order = lisp_.compile_function(items[2], slot_lookup(), errors_);
    return out;
  }
  out.goals = sequence(expression);
  return out;
}

std::vector<Goal> ClauseReader::sequence(Expression expression, int depth) {
  std::vector<Goal> out;
  if (is_nil(expression)) return out;
  const std::vector<Expression> items = parts(expression);
  if (!items.empty() && is_list(items[0])) {
    for (const Expression& item : items) out.push_back(element(item, depth + 1));
    return out;
  }
  out.push_back(element(expression, depth + 1));
  return out;
}

Goal ClauseReader::element(Expression expression, int depth) {
  Goal out;
  out.where = expression;
  if (is_nil(expression) || too_deep(expression, depth)) {
    out.parts.emplace_back();
    return out;
  }
  if (!(*expression).list) {
    out.kind = is_variable(expression) ? GoalKind::kVariable : GoalKind::kAtom;
    out.pattern = pattern(expression);
    return out;
  }
  const std::vector<Expression> items = parts(expression);
  if (!is_list(items[0])) return goal(expression, depth);
  if (items.size() == 1) return element(items[0], depth + 1);
  out.parts.push_back(sequence(expression, depth));
  return out;
}

Goal ClauseReader::plain(GoalKind kind, const std::vector<Expression>& items, int depth) {
  Goal out;
  out.kind = kind;
  if (kind == GoalKind::kAnd) {
    out.parts.emplace_back();
    for (std::size_t at = 1; at < items.size(); ++at) {
      out.parts[0].push_back(element(items[at], depth + 1));
    }
    return out;
  }
  for (std::size_t at = 1; at < items.size(); ++at) {
    out.parts.push_back(sequence(items[at], depth + 1));
  }
  return out;
}

// Three forms: (forall (vars) bounds conditions), and with types (forall (x - t) conditions).
Goal ClauseReader::quantified(GoalKind kind, const std::vector<Expression>& items, int depth) {
  Goal out;
  out.kind = kind;
  if (items.size() >= 4) {
    out.parts.push_back(sequence(items[2], depth + 1));
    out.parts.push_back(sequence(items[3], depth + 1));
  } else if (items.size() == 3) {
    out.parts.push_back(type_goals(items[1], false, nullptr));
    out.parts.push_back(sequence(items[2], depth + 1));
  } else {
    out.parts.resize(2);
  }
  return out;
}

Goal ClauseReader::evaluated(const std::vector<Expression>& items, Expression whole) {
  Goal out;
  if (is_symbol(items[0], "call")) {
    out.kind = GoalKind::kEval;
    out.code = lisp_.compile_call(whole, slot_lookup(), errors_);
  } else if (is_symbol(items[0], "eval")) {
    out.kind = GoalKind::kEval;
    if (items.size() > 1) out.code = code(items[1]);
  } else {
    out.kind = is_symbol(items[0], "assign") ? GoalKind::kAssign : GoalKind::kAssignEach;
    if (items.size() > 1) out.pattern = pattern(items[1]);
    if (items.size() > 2) out.code = code(items[2]);
  }
  return out;
}

Goal ClauseReader::goal(Expression expression, int depth) {
  static const std::map<std::string_view, GoalKind> kinds = {
      {"and", GoalKind::kAnd},         {"or", GoalKind::kOr},
      {"not", GoalKind::kNot},         {"imply", GoalKind::kImply},
      {"forall", GoalKind::kForall},   {"exists", GoalKind::kExists},
      {"assign", GoalKind::kAssign},   {"eval", GoalKind::kEval},
      {"assign*", GoalKind::kAssign},  {"call", GoalKind::kEval},
      {"setof", GoalKind::kSetof},     {"bagof", GoalKind::kBagof},
      {"enforce", GoalKind::kEnforce}, {"shop-forall", GoalKind::kForall},
      {":external", GoalKind::kAnd}};
  const std::vector<Expression> items = parts(expression);
  const Term name = (*items[0]).atom;
  const auto found = name.is(TermKind::kSymbol) ? kinds.find(store_.name(name)) : kinds.end();
  Goal out;
  if (found == kinds.end()) {
    out.kind = GoalKind::kAtom;
    out.pattern = pattern(expression, depth);
  } else if (found->second == GoalKind::kAssign || found->second == GoalKind::kEval) {
    out = evaluated(items, expression);
  } else if (found->second == GoalKind::kForall || found->second == GoalKind::kExists) {
    out = quantified(found->second, items, depth);
  } else if (found->second == GoalKind::kSetof || found->second == GoalKind::kBagof) {
    out.kind = found->second;
    out.parts.resize(1);
    if (items.size() > 1) out.pattern = pattern(items[1]);
    if (items.size() > 2) out.parts[0].push_back(element(items[2], depth + 1));
    if (items.size() > 3) out.result = pattern(items[3]);
  } else if (found->second == GoalKind::kEnforce) {
    out.kind = GoalKind::kEnforce;
    out.parts.resize(1);
    if (items.size() > 1) out.parts[0].push_back(element(items[1], depth + 1));
  } else {
    out = plain(found->second, items, depth);
  }
  out.where = expression;
  return out;
}

// (a b - t c): a and b are of type t, c is an object.
std::vector<Goal> ClauseReader::type_goals(Expression typed, bool enforced,
                                           std::vector<Term>* names) {
  std::vector<Goal> out;
  std::vector<Term> waiting;
  const std::vector<Expression> items = parts(typed);
  for (std::size_t at = 0; at < items.size(); ++at) {
    if (!is_symbol(items[at], "-") || at + 1 == items.size()) {
      waiting.push_back(pattern(items[at]));
      if (names != nullptr) names->push_back(waiting.back());
      continue;
    }
    const Term type = pattern(items[++at]);
    for (const Term variable : waiting) {
      Goal goal;
      goal.kind = GoalKind::kAtom;
      goal.pattern = store_.list(std::vector<Term>{type, variable});
      goal.where = typed;
      if (enforced) {
        Goal outer;
        outer.kind = GoalKind::kEnforce;
        outer.where = typed;
        outer.parts.push_back({goal});
        goal = outer;
      }
      out.push_back(std::move(goal));
    }
    waiting.clear();
  }
  return out;
}

std::vector<Effect> ClauseReader::effects(Expression list, EffectKind kind, int depth) {
  const EffectKind items_kind =
      kind == EffectKind::kAdd ? EffectKind::kAddItems : EffectKind::kDeleteItems;
  std::vector<Effect> out;
  if (is_nil(list) || too_deep(list, depth)) return out;
  if (!(*list).list) return {{items_kind, pattern(list), {}, {}}};
  std::vector<Expression> items = parts(list);
  if (!is_list(items[0]) && !is_variable(items[0])) items = {list};
  for (const Expression& item : items) {
    const std::vector<Expression> of_item = parts(item);
    if (is_nil(item)) continue;
    if (!of_item.empty() && is_symbol(of_item[0], "forall") && of_item.size() == 4) {
      Effect each{EffectKind::kForall, {}, sequence(of_item[2]), {}};
      each.parts = effects(of_item[3], kind, depth + 1);
      out.push_back(std::move(each));
    } else {
      out.push_back({kind, pattern(item), {}, {}});
    }
  }
  return out;
}

Effect ClauseReader::pddl_effect(Expression expression, int depth) {
  Effect out;
  out.kind = EffectKind::kForall;  // with an empty condition: all parts
  if (is_nil(expression) || too_deep(expression, depth)) return out;
  const std::vector<Expression> items = parts(expression);
  const bool list = (*items[0]).list;
  if (list || is_symbol(items[0], "and")) {
    for (std::size_t at = list ? 0 : 1; at < items.size(); ++at) {
      out.parts.push_back(pddl_effect(items[at], depth + 1));
    }
  } else if (is_symbol(items[0], "not") && items.size() > 1) {
    out.kind = EffectKind::kDelete;
    out.pattern = pattern(items[1]);
  } else if (is_symbol(items[0], "forall") && items.size() > 2) {
    out.condition = type_goals(items[1], false, nullptr);
    out.parts.push_back(pddl_effect(items[2], depth + 1));
  } else if (is_symbol(items[0], "when") && items.size() > 2) {
    out.kind = EffectKind::kWhen;
    out.condition = sequence(items[1]);
    out.parts.push_back(pddl_effect(items[2], depth + 1));
  } else {
    out.kind = EffectKind::kAdd;
    out.pattern = pattern(expression);
  }
  return out;
}

bool ClauseReader::contains_call(Expression expression, int depth) const {
  if (!(*expression).list || depth > kDeepest) return false;
  const std::vector<Expression> items = parts(expression);
  if (!items.empty() && is_symbol(items[0], "call")) return true;
  return std::any_of(items.begin(), items.end(),
                     [&](const Expression& item) { return contains_call(item, depth + 1); });
}

NetworkClause ClauseReader::task(Expression expression) {
  NetworkClause out;
  out.kind = TreeNodeKind::kTask;
  std::vector<Expression> items = parts(expression);
  while (!items.empty() && (is_symbol(items[0], ":task") || is_symbol(items[0], ":immediate"))) {
    out.immediate = out.immediate || is_symbol(items[0], ":immediate");
    items.erase(items.begin());
  }
  const bool evaluates = std::any_of(items.begin(), items.end(),
                                     [&](const Expression& item) { return contains_call(item); });
  std::vector<Term> patterns;
  for (const Expression& item : items) {
    NetworkClause::Item element{pattern(item), kNoCode};
    if (contains_call(item)) element.code = lisp_.compile_template(item, slot_lookup(), errors_);
    patterns.push_back(element.pattern);
    out.items.push_back(element);
  }
  const bool dotted = (*expression).dotted && !patterns.empty();
  const Term tail = dotted ? patterns.back() : kNil;
  if (dotted) patterns.pop_back();
  out.pattern = store_.list(patterns, tail);
  if (!evaluates) out.items.clear();
  return out;
}

NetworkClause ClauseReader::network(Expression expression, int depth) {
  NetworkClause out;
  const std::vector<Expression> items = parts(expression);
  if (is_nil(expression) || items.empty() || too_deep(expression, depth)) {
    NetworkClause nothing;
    nothing.kind = TreeNodeKind::kTask;
    nothing.pattern = store_.list(std::vector<Term>{store_.symbol(kNoOperation)});
    out.children.push_back(std::move(nothing));
    return out;
  }
  if ((is_symbol(items[0], "quote") || is_symbol(items[0], "backquote")) && items.size() == 2) {
    return network(items[1], depth + 1);
  }
  const bool unordered = is_symbol(items[0], ":unordered");
  const bool ordered = is_symbol(items[0], ":ordered");
  if (!unordered && !ordered && !is_list(items[0])) return task(expression);
  out.kind = unordered ? TreeNodeKind::kUnordered : TreeNodeKind::kOrdered;
  for (std::size_t at = unordered || ordered ? 1 : 0; at < items.size(); ++at) {
    out.children.push_back(network(items[at], depth + 1));
  }
  return out.children.empty() ? network({}, depth) : out;
}

}  // namespace skein::htn::replay
