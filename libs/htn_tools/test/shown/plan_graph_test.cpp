// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/plan_graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "testing/sample_plan.hpp"

namespace skein::htn {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_plans::PlanBuilder;
using testing_plans::swap_plan;

TEST(PlanGraph, DrawsTasksWithTheirBranchAndNumberedSteps) {
  TermStore store;

  const std::string dot = to_dot(swap_plan(store), store, {true, "swap"});

  EXPECT_THAT(dot, HasSubstr("digraph plan {"));
  EXPECT_THAT(dot, HasSubstr("label=\"swap\""));
  EXPECT_THAT(dot, HasSubstr("n1 [label=\"(swap banjo kiwi)\\nhas-first\""));
  EXPECT_THAT(dot, HasSubstr("s2 [label=\"3  (!pickup kiwi)\""));
  EXPECT_THAT(dot, HasSubstr("n1 -> s0;"));
}

TEST(PlanGraph, KeepsStepsInTheOrderOfExecution) {
  TermStore store;

  EXPECT_THAT(to_dot(swap_plan(store), store, {}), HasSubstr("s0 -> s1 -> s2"));
}

TEST(PlanGraph, DrawsEachCausalLinkFromMakerToUser) {
  TermStore store;

  const std::string dot = to_dot(swap_plan(store), store, {});

  EXPECT_THAT(dot, HasSubstr("f0 [label=\"(free hand)\""));
  EXPECT_THAT(dot, HasSubstr("s0:e -> f0:w [style=dashed"));
  EXPECT_THAT(dot, HasSubstr("s2:e -> f0:w [dir=back, style=dashed"));
  EXPECT_THAT(dot, Not(HasSubstr("(have banjo)")));  // held from the start
}

TEST(PlanGraph, DrawsWhatATaskNeededFromTheStepThatMadeIt) {
  TermStore store;
  Plan plan = swap_plan(store);
  plan.tree[1].support.push_back({testing_plans::term("(free hand)", store), 0});

  EXPECT_THAT(to_dot(plan, store, {}), HasSubstr("s0 -> n1 [style=dashed"));
}

TEST(PlanGraph, JoinsTheFactsThatOneStepMadeForTheSameSteps) {
  TermStore store;
  PlanBuilder builder(store);
  builder.step("(!a)", integer(1));
  builder.step("(!b)", integer(1));
  const TreeIndex root = builder.network(TreeNodeKind::kOrdered);
  builder.leaf(0, root);
  const TreeIndex user = builder.leaf(1, root);
  builder.needs(user, "(p)", 0);
  builder.needs(user, "(q)", 0);

  EXPECT_THAT(to_dot(builder.plan(), store, {}), HasSubstr("label=\"(p)\\n(q)\""));
}

TEST(PlanGraph, LeavesInternalStepsOutWhenAsked) {
  TermStore store;

  const std::string dot = to_dot(swap_plan(store), store, {.internal = false, .title = ""});

  EXPECT_THAT(dot, Not(HasSubstr("note")));
  EXPECT_THAT(dot, HasSubstr("s2 [label=\"2  (!pickup kiwi)\""));
  EXPECT_THAT(dot, HasSubstr("s0 -> s2"));
}

TEST(PlanGraph, DrawsTheStepsAloneOfAPlanWithoutTree) {
  TermStore store;
  Plan plan = swap_plan(store);
  plan.tree.clear();

  const std::string dot = to_dot(plan, store, {});

  EXPECT_THAT(dot, HasSubstr("s0 [label=\"1  (!drop banjo)\""));
  EXPECT_THAT(dot, Not(HasSubstr("n0")));
}

TEST(PlanGraph, EscapesQuotesAndShortensLongLabels) {
  TermStore store;
  PlanBuilder builder(store);
  builder.step("(!say \"he said \\\"é\\\"\")", integer(1));
  builder.step("(!say " + std::string(100, 'x') + ")", integer(1));
  const TreeIndex root = builder.network(TreeNodeKind::kOrdered);
  builder.leaf(0, root);
  builder.leaf(1, root);

  const std::string dot = to_dot(builder.plan(), store, {});

  EXPECT_THAT(dot, HasSubstr(R"(1  (!say \"he said \\\"é\\\"\"))"));
  EXPECT_THAT(dot, HasSubstr("xxx…\""));
  EXPECT_THAT(dot, HasSubstr("tooltip=\"(!say " + std::string(100, 'x')));
}

TEST(PlanGraph, IsTheSameEachTime) {
  TermStore store;
  const Plan plan = swap_plan(store);

  EXPECT_EQ(to_dot(plan, store, {}), to_dot(plan, store, {}));
}

}  // namespace
}  // namespace skein::htn
