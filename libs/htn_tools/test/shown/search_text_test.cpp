// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/search_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/sample_plan.hpp"

namespace skein::htn {
namespace {

using testing::HasSubstr;
using testing_plans::swap_plan;
using testing_plans::term;

TEST(TraceText, IndentsByDepthAndSaysWhatHappened) {
  TermStore store;
  const auto line = [&](TraceKind kind, std::uint64_t depth, const std::string& label = "",
                        std::uint64_t count = 0, const std::string& detail = "") {
    TraceEvent event;
    event.kind = kind;
    event.depth = depth;
    event.task = term("(fly karma)", store);
    event.label = label;
    event.count = count;
    event.detail = detail;
    return to_text(event, store, kPlainText);
  };

  EXPECT_EQ(line(TraceKind::kTask, 0), "    0 (fly karma)\n");
  EXPECT_EQ(line(TraceKind::kBranchFails, 1, "stay"), "    1     ✗ stay does not hold\n");
  EXPECT_EQ(line(TraceKind::kBranchHolds, 1, "tour", 1), "    1     ✓ tour holds, 1 reduction\n");
  EXPECT_EQ(line(TraceKind::kReduction, 1, "tour"), "    1     → tour\n");
  EXPECT_EQ(line(TraceKind::kStep, 2, "", 0, "7"), "    2       ● (fly karma): 7\n");
  EXPECT_EQ(line(TraceKind::kStepFails, 2, "", 0, "no precondition"),
            "    2       ✗ (fly karma) does not apply: no precondition\n");
  EXPECT_EQ(line(TraceKind::kBacktrack, 0), "    0   ↩ (fly karma): no way left\n");
}

TEST(TraceText, StopsIndentingSomewhere) {
  TermStore store;
  TraceEvent event;
  event.depth = 1'000'000;

  EXPECT_LT(to_text(event, store, kPlainText).size(), 100U);
}

FailurePoint failure_of(TermStore& store) {
  FailurePoint failure;
  failure.steps = swap_plan(store).steps;
  failure.open_tasks = {term("(mission)", store), term("(go b)", store)};
  failure.attempts.push_back({term("(go b)", store),
                              "direct",
                              "(road a b)",
                              {term("(road a c)", store), term("(road c b)", store)}});
  return failure;
}

TEST(FailureText, TellsStepsOpenTasksAndWhatEachAttemptLacked) {
  TermStore store;

  EXPECT_EQ(to_text(failure_of(store), store, kPlainText),
            "  The search came furthest after 3 steps:\n"
            "    1 (!drop banjo)\n"
            "    2 (!!note banjo)\n"
            "    3 (!pickup kiwi)\n"
            "  Open there, from the top:\n"
            "    (mission)\n"
            "      (go b)\n"
            "  Tried there, and why not:\n"
            "    ✗ (go b), direct: needs (road a b)\n"
            "      nearest facts: (road a c) (road c b)\n");
}

TEST(FailureText, ShowsTheLastStepsOnlyAndAFewFacts) {
  TermStore store;
  FailurePoint failure = failure_of(store);
  const Step step = failure.steps.front();
  failure.steps.assign(25, step);
  failure.attempts[0].nearest.assign(9, term("(road x y)", store));

  const std::string text = to_text(failure, store, kPlainText);

  EXPECT_THAT(text, HasSubstr("… 15 steps before\n    16 (!drop banjo)\n"));
  EXPECT_THAT(text, HasSubstr("(road x y) … and 4\n"));
}

TEST(FailureText, SaysWhenNothingWasThereToTry) {
  TermStore store;

  EXPECT_EQ(to_text(FailurePoint{}, store, kPlainText),
            "  The search came furthest after 0 steps.\n"
            "  No operator and no method was there to try.\n");
}

TEST(StandingText, ShortensTheTasksAndNamesTheRecursion) {
  TermStore store;
  FailurePoint point;
  point.open_tasks.assign(1, term("(go)", store));
  point.open_tasks.insert(point.open_tasks.end(), 499, term("(turn left)", store));

  const std::string text = standing_text(point, store, kPlainText);

  EXPECT_THAT(text, HasSubstr("  The search was cut after 0 steps.\n  Open there, from the top:\n"
                              "    (go)\n      (turn left)\n"));
  EXPECT_THAT(text, HasSubstr("    … 480 tasks more\n"));
  EXPECT_THAT(text, HasSubstr("  (turn …) is open 499 times inside itself"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 24);
}

}  // namespace
}  // namespace skein::htn
