// SPDX-License-Identifier: Apache-2.0
#include "language/condition_checker.hpp"

#include <algorithm>

#include "language/typed_list.hpp"

namespace skein::htn {

namespace {
constexpr std::size_t kAnyNumber = static_cast<std::size_t>(-1);
}

bool is_function(const ReadContext& context, Expression expression) {
  if (context.is_symbol(expression)) return !context.is_nil(expression);
  const Term word = context.head(expression);
  const Words& words = context.words;
  return word == words.function || word == words.quote || word == words.lambda;
}

void ConditionChecker::check_precondition(Expression precondition) {
  if (!precondition) return;
  const Term word = context_.head(precondition);
  if (word == context_.words.sort_by) return check_sort(precondition);
  if (word != context_.words.first) return check(precondition);
  for (Expression at = next(first(precondition)); at; at = next(at)) check(at);
}

void ConditionChecker::check(Expression condition) {
  open_.push_back(condition);
  while (!open_.empty()) {
    const Expression at = open_.back();
    open_.pop_back();
    check_one(at);
  }
}

void ConditionChecker::check_one(Expression condition) {
  if (context_.is_nil(condition) || context_.is_variable(condition)) return;
  if (!context_.is_list(condition)) {
    return context_.error(condition, text_of(condition) + " is no condition",
                          "(predicate arguments…) or a list of conditions");
  }
  const Expression begin = first(condition);
  if (context_.is_list(begin)) {
    if ((*condition).dotted) {
      context_.error(condition, "a list of conditions with a dot");
    } else {
      enclose_tail(condition);
    }
    return push_from(parts(condition), 0, kAnyNumber);
  }
  if (!context_.is_symbol(begin) || context_.is_nil(begin)) {
    return context_.error(begin, "a condition that begins with " + text_of(begin), "a predicate");
  }
  if (!context_.is_variable(begin)) check_list(condition, (*begin).atom);
}

// ((p ?x) q ?x): SHOP takes the rest as one more condition.
void ConditionChecker::enclose_tail(Expression conditions) const {
  for (Expression at = next(first(conditions)); at; at = next(at)) {
    if (!context_.is_name(at)) continue;
    context_.warn(at, "a condition without its parentheses", "(" + text_of(at) + " …)");
    return context_.enclose(conditions, at);
  }
}

void ConditionChecker::check_list(Expression condition, Term word) {
  const Words& words = context_.words;
  if (word == words.first || word == words.sort_by) {
    return context_.error(condition, context_.name(word) + " inside a condition",
                          "it at the head of a precondition only");
  }
  if (word == words.quote || word == words.backquote) {
    return context_.error(condition, "a quoted condition", "the condition itself");
  }
  if (!check_word(condition, word)) atoms_.push_back(condition);
}

// False: no word of the logic, so a predicate.
bool ConditionChecker::check_word(Expression condition, Term word) {
  const Words& words = context_.words;
  const std::vector<Expression> all = parts(condition);
  if (word == words.conjunction || word == words.disjunction || word == words.external) {
    has_arguments(condition, 0, kAnyNumber, "(and condition…)");
    push_from(all, 1, kAnyNumber);
  } else if (word == words.negation) {
    has_arguments(condition, 1, 1, "(not condition)");
    push_from(all, 1, kAnyNumber);
  } else if (word == words.imply) {
    has_arguments(condition, 2, 2, "(imply condition condition)");
    push_from(all, 1, kAnyNumber);
  } else if (word == words.forall || word == words.shop_forall) {
    if (has_arguments(condition, 2, 3, "(forall (variables…) condition condition)")) {
      check_quantifier(all);
    }
  } else if (word == words.exists) {
    if (has_arguments(condition, 2, 3, "(exists (variables…) [condition] condition)")) {
      check_quantifier(all);
    }
  } else if (word == words.assign || word == words.assign_star) {
    if (has_arguments(condition, 2, 2, "(assign ?variable expression)")) check_assignment(all);
  } else if (word == words.eval || word == words.call) {
    check_evaluation(all);
  } else if (word == words.setof || word == words.bagof) {
    const char* shape = word == words.setof ? "(setof term condition ?variable)"
                                            : "(bagof term condition ?variable)";
    if (has_arguments(condition, 3, 3, shape)) check_collection(all);
  } else if (word == words.enforce) {
    if (has_arguments(condition, 1, kAnyNumber, "(enforce condition text arguments…)")) {
      open_.push_back(all[1]);
    }
  } else {
    return false;
  }
  return true;
}

bool ConditionChecker::has_arguments(Expression condition, std::size_t least, std::size_t most,
                                     const char* shape) const {
  const std::size_t given = count(condition) - 1;
  if (given >= least && given <= most && !(*condition).dotted) return true;
  const std::string word = context_.name(context_.head(condition));
  std::string message = word + " with " + counted(given, "argument");
  if ((*condition).dotted) message = word + " with a dot";
  context_.error(condition, std::move(message), shape);
  return false;
}

// In the order of the text, the first on top.
void ConditionChecker::push_from(const std::vector<Expression>& all, std::size_t begin,
                                 std::size_t end) {
  for (std::size_t at = std::min(end, all.size()); at > begin; --at) open_.push_back(all[at - 1]);
}

void ConditionChecker::check_sort(Expression condition) {
  if (!has_arguments(condition, 2, 3, "(:sort-by key [#'function] condition)")) return;
  const std::vector<Expression> all = parts(condition);
  if (all.size() == 4 && !is_function(context_, all[2])) {
    context_.error(all[2], text_of(all[2]) + " where :sort-by takes a function",
                   "#'<, #'>, another function, or one condition (and …)");
  }
  check(all.back());
}

void ConditionChecker::check_quantifier(const std::vector<Expression>& all) {
  read_typed_list(context_, all[1], TypedNames::kVariables);
  push_from(all, 2, 4);
}

void ConditionChecker::check_collection(const std::vector<Expression>& all) {
  if (!context_.is_variable(all[3])) {
    context_.error(all[3], text_of(all[3]) + " where the collected list goes", "a variable");
  }
  open_.push_back(all[2]);
}

void ConditionChecker::check_assignment(const std::vector<Expression>& all) {
  if (context_.is_variable(all[1])) return;
  context_.error(all[1], "assign to " + text_of(all[1]), "a variable");
}

void ConditionChecker::check_evaluation(const std::vector<Expression>& all) {
  const bool eval = (*all[0]).atom == context_.words.eval;
  if (all.size() == 1) {
    return context_.error(all[0], eval ? "eval without an expression" : "call without a function",
                          eval ? "(eval expression)" : "(call function arguments…)");
  }
  if (eval && all.size() > 2) {
    context_.warn(all[2], "eval takes one expression; the rest is ignored");
  }
  if (!eval && !is_function(context_, all[1])) {
    context_.error(all[1], "call of " + text_of(all[1]), "the name of a function");
  }
}

}  // namespace skein::htn
