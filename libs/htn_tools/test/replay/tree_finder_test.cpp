// SPDX-License-Identifier: Apache-2.0
// Whether steps accomplish tasks, found without their tree: whatever the planner finds is found
// again from its steps alone, and what is no plan is not.
#include "skein/htn_tools/tree_finder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "skein/htn_tools/plan_json.hpp"
#include "skein/htn_tools/validator.hpp"
#include "test_cases.hpp"
#include "testing/random_domain.hpp"

namespace skein::htn {
namespace {

constexpr std::uint64_t kDepth = 14;
constexpr std::size_t kMostPlans = 20;

class TreeFinder : public ::testing::Test {
 protected:
  void read(const std::string& text) {
    Diagnostics warnings;
    read_definitions(
        {"test.lisp", text}, store_, [](const auto&, const auto&) { return failure("none"); },
        definitions_, errors_, warnings);
    ASSERT_TRUE(errors_.empty()) << to_text(errors_);
    domain_ =
        Domain::compile(definitions_.domains.at(0), definitions_.functions, host_, store_, errors_);
    ASSERT_NE(domain_, nullptr) << to_text(errors_);
    problem_ = make_problem(definitions_.problems.at(0), store_);
  }

  Outcome all_plans() {
    Options options;
    options.which = Which::kAll;
    options.limits.depth = kDepth;
    options.limits.plans = kMostPlans;
    return plan(*domain_, problem_, options);
  }

  /// As a file has it: without tree, numbers of unknown precision.
  GivenPlan given(const Plan& plan) {
    Outcome outcome;
    outcome.verdict = Verdict::kPlan;
    outcome.plans = {plan};
    const std::string text = to_json({"p", "d", 0, 0, 0}, outcome, store_, {});
    return read_plans("plan", text, store_, errors_).at(0);
  }

  FoundTree found(const GivenPlan& plan) {
    Limits limits;
    limits.depth = kDepth;
    return find_tree(*domain_, problem_, plan, limits);
  }

  Validation validated(const GivenPlan& plan) {
    const Validator validator(definitions_.domains.at(0), definitions_.functions, host_, store_,
                              errors_);
    return validator.validate(definitions_.problems.at(0), plan);
  }

  std::string text(const Plan& plan) const {
    std::string out;
    for (const Step& step : plan.steps) out += store_.to_text(step.action) + ' ';
    return out;
  }

  TermStore store_;
  Functions host_;
  Definitions definitions_;
  Diagnostics errors_;
  std::shared_ptr<Domain> domain_;
  Problem problem_;
};

class RandomTrees : public TreeFinder, public ::testing::WithParamInterface<std::uint64_t> {};

TEST_P(RandomTrees, AreFoundForEveryPlanAndForNothingElse) {
  read(oracle::random_domain(GetParam()));
  const Outcome outcome = all_plans();
  if (outcome.verdict == Verdict::kError) return;
  const bool all_known = outcome.verdict == Verdict::kPlan && outcome.plans.size() < kMostPlans;
  std::set<std::string> plans;
  for (const Plan& plan : outcome.plans) plans.insert(text(plan));

  for (const Plan& plan : outcome.plans) {
    const FoundTree tree = found(given(plan));

    ASSERT_EQ(tree.verdict, Verdict::kPlan) << text(plan);
    EXPECT_FALSE(tree.plan.tree.empty());
    EXPECT_TRUE(validated(tree.plan).tree_checked) << to_text(validated(tree.plan));
    if (plan.steps.empty() || !all_known) continue;
    Plan shorter = plan;
    shorter.steps.pop_back();
    if (!plans.contains(text(shorter))) {
      EXPECT_NE(found(given(shorter)).verdict, Verdict::kPlan) << text(shorter);
    }
    Plan longer = plan;
    longer.steps.push_back(plan.steps.back());
    if (!plans.contains(text(longer))) {
      EXPECT_NE(found(given(longer)).verdict, Verdict::kPlan) << text(longer);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomTrees,
                         ::testing::Range(std::uint64_t{1},
                                          testing::cases<std::uint64_t>(60, 2'000)));

TEST_F(TreeFinder, TakesTheBranchThatLeadsToTheSteps) {
  read(
      "(defdomain d ((:operator (!a ?x) () () ()) (:method (go) ((at ?x)) ((!a ?x)))))"
      "(defproblem p d ((at 1) (at 2) (at 0.5)) ((go)))");

  const auto steps = [this](const std::string& text) {
    return read_plans("plan", text, store_, errors_).at(0);
  };

  EXPECT_EQ(found(steps("(!a 1)")).verdict, Verdict::kPlan);
  EXPECT_EQ(found(steps("(!a 0.5)")).verdict, Verdict::kPlan);
  EXPECT_EQ(found(steps("(!a 3)")).verdict, Verdict::kNoPlan);
  EXPECT_EQ(found(steps("(!a 1) (!a 2)")).verdict, Verdict::kNoPlan);
}

}  // namespace
}  // namespace skein::htn
