// SPDX-License-Identifier: Apache-2.0
// What is to be planned, and the one job.
#include "jobs/agenda.hpp"

#include <gmock/gmock.h>

#include "testing/rooms.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Pending a_pending(std::uint64_t id) {
  Pending pending;
  pending.id = mission::MissionId{id};
  return pending;
}
Job insertion_of(std::uint64_t mission, bool evaluation = false) {
  Job job;
  job.mission = mission::MissionId{mission};
  job.evaluation = evaluation;
  return job;
}
std::vector<std::uint64_t> stopped(Rooms& rooms) {
  std::vector<std::uint64_t> jobs;
  for (const Effect& effect : rooms.out.close()) {
    if (const auto* one = std::get_if<StopDeliberation>(&effect)) jobs.push_back(one->job);
  }
  return jobs;
}

// ---- needs ----

TEST(Agenda, AFurtherCauseIsAddedToTheNeedThatIsThere) {
  Rooms rooms;
  rooms.at(10).agenda.plan_anew(std::nullopt, false, "wind");
  rooms.at(20).agenda.plan_anew(GoalId{701}, true, "engine");
  rooms.at(30).agenda.plan_anew(GoalId{702}, false, "rain");

  const Need need = rooms.agenda.take_need();
  EXPECT_EQ(need.cause, "wind; engine; rain");
  EXPECT_EQ(need.failed, GoalId{701});
  EXPECT_TRUE(need.refine);
  EXPECT_EQ(need.since, at(10));
  EXPECT_FALSE(rooms.agenda.repairing());
}

TEST(Agenda, APausedRepairIsNotDueBeforeItsTime) {
  Rooms rooms;
  rooms.at(10).agenda.plan_anew(std::nullopt, false, "refused");
  EXPECT_TRUE(rooms.agenda.repair_is_due());

  rooms.agenda.pause_until(at(15));
  EXPECT_FALSE(rooms.agenda.repair_is_due());
  EXPECT_TRUE(rooms.agenda.repairing());
  EXPECT_TRUE(rooms.at(15).agenda.repair_is_due());
}

TEST(Agenda, WhateverElseHappensEndsThePause) {
  Rooms rooms;
  rooms.at(10).agenda.plan_anew(std::nullopt, false, "refused");
  rooms.agenda.pause_until(at(60));

  rooms.at(12).agenda.plan_anew(std::nullopt, false, "wind");

  EXPECT_TRUE(rooms.agenda.repair_is_due());
}

// ---- the job ----

TEST(Agenda, AnEvaluationGivesWayToAMission) {
  Rooms rooms;
  rooms.agenda.run(insertion_of(1, true), InsertionRequest{});
  rooms.agenda.give_way();
  EXPECT_TRUE(rooms.agenda.job());
  EXPECT_FALSE(rooms.agenda.plans());

  rooms.agenda.add(a_pending(2));
  rooms.agenda.give_way();

  EXPECT_FALSE(rooms.agenda.job());
  EXPECT_THAT(stopped(rooms), ElementsAre(1));
}

TEST(Agenda, AnInsertionGivesWayToARepairAndARepairToNothing) {
  Rooms rooms;
  rooms.agenda.run(insertion_of(1), InsertionRequest{});
  rooms.agenda.plan_anew(std::nullopt, false, "wind");
  rooms.agenda.give_way();
  EXPECT_FALSE(rooms.agenda.job());

  rooms.agenda.take_need();
  rooms.agenda.run({}, RepairRequest{});
  rooms.agenda.add(a_pending(2));
  rooms.agenda.plan_anew(std::nullopt, false, "rain");
  rooms.agenda.give_way();
  EXPECT_TRUE(rooms.agenda.job());
}

TEST(Agenda, WhatAJobSaysThatWasGivenUpCountsForNothingAndIsNoSurprise) {
  Rooms rooms;
  rooms.agenda.run(insertion_of(1), InsertionRequest{});
  rooms.agenda.abandon_job();

  EXPECT_FALSE(rooms.agenda.finished(1));
  EXPECT_THAT(rooms.notices(), IsEmpty());
  EXPECT_FALSE(rooms.agenda.finished(1));
  EXPECT_THAT(rooms.notices(), ElementsAre("result of job 1, which nobody waits for"));
}

TEST(Agenda, AJobThatIsMadeAgainAndAgainCountsAsNoneAtLast) {
  Rooms rooms;
  rooms.agenda.add(a_pending(1));
  for (int times = 1; times <= 5; ++times) {
    EXPECT_TRUE(rooms.agenda.again(insertion_of(1), "the world changed")) << times;
  }
  EXPECT_THAT(rooms.notices(), IsEmpty());
  EXPECT_FALSE(rooms.agenda.again(insertion_of(1), "the world changed"));
  EXPECT_THAT(rooms.notices(),
              ElementsAre("job 0 is made again for the 6th time: the world changed"));
}

TEST(Agenda, ARepairThatIsMadeAgainKeepsWhatCameMeanwhile) {
  Rooms rooms;
  Job repair;
  repair.need.cause = "wind";
  rooms.agenda.plan_anew(GoalId{702}, false, "engine");

  rooms.agenda.again(repair, "it changed");

  EXPECT_EQ(rooms.agenda.needed()->cause, "wind; engine");
  EXPECT_EQ(rooms.agenda.needed()->failed, GoalId{702});
  EXPECT_FALSE(rooms.agenda.needed()->refine);
}

TEST(Agenda, ClearedThereIsNothingToPlanAndWhatWasToBeEvaluatedIsGivenBack) {
  Rooms rooms;
  Evaluation evaluation;
  evaluation.mission.id = mission::MissionId{3};
  rooms.agenda.add(a_pending(1));
  rooms.agenda.add(evaluation);
  rooms.agenda.plan_anew(std::nullopt, false, "wind");
  rooms.agenda.run(insertion_of(1), InsertionRequest{});

  const auto left = rooms.agenda.clear();

  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left.front().mission.id, mission::MissionId{3});
  EXPECT_THAT(stopped(rooms), ElementsAre(1));
  EXPECT_FALSE(rooms.agenda.repairing());
  EXPECT_TRUE(rooms.agenda.pending().empty());
  EXPECT_TRUE(rooms.agenda.evaluations().empty());
}

}  // namespace
}  // namespace skein::supervisor
