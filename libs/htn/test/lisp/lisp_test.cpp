// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/lisp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/lisp_fixture.hpp"

namespace skein::htn {
namespace {

class LispForms : public ::testing::Test, protected test::LispFixture {
 protected:
  void expect(const std::vector<std::pair<std::string, std::string>>& cases) {
    for (const auto& [text, expected] : cases) EXPECT_EQ(value(text), expected) << text;
  }
};

TEST_F(LispForms, ValuesOfClauseVariablesStandForThemselvesQuotedOrNot) {
  set("?x", "(+ 1 2)");
  set("?list", "(a b ?y)");

  expect({{"?x", "(+ 1 2)"},
          {"'?x", "(+ 1 2)"},
          {"(length ?list)", "3"},
          {"(length '?list)", "3"},
          {"'(a ?x . ?list)", "(a (+ 1 2) a b ?y)"},
          {"(eval ?x)", "(+ 1 2)"}});
}

TEST_F(LispForms, SymbolsThatAreNoVariablesStandForThemselves) {
  set("?a", "truck");

  EXPECT_EQ(value("fast"), "fast");
  EXPECT_EQ(value("?unknown"), "?unknown");
  EXPECT_EQ(call("(call = ?a truck)"), "t");
  EXPECT_EQ(call("(call = ?a boat)"), "nil");
  EXPECT_EQ(value("(+ ?a 1)"), "error: '+': argument 1 is the symbol truck, expected a number");
}

TEST_F(LispForms, UnboundVariablesAreTermsToListsAndErrorsToArithmetic) {
  set("?u", Term(TermKind::kVariable, 7));

  expect({{"(variablep ?u)", "t"},
          {"(variablep '?other)", "t"},
          {"(variablep 3)", "nil"},
          {"(length (list ?u ?u))", "2"},
          {"(= ?u 1)", "error: '=': argument 1 is an unbound variable, expected a value"},
          {"(+ 1 ?u)", "error: '+': argument 2 is an unbound variable, expected a number"}});
}

TEST_F(LispForms, CallIsUnderstoodAtTheTopAndInside) {
  set("?a", "2");

  EXPECT_EQ(call("(call + ?a 1)"), "3");
  EXPECT_EQ(call("(call #'+ ?a 1)"), "3");
  EXPECT_EQ(call("(call 'max ?a (call * 3 4))"), "12");
  EXPECT_EQ(call("(call if (> ?a 1) 'yes 'no)"), "yes");
  EXPECT_EQ(call("(call not nil)"), "t");
  EXPECT_EQ(value("(1+ (call * ?a 3))"), "7");
  EXPECT_EQ(call("(call)"),
            "load: test.lisp:1:1: a call without function; expected (call "
            "function arguments)");
}

TEST_F(LispForms, TasksHoldTheValuesOfTheirCalls) {
  set("?start", "5");
  set("?p", "(loc 1 2)");

  EXPECT_EQ(task("(!drive ?p (call + ?start 1) (at (call - 3) . ?p))"),
            "(!drive (loc 1 2) 6 (at -3 loc 1 2))");
  EXPECT_EQ(task("(!drive 'x + (+ 1 2))"), "(!drive (quote x) + (+ 1 2))");
  EXPECT_EQ(task("?p"), "(loc 1 2)");
  EXPECT_EQ(task("(!t (call lenght))"),
            "load: test.lisp:1:11: unknown function 'lenght'; did you mean 'length'?");
}

TEST_F(LispForms, ConditionalsEvaluateOnlyWhatTheyTake) {
  expect({{"(if t 1 (error \"no\"))", "1"},
          {"(if nil (error \"no\") 2)", "2"},
          {"(if nil 1)", "nil"},
          {"(cond (nil 1) ((= 1 1) 2 3) (t (error \"no\")))", "3"},
          {"(cond ((assoc 'b '((a 1) (b 2)))))", "(b 2)"},
          {"(cond)", "nil"},
          {"(when t 1 2)", "2"},
          {"(when nil 1)", "nil"},
          {"(unless nil 1 2)", "2"},
          {"(unless t 1)", "nil"},
          {"(and)", "t"},
          {"(and 1 2)", "2"},
          {"(and nil (error \"no\"))", "nil"},
          {"(or)", "nil"},
          {"(or nil 3 (error \"no\"))", "3"},
          {"(case 'b (a 1) ((b c) 2) (t 3))", "2"},
          {"(case 5 (a 1) (otherwise 3))", "3"},
          {"(case 5 (5.0 1))", "nil"},
          {"(case nil (nil 1) ((nil) 2))", "2"},
          {"(ecase 5 (4 1))", "error: no case for this value"}});
}

TEST_F(LispForms, VariablesAreLexical) {
  set("?a", "1");

  expect({{"(let ((x 1) (y 2)) (let ((x y) (y x)) (list x y)))", "(2 1)"},
          {"(let* ((x 1) (y (+ x 1))) (list x y))", "(1 2)"},
          {"(let (x (y)) (list x y))", "(nil nil)"},
          {"(let ((?a 5)) (+ ?a 1))", "6"},
          {"(progn (let ((x 1)) x) x)", "x"},
          {"(let ((list 3)) (list list))", "(3)"}});
}

TEST_F(LispForms, AssignmentChangesLocalVariables) {
  expect({{"(let ((x 1)) (setq x 2) x)", "2"},
          {"(let ((x 1) (y 1)) (setf x 2 y (+ x 1)) (list x y))", "(2 3)"},
          {"(let ((x 1)) (incf x) (incf x 5) (decf x 2) x)", "5"},
          {"(let ((l nil)) (push 1 l) (push 2 l) (list (pop l) l))", "(2 (1))"},
          {"(let ((l '(1))) (pushnew 1 l) (pushnew 2 l) l)", "(2 1)"}});
}

TEST_F(LispForms, OnlyLocalVariablesCanBeAssigned) {
  set("?a", "1");

  for (const char* text : {"(setq ?a 2)", "(incf counter)", "(setf (car x) 2)"}) {
    EXPECT_THAT(value(text), testing::HasSubstr("only a variable of the code can be assigned"))
        << text;
  }
}

TEST_F(LispForms, LoopsEndWithTheirResult) {
  expect({{"(let ((s 0)) (dolist (x '(1 2 3)) (incf s x)) s)", "6"},
          {"(let ((s 0)) (dolist (x '(1 2 3) (list s x)) (incf s x)))", "(6 nil)"},
          {"(let ((s 0)) (dotimes (i 4 (list s i)) (incf s i)))", "(6 4)"},
          {"(dolist (x '(1 2 3)) (when (= x 2) (return (list 'found x))))", "(found 2)"},
          {"(dotimes (i 0) (error \"no\"))", "nil"},
          {"(dolist (x 5) x)", "error: 'car': argument 1 is 5, expected a list"}});
}

TEST_F(LispForms, ReturnLeavesTheBlockInTheMiddleOfAnExpression) {
  expect({{"(block b (+ 1 (return-from b 5)))", "5"},
          {"(list 1 (block nil (list 2 (list 3 (return 4)))) 5)", "(1 4 5)"},
          {"(block a (block b (return-from a 1)) 2)", "1"}});
  EXPECT_THAT(value("(return 1)"), testing::HasSubstr("return without a block"));
}

TEST_F(LispForms, DestructuringFollowsThePattern) {
  expect({{"(destructuring-bind (a . b) '(1 . 2) (list a b))", "(1 2)"},
          {"(destructuring-bind (a (b c) &rest r) '(1 (2 3) 4 5) (list a b c r))", "(1 2 3 (4 5))"},
          {"(destructuring-bind (a &optional (b 7) c) '(1) (list a b c))", "(1 7 nil)"},
          {"(destructuring-bind (a &optional (b 7)) '(1 2) (list a b))", "(1 2)"},
          {"(destructuring-bind (a b) '(1) a)",
           "error: 'destructuring-bind': the list is shorter than the pattern"},
          {"(destructuring-bind (a) '(1 2) a)",
           "error: 'destructuring-bind': the list is longer than the pattern"}});
}

TEST_F(LispForms, BackquoteFillsATemplate) {
  set("?x", "(1 2)");

  expect({{"`(a ,(+ 1 2) ,@?x b)", "(a 3 1 2 b)"},
          {"`(a (b ,?x) . c)", "(a (b (1 2)) . c)"},
          {"`,(+ 1 2)", "3"},
          {"`(,@?x)", "(1 2)"},
          {"`a", "a"},
          {"`()", "nil"}});
}

TEST_F(LispForms, LambdasShareTheVariablesAroundThem) {
  set("?a", "10");

  expect(
      {{"(mapcar (lambda (x) (+ x ?a)) '(1 2))", "(11 12)"},
       {"((lambda (x &optional (y (* 2 x)) &rest r) (list x y r)) 4)", "(4 8 nil)"},
       {"((lambda (x &optional (y 0) &rest r) (list x y r)) 4 5 6 7)", "(4 5 (6 7))"},
       {"(let ((s 0)) (mapc #'(lambda (x) (incf s x)) '(1 2 3)) s)", "6"},
       {"(let ((n 10)) (let ((f (lambda (x) (incf n x)))) (funcall f 5) (funcall f 7) n))", "22"},
       {"(let ((i 0)) (mapcar #'(lambda (x) (mapcar #'(lambda (y) (+ x y (incf i))) '(1 2))) "
        "'(10 20)))",
        "((12 14) (24 26))"},
       {"(let ((c 0)) (lambda () (incf c)))",
        "error: a function that changes variables cannot be a result"},
       {"((lambda (a) a))", "error: 'lambda' takes 1 argument, got 0"}});
}

TEST_F(LispForms, ConstantsOfLispHaveTheirValues) {
  expect({{"pi", "3.141592653589793"},
          {"(< 5 most-positive-fixnum)", "t"},
          {"(let ((pi 3)) pi)", "3"},
          {"(list t nil () :key \"text\")", "(t nil nil :key \"text\")"}});
}

TEST_F(LispForms, FormsOfOneValueGiveIt) {
  expect({{"(progn 1 2 3)", "3"},
          {"(progn)", "nil"},
          {"(prog1 1 2 3)", "1"},
          {"(the fixnum (+ 1 2))", "3"},
          {"(eval (> 2 1))", "t"},
          {"(eval '(+ 1 2))", "3"},
          {"(funcall '+ 1 2)", "3"},
          {"(funcall #'car '(a))", "a"},
          {"(function car)", "car"}});
}

TEST_F(LispForms, FunctionsOfTheFileCallEachOther) {
  define("(defun is-even (n) (if (= n 0) t (is-odd (1- n))))");
  define("(defun is-odd (n) (if (= n 0) nil (is-even (1- n))))");
  define("(defun early (l) \"Doc.\" (dolist (x l) (when (> x 2) (return-from early x))) 'none)");

  expect({{"(is-even 1000)", "t"},
          {"(early '(1 2 3 4))", "3"},
          {"(early '(1))", "none"},
          {"(mapcar #'is-odd '(1 2))", "(t nil)"},
          {"(mapcar 'is-odd '(1 2))", "(t nil)"}});
}

TEST_F(LispForms, TheComparisonOfSortExampleOrdersPreferredFirst) {
  define(
      "(defun test-compare (x1 x2)"
      " (destructuring-bind (qual1 . val1) x1 (destructuring-bind (qual2 . val2) x2"
      "  (if (eq qual1 'preferred) (if (eq qual2 'unpreferred) t (> val1 val2))"
      "   (if (eq qual2 'preferred) nil (> val1 val2))))))");

  EXPECT_EQ(apply("#'test-compare", {"(preferred . 1)", "(unpreferred . 3)"}), "t");
  EXPECT_EQ(apply("#'test-compare", {"(preferred . -2)", "(preferred . 1)"}), "nil");
  EXPECT_EQ(apply("test-compare", {"(unpreferred . 3)", "(preferred . 1)"}), "nil");
}

TEST_F(LispForms, ADefunWithADocumentationStringMayPrint) {
  define("(defun pprint-t (x) \"Otherwise PPRINT returns NIL.\" (pprint x) t)");

  EXPECT_EQ(call("(call pprint-t 'x)"), "t");
}

TEST_F(LispForms, FunctionDesignatorsAreAppliedToTerms) {
  EXPECT_EQ(apply("#'<", {"1", "2"}), "t");
  EXPECT_EQ(apply("'>", {"1", "2"}), "nil");
  EXPECT_EQ(apply("<", {"1", "2"}), "t");
  EXPECT_EQ(apply("(lambda (x y) (- y x))", {"1", "5"}), "4");
  EXPECT_EQ(apply("#'(lambda (x) (* x x))", {"3"}), "9");
  EXPECT_EQ(apply("#'lenght", {}),
            "load: test.lisp:1:3: unknown function 'lenght'; did you mean 'length'?");
}

}  // namespace
}  // namespace skein::htn
