// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/deliberator.hpp"

#include "testing/core_harness.hpp"
#include "testing/planning_lab.hpp"

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

/// A mission of places to look at, asked for in the world of the seeds.
InsertionRequest looks_at(const testing::PlanningLab& lab, const std::vector<std::string>& places) {
  InsertionRequest request;
  request.base = lab.request();
  std::uint64_t id = 700;
  for (const std::string& place : places)
    request.added.push_back({mission::GoalId(++id), "perceive", {place, 30.0}, {}});
  return request;
}

// A restarted node does its jobs again, and tells each as often as before that there is time left.
TEST(Deliberator, AsksForTheTimeAsOftenWhateverJobsCameBefore) {
  testing::PlanningLab lab;
  lab.flying_at({0, 0, 40}).first_id(1);
  const std::vector<InsertionRequest> jobs = {looks_at(lab, {"P1"}), looks_at(lab, {"P2", "P1"}),
                                              looks_at(lab, {"nowhere"}),
                                              looks_at(lab, {"P1", "P2"})};
  Deliberator used;

  for (const InsertionRequest& job : jobs) {
    std::uint64_t asked_fresh = 0, asked_used = 0;
    const auto fresh = deliberate(job, [&] { return ++asked_fresh == 0; });
    const auto again = used.deliberate(job, [&] { return ++asked_used == 0; });

    EXPECT_EQ(std::get<InsertionOutcome>(again).plan, std::get<InsertionOutcome>(fresh).plan);
    EXPECT_EQ(std::get<InsertionOutcome>(again).reasons, std::get<InsertionOutcome>(fresh).reasons);
    EXPECT_EQ(asked_used, asked_fresh);
  }
}

}  // namespace
}  // namespace skein::supervisor
