// SPDX-License-Identifier: Apache-2.0
// Which plans a search gives: first, all, shallow, cheap, by deepening; and how it treats tasks.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "testing/naive_planner.hpp"
#include "testing/planner_case.hpp"

namespace skein::htn {
namespace {

using test::adds;
using test::Case;
using test::does;
using Plans = std::vector<std::string>;

std::string step(const std::string& head, const std::string& cost = "1") {
  return adds(head, "", cost);
}

/// Four ways to go: three cheap steps, one dear step, two cheap steps, one step dearer still.
std::string four_ways() {
  return does("(go)", "((!a) (!a) (!a))") + does("(go)", "((!b))") + does("(go)", "((!c) (!c))") +
         does("(go)", "((!d))") + step("(!a)") + step("(!b)", "5") + step("(!c)") +
         step("(!d)", "7");
}

Plans ways(Which which, const std::function<void(Options&)>& also = {}) {
  Case made(four_ways(), "", "((go))");
  made.options.which = which;
  if (also) also(made.options);
  const Outcome outcome = made.run();
  Plans out;
  for (const Plan& plan : outcome.plans) out.push_back(made.steps(plan));
  EXPECT_EQ(outcome.verdict, out.empty() ? Verdict::kNoPlan : Verdict::kPlan);
  return out;
}

// ---- which -----------------------------------------------------------------------------------

TEST(SearchWhich, FirstIsTheFirstInTheOrderOfTheMethods) {
  EXPECT_EQ(ways(Which::kFirst), (Plans{"(!a) (!a) (!a)"}));
}

TEST(SearchWhich, AllIsEveryPlanInTheOrderOfTheSearch) {
  EXPECT_EQ(ways(Which::kAll), (Plans{"(!a) (!a) (!a)", "(!b)", "(!c) (!c)", "(!d)"}));
}

TEST(SearchWhich, ShallowestIsAPlanOfLeastDepth) {
  EXPECT_EQ(ways(Which::kShallowest), (Plans{"(!b)"}));
}

TEST(SearchWhich, AllShallowestAreAllPlansOfLeastDepth) {
  EXPECT_EQ(ways(Which::kAllShallowest), (Plans{"(!b)", "(!d)"}));
}

TEST(SearchWhich, DeepeningMeetsTheShallowPlansFirst) {
  EXPECT_EQ(ways(Which::kIdFirst), (Plans{"(!b)"}));
  EXPECT_EQ(ways(Which::kIdAll), (Plans{"(!b)", "(!d)", "(!c) (!c)", "(!a) (!a) (!a)"}));
}

TEST(SearchWhich, BestIsThePlanOfLeastCost) { EXPECT_EQ(ways(Which::kBest), (Plans{"(!c) (!c)"})); }

TEST(SearchWhich, OptimizingKeepsThePlanOfLeastCost) {
  EXPECT_EQ(ways(Which::kFirst, [](Options& options) { options.optimize_cost = true; }),
            (Plans{"(!c) (!c)"}));
}

TEST(SearchWhich, ACostLimitGivesTheFirstPlanThatIsCheapEnough) {
  const auto up_to = [](double cost) {
    return ways(Which::kFirst, [cost](Options& options) { options.cost_limit = cost; });
  };

  EXPECT_EQ(up_to(4), (Plans{"(!a) (!a) (!a)"}));
  EXPECT_EQ(up_to(2), (Plans{"(!c) (!c)"}));
  EXPECT_EQ(up_to(1), Plans{});
}

TEST(SearchWhich, NoMorePlansAreGivenThanAskedFor) {
  const auto two = [](Options& options) { options.limits.plans = 2; };

  EXPECT_EQ(ways(Which::kAll, two), (Plans{"(!a) (!a) (!a)", "(!b)"}));
  EXPECT_EQ(ways(Which::kIdAll, two), (Plans{"(!b)", "(!d)"}));
  EXPECT_EQ(ways(Which::kIdAll, [](Options& options) { options.limits.plans = 3; }).size(), 3U);
}

TEST(SearchWhich, DeepeningGivesNoMorePlansThanAskedForOverAllDepths) {
  Case made(does("(go)", "((!a))") + does("(go)", "((!a) (!a))") + does("(go)", "((!b) (!b))") +
                step("(!a)") + step("(!b)"),
            "", "((go))");
  made.options.which = Which::kIdAll;
  made.options.limits.plans = 2;

  EXPECT_EQ(made.run().plans.size(), 2U);
}

TEST(SearchWhich, DeepeningFindsWhatDepthFirstSearchLoopsOn) {
  const std::string loop = does("(reach)", "((!turn) (reach))") + does("(reach)", "((!arrive))") +
                           step("(!turn)") + step("(!arrive)");
  Case first(loop, "", "((reach))");
  first.options.limits.expansions = 10'000;
  Case deepening(loop, "", "((reach))");
  deepening.options.which = Which::kIdFirst;

  EXPECT_EQ(first.first(), "limit: expansions");
  EXPECT_EQ(deepening.first(), "(!arrive)");
}

TEST(SearchWhich, DeepeningEndsWhenNothingIsDeeper) {
  for (const Which which : {Which::kIdFirst, Which::kIdAll}) {
    Case made(does("(go)", "((!never))") + "(:operator (!never) ((never)) () ())", "", "((go))");
    made.options.which = which;

    EXPECT_EQ(made.first(), "no plan");
  }
}

TEST(SearchWhich, TellsEachPlanWhenItIsFound) {
  Case made(four_ways(), "", "((go))");
  made.options.which = Which::kBest;
  Plans told;
  made.host.plan_found = [&](const Plan& plan) { told.push_back(made.steps(plan)); };

  made.run();

  EXPECT_EQ(told, (Plans{"(!a) (!a) (!a)", "(!c) (!c)"}));
}

RC_GTEST_PROP(SearchProperty, BestHasTheLeastCostOfAll,
              (const std::vector<std::uint8_t>& bytes, bool negative)) {
  std::string items;
  std::string tasks;
  for (std::size_t task = 0; task < std::min<std::size_t>(bytes.size() / 3, 4); ++task) {
    const std::string name = "t" + std::to_string(task);
    tasks += "(" + name + ")";
    for (std::size_t way = 0; way < 3; ++way) {
      const std::string operation = "(!" + name + "-" + std::to_string(way) + ")";
      const int cost = bytes[task * 3 + way] % 8 - (negative ? 4 : 0);
      items +=
          does("(" + name + ")", "(" + operation + ")") + step(operation, std::to_string(cost));
    }
  }
  Case all(items, "", "(" + tasks + ")");
  all.options.which = Which::kAll;
  Case best(items, "", "(" + tasks + ")");
  best.options.which = Which::kBest;

  const Outcome every = all.run();
  const Outcome one = best.run();

  double least = 1e9;
  for (const Plan& plan : every.plans) least = std::min(least, to_double(plan.cost));
  RC_ASSERT(one.plans.size() == 1U);
  RC_ASSERT(to_double(one.plans.front().cost) == least);
  RC_ASSERT(one.statistics.expansions <= every.statistics.expansions * (negative ? 2U : 1U));
}

RC_GTEST_PROP(SearchProperty, FindsThePlansThatTryingEverythingFinds, ()) {
  const auto domain = test::NaiveDomain::drawn();
  const unsigned facts = *rc::gen::inRange(0U, 16U);
  const auto expected = test::NaivePlanner(domain).plans(facts);
  RC_PRE(expected.has_value());
  RC_LOG() << domain.items() << test::NaiveDomain::facts_text(facts);
  Case made(domain.items(), test::NaiveDomain::facts_text(facts), "((t0))");
  made.options.which = Which::kAll;

  const std::vector<std::string> found = made.all();

  const std::set<std::string> different(found.begin(), found.end());
  RC_ASSERT(different == (expected->empty() ? std::set<std::string>{"no plan"} : *expected));
  made.options.which = Which::kFirst;
  RC_ASSERT(made.first() == found.front());
}

// ---- methods and branches --------------------------------------------------------------------

TEST(SearchMethods, UseTheFirstBranchThatHasASatisfier) {
  const std::string method = "(:method (go) fast ((fuel)) ((!fly)) slow () ((!walk)))";
  const std::string items = method + step("(!fly)") + step("(!walk)");

  EXPECT_EQ(Case(items, "(fuel)", "((go))").all(), (Plans{"(!fly)"}));
  EXPECT_EQ(Case(items, "", "((go))").all(), (Plans{"(!walk)"}));
}

TEST(SearchMethods, TryTheSatisfiersOfABranchInOrder) {
  const std::string items = "(:method (go) ((p ?x)) ((!go ?x)))" + step("(!go ?x)");

  EXPECT_EQ(Case(items, "(p a) (p b) (p c)", "((go))").all(),
            (Plans{"(!go a)", "(!go b)", "(!go c)"}));
}

TEST(SearchMethods, DropReductionsThatAreEqual) {
  const std::string items = "(:method (go) ((p ?x ?y)) ((!go ?x)))" + step("(!go ?x)");

  EXPECT_EQ(Case(items, "(p a 1) (p a 2) (p b 1)", "((go))").all(), (Plans{"(!go a)", "(!go b)"}));
}

// As SHOP3 has it: reductions are compared by their tasks, and the first of equal ones is kept.
TEST(SearchMethods, DropEqualReductionsAlsoWhenTheyBindOtherVariables) {
  const std::string items = does("(go)", "((choose ?x) (!use ?x))") +
                            "(:method (choose ?x) ((p ?x)) ())" + step("(!use ?x)");

  EXPECT_EQ(Case(items, "(p a) (p b)", "((go))").all(), (Plans{"(!use a)"}));
}

TEST(SearchMethods, MatchTheirHeadsAgainstTheTask) {
  const std::string items =
      "(:method (visit (?first . ?rest)) () ((!see ?first) (visit ?rest)))"
      "(:method (visit nil) () ())" +
      step("(!see ?x)");

  EXPECT_EQ(Case(items, "", "((visit (a b c)))").all(), (Plans{"(!see a) (!see b) (!see c)"}));
}

TEST(SearchMethods, WorkOutAllSatisfiersBeforeTheFirstIsTried) {
  Case made(
      "(:method (go) ((p ?x)) ((!eat ?x) (!end)))(:operator (!eat ?x) () ((p ?x) (p c)) ())"
      "(:operator (!end) ((not (p b))) () ())",
      "(p a) (p b) (p c)", "((go))");

  EXPECT_EQ(made.all(), (Plans{"(!eat b) (!end)"}));
}

TEST(SearchMethods, MayHaveNothingToDo) {
  EXPECT_EQ(Case(does("(rest)", "()"), "", "((rest))").all(), (Plans{""}));
  EXPECT_EQ(Case("", "", "()").all(), (Plans{""}));
  EXPECT_EQ(Case(does("(rest)", "(:unordered)") + step("(!a)"), "", "((rest) (!a))").all(),
            (Plans{"(!a)"}));
}

// ---- tasks -----------------------------------------------------------------------------------

TEST(SearchTasks, InterleaveWithoutOrderEveryWay) {
  const std::string items = step("(!a)") + step("(!b)") + step("(!c)");

  EXPECT_EQ(Case(items, "", "(:unordered (!a) (!b))").all(), (Plans{"(!a) (!b)", "(!b) (!a)"}));
  EXPECT_EQ(Case(items, "", "(:unordered (:ordered (!a) (!b)) (!c))").all(),
            (Plans{"(!a) (!c) (!b)", "(!a) (!b) (!c)", "(!c) (!a) (!b)"}));
}

TEST(SearchTasks, WithoutOrderTakeTurns) {
  const std::string items = step("(!a1)") + step("(!a2)") + step("(!b1)") + step("(!b2)");

  EXPECT_EQ(Case(items, "", "(:unordered ((!a1) (!a2)) ((!b1) (!b2)))").first(),
            "(!a1) (!b1) (!a2) (!b2)");
}

TEST(SearchTasks, ThatAreImmediateComeFirst) {
  const std::string items = step("(!a)") + step("(!b)");

  EXPECT_EQ(Case(items, "", "(:unordered (!a) (:task :immediate !b))").all(), (Plans{"(!b) (!a)"}));
  EXPECT_EQ(Case(items, "", "(:unordered (!a) (:immediate !b))").all(), (Plans{"(!b) (!a)"}));
}

TEST(SearchTasks, GoDownToAStepBeforeOtherThreadsAdvance) {
  const std::string items = does("(deep)", "((deeper))") + does("(deeper)", "((!x) (!y))") +
                            step("(!x)") + step("(!y)") + step("(!other)");

  EXPECT_EQ(Case(items, "", "(:unordered (deep) (!other))").all(),
            (Plans{"(!x) (!other) (!y)", "(!x) (!y) (!other)", "(!other) (!x) (!y)"}));
}

TEST(SearchTasks, MayHaveVariablesThatStepsBindLater) {
  const std::string items = does("(go)", "((!pick ?x) (!use ?x))") +
                            "(:operator (!pick ?x) ((p ?x)) () ())" + step("(!use ?x)");

  EXPECT_EQ(Case(items, "(p a) (p b)", "((go))").first(), "(!pick b) (!use b)");
  EXPECT_EQ(Case(items, "(p a)", "((!pick ?y) (!use ?y))").first(), "(!pick a) (!use a)");
}

TEST(SearchTasks, MayHaveVariablesThatMethodsBindLater) {
  const std::string items = does("(go)", "((choose ?x) (!use ?x))") +
                            "(:method (choose ?x) ((p ?x)) ((!chose ?x)))" + step("(!use ?x)") +
                            step("(!chose ?x)");

  EXPECT_EQ(Case(items, "(p a) (p b)", "((go))").all(),
            (Plans{"(!chose a) (!use a)", "(!chose b) (!use b)"}));
}

TEST(SearchTasks, MayBeNamedByAVariable) {
  const std::string items = "(:method (do ?task ?x) () ((?task ?x)))" + step("(!fly ?x)") +
                            "(:method (ride ?x) () ((!ride ?x)))" + step("(!ride ?x)");

  EXPECT_EQ(Case(items, "", "((do !fly k) (do ride k))").first(), "(!fly k) (!ride k)");
  EXPECT_EQ(Case(items, "", "((do nothing k))").first(), "no plan");
}

TEST(SearchTasks, ComputeTheirArgumentsWithCalls) {
  const std::string items =
      "(:method (wait ?n) () ((!wait (call + ?n 1) x)"
      " (:task !wait (f (call * ?n 2)) ?n)))" +
      step("(!wait ?n ?x)");

  EXPECT_EQ(Case(items, "", "((wait 4))").first(), "(!wait 5 x) (!wait (f 8) 4)");
}

TEST(SearchTasks, AreErrorsWithTheirPlaceWhenTheyCannotBeComputed) {
  const std::string items = "(:method (wait ?n) () ((!wait (call / ?n 0))))" + step("(!wait ?n)");
  Case nothing("(:method (go) () ((call car '(go))))", "", "((go))");

  EXPECT_EQ(Case(items, "", "((wait 4))").first().substr(0, 17), "error: case.lisp:");
  EXPECT_EQ(nothing.first(), "error: case.lisp:2:15: a computed task is go");
}

TEST(SearchTasks, WithoutMethodAreDeadEnds) {
  EXPECT_EQ(Case("", "", "((unheard-of a))").first(), "no plan");
  EXPECT_EQ(Case("", "", "((!unheard-of a))").first(), "no plan");
  EXPECT_EQ(
      Case(does("(go)", "((unheard-of))") + does("(go)", "((!a))") + step("(!a)"), "", "((go))")
          .first(),
      "(!a)");
  EXPECT_EQ(Case(step("(!a ?x)"), "", "((!a))").first(), "no plan");
}

TEST(SearchTasks, ThatAreEqualAreDoneFirstWhereTheyStandFirst) {
  const std::string items = step("(!a)") + step("(!same)") + step("(!b)");

  EXPECT_EQ(Case(items, "", "(:unordered ((!a) (!same)) ((!same) (!b)))").first(),
            "(!a) (!same) (!same) (!b)");
}

// ---- the whole -------------------------------------------------------------------------------

TEST(Search, BacktracksOverMethodsSatisfiersAndOrders) {
  const std::string items =
      "(:method (go) ((p ?x)) ((!take ?x) (!need b)))"
      "(:method (go) ((q ?x)) ((!take ?x) (!need ?x)))"
      "(:operator (!take ?x) () () ((has ?x)))"
      "(:operator (!need ?x) ((has ?x) (good ?x)) () ())";

  EXPECT_EQ(Case(items, "(p a) (q c) (q d) (good d)", "((go))").all(),
            (Plans{"(!take d) (!need d)"}));
}

TEST(Search, IsDeterministicAndLeavesNothingBehind) {
  Case made(four_ways() + "(:method (pick) ((p ?x)) ((!take ?x) (go)))" + step("(!take ?x)"),
            "(p a) (p b)", "(:unordered (pick) (pick))");
  const Plans first = made.all();
  const Outcome one = made.run();

  const Outcome two = made.run();

  EXPECT_EQ(made.all(), first);
  EXPECT_EQ(one.statistics.expansions, two.statistics.expansions);
  EXPECT_EQ(one.statistics.inferences, two.statistics.inferences);
  EXPECT_EQ(one.plans.size(), two.plans.size());
}

TEST(Search, PlansOneDomainFromSeveralProblems) {
  Case made("(:method (go) ((p ?x)) ((!go ?x)))" + step("(!go ?x)"), "(p a)", "((go))");
  ASSERT_EQ(made.first(), "(!go a)");
  Problem other = made.problem();
  other.facts = {made.term("(p z)")};

  const Outcome outcome = plan(made.domain(), other, made.options);

  ASSERT_EQ(outcome.plans.size(), 1U);
  EXPECT_EQ(made.steps(outcome.plans.front()), "(!go z)");
  EXPECT_EQ(made.first(), "(!go a)");
}

TEST(Search, CountsTasksTakenAndPlansFound) {
  const Outcome outcome = Case(does("(go)", "((!a) (!a))") + step("(!a)"), "", "((go))").run();

  EXPECT_EQ(outcome.statistics.expansions, 4U);
  EXPECT_EQ(outcome.statistics.inferences, 0U);
  EXPECT_EQ(outcome.statistics.deepest, 3U);
  EXPECT_GT(outcome.statistics.memory_bytes, 0U);
}

// ---- what is told of a search that found nothing
// --------------------------------------------------

TEST(SearchCut, TellsWhereItStood) {
  Case made(
      does("(go)", "((!a) (turn 1))") + does("(turn ?x)", "((turn (s ?x)))") + adds("(!a)", ""), "",
      "((go))");
  made.options.explain_failure = true;
  for (const bool by_depth : {false, true}) {
    made.options.limits = {};
    (by_depth ? made.options.limits.depth : made.options.limits.expansions) = 100;

    const Outcome outcome = made.run();

    EXPECT_EQ(outcome.verdict, Verdict::kLimit);
    EXPECT_FALSE(outcome.failure) << "nothing was ever given up";
    ASSERT_TRUE(outcome.standing);
    EXPECT_EQ(outcome.standing->steps.size(), 1U);
    EXPECT_GE(outcome.standing->open_tasks.size(), 98U);
    EXPECT_EQ(made.store.to_text(outcome.standing->open_tasks.front()), "(go)");
  }
}

TEST(SearchCut, TellsTheFurthestDeadEndToo) {
  Case made(does("(go)", "((!a) (!never))") + does("(go)", "((turn))") +
                does("(turn)", "((turn))") + adds("(!a)", "") +
                "(:operator (!never) ((wanted)) () ())",
            "", "((go))");
  made.options.explain_failure = true;
  made.options.limits.expansions = 100;

  const Outcome outcome = made.run();

  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->attempts.at(0).condition, "(wanted)");
  EXPECT_EQ(outcome.standing->steps.size(), 0U);
}

TEST(SearchBound, IsNamedWhereItLeftNoPlan) {
  Case made(adds("(!a)", "", "7"), "", "((!a))");
  made.options.cost_limit = 5;
  const Outcome bounded = made.run();
  EXPECT_EQ(bounded.verdict, Verdict::kNoPlan);
  EXPECT_EQ(bounded.why, "none costs 5.0 or less");

  Case other("(:operator (!a) ((never)) () ())", "", "((!a))");
  other.options.cost_limit = 5;
  EXPECT_EQ(other.run().why, "") << "the bound is not why";
}

TEST(SearchAll, CountsTheRepeatsItLeavesOut) {
  Case made(adds("(!a)", ""), "", "((:unordered (!a) (!a)))");
  made.options.which = Which::kAll;

  const Outcome outcome = made.run();

  EXPECT_EQ(outcome.plans.size(), 1U);
  EXPECT_EQ(outcome.repeats_left_out, 1U);
}

// ---- states
// ---------------------------------------------------------------------------------------

TEST(SearchStates, AreWhatEachStepChanges) {
  Case made(
      "(:operator (!go ?a ?b) ((at ?a)) ((at ?a) (gone)) ((at ?b) (here))) (:operator (!stay ?a) "
      "((at ?a)) ((at ?a)) ((at ?a)))",
      "(at a) (here)", "((!go a b) (!stay b))");
  made.options.states = true;

  const Outcome outcome = made.run();

  ASSERT_EQ(outcome.plans.size(), 1U);
  const std::vector<StateChange>& changes = outcome.plans[0].changes;
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].deleted, std::vector<Term>{made.term("(at a)")});
  EXPECT_EQ(changes[0].added, std::vector<Term>{made.term("(at b)")});
  EXPECT_TRUE(changes[1].deleted.empty());
  EXPECT_TRUE(changes[1].added.empty());
}

// ---- traces
// ---------------------------------------------------------------------------------------

TEST(SearchTrace, SaysWhatWasBoundAndWhatFailed) {
  Case made(
      "(:method (go ?x) ((way ?x ?y) (open ?y)) ((!a ?x ?y)) ((way ?x ?y)) ((!a ?x ?y))) "
      "(:method (go ?x) named () ()) (:operator (!a ?x ?y) ((free ?y)) () ())",
      "(way a b) (way a c)", "((go a))");
  std::vector<std::string> told;
  made.host.trace = [&](const TraceEvent& event) {
    told.push_back(event.label + " | " + event.detail);
  };
  const Outcome traced = made.run();

  const std::vector<std::string> expected = {" | ",
                                             "method 1, branch 1 | needs (open b)",
                                             "method 1, branch 2 | ?x = a, ?y = b; ?x = a, ?y = c",
                                             "go-2 | (!a a b)",
                                             " | ",
                                             " | its precondition does not hold: it needs (free b)",
                                             "go-2 | (!a a c)",
                                             " | ",
                                             " | its precondition does not hold: it needs (free c)",
                                             "named | ?x = a",
                                             "named | (!!inop)"};
  EXPECT_EQ(std::vector<std::string>(told.begin(), told.begin() + 11), expected);
  made.host.trace = nullptr;
  EXPECT_EQ(made.run().statistics.inferences, traced.statistics.inferences);
}

}  // namespace
}  // namespace skein::htn
