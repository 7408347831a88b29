// SPDX-License-Identifier: Apache-2.0
// Who thinks first: repair before insertion before evaluation; bounds after goals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

mission::UnitMission asked(std::uint64_t id, const std::vector<std::uint64_t>& goals) {
  mission::UnitMission mission = a_mission(id, goals);
  mission.evaluate = true;
  return mission;
}

std::vector<std::uint64_t> stopped(const Desk& desk) {
  std::vector<std::uint64_t> jobs;
  for (const auto& one : desk.of<StopDeliberation>()) jobs.push_back(one.job);
  return jobs;
}

// ---- evaluation ----

TEST(SupervisorEvaluation, SaysWhatAMissionWouldCostAndAdoptsNothing) {
  Desk desk = flying();
  const auto before = desk.supervisor.report();
  desk.add(asked(2, {801}));
  ASSERT_TRUE(desk.job_started());

  InsertionOutcome outcome = inserted(
      {702, 801},
      {TaskOf(200, "goto", 702).energy(0.1), TaskOf(201, "goto", 801).after(200).energy(0.05)});
  outcome.plan->energy = 0.15;
  outcome.plan->cost = 7;
  outcome.schedule = schedule(outcome.plan->tasks, {}, desk.now);
  desk.finish(outcome);

  ASSERT_EQ(desk.of<MissionDecided>().size(), 1U);
  const mission::MissionOutcome answer = desk.of<MissionDecided>()[0].outcome;
  EXPECT_TRUE(answer.evaluated);
  EXPECT_TRUE(answer.planned);
  ASSERT_TRUE(answer.estimate.has_value());
  EXPECT_NEAR(answer.estimate->energy, 0.05, 1e-9) << "beside what is planned already";
  EXPECT_EQ(answer.estimate->earliest_end, desk.now + secs(20));
  EXPECT_EQ(answer.estimate->latest_end, desk.now + secs(40));
  EXPECT_THAT(desk.decisions(), ElementsAre("1 evaluate"));
  EXPECT_EQ(desk.supervisor.report(), before);
  EXPECT_THAT(desk.requests(), IsEmpty());
}

TEST(SupervisorEvaluation, OfWhatCannotBeTakenGivesTheReasons) {
  Desk desk = flying();
  desk.add(asked(2, {801}));

  desk.finish(refused("no way to goal 801"));

  const mission::MissionOutcome answer = desk.of<MissionDecided>()[0].outcome;
  EXPECT_TRUE(answer.evaluated);
  EXPECT_FALSE(answer.planned);
  EXPECT_THAT(answer.reasons, ElementsAre("no way to goal 801"));
  EXPECT_EQ(desk.state_of(801), "unknown");
}

TEST(SupervisorEvaluation, TheSameMissionCanBeSentAfterwards) {
  Desk desk = flying();
  desk.add(asked(2, {801}));
  desk.finish(refused("not now"));

  desk.add(a_mission(2, {801}));

  EXPECT_TRUE(desk.of<Answer>()[0].accepted);
  EXPECT_EQ(desk.state_of(801), "received");
}

// ---- lanes ----

TEST(SupervisorLanes, AnInsertionGivesWayToARepairAndIsBegunAgain) {
  Desk desk = flying();
  desk.add(a_mission(2, {801}));
  const std::uint64_t insertion_job = desk.job_id;

  desk.at(30).aborted(101);

  ASSERT_TRUE(desk.job_started()) << "the repair does not wait";
  EXPECT_TRUE(std::holds_alternative<RepairRequest>(*desk.request));
  EXPECT_THAT(stopped(desk), ElementsAre(insertion_job));
  const std::uint64_t repair_job = desk.job_id;
  desk.give(JobFinished{insertion_job, refused("stopped")});
  EXPECT_THAT(desk.notices(), IsEmpty());
  EXPECT_EQ(desk.state_of(801), "received") << "what a stopped job says counts for nothing";

  desk.give(JobFinished{repair_job,
                        repaired(RepairStep::kRefine, {701, 702},
                                 {TaskOf(300, "goto", 701), TaskOf(301, "goto", 702).after(300)})});

  ASSERT_TRUE(desk.job_started());
  EXPECT_TRUE(std::holds_alternative<InsertionRequest>(*desk.request));
}

TEST(SupervisorLanes, AnEvaluationGivesWayToAMission) {
  Desk desk = flying();
  desk.add(asked(2, {801}));
  const std::uint64_t evaluation = desk.job_id;

  desk.add(a_mission(3, {901}));

  ASSERT_TRUE(desk.job_started());
  EXPECT_THAT(stopped(desk), ElementsAre(evaluation));
  EXPECT_EQ(desk.insertion().added.front().id, GoalId{901});
}

TEST(SupervisorLanes, AMissionThatIsCancelledIsNoLongerThoughtAbout) {
  Desk desk = flying();
  desk.add(a_mission(2, {801}));
  const std::uint64_t insertion = desk.job_id;

  desk.give(CancelMission{{{GoalId{801}}, mission::MissionId{}, true}, "test"});

  EXPECT_THAT(stopped(desk), ElementsAre(insertion));
  EXPECT_EQ(desk.state_of(801), "cancelled");
}

TEST(SupervisorLanes, AMissionThatIsCancelledIsNoLongerWaitedFor) {
  Desk desk = flying();
  desk.add(a_mission(2, {801}));
  const std::uint64_t job = desk.job_id;
  desk.give(CancelMission{{{GoalId{801}}, mission::MissionId{}, true}, "test"});

  desk.add(a_mission(3, {901}));

  ASSERT_TRUE(desk.job_started()) << "at once";
  EXPECT_EQ(desk.insertion().added.front().id, GoalId{901});
  desk.give(JobFinished{job, refused("late")});
  EXPECT_EQ(desk.state_of(901), "received");
}

// ---- bounds after goals ----

mission::UnitMission with_bound(std::uint64_t id, std::uint64_t goal, std::uint64_t other,
                                double most) {
  mission::UnitMission mission = a_mission(id, {goal});
  mission.tasks[0].after.push_back({GoalId{other}, false, Duration(), secs(most)});
  return mission;
}

TEST(SupervisorGoalBounds, AGoalThatNobodyKnowsIsRefused) {
  Desk desk = flying();

  desk.add(with_bound(2, 801, 799, 60));

  ASSERT_FALSE(desk.of<Answer>()[0].accepted);
  EXPECT_THAT(desk.of<Answer>()[0].reasons,
              ElementsAre("high-level task 799, after which 801 is to come, is not known"));
}

TEST(SupervisorGoalBounds, CountFromTheInstantAtWhichTheGoalWasAchieved) {
  Desk desk = flying();
  desk.add(with_bound(2, 801, 701, 60));
  desk.finish(inserted({702, 801},
                       {TaskOf(200, "goto", 702).after(101), TaskOf(201, "goto", 801).after(200)}));
  ASSERT_EQ(desk.state_of(801), "planned");

  desk.at(110).ends(101);

  EXPECT_EQ(desk.state_of(701), "achieved");
  desk.at(120).add(a_mission(3, {901}));
  const auto& bounds = desk.insertion().standing.bounds;
  EXPECT_EQ(bounds.over.at(GoalId{701}), testing::at(110));
}

TEST(SupervisorGoalBounds, AGoalThatComesSomeTimeAfterAnotherHasItsDateWhenThatIsOver) {
  Desk desk = flying();
  mission::UnitMission mission = a_mission(2, {801});
  mission.tasks[0].after.push_back({GoalId{702}, false, secs(60), Duration::max()});
  desk.add(mission);
  desk.finish(inserted({702, 801},
                       {TaskOf(200, "goto", 702).after(101), TaskOf(201, "goto", 801).after(200)}));

  desk.at(110).ends(101);
  desk.runs(200);
  desk.at(119).give(Tick{});
  EXPECT_THAT(desk.requests(), IsEmpty());
  desk.at(120).ends(200);
  EXPECT_THAT(desk.requests(), ElementsAre("START 202")) << "a safe wait";
  EXPECT_THAT(desk.notices(), Contains(HasSubstr("waits: nothing of it may begin "
                                                 "before 180 s")));
  desk.at(179).give(Tick{});

  EXPECT_THAT(desk.requests(), ElementsAre("START 201", "ABORT 202"));
}

TEST(SupervisorGoalBounds, AnEndThatComesBeforeItWasAskedIsSaid) {
  Desk desk = flying();
  mission::UnitMission mission = a_mission(2, {801});
  mission.tasks[0].after.push_back({GoalId{701}, true, secs(60), Duration::max()});
  desk.add(mission);
  desk.finish(inserted({702, 801}, {TaskOf(200, "goto", 702).after(101),
                                    TaskOf(201, "goto", 801).after(200).takes(50, 60)}));
  ASSERT_EQ(desk.state_of(801), "planned");

  desk.at(110).ends(101);
  desk.runs(200);
  desk.at(120).ends(200);
  desk.runs(201);
  desk.at(130).ends(201);

  EXPECT_THAT(desk.notices(),
              ::testing::Contains(HasSubstr("goal 801: goto 201 ended early by 40 s: it was to end "
                                            "after 170 s, counted from goal 701")));
}

TEST(SupervisorGoalBounds, OneThatIsBrokenInFlightIsRepairedWithItsFigures) {
  Desk desk = flying();
  desk.add(with_bound(2, 801, 701, 30));
  desk.finish(inserted({702, 801}, {TaskOf(200, "goto", 702).after(101).takes(5, 25),
                                    TaskOf(201, "goto", 801).after(200)}));
  ASSERT_EQ(desk.state_of(801), "planned");
  desk.at(110).ends(101);
  desk.runs(200);

  for (double s = 120; s < 150 && !std::holds_alternative<RepairRequest>(*desk.request); s += 1) {
    desk.at(s).give(Tick{});
  }

  ASSERT_TRUE(std::holds_alternative<RepairRequest>(*desk.request));
}

}  // namespace
}  // namespace skein::supervisor
