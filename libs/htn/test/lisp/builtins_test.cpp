// SPDX-License-Identifier: Apache-2.0
// Every built-in function, by theme.
#include <gtest/gtest.h>

#include <set>

#include "lisp/builtins.hpp"
#include "testing/lisp_fixture.hpp"

namespace skein::htn {
namespace {

using Cases = std::vector<std::pair<std::string, std::string>>;

class LispBuiltins : public ::testing::Test, protected test::LispFixture {
 protected:
  void expect(const Cases& cases) {
    for (const auto& [text, expected] : cases) EXPECT_EQ(value(text), expected) << text;
  }
};

TEST_F(LispBuiltins, ArithmeticKeepsTheKindsOfLisp) {
  expect({{"(+)", "0"},
          {"(*)", "1"},
          {"(+ 1 2 3)", "6"},
          {"(+ 1.01 3 0.01)", "4.0200005"},
          {"(- 3)", "-3"},
          {"(- 10 1 2)", "7"},
          {"(- 0.0)", "-0.0"},
          {"(* 2 1/4)", "1/2"},
          {"(/ 1 3)", "1/3"},
          {"(/ 6 3)", "2"},
          {"(/ 2)", "1/2"},
          {"(/ 6 4.0)", "1.5"},
          {"(+ 0.01L0 1)", "1.01"},
          {"(1+ 1.5)", "2.5"},
          {"(1- 1)", "0"},
          {"(abs -3)", "3"},
          {"(abs -1/2)", "1/2"},
          {"(abs -0.5)", "0.5"},
          {"(abs 2)", "2"},
          {"(float 3)", "3.0"},
          {"(float 1/3)", "0.33333334"},
          {"(float 1/3 1d0)", "0.3333333333333333"},
          {"(float 0.5d0)", "0.5"},
          {"(float 0.1d0 1.0)", "0.1"},
          {"(sqrt 16)", "4.0"},
          {"(sqrt 2.0d0)", "1.4142135623730951"},
          {"(expt 2 10)", "1024"},
          {"(expt 2 -2)", "1/4"},
          {"(expt 1/2 2)", "1/4"},
          {"(expt 2.0 3)", "8.0"},
          {"(expt 2 0.5)", "1.4142135"},
          {"(expt 5 0)", "1"}});
}

TEST_F(LispBuiltins, MaxAndMinGiveTheFirstOfTheExtremeArgumentsAsItIs) {
  expect({{"(max 1 3 2)", "3"},
          {"(max 1 2.5)", "2.5"},
          {"(max 3 2.5)", "3"},
          {"(max 1 1.0)", "1"},
          {"(max 0.0 0)", "0.0"},
          {"(min 1 1.0)", "1"},
          {"(min 3 1/2 0.75)", "1/2"}});
}

TEST_F(LispBuiltins, RoundingFollowsTheDivisor) {
  expect({{"(floor 7 2)", "3"},
          {"(floor -7 2)", "-4"},
          {"(floor 7 -2)", "-4"},
          {"(ceiling 7 2)", "4"},
          {"(ceiling -7 2)", "-3"},
          {"(truncate -7 2)", "-3"},
          {"(round 5/2)", "2"},
          {"(round 7/2)", "4"},
          {"(round -7/2)", "-4"},
          {"(round 2.5)", "2"},
          {"(round -2.6)", "-3"},
          {"(floor 2.7)", "2"},
          {"(ceiling 2.1d0)", "3"},
          {"(mod -7 3)", "2"},
          {"(mod 7 -3)", "-2"},
          {"(rem -7 3)", "-1"},
          {"(mod 5.5 2)", "1.5"},
          {"(mod -5.5 2)", "0.5"},
          {"(rem -5.5d0 2)", "-1.5"},
          {"(mod 7/2 1)", "1/2"},
          {"(mod -9223372036854775808 -1)", "0"}});
}

TEST_F(LispBuiltins, ComparisonsHoldBetweenAllNeighbours) {
  expect({{"(= 1 1.0 1)", "t"},
          {"(= 1 2)", "nil"},
          {"(= 1/2 0.5)", "t"},
          {"(= 'a 'a)", "t"},
          {"(= 'a 'b)", "nil"},
          {"(= 'a 1)", "nil"},
          {"(/= 1 2 3)", "t"},
          {"(/= 1 2 1)", "nil"},
          {"(< 1 2 3)", "t"},
          {"(< 1 3 2)", "nil"},
          {"(<= 1 1 2)", "t"},
          {"(> 3 2.5 1/2)", "t"},
          {"(>= 2 2 3)", "nil"},
          {"(< 1)", "t"}});
}

TEST_F(LispBuiltins, EqualitiesCompareTermsAsWritten) {
  expect({{"(eq 'a 'a)", "t"},
          {"(eql 1 1.0)", "nil"},
          {"(eql 1.0 1.0d0)", "nil"},
          {"(equal '(1 (b)) (list 1 (list 'b)))", "t"},
          {"(equal \"a\" \"A\")", "nil"},
          {"(equalp \"a\" \"A\")", "t"},
          {"(equalp 1 1.0)", "t"},
          {"(equalp '(1 (\"A\")) '(1.0 (\"a\")))", "t"},
          {"(equalp 1 2)", "nil"}});
}

TEST_F(LispBuiltins, PredicatesTellKindsApart) {
  expect({{"(not nil)", "t"},         {"(null '(a))", "nil"},    {"(endp nil)", "t"},
          {"(consp '(a))", "t"},      {"(consp nil)", "nil"},    {"(listp nil)", "t"},
          {"(listp 'a)", "nil"},      {"(atom 'a)", "t"},        {"(atom '(a))", "nil"},
          {"(symbolp 'a)", "t"},      {"(symbolp nil)", "t"},    {"(symbolp 1)", "nil"},
          {"(numberp 1/2)", "t"},     {"(numberp 'a)", "nil"},   {"(realp 1.5)", "t"},
          {"(integerp 1)", "t"},      {"(integerp 1.0)", "nil"}, {"(rationalp 1/2)", "t"},
          {"(floatp 1d0)", "t"},      {"(floatp 1)", "nil"},     {"(stringp \"a\")", "t"},
          {"(stringp 'a)", "nil"},    {"(zerop 0.0)", "t"},      {"(zerop 1)", "nil"},
          {"(plusp 1/2)", "t"},       {"(plusp 0)", "nil"},      {"(minusp -1)", "t"},
          {"(evenp -2)", "t"},        {"(oddp -3)", "t"},        {"(oddp 2)", "nil"},
          {"(variablep '?x)", "t"},   {"(variablep 'x)", "nil"}, {"(functionp (lambda () 1))", "t"},
          {"(functionp 'car)", "nil"}});
}

TEST_F(LispBuiltins, ListsAreBuiltAndTakenApart) {
  expect({{"(list)", "nil"},
          {"(list 1 'a)", "(1 a)"},
          {"(list* 1 2 '(3))", "(1 2 3)"},
          {"(list* 1 2)", "(1 . 2)"},
          {"(cons 1 nil)", "(1)"},
          {"(car '(a b))", "a"},
          {"(cdr '(a b))", "(b)"},
          {"(rest '(a b))", "(b)"},
          {"(car nil)", "nil"},
          {"(cdr nil)", "nil"},
          {"(caar '((a) b))", "a"},
          {"(cadr '(a b))", "b"},
          {"(cdar '((a b)))", "(b)"},
          {"(cddr '(a b c))", "(c)"},
          {"(caddr '(a b c))", "c"},
          {"(cdddr '(a b c d))", "(d)"},
          {"(cadddr '(a b c d))", "d"},
          {"(nth 1 '(a b c))", "b"},
          {"(nth 5 '(a b c))", "nil"},
          {"(elt '(a b c) 2)", "c"},
          {"(nthcdr 2 '(a b c))", "(c)"},
          {"(nthcdr 5 '(a b c))", "nil"},
          {"(last '(a b c))", "(c)"},
          {"(last '(a b c) 2)", "(b c)"},
          {"(butlast '(a b c))", "(a b)"},
          {"(append)", "nil"},
          {"(append '(a) nil '(b c) 'd)", "(a b c . d)"},
          {"(length '(a b))", "2"},
          {"(length \"abc\")", "3"},
          {"(list-length nil)", "0"},
          {"(reverse '(1 2 3))", "(3 2 1)"},
          {"(nreverse '(1 2))", "(2 1)"},
          {"(copy-list '(1 2))", "(1 2)"},
          {"(copy-tree '(1 (2)))", "(1 (2))"},
          {"(getf '(:a 1 :b 2) :b)", "2"},
          {"(getf '(:a 1) :c 'none)", "none"},
          {"(identity 5)", "5"},
          {"(values 1 2)", "1"},
          {"(values)", "nil"}});
}

TEST_F(LispBuiltins, OrdinalsCountFromFirstToTenth) {
  const std::vector<std::string> ordinals{"first", "second",  "third",  "fourth", "fifth",
                                          "sixth", "seventh", "eighth", "ninth",  "tenth"};

  for (std::size_t at = 0; at < ordinals.size(); ++at) {
    EXPECT_EQ(value("(" + ordinals[at] + " '(0 1 2 3 4 5 6 7 8 9))"), std::to_string(at));
    EXPECT_EQ(value("(" + ordinals[at] + " nil)"), "nil");
  }
}

TEST_F(LispBuiltins, SearchesHonourTestAndKey) {
  expect({{"(member 'b '(a b c))", "(b c)"},
          {"(member 'x '(a b c))", "nil"},
          {"(member 2.0 '(1 2 3) :test #'=)", "(2 3)"},
          {"(member 2 '((1 a) (2 b)) :key #'car)", "((2 b))"},
          {"(member 1 '(1 1 2) :test-not #'eql)", "(2)"},
          {"(member '(a) '((b) (a)) :test #'equal)", "((a))"},
          {"(member-if #'evenp '(1 2 3))", "(2 3)"},
          {"(find 2 '((1 a) (2 b)) :key #'car)", "(2 b)"},
          {"(find-if #'oddp '(2 3 4))", "3"},
          {"(find-if-not #'oddp '(1 2))", "2"},
          {"(position 'c '(a b c c))", "2"},
          {"(position 'c '(a b c c) :from-end t)", "3"},
          {"(position-if #'plusp '(-1 0 1))", "2"},
          {"(position-if-not #'plusp '(1 0))", "1"},
          {"(count 'a '(a b a))", "2"},
          {"(count-if #'evenp '(1 2 4))", "2"},
          {"(count-if-not #'evenp '(1 2 4))", "1"},
          {"(assoc 'b '((a . 1) (b . 2)))", "(b . 2)"},
          {"(assoc 2.0 '((1 a) nil (2 b)) :test #'=)", "(2 b)"},
          {"(rassoc 2 '((a . 1) (b . 2)))", "(b . 2)"}});
}

TEST_F(LispBuiltins, FiltersKeepTheOrder) {
  expect({{"(remove 'a '(a b a c))", "(b c)"},
          {"(delete 'a '(a b))", "(b)"},
          {"(remove-if #'evenp '(1 2 3))", "(1 3)"},
          {"(remove-if-not #'evenp '(1 2 3))", "(2)"},
          {"(remove-if #'evenp '((1) (2)) :key #'car)", "((1))"},
          {"(delete-if #'evenp '(1 2))", "(1)"},
          {"(delete-if-not #'evenp '(1 2))", "(2)"},
          {"(remove-duplicates '(1 2 1 3))", "(2 1 3)"},
          {"(remove-duplicates '(1 2 1 3) :from-end t)", "(1 2 3)"},
          {"(delete-duplicates '((a 1) (a 2)) :key #'car)", "((a 2))"},
          {"(remove-duplicates '(1 1.0) :test #'=)", "(1.0)"}});
}

TEST_F(LispBuiltins, SetsComeInTheOrderOfSbcl) {
  expect({{"(union '(1 2) '(2 3 4))", "(4 3 1 2)"},
          {"(union '(1 2 3) '(2 4))", "(3 1 2 4)"},
          {"(intersection '(1 2 3) '(3 2))", "(3 2)"},
          {"(set-difference '(1 2 3 4) '(3))", "(4 2 1)"},
          {"(set-difference '(1 2) nil)", "(1 2)"},
          {"(intersection '((a 1) (b 2)) '((b 3)) :key #'car)", "((b 2))"},
          {"(subsetp '(1 2) '(2 3 1))", "t"},
          {"(subsetp '(1 5) '(2 3 1))", "nil"},
          {"(adjoin 1 '(2))", "(1 2)"},
          {"(adjoin 2 '(2))", "(2)"}});
}

TEST_F(LispBuiltins, MappingCallsTheFunctionOnEachRow) {
  expect({{"(mapcar #'1+ '(1 2))", "(2 3)"},
          {"(mapcar #'+ '(1 2 3) '(10 20))", "(11 22)"},
          {"(mapcar #'list nil)", "nil"},
          {"(mapc #'list '(1 2))", "(1 2)"},
          {"(mapcan (lambda (x) (list x x)) '(1 2))", "(1 1 2 2)"},
          {"(some #'evenp '(1 2))", "t"},
          {"(some (lambda (x) (and (> x 1) x)) '(1 2 3))", "2"},
          {"(some #'evenp nil)", "nil"},
          {"(every #'evenp '(2 4))", "t"},
          {"(every #'< '(1 2) '(2 2))", "nil"},
          {"(every #'evenp nil)", "t"},
          {"(notany #'evenp '(1 3))", "t"},
          {"(notevery #'evenp '(2 3))", "t"},
          {"(apply #'+ 1 2 '(3 4))", "10"},
          {"(apply #'list nil)", "nil"},
          {"(mapcar #'funcall '(car cdr) '((1) (2 3)))", "(1 (3))"},
          {"(reduce #'+ '(1 2 3))", "6"},
          {"(reduce #'+ '(1 2 3) :initial-value 10)", "16"},
          {"(reduce #'list '(1 2 3) :from-end t)", "(1 (2 3))"},
          {"(reduce #'max '((1) (3) (2)) :key #'car)", "3"},
          {"(reduce #'+ nil)", "0"}});
}

TEST_F(LispBuiltins, SortingIsStable) {
  expect({{"(sort '(3 1 2) #'<)", "(1 2 3)"},
          {"(sort '(3 1 2) #'>)", "(3 2 1)"},
          {"(sort nil #'<)", "nil"},
          {"(stable-sort '((2 a) (1 b) (2 c) (1 d)) #'< :key #'car)", "((1 b) (1 d) (2 a) (2 c))"},
          {"(sort '(1 2 3 4 5) (lambda (x y) t))", "(5 4 3 2 1)"}});
}

TEST_F(LispBuiltins, TextsAreComparedAndMade) {
  expect({{"(string= \"a\" \"a\")", "t"},
          {"(string= \"a\" \"A\")", "nil"},
          {"(string= 'a \"A\")", "t"},
          {"(string-equal \"a\" \"A\")", "t"},
          {"(symbol-name 'karma)", "\"karma\""},
          {"(intern \"Truck1\")", "truck1"},
          {"(string 'a)", "\"a\""},
          {"(princ-to-string '(1 a))", "\"(1 a)\""},
          {"(concatenate 'string \"ab\" \"c\")", "\"abc\""},
          {"(format nil \"~a is ~s, ~d~%~~\" \"x\" \"y\" 5)", "\"x is \\\"y\\\", 5\n~\""},
          {"(format t \"~a\" 'x)", "nil"}});
}

TEST_F(LispBuiltins, PrintingGivesItsValueOnly) {
  expect({{"(print 'a)", "a"},
          {"(princ 'a)", "a"},
          {"(prin1 '(a))", "(a)"},
          {"(pprint 'a)", "nil"},
          {"(terpri)", "nil"},
          {"(print-current-state)", "t"},
          {"(print-current-state :sorted t)", "t"},
          {"(print-current-tasks)", "t"},
          {"(print-current-plan)", "t"},
          {"(print-last-action)", "t"},
          {"(query-current-state 'at)", "nil"}});
}

TEST_F(LispBuiltins, ErrorsEndTheEvaluationWithTheirMessage) {
  EXPECT_EQ(value("(error \"no way from ~a to ~a\" 'here '(there))"),
            "error: no way from here to (there)");
  EXPECT_EQ(value("(error 'impossible)"), "error: impossible");
}

TEST(LispTables, NameEachFunctionOnceAndBelowItsLargestCount) {
  std::set<std::string_view> names;

  for (const auto table : lisp::all_builtins()) {
    for (const lisp::Builtin& builtin : table) {
      EXPECT_TRUE(names.insert(builtin.name).second) << builtin.name;
      EXPECT_LE(builtin.least, builtin.most) << builtin.name;
    }
  }
}

}  // namespace
}  // namespace skein::htn
