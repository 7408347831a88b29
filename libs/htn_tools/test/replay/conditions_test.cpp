// SPDX-License-Identifier: Apache-2.0
// What the validator takes for proven: each word of the logic in the precondition of an operator.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/validator_fixture.hpp"

namespace skein::htn {
namespace {

using testing::HasSubstr;
using testing_validator::ValidatorFixture;

constexpr const char* kFacts =
    "(block a) (block b) (block c) (red a) (red b) (heavy c) (on a b) (on b c)"
    " (size a 1) (size b 2) (size c 3) (pair (x y)) (ready)";

/// Does (!do argument) apply in the state of kFacts under this precondition over ?x?
bool holds(const std::string& condition, const std::string& argument,
           const std::string& more_items = "") {
  ValidatorFixture fixture("(:operator (!do ?x) (" + condition + ") () ())" + more_items, kFacts);
  const Validation result = fixture.validate("(!do " + argument + ")");
  EXPECT_TRUE(!result.fault || result.fault->kind == FaultKind::kPrecondition) << to_text(result);
  return !result.fault;
}

TEST(ValidatorConditions, AtomsHoldThatAreFacts) {
  EXPECT_TRUE(holds("(red ?x)", "a"));
  EXPECT_FALSE(holds("(red ?x)", "c"));
  EXPECT_TRUE(holds("(pair ?x)", "(x y)"));
  EXPECT_FALSE(holds("(pair ?x)", "(y x)"));
  EXPECT_TRUE(holds("(size a ?x)", "1"));
  EXPECT_FALSE(holds("(size a ?x)", "2"));
  EXPECT_TRUE(holds("(ready)", "a"));
}

TEST(ValidatorConditions, EmptyConditionsHold) {
  for (const char* condition : {"", "(and)", "(and (and))", "(and nil ())"}) {
    EXPECT_TRUE(holds(condition, "a")) << condition;
  }
}

TEST(ValidatorConditions, ConjunctionsShareTheirVariables) {
  EXPECT_TRUE(holds("(and (on ?x ?y) (on ?y ?z))", "a"));
  EXPECT_FALSE(holds("(and (on ?x ?y) (on ?y ?z))", "b"));
  EXPECT_TRUE(holds("(on ?x ?y) (heavy ?y)", "b"));
  EXPECT_FALSE(holds("(on ?x ?y) (heavy ?y)", "a"));
}

TEST(ValidatorConditions, ConjunctionsGoBackToOtherBindings) {
  EXPECT_TRUE(holds("(block ?y) (size ?y ?n) (call = ?n 3) (heavy ?y)", "a"));
  EXPECT_FALSE(holds("(block ?y) (size ?y ?n) (call = ?n 4)", "a"));
}

TEST(ValidatorConditions, OneDisjunctIsEnough) {
  EXPECT_TRUE(holds("(or (heavy ?x) (red ?x))", "a"));
  EXPECT_TRUE(holds("(or (heavy ?x) (red ?x))", "c"));
  EXPECT_FALSE(holds("(or (heavy ?x) (on ?x a))", "b"));
  EXPECT_FALSE(holds("(or)", "a"));
  EXPECT_TRUE(holds("(or (on ?x ?y) (on ?y ?x)) (heavy ?y)", "b"));
}

TEST(ValidatorConditions, NegationsHoldWhereNothingIsProven) {
  EXPECT_TRUE(holds("(not (heavy ?x))", "a"));
  EXPECT_FALSE(holds("(not (red ?x))", "a"));
  EXPECT_FALSE(holds("(not (on ?x ?y))", "a"));
  EXPECT_TRUE(holds("(not (on ?x ?y))", "c"));
  EXPECT_TRUE(holds("(not (not (red ?x)))", "a"));
  EXPECT_FALSE(holds("(not (and (red ?x) (on ?x b)))", "a"));
  EXPECT_TRUE(holds("(not (and (red ?x) (on ?x b)))", "b"));
}

TEST(ValidatorConditions, NegationsBindNothing) {
  EXPECT_TRUE(holds("(not (on ?x ?y)) (on ?y c)", "c"));
  EXPECT_TRUE(holds("(not (not (on ?x ?y))) (heavy ?y)", "a"));
}

TEST(ValidatorConditions, ImplicationsHoldWithoutTheirPremise) {
  EXPECT_TRUE(holds("(imply (heavy ?x) (red ?x))", "a"));
  EXPECT_FALSE(holds("(imply (heavy ?x) (red ?x))", "c"));
  EXPECT_TRUE(holds("(imply (red ?x) (block ?x))", "b"));
}

TEST(ValidatorConditions, UniversalsHoldForEachBinding) {
  EXPECT_TRUE(holds("(forall (?y) (red ?y) (block ?y))", "a"));
  EXPECT_FALSE(holds("(forall (?y) (block ?y) (red ?y))", "a"));
  EXPECT_TRUE(holds("(forall (?y) (purple ?y) (red ?y))", "a"));
  EXPECT_TRUE(holds("(forall (?y) (on ?x ?y) (red ?y))", "a"));
  EXPECT_FALSE(holds("(forall (?y) (on ?x ?y) (red ?y))", "b"));
  EXPECT_TRUE(holds("(forall (?y ?n) ((block ?y) (size ?y ?n)) (call < ?n 4))", "a"));
  EXPECT_FALSE(holds("(forall (?y ?n) ((block ?y) (size ?y ?n)) (call < ?n 3))", "a"));
}

TEST(ValidatorConditions, ExistentialsHoldForSomeBindingAndBindNothing) {
  EXPECT_TRUE(holds("(exists (?y) (on ?x ?y) (heavy ?y))", "b"));
  EXPECT_FALSE(holds("(exists (?y) (on ?x ?y) (heavy ?y))", "a"));
  EXPECT_TRUE(holds("(exists (?y) (on ?x ?y) (red ?y)) (on ?y c)", "a"));
}

TEST(ValidatorConditions, AssignmentsBindTheValue) {
  EXPECT_TRUE(holds("(assign ?y (+ 1 1)) (size ?x ?y)", "b"));
  EXPECT_FALSE(holds("(assign ?y (+ 1 1)) (size ?x ?y)", "a"));
  EXPECT_TRUE(holds("(size b ?y) (assign ?y 2)", "a"));
  EXPECT_FALSE(holds("(size b ?y) (assign ?y 3)", "a"));
  EXPECT_TRUE(holds("(assign ?y '?x) (red ?y)", "a"));
}

TEST(ValidatorConditions, AssignmentsOfEachTryOneValueAfterTheOther) {
  EXPECT_TRUE(holds("(assign* ?y '(5 2 1)) (size ?x ?y)", "a"));
  EXPECT_FALSE(holds("(assign* ?y '(5 2 1)) (size ?x ?y)", "c"));
  EXPECT_FALSE(holds("(assign* ?y nil)", "a"));
}

TEST(ValidatorConditions, EvaluationsHoldForAllButNil) {
  EXPECT_TRUE(holds("(size ?x ?n) (eval (> '?n 1))", "b"));
  EXPECT_FALSE(holds("(size ?x ?n) (eval (> '?n 1))", "a"));
  EXPECT_TRUE(holds("(eval 0)", "a"));
  EXPECT_FALSE(holds("(eval nil)", "a"));
  EXPECT_TRUE(holds("(call member '?x '(a b))", "a"));
  EXPECT_FALSE(holds("(call member '?x '(a b))", "c"));
}

TEST(ValidatorConditions, CollectionsHoldTheAnswersAndFailWithoutAny) {
  EXPECT_TRUE(holds("(setof ?y (red ?y) ?s) (call = (length ?s) 2)", "a"));
  EXPECT_FALSE(holds("(setof ?y (purple ?y) ?s)", "a"));
  EXPECT_TRUE(holds("(setof ?c (and (block ?y) (assign ?c 'one)) ?s) (call = (length ?s) 1)", "a"));
  EXPECT_TRUE(holds("(bagof ?c (and (block ?y) (assign ?c 'one)) ?s) (call = (length ?s) 3)", "a"));
  EXPECT_TRUE(holds("(setof (?y ?z) (on ?y ?z) ?s) (call member '(a b) ?s :test #'equal)", "a"));
}

TEST(ValidatorConditions, AGivenCollectionMayHaveAnyOrder) {
  EXPECT_TRUE(holds("(setof ?y (red ?y) ?x)", "(a b)"));
  EXPECT_TRUE(holds("(setof ?y (red ?y) ?x)", "(b a)"));
  EXPECT_FALSE(holds("(setof ?y (red ?y) ?x)", "(a)"));
  EXPECT_FALSE(holds("(setof ?y (red ?y) ?x)", "(a b c)"));
  EXPECT_FALSE(holds("(setof ?y (red ?y) ?x)", "(a a)"));
}

TEST(ValidatorConditions, WordsThatOnlyMarkAConditionAreThatCondition) {
  EXPECT_TRUE(holds("(enforce (red ?x) \"~a is not red\" ?x)", "a"));
  EXPECT_FALSE(holds("(enforce (red ?x) \"~a is not red\" ?x)", "c"));
  EXPECT_TRUE(holds("(:external (red ?x) (block ?x))", "a"));
  EXPECT_FALSE(holds("(:external (red ?x) (heavy ?x))", "a"));
}

TEST(ValidatorConditions, PreconditionsThatWantTheFirstProofAreProven) {
  ValidatorFixture first("(:operator (!do ?x) (:first (red ?x) (block ?x)) () ())", kFacts);
  ValidatorFixture sorted(
      "(:operator (!do ?x) (:sort-by ?n #'> (and (on ?x ?y) (size ?y ?n))) () ())", kFacts);

  EXPECT_TRUE(first.valid("(!do a)"));
  EXPECT_FALSE(first.valid("(!do c)"));
  EXPECT_TRUE(sorted.valid("(!do a)"));
  EXPECT_FALSE(sorted.valid("(!do c)"));
}

TEST(ValidatorConditions, AConditionInAVariableIsTheOneItHolds) {
  ValidatorFixture fixture("(:operator (!do ?g) ((ready) ?g) () ())", kFacts);

  EXPECT_TRUE(fixture.valid("(!do (red a))"));
  EXPECT_FALSE(fixture.valid("(!do (red c))"));
  EXPECT_TRUE(fixture.valid("(!do ((red a) (red b)))"));
  EXPECT_FALSE(fixture.valid("(!do ((red a) (red c)))"));
  EXPECT_TRUE(fixture.valid("(!do (not (red c)))"));
  EXPECT_TRUE(fixture.valid("(!do (and (red a) (not (red c))))"));
  EXPECT_FALSE(fixture.valid("(!do (and (red a) (not (red b))))"));
}

// Axioms

TEST(ValidatorAxioms, AreProvenThroughEachOther) {
  const std::string above =
      "(:- (above ?u ?v) ((on ?u ?v))) (:- (above ?u ?v) ((on ?u ?w) (above ?w ?v)))";

  EXPECT_TRUE(holds("(above ?x c)", "a", above));
  EXPECT_TRUE(holds("(above ?x c)", "b", above));
  EXPECT_FALSE(holds("(above ?x a)", "c", above));
}

TEST(ValidatorAxioms, TakeALaterTailOnlyWhenNoEarlierOneHolds) {
  const std::string colour =
      "(:- (colour ?u ?c) ((red ?u) (assign ?c 'red)) ((block ?u) (assign ?c 'grey)))";

  EXPECT_TRUE(holds("(colour ?x red)", "a", colour));
  EXPECT_TRUE(holds("(colour ?x grey)", "c", colour));
  EXPECT_FALSE(holds("(colour ?x ?k) (call = ?k 'grey)", "a", colour));
}

TEST(ValidatorAxioms, GiveOnlyTheFirstProofWhereTheyAskForIt) {
  const std::string any = "(:- (some-block ?u) (:first (block ?u)))";

  EXPECT_TRUE(holds("(setof ?u (some-block ?u) ?s) (call = (length ?s) 1)", "a", any));
  EXPECT_TRUE(holds("(setof ?u (block ?u) ?s) (call = (length ?s) 3)", "a", any));
}

TEST(ValidatorAxioms, WithoutTailsHoldAlways) {
  EXPECT_TRUE(holds("(same ?x a)", "a", "(:- (same ?u ?u))"));
  EXPECT_FALSE(holds("(same ?x a)", "b", "(:- (same ?u ?u))"));
  EXPECT_TRUE(holds("(same ?x a)", "a", "(:- (same ?u ?u) nil)"));
}

TEST(ValidatorAxioms, AreTriedBesideTheFactsOfTheirPredicate) {
  const std::string red = "(:- (red ?u) ((heavy ?u)))";

  EXPECT_TRUE(holds("(red ?x)", "a", red));
  EXPECT_TRUE(holds("(red ?x)", "c", red));
}

// Limits and errors

TEST(ValidatorLimits, AnEndlessProofIsAFaultNotAHang) {
  ValidatorFixture fixture("(:operator (!do ?x) ((loop ?x)) () ()) (:- (loop ?x) ((loop ?x)))",
                           kFacts);

  const Validation result = fixture.validate("(!do a)", {.inferences = 10'000});

  ASSERT_TRUE(result.fault);
  EXPECT_EQ(result.fault->kind, FaultKind::kEvaluation);
  EXPECT_EQ(to_text(result), "step 1 (line 1): cannot be evaluated: too many inferences");
}

TEST(ValidatorLimits, NegationsInsideEachOtherWithoutEndAreAFault) {
  ValidatorFixture fixture("(:operator (!do ?x) ((odd ?x)) () ()) (:- (odd ?x) ((not (odd ?x))))",
                           kFacts);

  const Validation result = fixture.validate("(!do a)");

  ASSERT_TRUE(result.fault);
  EXPECT_EQ(result.fault->kind, FaultKind::kEvaluation);
  EXPECT_THAT(to_text(result), HasSubstr("negations and quantifiers nested too deeply"));
}

TEST(ValidatorLimits, WhatCannotBeEvaluatedIsSaid) {
  ValidatorFixture fixture("(:operator (!do ?x) ((eval (> '?x 1))) () ())", kFacts);

  const Validation result = fixture.validate("(!do 2)\n(!do a)");

  ASSERT_TRUE(result.fault);
  EXPECT_EQ(result.fault->kind, FaultKind::kEvaluation);
  EXPECT_EQ(result.fault->step, 1U);
  EXPECT_EQ(to_text(result),
            "step 2 (line 2): cannot be evaluated: "
            "'>': argument 1 is the symbol a, expected a number");
}

TEST(ValidatorLimits, UnknownFunctionsAreReportedWhenTheDomainIsTaken) {
  ValidatorFixture fixture("(:operator (!do ?x) ((eval (frist ?x))) () ())", kFacts);
  Diagnostics errors;

  const Validator validator(fixture.definitions.domains[0], {}, Functions{}, fixture.store, errors);

  EXPECT_THAT(to_text(errors), HasSubstr("unknown function 'frist'; did you mean 'first'?"));
}

TEST(ValidatorLimits, DefunsOfTheFileCanBeCalled) {
  ValidatorFixture fixture(
      "(defun twice (n) (* 2 n))"
      "(defdomain d ((:operator (!do ?x ?y) ((eval (= '?y (twice '?x)))) () () (twice ?x))))"
      "(defproblem p d () ())");

  EXPECT_EQ(fixture.text("(!do 2 4) 4"), "valid: 1 steps, cost 4");
  EXPECT_FALSE(fixture.valid("(!do 2 5)"));
}

// What is said of an unmet precondition

TEST(ValidatorUnmet, IsTheFirstConjunctThatCannotHoldWithThoseBefore) {
  const auto unmet = [](const std::string& condition, const std::string& argument) {
    ValidatorFixture fixture("(:operator (!do ?x) (" + condition + ") () ())", kFacts);
    return fixture.text("(!do " + argument + ")");
  };

  EXPECT_EQ(unmet("(block ?x) (heavy ?x) (purple ?x)", "a"),
            "step 1 (line 1): precondition unmet: (heavy a)");
  EXPECT_EQ(unmet("(on ?x ?y) (heavy ?y)", "a"), "step 1 (line 1): precondition unmet: (heavy ?y)");
  EXPECT_EQ(unmet("(block ?x) (not (red ?x))", "a"),
            "step 1 (line 1): precondition unmet: (not (red ?x))");
  EXPECT_EQ(unmet("(and (block ?x) (and (red ?x) (on ?x c)))", "a"),
            "step 1 (line 1): precondition unmet: (on a c)");
  EXPECT_EQ(unmet("(forall (?y) (block ?y) (red ?y))", "a"),
            "step 1 (line 1): precondition unmet: (forall (?y) (block ?y) (red ?y))");
}

TEST(ValidatorUnmet, AreTheArgumentsWhereTheHeadDoesNotMatch) {
  ValidatorFixture fixture("(:operator (!swap ?x ?x) () () ()) (:operator (!go (at ?x)) () () ())",
                           kFacts);

  EXPECT_EQ(fixture.text("(!swap a b)"), "step 1 (line 1): precondition unmet: the arguments");
  EXPECT_EQ(fixture.text("(!go a)"), "step 1 (line 1): precondition unmet: the arguments");
  EXPECT_TRUE(fixture.valid("(!swap a a) (!go (at b))"));
}

}  // namespace
}  // namespace skein::htn
