// SPDX-License-Identifier: Apache-2.0
// How deep conditions, networks and problems may be nested: both sides of each limit; and
// quantifiers whose bounds are types.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/planner_questions.hpp"

namespace skein::htn {
namespace {

using test::adds;
using test::Case;
using test::does;
using test::Questions;
using ::testing::HasSubstr;

/// `before` so many times, the kernel, and as many times `after`.
std::string nested(int depth, const std::string& before, const std::string& kernel,
                   const std::string& after = ")") {
  std::string text;
  for (int i = 0; i < depth; ++i) text += before;
  text += kernel;
  for (int i = 0; i < depth; ++i) text += after;
  return text;
}

// ---- limits ------------------------------------------------------------------------------------

TEST(Nesting, ConditionsMayBeFourHundredDeep) {
  Questions questions("(p)");

  EXPECT_TRUE(questions.holds(nested(400, "(not ", "(p)")));
  EXPECT_FALSE(questions.holds(nested(399, "(not ", "(p)")));
  EXPECT_THAT(questions.ask(nested(402, "(not ", "(p)")),
              HasSubstr("conditions are nested too deeply; expected at most 400 levels"));
}

TEST(Nesting, ConditionsThatAreTooDeepAreToldWithTheirPlace) {
  Case made("(:- (deep)\n " + nested(500, "(and ", "(p)") + ")");

  // Behind the blank in column 1 stand 401 of the five letters of "(and ".
  EXPECT_THAT(made.errors(), HasSubstr("case.lisp:3:2007: conditions are nested too deeply"));
}

TEST(Nesting, ParenthesesAroundOneConditionAreNested) {
  Questions questions("(p)");

  EXPECT_TRUE(questions.holds(nested(300, "(", "(p)")));
  EXPECT_THAT(questions.ask(nested(450, "(", "(p)")), HasSubstr("nested too deeply"));
}

TEST(Nesting, TaskNetworksOfMethodsMayBeFiveHundredDeep) {
  const auto method = [](int depth) {
    return does("(go)", nested(depth, "(:ordered ", "(!a)")) + adds("(!a)", "");
  };

  EXPECT_EQ(Case(method(499), "", "((go))").first(), "(!a)");
  EXPECT_THAT(Case(method(500), "", "((go))").errors(),
              HasSubstr("the task network is nested too deeply; expected at most 500 levels"));
}

TEST(Nesting, AWideNetworkIsNoDeepOne) {
  std::string tasks;
  for (int i = 0; i < 2'000; ++i) tasks += "(!a)";

  const Outcome outcome =
      Case(does("(go)", "(" + tasks + ")") + adds("(!a)", ""), "", "((go))").run();

  ASSERT_EQ(outcome.plans.size(), 1U);
  EXPECT_EQ(outcome.plans.front().steps.size(), 2'000U);
}

TEST(Nesting, NoTaskOfAProblemIsLostHoweverDeepItStands) {
  for (const int depth : {1, 499, 500, 501, 600, 990}) {
    Case made(adds("(!a)", ""), "", nested(depth, "(:unordered ", "(!a)"));

    ASSERT_EQ(made.errors(), "") << depth;
    EXPECT_EQ(made.first(), "(!a)") << depth;
  }
}

TEST(Nesting, ValuesThatAreConditionsMayBeTwoHundredDeep) {
  Questions shallow("(p) (goal " + nested(190, "(and ", "(p)") + ")");
  Questions deep("(p) (goal " + nested(250, "(and ", "(p)") + ")");

  EXPECT_TRUE(shallow.holds("((goal ?g) ?g)"));
  EXPECT_THAT(deep.ask("((goal ?g) ?g)"),
              HasSubstr("a value is nested too deeply to be a condition"));
}

// ---- bounds that are types ---------------------------------------------------------------------

const char* const kTypes =
    "(:types uav boat - vehicle place)"
    "(:action show :parameters (?p) :precondition ";

std::string holds_where(const std::string& condition, const std::string& facts) {
  return Case(std::string(kTypes) + condition + " :effect (shown ?p))",
              "(uav k) (uav m) (boat b) (place p) " + facts, "((!show p))")
      .first();
}

TEST(TypedQuantifiers, AskOfEachObjectOfTheType) {
  const std::string all = "(forall (?u - uav) (at ?u ?p))";

  EXPECT_EQ(holds_where(all, "(at k p) (at m p)"), "(!show p)") << "the boat is no UAV";
  EXPECT_EQ(holds_where(all, "(at k p)"), "no plan");
}

TEST(TypedQuantifiers, KnowTheObjectsOfTypesBelow) {
  const std::string all = "(forall (?v - vehicle) (at ?v ?p))";

  EXPECT_EQ(holds_where(all, "(at k p) (at m p) (at b p)"), "(!show p)");
  EXPECT_EQ(holds_where(all, "(at k p) (at m p)"), "no plan");
}

TEST(TypedQuantifiers, TakeOneObjectThatDoes) {
  const std::string one = "(exists (?v - vehicle) (at ?v ?p))";

  EXPECT_EQ(holds_where(one, "(at b p)"), "(!show p)");
  EXPECT_EQ(holds_where(one, "(at p p)"), "no plan") << "a place is no vehicle";
}

TEST(TypedQuantifiers, MayNameSeveralVariablesAndEitherType) {
  const std::string pairs = "(forall (?u - uav ?b - boat) (near ?u ?b))";
  const std::string either = "(forall (?x - (either boat place)) (marked ?x))";

  EXPECT_EQ(holds_where(pairs, "(near k b) (near m b)"), "(!show p)");
  EXPECT_EQ(holds_where(pairs, "(near k b)"), "no plan");
  EXPECT_EQ(holds_where(either, "(marked b) (marked p)"), "(!show p)");
  EXPECT_EQ(holds_where(either, "(marked b)"), "no plan");
}

TEST(TypedQuantifiers, HideTheVariablesOfTheirNamesInsideThemOnly) {
  for (const char* const both : {"(and (at ?v ?p) (exists (?v - boat) (near ?v ?p)))",
                                 "(and (exists (?v - boat) (near ?v ?p)) (at ?v ?p))"}) {
    EXPECT_EQ(Case(std::string("(:types boat) (:action show :parameters (?p ?v) :precondition ") +
                       both + " :effect (shown ?p))",
                   "(boat b) (near b p) (at k p)", "((!show p k))")
                  .first(),
              "(!show p k)");
  }
}

TEST(TypedQuantifiers, OfNoObjectAtAllAreTrueOrFalse) {
  const auto without = [](const std::string& condition) {
    return Case("(:types ship) (:action a :precondition " + condition + " :effect (done))", "",
                "((!a))")
        .first();
  };

  EXPECT_EQ(without("(forall (?s - ship) (never ?s))"), "(!a)");
  EXPECT_EQ(without("(exists (?s - ship) (and))"), "no plan");
}

}  // namespace
}  // namespace skein::htn
