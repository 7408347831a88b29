// SPDX-License-Identifier: Apache-2.0
// Who thinks first: repair before insertion; what nobody wants any more is not waited for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::IsEmpty;

TEST(SupervisorLanes, AnInsertionGivesWayToARepairAndIsBegunAgain) {
  Desk desk = flying();
  desk.add(a_mission(2, {801}));
  const std::uint64_t insertion_job = desk.job_id;

  desk.at(30).aborted(101);

  ASSERT_TRUE(desk.job_started()) << "the repair does not wait";
  ASSERT_TRUE(std::holds_alternative<RepairRequest>(*desk.request));
  const std::uint64_t repair_job = desk.job_id;
  desk.give(JobFinished{insertion_job, refused("no longer wanted")});
  EXPECT_THAT(desk.notices(), IsEmpty());
  EXPECT_EQ(desk.state_of(801), "received") << "what an abandoned job says counts for nothing";

  desk.give(JobFinished{repair_job,
                        repaired(RepairStep::kRefine, {701, 702},
                                 {TaskOf(300, "goto", 701), TaskOf(301, "goto", 702).after(300)})});

  ASSERT_TRUE(desk.job_started());
  EXPECT_TRUE(std::holds_alternative<InsertionRequest>(*desk.request));
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

}  // namespace
}  // namespace skein::supervisor
