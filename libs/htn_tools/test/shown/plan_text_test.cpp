// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/plan_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/sample_plan.hpp"

namespace skein::htn {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_plans::PlanBuilder;
using testing_plans::swap_plan;

TEST(StepsText, NumbersStepsAndAlignsTheirCosts) {
  TermStore store;
  const Plan plan = swap_plan(store);

  EXPECT_EQ(steps_text(plan, store, {}),
            "  1  (!drop banjo)     1\n"
            "  2  (!!note banjo)    0\n"
            "  3  (!pickup kiwi)  2.5\n");
}

TEST(StepsText, NumbersAnewWithoutInternalSteps) {
  TermStore store;
  const Plan plan = swap_plan(store);

  EXPECT_EQ(steps_text(plan, store, {.internal = false}),
            "  1  (!drop banjo)     1\n"
            "  2  (!pickup kiwi)  2.5\n");
}

TEST(StepsText, DoesNotPushAllCostsAsideForOneLongStep) {
  TermStore store;
  PlanBuilder builder(store);
  builder.step("(!a)", integer(1));
  builder.step("(!b " + std::string(200, 'x') + ")", integer(22));

  const std::string text = steps_text(builder.plan(), store, {});

  EXPECT_THAT(text, HasSubstr("(!a)" + std::string(56, ' ') + "   1\n"));
  EXPECT_THAT(text, HasSubstr("x)  22\n"));
}

TEST(StepsText, AlignsByCharactersAndNotByBytes) {
  TermStore store;
  PlanBuilder builder(store);
  builder.step("(!fly lousã)", integer(1));
  builder.step("(!fly lousa)", integer(2));

  EXPECT_EQ(steps_text(builder.plan(), store, {}),
            "  1  (!fly lousã)  1\n"
            "  2  (!fly lousa)  2\n");
}

TEST(StepsText, IsEmptyForAPlanWithoutSteps) {
  TermStore store;

  EXPECT_EQ(steps_text(Plan{}, store, {}), "");
  EXPECT_EQ(tree_text(Plan{}, store, {}), "");
}

TEST(TreeText, ShowsTasksWithTheirBranchAndStepsWithWhatTheyNeeded) {
  TermStore store;
  const Plan plan = swap_plan(store);

  EXPECT_EQ(tree_text(plan, store, {}),
            "(swap banjo kiwi)  has-first\n"
            "├─ 1 (!drop banjo)  cost 1\n"
            "├─ 2 (!!note banjo)  cost 0\n"
            "└─ 3 (!pickup kiwi)  cost 2.5\n"
            "      ← (free hand) from 1 !drop\n"
            "      ← (noted banjo) from 2 !!note\n");
}

TEST(TreeText, LeavesInternalStepsOutButNotWhatTheyMade) {
  TermStore store;
  const Plan plan = swap_plan(store);

  EXPECT_EQ(tree_text(plan, store, {.internal = false}),
            "(swap banjo kiwi)  has-first\n"
            "├─ 1 (!drop banjo)  cost 1\n"
            "└─ 2 (!pickup kiwi)  cost 2.5\n"
            "      ← (free hand) from 1 !drop\n"
            "      ← (noted banjo) from !!note\n");
}

TEST(TreeText, ShowsNetworksThatSaySomething) {
  TermStore store;
  PlanBuilder builder(store);
  for (const char* action : {"(!a)", "(!b)", "(!c)"}) builder.step(action, integer(1));
  const TreeIndex root = builder.network(TreeNodeKind::kUnordered);
  const TreeIndex pair = builder.network(TreeNodeKind::kOrdered, root);
  builder.leaf(0, pair);
  builder.leaf(2, pair);
  const TreeIndex task = builder.task("(t)", "m", root);
  const TreeIndex single = builder.network(TreeNodeKind::kUnordered, task);
  builder.leaf(1, single);

  EXPECT_EQ(tree_text(builder.plan(), store, {}),
            ":unordered\n"
            "├─ :ordered\n"
            "│  ├─ 1 (!a)  cost 1\n"
            "│  └─ 3 (!c)  cost 1\n"
            "└─ (t)  m\n"
            "   └─ 2 (!b)  cost 1\n");
}

TEST(TreeText, MarksForATerminalAndOnlyThen) {
  TermStore store;
  const Plan plan = swap_plan(store);

  EXPECT_THAT(tree_text(plan, store, {}), Not(HasSubstr("\033")));
  EXPECT_THAT(tree_text(plan, store, {true, kTerminalText}), HasSubstr("\033[2mhas-first\033[0m"));
  EXPECT_THAT(steps_text(plan, store, {true, kTerminalText}), HasSubstr("\033[2m1\033[0m"));
}

// A chain of tasks, each the only child of the one before.
Plan chain(TermStore& store, int length) {
  PlanBuilder builder(store);
  builder.step("(!end)", integer(1));
  TreeIndex above = kNoParent;
  for (int level = 0; level < length; ++level) above = builder.task("(down)", "m", above);
  builder.leaf(0, above);
  return builder.plan();
}

TEST(TreeText, SaysHowManyLevelsOfGuidesItLeavesOut) {
  TermStore store;

  const std::string text = tree_text(chain(store, 50), store, {});

  EXPECT_THAT(text, HasSubstr("[+9] " + std::string(3 * 40, ' ') + "└─ 1 (!end)"));
}

TEST(TreeText, StaysLinearHoweverDeepTheTree) {
  TermStore store;
  constexpr int kDepth = 200'000;

  const std::string text = tree_text(chain(store, kDepth), store, {});

  EXPECT_LT(text.size(), std::size_t{kDepth} * 200);
}

}  // namespace
}  // namespace skein::htn
