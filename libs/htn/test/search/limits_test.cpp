// SPDX-License-Identifier: Apache-2.0
// Where a search gives up, how it is cancelled, and how long plans may be.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "testing/planner_case.hpp"

namespace skein::htn {
namespace {

using test::adds;
using test::Case;
using test::does;

/// Turns for ever, without any condition to prove.
const std::string kTurning = does("(turn)", "((!turn) (turn))") + adds("(!turn)", "", "0");

TEST(SearchLimits, StopAfterSoManyExpansions) {
  Case made(kTurning, "", "((turn))");
  made.options.limits.expansions = 5'000;

  const Outcome outcome = made.run();

  EXPECT_EQ(outcome.verdict, Verdict::kLimit);
  EXPECT_EQ(outcome.why, "expansions");
  EXPECT_EQ(outcome.statistics.expansions, 5'001U);
  EXPECT_TRUE(outcome.plans.empty());
}

TEST(SearchLimits, StopBelowACertainDepth) {
  Case made(kTurning, "", "((turn))");
  made.options.limits.depth = 100;

  const Outcome outcome = made.run();

  EXPECT_EQ(outcome.verdict, Verdict::kLimit);
  EXPECT_EQ(outcome.why, "depth");
  EXPECT_EQ(outcome.statistics.deepest, 100U);
}

TEST(SearchLimits, StopDeepeningBelowACertainDepthToo) {
  Case made(kTurning, "", "((turn))");
  made.options.limits.depth = 50;
  made.options.which = Which::kIdFirst;

  EXPECT_EQ(made.first(), "limit: depth");
}

TEST(SearchLimits, FindPlansAboveTheDepthTheyForbid) {
  Case made(does("(turn)", "((!turn) (turn))") + does("(turn)", "((!end))") +
                adds("(!turn)", "", "0") + adds("(!end)", ""),
            "", "((turn))");
  made.options.limits.depth = 4;

  EXPECT_EQ(made.first(), "(!turn) (!end)");
}

TEST(SearchLimits, StopInsideOnePrecondition) {
  std::string facts;
  for (int at = 0; at < 50; ++at) facts += "(n " + std::to_string(at) + ")";
  Case made("(:method (go) ((n ?a) (n ?b) (n ?c) (n ?d) (n ?e) (never ?a ?b ?c ?d ?e)) ((!x)))" +
                adds("(!x)", ""),
            facts, "((go))");
  made.options.limits.inferences = 100'000;

  const Outcome outcome = made.run();

  EXPECT_EQ(outcome.verdict, Verdict::kLimit);
  EXPECT_EQ(outcome.why, "inferences");
  EXPECT_EQ(outcome.statistics.inferences, 100'001U);
  EXPECT_EQ(outcome.statistics.expansions, 1U);
}

TEST(SearchLimits, StopByTheClockAlsoWhereNoConditionIsProved) {
  double now = 50;
  Case made(kTurning, "", "((turn))");
  made.options.limits.seconds = 3;
  made.host.cpu_seconds = [&now] { return now += 0.5; };

  EXPECT_EQ(made.first(), "limit: time");
  EXPECT_LT(now, 56);
}

TEST(SearchLimits, StopWhenTheSearchTakesTooMuchMemory) {
  Case made(does("(grow ?x)", "((!grow) (grow (s ?x)))") + adds("(!grow)", "", "0"), "",
            "((grow z))");
  made.options.limits.memory_bytes = 8'000'000;

  const Outcome outcome = made.run();

  EXPECT_EQ(outcome.why, "memory");
  EXPECT_GT(outcome.statistics.memory_bytes, 8'000'000U);
  EXPECT_LT(outcome.statistics.memory_bytes, 40'000'000U);
}

// With the default limit of memory one such proof took 18 GB.
TEST(SearchLimits, StopAxiomsThatLeadToThemselvesWithoutEnd) {
  for (const std::string axiom :
       {"(:- (deep ?x) ((deep (s ?x))))", "(:- (deep ?x) ((deep ?x) (never)))",
        "(:- (deep ?x) ((not (deep ?x))))", "(:- (deep ?x) ((deep ?x)) ((deep (s ?x))))",
        "(:- (deep ?x) ((wide ?x))) (:- (wide ?x) ((deep (s ?x)) (deep ?x)))"}) {
    Case made("(:method (go) ((deep z)) ((!x)))" + adds("(!x)", "") + axiom, "", "((go))");

    const Outcome outcome = made.run();

    EXPECT_EQ(outcome.verdict, Verdict::kLimit) << axiom;
    EXPECT_NE(outcome.why.find("lead to themselves"), std::string::npos) << axiom << outcome.why;
    EXPECT_LT(outcome.statistics.memory_bytes, 1'000'000'000U) << axiom;
  }
}

// As deep as the state goes: no proof that ends is anywhere near the bound.
TEST(SearchLimits, LetAxiomsFollowALongChainOfFacts) {
  std::string facts = "(end n100000)";
  for (int at = 0; at < 100'000; ++at)
    facts += "(next n" + std::to_string(at) + " n" + std::to_string(at + 1) + ")";
  Case made("(:method (go) ((leads n0)) ((!x)))" + adds("(!x)", "") +
                "(:- (leads ?x) ((end ?x)) ((next ?x ?y) (leads ?y)))",
            facts, "((go))");

  EXPECT_EQ(made.first(), "(!x)");
}

TEST(SearchLimits, LeaveTheBestPlanFoundSoFar) {
  for (const Which which : {Which::kBest, Which::kAll, Which::kShallowest}) {
    Case made(does("(go)", "((!end))") + does("(go)", "((turn))") + kTurning + adds("(!end)", ""),
              "", "((go))");
    made.options.which = which;
    made.options.limits.expansions = 1'000;
    const Outcome outcome = made.run();

    const bool endless = which != Which::kShallowest;  // nothing shallower is there to look for
    EXPECT_EQ(outcome.verdict, endless ? Verdict::kLimit : Verdict::kPlan);
    ASSERT_EQ(outcome.plans.size(), 1U);
    EXPECT_EQ(made.steps(outcome.plans.front()), "(!end)");
  }
}

TEST(SearchLimits, LetTheHostCancelFromAnotherThread) {
  Case made(kTurning, "", "((turn))");
  std::atomic<bool> begun{false};
  std::atomic<bool> cancelled{false};
  made.host.cancelled = [&] {
    begun = true;
    return cancelled.load();
  };
  std::thread other([&] {
    while (!begun) std::this_thread::yield();
    cancelled = true;
  });

  EXPECT_EQ(made.first(), "limit: cancelled");
  other.join();
}

TEST(SearchLimits, AllowAnotherSearchAfterOneThatWasCut) {
  Case made(does("(go)", "((turn))") + does("(go)", "((!end))") + kTurning + adds("(!end)", ""), "",
            "((go))");
  made.options.limits.expansions = 100;
  ASSERT_EQ(made.first(), "limit: expansions");

  made.options.limits.expansions.reset();
  made.options.which = Which::kIdFirst;

  EXPECT_EQ(made.first(), "(!end)");
}

// ---- length and depth ------------------------------------------------------------------------

constexpr std::size_t kLong = 60'000;

Outcome counted(const std::string& tasks, bool trees = false) {
  Case made("(:method (count ?n) done ((eval (= ?n 0))) () more ((assign ?m (- ?n 1))) " + tasks +
                ")" + adds("(!tick)", ""),
            "", "((count " + std::to_string(kLong) + "))");
  made.options.trees = trees;
  return made.run();
}

TEST(SearchLength, IsBoundByMemoryOnly) {
  const Outcome outcome = counted("((!tick) (count ?m))");

  ASSERT_EQ(outcome.verdict, Verdict::kPlan) << outcome.why;
  EXPECT_EQ(outcome.plans.front().steps.size(), kLong);
  EXPECT_EQ(to_double(outcome.plans.front().cost), static_cast<double>(kLong));
}

TEST(SearchLength, MayComeFromRecursionOnTheLeft) {
  const Outcome outcome = counted("((count ?m) (!tick))");

  ASSERT_EQ(outcome.verdict, Verdict::kPlan) << outcome.why;
  EXPECT_EQ(outcome.plans.front().steps.size(), kLong);
}

TEST(SearchLength, MayComeWithItsTree) {
  const Outcome outcome = counted("((count ?m) (!tick))", true);

  ASSERT_EQ(outcome.verdict, Verdict::kPlan) << outcome.why;
  EXPECT_GT(outcome.plans.front().tree.size(), 2 * kLong);
}

TEST(SearchLength, MayHaveAChoiceOpenAtEveryStep) {
  Case made(
      "(:method (count ?n) done ((eval (= ?n 0))) () more ((assign ?m (- ?n 1)) (way ?w)) "
      "((!tick ?w) (count ?m)))" +
          adds("(!tick ?w)", "(ticked ?w)"),
      "(way a) (way b)", "((count 50000))");

  const Outcome outcome = made.run();

  ASSERT_EQ(outcome.verdict, Verdict::kPlan) << outcome.why;
  EXPECT_EQ(outcome.plans.front().steps.size(), 50'000U);
}

}  // namespace
}  // namespace skein::htn
