// SPDX-License-Identifier: Apache-2.0
// What a search tells besides the steps: trees, causal links, traces, reasons of failure; and the
// preferences it is given.
#include <gtest/gtest.h>

#include <algorithm>

#include "testing/planner_case.hpp"

namespace skein::htn {
namespace {

using test::adds;
using test::Case;
using test::does;

// ---- trees -----------------------------------------------------------------------------------

const char* const kDelivery =
    "(:method (deliver ?p ?b) ship ((at ?p ?a))"
    " ((!load ?p ?a) (:unordered (!fly ?b) (!!note ?p)) (!unload ?p ?b)))"
    "(:operator (!load ?p ?a) ((at ?p ?a)) ((at ?p ?a)) ((in ?p)))"
    "(:operator (!fly ?b) () () ((uav ?b)))"
    "(:operator (!!note ?p) () () ((noted ?p)))"
    "(:operator (!unload ?p ?b) ((in ?p) (uav ?b) (not (at ?p x))) ((in ?p)) ((at ?p ?b)))";

/// The tree indented, one node a line, with what supports it.
std::string shown(const Case& made, const Plan& plan, TreeIndex node = 0, int depth = 0) {
  const TreeNode& here = plan.tree[node];
  std::string out(static_cast<std::size_t>(depth), ' ');
  switch (here.kind) {
    case TreeNodeKind::kOrdered:
      out += "ordered";
      break;
    case TreeNodeKind::kUnordered:
      out += "unordered";
      break;
    case TreeNodeKind::kTask:
      out += made.store.to_text(here.task) + " by " + here.method;
      break;
    case TreeNodeKind::kStep:
      out += std::to_string(here.step) + ": " + made.store.to_text(here.task);
      break;
  }
  for (const CausalLink& link : here.support) {
    out += " <" + made.store.to_text(link.fact) + " ";
    out += link.step == kInitialState ? "start>" : std::to_string(link.step) + ">";
  }
  out += "\n";
  for (const TreeIndex child : here.children) {
    EXPECT_EQ(plan.tree[child].parent, node);
    out += shown(made, plan, child, depth + 1);
  }
  return out;
}

std::string tree(Case& made) {
  made.options.trees = true;
  const Outcome outcome = made.run();
  if (outcome.plans.empty()) return "no plan: " + outcome.why;
  EXPECT_EQ(outcome.plans.front().tree.front().parent, kNoParent);
  return shown(made, outcome.plans.front());
}

TEST(SearchTree, ShowsTheDecompositionWithWhatEachPartRestsOn) {
  Case made(kDelivery, "(at x1 a) (at x a)", "((deliver x1 b))");

  EXPECT_EQ(tree(made),
            "ordered\n"
            " (deliver x1 b) by ship <(at x1 a) start>\n"
            "  ordered\n"
            "   0: (!load x1 a) <(at x1 a) start>\n"
            "   unordered\n"
            "    1: (!fly b)\n"
            "    2: (!!note x1)\n"
            "   3: (!unload x1 b) <(in x1) 0> <(uav b) 1>\n");
}

TEST(SearchTree, IsEmptyUnlessAskedFor) {
  Case made(kDelivery, "(at x1 a)", "((deliver x1 b))");

  EXPECT_TRUE(made.run().plans.front().tree.empty());
}

TEST(SearchTree, LinksWhatMustNotHoldToTheStepThatDeletedIt) {
  Case made("(:operator (!clear) () ((blocked a)) ()) (:operator (!go) ((not (blocked a))) () ())",
            "(blocked a)", "((!clear) (!go))");

  EXPECT_EQ(tree(made), "ordered\n 0: (!clear)\n 1: (!go) <(not (blocked a)) 0>\n");
}

TEST(SearchTree, LinksThroughQuantifiersAndCollections) {
  for (const char* const condition :
       {"(exists (?x) ((kind ?x)) ((made ?x)))", "(forall (?x) ((kind ?x)) ((made ?x)))",
        "(setof ?x (made ?x) ?all)"}) {
    Case made(std::string("(:operator (!make) () () ((made a))) (:operator (!use) (") + condition +
                  ") () ())",
              "(kind a)", "((!make) (!use))");

    EXPECT_EQ(tree(made), "ordered\n 0: (!make)\n 1: (!use) <(made a) 0>\n") << condition;
  }
}

TEST(SearchTree, LinksThroughAxiomsToTheFactsBehindThem) {
  Case made(
      "(:- (ready ?u) ((fuel ?u) (crew ?u))) (:operator (!fuel ?u) () () ((fuel ?u)))"
      "(:operator (!go ?u) ((ready ?u)) () ())",
      "(crew k)", "((!fuel k) (!go k))");

  EXPECT_EQ(tree(made), "ordered\n 0: (!fuel k)\n 1: (!go k) <(fuel k) 0> <(crew k) start>\n");
}

TEST(SearchTree, LinksToTheLastStepThatMadeAFactTrue) {
  Case made(
      "(:operator (!fuel) () () ((fuel))) (:operator (!burn) () ((fuel)) ())"
      "(:operator (!go) ((fuel)) () ())",
      "(fuel)", "((!go) (!burn) (!fuel) (!go))");

  EXPECT_EQ(tree(made),
            "ordered\n 0: (!go) <(fuel) start>\n 1: (!burn)\n 2: (!fuel)\n"
            " 3: (!go) <(fuel) 2>\n");
}

TEST(SearchTree, LeavesOutTheStepsThatDoNothing) {
  Case made(does("(rest)", "()") + adds("(!a)", ""), "", "((rest) (!a))");

  EXPECT_EQ(tree(made), "ordered\n (rest) by rest-1\n 0: (!a)\n")
      << "the label is made of the method's name";
}

TEST(SearchTree, BindsWhatBecameKnownLater) {
  Case made("(:method (go ?x) way () ((!pick ?x)))(:operator (!pick ?x) ((p ?x)) () ())", "(p a)",
            "((go ?y))");

  EXPECT_EQ(tree(made), "ordered\n (go a) by way\n  ordered\n   0: (!pick a) <(p a) start>\n");
}

TEST(SearchTree, IsTheSameWithAndWithoutBacktracking) {
  const std::string fails =
      "(:method (go) wrong ((q ?x)) ((!go ?x) (!never)))"
      "(:operator (!never) ((never)) () ())";
  const std::string works =
      "(:method (go) right ((p ?x)) ((!go ?x)))" + adds("(!go ?x)", "(went ?x)");
  Case once(works, "(p a) (q b)", "((go))");
  Case twice(fails + works, "(p a) (q b)", "((go))");

  EXPECT_EQ(tree(twice), tree(once));
}

// ---- traces ----------------------------------------------------------------------------------

std::vector<std::string> trace(Case& made) {
  std::vector<std::string> events;
  made.host.trace = [&](const TraceEvent& event) {
    static const char* const kNames[] = {"task", "fails", "holds",    "try",
                                         "step", "stuck", "backtrack"};
    std::string text = kNames[static_cast<std::size_t>(event.kind)];
    text += " " + made.store.to_text(event.task);
    if (!event.label.empty()) text += " " + event.label;
    if (event.count > 0) text += " " + std::to_string(event.count);
    if (!event.detail.empty()) text += ": " + event.detail;
    events.push_back(text);
  };
  made.run();
  return events;
}

const char* const kTraced =
    "(:method (go) fly ((fuel)) ((!fly)) walk ((way ?w)) ((!walk ?w)))"
    "(:operator (!walk ?w) ((dry ?w)) () () 2)";

TEST(SearchTrace, TellsWhyMethodsWereTriedFailedAndChosen) {
  Case made(kTraced, "(way a) (way b) (dry b)", "((go))");

  EXPECT_EQ(trace(made),
            (std::vector<std::string>{
                "task (go)", "fails (go) fly: needs (fuel)", "holds (go) walk 2: ?w = a; ?w = b",
                "try (go) walk: (!walk a)", "task (!walk a)",
                "stuck (!walk a): its precondition does not hold: it needs (dry a)",
                "try (go) walk: (!walk b)", "task (!walk b)", "step (!walk b): 2"}));
}

TEST(SearchTrace, TellsOfTheTasksAskedForOnly) {
  Case made(kTraced, "(way a)", "((go))");
  made.options.traced_tasks = {"!WALK"};

  EXPECT_EQ(trace(made), (std::vector<std::string>{
                             "task (!walk a)",
                             "stuck (!walk a): its precondition does not hold: it needs (dry a)"}));
}

TEST(SearchTrace, TellsWhenAllWaysOfATaskAreExhausted) {
  Case made(kTraced, "", "((go) (!none))");
  Case unknown("", "", "((!none))");

  EXPECT_EQ(trace(made),
            (std::vector<std::string>{"task (go)", "fails (go) fly: needs (fuel)",
                                      "fails (go) walk: needs (way ?w)", "backtrack (go)"}));
  EXPECT_EQ(trace(unknown),
            (std::vector<std::string>{"task (!none)", "stuck (!none): no such operator"}));
}

// ---- why not ---------------------------------------------------------------------------------

FailurePoint failure(Case& made) {
  made.options.explain_failure = true;
  const Outcome outcome = made.run();
  EXPECT_EQ(outcome.verdict, Verdict::kNoPlan);
  EXPECT_TRUE(outcome.failure.has_value());
  return outcome.failure.value_or(FailurePoint{});
}

TEST(SearchFailure, IsWhereTheSearchCameFurthest) {
  Case made(does("(go)", "((!one) (land))") + does("(go)", "((!stop))") + adds("(!one)", "(one)") +
                "(:method (land) strip ((free ?s) (long ?s)) ((!land ?s)))"
                "(:operator (!stop) ((never)) () ())" +
                adds("(!land ?s)", ""),
            "(free s1) (free s2) (long s3)", "((go))");

  const FailurePoint point = failure(made);

  ASSERT_EQ(point.steps.size(), 1U);
  EXPECT_EQ(made.store.to_text(point.steps[0].action), "(!one)");
  EXPECT_EQ(point.open_tasks, (std::vector<Term>{made.term("(go)"), made.term("(land)")}));
  ASSERT_EQ(point.attempts.size(), 1U);
  EXPECT_EQ(point.attempts[0].label, "strip");
  EXPECT_EQ(point.attempts[0].condition, "(long s1)");
  EXPECT_EQ(point.attempts[0].nearest, (std::vector<Term>{made.term("(long s3)")}));
}

TEST(SearchFailure, NamesTheNearestFactsFirst) {
  Case made("(:operator (!go ?u) ((at ?u p1 high)) () ())",
            "(at k p2 low) (at k p1 low) (at m p1 high) (at k p2 high) (at m p2 low)", "((!go k))");

  const FailurePoint point = failure(made);

  ASSERT_EQ(point.attempts.size(), 1U);
  EXPECT_EQ(point.attempts[0].condition, "(at k p1 high)");
  ASSERT_EQ(point.attempts[0].nearest.size(), 3U);
  for (const Term fact : point.attempts[0].nearest) {
    EXPECT_NE(fact, made.term("(at m p2 low)"));
    EXPECT_NE(fact, made.term("(at k p2 low)"));
  }
}

TEST(SearchFailure, TellsOfEveryBranchThatMightHaveDoneIt) {
  Case made(
      "(:method (go) fly ((fuel)) ((!x)) walk ((eval (> 1 2))) ((!x)))"
      "(:method (go) swim ((not (dry))) ((!x)))" +
          adds("(!x)", ""),
      "(dry)", "((go))");

  const FailurePoint point = failure(made);

  ASSERT_EQ(point.attempts.size(), 3U);
  EXPECT_EQ(point.attempts[0].condition, "(fuel)");
  EXPECT_EQ(point.attempts[1].condition, "(eval (> 1 2))");
  EXPECT_EQ(point.attempts[2].condition, "(not (dry))");
}

TEST(SearchFailure, SaysThatNothingHasTheName) {
  Case made("", "", "((unheard-of a))");

  const FailurePoint point = failure(made);

  ASSERT_EQ(point.attempts.size(), 1U);
  EXPECT_EQ(point.attempts[0].condition, "no method or operator has this name");
}

TEST(SearchFailure, SaysThatATaskDoesNotMatchItsOperator) {
  Case made(adds("(!go a)", ""), "", "((!go b))");

  const FailurePoint point = failure(made);

  ASSERT_EQ(point.attempts.size(), 1U);
  EXPECT_EQ(point.attempts[0].condition, "the task does not match (!go a)");
}

TEST(SearchFailure, SaysThatAProtectionStoodInTheWay) {
  Case made("(:operator (!guard) () () ((:protection (p)))) (:operator (!drop) () ((p)) ())", "(p)",
            "((!guard) (!drop))");

  const FailurePoint point = failure(made);

  ASSERT_EQ(point.attempts.size(), 1U);
  EXPECT_EQ(point.attempts[0].condition, "it would violate a protection");
}

TEST(SearchFailure, IsExplainedAfterDeepeningToo) {
  for (const Which which : {Which::kIdFirst, Which::kIdAll, Which::kAll, Which::kBest}) {
    Case made(does("(go)", "((!one) (!two))") + adds("(!one)", "(one)") +
                  "(:operator (!two) ((two)) () ())",
              "", "((go))");
    made.options.which = which;

    const FailurePoint point = failure(made);

    EXPECT_EQ(point.steps.size(), 1U);
    ASSERT_EQ(point.attempts.size(), 1U);
    EXPECT_EQ(point.attempts[0].condition, "(two)");
  }
}

TEST(SearchFailure, IsAbsentWhenThereIsAPlan) {
  Case made(adds("(!a)", ""), "", "((!a))");
  made.options.explain_failure = true;

  EXPECT_FALSE(made.run().failure.has_value());
}

// ---- preferences -----------------------------------------------------------------------------

const std::string kChoices =
    "(:method (go) fly () ((!fly)))(:method (go) drive ((road ?r)) ((!drive ?r)))" +
    adds("(!fly)", "") + adds("(!drive ?r)", "");

TEST(SearchPreferences, BringTheMethodOfAnEarlierPlanToTheFront) {
  Case made(kChoices, "(road a) (road b)", "((go))");
  made.options.preferences = {{made.term("(go)"), "drive", {made.term("(!drive b)")}}};

  EXPECT_EQ(made.all(), (std::vector<std::string>{"(!drive b)", "(!drive a)", "(!fly)"}));
}

TEST(SearchPreferences, ChangeNothingWhenTheyNoLongerApply) {
  Case made(kChoices, "(road a)", "((go))");
  made.options.preferences = {{made.term("(go)"), "sail", {}},
                              {made.term("(other)"), "drive", {made.term("(!drive a)")}}};

  EXPECT_EQ(made.all(), (std::vector<std::string>{"(!fly)", "(!drive a)"}));
}

TEST(SearchPreferences, AreOnlyTriedFirst) {
  Case made(kChoices + "(:operator (!check) ((fine)) () ())", "", "((go))");
  made.options.preferences = {{made.term("(go)"), "drive", {made.term("(!drive z)")}}};

  EXPECT_EQ(made.first(), "(!fly)");
}

}  // namespace
}  // namespace skein::htn
