// SPDX-License-Identifier: Apache-2.0
#include "language/problem_reader.hpp"

#include "language/task_checker.hpp"

namespace skein::htn {

namespace {

constexpr const char* kShape = "(defproblem name [domain] (facts…) (tasks…))";

// The first variable inside a list, whose nodes stand right behind it.
Expression variable_in(const ReadContext& context, Expression list) {
  const std::vector<Node>& nodes = list.document->nodes;
  const std::uint32_t end = (*list).end;
  for (NodeIndex at = list.node + 1; at < nodes.size() && nodes[at].begin < end; ++at) {
    const Expression here{list.document, at};
    if (!nodes[at].list && context.is_variable(here)) return here;
  }
  return {list.document, kNoNode};
}

void check_fact(const ReadContext& context, Expression fact) {
  const bool nothing = context.is_nil(fact) || (count(fact) == 1 && context.is_nil(first(fact)));
  if (nothing || context.is_symbol(fact)) {
    return context.warn(fact, "a stray " + text_of(fact) + " is left out",
                        "(predicate arguments…)");
  }
  const Expression name = first(fact);
  if (!name) return context.error(fact, text_of(fact) + " is no fact", "(predicate arguments…)");
  if (!context.is_name(name)) {
    return context.error(name, "a fact that begins with " + text_of(name), "a predicate");
  }
  if ((*fact).dotted) context.error(fact, "a fact with a dot", "(predicate arguments…)");
  const Expression variable = variable_in(context, fact);
  if (variable) {
    context.error(variable, "variable " + text_of(variable) + " in a fact", "a constant");
  }
}

void check_facts(const ReadContext& context, Expression facts) {
  if (context.is_nil(facts)) return;
  if (!context.is_list(facts)) {
    return context.error(facts, text_of(facts) + " where the facts go",
                         "((predicate arguments…) …)");
  }
  if (context.head(facts) != kNil) {
    return context.error(facts, "one fact where a list of facts belongs",
                         "((predicate arguments…) …)");
  }
  for (Expression at = first(facts); at; at = next(at)) check_fact(context, at);
}

bool is_keyword(const ReadContext& context, Expression expression) {
  return context.is_symbol(expression) && context.name(expression).starts_with(':');
}

// (name :domain d …) or name.
bool read_name(const ReadContext& context, Expression given, ProblemDefinition& made) {
  const Expression name = context.is_list(given) ? first(given) : given;
  if (!name || !context.is_name(name)) {
    context.error(given, text_of(given) + " is no name for a problem", "a name or (name options…)");
    return false;
  }
  made.name = context.name(name);
  if (!context.is_list(given)) return true;
  for (Expression at = next(name); at && next(at); at = next(next(at))) {
    const bool domain = context.is_symbol(at) && (*at).atom == context.words.domain;
    if (domain && context.is_name(next(at))) made.domain = context.name(next(at));
  }
  return true;
}

// make-problem is a function: what is not quoted is computed.
bool is_computed(const ReadContext& context, Expression argument) {
  if (context.is_nil(argument)) return false;
  if (context.is_symbol(argument)) return !is_keyword(context, argument);
  const Term word = context.head(argument);
  return context.is_list(argument) && word != context.words.quote &&
         word != context.words.backquote;
}

bool holds_commas(const ReadContext& context, Expression list) {
  const std::vector<Node>& nodes = list.document->nodes;
  for (NodeIndex at = list.node; at < nodes.size() && nodes[at].begin < (*list).end; ++at) {
    const Term word = context.head({list.document, at});
    if (word == context.words.comma || word == context.words.comma_at) return true;
  }
  return false;
}

}  // namespace

bool is_fact(Expression expression) {
  const Expression name = first(expression);
  return name && !(*name).list && (*name).atom.is(TermKind::kSymbol) && (*name).atom != kNil;
}

void read_problem(const ReadContext& context, Expression form) {
  std::vector<Expression> all = parts(form);
  const bool function = context.head(form) == context.words.make_problem;
  for (std::size_t i = 1; function && i < all.size(); ++i) {
    if (!is_computed(context, all[i]) && !holds_commas(context, all[i])) continue;
    return context.warn(form, "a problem that Lisp code computes is left out", "quoted arguments");
  }
  std::vector<Expression> given;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (i > 3 && is_keyword(context, all[i])) break;  // options of make-problem
    given.push_back(unquoted(all[i], context.words));
  }
  if (given.size() < 3 || given.size() > 4) {
    return context.error(form, "a problem of " + counted(given.size(), "part"), kShape);
  }
  const std::size_t before = context.errors.size();
  ProblemDefinition made;
  const bool named = read_name(context, given[0], made);
  if (given.size() == 4) {
    if (!context.is_symbol(given[1]) || context.is_variable(given[1])) {
      context.error(given[1], text_of(given[1]) + " where the name of the domain goes", kShape);
    } else if (!context.is_nil(given[1])) {
      made.domain = context.name(given[1]);
    }
  }
  made.facts = given[given.size() - 2];
  made.tasks = given.back();
  check_facts(context, made.facts);
  TaskChecker(context).check(made.tasks);
  if (named && context.errors.size() == before) {
    context.definitions.problems.push_back(std::move(made));
  }
}

}  // namespace skein::htn
