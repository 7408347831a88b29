// SPDX-License-Identifier: Apache-2.0
// Which variable a name means, what a function sees, where control goes, and where errors are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/lisp_fixture.hpp"

namespace skein::htn {
namespace {

using testing::HasSubstr;

class LispScoping : public ::testing::Test, protected test::LispFixture {
 protected:
  void expect(const std::vector<std::pair<std::string, std::string>>& cases) {
    for (const auto& [text, expected] : cases) EXPECT_EQ(value(text), expected) << text;
  }
  /// "line:column why" of what goes wrong when `text` is evaluated.
  std::string run_error(const std::string& text) {
    Diagnostics errors;
    const CodeIndex code = lisp().compile(read(text), slot_of(), errors);
    EXPECT_TRUE(errors.empty()) << to_text(errors);
    const auto result = evaluated(code);
    if (result) return "no error";
    const Expression where = result.error().where;
    const Place place = place_of(*where.document, (*where).begin);
    return std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
           result.error().why;
  }
};

// Variables

TEST_F(LispScoping, LetEvaluatesAllItsValuesOutside) {
  expect({{"(let ((x 1)) (let ((x (+ x 1)) (y x)) (list x y)))", "(2 1)"},
          {"(let ((x 1)) (let* ((x (+ x 1)) (y x)) (list x y)))", "(2 2)"},
          {"(let ((x 1)) (let ((x 2)) x) x)", "1"},
          {"(let ((x 1)) (let ((x 2)) (setq x 3)) x)", "1"},
          {"(let () 5)", "5"},
          {"(let ((x 1)))", "nil"}});
}

TEST_F(LispScoping, ALocalVariableHidesTheClauseVariableOfItsName) {
  set("?x", "outer");

  expect({{"(list ?x (let ((?x 'inner)) ?x) ?x)", "(outer inner outer)"},
          {"(funcall (lambda (?x) ?x) 'given)", "given"},
          {"(dolist (?x '(a) ?x))", "nil"},
          {"(let ((y ?x)) (list y ?x))", "(outer outer)"}});
}

TEST_F(LispScoping, FunctionsSeeTheVariablesAroundTheirTextNotThoseOfTheirCaller) {
  define("(defun get-x () x)");
  define("(defun make-list-of (x) (mapcar (lambda (y) (list x y)) '(1 2)))");

  expect({{"(let ((x 5)) (get-x))", "x"},
          {"(let ((x 'no)) (make-list-of 'yes))", "((yes 1) (yes 2))"},
          {"(let ((x 1)) (let ((f (lambda () x))) (let ((x 2)) (funcall f))))", "1"}});
}

TEST_F(LispScoping, EachCallOfAFunctionHasVariablesOfItsOwn) {
  define("(defun count-down (n) (if (= n 0) nil (let ((m n)) (cons m (count-down (1- n))))))");
  define("(defun fib (n) (if (< n 2) n (+ (fib (- n 1)) (fib (- n 2)))))");

  expect({{"(count-down 3)", "(3 2 1)"}, {"(fib 15)", "610"}});
}

TEST_F(LispScoping, ParametersAreCopiesOfWhatTheCallerHas) {
  define("(defun spoil (x) (setq x 'spoilt) x)");

  EXPECT_EQ(value("(let ((y 'good)) (list (spoil y) y))"), "(spoilt good)");
}

TEST_F(LispScoping, LambdasInsideEachOtherReachAllTheVariablesOutside) {
  expect({{"(funcall (funcall (lambda (x) (lambda (y) (- x y))) 10) 3)", "7"},
          {"(mapcar (lambda (x) (mapcar (lambda (y) (* x y)) '(1 2))) '(3 4))", "((3 6) (4 8))"},
          {"(let ((n 0)) (mapcar (lambda (x) (setq n (+ n x)) n) '(1 2 3)))", "(1 3 6)"},
          {"(let ((n 0)) (dolist (x '(1 2)) (funcall (lambda () (incf n x)))) n)", "3"}});
}

TEST_F(LispScoping, AFunctionAndAVariableOfOneNameAreTwoThings) {
  define("(defun size (l) (length l))");

  expect({{"(let ((size '(a b))) (size size))", "2"},
          {"(let ((car '(1 2))) (car car))", "1"},
          {"(let ((f #'car)) (funcall f '(9)))", "9"}});
}

TEST_F(LispScoping, DefaultsOfOptionalParametersSeeTheParametersBefore) {
  define("(defun box (w &optional (h w) (d (* w h))) (list w h d))");
  define("(defun tail (&optional a &rest more) (list a more))");

  expect({{"(box 2)", "(2 2 4)"},
          {"(box 2 3)", "(2 3 6)"},
          {"(box 2 3 nil)", "(2 3 nil)"},
          {"(tail)", "(nil nil)"},
          {"(tail 1)", "(1 nil)"},
          {"(tail 1 2 3)", "(1 (2 3))"}});
}

TEST_F(LispScoping, DefunsWithoutBodyGiveNil) {
  define("(defun nothing (x))");

  EXPECT_EQ(value("(nothing 1)"), "nil");
}

// Control

TEST_F(LispScoping, LoopsBindTheirVariableInsideOnly) {
  expect({{"(let ((x 'kept)) (dolist (x '(1 2)) x) x)", "kept"},
          {"(let ((i 'kept)) (dotimes (i 3) i) i)", "kept"},
          {"(let ((l nil)) (dotimes (i 3) (dotimes (j i) (push (list i j) l))) (reverse l))",
           "((1 0) (2 0) (2 1))"},
          {"(let ((l '(1 2 3)) (n 0)) (dolist (x l) (setq l nil) (incf n)) n)", "3"},
          {"(dotimes (i -1 i))", "0"}});
}

TEST_F(LispScoping, ChangingTheVariableOfALoopDoesNotChangeItsCount) {
  EXPECT_EQ(value("(let ((n 0)) (dotimes (i 3) (setq i 10) (incf n)) n)"), "3");
}

TEST_F(LispScoping, ReturnLeavesTheInnermostLoopAndReturnFromTheNamedBlock) {
  define(
      "(defun first-big (ll) (dolist (l ll) (dolist (x l) (if (> x 9) (return-from first-big "
      "x)))))");

  expect({{"(let ((n 0)) (dolist (x '(1 2)) (dolist (y '(1 2)) (incf n) (return))) n)", "2"},
          {"(first-big '((1 2) (3 40) (50)))", "40"},
          {"(first-big '((1)))", "nil"},
          {"(block outer (dolist (x '(1 2)) (return-from outer (list x))))", "(1)"},
          {"(block b)", "nil"},
          {"(block b 1 (return-from b) 2)", "nil"}});
}

TEST_F(LispScoping, ALambdaCannotLeaveTheBlockAroundIt) {
  EXPECT_THAT(value("(block b (mapcar (lambda (x) (return-from b x)) '(1)))"),
              HasSubstr("return without a block of that name in the same function"));
}

TEST_F(LispScoping, ConditionalsTakeTheirValuesFromTheTakenBranch) {
  expect(
      {{"(if nil 1 2 3)", "load: test.lisp:1:1: 'if' with 4 arguments; expected 2 to 3 arguments"},
       {"(cond ((member 'b '(a b c))) (t 'no))", "(b c)"},
       {"(cond (nil 1))", "nil"},
       {"(cond (1 nil) (t 2))", "nil"},
       {"(when 1)", "nil"},
       {"(unless nil)", "nil"},
       {"(case 1.0 (1 'integer) (1.0 'float))", "float"},
       {"(case 'z ((a b) 1))", "nil"},
       {"(case '(a) ((a) 1) (t 2))", "2"},
       {"(or nil nil)", "nil"},
       {"(and 1 nil 2)", "nil"}});
}

TEST_F(LispScoping, AssignmentsGiveTheirLastValue) {
  expect({{"(let (x y) (setq x 1 y 2))", "2"},
          {"(let (x) (setq x 1 x (+ x 1)) x)", "2"},
          {"(let ((x 1)) (incf x 1/2))", "3/2"},
          {"(let ((x 1)) (decf x))", "0"},
          {"(let ((l '(a b))) (list (pop l) (pop l) (pop l) l))", "(a b nil nil)"},
          {"(let (l) (push 'a l) (push 'b l))", "(b a)"},
          {"(setq)", "nil"}});
}

TEST_F(LispScoping, IncrementingWhatIsNoNumberIsAnError) {
  EXPECT_EQ(value("(let ((x 'a)) (incf x))"),
            "error: '+': argument 1 is the symbol a, expected a number");
}

// Templates and patterns

TEST_F(LispScoping, BackquotesQuoteAllButWhatFollowsAComma) {
  set("?x", "(1 2)");

  expect({{"`(?x ,?x)", "((1 2) (1 2))"},
          {"(let ((y 3)) `(y ,y ,@(list y y) . ,y))", "(y 3 3 3 . 3)"},
          {"`(a ,@nil b)", "(a b)"},
          {"`((,@?x) ,@?x)", "((1 2) 1 2)"},
          {"`(a \"text\" 1.5)", "(a \"text\" 1.5)"},
          {"`(,@5 a)", "error: 'append': argument 1 is 5, expected a list"}});
}

TEST_F(LispScoping, PatternsMayBeNestedDottedAndOptional) {
  expect({{"(destructuring-bind ((a . b) c) '((1 2 3) 4) (list a b c))", "(1 (2 3) 4)"},
          {"(destructuring-bind (&rest all) '(1 2) all)", "(1 2)"},
          {"(destructuring-bind (&optional a &rest r) nil (list a r))", "(nil nil)"},
          {"(destructuring-bind (a &optional (b (1+ a))) '(1) (list a b))", "(1 2)"},
          {"(destructuring-bind () nil 'empty)", "empty"},
          {"(destructuring-bind ((a)) '(b) a)",
           "error: 'destructuring-bind': the list is shorter than the pattern"}});
  EXPECT_THAT(value("(destructuring-bind (a &key b) '(1) a)"),
              HasSubstr("patterns of this kind are not supported"));
  EXPECT_THAT(value("(destructuring-bind (a 5) '(1 2) a)"), HasSubstr("cannot be a pattern"));
}

TEST_F(LispScoping, QuotesKeepFormsFromBeingEvaluated) {
  expect({{"'(+ 1 2)", "(+ 1 2)"},
          {"''a", "(quote a)"},
          {"(car ''a)", "quote"},
          {"'(if . x)", "(if . x)"},
          {"(eval ''a)", "a"},
          {"(list 'a \"b\" :c 1/2)", "(a \"b\" :c 1/2)"}});
}

// Errors and their places

TEST_F(LispScoping, ErrorsAreWhereTheFailingExpressionBegins) {
  EXPECT_EQ(run_error("(+ 1\n   (* 2 'a))"),
            "2:4 '*': argument 2 is the symbol a, expected a number");
  EXPECT_EQ(run_error("(let ((x 5))\n  (if (> x 1)\n    (car x)))"),
            "3:5 'car': argument 1 is 5, expected a list");
  EXPECT_EQ(run_error("(progn 1\n (ecase 'b (a 1)))"), "2:2 no case for this value");
  EXPECT_EQ(run_error("(list 1 (error \"bad ~a\" 'day))"), "1:9 bad day");
}

TEST_F(LispScoping, LoadErrorsNameThePartThatIsWrong) {
  expect({{"(list 1\n  (frist '(a)))",
           "load: test.lisp:2:4: unknown function 'frist'; did you mean 'first'?"},
          {"(let ((x 1))\n  (cons x))",
           "load: test.lisp:2:4: 'cons' with 1 argument; expected 2 arguments"},
          {"(nth 1 '(a) 2)", "load: test.lisp:1:2: 'nth' with 3 arguments; expected 2 arguments"},
          {"(mapcar #'1+)",
           "load: test.lisp:1:2: 'mapcar' with 1 argument; expected at least 2 arguments"}});
}

TEST_F(LispScoping, FunctionsCalledThroughTheirNameCheckTheirArgumentsWhenCalled) {
  define("(defun two (a b) (list a b))");

  expect({{"(funcall #'two 1)", "error: 'two' takes 2 arguments, got 1"},
          {"(mapcar #'two '(1))", "error: 'mapcar': 'two' takes 2 arguments, got 1"},
          {"(apply #'cons '(1 2 3))", "error: 'apply': 'cons' takes 2 arguments"}});
}

TEST_F(LispScoping, TheStepLimitHoldsForEachEvaluationAnew) {
  lisp().limit_steps(200);

  EXPECT_EQ(value("(dotimes (i 10) i)"), "nil");
  EXPECT_EQ(value("(dotimes (i 10) i)"), "nil");
  EXPECT_EQ(value("(dotimes (i 1000) i)"), "error: the evaluation takes too many steps");
  EXPECT_EQ(value("(dotimes (i 10) i)"), "nil");
}

}  // namespace
}  // namespace skein::htn
