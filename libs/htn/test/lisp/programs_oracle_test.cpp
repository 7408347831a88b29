// SPDX-License-Identifier: Apache-2.0
// Programs that assign, loop and leave blocks, against a walk over their tree; and what happens to
// them in functions and lambdas.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing/drawn_program.hpp"
#include "testing/lisp_fixture.hpp"

namespace skein::htn {
namespace {

using test::DrawnProgram;
using test::LispFixture;

RC_GTEST_PROP(LispPrograms, GiveWhatAWalkOverTheirTreeGives, ()) {
  const DrawnProgram program = DrawnProgram::drawn();
  LispFixture lisp;
  RC_LOG() << program.text();

  RC_ASSERT(lisp.value(program.text()) == program.expected());
}

RC_GTEST_PROP(LispPrograms, GiveTheSameAsTheBodyOfAFunctionAndOfALambda, ()) {
  const DrawnProgram program = DrawnProgram::drawn();
  LispFixture lisp;
  lisp.define("(defun run (unused) " + program.text() + ")");
  RC_LOG() << program.text();

  RC_ASSERT(lisp.value("(run 1)") == program.expected());
  RC_ASSERT(lisp.value("(funcall (lambda () " + program.text() + "))") == program.expected());
  RC_ASSERT(lisp.value("(list (run 1) (second (list 1 " + program.text() + ")))") ==
            "(" + program.expected() + " " + program.expected() + ")");
}

RC_GTEST_PROP(LispPrograms, LeaveTheVariablesAroundThemAlone, ()) {
  const DrawnProgram program = DrawnProgram::drawn();
  LispFixture lisp;
  RC_LOG() << program.text();

  RC_ASSERT(lisp.value("(let ((v0 'a) (out 'b)) " + program.text() + " (list v0 out))") == "(a b)");
}

}  // namespace
}  // namespace skein::htn
