// SPDX-License-Identifier: Apache-2.0
// Of a file with many problems only the wanted ones are read.
#include "skein/htn/wanted_problems.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/foundation/random.hpp"
#include "test_cases.hpp"

namespace skein::htn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What reading gave, as texts.
class Reading {
 public:
  explicit Reading(const std::string& text, std::vector<std::string> wanted = {}) {
    problems.names = std::move(wanted);
    read_definitions({"test.lisp", text}, store_, {}, definitions, Findings{errors}, problems);
  }
  std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const ProblemDefinition& one : definitions.problems) out.push_back(one.name);
    return out;
  }
  /// Facts and tasks of a problem as written; empty if it was not read.
  std::string said(const std::string& name) const {
    for (const ProblemDefinition& one : definitions.problems) {
      if (one.name == name) return text_of(one.facts) + " " + text_of(one.tasks);
    }
    return "";
  }

  Definitions definitions;
  Diagnostics errors;
  WantedProblems problems;

 private:
  static std::string text_of(Expression expression) {
    const Node& node = *expression;
    return expression.document->text.substr(node.begin, node.end - node.begin);
  }
  TermStore store_;
};

TEST(PassedOver, OnlyWantedProblemsAreRead) {
  const Reading reading(
      "(defproblem a d ((p)) ((t)))\n(defproblem b d ((q)) ((t)))\n(defproblem c d () ())", {"B"});

  EXPECT_THAT(reading.names(), ElementsAre("b"));
  EXPECT_THAT(reading.problems.passed_over, ElementsAre("a", "c"));
  EXPECT_EQ(reading.said("b"), "((q)) ((t))");
}

TEST(PassedOver, WithoutANameAllAre) {
  const Reading reading("(defproblem a d () ())(defproblem b d () ())");

  EXPECT_THAT(reading.names(), ElementsAre("a", "b"));
  EXPECT_THAT(reading.problems.passed_over, IsEmpty());
}

TEST(PassedOver, DomainsAndOtherFormsAreReadAsBefore) {
  const Reading reading(
      "(in-package :shop)(defdomain d ((:operator (!a) () () ())))"
      "(defun three () (defproblem inside d ((p)) ()))(defproblem other d () ())",
      {"wanted"});

  EXPECT_EQ(reading.definitions.domains.size(), 1U);
  EXPECT_THAT(reading.names(), ElementsAre("inside"));
  EXPECT_THAT(reading.problems.passed_over, ElementsAre("other"));
}

TEST(PassedOver, NothingInsideIsLookedAt) {
  const Reading reading("(defproblem a d ((p ?x)) (5))(defproblem b d () ())", {"b"});

  EXPECT_TRUE(reading.errors.empty()) << to_text(reading.errors);
  EXPECT_THAT(reading.names(), ElementsAre("b"));
}

TEST(PassedOver, ParenthesesInStringsCommentsAndNamesDoNotCount) {
  const Reading reading(
      "(defproblem a d ((p \")\" \"\\\")\" |)| #\\) \\) #| ) #| ) |# ) |# ; )\n) (q)) ())"
      "(defproblem b d ((r)) ())",
      {"b"});

  EXPECT_TRUE(reading.errors.empty()) << to_text(reading.errors);
  EXPECT_THAT(reading.names(), ElementsAre("b"));
  EXPECT_THAT(reading.problems.passed_over, ElementsAre("a"));
}

TEST(PassedOver, WhereAParenthesisIsMissingAllIsReadAndTheErrorIsThatOfTheWhole) {
  const std::string text =
      "(defproblem a d ((p)\n ((t)))\n(defproblem b d ((q)) ())\n(defproblem c d () ())";

  const Reading some(text, {"b"});

  EXPECT_EQ(to_text(some.errors), to_text(Reading(text).errors));
  EXPECT_THAT(to_text(some.errors), HasSubstr("unclosed"));
}

/// Texts of problems with all that may stand in one.
class RandomFile {
 public:
  explicit RandomFile(std::uint64_t seed) : random_(seed, "problems") {}

  std::string draw(std::size_t problems) {
    std::string text;
    for (std::size_t at = 0; at < problems; ++at) {
      text += space() + (random_.chance(0.5) ? "(defproblem " : "( DEFPROBLEM\n") + "p" +
              std::to_string(at) + space() + "d" + space() + "(" + facts() + ")" + space() + "((t" +
              noise() + "))" + space() + ")" + space();
    }
    return text;
  }

 private:
  std::string facts() {
    std::string text;
    for (std::uint64_t left = random_.below(4); left > 0; --left)
      text += "(f" + noise() + ")" + space();
    return text;
  }
  std::string noise() {
    static const std::vector<std::string> parts = {
        " a",        " \"x\"",      " \")\"",     " \"\\\"(\"", " |(|",   " |a b)|",
        " \\(",      " #\\)",       " (a (b))",   " #| ( |#",   " ; )\n", " 'x",
        " `(a ,b)",  " 1.5d0",      " ()",        " \"\\\\\"",  " #'f",   " a\\)b",
        " #\\space", " #|#|)|#(|#", " \"a|b;c\"", " |a;b\"|",   " #xF",   " .5"};
    std::string text;
    for (std::uint64_t left = random_.below(5); left > 0; --left)
      text += parts[random_.below(parts.size())];
    return text;
  }
  std::string space() {
    static const std::vector<std::string> parts = {" ", "\n", " ; (\n", " #| ) |# ", "\t "};
    return parts[random_.below(parts.size())];
  }

  Random random_;
};

// Whatever stands in the others, what is wanted is read as in the whole file.
TEST(PassedOver, AWantedProblemIsTheSameAsInTheWholeFile) {
  const auto cases = ::skein::testing::cases<std::uint64_t>(300, 30'000);
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    const std::string text = RandomFile(seed).draw(5);
    const Reading whole(text);
    ASSERT_TRUE(whole.errors.empty()) << to_text(whole.errors) << text;
    ASSERT_EQ(whole.names().size(), 5U) << text;
    const std::string wanted = "p" + std::to_string(seed % 5);

    const Reading some(text, {wanted});

    ASSERT_TRUE(some.errors.empty()) << to_text(some.errors) << text;
    ASSERT_EQ(some.said(wanted), whole.said(wanted)) << text;
    ASSERT_EQ(some.names().size() + some.problems.passed_over.size(), 5U) << text;
  }
}

// Nor does any cut of a text make a difference to its errors of parentheses, where it is not
// closed.
TEST(PassedOver, AFileThatIsCutOffHasTheErrorsOfTheWhole) {
  const std::string text = RandomFile(7).draw(3);
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string cut = text.substr(0, length);
    const Reading whole(cut);
    if (to_text(whole.errors).find("unclosed") == std::string::npos) continue;

    const Reading some(cut, {"none"});

    EXPECT_FALSE(some.errors.empty()) << cut;
  }
}

}  // namespace
}  // namespace skein::htn
