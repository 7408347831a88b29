// SPDX-License-Identifier: Apache-2.0
// Both sides of what a text may hold, and the rarer errors and warnings of its parts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/htn/utf8.hpp"
#include "testing/reader_fixture.hpp"

namespace skein::htn {
namespace {

using ::testing::HasSubstr;
using testing::ReaderFixture;

std::string problems_of(const std::string& text) {
  TermStore store;
  Diagnostics problems;
  read_document("t", text, store, problems);
  return to_text(problems);
}

std::string definition_errors(const std::string& items) {
  return ReaderFixture().read("(defdomain d (\n" + items + "))").error_text();
}

std::string definition_warnings(const std::string& items, const std::string& problem = "") {
  ReaderFixture reader;
  reader.read("(defdomain d (\n" + items + "))" + problem);
  EXPECT_EQ(reader.error_text(), "") << items;
  return reader.warning_text();
}

// ---- names and characters --------------------------------------------------------------------

TEST(DocumentLimits, NamesHaveTenThousandBytesAtMost) {
  EXPECT_EQ(problems_of(std::string(kLongestName, 'a')), "");
  EXPECT_EQ(problems_of(" " + std::string(kLongestName + 1, 'a')),
            "t:1:2: a name of 10001 bytes; expected 10000 at most\n");
}

TEST(DocumentLimits, ANameIsCutBetweenCharacters) {
  TermStore store;
  Diagnostics problems;
  const Document document =
      read_document("t", std::string(kLongestName - 1, 'a') + "éb", store, problems);

  const std::string_view name = store.name(document[document.top.at(0)].atom);

  EXPECT_EQ(name, std::string(kLongestName - 1, 'a')) << "half of the é would be no text";
}

TEST(DocumentLimits, ListsMayBeAMillionDeep) {
  const auto lists = [](std::size_t depth) {
    return std::string(depth, '(') + std::string(depth, ')');
  };

  EXPECT_EQ(problems_of(lists(kDeepestText - 1)), "");
  EXPECT_EQ(problems_of(lists(kDeepestText + 1)),
            "t:1:1000001: nested more than 1000000 deep; what follows is not read\n");
}

TEST(DocumentLimits, AHundredErrorsAreReported) {
  const std::string hundred(100, ')');

  EXPECT_THAT(problems_of(hundred), ::testing::Not(HasSubstr("the rest is not reported")));
  EXPECT_THAT(problems_of(hundred + ")))"),
              HasSubstr("t:1:101: more than 100 errors; the rest is not reported\n"));
}

TEST(DefinitionLimits, AWideDefinitionBesideADeepFormIsNoDeepOne) {
  std::string facts;
  for (int i = 0; i < 1'500; ++i) facts += "(a)";
  const std::string deep = std::string(1'100, '(') + std::string(1'100, ')');
  ReaderFixture reader;

  reader.read("(other " + deep + ") (defproblem p d (" + facts + ") ())");

  EXPECT_EQ(reader.error_text(), "");
  EXPECT_EQ(reader.definitions.problems.size(), 1U);
}

TEST(DocumentErrors, OfLonePrefixesNameWhatIsMissing) {
  EXPECT_EQ(problems_of("(a #: b)"), "t:1:4: nothing follows #:; expected a name\n");
  EXPECT_EQ(problems_of("a #:"), "t:1:3: nothing follows #:; expected a name\n");
  EXPECT_EQ(problems_of("a #\\"), "t:1:3: nothing follows #\\; expected a character\n");
  EXPECT_EQ(problems_of("(a : b)"), "t:1:4: a lone ':'; expected a name behind it\n");
  EXPECT_EQ(problems_of("(a b: c)"),
            "t:1:4: 'b:' names a package only; expected a name behind the ':'\n");
  EXPECT_EQ(problems_of("(a . )"), "t:1:6: no expression between '.' and ')'\n");
  EXPECT_EQ(problems_of("(a . b c)"), "t:1:8: more than one expression after '.'; expected ')'\n");
}

TEST(DocumentErrors, AtTheEndNameTheWholeThatIsOpen) {
  EXPECT_EQ(problems_of("(a (b"), "t:1:1: unclosed '('; expected 2 more ')'s\n");
  EXPECT_EQ(problems_of("(a (b)"), "t:1:1: unclosed '('; expected 1 more ')'\n");
  EXPECT_EQ(problems_of("(a '"),
            "t:1:1: unclosed '('; expected 2 more ')'s\nt:1:4: nothing follows '; expected an "
            "expression\n")
      << "a quote counts as a list";
}

TEST(Utf8, TextsAreClippedBetweenCharacters) {
  EXPECT_EQ(clipped(std::string("Lousã"), 5), "Lousã");
  EXPECT_EQ(clipped(std::string("éèêë"), 3), "éèê…");
  EXPECT_EQ(clipped(std::string("abcdef"), 4), "abcd…");
  EXPECT_EQ(clipped(std::string("a"), 0), "…");
  EXPECT_EQ(clipped(std::string(), 0), "");
}

TEST(ReaderDiagnostics, QuoteNoMoreThanAnExcerptOfALongName) {
  const std::string most(kLongestExcerpt, 'x');
  const Diagnostic given{"f", 1, 1, "", most, most + "x", most + "xyz"};

  const Diagnostic shown = clipped(given);

  EXPECT_EQ(shown.message, most);
  EXPECT_EQ(shown.expected, most + "…");
  EXPECT_EQ(shown.nearest, most + "…");
}

// ---- excerpts --------------------------------------------------------------------------------

Excerpt excerpt_at(int line, int column, const std::string& text) {
  return excerpt({"f", line, column, "", "m", "", ""}, text);
}

TEST(Excerpts, UnderlineTheExpressionAtThePlace) {
  const auto marks = [](int column) {
    return excerpt_at(1, column, "(a (b \"c )\") 'd ;e)").marks;
  };

  EXPECT_EQ(marks(4), "   ^~~~~~~~~");
  EXPECT_EQ(marks(2), " ^");
  EXPECT_EQ(marks(7), "      ^~~~~") << "a parenthesis in a text is none";
  EXPECT_EQ(marks(14), "             ^~") << "a quote with what it quotes";
  EXPECT_EQ(marks(1), "^~~~~~~~~~~~~~~") << "no comment";
}

TEST(Excerpts, ShowTheLineThatIsMeantWhateverEndsIt) {
  EXPECT_EQ(excerpt_at(2, 1, "a\r\nbc\r\nd").line, "bc");
  EXPECT_EQ(excerpt_at(3, 1, "a\nb\nd").line, "d");
  EXPECT_EQ(excerpt_at(4, 1, "a\nb\nd").line, "");
  EXPECT_EQ(excerpt_at(0, 1, "a").line, "");
  EXPECT_EQ(excerpt_at(1, 0, "a").line, "");
}

TEST(Excerpts, KeepTabsAndCountCharacters) {
  const Excerpt shown = excerpt_at(1, 5, "\té (xx)");

  EXPECT_EQ(shown.line, "\té (xx)");
  EXPECT_EQ(excerpt_at(1, 4, "\té (xx)").marks, "\t  ^~~~");
  EXPECT_EQ(shown.marks, "\t   ^~");
}

TEST(Excerpts, OfLongLinesShowThePartAroundThePlace) {
  std::string line;
  for (int i = 0; i < 10'000; ++i) line += "é";
  line += " (here) " + std::string(300, 'z');

  const Excerpt shown = excerpt_at(1, 10'002, line);

  EXPECT_EQ(count_characters(shown.line), kLongestExcerpt);
  EXPECT_TRUE(shown.line.starts_with("…é"));
  EXPECT_TRUE(shown.line.ends_with("z…"));
  EXPECT_EQ(shown.marks, std::string(51, ' ') + "^~~~~~");
}

TEST(Excerpts, OfLinesOfExactlyTheLongestShowAll) {
  const std::string exact(kLongestExcerpt, 'a');

  EXPECT_EQ(excerpt_at(1, 100, exact).line, exact);
  EXPECT_EQ(count_characters(excerpt_at(1, 1, exact + "a").line), kLongestExcerpt - 1)
      << "cut on one side only";
}

// ---- parts of definitions --------------------------------------------------------------------

TEST(ReaderErrors, OfDottedConditionsNameTheList) {
  EXPECT_EQ(definition_errors("(:- (p) ((a) . (b)))"), "") << "that is ((a) b) to a reader of Lisp";
  EXPECT_EQ(definition_errors("(:- (p) ((a) (b) . ?x))"),
            "test.lisp:2:9: a list of conditions with a dot\n");
}

TEST(ReaderErrors, OfItemsThatAreNoList) {
  EXPECT_EQ(ReaderFixture().read("(defdomain d \"x\")").error_text(),
            "test.lisp:1:14: \"x\" where the items go; expected a list of items\n");
  EXPECT_EQ(ReaderFixture().read("(defdomain d nil)").error_text(), "");
}

TEST(ReaderErrors, OfDomainsWithoutANameQuoteWhatStandsThere) {
  for (const char* const name : {"()", "5", "?d", "(5 :type x)"})
    EXPECT_EQ(ReaderFixture().read("(defdomain " + std::string(name) + " ())").error_text(),
              "test.lisp:1:12: " + std::string(name) +
                  " is no name for a domain; expected a name or (name options…)\n");
}

TEST(ReaderErrors, QuoteFortyBytesAndNoHalfCharacter) {
  const std::string most(38, 'x');

  EXPECT_THAT(definition_errors("(:- (p) \"" + most + "\")"),
              HasSubstr("\"" + most + "\" is no condition"));
  EXPECT_THAT(definition_errors("(:- (p) \"" + most + "é\")"),
              HasSubstr("\"" + most + "é… is no condition"));
}

TEST(ReaderErrors, OfFactsThatAreNone) {
  EXPECT_EQ(ReaderFixture().read("(defproblem p d ((a) 5) ())").error_text(),
            "test.lisp:1:22: 5 is no fact; expected (predicate arguments…)\n");
  EXPECT_EQ(ReaderFixture().read("(defproblem p d ((\"a\" b)) ())").error_text(),
            "test.lisp:1:19: a fact that begins with \"a\"; expected a predicate\n");
}

TEST(ReaderErrors, OfNamesThatAreNoList) {
  EXPECT_EQ(definition_errors("(:types a - b 5)"),
            "test.lisp:2:15: 5 in a list of names; expected a name\n");
}

TEST(ReaderWarnings, OfAKeywordForATaskNameTheKeywords) {
  EXPECT_EQ(definition_warnings("(:method (:fly-home) () ()) (:method (m) () (:fly-home))"),
            "test.lisp:2:46: keyword :fly-home as the name of a task; expected :ordered, "
            ":unordered, :task or :immediate\n");
}

TEST(ReaderErrors, OfAKeywordThatIsNearlyOneOfTaskLists) {
  EXPECT_EQ(definition_errors("(:method (m) () (:unorderd (a)))"),
            "test.lisp:2:18: unknown keyword :unorderd in a task list; expected :ordered, "
            ":unordered, :task or :immediate; did you mean ':unordered'?\n");
}

TEST(ReaderWarnings, OfATextForACost) {
  EXPECT_EQ(definition_warnings("(:operator (!a) () () () \"two\")"),
            "test.lisp:2:26: a string for a cost; it counts as 1; expected a number or an "
            "expression\n");
}

TEST(ReaderWarnings, OfAnAxiomWithATextForALabelAskForNone) {
  EXPECT_EQ(definition_errors("(:- (p) 5 ((a)))"),
            "test.lisp:2:9: 5 is no condition; expected (predicate arguments…) or a list of "
            "conditions\n");
}

TEST(ReaderWarnings, OfPredicatesThatAreProvidedWithOtherArgumentsOnly) {
  const std::string items = "(:method (m) ((at k) (at k)) ())";

  EXPECT_EQ(definition_warnings(items, "(defproblem p d ((at k base) (at)) (m))"),
            "test.lisp:2:15: (at …) with 1 argument is never provided; expected 0 or 2\n")
      << "once for each number of arguments";
  EXPECT_EQ(definition_warnings(items, "(defproblem p d ((at k)) (m))"), "");
}

TEST(ReaderWarnings, OfFactsThatNobodyAsksForInThatNumber) {
  EXPECT_EQ(
      definition_warnings("(:method (m) ((at k)) ())", "\n(defproblem p d ((at k) (at k b)) (m))"),
      "test.lisp:3:25: (at …) with 2 arguments is never asked for; expected 1\n");
}

TEST(ReaderWarnings, OfAChangeOfWhatIsStatic) {
  EXPECT_EQ(definition_warnings("(:static road) (:operator (!pave ?x) () () ((road ?x)))"),
            "test.lisp:2:45: an operator changes 'road'; expected no change of a predicate of "
            ":static\n");
}

TEST(ReaderWarnings, OfAProblemOfNoKnownDomainNameTheNearest) {
  EXPECT_EQ(definition_warnings("", "\n(defproblem p b () ())"),
            "test.lisp:3:17: problem 'p' of unknown domain 'b'; expected a domain that is read "
            "with it; did you mean 'd'?\n");
}

}  // namespace
}  // namespace skein::htn
