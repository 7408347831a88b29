// SPDX-License-Identifier: Apache-2.0
// What a contact-loss policy interrupted goes back to the ground station, which may give it again.
#include <gmock/gmock.h>

#include "testing/kept_uav.hpp"

namespace skein::decision_node {
namespace {

using executive::TaskState;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::goto_of;
using ::testing::IsEmpty;
using testing::kDue;
using testing::KeptUav;
using testing::kLost;
using testing::of;
using testing::start_of;

executive::Clause when(std::uint64_t task, TaskState state) {
  return {{executive::TaskInState{executive::TaskId(task), state}}};
}

/// On goto 12, after which wait 13 comes; takeshot 14 lasts as long as 12, takeshot 15 goes on.
KeptUav under_way(int degree = 3) {
  KeptUav uav(of(ContactPolicy::kHold, degree));
  uav.flies_at({50, 0, 50});
  uav.command(goto_of(12, {400, 0, 50}));
  executive::Start wait = start_of(13, "wait");
  wait.task.preconditions = {when(12, TaskState::kEnded)};
  uav.command(wait);
  executive::Start look = start_of(14, "takeshot");
  look.task.exit = {when(12, TaskState::kEnded)};
  uav.command(look);
  uav.command(start_of(15, "takeshot"));
  uav.loses_the_ground(kLost);
  return uav;
}

TEST(Interrupted, GoesBackWithWhatWasToFollowAndWhatWasToEndWithIt) {
  KeptUav uav = under_way();

  uav.at(kDue);

  ASSERT_EQ(uav.handed_over().size(), 1U);
  const HandedOver& told = uav.handed_over().front();
  EXPECT_EQ(told.hand_over.degree, 3);
  std::vector<std::uint64_t> tasks;
  for (const mission::HeldTask& one : told.hand_over.tasks) {
    tasks.push_back(one.task.id.value());
    EXPECT_FALSE(one.in_executive);
    EXPECT_EQ(one.state, TaskState::kScheduled);
  }
  EXPECT_THAT(tasks, ElementsAre(12, 13, 14));
  EXPECT_EQ(told.hand_over.tasks[1].task.preconditions,
            executive::Formula{when(12, TaskState::kEnded)});
}

TEST(Interrupted, WhatAnOperatorWasStoppingDoesNotGoBack) {
  KeptUav uav = under_way();
  uav.brakes_slowly();
  uav.command(executive::Abort{executive::TaskId(13)});
  uav.command(executive::Abort{executive::TaskId(14)});
  uav.command(executive::Abort{executive::TaskId(12)});

  uav.at(kDue);

  EXPECT_THAT(uav.handed_over(), IsEmpty());
}

TEST(Interrupted, OnTheGroundNothingGoesBack) {
  KeptUav uav(of(ContactPolicy::kHold));
  executive::Start wait = start_of(13, "wait");
  wait.task.preconditions = {{{executive::MessageReceived{"go"}}}};
  uav.command(wait);
  uav.loses_the_ground(kLost);
  uav.flies_at({0, 0, 0});

  uav.at(kDue);

  EXPECT_THAT(uav.handed_over(), IsEmpty());
}

// It would refuse the mission that the ground station gives it when it is back.
TEST(Interrupted, DeliberationIsNotOfAUavOnTheGroundThatHasNothingToDo) {
  for (const int degree : {4, 3}) {
    KeptUav uav(of(ContactPolicy::kHold, degree));
    uav.loses_the_ground(kLost);
    uav.flies_at({0, 0, 0});

    uav.at(kDue);

    EXPECT_THAT(uav.news(), Contains("policy hold"));
    EXPECT_THAT(uav.handed_over(), IsEmpty()) << "at degree " << degree;
  }
}

}  // namespace
}  // namespace skein::decision_node
