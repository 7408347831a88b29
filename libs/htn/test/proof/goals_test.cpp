// SPDX-License-Identifier: Apache-2.0
// Goals that compute or collect, goals met as values, errors, and limits inside one condition.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "testing/planner_questions.hpp"

namespace skein::htn {
namespace {

using test::Questions;
using testing::Test;

// ---- collecting ------------------------------------------------------------------------------

TEST(ProverCollect, GathersEachValueOnceInTheOrderOfTheAnswers) {
  Questions state("(p a 1) (p b 2) (p a 3)");

  EXPECT_EQ(state.ask("((setof ?x (p ?x ?n) ?all))", "?all"), "((a b))");
  EXPECT_EQ(state.ask("((bagof ?x (p ?x ?n) ?all))", "?all"), "((a b a))");
  EXPECT_EQ(state.ask("((setof (?n ?x) ((p ?x ?n)) ?all))", "?all"), "(((1 a) (2 b) (3 a)))");
}

TEST(ProverCollect, FailsWhereNothingIsToGather) {
  Questions state("(p a 1)");

  EXPECT_EQ(state.ask("((setof ?x (q ?x) ?all))", "?all"), "none");
  EXPECT_EQ(state.ask("((bagof ?x (p ?x 2) ?all))", "?all"), "none");
}

TEST(ProverCollect, GathersUnderTheBindingsSoFar) {
  Questions state("(team x) (team y) (member x a) (member x b) (member y c)");

  EXPECT_EQ(state.ask("((team ?t) (setof ?m (member ?t ?m) ?all))", "?t ?all"),
            "(x (a b)) (y (c))");
}

TEST(ProverCollect, MustAgreeWithAValueThatIsKnown) {
  Questions state("(p a) (p b) (wanted (a b)) (wanted (b))");

  EXPECT_EQ(state.ask("((wanted ?all) (setof ?x (p ?x) ?all))", "?all"), "((a b))");
}

// ---- computing -------------------------------------------------------------------------------

TEST(ProverCompute, AssignsTheValueOfAnExpression) {
  Questions state("(fuel 7)");

  EXPECT_EQ(state.ask("((fuel ?f) (assign ?left (- ?f 2)))", "?left"), "(5)");
  EXPECT_EQ(state.ask("((assign ?l (list 'a 1 \"s\")))", "?l"), "((a 1 \"s\"))");
  EXPECT_EQ(state.ask("((assign ?x nil))", "?x"), "(nil)");
}

TEST(ProverCompute, AssignsToAKnownVariableWhatEqualsIt) {
  Questions state("(fuel 7) (fuel 5)");

  EXPECT_EQ(state.ask("((fuel ?f) (assign ?f (+ 3 4)))", "?f"), "(7)");
  EXPECT_EQ(state.ask("((fuel ?f) (assign ?f 5.0))", "?f"), "(5)");
}

TEST(ProverCompute, AssignsEachItemOfAListInTurn) {
  Questions state("(p b)");

  EXPECT_EQ(state.ask("((assign* ?x '(a b c)))", "?x"), "(c) (b) (a)");
  EXPECT_EQ(state.one("((assign* ?x '(a b c)))", "?x"), "(a)");
  EXPECT_EQ(state.ask("((assign* ?x '(a b c)) (p ?x))", "?x"), "(b)");
  EXPECT_EQ(state.ask("((assign* ?x nil))", "?x"), "none");
}

TEST(ProverCompute, TakesAnythingButNilForTrue) {
  Questions state("(fuel 7)");

  EXPECT_TRUE(state.holds("((fuel ?f) (eval (> ?f 5)))"));
  EXPECT_FALSE(state.holds("((fuel ?f) (eval (> ?f 9)))"));
  EXPECT_TRUE(state.holds("((call < 1 2 3))"));
  EXPECT_FALSE(state.holds("((call member a '(b c)))"));
  EXPECT_TRUE(state.holds("((call member b '(b c)))"));
  EXPECT_TRUE(state.holds("((eval 0))"));
}

TEST(ProverCompute, CallsFunctionsOfTheHostWithWhatIsBound) {
  Questions state("(at 3) (at 4)");
  state.functions.add("near", 2, 2, [](TermStore& store, std::span<const Term> arguments) {
    const auto left = store.value(arguments[0]).numerator;
    return Result<Term, Failure>(
        TermStore::boolean(left - store.value(arguments[1]).numerator <= 1));
  });

  EXPECT_EQ(state.ask("((at ?x) (call near ?x 2))", "?x"), "(3)");
}

TEST(ProverCompute, RefusesUnknownFunctionsWhenTheDomainIsLoaded) {
  const std::string found = Questions("").ask("((call no-such-thing 1))");

  EXPECT_EQ(found.substr(0, 20), "bad: case.lisp:3:24:") << found;
  EXPECT_NE(found.find("no-such-thing"), std::string::npos) << found;
}

// ---- conditions that are values --------------------------------------------------------------

TEST(ProverValues, ProveAVariableThatHoldsAnAtom) {
  Questions state("(todo (at karma p1)) (todo (at marvin p2)) (at karma p1) (at heliv p3)");

  EXPECT_EQ(state.ask("((todo ?goal) ?goal)", "?goal"), "((at karma p1))");
  EXPECT_EQ(state.ask("((todo ?goal) (not ?goal))", "?goal"), "((at marvin p2))");
}

TEST(ProverValues, BindTheVariablesInsideAGoal) {
  Questions state("(p a) (p b)", "(:- (holds ?goal) (and ?goal))");

  EXPECT_EQ(state.ask("((holds (p ?x)))", "?x"), "(b) (a)");
}

TEST(ProverValues, MayBeConnectives) {
  Questions state(
      "(p a) (q b) (want (and (p a) (q b))) (want (or (p z) (q b))) "
      "(want (not (p b))) (want ((p a) (p b))) (want (not (q b)))");

  EXPECT_EQ(state.ask("((want ?g) ?g)", "?g"),
            "((and (p a) (q b))) ((or (p z) (q b))) ((not (p b)))");
}

TEST(ProverValues, AreProvedByAxiomsToo) {
  Questions state("(p a) (want (r a)) (want (r b))", "(:- (r ?x) ((p ?x)))");

  EXPECT_EQ(state.ask("((want ?g) ?g)", "?g"), "((r a))");
}

TEST(ProverValues, AreErrorsWhenTheyAreNoConditions) {
  Questions state("(want 7)");
  Questions deep("(want (forall (x) (y) (z)))");

  EXPECT_EQ(state.ask("((want ?g) ?g)", "?g"), "error: case.lisp:3:30: 7 is no condition");
  EXPECT_EQ(deep.ask("((want ?g) ?g)", "?g").substr(0, 25), "error: case.lisp:3:30: a ")
      << deep.ask("((want ?g) ?g)", "?g");
}

// ---- enforcing and errors --------------------------------------------------------------------

TEST(ProverErrors, EnforceGivesTheAnswersOfItsCondition) {
  Questions state("(p a) (p b)");

  EXPECT_EQ(state.ask("((enforce (p ?x) \"no p\"))", "?x"), "(b) (a)");
}

TEST(ProverErrors, EnforceEndsTheSearchWhenItsConditionFails) {
  Questions state("(p a)");

  EXPECT_EQ(state.ask("((p ?x)\n (enforce (q ?x) \"no q for p\"))", "?x"),
            "error: case.lisp:4:2: no q for p");
  EXPECT_EQ(state.ask("((enforce (q)))"),
            "error: case.lisp:3:18: an enforced condition does not hold");
}

TEST(ProverErrors, HaveThePlaceOfTheExpressionThatFailed) {
  Questions state("(p a)");

  EXPECT_EQ(state.ask("((p ?x)\n (eval (> ?x 1)))", "?x").substr(0, 21), "error: case.lisp:4:8:");
  EXPECT_EQ(state.ask("((assign ?y (/ 1 0)))", "?y").substr(0, 22), "error: case.lisp:3:31:");
  EXPECT_EQ(state.ask("((assign* ?y (car 'a)))", "?y").substr(0, 7), "error: ");
}

TEST(ProverErrors, OfTheHostAreErrorsOfTheSearch) {
  Questions state("");
  state.functions.add("lost", 0, 0, [](TermStore&, std::span<const Term>) {
    return Result<Term, Failure>(tl::unexpected(Failure{"no map"}));
  });

  const std::string found = state.ask("((call lost))");

  EXPECT_EQ(found.substr(0, 17), "error: case.lisp:") << found;
  EXPECT_NE(found.find("no map"), std::string::npos) << found;
}

// ---- tests -----------------------------------------------------------------------------------

/// Forty things, one of them rare, and towers of boxes.
class ProverTests : public Test {
 protected:
  static std::string facts() {
    std::string out = "(rare t7) (on b3 b2) (on b2 b1) (on b1 table)";
    for (int at = 0; at < 40; ++at) out += "(thing t" + std::to_string(at) + ")";
    return out;
  }
  Questions state{facts(),
                  "(:- (odd ?x) ((thing ?x) (rare ?x)))"
                  "(:- (some-rare) ((thing ?x) (rare ?x)))"
                  "(:- (above ?x ?y) ((on ?x ?y)) ((on ?x ?z) (above ?z ?y)))"
                  "(:- (loop ?x ?y) ((loop ?y ?x)))"};
};

TEST_F(ProverTests, BeginWithTheFactThatFewestMatch) {
  EXPECT_FALSE(state.holds("((not (and (thing ?x) (rare ?x))))"));
  EXPECT_LE(state.inferences, 5U);
  EXPECT_TRUE(state.holds("((some-rare))"));
  EXPECT_LE(state.inferences, 5U);
}

TEST_F(ProverTests, KeepTheOrderOfGoalsWhereTheirAnswersAreWanted) {
  Questions order("(p a) (p b) (p c) (q b) (q a) (r x) (r y)", "");

  EXPECT_EQ(order.ask("((p ?x) (q ?x) (r ?y))", "?x ?y"), "(a x) (a y) (b x) (b y)");
  EXPECT_EQ(order.one("((p ?x) (q ?x))", "?x"), "(b)");
}

TEST_F(ProverTests, EndWithTheFirstProofOfAGroundAtom) {
  Questions many(facts(), "(:- (rich) ((thing ?x) (thing ?y) (thing ?z)))");

  EXPECT_TRUE(many.holds("((rich))"));
  EXPECT_LE(many.inferences, 6U);
}

TEST_F(ProverTests, FollowAxiomsThatLeadBackToThemselves) {
  EXPECT_TRUE(state.holds("((above b3 table))"));
  EXPECT_TRUE(state.holds("((not (above table b3)))"));
  EXPECT_FALSE(state.holds("((not (above b2 b1)))"));
  EXPECT_EQ(state.ask("((above b3 ?x))", "?x"), "(b2)");
}

TEST_F(ProverTests, DoNotMoveFactsBeforeWhatDependsOnWhatIsBound) {
  // While ?x is open some thing is rare; then no other can be found.
  EXPECT_TRUE(state.holds("((not (and (not (rare ?x)) (thing ?x) (rare t7))))"));
  EXPECT_FALSE(state.holds("((not (and (thing ?x) (not (rare ?x)) (rare t7))))"));
}

TEST_F(ProverTests, AreStoppedInsideAxiomsThatNeverEnd) {
  state.limits.inferences = 1'000;

  EXPECT_EQ(state.ask("((loop a b))"), "stopped: inferences");
}

// ---- limits ----------------------------------------------------------------------------------

/// Proving takes 40^5 inferences: more than any test waits for.
class ProverLimits : public Test {
 protected:
  static std::string numbers() {
    std::string facts;
    for (int at = 0; at < 40; ++at) facts += "(n " + std::to_string(at) + ")";
    return facts;
  }
  Questions state{numbers()};
  const std::string endless = "((n ?a) (n ?b) (n ?c) (n ?d) (n ?e) (eval (> ?e 99)))";
};

TEST_F(ProverLimits, StopAfterSoManyInferences) {
  state.limits.inferences = 10'000;

  EXPECT_EQ(state.ask(endless), "stopped: inferences");
  EXPECT_EQ(state.inferences, 10'001U);
}

TEST_F(ProverLimits, AllowAsManyInferencesAsAreNeeded) {
  ASSERT_EQ(state.ask("((n 1) (n 2) (n 3))"), "nil");
  const std::uint64_t needed = state.inferences;

  state.limits.inferences = needed;
  EXPECT_EQ(state.ask("((n 1) (n 2) (n 3))"), "nil");
  state.limits.inferences = needed - 1;
  EXPECT_EQ(state.ask("((n 1) (n 2) (n 3))"), "stopped: inferences");
}

TEST_F(ProverLimits, StopWhenTheClockSaysSo) {
  double now = 100;
  state.limits.seconds = 2.5;
  state.host.cpu_seconds = [&now] { return now += 0.25; };

  EXPECT_EQ(state.ask(endless), "stopped: time");
  EXPECT_LT(now, 104);
}

TEST_F(ProverLimits, MeasureTimeFromTheStartOfTheSearch) {
  state.limits.seconds = 10;
  state.host.cpu_seconds = [] { return 1e6; };

  EXPECT_EQ(state.ask("((n 7))"), "nil");
}

TEST_F(ProverLimits, StopWhenTheHostCancels) {
  int asked = 0;
  state.host.cancelled = [&asked] { return ++asked == 5; };

  EXPECT_EQ(state.ask(endless), "stopped: cancelled");
  EXPECT_EQ(asked, 5);
}

TEST_F(ProverLimits, StopWhenAnotherThreadCancels) {
  std::atomic<bool> cancelled{false};
  std::atomic<bool> begun{false};
  state.host.cancelled = [&] {
    begun = true;
    return cancelled.load();
  };
  std::thread other([&] {
    while (!begun) std::this_thread::yield();
    cancelled = true;
  });

  EXPECT_EQ(state.ask(endless), "stopped: cancelled");
  other.join();
}

TEST_F(ProverLimits, StopInsideEndlessAxioms) {
  Questions loop("", "(:- (loop ?x) ((loop (f ?x))))");
  loop.limits.inferences = 1'000;

  EXPECT_EQ(loop.ask("((loop a))"), "stopped: inferences");
  EXPECT_EQ(loop.ask("((not (loop a)))"), "stopped: inferences");
  EXPECT_EQ(loop.ask("((setof ?x (loop ?x) ?l))", "?l"), "stopped: inferences");
  EXPECT_EQ(loop.ask("((forall (?x) ((loop ?x)) ((loop ?x))))"), "stopped: inferences");
}

}  // namespace
}  // namespace skein::htn
