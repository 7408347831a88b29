// SPDX-License-Identifier: Apache-2.0
// The words of the language as terms: comparing handles is comparing words.
#pragma once

#include "skein/htn/term_store.hpp"

namespace skein::htn {

class Words {
 public:
  explicit Words(TermStore& store) : store_(store) {}

 private:
  Term word(const char* text) { return store_.symbol(text); }
  TermStore& store_;  // before the words, which are made with it

 public:
  // around definitions
  Term defdomain = word("defdomain");
  Term define = word("define");
  Term defproblem = word("defproblem");
  Term make_problem = word("make-problem");
  Term def_problem_set = word("def-problem-set");
  Term defun = word("defun");
  Term let = word("let");
  Term let_star = word("let*");
  Term ignore_singletons = word("*ignore-singleton-variables*");
  Term quote = word("quote");
  Term backquote = word("backquote");
  Term comma = word("comma");
  Term comma_at = word("comma-at");
  Term function = word("function");
  Term lambda = word("lambda");
  // items of a domain
  Term op_long = word(":operator");
  Term op_short = word(":op");
  Term method = word(":method");
  Term pddl_method = word(":pddl-method");
  Term axiom = word(":-");
  Term include = word(":include");
  Term statics = word(":static");
  Term requirements = word(":requirements");
  Term types = word(":types");
  Term predicates = word(":predicates");
  Term functions = word(":functions");
  Term constants = word(":constants");
  Term action = word(":action");
  Term derived = word(":derived");
  // keywords inside items
  Term precond = word(":precond");
  Term precondition = word(":precondition");
  Term deletion = word(":delete");
  Term addition = word(":add");
  Term cost = word(":cost");
  Term parameters = word(":parameters");
  Term effect = word(":effect");
  Term type = word(":type");
  Term domain = word(":domain");
  // tasks and effects
  Term ordered = word(":ordered");
  Term unordered = word(":unordered");
  Term task = word(":task");
  Term immediate = word(":immediate");
  Term protection = word(":protection");
  // conditions
  Term first = word(":first");
  Term sort_by = word(":sort-by");
  Term external = word(":external");
  Term conjunction = word("and");
  Term disjunction = word("or");
  Term negation = word("not");
  Term imply = word("imply");
  Term forall = word("forall");
  Term shop_forall = word("shop-forall");
  Term exists = word("exists");
  Term assign = word("assign");
  Term assign_star = word("assign*");
  Term eval = word("eval");
  Term call = word("call");
  Term setof = word("setof");
  Term bagof = word("bagof");
  Term enforce = word("enforce");
  Term when = word("when");
  // PDDL
  Term either = word("either");
  Term dash = word("-");
  Term object = word("object");
  Term number = word("number");
  Term increase = word("increase");
  Term decrease = word("decrease");
  Term scale_up = word("scale-up");
  Term scale_down = word("scale-down");
  Term equal = word("=");
};

}  // namespace skein::htn
