// SPDX-License-Identifier: Apache-2.0
// What a search takes from an earlier plan: steps that were executed, choices that are preferred;
// and hosts that offer less than is asked of them.
#include <gtest/gtest.h>

#include "testing/planner_case.hpp"

namespace skein::htn {
namespace {

using test::adds;
using test::Case;
using test::does;
using Plans = std::vector<std::string>;

// ---- executed steps --------------------------------------------------------------------------

const char* const kGuard =
    "(:operator (!guard) () () ((:protection (p))))"
    "(:operator (!drop) () ((p)) ())"
    "(:operator (!need ?x) ((has ?x)) () ((used ?x)))"
    "(:operator (!dear) () () () 9223372036854775807)";

/// What is found behind a past: "step" an action, "+fact" or "-fact" a change from outside.
std::string behind(const std::string& facts, const std::vector<std::string>& past,
                   const std::string& tasks) {
  Case made(kGuard, facts, tasks);
  Problem problem = made.problem();
  for (const std::string& event : past) {
    const auto kind = event[0] == '+'   ? Event::Kind::kAdded
                      : event[0] == '-' ? Event::Kind::kDeleted
                                        : Event::Kind::kStep;
    const std::string term = kind == Event::Kind::kStep ? event : event.substr(1);
    problem.past.push_back({kind, made.term(term)});
  }
  const Outcome outcome = plan(made.domain(), problem, made.options);
  return outcome.verdict == Verdict::kPlan    ? made.steps(outcome.plans.front())
         : outcome.verdict == Verdict::kError ? "error: " + outcome.why
                                              : "no plan";
}

TEST(SearchPast, PlansBeginWithWhatWasExecuted) {
  EXPECT_EQ(behind("(has a)", {"(!need a)"}, "((!need a))"), "(!need a) (!need a)");
  EXPECT_EQ(behind("", {"+(has a)"}, "((!need a))"), "(!need a)");
  EXPECT_EQ(behind("(has a)", {"-(has a)"}, "((!need a))"), "no plan");
}

TEST(SearchPast, AStepThatCannotHaveBeenExecutedEndsTheSearchWithItsReason) {
  const auto reason = [](const std::string& step, const std::string& why) {
    return "error: the step " + step + ", said to be executed, does not apply: " + why;
  };

  EXPECT_EQ(behind("", {"(!need a)"}, "()"), reason("(!need a)", "its precondition does not hold"));
  EXPECT_EQ(behind("", {"(!need)"}, "()"), reason("(!need)", "the task does not match its head"));
  EXPECT_EQ(behind("", {"(!unheard-of)"}, "()"), reason("(!unheard-of)", "no such operator"));
  EXPECT_EQ(behind("(p)", {"(!guard)", "(!drop)"}, "()"),
            reason("(!drop)", "it would violate a protection"));
  EXPECT_EQ(behind("", {"(!guard)"}, "()"),
            reason("(!guard)", "it would protect what does not hold"));
}

TEST(SearchPast, WhatAnExecutedStepProtectsStaysProtected) {
  EXPECT_EQ(behind("(p)", {"(!guard)"}, "((!drop))"), "no plan");
  EXPECT_EQ(behind("(p)", {"+(q)", "(!guard)", "+(r)"}, "((!drop))"), "no plan");
}

TEST(SearchPast, WhatTheWorldMadeFalseIsProtectedNoLonger) {
  EXPECT_EQ(behind("(p)", {"(!guard)", "-(p)", "+(p)"}, "((!drop))"), "no plan")
      << "it was made true again before anybody acted";
  EXPECT_EQ(behind("(p)", {"(!guard)", "(!guard)", "-(p)", "(!dear)", "+(p)"}, "((!drop))"),
            "(!guard) (!guard) (!dear) (!drop)")
      << "however often it was protected";
  EXPECT_EQ(behind("(p)", {"(!guard)", "-(p)"}, "((!drop))"), "(!guard) (!drop)");
}

TEST(SearchPast, CostsOfExecutedStepsCount) {
  EXPECT_EQ(behind("", {"(!dear)"}, "((!dear))"),
            "error: the cost of the plan: the result is an integer beyond 64 bits");
}

TEST(SearchPast, VariablesOfExecutedStepsAreBoundByTheirPreconditions) {
  Case made(kGuard, "(has a) (has b)", "()");
  Problem problem = made.problem();
  const std::array<Term, 2> free{made.store.symbol("!need"), Term(TermKind::kLocal, 0)};
  problem.past = {{Event::Kind::kStep, made.store.list(free)}};

  const Outcome outcome = plan(made.domain(), problem, made.options);

  ASSERT_EQ(outcome.plans.size(), 1U);
  EXPECT_EQ(made.steps(outcome.plans.front()), "(!need b)") << "the newest fact, as a search would";
}

// ---- preferred choices -----------------------------------------------------------------------

TEST(SearchPreferred, TheTaskThatCameEarlierIsTakenEarlier) {
  Case made(adds("(!a)", "") + adds("(!b)", "") + adds("(!c)", ""), "",
            "(:unordered (!a) (!b) (!c))");
  made.options.preferences = {{made.term("(!c)"), "", {}, 0}, {made.term("(!b)"), "", {}, 1}};

  EXPECT_EQ(made.first(), "(!c) (!b) (!a)");
  EXPECT_EQ(made.all().size(), 6U) << "every order is still there";
}

TEST(SearchPreferred, EachPreferenceServesOnce) {
  const std::string ways =
      does("(go)", "((!a))") + does("(go)", "((!b))") + adds("(!a)", "") + adds("(!b)", "");
  const std::string labelled = "(:method (go) left () ((!a)))(:method (go) right () ((!b)))" +
                               adds("(!a)", "") + adds("(!b)", "");
  Case made(labelled, "", "((go) (go) (go))");
  made.options.preferences = {{made.term("(go)"), "right", {made.term("(!b)")}},
                              {made.term("(go)"), "left", {made.term("(!a)")}}};

  EXPECT_EQ(made.first(), "(!b) (!a) (!a)");
  EXPECT_EQ(Case(ways, "", "((go) (go) (go))").first(), "(!a) (!a) (!a)");
}

TEST(SearchPreferred, ATaskThatIsNotYetBoundTakesThatOfAnInstance) {
  const std::string items =
      "(:method (pick ?x) ((p ?x)) ((!pick ?x)))" + adds("(!pick ?x)", "(picked ?x)");
  Case made(items, "(p a) (p b) (p c)", "((pick ?x))");
  ASSERT_EQ(made.first(), "(!pick a)");
  Case again(items, "(p a) (p b) (p c)", "((pick ?x))");
  again.options.preferences = {{again.term("(pick b)"), "pick-1", {again.term("(!pick b)")}}};

  EXPECT_EQ(again.first(), "(!pick b)");
  EXPECT_EQ(again.all(), (Plans{"(!pick b)", "(!pick a)", "(!pick c)"}));
}

TEST(SearchPreferred, AnInstanceOfAnotherTaskIsNone) {
  const std::string items =
      "(:method (pick ?x ?n) ((p ?x)) ((!pick ?x)))" + adds("(!pick ?x)", "(picked ?x)");
  Case made(items, "(p a) (p b)", "((pick ?x 1))");
  made.options.preferences = {{made.term("(pick b 2)"), "pick-1", {made.term("(!pick b)")}},
                              {made.term("(other b 1)"), "pick-1", {made.term("(!pick b)")}}};

  EXPECT_EQ(made.first(), "(!pick a)");
}

TEST(SearchPreferred, AReductionIsPreferredOnlyWithAllItsSubtasks) {
  const std::string items =
      "(:method (go) ((p ?x)) ((!a ?x) (!b ?x)))" + adds("(!a ?x)", "") + adds("(!b ?x)", "");
  const auto first_with = [&](const std::vector<std::string>& subtasks) {
    Case made(items, "(p 1) (p 2)", "((go))");
    std::vector<Term> terms;
    for (const std::string& task : subtasks) terms.push_back(made.term(task));
    made.options.preferences = {{made.term("(go)"), "go-1", terms}};
    return made.first();
  };

  EXPECT_EQ(first_with({"(!a 2)", "(!b 2)"}), "(!a 2) (!b 2)");
  EXPECT_EQ(first_with({"(!a 2)"}), "(!a 1) (!b 1)");
  EXPECT_EQ(first_with({"(!a 2)", "(!b 2)", "(!c)"}), "(!a 1) (!b 1)");
  EXPECT_EQ(first_with({"(!b 2)", "(!a 2)"}), "(!a 1) (!b 1)");
}

// ---- hosts and problems ----------------------------------------------------------------------

const std::string kTurningOn =
    does("(turn ?n)", "((!turn) (turn (s ?n)))") + adds("(!turn)", "", "0");

TEST(SearchHost, WithoutAClockThereIsNoLimitOfTime) {
  Case made(kTurningOn, "", "((turn z))");
  made.options.limits.seconds = 0;
  made.options.limits.expansions = 100'000;

  EXPECT_EQ(made.first(), "limit: expansions");
}

TEST(SearchHost, TheLimitOfTimeIsPassedWhereItIsExceededOnly) {
  const auto after = [](double seconds) {
    Case made(kTurningOn, "", "((turn z))");
    made.options.limits.seconds = 2;
    made.options.limits.expansions = 100'000;
    int asked = 0;
    made.host.cpu_seconds = [&asked, seconds] { return asked++ == 0 ? 10 : 10 + seconds; };
    return made.first();
  };

  EXPECT_EQ(after(2), "limit: expansions");
  EXPECT_EQ(after(2.001), "limit: time");
}

TEST(SearchProblem, ATaskMustBeAListWithItsName) {
  Case made(adds("(!a)", ""), "", "((!a))");
  Problem problem = made.problem();
  problem.tasks = {NetworkKind::kTask, {}, made.store.symbol("go"), false};

  const Outcome outcome = plan(made.domain(), problem, made.options);

  EXPECT_EQ(outcome.verdict, Verdict::kError);
  EXPECT_EQ(outcome.why, "a task must be a list that begins with its name, not go");
}

}  // namespace
}  // namespace skein::htn
