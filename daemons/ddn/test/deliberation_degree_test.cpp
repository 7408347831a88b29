// SPDX-License-Identifier: Apache-2.0
// Degree 4 taken away and given back, by the operator and by a loss of contact; and closed air.
#include "testing/deliberating.hpp"

namespace skein::ddn {
namespace {

using testing::a_task;
using testing::Bench;
using testing::cancellation;
using testing::command;
using ::testing::Contains;
using testing::degree;
using testing::deliberating;
using ::testing::ElementsAre;
using testing::finish;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kGoal;
using testing::mission_to;
using ::testing::Not;
using testing::plan;
using ::testing::SizeIs;
using testing::start;
using testing::state_of_goal;
using testing::status;
using testing::take_off;
using testing::telemetry;
using testing::three_tasks;
using wire::TaskState;
using Words = std::vector<std::string>;

// ---- down and up again ----

TEST(DownFrom4, WhatRunsGoesOnAndTheGroundIsToldWhoseTasksTheyAre) {
  Bench bench(deliberating(4));
  plan(bench);
  take_off(bench);

  EXPECT_THAT(bench.from_ground(degree(9, 3)),
              ElementsAre("ground: reply 9 accepted", "ground: degree 3",
                          "ground: hand-over 3: 101 running, 102 scheduled"));
  const wire::HandOver& hand_over = *bench.sent<wire::HandOver>();
  EXPECT_EQ(hand_over.tasks[0].origin, kGoal);
  ASSERT_THAT(hand_over.goals, SizeIs(1));
  EXPECT_EQ(hand_over.goals[0].id, kGoal);
  EXPECT_THAT(bench.from_sim(status(101, TaskState::kEnded)), Contains("sim: dispatch 102 land"));
}

TEST(DownFrom4, ToDegree1TheGoalIsStillSeenAchieved) {
  Bench bench(deliberating(4));
  plan(bench);
  take_off(bench);
  bench.from_ground(degree(9, 1));
  bench.from_sim(status(101, TaskState::kEnded));
  bench.from_ground(testing::dispatch(102, "land"));
  bench.from_sim(status(102, TaskState::kRunning));

  EXPECT_THAT(bench.from_sim(status(102, TaskState::kEnded)),
              ElementsAre("ground: status 102 ended"));

  EXPECT_EQ(state_of_goal(bench), "achieved");
}

// A synchronisation ends in the ground's executive, and no functional status says so.
TEST(DownFrom4, ToDegree1AGoalIsSeenAchievedWhoseLastTaskOnlyTheGroundSees) {
  Bench bench(deliberating(4));
  plan(bench);
  take_off(bench);
  bench.from_ground(degree(9, 1));
  bench.from_sim(status(101, TaskState::kEnded));
  wire::TaskEvent event;
  event.uav = "marvin";
  event.id = 102;
  event.type = "land";
  event.state = TaskState::kEnded;

  bench.from_heliv(event);
  EXPECT_NE(state_of_goal(bench), "achieved") << "nobody but the ground has tasks of this UAV";
  bench.from_ground(event);

  EXPECT_EQ(state_of_goal(bench), "achieved");
}

TEST(DownFrom4, WhatIsNotPlannedYetIsPlannedWhenGivenBack) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});
  bench.from_ground(mission_to(1, 7));
  bench.from_ground(degree(2, 1));
  EXPECT_EQ(state_of_goal(bench), "handed-over");

  bench.from_ground(degree(3, 4));

  EXPECT_THAT(bench.jobs(), SizeIs(1));
}

TEST(DownFrom4, WhatWasHandedOverStaysSoWithoutResume) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});
  bench.from_ground(mission_to(1, 7));
  bench.from_ground(degree(2, 3));
  wire::DegreeCommand up = degree(3, 4);
  up.resume = false;

  bench.from_ground(up);

  EXPECT_THAT(bench.jobs(), IsEmpty());
  EXPECT_EQ(bench.sent<wire::HandOver>()->goals.at(0).state, wire::GoalState::kHandedOver);
}

TEST(DownFrom4, WhatWasHandedOverCanBeCancelled) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});
  bench.from_ground(mission_to(1, 7));
  bench.from_ground(degree(2, 3));

  EXPECT_THAT(bench.from_ground(cancellation(3)), Contains("ground: reply 3 accepted"));

  EXPECT_EQ(state_of_goal(bench), "cancelled");
}

TEST(DownFrom4, AnInterruptionStopsThePlanAndWaits) {
  Bench bench(deliberating(4));
  plan(bench);
  take_off(bench);

  const Words words = bench.from_ground(testing::interrupting(degree(9, 3)));

  EXPECT_THAT(words, Contains("ground: 102 aborted"));
  EXPECT_THAT(words, Contains("sim: interrupt 101"));
  EXPECT_THAT(bench.from_sim(status(101, TaskState::kAborted)), Contains(HasSubstr(" wait")));
  EXPECT_THAT(bench.jobs(), IsEmpty());
}

TEST(AtDegree4, TheSameDegreeAgainTellsThePlanAgain) {
  Bench bench(deliberating(4));
  plan(bench);

  EXPECT_THAT(bench.from_ground(degree(9, 4)),
              ElementsAre("ground: reply 9 accepted", "ground: degree 4",
                          HasSubstr("hand-over 4: 100 started")));
}

TEST(AtDegree4, ARestartedNodeIsBackAtItsDegreeWithoutAPlan) {
  Bench bench(deliberating(4));

  EXPECT_THAT(bench.give(node::Started{2}), ElementsAre("ground: degree 4"));

  ASSERT_THAT(bench.boards(), SizeIs(1));
  EXPECT_THAT(bench.boards()[0].tasks, IsEmpty());
  EXPECT_THAT(bench.from_ground(mission_to(1, 7)), ElementsAre("ground: reply 1 accepted"));
}

// ---- the world ----

wire::WorldChange closed_air(std::uint64_t number) {
  mission::ChangeWorld change;
  change.volume.name = "smoke";
  change.volume.polygon = {{500, 500}, {600, 500}, {600, 600}};
  wire::WorldChange sample = translation::to_wire(change);
  sample.header.incarnation = 1;
  sample.command = number;
  return sample;
}

class TheWorld : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Deliberation, TheWorld, ::testing::Values(1, 2, 3, 4));

TEST_P(TheWorld, IsChangedAtEveryDegree) {
  Bench bench(deliberating(GetParam()));
  bench.give(node::Started{1, true});

  EXPECT_THAT(bench.from_ground(closed_air(1)), ElementsAre("ground: reply 1 accepted"));
  EXPECT_THAT(bench.from_ground(closed_air(1)), ElementsAre("ground: reply 1 accepted"));
}

TEST(TheWorld, OfAUavThatDoesNotPlanIsTakenAllTheSame) {
  Bench bench(Bench::at_degree(3));

  EXPECT_THAT(bench.from_ground(closed_air(1)), ElementsAre("ground: reply 1 accepted"));
}

TEST(TheWorld, AVolumeThatIsNoneIsRefused) {
  Bench bench(deliberating(4));
  wire::WorldChange change = closed_air(1);
  change.corners.pop_back();

  EXPECT_THAT(bench.from_ground(change), ElementsAre(HasSubstr("reply 1 refused: corners: ")));
}

// ---- contact ----

class ContactLostAt4 : public ::testing::Test {
 protected:
  void lose_contact() {
    plan(bench);
    take_off(bench);
    bench.set_time(10);
    bench.hear_ground(false);
    words = bench.wake_at(40);
  }
  Bench bench{deliberating(4, ContactPolicy::kHold)};
  Words words;
};

TEST_F(ContactLostAt4, HoldStopsThePlanAndTellsTheGround) {
  lose_contact();

  EXPECT_THAT(bench.records("contact"), SizeIs(1));
  EXPECT_THAT(words, Contains("ground: 102 aborted"));
  EXPECT_THAT(words, Contains("sim: interrupt 101"));
  EXPECT_THAT(words, Contains(HasSubstr("hand-over 4:")));
  EXPECT_THAT(bench.from_sim(status(101, TaskState::kAborted)), Contains(HasSubstr(" wait")));
  EXPECT_THAT(bench.jobs(), IsEmpty());
}

TEST_F(ContactLostAt4, NothingIsPlannedUntilTheDegreeIsGivenAgain) {
  lose_contact();
  bench.hear_ground(true);

  EXPECT_THAT(bench.from_ground(mission_to(20, 8)),
              ElementsAre("ground: reply 20 refused: deliberation stopped when contact was lost: "
                          "degree 4 is to be given again"));
  bench.from_ground(degree(21, 4));
  EXPECT_THAT(bench.from_ground(mission_to(22, 8)), Contains("ground: reply 22 accepted"));
}

// Else a plan would wait for the hold, which nobody ends.
TEST_F(ContactLostAt4, WhatHeldItSafeGivesWayWhenTheDegreeIsGivenAgain) {
  lose_contact();
  bench.from_sim(status(101, TaskState::kAborted));
  bench.from_sim(status(functional::kFirstOwnId.value() + 40'000, TaskState::kRunning));
  bench.hear_ground(true);

  const Words given_again = bench.from_ground(degree(21, 4));

  EXPECT_THAT(given_again, Contains("sim: interrupt 1000040000"));
}

TEST(ContactAt4, ContinueGoesOn) {
  Bench bench(deliberating(4, ContactPolicy::kContinue));
  plan(bench);
  take_off(bench);
  bench.set_time(5);
  bench.hear_ground(false);

  EXPECT_THAT(bench.from_sim(status(101, TaskState::kEnded)), Contains("sim: dispatch 102 land"));
  EXPECT_THAT(bench.records("contact"), IsEmpty());
}

}  // namespace
}  // namespace skein::ddn
