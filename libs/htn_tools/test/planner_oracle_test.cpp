// SPDX-License-Identifier: Apache-2.0
// The planner against a brute-force planner and the validator, on random domains.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "skein/htn/planner.hpp"
#include "skein/htn_tools/validator.hpp"
#include "test_cases.hpp"
#include "testing/brute_force_planner.hpp"
#include "testing/brute_force_prover.hpp"
#include "testing/random_domain.hpp"

namespace skein::htn {
namespace {

constexpr std::uint64_t kDepth = 14;

std::uint64_t case_count() { return testing::cases<std::uint64_t>(20, 3'000); }

/// A random domain with its problem, compiled.
class Case {
 public:
  explicit Case(std::uint64_t seed) : text_(oracle::random_domain(seed)) {
    Diagnostics errors;
    Diagnostics warnings;
    read_definitions(
        {"random.lisp", text_}, store_,
        [](const std::string&, const std::string&) { return failure("none"); }, definitions_,
        errors, warnings);
    EXPECT_TRUE(errors.empty()) << to_text(errors) << text_;
    domain_ =
        Domain::compile(definitions_.domains.at(0), definitions_.functions, host_, store_, errors);
    EXPECT_NE(domain_, nullptr) << to_text(errors) << text_;
    problem_ = make_problem(definitions_.problems.at(0), store_);
  }

  oracle::OracleOutcome expected(std::uint64_t depth = kDepth, bool first_only = false) {
    oracle::OracleLimits limits;
    limits.depth = depth;
    limits.first_only = first_only;
    return oracle::brute_force(definitions_.domains[0], definitions_.functions,
                               definitions_.problems[0], store_, limits);
  }
  Outcome planned(Which which, bool trees = false) {
    Options options;
    options.which = which;
    options.limits.depth = kDepth;
    options.trees = trees;
    return plan(*domain_, problem_, options);
  }
  Outcome planned(const Options& options) { return plan(*domain_, problem_, options); }
  std::vector<std::string> steps(const Plan& plan) {
    std::vector<std::string> out;
    for (const Step& step : plan.steps) out.push_back(oracle::plain_text(store_, step.action));
    return out;
  }
  std::vector<std::vector<std::string>> all_steps(const Outcome& outcome) {
    std::vector<std::vector<std::string>> out;
    for (const Plan& plan : outcome.plans) out.push_back(steps(plan));
    return out;
  }
  Validation validate(const Plan& plan) {
    Diagnostics errors;
    const Validator validator(definitions_.domains[0], definitions_.functions, host_, store_,
                              errors);
    GivenPlan given;
    given.cost = plan.cost;
    for (const Step& step : plan.steps) given.steps.push_back({step.action, step.cost, 0});
    for (const TreeNode& node : plan.tree) {
      given.tree.push_back({node.kind, node.children, node.task, node.method, node.step});
    }
    return validator.validate(definitions_.problems[0], given);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  TermStore store_;
  Definitions definitions_;
  Functions host_;
  std::shared_ptr<Domain> domain_;
  Problem problem_;
};

std::vector<std::vector<std::string>> all_steps(const oracle::OracleOutcome& outcome) {
  std::vector<std::vector<std::string>> out;
  for (const oracle::OraclePlan& plan : outcome.plans) out.push_back(plan.steps);
  return out;
}

/// Calls `check(case, expected)` for the cases about which the oracle can say something.
template <class Check>
void for_random_cases(std::uint64_t first_seed, const Check& check) {
  for (std::uint64_t seed = first_seed; seed < first_seed + case_count(); ++seed) {
    Case one(seed);
    const oracle::OracleOutcome expected = one.expected();
    if (expected.out_of_budget) continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + one.text());
    check(one, expected);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(PlannerOracle, AllFindsThePlansOfTheOracleInItsOrder) {
  for_random_cases(0, [](Case& one, const oracle::OracleOutcome& expected) {
    const Outcome outcome = one.planned(Which::kAll);

    ASSERT_EQ(outcome.verdict == Verdict::kError, expected.error.has_value())
        << outcome.why << expected.error.value_or("");
    if (expected.error) return;
    EXPECT_EQ(one.all_steps(outcome), all_steps(expected));
    EXPECT_EQ(outcome.statistics.expansions, expected.expansions);
    for (std::size_t at = 0; at < outcome.plans.size(); ++at) {
      EXPECT_NEAR(to_double(outcome.plans[at].cost), expected.plans[at].cost, 1e-9);
    }
  });
}

TEST(PlannerOracle, FirstFindsTheFirstPlanOfTheOracle) {
  for_random_cases(10'000'000, [](Case& one, const oracle::OracleOutcome&) {
    const oracle::OracleOutcome expected = one.expected(kDepth, true);
    const Outcome outcome = one.planned(Which::kFirst);

    if (expected.error) return;
    EXPECT_EQ(one.all_steps(outcome), all_steps(expected));
    EXPECT_EQ(outcome.statistics.expansions, expected.expansions);
  });
}

TEST(PlannerOracle, EveryPlanFoundValidatesWithItsTree) {
  for_random_cases(0, [](Case& one, const oracle::OracleOutcome& expected) {
    if (expected.error) return;
    const Outcome outcome = one.planned(Which::kAll, true);

    for (std::size_t at = 0; at < std::min<std::size_t>(outcome.plans.size(), 10); ++at) {
      const Validation validation = one.validate(outcome.plans[at]);
      EXPECT_FALSE(validation.fault.has_value()) << at << ": " << to_text(validation);
      EXPECT_EQ(validation.steps, outcome.plans[at].steps.size());
    }
  });
}

TEST(PlannerOracle, BestHasTheLeastCostOfAll) {
  for_random_cases(20'000'000, [](Case& one, const oracle::OracleOutcome& expected) {
    if (expected.error || expected.plans.empty()) return;
    const Outcome best = one.planned(Which::kBest);

    ASSERT_FALSE(best.plans.empty());
    const auto least = std::min_element(
        expected.plans.begin(), expected.plans.end(),
        [](const auto& left, const auto& right) { return left.cost < right.cost; });
    EXPECT_NEAR(to_double(best.plans[0].cost), least->cost, 1e-9);
  });
}

TEST(PlannerOracle, ShallowestAndIterativeDeepeningFindPlansOfLeastDepth) {
  for_random_cases(30'000'000, [](Case& one, const oracle::OracleOutcome& expected) {
    if (expected.error || expected.plans.empty()) return;
    std::uint64_t least = kDepth;
    for (const oracle::OraclePlan& plan : expected.plans) least = std::min(least, plan.depth);
    std::vector<std::vector<std::string>> shallow;
    for (const oracle::OraclePlan& plan : expected.plans) {
      if (plan.depth == least) shallow.push_back(plan.steps);
    }
    std::sort(shallow.begin(), shallow.end());

    for (const Which which : {Which::kShallowest, Which::kIdFirst}) {
      const Outcome outcome = one.planned(which);
      ASSERT_EQ(outcome.plans.size(), 1U);
      EXPECT_TRUE(std::binary_search(shallow.begin(), shallow.end(), one.steps(outcome.plans[0])));
    }
    auto all = one.all_steps(one.planned(Which::kAllShallowest));
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, shallow);
    EXPECT_EQ(one.planned(Which::kIdAll).plans.size(), expected.plans.size());
  });
}

TEST(PlannerOracle, LimitsHoldAndTheSameRunGivesTheSameOutcome) {
  for_random_cases(40'000'000, [](Case& one, const oracle::OracleOutcome& expected) {
    if (expected.error) return;
    Options options;
    options.which = Which::kAll;
    options.limits.depth = kDepth;
    options.limits.expansions = 20;
    options.limits.plans = 2;
    const Outcome once = one.planned(options);
    const Outcome again = one.planned(options);

    EXPECT_LE(once.plans.size(), 2U);
    EXPECT_LE(once.statistics.expansions, 21U);  // the one that meets the limit is counted
    EXPECT_EQ(one.all_steps(once), one.all_steps(again));
    EXPECT_EQ(once.statistics.inferences, again.statistics.inferences);
    for (std::size_t at = 0; at < once.plans.size(); ++at) {
      EXPECT_EQ(one.steps(once.plans[at]), expected.plans.at(at).steps);
    }
  });
}

}  // namespace
}  // namespace skein::htn
