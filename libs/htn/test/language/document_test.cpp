// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "skein/htn/syntax.hpp"
#include "testing/reader_fixture.hpp"

namespace skein::htn {
namespace {

struct Reading {
  TermStore store;
  Diagnostics problems;
  Document document;

  explicit Reading(const std::string& text)
      : document(read_document("test.lisp", text, store, problems)) {}
  std::string printed() const {
    std::string out;
    for (const NodeIndex top : document.top) {
      out += (out.empty() ? "" : " ") + testing::printed(document, top, store);
    }
    return out;
  }
};

std::string read(const std::string& text) {
  const Reading reading(text);
  EXPECT_EQ(to_text(reading.problems), "") << text;
  return reading.printed();
}

std::string errors_of(const std::string& text) { return to_text(Reading(text).problems); }

TEST(Document, ReadsListsAndSymbolsWithoutCase) {
  EXPECT_EQ(read("(At TRUCK1 (loc-A) ())"), "(at truck1 (loc-a) ())");
  EXPECT_EQ(read("a\n\tb\r\nc\fd"), "a b c d");
  EXPECT_EQ(read(""), "");
}

TEST(Document, LeavesOutComments) {
  EXPECT_EQ(read("(a ; b )\n c) ; d"), "(a c)");
  EXPECT_EQ(read("(a #| b #| ( |# \" |# c)"), "(a c)");
  EXPECT_EQ(read("a;"), "a");
  EXPECT_EQ(read("#!/usr/bin/skein plan\n(a)"), "(a)");
  EXPECT_EQ(read("\xEF\xBB\xBF(a)"), "(a)");
}

TEST(Document, ReadsStringsWithEscapes) {
  EXPECT_EQ(read(R"x(("a (b) ; c" "q\"u\\o" ""))x"), R"x(("a (b) ; c" "q\"u\\o" ""))x");
  EXPECT_EQ(read("\"Keep Case\nand lines\""), "\"Keep Case\nand lines\"");
}

TEST(Document, WritesPrefixesOut) {
  EXPECT_EQ(read("'a"), "(quote a)");
  EXPECT_EQ(read("#'<"), "(function <)");
  EXPECT_EQ(read("`(a ,b ,@c ,.d)"), "(backquote (a (comma b) (comma-at c) (comma-at d)))");
  EXPECT_EQ(read("''a '(b 'c)"), "(quote (quote a)) (quote (b (quote c)))");
  EXPECT_EQ(read("' ; later\n a"), "(quote a)");
}

TEST(Document, ReadsDottedPairsInTheirShortestForm) {
  EXPECT_EQ(read("(?x . ?rest)"), "(?x . ?rest)");
  EXPECT_EQ(read("(a . (b c))"), "(a b c)");
  EXPECT_EQ(read("(a . (b . c))"), "(a b . c)");
  EXPECT_EQ(read("(a . nil) (a . ())"), "(a) (a)");
  EXPECT_EQ(read("(a . (b . (c . ())))"), "(a b c)");
  EXPECT_EQ(read("((x) . y)"), "((x) . y)");
}

TEST(Document, ReadsNumbersOfAllKinds) {
  EXPECT_EQ(read("(12 -3 +4 1/3 6/4)"), "(12 -3 4 1/3 3/2)");
  EXPECT_EQ(read("(0.5 .5 2.5d0)"), "(0.5 0.5 2.5)");
  EXPECT_EQ(read("(#x1F #b101 #o17)"), "(31 5 15)");
  EXPECT_EQ(read("(1+ - + a1 -x 1-2 1.2.3)"), "(1+ - + a1 -x 1-2 1.2.3)");
  EXPECT_EQ(read("123456789012345678"), "123456789012345678");
}

TEST(Document, LeavesOutPackagesAndKeepsKeywords) {
  EXPECT_EQ(read("(shop2::foo cl:car :key keyword:word #:name)"), "(foo car :key :word name)");
}

TEST(Document, ReadsNamesWithBarsAndBackslashes) {
  TermStore store;
  Diagnostics problems;
  const Document document = read_document("t", R"((|a b| c\(d p::|x y|))", store, problems);

  const std::vector<NodeIndex> all = children(document, document.top.at(0));
  EXPECT_TRUE(problems.empty());
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(store.name(document[all[0]].atom), "a b");
  EXPECT_EQ(store.name(document[all[1]].atom), "c(d");
  EXPECT_EQ(store.name(document[all[2]].atom), "x y");
}

TEST(Document, HasNoFeatures) {
  EXPECT_EQ(read("(a #+sbcl b #-sbcl c)"), "(a c)");
  EXPECT_EQ(read("(a #+(or x y) (b) #-(or x y) (c))"), "(a (c))");
  EXPECT_EQ(read("(#+(and) a #-(and) b #+(not x) c #-(not (or)) d)"), "(a c)");
  EXPECT_EQ(read("(#+x #+y a b c)"), "(c)") << "the form that #+x leaves out is b";
}

TEST(Document, ReadsFormsToEvaluateAsTheForm) {
  EXPECT_EQ(read("#.(make-problem 'p '() '())"), "(make-problem (quote p) (quote ()) (quote ()))");
  EXPECT_EQ(read("#(1 2) #p\"file\""), "(1 2) \"file\"");
  EXPECT_EQ(read("(#\\a #\\( #\\Space)"), "(#\\a #\\( #\\space)");
}

TEST(Document, KnowsWhereExpressionsStand) {
  const Reading reading("(a\n  (bé c)\n \"d\")");
  const Document& document = reading.document;
  const std::vector<NodeIndex> all = children(document, document.top.at(0));

  const Place inner = place_of(document, document[all[1]].begin);
  EXPECT_EQ(inner.line, 2);
  EXPECT_EQ(inner.column, 3);
  const Place c = place_of(document, document[children(document, all[1])[1]].begin);
  EXPECT_EQ(c.column, 7) << "characters, not bytes";
  EXPECT_EQ(document[all[2]].end - document[all[2]].begin, 3U);
  EXPECT_EQ(document.depth, 2U);
}

TEST(Document, ReportsParenthesesTooMany) {
  EXPECT_EQ(errors_of("(a))\n)"),
            "test.lisp:1:4: unmatched ')'; expected one ')' fewer since line 1\n"
            "test.lisp:2:1: unmatched ')'; expected one ')' fewer since line 1\n");
}

TEST(Document, GuessesWhereAParenthesisIsMissing) {
  const std::string in_item =
      "(defdomain d (\n"
      "  (:method (a) () ((b))\n"
      "  (:method (c) () ())))\n"
      "(defproblem p d () ())\n";
  EXPECT_EQ(errors_of(in_item), "test.lisp:2:3: unclosed '('; expected 1 more ')' before line 3\n");
  EXPECT_EQ(Reading(in_item).document.top.size(), 2U);

  EXPECT_EQ(errors_of("(defproblem p d (\n (a)\n) ((b))\n(defproblem q d () ())"),
            "test.lisp:1:1: unclosed '('; expected 1 more ')' before line 4\n");
  EXPECT_EQ(errors_of("(a (b (c)"), "test.lisp:1:1: unclosed '('; expected 2 more ')'s\n");
  EXPECT_EQ(errors_of("(p\n  (a b)\n  (c d\n  (e f)\n)"),
            "test.lisp:1:1: unclosed '('; expected 1 more ')', perhaps for the list at line 3 "
            "before the one at line 4\n");
}

TEST(Document, ReportsWhatHasNoEnd) {
  EXPECT_EQ(errors_of("(a \"b"), "test.lisp:1:4: string without end; expected '\"'\n");
  EXPECT_EQ(errors_of("(a #| b #| |# c"), "test.lisp:1:4: comment without end; expected '|#'\n");
  EXPECT_EQ(errors_of("(a |b c)"), "test.lisp:1:4: '|' without end; expected a second '|'\n");
}

TEST(Document, ReportsEachErrorAndReadsOn) {
  const Reading reading("(a . ) ( . b) (c . d e) (f ') ... 1/0 #<x> \x01 (g)");

  EXPECT_EQ(reading.problems.size(), 8U) << to_text(reading.problems);
  EXPECT_NE(reading.printed().find("(g)"), std::string::npos);
}

TEST(Document, ReportsBytesThatAreNoText) {
  EXPECT_EQ(errors_of("(a\xFF \"\xC0\x80\")"),
            "test.lisp:1:2: bytes that are no UTF-8 text\n"
            "test.lisp:1:5: bytes that are no UTF-8 text\n");
  EXPECT_EQ(errors_of("; \xE9t\xE9\n(caf\xC3\xA9)"), "") << "comments may hold anything";
}

TEST(Document, ReportsAHundredErrorsAtMost) {
  const Reading reading(std::string(100'000, ')'));

  EXPECT_EQ(reading.problems.size(), 101U);
  EXPECT_NE(to_text(reading.problems).find("the rest is not reported"), std::string::npos);
}

TEST(Document, ReadsListsNestedDeeperThanTheStack) {
  const std::size_t depth = 200'000;
  const Reading lists(std::string(depth, '(') + std::string(depth, ')'));
  const Reading quotes(std::string(depth, '\'').append("a"));
  const Reading open(std::string(depth, '('));
  const Reading dots([] {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += "(a . ";
    return text + "nil" + std::string(100'000, ')');
  }());

  EXPECT_TRUE(lists.problems.empty());
  EXPECT_EQ(lists.document.depth, depth);
  EXPECT_TRUE(quotes.problems.empty());
  EXPECT_EQ(open.problems.size(), 1U);
  EXPECT_TRUE(dots.problems.empty());
  EXPECT_EQ(children(dots.document, dots.document.top[0]).size(), 100'000U);
}

TEST(Excerpt, UnderlinesTheExpressionAtThePlace) {
  Diagnostic error{"f.lisp", 2, 4, "", "wrong", "right", ""};

  EXPECT_EQ(underlined(error, "x\n   (a \"b)\" (c)) d\n"),
            "f.lisp:2:4: wrong; expected right\n"
            "   (a \"b)\" (c)) d\n"
            "   ^~~~~~~~~~~~\n");
  EXPECT_EQ(excerpt(error, "x\n\t\té'name and more").marks, "\t\t ^~~~~");
  EXPECT_EQ(excerpt(error, "x\n   (a ; comment").marks, "   ^~");
  EXPECT_EQ(excerpt(error, "x\n   )").marks, "   ^");
}

TEST(Excerpt, CannotWriteToATerminalWhatTheFileHasInIt) {
  const Diagnostic error{"f.lisp", 1, 6, "", "'\x1b[31m' is wrong", "", ""};

  EXPECT_EQ(underlined(error, "(a \x1b (b \x07))"),
            "f.lisp:1:6: '\uFFFD[31m' is wrong\n"
            "(a \uFFFD (b \uFFFD))\n"
            "     ^~~~~\n");
}

TEST(Excerpt, IsAbsentWhereTheTextHasNoSuchLine) {
  EXPECT_EQ(underlined({"f", 9, 1, "", "wrong", "", ""}, "x"), "f:9:1: wrong\n");
  EXPECT_EQ(underlined({"f", 0, 0, "", "wrong", "", ""}, "x"), "f: wrong\n");
}

}  // namespace
}  // namespace skein::htn
