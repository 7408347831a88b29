// SPDX-License-Identifier: Apache-2.0
// What is wrong with an expression is said when it is loaded, or with its place when it is run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/lisp_fixture.hpp"

namespace skein::htn {
namespace {

using testing::HasSubstr;

class LispErrors : public ::testing::Test, protected test::LispFixture {
 protected:
  Diagnostics load(const std::string& text) {
    Diagnostics errors;
    EXPECT_EQ(lisp().compile(read(text), slot_of(), errors), kNoCode) << text;
    return errors;
  }
  std::string repeated(const std::string& text, int count) {
    std::string out;
    for (int at = 0; at < count; ++at) out += text;
    return out;
  }
};

TEST_F(LispErrors, AllErrorsOfAnExpressionAreReported) {
  const Diagnostics errors = load("(+ (lenght ?x)\n  (car)\n  (if))");

  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(to_text(errors.all()[0]),
            "test.lisp:1:5: unknown function 'lenght'; did you mean 'length'?");
  EXPECT_EQ(to_text(errors.all()[1]),
            "test.lisp:2:4: 'car' with no arguments; expected 1 argument");
  EXPECT_EQ(to_text(errors.all()[2]),
            "test.lisp:3:3: 'if' with no arguments; expected 2 to 3 arguments");
}

TEST_F(LispErrors, UnknownFunctionsOfAnyUseAreErrors) {
  define("(defun helper (x) x)");

  EXPECT_EQ(value("(helpr 1)"),
            "load: test.lisp:1:2: unknown function 'helpr'; did you mean 'helper'?");
  EXPECT_THAT(value("(mapcar #'helpr '(1))"), HasSubstr("did you mean 'helper'?"));
  EXPECT_THAT(value("(funcall 'helpr 1)"), HasSubstr("did you mean 'helper'?"));
  EXPECT_EQ(value("(mapcar 'helpr '(1))"), "error: 'mapcar': helpr is not a function");
  EXPECT_EQ(value("(apply 5 nil)"), "error: 'apply': 5 is not a function");
  EXPECT_EQ(value("(funcall nil)"), "error: nil is not a function");
}

TEST_F(LispErrors, ArgumentCountsOfDefunsAreCheckedWhenLoading) {
  define("(defun f (a &optional b) a)");
  define("(defun g (a &rest b) a)");

  EXPECT_THAT(value("(f)"), HasSubstr("'f' with no arguments; expected 1 to 2 arguments"));
  EXPECT_THAT(value("(f 1 2 3)"), HasSubstr("'f' with 3 arguments"));
  EXPECT_THAT(value("(g)"), HasSubstr("expected at least 1 argument"));
  EXPECT_EQ(value("(g 1 2 3)"), "1");
}

TEST_F(LispErrors, WhatNoDomainUsesMayContainAnything) {
  define("(defun odd-one (x) (loop for y in x collect (no-such-thing y)))");
  define("(defun fine (x) (1+ x))");

  EXPECT_EQ(value("(fine 1)"), "2");
}

TEST_F(LispErrors, WhatADomainUsesIsCompiledWithAllThatItCalls) {
  define("(defun outer (x)\n (middle x))");
  define("(defun middle (x)\n (no-such-thing x))");

  EXPECT_EQ(value("(outer 1)"), "load: test.lisp:2:3: unknown function 'no-such-thing'");
  EXPECT_EQ(value("(middle 1)"), "load: test.lisp:1:2: function 'middle' has errors");
}

TEST_F(LispErrors, TheErrorOfADefunThatOnlyItsNameLeadsToIsFoundWhenItIsCalled) {
  define("(defun bad (x) (no-such-thing x))");

  EXPECT_THAT(value("(mapcar 'bad '(1))"), HasSubstr("unknown function 'no-such-thing'"));
  EXPECT_THAT(value("(mapcar 'bad '(1))"), HasSubstr("function 'bad' has errors"));
}

TEST_F(LispErrors, TheLastDefinitionOfANameCounts) {
  define("(defun f () 1)");
  define("(defun f () 2)");

  EXPECT_EQ(value("(f)"), "2");
}

TEST_F(LispErrors, EvaluationErrorsHaveThePlaceOfTheInnermostExpression) {
  define("(defun f (x)\n  (list x\n    (+ x 'b)))");
  Diagnostics errors;

  const CodeIndex code = lisp().compile(read("(mapcar #'f '(1 2))"), slot_of(), errors);
  const auto result = evaluated(code);

  ASSERT_FALSE(result);
  const Expression where = result.error().where;
  EXPECT_EQ(place_of(*where.document, (*where).begin).line, 3);
  EXPECT_EQ(result.error().why, "'mapcar': '+': argument 2 is the symbol b, expected a number");
}

TEST_F(LispErrors, WrongArgumentsSayWhatWasExpected) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"(car 5)", "'car': argument 1 is 5, expected a list"},
      {"(length '(1 . 2))", "'length': argument 1 is (1 . 2), expected a list"},
      {"(nth -1 '(1))", "'nth': argument 1 is -1, expected no negative integer"},
      {"(nth 0.5 '(1))", "'nth': argument 1 is 0.5, expected an integer"},
      {"(< 1 'a)", "'<': argument 2 is the symbol a, expected a number"},
      {"(sqrt -1)", "'sqrt': argument 1 is -1, expected a number that is not negative"},
      {"(evenp 1.5)", "'evenp': argument 1 is 1.5, expected an integer"},
      {"(append 1 '(2))", "'append': argument 1 is 1, expected a list"},
      {"(assoc 1 '(1))", "'assoc': argument 2 is (1), expected a list of pairs"},
      {"(symbol-name 5)", "'symbol-name': argument 1 is 5, expected a symbol"},
      {"(string= 5 \"a\")", "'string=': argument 1 is 5, expected a string or a symbol"},
      {"(member 1 '(1) :tset #'eq)",
       "'member': unknown option :tset, expected :test, :test-not, :key, :from-end"},
      {"(member 1 '(1) :test)", "'member': option :test without value"},
      {"(format nil \"~a\")", "'format': too few arguments for the text"},
      {"(sort '(2 1) 'car)", "'sort': 'car' takes 1 argument"},
      {"(expt 2 70)", "'expt': the result is an integer beyond 64 bits"},
      {"(mod 1 0)", "'mod': division by zero"},
      {"(truncate 1e20)", "'truncate': the result is an integer beyond 64 bits"},
      {"(floor 'a)", "'floor': argument 1 is the symbol a, expected a number"}};

  for (const auto& [text, why] : cases) EXPECT_EQ(value(text), "error: " + why) << text;
}

TEST_F(LispErrors, MalformedFormsAreLoadErrors) {
  for (const char* text : {"(1 2)",
                           "((foo) 1)",
                           "(car . a)",
                           "(let ((x 1 2)) x)",
                           "(let ((5 1)) 5)",
                           "(let (()) 1)",
                           "(lambda)",
                           "(lambda 5 1)",
                           "(lambda (x . y) 1)",
                           "(lambda (&key x) x)",
                           "(lambda (&rest a b) a)",
                           "(lambda ((a b)) a)",
                           "(lambda (&optional (a 1 2)) a)",
                           "(cond ())",
                           "(cond 5)",
                           "(case 1 ())",
                           "(dolist (x) x)",
                           "(dolist x)",
                           "(dotimes (i) i)",
                           "(setq x)",
                           "(function 5)",
                           "(function if)",
                           "(destructuring-bind (&key x) '(1) x)",
                           "(destructuring-bind 5 '(1) x)",
                           "``a",
                           "`(a `b)",
                           "(return-from nowhere 1)",
                           "(call)",
                           "(comma x)"}) {
    Diagnostics errors;
    EXPECT_EQ(lisp().compile(read(text), slot_of(), errors), kNoCode) << text;
    EXPECT_FALSE(errors.empty()) << text;
  }
}

TEST_F(LispErrors, EndlessEvaluationsRunIntoTheStepLimit) {
  define("(defun for-ever (x) (for-ever-2 x))");
  define("(defun for-ever-2 (x) (dotimes (i 1000000000 x) (list i)))");

  EXPECT_EQ(value("(for-ever 1)"), "error: the evaluation takes too many steps");
  lisp().limit_steps(100);
  EXPECT_EQ(value("(dotimes (i 1000) i)"), "error: the evaluation takes too many steps");
  EXPECT_EQ(value("(dotimes (i 3) i)"), "nil");
}

TEST_F(LispErrors, StepsCountTheItemsOfListsToo) {
  EXPECT_THAT(value("(let ((l '(a b))) (dotimes (i 40) (setq l (append l l))) (length l))"),
              HasSubstr("the evaluation takes too many steps"));
}

TEST_F(LispErrors, TextsDoNotGrowBeyondReason) {
  EXPECT_EQ(value("(let ((s \"ab\")) (dotimes (i 40) (setq s (format nil \"~a~a\" s s))) s)"),
            "error: 'format': the text becomes too long");
}

TEST_F(LispErrors, DeepRecursionIsAnErrorNotACrash) {
  define("(defun deep (n) (if (= n 0) 0 (1+ (deep (1- n)))))");
  define("(defun mapped (n) (mapcar #'mapped (list (1+ n))))");

  EXPECT_EQ(value("(deep 15000)"), "15000");
  EXPECT_EQ(value("(deep 1000000)"),
            "error: too many calls inside each other, or too many arguments");
  EXPECT_THAT(value("(mapped 0)"),
              HasSubstr("too many calls inside each other, or too many arguments"));
  EXPECT_EQ(value("(deep 10)"), "10");
}

TEST_F(LispErrors, DeepExpressionsAreAnErrorNotACrash) {
  const int depth = 100'000;

  EXPECT_THAT(value(repeated("(1+ ", depth) + "0" + repeated(")", depth)),
              HasSubstr("nested too deeply"));
  EXPECT_THAT(value("`" + repeated("(", depth) + ",1" + repeated(")", depth)), HasSubstr("load: "));
  EXPECT_THAT(task(repeated("(a ", depth) + "(call + 1 1)" + repeated(")", depth)),
              HasSubstr("nested too deeply"));
  EXPECT_EQ(value(repeated("(1+ ", 300) + "0" + repeated(")", 300)), "300");
}

TEST_F(LispErrors, DeepDataIsNoProblem) {
  set("?x", "end");
  const int depth = 100'000;
  const std::string text = repeated("(a ", depth) + "?x" + repeated(")", depth);

  const std::string result = task(text);

  EXPECT_EQ(result.size(), text.size() + 1);
  EXPECT_EQ(value("(consp '" + text + ")"), "t");
}

TEST_F(LispErrors, AWideExpressionIsNoProblem) {
  EXPECT_EQ(value("(+" + repeated(" 1", 50'000) + ")"), "50000");
  EXPECT_EQ(value("(+" + repeated(" 1", 300'000) + ")"),
            "error: too many calls inside each other, or too many arguments");
}

}  // namespace
}  // namespace skein::htn
