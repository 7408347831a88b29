// SPDX-License-Identifier: Apache-2.0
// What steps change in the validator's world, in both syntaxes, and every kind of fault.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/validator_fixture.hpp"

namespace skein::htn {
namespace {

using testing::HasSubstr;
using testing_validator::ValidatorFixture;

// Looks at the world: these apply where the fact holds, or does not.
constexpr const char* kLooks =
    "(:operator (!is ?fact) ((nil-fact) ?fact) () () 0)"
    "(:operator (!is-not ?fact) ((nil-fact) (not ?fact)) () () 0)";
constexpr const char* kFacts =
    "(nil-fact) (ball a) (ball b) (ball c) (in a box) (in b box) (in c bag) (open)";

class Effects : public ValidatorFixture {
 public:
  explicit Effects(const std::string& items, const std::string& facts = kFacts)
      : ValidatorFixture(kLooks + items, facts) {}
};

// Lists of operators

TEST(ValidatorEffects, DeletionsComeBeforeAdditions) {
  Effects effects("(:operator (!renew) () ((open)) ((open)))");

  EXPECT_TRUE(effects.valid("(!renew) (!is (open))"));
}

TEST(ValidatorEffects, DeletingWhatIsNotThereIsNothing) {
  Effects effects("(:operator (!shut) () ((closed) (open)) ())");

  EXPECT_TRUE(effects.valid("(!shut) (!shut) (!is-not (open))"));
}

TEST(ValidatorEffects, AddingTwiceIsAddingOnce) {
  Effects effects("(:operator (!put ?x) () () ((on ?x))) (:operator (!take ?x) () ((on ?x)) ())");

  EXPECT_TRUE(effects.valid("(!put a) (!put a) (!take a) (!is-not (on a))"));
  EXPECT_FALSE(effects.valid("(!put a) (!put b) (!take a) (!is-not (on b))"));
}

TEST(ValidatorEffects, ThoseOfForallAreForEachBindingOfTheStateBefore) {
  Effects effects(
      "(:operator (!pour) () ((forall (?x) ((in ?x box)) ((in ?x box))))"
      " ((forall (?x) ((in ?x box)) ((on-floor ?x)))))");

  EXPECT_TRUE(effects.valid("(!pour) (!is (on-floor a)) (!is (on-floor b)) (!is-not (in a box))"));
  EXPECT_TRUE(effects.valid("(!pour) (!is (in c bag)) (!is-not (on-floor c))"));
}

TEST(ValidatorEffects, OfForallInForallTakeBothBindings) {
  Effects effects(
      "(:operator (!mix) () () ((forall (?x) ((in ?x box))"
      " ((forall (?y) ((in ?y bag)) ((touch ?x ?y)))))))");

  EXPECT_TRUE(effects.valid("(!mix) (!is (touch a c)) (!is (touch b c)) (!is-not (touch c c))"));
}

TEST(ValidatorEffects, AVariableMayHoldOneAtomAmongOthers) {
  Effects effects("(:operator (!set ?atom) () () (?atom (done)))");

  EXPECT_TRUE(effects.valid("(!set (p 1)) (!is (p 1)) (!is (done))"));
}

TEST(ValidatorEffects, AVariableInPlaceOfTheListHoldsTheList) {
  Effects effects("(:operator (!change ?out ?in) () ?out ?in)");

  EXPECT_TRUE(
      effects.valid("(!change ((open) (in a box)) ((p)))"
                    " (!is-not (open)) (!is-not (in a box)) (!is (p)) (!is (in b box))"));
  EXPECT_TRUE(effects.valid("(!change nil nil) (!is (open))"));
}

TEST(ValidatorEffects, ArgumentsOfFactsMayBeNumbersTextsAndLists) {
  Effects effects("(:operator (!put ?x) () () ((got ?x)))");

  EXPECT_TRUE(effects.valid("(!put (1 (2))) (!is (got (1 (2)))) (!is-not (got (1 2)))"));
  EXPECT_TRUE(effects.valid("(!put \"A\") (!is (got \"A\")) (!is-not (got \"a\"))"));
  EXPECT_TRUE(effects.valid("(!put 1) (!is-not (got 1.0)) (!is (got 1))"));
  EXPECT_TRUE(effects.valid("(!put (a . b)) (!is (got (a . b))) (!is-not (got (a b)))"));
}

TEST(ValidatorEffects, AreThoseOfTheChosenProofAndOnlyOne) {
  Effects effects("(:operator (!grab) ((in ?x box)) ((in ?x box)) ((held ?x)))");

  EXPECT_TRUE(effects.valid("(!grab) (!is (held a)) (!is (in b box))"));
  EXPECT_TRUE(effects.valid("(!grab) (!is (held b)) (!is (in a box))"));
  EXPECT_FALSE(effects.valid("(!grab) (!is (held a)) (!is (held b))"));
  EXPECT_TRUE(effects.valid("(!grab) (!grab) (!is (held a)) (!is (held b))"));
  EXPECT_FALSE(effects.valid("(!grab) (!grab) (!grab)"));
}

TEST(ValidatorEffects, ChoicesAreTriedOnlyAsOftenAsAllowed) {
  Effects effects("(:operator (!grab) ((in ?x box)) ((in ?x box)) ((held ?x)))");
  const std::string both[] = {"(!grab) (!is (held a))", "(!grab) (!is (held b))"};

  const auto valid_without_retries = [&](const std::string& plan) {
    return !effects.validate(plan, {.retries = 0}).fault;
  };

  EXPECT_NE(valid_without_retries(both[0]), valid_without_retries(both[1]));
}

// PDDL

constexpr const char* kLift =
    "(:types ball - thing box - thing)"
    "(:action lift :parameters (?x - ball ?b) :precondition (and (in ?x ?b))"
    " :effect (and (not (in ?x ?b)) (held ?x) (when (wet ?x) (slippery))"
    "  (forall (?y - box) (when (in ?x ?y) (seen ?y)))) :cost 2)";
constexpr const char* kLiftFacts =
    "(nil-fact) (ball a) (ball b) (box red) (box blue) (in a red) (in b blue) (wet b) (in red "
    "blue)";

TEST(ValidatorActions, HaveTheirNameWithAnExclamationMark) {
  Effects lift(kLift, kLiftFacts);

  EXPECT_EQ(lift.text("(!lift a red) 2"), "valid: 1 steps, cost 2");
  EXPECT_EQ(lift.text("(lift a red)"), "step 1 (line 1): unknown operator lift");
  EXPECT_EQ(lift.text("(!lift a)"), "step 1 (line 1): !lift takes 2 arguments, not 1");
}

TEST(ValidatorActions, TakeArgumentsOfTheirTypesOnly) {
  Effects lift(kLift, kLiftFacts);

  const Validation result = lift.validate("(!lift red blue)");

  ASSERT_TRUE(result.fault);
  EXPECT_EQ(result.fault->kind, FaultKind::kPrecondition);
}

TEST(ValidatorActions, TakeArgumentsOfSubtypesAndOfTypesOfTypes) {
  Effects touch(
      "(:types ball - thing thing)"
      "(:action touch :parameters (?x - thing) :effect (touched ?x))"
      "(:action see :parameters (?x - object) :effect (seen ?x))",
      kLiftFacts);

  EXPECT_TRUE(touch.valid("(!touch a) (!is (touched a))"));
  EXPECT_TRUE(touch.valid("(!see b)"));
  EXPECT_FALSE(touch.valid("(!touch red)"));
}

TEST(ValidatorActions, ChangeTheWorldByEachPartOfTheirEffect) {
  Effects lift(kLift, kLiftFacts);

  EXPECT_TRUE(lift.valid("(!lift a red) (!is (held a)) (!is-not (in a red))"));
  EXPECT_TRUE(lift.valid("(!lift a red) (!is-not (slippery))"));
  EXPECT_TRUE(lift.valid("(!lift b blue) (!is (slippery))"));
}

TEST(ValidatorActions, TestConditionsOfEffectsInTheStateBefore) {
  Effects lift(kLift, kLiftFacts);

  EXPECT_TRUE(lift.valid("(!lift a red) (!is (seen red)) (!is-not (seen blue))"));
}

TEST(ValidatorActions, TakeEachBindingOfAForallWithItsType) {
  Effects wash(
      "(:types ball box) (:action wash :parameters () :precondition (and)"
      " :effect (forall (?x - ball) (and (clean ?x) (not (wet ?x)))))",
      kLiftFacts);

  EXPECT_TRUE(wash.valid("(!wash) (!is (clean a)) (!is (clean b)) (!is-not (wet b))"));
  EXPECT_TRUE(wash.valid("(!wash) (!is-not (clean red))"));
}

TEST(ValidatorActions, UnderstandQuantifiersEqualityAndDerivedPredicates) {
  Effects stack(
      "(:types ball box) (:derived (empty ?b) (not (exists (?x - ball) (in ?x ?b))))"
      "(:action stack :parameters (?b - box ?c - box)"
      " :precondition (and (not (= ?b ?c)) (forall (?x - ball) (not (in ?x ?b))) (empty ?b))"
      " :effect (on ?b ?c))",
      "(nil-fact) (ball a) (box red) (box blue) (in a red)");

  EXPECT_TRUE(stack.valid("(!stack blue red) (!is (on blue red))"));
  EXPECT_FALSE(stack.valid("(!stack red blue)"));
  EXPECT_FALSE(stack.valid("(!stack blue blue)"));
}

// Faults

TEST(ValidatorFaults, EachKindComesWithItsStepAndLine) {
  Effects effects(
      "(:operator (!go ?x) ((ball ?x)) () ((went ?x)) 2)"
      "(:operator (!hold ?x) () () ((:protection (ball ?x))))"
      "(:operator (!lose ?x) () ((ball ?x)) ())"
      "(:operator (!open-end ?x) () () ((end ?x ?y)))"
      "(:operator (!sum ?x) ((call > ?x 0)) () ())");
  struct Case {
    const char* step;
    FaultKind kind;
    const char* why;
  };
  const std::vector<Case> cases{
      {"(!jump a)", FaultKind::kUnknownOperator, "unknown operator !jump"},
      {"(!go a b)", FaultKind::kArity, "!go takes 1 arguments, not 2"},
      {"(!go)", FaultKind::kArity, "!go takes 1 arguments, not 0"},
      {"(!go stone)", FaultKind::kPrecondition, "precondition unmet: (ball stone)"},
      {"(!go a) 3", FaultKind::kCost, "costs 2, not 3"},
      {"(!lose a)", FaultKind::kEffect, "protection violated: (ball a)"},
      {"(!hold z)", FaultKind::kEffect, "would protect (ball z), which does not hold"},
      {"(!sum b)", FaultKind::kEvaluation,
       "cannot be evaluated: '>': argument 1 is the symbol b, expected a number"}};

  for (const Case& one : cases) {
    const Validation result = effects.validate("; comment\n(!hold a)\n(!go a) 2\n\n" +
                                               std::string(one.step) + "\n(!go b)");

    ASSERT_TRUE(result.fault) << one.step;
    EXPECT_EQ(result.fault->kind, one.kind) << one.step;
    EXPECT_EQ(result.fault->step, 2U) << one.step;
    EXPECT_EQ(result.steps, 2U) << one.step;
    EXPECT_EQ(to_text(result), "step 3 (line 5): " + std::string(one.why));
  }
  EXPECT_THAT(effects.text("(!open-end a)"), HasSubstr("would add (end a "));
}

TEST(ValidatorFaults, TheTotalCostIsCompared) {
  Effects effects("(:operator (!go ?x) ((ball ?x)) () () 1.5)");

  EXPECT_EQ(effects.text(R"({"plans":[{"cost":4,"steps":[["!go","a"],["!go","b"]]}]})"),
            "step 2: the steps cost 3.0, the plan says 4");
  EXPECT_TRUE(effects.valid(R"({"plans":[{"cost":3,"steps":[["!go","a"],["!go","b"]]}]})"));
  EXPECT_TRUE(effects.valid(R"({"plans":[{"cost":3.0000001,"steps":[["!go","a"],["!go","b"]]}]})"));
  EXPECT_FALSE(effects.valid(R"({"plans":[{"cost":1,"steps":[]}]})"));
}

TEST(ValidatorFaults, CostsOfStepsAreComparedWhereTheyAreGiven) {
  Effects effects("(:operator (!go ?x) ((ball ?x)) () () (if (eq '?x 'a) 1/3 2))");

  EXPECT_TRUE(
      effects.valid(R"({"plans":[{"steps":[["!go","a"],["!go","b"]],"costs":["1/3",2]}]})"));
  EXPECT_TRUE(effects.valid(R"({"plans":[{"steps":[["!go","a"],["!go","b"]],"costs":["1/3"]}]})"));
  EXPECT_FALSE(
      effects.valid(R"({"plans":[{"steps":[["!go","a"],["!go","b"]],"costs":[2,"1/3"]}]})"));
}

TEST(ValidatorFaults, OperatorsWithoutCostCostOne) {
  Effects effects("(:operator (!go ?x) () () ())");

  EXPECT_EQ(effects.text("(!go a) (!go b)"), "valid: 2 steps, cost 2.0");
}

TEST(ValidatorFaults, AnEmptyPlanIsValidAndCostsNothing) {
  Effects effects("");

  EXPECT_EQ(effects.text(""), "valid: 0 steps, cost 0");
}

TEST(ValidatorFaults, APlanWithoutInternalStepsCountsWhereTheDomainHasNone) {
  Effects with("(:operator (!!note ?x) () () ((noted ?x)))");
  Effects without("(:operator (!note ?x) () () ((noted ?x)))");
  const std::string plan = R"({"internal":false,"plans":[{"steps":[]}]})";

  EXPECT_EQ(with.validate(plan).fault.value().kind, FaultKind::kInternalLeftOut);
  EXPECT_THAT(with.text(plan), HasSubstr("written without its internal steps (!!name)"));
  EXPECT_TRUE(without.valid(plan));
}

TEST(ValidatorFaults, StepsThatTheWorldUndoesStayUndone) {
  Effects effects(
      "(:operator (!hold) () () ((:protection (open))))"
      "(:operator (!free) () ((:protection (open))) ())"
      "(:operator (!shut) () ((open)) ())"
      "(:operator (!swap) () ((open)) ((open)))");

  EXPECT_FALSE(effects.valid("(!hold) (!shut)"));
  EXPECT_TRUE(effects.valid("(!hold) (!swap) (!free) (!shut)"));
  EXPECT_FALSE(effects.valid("(!hold) (!free) (!hold) (!shut)"));
  EXPECT_TRUE(effects.valid("(!free) (!shut)"));
}

TEST(ValidatorFaults, ProtectionsMayBeOfWhatAxiomsProve) {
  Effects effects(
      "(:- (safe) ((in a box)))"
      "(:operator (!guard) () () ((:protection (safe))))"
      "(:operator (!empty) () ((in a box)) ())"
      "(:operator (!other) () ((in b box)) ())");

  EXPECT_EQ(effects.text("(!guard) (!other) (!empty)"),
            "step 3 (line 1): protection violated: (safe)");
}

}  // namespace
}  // namespace skein::htn
