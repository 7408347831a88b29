// SPDX-License-Identifier: Apache-2.0
// Tasks that a contact-loss policy interrupted are begun again under other ids.
#include "skein/ground_station/stand_ins.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/ground_station/ground_control.hpp"
#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::Formula;
using executive::TaskState;
using mission::HeldTask;
using testing::a_step;
using testing::a_task;
using testing::at;
using ::testing::ElementsAre;
using testing::first;
using testing::flat_terrain;
using testing::id;
using testing::in_state;
using ::testing::IsEmpty;
using testing::only;
using Effects = std::vector<GroundControl::Effect>;

constexpr std::uint64_t kNew = StandIns::kFirstId;

HeldTask held(std::uint64_t task, Formula preconditions = {}) {
  HeldTask out;
  out.task = a_task(task);
  out.task.preconditions = std::move(preconditions);
  return out;
}

bool is_known(executive::TaskId task) { return task < id(10) || task >= id(kNew); }

TEST(StandIns, GiveNewIdsToThoseThatAreUsedUpAndConditionsFollow) {
  StandIns stand_ins;
  std::vector<HeldTask> tasks{held(5, {in_state(4, TaskState::kEnded)}),
                              held(6, {in_state(5, TaskState::kEnded)}),
                              held(20, {in_state(6, TaskState::kEnded)})};

  stand_ins.stand_in("marvin", tasks, is_known);

  EXPECT_EQ(tasks[0].task.id, id(kNew));
  EXPECT_EQ(tasks[0].task.preconditions, Formula{in_state(4, TaskState::kEnded)});
  EXPECT_EQ(tasks[1].task.id, id(kNew + 1));
  EXPECT_EQ(tasks[1].task.preconditions, Formula{in_state(kNew, TaskState::kEnded)});
  EXPECT_EQ(tasks[2].task.id, id(20));
  EXPECT_EQ(tasks[2].task.preconditions, Formula{in_state(kNew + 1, TaskState::kEnded)});
}

TEST(StandIns, OneThatIsInterruptedTooHasAnotherForTheSameOriginal) {
  StandIns stand_ins;
  std::vector<HeldTask> tasks{held(5)};
  stand_ins.stand_in("marvin", tasks, is_known);

  stand_ins.stand_in("marvin", tasks, is_known);

  EXPECT_EQ(tasks[0].task.id, id(kNew + 1));
  EXPECT_EQ(stand_ins.original_of("marvin", id(kNew)), id(5));
  EXPECT_EQ(stand_ins.original_of("marvin", id(kNew + 1)), id(5));
  EXPECT_EQ(stand_ins.original_of("heliv", id(kNew + 1)), std::nullopt);
  EXPECT_EQ(stand_ins.original_of("marvin", id(5)), std::nullopt);
}

TEST(StandIns, RequestsGoToTheTaskThatStandsForTheOneTheyName) {
  StandIns stand_ins;
  std::vector<HeldTask> tasks{held(5)};
  stand_ins.stand_in("marvin", tasks, is_known);
  executive::Start start{a_task(30)};
  start.task.preconditions = {in_state(5, TaskState::kEnded)};

  const auto abort = stand_ins.redirected("marvin", testing::abort_of(5));
  const auto of_another = stand_ins.redirected("heliv", testing::abort_of(5));
  const auto after = stand_ins.redirected("marvin", start);

  EXPECT_EQ(std::get<executive::Abort>(abort).id, id(kNew));
  EXPECT_EQ(std::get<executive::Abort>(of_another).id, id(5));
  EXPECT_EQ(std::get<executive::Start>(after).task.preconditions,
            Formula{in_state(kNew, TaskState::kEnded)});
}

// ---- the ground station ----

/// Gives back what is held, and waits for 5 to end.
GroundControl giving_again() {
  GroundConfig config;
  config.uavs = {{"marvin", 3, {}}};
  Step again = a_step("again", {OnHeld{"marvin"}}, {ResumePlan{"marvin"}});
  again.once = false;
  config.script.steps = {again, a_step("done", {OnTask{"marvin", id(5), TaskState::kEnded}})};
  return {config, flat_terrain()};
}

Effects tell(GroundControl& ground, std::uint64_t task, TaskState state, double when) {
  return ground.handle(TaskEventReceived{"marvin", id(task), "goto", state, ""}, at(when));
}

Effects hand_over(GroundControl& ground, std::vector<HeldTask> tasks, double when) {
  return ground.handle(HandOverReceived{"marvin", {3, std::move(tasks), {}}, at(when)}, at(when));
}

std::vector<std::string> steps_of(const Effects& effects) {
  std::vector<std::string> names;
  for (const StepDone& step : only<StepDone>(effects)) names.push_back(step.name);
  return names;
}

TEST(Interrupted, IsGivenAgainByTheScriptWhichSeesItEndAsTheOneItAskedFor) {
  GroundControl ground = giving_again();
  tell(ground, 5, TaskState::kRunning, 1);

  const Effects held_now = hand_over(ground, {held(5)}, 2);

  EXPECT_EQ(first<HeldPlanChanged>(held_now).state, HeldState::kHeld);
  EXPECT_THAT(steps_of(held_now), ElementsAre("again"));
  const auto start = std::get<executive::Start>(first<SendRequest>(held_now).request);
  EXPECT_EQ(start.task.id, id(kNew));
  EXPECT_THAT(steps_of(tell(ground, 5, TaskState::kAborted, 3)), IsEmpty());
  EXPECT_THAT(steps_of(tell(ground, kNew, TaskState::kEnded, 4)), ElementsAre("done"));
}

TEST(Interrupted, IsNotWhoWasAskedToChangeItsDegree) {
  GroundControl ground = giving_again();
  ground.handle(OperatorCommand{"marvin", mission::ChangeDegree{2}, Duration::seconds(60)}, at(1));

  const Effects asked = ground.handle(HandOverReceived{"marvin", {2, {held(5)}, {}}, at(2)}, at(2));

  EXPECT_EQ(first<HeldPlanChanged>(asked).state, HeldState::kHeld);
  EXPECT_THAT(steps_of(asked), IsEmpty());
}

// A script that gives the degree again to who was interrupted would do so for ever.
TEST(Interrupted, IsNotWhoIsGivenTheDegreeThatItHas) {
  GroundControl ground = giving_again();
  const Effects issued = ground.handle(
      OperatorCommand{"marvin", mission::ChangeDegree{3}, Duration::seconds(60)}, at(1));
  const CommandNumber command = first<SendRequest>(issued).command;
  ground.handle(RequestReplyReceived{command, true, ""}, at(2));

  EXPECT_THAT(steps_of(hand_over(ground, {held(5)}, 2)), IsEmpty());
  EXPECT_THAT(steps_of(hand_over(ground, {held(6)}, 3)), ElementsAre("again"));
}

TEST(Interrupted, ASecondTimeIsGivenAgainOnceMore) {
  GroundControl ground = giving_again();
  tell(ground, 5, TaskState::kRunning, 1);
  hand_over(ground, {held(5)}, 2);
  tell(ground, kNew, TaskState::kRunning, 3);

  const Effects again = hand_over(ground, {held(kNew)}, 4);

  EXPECT_THAT(steps_of(again), ElementsAre("again"));
  EXPECT_THAT(steps_of(tell(ground, kNew + 1, TaskState::kEnded, 6)), ElementsAre("done"));
}

}  // namespace
}  // namespace skein::ground_station
