// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/deliberation.hpp"

#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words

PlanningRequest with_a_domain_that_says_nothing() {
  const Config config = config_for_tests();
  PlanningRequest request;
  request.knowledge = config.knowledge;
  request.world = config.world;
  return request;
}

TEST(Deliberate, AnswersAnInsertionWithAnInsertion) {
  InsertionRequest request;
  request.base = with_a_domain_that_says_nothing();
  request.added = goals_of({701});

  const DeliberationResult result = deliberate(request);

  ASSERT_TRUE(std::holds_alternative<InsertionOutcome>(result));
  EXPECT_FALSE(std::get<InsertionOutcome>(result).plan.has_value());
  EXPECT_FALSE(std::get<InsertionOutcome>(result).reasons.empty());
}

TEST(Deliberate, AnswersARepairWithARepair) {
  RepairRequest request;
  request.base = with_a_domain_that_says_nothing();
  request.remaining = goals_of({701});

  const DeliberationResult result = deliberate(request);

  ASSERT_TRUE(std::holds_alternative<RepairOutcome>(result));
  EXPECT_EQ(std::get<RepairOutcome>(result).served, RepairStep::kFail);
}

}  // namespace
}  // namespace skein::supervisor
