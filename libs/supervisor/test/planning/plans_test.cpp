// SPDX-License-Identifier: Apache-2.0
// Plans made one after another are those that each request gives by itself.
#include "planning/plans.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/planned.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using namespace std::string_literals;
using testing::flying;
using testing::PlanningLab;

/// Requests of one job: they share knowledge and world.
PlanningRequest with_tasks(const PlanningRequest& base, std::vector<mission::HighLevelTask> tasks) {
  PlanningRequest request = base;
  request.tasks = std::move(tasks);
  return request;
}

mission::HighLevelTask perceive(std::uint64_t id, const std::string& place) {
  return {mission::GoalId(id), "perceive", {place, 30.0}, {}};
}

TEST(Plans, AreThoseThatEachRequestGivesByItself) {
  PlanningLab lab = flying();
  lab.vehicle(testing::vehicle_of("scenarios/comets/models/karma.yaml"));
  const PlanningRequest base = lab.request();
  const mission::HighLevelTask mapping{mission::GoalId(3), "perform-mapping", {"Z2"s}, {}};
  PlanningRequest elsewhere = with_tasks(base, {perceive(1, "P1"), mapping});
  elsewhere.situation.position += world::Vector3(60, 0, 0);
  PlanningRequest later = elsewhere;
  later.situation.origin = MissionTime::seconds(100);
  PlanningRequest in_flight = elsewhere;
  in_flight.situation.flies_on = true;
  Plans plans;

  for (const PlanningRequest& request :
       {with_tasks(base, {perceive(1, "P1"), perceive(2, "P2"), mapping}),
        with_tasks(base, {mapping, perceive(2, "P2"), perceive(1, "P1")}),
        with_tasks(base, {perceive(1, "nowhere")}), elsewhere, later, in_flight,
        with_tasks(base, {perceive(2, "P2"), mapping, perceive(1, "P1")})})
    EXPECT_EQ(plans.plan(request), plan_tasks(request));
}

TEST(Plans, AreTheSameWhateverJobsCameBefore) {
  PlanningLab lab = flying();
  const PlanningRequest base = lab.request();
  PlanningRequest later = with_tasks(base, {perceive(3, "P2")});
  later.situation.origin = MissionTime::seconds(100);
  PlanningLab other_domain = flying();
  other_domain.domain("(defdomain other ())");
  Plans plans;

  for (const PlanningRequest& request :
       {with_tasks(base, {perceive(1, "P1")}), later, with_tasks(other_domain.request(), {}),
        with_tasks(base, {perceive(1, "nowhere")}), with_tasks(base, {perceive(1, "P1")})}) {
    EXPECT_EQ(plans.plan(request), plan_tasks(request));
    plans.end_job();
  }
}

TEST(Plans, OfANewJobAskTheRefinersAgain) {
  const PlanningRequest request = with_tasks(flying().request(), {perceive(1, "P1")});
  Plans plans;
  PlanningEffort first, second;
  ASSERT_TRUE(plans.plan(request, &first));
  plans.end_job();

  ASSERT_TRUE(plans.plan(request, &second));

  EXPECT_GT(first.refinements, 0U);
  EXPECT_EQ(second, first);
}

TEST(Plans, ReadNoDomainAndAskNoRefinerAgainForWhatIsKnown) {
  const PlanningRequest base = flying().request();
  Plans plans;
  PlanningEffort first, second;
  ASSERT_TRUE(plans.plan(with_tasks(base, {perceive(1, "P1"), perceive(2, "P2")}), &first));

  ASSERT_TRUE(plans.plan(with_tasks(base, {perceive(7, "P1"), perceive(8, "P2")}), &second));

  EXPECT_GT(first.refinements, 0U);
  EXPECT_EQ(second.refinements, 0U);
  EXPECT_EQ(second.expansions, first.expansions);
}

TEST(Plans, OfWhatWasRefusedBeforeAreRefusedWithTheSameWords) {
  PlanningLab lab = flying();
  const world::Vector3 p1 = lab.world.places.at("P1");
  lab.world.volumes.push_back({"smoke",
                               {{p1.x() - 300, p1.y() - 300},
                                {p1.x() + 300, p1.y() - 300},
                                {p1.x() + 300, p1.y() + 300},
                                {p1.x() - 300, p1.y() + 300}},
                               0,
                               500,
                               {}});
  lab.flying_at(p1 + world::Vector3(500, 0, 40));
  const PlanningRequest base = lab.request();
  Plans plans;
  const auto first = plans.plan(with_tasks(base, {perceive(1, "P1")}));

  const auto again = plans.plan(with_tasks(base, {perceive(2, "P1")}));

  ASSERT_FALSE(first);
  ASSERT_FALSE(again);
  EXPECT_FALSE(first.error().reasons.empty());
  EXPECT_EQ(again.error().reasons, first.error().reasons);
  EXPECT_EQ(again.error().culprit, mission::GoalId(2));
}

}  // namespace
}  // namespace skein::supervisor
