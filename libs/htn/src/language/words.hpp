// SPDX-License-Identifier: Apache-2.0
// The words of the language as terms: comparing handles is comparing words.
#pragma once

#include "skein/htn/term_store.hpp"

namespace skein::htn {

/// Makes the words of a group.
class WordGroup {
 protected:
  explicit WordGroup(TermStore& store) : store_(store) {}
  Term word(const char* text) { return store_.symbol(text); }

 private:
  TermStore& store_;
};

/// Around definitions.
struct FormWords : private WordGroup {
  explicit FormWords(TermStore& store) : WordGroup(store) {}
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
};

/// Items of a domain.
struct ItemWords : private WordGroup {
  explicit ItemWords(TermStore& store) : WordGroup(store) {}
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
};

/// Keywords inside items.
struct PartWords : private WordGroup {
  explicit PartWords(TermStore& store) : WordGroup(store) {}
  Term precond = word(":precond");
  Term precondition = word(":precondition");
  Term deletion = word(":delete");
  Term addition = word(":add");
  Term cost = word(":cost");
  Term parameters = word(":parameters");
  Term effect = word(":effect");
  Term type = word(":type");
  Term domain = word(":domain");
};

/// Tasks and effects.
struct TaskWords : private WordGroup {
  explicit TaskWords(TermStore& store) : WordGroup(store) {}
  Term ordered = word(":ordered");
  Term unordered = word(":unordered");
  Term task = word(":task");
  Term immediate = word(":immediate");
  Term protection = word(":protection");
};

/// Conditions.
struct ConditionWords : private WordGroup {
  explicit ConditionWords(TermStore& store) : WordGroup(store) {}
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
};

/// PDDL.
struct PddlWords : private WordGroup {
  explicit PddlWords(TermStore& store) : WordGroup(store) {}
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

/// All of them.
struct Words : FormWords, ItemWords, PartWords, TaskWords, ConditionWords, PddlWords {
  explicit Words(TermStore& store)
      : FormWords(store),
        ItemWords(store),
        PartWords(store),
        TaskWords(store),
        ConditionWords(store),
        PddlWords(store) {}
};

}  // namespace skein::htn
