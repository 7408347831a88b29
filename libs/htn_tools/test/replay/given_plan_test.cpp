// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/given_plan.hpp"

#include <gtest/gtest.h>

namespace skein::htn {
namespace {

struct Read {
  TermStore store;
  Diagnostics errors;
  std::vector<GivenPlan> plans;
  explicit Read(const std::string& text) { plans = read_plans("plan", text, store, errors); }
  std::string step(std::size_t at) { return store.to_text(plans.at(0).steps.at(at).action); }
};

TEST(GivenPlan, ReadsStepsWithCostsOfTheTextForm) {
  Read read("; found yesterday\n(!A (b \"C\") 0.5 -3) 2\n\n(!b)\n");

  ASSERT_TRUE(read.errors.empty()) << to_text(read.errors);
  ASSERT_EQ(read.plans.at(0).steps.size(), 2U);
  EXPECT_EQ(read.step(0), "(!a (b \"C\") 0.5 -3)");
  EXPECT_EQ(read.plans[0].steps[0].line, 2);
  EXPECT_EQ(read.plans[0].steps[0].cost, integer(2));
  EXPECT_FALSE(read.plans[0].steps[1].cost.has_value());
}

TEST(GivenPlan, ReadsJsonWithCostsListsAndStrings) {
  Read read(R"({"problem":"P","result":"plan","plans":[{"cost":1.5,)"
            R"("steps":[["!a","b",["c",1,null],"\"Text\"","1/3",["x",".","y"]]],"costs":[1.5]}]})");

  ASSERT_TRUE(read.errors.empty()) << to_text(read.errors);
  EXPECT_EQ(read.plans.at(0).problem, "P");
  EXPECT_EQ(read.step(0), "(!a b (c 1 nil) \"Text\" 1/3 (x . y))");
  EXPECT_EQ(read.plans[0].steps[0].cost, real(1.5));
  EXPECT_EQ(read.plans[0].cost, real(1.5));
}

TEST(GivenPlan, ReadsOneObjectALineAndEveryPlanOfIt) {
  Read read(
      "{\"problem\":\"p\",\"plans\":[{\"steps\":[]},{\"steps\":[[\"!a\"]]}]}\n"
      "{\"problem\":\"q\",\"result\":\"no-plan\",\"plans\":[]}\n"
      "{\"problem\":\"r\",\"plans\":[{\"steps\":[[\"!b\"]]}]}\n");

  ASSERT_EQ(read.plans.size(), 3U);
  EXPECT_EQ(read.plans[2].problem, "r");
  EXPECT_EQ(read.plans[2].steps[0].line, 3);
}

TEST(GivenPlan, ReadsTheTree) {
  Read read(R"({"plans":[{"steps":[["!a"]],"tree":[{"kind":"ordered","children":[1]},)"
            R"({"kind":"step","task":["!a"],"step":0}]}]})");

  const std::vector<GivenNode>& tree = read.plans.at(0).tree;
  ASSERT_EQ(tree.size(), 2U);
  EXPECT_EQ(tree[0].children, std::vector<TreeIndex>{1});
  EXPECT_EQ(tree[1].kind, TreeNodeKind::kStep);
  EXPECT_EQ(tree[1].step, 0U);
}

TEST(GivenPlan, ReportsWhatIsNoPlan) {
  EXPECT_FALSE(Read("{\"plans\":7}").errors.empty());
  EXPECT_FALSE(Read("{\"plans\":[{\"steps\":[5]}]}").errors.empty());
  EXPECT_FALSE(Read("{nonsense").errors.empty());
  EXPECT_FALSE(Read("hello").errors.empty());
  EXPECT_FALSE(Read("(!a").errors.empty());
  EXPECT_FALSE(Read("{\"plans\":[{\"steps\":[],\"tree\":[{\"kind\":\"odd\"}]}]}").errors.empty());
}

TEST(GivenPlan, SurvivesDeepNesting) {
  const std::string many(100'000, '(');
  const std::string brackets(100'000, '[');

  EXPECT_FALSE(Read("(!a " + many + std::string(100'000, ')') + ")").errors.empty());
  EXPECT_FALSE(
      Read("{\"plans\":[{\"steps\":[[\"!a\"," + brackets + std::string(100'000, ']') + "]]}]}")
          .errors.empty());
}

}  // namespace
}  // namespace skein::htn
