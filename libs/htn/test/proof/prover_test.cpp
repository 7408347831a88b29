// SPDX-License-Identifier: Apache-2.0
// Which answers a condition has and in which order: facts, axioms, connectives.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <functional>

#include "testing/planner_questions.hpp"

namespace skein::htn {
namespace {

using test::Questions;

// ---- facts -----------------------------------------------------------------------------------

TEST(Prover, GivesTheAnswersOfAGoalInTheOrderInWhichTheFactsCame) {
  Questions state("(p a) (p b) (p c)");

  EXPECT_EQ(state.ask("((p ?x))", "?x"), "(a) (b) (c)");
}

TEST(Prover, MeetsTheNewestFactFirst) {
  Questions state("(p a) (p b) (p c)");

  EXPECT_EQ(state.one("((p ?x))", "?x"), "(c)");
  EXPECT_EQ(state.ask("(:first (p ?x))", "?x"), "(c)");
}

TEST(Prover, VariesTheLastGoalFastest) {
  Questions state("(p a) (p b) (q 1) (q 2)");

  EXPECT_EQ(state.ask("((p ?x) (q ?y))", "?x ?y"), "(a 1) (a 2) (b 1) (b 2)");
}

TEST(Prover, BindsAVariableOnceInAConjunction) {
  Questions state("(p a) (p b) (p c) (q c) (q a) (r a a) (r a b)");

  EXPECT_EQ(state.ask("((p ?x) (q ?x))", "?x"), "(a) (c)");
  EXPECT_EQ(state.ask("((r ?x ?x))", "?x"), "(a)");
  EXPECT_EQ(state.ask("((r ?x ?y) (p ?y))", "?x ?y"), "(a a) (a b)");
}

TEST(Prover, HasOneEmptyAnswerForNothing) {
  Questions state("");

  for (const char* nothing : {"()", "nil", "(and)", "(:first)", "(())", "(() ())"}) {
    EXPECT_TRUE(state.holds(nothing)) << nothing;
  }
}

TEST(Prover, GivesNoAnswerTwice) {
  Questions state("(p a 1) (p a 2) (p b 1)", "(:- (q ?x) ((p ?x 1))) (:- (q ?x) ((p ?x 2)))");

  EXPECT_EQ(state.ask("((q ?x))", "?x"), "(a) (b)");
  EXPECT_EQ(state.ask("((or (p ?x 1) (p ?x 2)))", "?x"), "(a) (b)");
}

TEST(Prover, MatchesListsAndDottedPairsInsideFacts) {
  Questions state("(route (a b c)) (route (d)) (route e)");

  EXPECT_EQ(state.ask("((route (?first . ?rest)))", "?first ?rest"), "(a (b c)) (d nil)");
  EXPECT_EQ(state.ask("((route (?one ?two ?three)))", "?two"), "(b)");
  EXPECT_EQ(state.ask("((route ?all))", "?all"), "((a b c)) ((d)) (e)");
}

TEST(Prover, DoesNotMatchAtomsOfAnotherLength) {
  Questions state("(p a) (p a b) (p)");

  EXPECT_EQ(state.ask("((p ?x))", "?x"), "(a)");
  EXPECT_TRUE(state.holds("((p))"));
}

TEST(Prover, TellsNumbersOfDifferentKindsApartInAtoms) {
  Questions state("(fuel 1) (name \"Karma\")");

  EXPECT_FALSE(state.holds("((fuel 1.0))"));
  EXPECT_TRUE(state.holds("((fuel 1))"));
  EXPECT_FALSE(state.holds("((name \"KARMA\"))"));
}

TEST(Prover, IgnoresTheCaseOfSymbols) {
  Questions state("(At Karma P1)");

  EXPECT_EQ(state.ask("((AT karma ?Where))", "?where"), "(p1)");
}

TEST(Prover, TreatsAnonymousVariablesAsDifferentEachTime) {
  Questions state("(r a b)");

  EXPECT_TRUE(state.holds("((r ?_ ?_))"));
  EXPECT_TRUE(state.holds("((r ?_any ?_any))"));
  EXPECT_FALSE(state.holds("((r ?any ?any))"));
}

TEST(Prover, FindsTheSameAnswersThroughAnIndexAsByScanning) {
  std::string facts;
  for (int at = 0; at < 30; ++at) {
    facts += "(on b" + std::to_string(at) + " b" + std::to_string(at % 5) + ")";
    facts += "(goal (on b" + std::to_string(at) + " b" + std::to_string(at % 5) + "))";
  }
  Questions state(facts);

  EXPECT_EQ(state.ask("((on ?x b3))", "?x"), "(b3) (b8) (b13) (b18) (b23) (b28)");
  EXPECT_EQ(state.ask("((goal (on ?x b3)))", "?x"), "(b3) (b8) (b13) (b18) (b23) (b28)");
  EXPECT_EQ(state.ask("((goal (on b7 ?y)))", "?y"), "(b2)");
  EXPECT_EQ(state.ask("((goal (on b7 ?y)) (on ?x ?y) (goal (on ?x b2)))", "?x"),
            "(b2) (b7) (b12) (b17) (b22) (b27)");
}

TEST(Prover, FindsAnAtomWhosePredicateIsTheValueOfAVariable) {
  Questions state("(kind at) (kind near) (at karma p1) (near karma p2) (near karma p3)");

  EXPECT_EQ(state.ask("((kind ?p) (?p karma ?where))", "?p ?where"), "(at p1) (near p2) (near p3)");
  EXPECT_EQ(state.ask("((kind ?p) (?p karma p2))", "?p"), "(near)");
}

// ---- axioms ----------------------------------------------------------------------------------

TEST(ProverAxioms, GiveTheirAnswersBehindThoseOfTheFacts) {
  Questions state("(p a) (p b) (q c) (q d)", "(:- (p ?x) ((q ?x)))");

  EXPECT_EQ(state.ask("((p ?x))", "?x"), "(a) (b) (c) (d)");
  EXPECT_EQ(state.one("((p ?x))", "?x"), "(b)");
}

TEST(ProverAxioms, GiveTheAnswersOfALaterAxiomBeforeThoseOfAnEarlier) {
  Questions state("(q a) (q b) (r c) (r d)", "(:- (p ?x) ((q ?x))) (:- (p ?x) ((r ?x)))");

  EXPECT_EQ(state.ask("((p ?x))", "?x"), "(c) (d) (a) (b)");
  EXPECT_EQ(state.one("((p ?x))", "?x"), "(b)");
}

TEST(ProverAxioms, KeepTheirOrderWithFactsUnderFurtherGoals) {
  Questions state("(p a) (q b) (s 1) (s 2)", "(:- (p ?x) ((q ?x)))");

  EXPECT_EQ(state.ask("((p ?x) (s ?n))", "?x ?n"), "(a 1) (a 2) (b 1) (b 2)");
  EXPECT_EQ(state.ask("((s ?n) (p ?x))", "?x ?n"), "(a 1) (b 1) (a 2) (b 2)");
}

TEST(ProverAxioms, WithoutBodyAreFacts) {
  Questions state("(p b)", "(:- (p a)) (:- (same ?x ?x) nil)");

  EXPECT_EQ(state.ask("((p ?x))", "?x"), "(b) (a)");
  EXPECT_TRUE(state.holds("((same (a b) (a b)))"));
  EXPECT_FALSE(state.holds("((same a b))"));
  EXPECT_EQ(state.ask("((same ?x (f y)))", "?x"), "((f y))");
}

TEST(ProverAxioms, UseTheFirstTailThatHolds) {
  const std::string axiom = "(:- (best ?x) ((gold ?x)) ((silver ?x)) ((bronze ?x)))";

  EXPECT_EQ(Questions("(bronze c) (silver b) (gold a)", axiom).ask("((best ?x))", "?x"), "(a)");
  EXPECT_EQ(Questions("(bronze c) (silver b) (silver d)", axiom).ask("((best ?x))", "?x"),
            "(b) (d)");
  EXPECT_EQ(Questions("(bronze c)", axiom).ask("((best ?x))", "?x"), "(c)");
  EXPECT_EQ(Questions("", axiom).ask("((best ?x))", "?x"), "none");
}

TEST(ProverAxioms, DoNotTryFurtherTailsWhenWhatFollowsFails) {
  Questions state("(gold a) (silver b) (wanted b)", "(:- (best ?x) ((gold ?x)) ((silver ?x)))");

  EXPECT_EQ(state.ask("((best ?x) (wanted ?x))", "?x"), "none");
  EXPECT_EQ(state.ask("((wanted ?x) (best ?x))", "?x"), "(b)");
}

TEST(ProverAxioms, TryTheNextAxiomAlsoWhenATailOfTheFirstHeld) {
  Questions state("(gold a) (silver b) (iron c)",
                  "(:- (m ?x) ((gold ?x)) ((silver ?x))) (:- (m ?x) ((iron ?x)))");

  EXPECT_EQ(state.ask("((m ?x))", "?x"), "(c) (a)");
}

TEST(ProverAxioms, GiveOneAnswerFromATailThatBeginsWithFirst) {
  Questions state("(q a) (q b) (r 1) (r 2)", "(:- (p ?x) (:first (q ?x)))");

  EXPECT_EQ(state.ask("((p ?x))", "?x"), "(b)");
  EXPECT_EQ(state.ask("((r ?n) (p ?x))", "?n ?x"), "(1 b) (2 b)");
}

TEST(ProverAxioms, MayHaveLabelsOnTheirTails) {
  Questions state("(silver b)", "(:- (best ?x) winner ((gold ?x)) second ((silver ?x)))");

  EXPECT_EQ(state.ask("((best ?x))", "?x"), "(b)");
}

TEST(ProverAxioms, AnswerWithVariablesThatStayUnbound) {
  Questions state("(q a)", "(:- (p ?x (f ?y ?z ?y)) ((q ?x)))");

  EXPECT_EQ(state.ask("((p ?x ?t) (same-shape))", "?x"), "none");
  const std::string found = state.ask("((p ?x (f 1 2 ?w)))", "?x ?w");
  EXPECT_EQ(found, "(a 1)");
  EXPECT_NE(state.ask("((p ?x ?t))", "?t").find("((f ?_"), std::string::npos);
}

TEST(ProverAxioms, CallEachOtherAndThemselves) {
  Questions state("(link a b) (link b c) (link c d)",
                  "(:- (reach ?x ?y) ((link ?x ?y))) "
                  "(:- (reach ?x ?z) ((link ?x ?y) (reach ?y ?z)))");

  // The tail of two goals is a query of its own: its answers (d c) are gone through as they stand.
  EXPECT_EQ(state.ask("((reach a ?x))", "?x"), "(c) (d) (b)");
  EXPECT_TRUE(state.holds("((reach a d))"));
  EXPECT_FALSE(state.holds("((reach d a))"));
}

TEST(ProverAxioms, KeepTheVariablesOfTheirActivationsApart) {
  Questions state("",
                  "(:- (len nil 0)) "
                  "(:- (len (?_ . ?rest) ?n) ((len ?rest ?m) (assign ?n (call + ?m 1))))");

  EXPECT_EQ(state.ask("((len (a b c d) ?n))", "?n"), "(4)");
  EXPECT_EQ(state.ask("((len () ?n))", "?n"), "(0)");
}

TEST(ProverAxioms, RecurAHundredThousandLevelsDeep) {
  Questions state("",
                  "(:- (down 0) ()) "
                  "(:- (down ?n) ((eval (> ?n 0)) (assign ?m (- ?n 1)) (down ?m)))");

  EXPECT_TRUE(state.holds("((down 100000))"));
}

TEST(ProverAxioms, RecurAHundredThousandLevelsDeepWithGoalsLeftBehind) {
  Questions state("",
                  "(:- (sum 0 0) ()) "
                  "(:- (sum ?n ?s) ((eval (> ?n 0)) (assign ?m (- ?n 1)) (sum ?m ?r)"
                  " (assign ?s (+ ?r 1))))");

  EXPECT_EQ(state.ask("((sum 100000 ?s))", "?s"), "(100000)");
}

TEST(ProverAxioms, RecurAHundredThousandLevelsDeepThroughNegationsAndTails) {
  Questions state("",
                  "(:- (even ?n) zero ((eval (= ?n 0)))"
                  " more ((assign ?m (- ?n 1)) (not (even ?m))))");

  EXPECT_TRUE(state.holds("((even 100000))"));
  EXPECT_FALSE(state.holds("((even 100001))"));
}

// ---- connectives -----------------------------------------------------------------------------

TEST(ProverConnectives, ReverseTheAnswersOfAConjunctionThatIsWrittenOut) {
  Questions state("(p a) (p b) (p c)");

  EXPECT_EQ(state.ask("((p ?x))", "?x"), "(a) (b) (c)");
  EXPECT_EQ(state.ask("(and (p ?x))", "?x"), "(c) (b) (a)");
  EXPECT_EQ(state.ask("((and (p ?x)))", "?x"), "(c) (b) (a)");
  EXPECT_EQ(state.ask("((and (and (p ?x))))", "?x"), "(a) (b) (c)");
}

TEST(ProverConnectives, GoThroughTheAlternativesOfOrOneAfterTheOther) {
  Questions state("(p a) (p b) (q c) (q d)");

  EXPECT_EQ(state.ask("((or (p ?x) (q ?x)))", "?x"), "(d) (c) (b) (a)");
  EXPECT_EQ(state.one("((or (p ?x) (q ?x)))", "?x"), "(a)");
  EXPECT_EQ(state.ask("((or (q ?x) (p ?x)))", "?x"), "(b) (a) (d) (c)");
}

TEST(ProverConnectives, TakeAListOfGoalsAsAnAlternative) {
  Questions state("(p a) (q a) (p b) (r c)");

  EXPECT_EQ(state.ask("((or ((p ?x) (q ?x)) (r ?x)))", "?x"), "(c) (a)");
  EXPECT_EQ(state.ask("((or))", ""), "none");
}

TEST(ProverConnectives, NegateWithoutBinding) {
  Questions state("(p a) (p b) (q a)");

  EXPECT_EQ(state.ask("((p ?x) (not (q ?x)))", "?x"), "(b)");
  EXPECT_FALSE(state.holds("((not (q ?any)))"));
  EXPECT_TRUE(state.holds("((not (r ?any)))"));
  EXPECT_EQ(state.ask("((not (r ?x)) (p ?x))", "?x"), "(a) (b)");
  EXPECT_TRUE(state.holds("((not (not (p a))))"));
  EXPECT_TRUE(state.holds("((not (and (p b) (q b))))"));
}

TEST(ProverConnectives, ImplyWhatHoldsOrWhoseConditionDoesNot) {
  Questions state("(p a) (p b) (q a) (r a)");

  EXPECT_EQ(state.ask("((p ?x) (imply (q ?x) (r ?x)))", "?x"), "(a) (b)");
  EXPECT_TRUE(state.holds("((imply (q b) (r b)))"));
  EXPECT_FALSE(state.holds("((imply (p b) (q b)))"));
  EXPECT_TRUE(state.holds("((imply (q a) (r a)))"));
}

TEST(ProverConnectives, TakeExternalAsAnd) {
  Questions state("(p a) (q a)");

  EXPECT_EQ(state.ask("((:external (p ?x) (q ?x)))", "?x"), "(a)");
}

TEST(ProverConnectives, AskForAllBounds) {
  Questions state("(uav a) (uav b) (ready a) (ready b) (fuelled a)");

  EXPECT_TRUE(state.holds("((forall (?u) ((uav ?u)) ((ready ?u))))"));
  EXPECT_FALSE(state.holds("((forall (?u) ((uav ?u)) ((fuelled ?u))))"));
  EXPECT_TRUE(state.holds("((forall (?u) ((boat ?u)) ((fuelled ?u))))"));
  EXPECT_TRUE(state.holds("((forall (?u) ((uav ?u) (fuelled ?u)) (ready ?u)))"));
  EXPECT_TRUE(state.holds("(forall (?u) (uav ?u) (ready ?u))"));
}

TEST(ProverConnectives, AskForOneOfTheBounds) {
  Questions state("(uav a) (uav b) (fuelled b)");

  EXPECT_TRUE(state.holds("((exists (?u) ((uav ?u)) ((fuelled ?u))))"));
  EXPECT_FALSE(state.holds("((exists (?u) ((boat ?u)) ((fuelled ?u))))"));
  EXPECT_FALSE(state.holds("((exists (?u) ((uav ?u)) ((lost ?u))))"));
}

TEST(ProverConnectives, HideTheVariablesOfAQuantifier) {
  Questions state("(uav a) (uav b) (ready a) (ready b) (chief b)");

  EXPECT_EQ(state.ask("((chief ?u) (forall (?u) ((uav ?u)) ((ready ?u))))", "?u"), "(b)");
  EXPECT_EQ(state.ask("((exists (?u) ((uav ?u)) ((ready ?u))) (uav ?u))", "?u"), "(a) (b)");
}

TEST(ProverConnectives, UseOuterVariablesInsideQuantifiers) {
  Questions state("(team x) (team y) (member x a) (member x b) (member y c) (ready a) (ready b)");

  EXPECT_EQ(state.ask("((team ?t) (forall (?u) ((member ?t ?u)) ((ready ?u))))", "?t"), "(x)");
  EXPECT_EQ(state.ask("((team ?t) (not (exists (?u) ((member ?t ?u)) ((ready ?u)))))", "?t"),
            "(y)");
}

TEST(ProverConnectives, NestQuantifiers) {
  Questions state("(row 1) (row 2) (col a) (col b) (free 1 a) (free 1 b) (free 2 a)");

  EXPECT_FALSE(state.holds("((forall (?r) ((row ?r)) ((forall (?c) ((col ?c)) ((free ?r ?c))))))"));
  EXPECT_TRUE(state.holds("((exists (?r) ((row ?r)) ((forall (?c) ((col ?c)) ((free ?r ?c))))))"));
  EXPECT_TRUE(state.holds("((forall (?r) ((row ?r)) ((exists (?c) ((col ?c)) ((free ?r ?c))))))"));
}

// ---- what stands at the head of a precondition ------------------------------------------------

TEST(ProverSortBy, SortsByTheValueOfAVariable) {
  Questions state("(d a 3) (d b 1) (d c 2)");

  EXPECT_EQ(state.ask("(:sort-by ?n ((d ?x ?n)))", "?x"), "(b) (c) (a)");
  EXPECT_EQ(state.ask("(:sort-by ?n #'> ((d ?x ?n)))", "?x"), "(a) (c) (b)");
  EXPECT_EQ(state.ask("(:sort-by ?n < (d ?x ?n))", "?x"), "(b) (c) (a)");
}

TEST(ProverSortBy, SortsByAnExpression) {
  Questions state("(d a 3) (d b 1) (d c 2)");

  EXPECT_EQ(state.ask("(:sort-by (* -1 ?n) ((d ?x ?n)))", "?x"), "(a) (c) (b)");
}

TEST(ProverSortBy, KeepsTheOrderOfEqualValues) {
  Questions state("(d a 2) (d b 1) (d c 2) (d e 1) (d f 2)");

  EXPECT_EQ(state.ask("(:sort-by ?n ((d ?x ?n)))", "?x"), "(b) (e) (a) (c) (f)");
  EXPECT_EQ(state.ask("(:sort-by ?n #'> ((d ?x ?n)))", "?x"), "(a) (c) (f) (b) (e)");
}

TEST(ProverSortBy, SortsWithAFunctionOfTheDomain) {
  const std::string by_distance = "(:sort-by ?n #'(lambda (x y) (< (abs x) (abs y))) ((d ?x ?n)))";

  EXPECT_EQ(Questions("(d a 3) (d b -5) (d c 2)").ask(by_distance, "?x"), "(c) (a) (b)");
}

TEST(ProverSortBy, IsAnErrorWithItsPlaceForWhatIsNoNumber) {
  const std::string found = Questions("(d a 3) (d b x)").ask("(:sort-by ?n ((d ?x ?n)))", "?x");

  EXPECT_EQ(found.substr(0, 18), "error: case.lisp:3") << found;
  EXPECT_NE(found.find(":sort-by compares numbers, not x and 3"), std::string::npos) << found;
}

// ---- against trying every binding -------------------------------------------------------------

/// A state of p/1 and q/2 over three constants, as bits; q leads upwards, so that `reach` ends.
struct SmallState {
  unsigned p = 0, q = 0;

  static constexpr int kConstants = 3;
  bool has_p(int a) const { return (p >> a & 1U) != 0; }
  bool has_q(int a, int b) const { return a < b && (q >> (a * kConstants + b) & 1U) != 0; }
  bool reaches(int a, int b) const {
    bool found = has_q(a, b);
    for (int m = a + 1; m < b; ++m) found = found || (has_q(a, m) && reaches(m, b));
    return found;
  }
  std::string text() const {
    std::string facts;
    for (int a = 0; a < kConstants; ++a) {
      facts += "(c " + std::to_string(a) + ") ";
      if (has_p(a)) facts += "(p " + std::to_string(a) + ") ";
      for (int b = 0; b < kConstants; ++b)
        if (has_q(a, b)) facts += "(q " + std::to_string(a) + " " + std::to_string(b) + ") ";
    }
    return facts;
  }
};

/// A condition as text, and what it means when ?x, ?y and ?z are the constants of a row.
struct Meant {
  std::string text;
  std::function<bool(const SmallState&, const std::array<int, 3>&)> is_true;
};

Meant drawn_atom(bool inside_forall) {
  const auto variable = [&] { return *rc::gen::inRange(0, inside_forall ? 3 : 2); };
  const int a = variable(), b = variable();
  const std::string one = std::string(" ?") + "xyz"[a], two = std::string(" ?") + "xyz"[b];
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return {"(p" + one + ")", [a](const auto& state, const auto& row) {
                return state.has_p(row[static_cast<std::size_t>(a)]);
              }};
    case 1:
      return {"(q" + one + two + ")", [a, b](const auto& state, const auto& row) {
                return state.has_q(row[static_cast<std::size_t>(a)],
                                   row[static_cast<std::size_t>(b)]);
              }};
    case 2:
      return {"(eval (< " + one + two + "))", [a, b](const auto&, const auto& row) {
                return row[static_cast<std::size_t>(a)] < row[static_cast<std::size_t>(b)];
              }};
    default:
      return {"(reach" + one + two + ")", [a, b](const auto& state, const auto& row) {
                return state.reaches(row[static_cast<std::size_t>(a)],
                                     row[static_cast<std::size_t>(b)]);
              }};
  }
}

Meant drawn_condition(int depth, bool inside_forall = false) {
  if (depth == 0) return drawn_atom(inside_forall);
  const int kind = *rc::gen::inRange(0, inside_forall ? 4 : 5);
  const Meant one = drawn_condition(depth - 1, inside_forall || kind == 4);
  if (kind == 0)
    return {"(not " + one.text + ")",
            [one](const auto& state, const auto& row) { return !one.is_true(state, row); }};
  if (kind == 4)
    return {"(forall (?z) ((c ?z)) (" + one.text + "))", [one](const auto& state, auto row) {
              bool all = true;
              for (row[2] = 0; row[2] < SmallState::kConstants; ++row[2])
                all = all && one.is_true(state, row);
              return all;
            }};
  const Meant two = drawn_condition(depth - 1, inside_forall);
  const std::string word = kind == 1 ? "and" : kind == 2 ? "or" : "imply";
  return {"(" + word + " " + one.text + " " + two.text + ")",
          [one, two, kind](const auto& state, const auto& row) {
            const bool a = one.is_true(state, row), b = two.is_true(state, row);
            return kind == 1 ? a && b : kind == 2 ? a || b : !a || b;
          }};
}

RC_GTEST_PROP(ProverProperty, FindsTheBindingsThatTryingThemAllFinds, ()) {
  const SmallState state{*rc::gen::inRange(0U, 8U), *rc::gen::inRange(0U, 512U)};
  const Meant drawn = drawn_condition(*rc::gen::inRange(0, 4));
  std::string expected;
  for (int x = 0; x < SmallState::kConstants; ++x)
    for (int y = 0; y < SmallState::kConstants; ++y)
      if (drawn.is_true(state, {x, y, 0}))
        expected +=
            (expected.empty() ? "(" : " (") + std::to_string(x) + " " + std::to_string(y) + ")";
  Questions questions(state.text(),
                      "(:- (reach ?a ?b) ((q ?a ?b)) ((q ?a ?m) (reach ?m ?b)))"
                      "(:- (reach ?a ?b) ((q ?a ?m) (reach ?m ?b)))");

  const std::string found = questions.ask("((c ?x) (c ?y) " + drawn.text + ")", "?x ?y");

  RC_LOG() << state.text() << drawn.text;
  RC_ASSERT(found == (expected.empty() ? "none" : expected));
}

}  // namespace
}  // namespace skein::htn
