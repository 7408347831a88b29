// SPDX-License-Identifier: Apache-2.0
// Every row of the shared reference.csv: the same result, number of steps, cost and number of plans
// as SHOP3, and step by step the plan that it gave.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>

#include "skein/htn/planner.hpp"
#include "testing/shop_data.hpp"

namespace skein::htn {
namespace {

using shop_data::Row;

// SHOP3 counts in single floats, and its table is written with few digits.
bool same_number(double left, double right) {
  return std::abs(left - right) <= 2e-6 * std::max({1.0, std::abs(left), std::abs(right)});
}

/// The same term; floats may differ by the rounding of single precision.
bool alike(const TermStore& store, Term left, Term right) {
  while (left.is(TermKind::kPair) && right.is(TermKind::kPair)) {
    if (!alike(store, store.car(left), store.car(right))) return false;
    left = store.cdr(left);
    right = store.cdr(right);
  }
  if (left.is(TermKind::kNumber) && right.is(TermKind::kNumber)) {
    return same_number(to_double(store.value(left)), to_double(store.value(right)));
  }
  return left == right;
}

/// The first step that differs, as a sentence; empty for the same plan.
std::string difference(const TermStore& store, const Plan& plan, const GivenPlan& expected) {
  for (std::size_t at = 0; at < std::min(plan.steps.size(), expected.steps.size()); ++at) {
    const GivenStep& wanted = expected.steps[at];
    const Step& step = plan.steps[at];
    const bool cost = !wanted.cost || same_number(to_double(step.cost), to_double(*wanted.cost));
    if (alike(store, step.action, wanted.action) && cost) continue;
    return "step " + std::to_string(at + 1) + ": " + store.to_text(step.action) + ' ' +
           to_text(step.cost) + ", expected " + store.to_text(wanted.action) +
           (wanted.cost ? ' ' + to_text(*wanted.cost) : std::string());
  }
  return plan.steps.size() == expected.steps.size() ? "" : "one plan is longer";
}

/// Rows in which SHOP3 errs: the right answer is that of another row, or that there is no plan.
const std::map<std::string, std::optional<Row>>& corrections() {
  static const Row basic{"toy-basic", "problem1", "first", "2", 2, 1};
  static const std::map<std::string, std::optional<Row>> corrected = {
      // An unbound argument of a call makes a condition fail; it is no crash.
      {"toy-axiom-else testing-check-constraint all", {}},
      // A symbol stands for itself in a Lisp term.
      {"toy-sort p4 first", Row{"toy-sort", "p5", "first", "1", 1, 1}},
      {"toy-sort p4 all", Row{"toy-sort", "p5", "all", "1", 1, 3}},
      // Each round of iterative deepening starts from the initial state.
      {"toy-basic problem1 id-first", basic},
      {"toy-basic problem1 id-all", basic}};
  return corrected;
}

struct Expected {
  Row row;  ///< `steps` is a number or "none"
  bool corrected = false;
};

Expected expected_of(const Row& row) {
  const auto found = corrections().find(row.domain + ' ' + row.problem + ' ' + row.which);
  if (found == corrections().end()) return {row, false};
  if (found->second) return {*found->second, true};
  Row none = row;
  none.steps = "none";
  return {none, true};
}

Options options_of(const std::string& which) {
  static const std::map<std::string, Which> modes = {
      {"first", Which::kFirst},           {"all", Which::kAll},
      {"id-first", Which::kIdFirst},      {"id-all", Which::kIdAll},
      {"shallowest", Which::kShallowest}, {"all-shallowest", Which::kAllShallowest}};
  Options options;
  const std::size_t slash = which.find('/');
  options.which = modes.at(which.substr(0, slash));
  if (slash == std::string::npos) return options;
  const std::string cost = which.substr(slash + 5);  // behind "/opt="
  if (cost == "t") {
    options.optimize_cost = true;
  } else if (cost != "nil") {
    options.cost_limit = std::stod(cost);
  }
  return options;
}

/// What all rows share; the last line says how many were as expected.
class Reference : public testing::TestWithParam<Row> {
 protected:
  static void SetUpTestSuite() { archive_ = std::make_unique<shop_data::Archive>(); }
  static void TearDownTestSuite() {
    std::cout << "reference.csv: " << passed_ << " of " << shop_data::rows().size()
              << " rows as SHOP3, of which " << compared_ << " step by step; " << corrected_
              << " corrected\n";
    archive_.reset();
  }

  static void check(const Outcome& outcome, const Expected& expected, TermStore& store) {
    const Row& row = expected.row;
    if (row.steps == "none") {
      EXPECT_EQ(outcome.verdict, Verdict::kNoPlan) << outcome.why;
      EXPECT_TRUE(outcome.plans.empty());
      return;
    }
    ASSERT_EQ(outcome.verdict, Verdict::kPlan) << outcome.why;
    EXPECT_EQ(outcome.plans.size(), row.plans);
    const Plan& first = outcome.plans.front();
    EXPECT_EQ(first.steps.size(), static_cast<std::size_t>(std::stoi(row.steps)));
    EXPECT_PRED2(same_number, to_double(first.cost), row.cost);
    const std::optional<GivenPlan> archived =
        archive_->plan(row.domain, row.problem, row.which, store);
    if (!archived) return;
    ++compared_;
    EXPECT_EQ(difference(store, first, *archived), "");
  }

  static inline std::unique_ptr<shop_data::Archive> archive_;
  static inline int passed_ = 0;
  static inline int compared_ = 0;
  static inline int corrected_ = 0;
};

TEST_P(Reference, GivesWhatShop3Gave) {
  const Row& row = GetParam();
  const auto loaded = shop_data::load(row.domain, row.problem);
  ASSERT_TRUE(loaded->errors.empty()) << to_text(loaded->errors);
  ASSERT_NE(loaded->problem, nullptr);
  const auto domain =
      Domain::compile(loaded->definitions.domains.front(), loaded->definitions.functions,
                      Functions{}, loaded->store, loaded->errors);
  ASSERT_NE(domain, nullptr) << to_text(loaded->errors);
  const Expected expected = expected_of(row);

  const Outcome outcome =
      plan(*domain, make_problem(*loaded->problem, loaded->store), options_of(row.which));

  check(outcome, expected, loaded->store);
  corrected_ += expected.corrected ? 1 : 0;
  passed_ += HasFailure() ? 0 : 1;
}

std::string test_name(const testing::TestParamInfo<Row>& info) {
  std::string name = info.param.domain + '_' + info.param.problem + '_' + info.param.which;
  for (char& letter : name) {
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  }
  return name;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Reference);
INSTANTIATE_TEST_SUITE_P(Rows, Reference, testing::ValuesIn(shop_data::rows()), test_name);

class ReferenceData : public testing::Test {
 protected:
  void SetUp() override {
    if (!shop_data::rows().empty()) return;
    GTEST_SKIP() << "no reference.csv in " << shop_data::folder()
                 << ": nothing was compared with SHOP3";
  }
};

TEST_F(ReferenceData, IsThere) { EXPECT_GE(shop_data::rows().size(), 150U); }

// Beside the rows that take longest, which are run apart from the others.
TEST_F(ReferenceData, IsThereForLongRows) { EXPECT_GE(shop_data::rows().size(), 150U); }

}  // namespace
}  // namespace skein::htn
