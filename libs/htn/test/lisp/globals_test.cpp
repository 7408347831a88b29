// SPDX-License-Identifier: Apache-2.0
// What a Lisp program keeps and changes: global variables, loops, hash tables, arrays.
#include <gtest/gtest.h>

#include "testing/lisp_fixture.hpp"
#include "testing/planner_case.hpp"

namespace skein::htn {
namespace {

using test::adds;
using test::Case;

class Globals : public testing::Test, public test::LispFixture {
 protected:
  void define_variable(const std::string& name, const std::string& value) {
    FunctionDefinition definition;
    definition.variable = true;
    definition.name = name;
    if (!value.empty()) definition.body.push_back(read(value));
    definitions.push_back(definition);
    restart();
  }
};

TEST_F(Globals, KeepWhatWasAssignedUntilTheNextSearchBegins) {
  define_variable("counter", "10");
  define_variable("*limit*", "(+ 1 2)");
  lisp().begin();

  EXPECT_EQ(value("(incf counter)"), "11");
  EXPECT_EQ(value("(progn (setf *limit* (* *limit* counter)) (list counter *limit*))"), "(11 33)");
  lisp().begin();

  EXPECT_EQ(value("(list counter *limit*)"), "(10 3)");
}

TEST_F(Globals, NeedNoDefinitionWhenTheyAreWrittenWithStars) {
  EXPECT_EQ(value("(list *tc*)"), "(*tc*)") << "a symbol stands for itself";
  EXPECT_EQ(value("(progn (setf *tc* 3) (+ *tc* 1))"), "4");
  EXPECT_EQ(value("*tc*"), "3");
}

TEST_F(Globals, OfOneFunctionAreThoseOfAnother) {
  define("(defun remember (x) (push x *seen*))");
  define("(defun how-many () (length *seen*))");

  EXPECT_EQ(value("(progn (setf *seen* nil) (remember 1) (remember 2) (how-many))"), "2");
}

TEST_F(Globals, AreHiddenByLocalsOfTheirName) {
  EXPECT_EQ(value("(progn (setf *x* 1) (let ((*x* 2)) (setq *x* 5)) *x*)"), "1");
}

TEST_F(Globals, AreNoOtherNames) {
  EXPECT_NE(value("(setq total 1)").find("only a variable of the code can be assigned"),
            std::string::npos);
}

TEST_F(Globals, DoStepsAllVariablesAtOnce) {
  EXPECT_EQ(value("(do ((i 0 (1+ i)) (sum 0 (+ sum i))) ((= i 4) sum))"), "6");
  EXPECT_EQ(value("(do* ((i 0 (1+ i)) (sum 0 (+ sum i))) ((= i 4) sum))"), "10");
  EXPECT_EQ(value("(do ((i 0 (1+ i)) (seen nil)) ((> i 2) seen) (push i seen))"), "(2 1 0)");
  EXPECT_EQ(value("(do ((i 0 (1+ i))) ((> i 2)))"), "nil");
  EXPECT_EQ(value("(do ((l '(a b) (cdr l))) ((null l) 'end) (if (eq (car l) 'b) (return l)))"),
            "(b)");
  EXPECT_NE(value("(do ((i 0)) (nil))").find("too many steps"), std::string::npos);
}

TEST_F(Globals, DoSharesItsVariablesWithLambdas) {
  EXPECT_EQ(value("(let ((fs nil)) (do ((i 0 (1+ i))) ((= i 3)) (push (lambda () i) fs)) "
                  "(mapcar #'funcall fs))"),
            "(3 3 3)");
}

TEST_F(Globals, HashTablesGiveWhatWasPutIn) {
  const std::string table = "(progn (setf *t* (make-hash-table :test #'equal)) ";
  EXPECT_EQ(value(table + "(setf (gethash '(a 1) *t*) 5) (gethash '(a 1) *t*))"), "5");
  EXPECT_EQ(value(table + "(list (gethash 'b *t*) (gethash 'b *t* 7)))"), "(nil 7)");
  EXPECT_EQ(value(table + "(setf (gethash 'a *t*) 1 (gethash 'b *t*) 2) (remhash 'a *t*) "
                          "(list (hash-table-count *t*) (gethash 'a *t*)))"),
            "(1 nil)");
  EXPECT_EQ(value("(progn (setf *t* (make-hash-table :test 'equalp)) (setf (gethash 1 *t*) 'one) "
                  "(gethash 1.0 *t*))"),
            "one");
  EXPECT_NE(value("(gethash 'a 'b)").find("expected a hash table"), std::string::npos);
}

TEST_F(Globals, ArraysHaveBounds) {
  EXPECT_EQ(value("(let ((a (make-array 3 :initial-element 0))) (setf (aref a 1) 5) "
                  "(list (aref a 0) (aref a 1) (array-dimension a 0)))"),
            "(0 5 3)");
  EXPECT_EQ(value("(let ((a (make-array '(2 3)))) (setf (aref a 1 2) 'x) (aref a 1 2))"), "x");
  EXPECT_NE(value("(aref (make-array 3) 3)").find("expected an index below 3"), std::string::npos);
  EXPECT_NE(value("(aref (make-array '(2 2)) 1)").find("with 2 indices, not 1"), std::string::npos);
  EXPECT_NE(value("(make-array 1000000000)").find("ten million"), std::string::npos);
}

// In a domain.

TEST_F(Globals, OfADomainBeginAnewWithEachSearch) {
  Case made(
      "(:method (go) ((eval (setf *n* (+ 1 (if (numberp *n*) *n* 0)))) (assign ?n *n*)) "
      "((!a ?n) (!b ?n)))" +
          adds("(!a ?n)", "") + adds("(!b ?n)", ""),
      "", "((go) (go))");

  EXPECT_EQ(made.first(), "(!a 1) (!b 1) (!a 2) (!b 2)");
  EXPECT_EQ(made.first(), "(!a 1) (!b 1) (!a 2) (!b 2)") << "nothing is left of the first search";
}

}  // namespace
}  // namespace skein::htn
