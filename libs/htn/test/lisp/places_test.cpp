// SPDX-License-Identifier: Apache-2.0
// Hash tables, arrays and texts: what they hold, what they refuse, and the ends of their sizes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "testing/lisp_fixture.hpp"

namespace skein::htn {
namespace {

using ::testing::HasSubstr;
using Cases = std::vector<std::pair<std::string, std::string>>;

class LispPlaces : public ::testing::Test, protected test::LispFixture {
 protected:
  void expect(const Cases& cases) {
    for (const auto& [text, expected] : cases) EXPECT_EQ(value(text), expected) << text;
  }
  /// `body` with a new table of the test in `h`.
  static std::string with_table(const std::string& body, const std::string& test = "equal") {
    return "(let ((h (make-hash-table :test '" + test + "))) " + body + ")";
  }
};

// ---- hash tables -----------------------------------------------------------------------------

TEST_F(LispPlaces, ATableCountsItsKeysOnce) {
  expect({{with_table("(hash-table-count h)"), "0"},
          {with_table("(setf (gethash 'a h) 1) (setf (gethash 'a h) 2) (hash-table-count h)"), "1"},
          {with_table("(setf (gethash 'a h) 1) (setf (gethash 'a h) 2) (gethash 'a h)"), "2"}});
}

TEST_F(LispPlaces, PuttingGivesWhatWasPut) {
  expect({{with_table("(setf (gethash 'a h) 5)"), "5"},
          {"(let ((a (make-array 2))) (setf (aref a 0) 'x))", "x"}});
}

TEST_F(LispPlaces, RemovingSaysWhetherSomethingWasThere) {
  expect({{with_table("(remhash 'a h)"), "nil"},
          {with_table("(setf (gethash 'a h) nil) (remhash 'a h)"), "t"},
          {with_table("(setf (gethash 'a h) 1) (remhash 'a h) (gethash 'a h 'gone)"), "gone"}});
}

TEST_F(LispPlaces, AValueOfNilIsNoMissingValue) {
  expect({{with_table("(setf (gethash 'a h) nil) (gethash 'a h 'default)"), "nil"},
          {with_table("(gethash 'a h 'default)"), "default"}});
}

TEST_F(LispPlaces, ClearingLeavesTheTableEmpty) {
  expect({{with_table("(setf (gethash 'a h) 1) (clrhash h) (list (hash-table-count h) "
                      "(gethash 'a h))"),
           "(0 nil)"},
          {with_table("(hash-table-count (clrhash h))"), "0"}});
}

TEST_F(LispPlaces, OnlyTablesOfEqualpTakeCaseAndKindForNothing) {
  const std::string put = "(setf (gethash \"Key\" h) 'text (gethash 1 h) 'number)";
  const std::string get = "(list (gethash \"KEY\" h) (gethash 1.0 h))";

  expect({{with_table(put + get, "equalp"), "(text number)"},
          {with_table(put + get, "equal"), "(nil nil)"},
          {"(let ((h (make-hash-table))) " + put + get + ")", "(nil nil)"},
          {"(let ((h (make-hash-table :size 10 :test #'equalp))) " + put + get + ")",
           "(text number)"}});
}

TEST_F(LispPlaces, TwoTablesAreTwo) {
  expect(
      {{"(let ((g (make-hash-table)) (h (make-hash-table))) (setf (gethash 'a g) 1) "
        "(list (gethash 'a g) (gethash 'a h) (eq g h) (eq g g)))",
        "(1 nil nil t)"}});
}

TEST_F(LispPlaces, WhatIsNoTableIsRefusedByEachFunction) {
  expect({{"(gethash 'a 5)", "error: 'gethash': argument 2 is 5, expected a hash table"},
          {"(remhash 'a nil)", "error: 'remhash': argument 2 is nil, expected a hash table"},
          {"(clrhash '(a))", "error: 'clrhash': argument 1 is (a), expected a hash table"},
          {"(hash-table-count 1)",
           "error: 'hash-table-count': argument 1 is 1, expected a hash table"},
          {"(gethash 'a (make-array 1))",
           "error: 'gethash': argument 2 is #<array>, expected a hash table"}});
  EXPECT_THAT(value("(setf (gethash 'a 5) 1)"), HasSubstr("is 5, expected a hash table"));
}

RC_GTEST_PROP(LispPlacesProperty, ATableIsAMap, ()) {
  const auto changes = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(0, 5), rc::gen::inRange(-3, 10)));
  std::map<int, int> expected;
  std::string body;
  for (const auto& [key, put] : changes) {
    const std::string place = std::to_string(key) + " h";
    if (put < 0) {
      expected.erase(key);
      body += "(remhash " + place + ")";
    } else {
      expected[key] = put;
      body += "(setf (gethash " + place + ") " + std::to_string(put) + ")";
    }
  }
  std::string found = std::to_string(expected.size());
  for (int key = 0; key < 5; ++key)
    found += " " + (expected.contains(key) ? std::to_string(expected[key]) : std::string("none"));
  test::LispFixture lisp;

  RC_ASSERT(lisp.value("(let ((h (make-hash-table))) " + body +
                       "(cons (hash-table-count h) (mapcar (lambda (k) (gethash k h 'none)) "
                       "'(0 1 2 3 4))))") == "(" + found + ")");
}

// ---- arrays ----------------------------------------------------------------------------------

TEST_F(LispPlaces, ANewArrayHoldsNilOrWhatItIsFilledWith) {
  expect({{"(aref (make-array 2) 1)", "nil"},
          {"(aref (make-array 2 :initial-element 'x) 1)", "x"},
          {"(aref (make-array '(2 2) :initial-element 7) 1 0)", "7"},
          {"(aref (make-array nil :initial-element 'alone))", "alone"}});
}

TEST_F(LispPlaces, EachPlaceOfAnArrayIsItsOwn) {
  expect(
      {{"(let ((a (make-array '(2 3)))) "
        "(dotimes (i 2) (dotimes (j 3) (setf (aref a i j) (+ (* 10 i) j)))) "
        "(list (aref a 0 0) (aref a 0 2) (aref a 1 0) (aref a 1 2)))",
        "(0 2 10 12)"}});
}

TEST_F(LispPlaces, DimensionsAreThoseTheArrayWasMadeWith) {
  expect({{"(array-dimension (make-array '(2 3)) 0)", "2"},
          {"(array-dimension (make-array '(2 3)) 1)", "3"},
          {"(array-dimension (make-array '(2 3)) 2)",
           "error: 'array-dimension': argument 2 is 2, expected one of its dimensions"},
          {"(array-dimension (make-array 4) -1)",
           "error: 'array-dimension': argument 2 is -1, expected one of its dimensions"},
          {"(array-dimension 'a 0)",
           "error: 'array-dimension': argument 1 is the symbol a, expected an array"}});
}

TEST_F(LispPlaces, IndicesBeginAtZeroAndEndBelowTheSize) {
  expect(
      {{"(aref (make-array 3) 0)", "nil"},
       {"(aref (make-array 3) 2)", "nil"},
       {"(aref (make-array 3) 3)", "error: 'aref': argument 2 is 3, expected an index below 3"},
       {"(aref (make-array 3) -1)", "error: 'aref': argument 2 is -1, expected an index below 3"},
       {"(aref (make-array '(2 3)) 1 3)",
        "error: 'aref': argument 3 is 3, expected an index below 3"},
       {"(aref (make-array 0) 0)", "error: 'aref': argument 2 is 0, expected an index below 0"},
       {"(aref (make-array 3) 0 0)", "error: 'aref': an array with 1 indices, not 2"},
       {"(aref (make-array 3) 0.5)", "error: 'aref': argument 2 is 0.5, expected an integer"},
       {"(aref '(a) 0)", "error: 'aref': argument 1 is (a), expected an array"}});
}

TEST_F(LispPlaces, ArraysHaveTenMillionItemsAtMost) {
  expect({{"(array-dimension (make-array '(0 10000000)) 1)", "10000000"},
          {"(make-array 10000001)",
           "error: 'make-array': argument 1 is 10000001, expected sizes from 0 to ten million"},
          {"(make-array '(4000 2501))",
           "error: 'make-array': an array of more than ten million items"},
          {"(make-array -1)",
           "error: 'make-array': argument 1 is -1, expected sizes from 0 to ten million"},
          {"(make-array '(2 x))",
           "error: 'make-array': argument 1 is (2 x), expected sizes from 0 to ten million"},
          {"(make-array 'x)",
           "error: 'make-array': argument 1 is the symbol x, expected a size or a list of sizes"}});
}

// ---- texts -----------------------------------------------------------------------------------

TEST_F(LispPlaces, TextsAreFormattedByTheirDirectives) {
  expect({{"(format nil \"~A ~S ~D\" \"x\" \"x\" 5)", "\"x \\\"x\\\" 5\""},
          {"(format nil \"a~&b~%c\")", "\"a\nb\nc\""},
          {"(format nil \"~~a\" 1)", "\"~a\""},
          {"(format nil \"~5x\" 1)", "\"~5x\""},
          {"(format nil \"100~\")", "\"100~\""},
          {"(format nil \"~a\" 1 2)", "\"1\""},
          {"(format nil 'a)", "error: 'format': argument 2 is the symbol a, expected a string"},
          {"(format nil \"~a~a\" 1)", "error: 'format': too few arguments for the text"}});
}

TEST_F(LispPlaces, TextsHaveSixtyFiveThousandBytesAtMost) {
  define("(defun twice (s n) (dotimes (i n s) (setq s (concatenate 'string s s))))");

  expect(
      {{"(length (twice \"ab\" 15))", "65536"},
       {"(twice \"ab\" 16)", "error: 'concatenate': the text becomes too long"},
       {"(length (format nil \"~a\" (twice \"ab\" 15)))", "65536"},
       {"(format nil \"~a.\" (twice \"ab\" 15))", "error: 'format': the text becomes too long"}});
}

TEST_F(LispPlaces, TextsAreJoinedOnlyWithTexts) {
  expect({{"(concatenate 'string)", "\"\""},
          {"(concatenate 'string \"a\" \"\" \"b\")", "\"ab\""},
          {"(concatenate 'list \"a\")",
           "error: 'concatenate': argument 1 is the symbol list, expected the type string"},
          {"(concatenate 'string \"a\" 'b)",
           "error: 'concatenate': argument 3 is the symbol b, expected a string"}});
}

TEST_F(LispPlaces, NamesAndTextsAreComparedWithoutCaseAsSoonAsOneIsAName) {
  expect({{"(string= \"Ab\" \"Ab\")", "t"},
          {"(string= \"Ab\" \"aB\")", "nil"},
          {"(string= 'ab \"AB\")", "t"},
          {"(string= \"AB\" 'ab)", "t"},
          {"(string-equal \"Ab\" \"aB\")", "t"},
          {"(string-equal \"ab\" \"ac\")", "nil"},
          {"(string= \"a\" 5)", "error: 'string=': argument 2 is 5, expected a string or a symbol"},
          {"(intern 5)", "error: 'intern': argument 1 is 5, expected a string or a symbol"},
          {"(string 5)", "error: 'string': argument 1 is 5, expected a string or a symbol"}});
}

TEST_F(LispPlaces, ErrorsOfADomainMayBeFormattedOrAnyTerm) {
  expect({{"(error \"~a of ~s\" 'one \"two\")", "error: one of \"two\""},
          {"(error '(a b))", "error: (a b)"},
          {"(error \"~a\")", "error: too few arguments for the text"}});
}

// ---- forms that are malformed ----------------------------------------------------------------

TEST_F(LispPlaces, MalformedFormsSayWhatTheyLookLike) {
  expect(
      {{"(do ((i 0)) () i)",
        "load: test.lisp:1:1: malformed do; expected (do ((variable first "
        "step)…) (end result…) body…)"},
       {"((lambda) 1)",
        "load: test.lisp:1:2: a lambda without parameters; expected (lambda (parameters) body)"},
       {"(dolist (x) x)",
        "load: test.lisp:1:1: malformed dolist; expected (dolist (variable list [result]) body)"},
       {"(return-from b 1)",
        "load: test.lisp:1:1: return without a block of that name in the same function; "
        "expected a surrounding block, dolist, dotimes or defun"}});
}

}  // namespace
}  // namespace skein::htn
