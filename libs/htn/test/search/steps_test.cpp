// SPDX-License-Identifier: Apache-2.0
// Operators and actions: what a step changes, costs and refuses.
#include <gtest/gtest.h>

#include "testing/planner_case.hpp"

namespace skein::htn {
namespace {

using test::adds;
using test::Case;
using test::does;

/// Steps done one after the other; "!end" shows the facts of p as they stand in the end.
std::string end_after(const std::string& operators, const std::string& facts,
                      const std::string& tasks) {
  Case made(operators +
                "(:operator (!!ask) ((bagof ?x (p ?x) ?all)) () ((seen ?all)) 0)"
                "(:operator (!end ?all) ((seen ?all)) () ())",
            facts, "(:ordered " + tasks + " (!!ask) (!end ?what))");
  const Outcome outcome = made.run();
  if (outcome.verdict != Verdict::kPlan) return "no plan: " + outcome.why;
  return made.store.to_text(outcome.plans.front().steps.back().action);
}

TEST(Steps, DeleteAndAddFacts) {
  EXPECT_EQ(
      end_after("(:operator (!go ?x ?y) ((p ?x)) ((p ?x)) ((p ?y)))", "(p a) (p b)", "(!go a c)"),
      "(!end (b c))");
}

TEST(Steps, DeleteBeforeTheyAdd) {
  EXPECT_EQ(end_after("(:operator (!stay) () ((p a)) ((p a)))", "(p a) (p b)", "(!stay)"),
            "(!end (b a))");
}

TEST(Steps, MakeTheFirstOfTheTextTheNewest) {
  EXPECT_EQ(end_after("(:operator (!add) () () ((p a) (p b) (p c)))", "", "(!add)"),
            "(!end (c b a))");
}

TEST(Steps, AddOfEqualAtomsTheLastOfTheTextOnly) {
  EXPECT_EQ(end_after("(:operator (!add) () () ((p a) (p b) (p a)))", "", "(!add)"),
            "(!end (a b))");
}

TEST(Steps, TakeTheFirstProofOfTheirPrecondition) {
  EXPECT_EQ(Case("(:operator (!pick ?x) ((p ?x)) () ())", "(p a) (p b)", "((!pick ?any))").all(),
            (std::vector<std::string>{"(!pick b)"}));
}

TEST(Steps, AddTheAtomsOfAListThatIsTheValueOfAVariable) {
  EXPECT_EQ(end_after("(:operator (!all ?add ?del) () ?del ?add)", "(p a) (p b)",
                      "(!all ((p c) (p d)) ((p a)))"),
            "(!end (b d c))");
  EXPECT_EQ(end_after("(:operator (!all ?add) () () (?add (p e)))", "", "(!all ((p c) (p d)))"),
            "no plan: case.lisp:2:12: a step would add ((p c) (p d)), which is no ground atom")
      << "a list among atoms";
}

TEST(Steps, TakeASingleAtomForAListOfOne) {
  EXPECT_EQ(end_after("(:operator (!one) () (p a) (p b))", "(p a)", "(!one)"), "(!end (b))");
}

TEST(Steps, AddForAllInTheStateBeforeThem) {
  const std::string shift =
      "(:operator (!shift) () ((forall (?x) ((p ?x)) ((p ?x))))"
      " ((forall (?x ?y) ((p ?x) (next ?x ?y)) ((p ?y)))))";

  EXPECT_EQ(end_after(shift, "(p a) (p b) (next a b) (next b c)", "(!shift)"), "(!end (c b))");
}

TEST(Steps, KnowForallByItsOtherNameToo) {
  EXPECT_EQ(end_after("(:operator (!none) () ((shop-forall (?x) ((p ?x)) ((p ?x)))) ((p z)))",
                      "(p a) (p b)", "(!none)"),
            "(!end (z))");
}

TEST(Steps, AreErrorsWithTheirPlaceWhenTheyAddWhatIsNotGround) {
  Case made("(:operator (!ok) () () ((p a)))\n(:operator (!add ?x)\n () () ((p ?x)))", "",
            "((!ok) (!add ?free))");

  EXPECT_EQ(made.first().substr(0, 44), "error: case.lisp:3:12: a step would add (p ?");
}

TEST(Steps, AreErrorsWhenAListOfAtomsHoldsSomethingElse) {
  EXPECT_EQ(Case("(:operator (!all ?add) () () ?add)", "", "((!all ((p a) b)))").first(),
            "error: case.lisp:2:12: a list of atoms to add or delete holds b");
  EXPECT_EQ(Case("(:operator (!all ?add) () () ?add)", "", "((!all ((:protection b))))").first(),
            "error: case.lisp:2:12: a step would protect b, which is no atom");
}

TEST(Steps, DeleteNothingWhereWhatTheyDeleteIsNoFact) {
  const std::string drop = "(:operator (!drop ?x) () ((p ?x) (q ?y)) ())";

  EXPECT_EQ(end_after(drop, "(p a)", "(!drop b)"), "(!end (a))");
  Case odd("(:operator (!drop ?all) () ?all ())", "(p a)", "((!drop (((f) x) (7 a))))");
  odd.options.trees = true;
  EXPECT_EQ(odd.first(), "(!drop (((f) x) (7 a)))");
}

TEST(Steps, BindTheUnboundVariablesOfTheirHead) {
  Case made(
      "(:method (refuel ?u) () ((!refuel ?u ?from ?to) (!log ?from ?to)))"
      "(:operator (!refuel ?u ?from ?to) ((fuel ?u ?from) (next ?from ?to))"
      " ((fuel ?u ?from)) ((fuel ?u ?to)))"
      "(:operator (!log ?a ?b) () () ())",
      "(fuel k low) (next low high)", "((refuel k))");

  EXPECT_EQ(made.first(), "(!refuel k low high) (!log low high)");
}

// ---- costs -----------------------------------------------------------------------------------

TEST(StepCosts, AreOneWhenNotGivenAndCountForInternalStepsToo) {
  Case made("(:operator (!a) () () ()) (:operator (!!b) () () () 2.5) (:operator (!c) () () () 0)",
            "", "((!a) (!!b) (!c))");

  const Outcome outcome = made.run();

  ASSERT_EQ(outcome.plans.size(), 1U);
  const std::vector<Step>& steps = outcome.plans.front().steps;
  EXPECT_EQ(to_text(steps[0].cost), "1.0");
  EXPECT_EQ(to_text(steps[1].cost), "2.5");
  EXPECT_TRUE(steps[1].internal);
  EXPECT_FALSE(steps[2].internal);
  EXPECT_EQ(to_text(outcome.plans.front().cost), "3.5");
}

TEST(StepCosts, AreExpressionsOfWhatTheStepBinds) {
  Case made("(:operator (!fly ?a ?b) ((distance ?a ?b ?d)) () () (* 2 ?d))", "(distance x y 21)",
            "((!fly x y))");

  EXPECT_EQ(to_text(made.run().plans.front().cost), "42");
}

TEST(StepCosts, AreErrorsWithTheirPlaceWhenTheyCannotBeEvaluated) {
  Case made("(:operator (!bad) () () () (/ 1 0))", "", "((!bad))");

  EXPECT_EQ(made.first().substr(0, 23), "error: case.lisp:2:28: ");
}

// ---- protections -----------------------------------------------------------------------------

const char* const kGuards =
    "(:operator (!guard ?x) () () ((:protection (p ?x))))"
    "(:operator (!free ?x) () ((:protection (p ?x))) ())"
    "(:operator (!drop ?x) () ((p ?x)) ())"
    "(:operator (!put ?x) () () ((p ?x)))"
    "(:operator (!renew ?x) () ((p ?x)) ((p ?x)))";

std::string guarded(const std::string& tasks) { return Case(kGuards, "(p a)", tasks).first(); }

TEST(StepProtections, ForbidToDeleteWhatIsProtected) {
  EXPECT_EQ(guarded("((!drop a))"), "(!drop a)");
  EXPECT_EQ(guarded("((!guard a) (!drop a))"), "no plan");
  EXPECT_EQ(guarded("((!guard a) (!drop b))"), "(!guard a) (!drop b)");
}

TEST(StepProtections, AllowWhatIsReleased) {
  EXPECT_EQ(guarded("((!guard a) (!free a) (!drop a))"), "(!guard a) (!free a) (!drop a)");
}

TEST(StepProtections, AreCounted) {
  EXPECT_EQ(guarded("((!guard a) (!guard a) (!free a) (!drop a))"), "no plan");
  EXPECT_EQ(guarded("((!guard a) (!guard a) (!free a) (!free a) (!drop a))"),
            "(!guard a) (!guard a) (!free a) (!free a) (!drop a)");
}

TEST(StepProtections, AreCheckedWhenAllChangesAreMade) {
  EXPECT_EQ(guarded("((!guard a) (!renew a))"), "(!guard a) (!renew a)");
}

TEST(StepProtections, CannotProtectWhatDoesNotHold) {
  EXPECT_EQ(guarded("((!guard b))"), "no plan");
  EXPECT_EQ(guarded("((!put b) (!guard b))"), "(!put b) (!guard b)");
}

TEST(StepProtections, AreUndoneOnBacktracking) {
  Case made(std::string(kGuards) +
                "(:method (try) () ((!guard a) (!impossible)))"
                "(:method (try) () ((!drop a)))"
                "(:operator (!impossible) ((never)) () ())",
            "(p a)", "((try))");

  EXPECT_EQ(made.first(), "(!drop a)");
}

TEST(StepProtections, HoldWhatFollowsByAxiomsToo) {
  const std::string axiom = "(:- (safe) ((p a)))";
  const std::string guard = "(:operator (!safe) () () ((:protection (safe))))";
  Case made(kGuards + axiom + guard, "(p a)", "((!safe) (!drop a))");
  Case other(kGuards + axiom + guard, "(p a) (p b)", "((!safe) (!drop b))");

  EXPECT_EQ(made.first(), "no plan");
  EXPECT_EQ(other.first(), "(!safe) (!drop b)");
}

// ---- actions of PDDL -------------------------------------------------------------------------

TEST(Actions, AskForTheTypesOfTheirParameters) {
  const std::string domain =
      "(:types uav boat - vehicle place)"
      "(:action go :parameters (?v - vehicle ?p - place) :precondition (not (at ?v ?p))"
      " :effect (at ?v ?p))";
  const std::string facts = "(uav k) (boat b) (place p) (rock r)";

  EXPECT_EQ(Case(domain, facts, "((!go k p))").first(), "(!go k p)");
  EXPECT_EQ(Case(domain, facts, "((!go b p))").first(), "(!go b p)");
  EXPECT_EQ(Case(domain, facts, "((!go r p))").first(), "no plan");
  EXPECT_EQ(Case(domain, facts, "((!go k r))").first(), "no plan");
}

TEST(Actions, DeleteWhatTheyNegate) {
  EXPECT_EQ(end_after("(:action move :parameters (?x ?y) :precondition (p ?x)"
                      " :effect (and (not (p ?x)) (p ?y)))",
                      "(p a) (p b)", "(!move a c)"),
            "(!end (b c))");
}

TEST(Actions, DeleteFirstWhateverTheOrderOfTheText) {
  EXPECT_EQ(
      end_after("(:action same :parameters () :effect (and (p a) (not (p a))))", "", "(!same)"),
      "(!end (a))");
}

TEST(Actions, ChangeUnderAConditionOfTheStateBeforeThem) {
  const std::string action =
      "(:action flip :parameters (?x) :effect"
      " (and (when (p ?x) (not (p ?x))) (when (not (p ?x)) (p ?x))))";

  EXPECT_EQ(end_after(action, "(p a) (p z)", "(!flip a) (!flip b)"), "(!end (z b))");
}

TEST(Actions, ChangeForAllOfAType) {
  const std::string action =
      "(:types crate - thing)"
      "(:action load :parameters (?t) :effect (forall (?c - crate)"
      " (when (near ?c ?t) (and (p ?c) (not (near ?c ?t))))))";

  EXPECT_EQ(end_after(action, "(crate a) (crate b) (crate c) (near a t) (near c t)", "(!load t)"),
            "(!end (a c))");
}

TEST(Actions, KnowEquality) {
  const std::string action =
      "(:action pair :parameters (?x ?y) :precondition (not (= ?x ?y)) :effect (paired ?x ?y))";

  EXPECT_EQ(Case(action, "", "((!pair a b))").first(), "(!pair a b)");
  EXPECT_EQ(Case(action, "", "((!pair a a))").first(), "no plan");
}

TEST(Actions, HaveACostWhereItIsGiven) {
  Case made("(:action wait :parameters (?n) :effect (waited) :cost (* ?n 3))", "", "((!wait 4))");

  EXPECT_EQ(to_text(made.run().plans.front().cost), "12");
}

// ---- undoing ---------------------------------------------------------------------------------

TEST(Steps, ChangeNothingWhenTheyAreRefused) {
  Case made(std::string(kGuards) + does("(try)", "((!both))") + does("(try)", "((!show ?x))") +
                "(:operator (!both) () ((p a) (q)) ((p c) (:protection (never))))"
                "(:operator (!show ?all) ((bagof ?x (p ?x) ?all) (q)) () ())",
            "(p a) (p b) (q)", "((try))");

  EXPECT_EQ(made.first(), "(!show (b a))");
}

TEST(Steps, AreUndoneOnBacktrackingWithDeletedFactsAtTheFront) {
  Case made(does("(try)", "((!take a) (!fail))") + does("(try)", "((!first ?x))") +
                "(:operator (!take ?x) ((p ?x)) ((p ?x)) ((taken ?x)))"
                "(:operator (!fail) ((never)) () ())"
                "(:operator (!first ?x) ((p ?x) (not (taken ?x))) () ())",
            "(p a) (p b) (p c)", "((try))");

  EXPECT_EQ(made.first(), "(!first a)");
}

TEST(Actions, TakeTheFirstObjectForAParameterThatIsFree) {
  const std::string facts = "(place a) (place b) (place c)";
  Case action(
      "(:types place) (:action go :parameters (?x - place) :effect ((at ?x) (not (on ?x))))",
      facts + " (on a)", "((!go ?y))");
  Case operation("(:operator (!go ?x) ((place ?x)) () ())", facts, "((!go ?y))");
  action.options.states = true;

  const Outcome outcome = action.run();

  ASSERT_EQ(outcome.plans.size(), 1U);
  EXPECT_EQ(action.steps(outcome.plans[0]), "(!go a)");
  EXPECT_EQ(outcome.plans[0].changes[0].deleted, std::vector<Term>{action.term("(on a)")});
  EXPECT_EQ(operation.first(), "(!go c)");
}

TEST(Operators, MayHaveNothingInTheirLists) {
  Case made("(:operator (!a) () (()) (() (done)))", "", "((!a))");
  EXPECT_EQ(made.errors(), "");
  EXPECT_EQ(made.first(), "(!a)");
}

}  // namespace
}  // namespace skein::htn
