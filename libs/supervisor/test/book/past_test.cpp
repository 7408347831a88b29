// SPDX-License-Identifier: Apache-2.0
// What was settled long ago is let go, and nothing that anybody still needs.
#include "book/past.hpp"

#include <gmock/gmock.h>

#include "testing/rooms.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

/// Ten goals 1 to 10, each with a task of a hundred times its number; all achieved but 9 and 10.
struct TenGoals : Rooms {
  TenGoals() {
    std::vector<mission::ElementaryTask> tasks;
    for (std::uint64_t id = 1; id <= 10; ++id) tasks.push_back(TaskOf(100 * id, "goto", id));
    goals({1, 2, 3, 4, 5, 6, 7, 8}, GoalState::kAchieved).goals({9, 10});
    plan(std::move(tasks));
    for (std::uint64_t id = 1; id <= 8; ++id) gave({100 * id}).ended(100 * id);
  }
};

TEST(Past, TheOldestGoalsGoWithTheirTasks) {
  TenGoals rooms;

  let_go_of_the_past(rooms.book, {4, 4});

  EXPECT_EQ(rooms.book.order, goal_ids({5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(rooms.book.find(TaskId{400}), nullptr);
  EXPECT_NE(rooms.book.find(TaskId{500}), nullptr);
}

TEST(Past, ThatThereWasAGoalOfThatNumberStaysKnown) {
  TenGoals rooms;

  let_go_of_the_past(rooms.book, {4, 4});

  EXPECT_EQ(rooms.state_of(1), GoalState::kAchieved);
}

TEST(Past, OfTheOldestOnlyTheNumberStaysKnown) {
  TenGoals rooms;
  for (std::uint64_t id = 1; id <= 8; ++id)
    rooms.book.goals.at(GoalId{id}).settled = MissionTime::seconds(static_cast<double>(id));
  rooms.book.goals.at(GoalId{9}).task.after = {
      {GoalId{2}, true, Duration(), Duration::seconds(60)}};

  let_go_of_the_past(rooms.book, {1, 1, 3});

  EXPECT_EQ(rooms.book.order, goal_ids({2, 8, 9, 10}));
  for (std::uint64_t id = 1; id <= 10; ++id) EXPECT_TRUE(rooms.book.knows(GoalId{id})) << id;
  EXPECT_FALSE(rooms.book.knows(GoalId{11}));
  EXPECT_FALSE(rooms.book.goals.contains(GoalId{1}));
  EXPECT_TRUE(rooms.book.goals.contains(GoalId{2})) << "something open is bound to it";
  EXPECT_FALSE(rooms.book.goals.contains(GoalId{4}));
  EXPECT_EQ(rooms.state_of(5), GoalState::kAchieved);
}

TEST(Past, NothingGoesBeforeThereIsAQuarterTooMuch) {
  TenGoals rooms;

  let_go_of_the_past(rooms.book, {7, 7});

  EXPECT_EQ(rooms.book.order.size(), 10U);
}

TEST(Past, WhatSomethingOpenIsBoundToStays) {
  TenGoals rooms;
  rooms.book.goals.at(GoalId{9}).task.after = {
      {GoalId{1}, true, Duration(), Duration::seconds(60)}};
  rooms.entry(1000).task.dependences.push_back({mission::DependenceKind::kEnded, TaskId{200}});

  let_go_of_the_past(rooms.book, {4, 4});

  EXPECT_EQ(rooms.book.order, goal_ids({1, 2, 5, 6, 7, 8, 9, 10}));
}

TEST(Past, TasksGoBeforeTheirGoals) {
  TenGoals rooms;

  let_go_of_the_past(rooms.book, {8, 2});

  EXPECT_EQ(rooms.book.order.size(), 10U);
  EXPECT_EQ(rooms.book.find(TaskId{600}), nullptr);
  EXPECT_NE(rooms.book.find(TaskId{700}), nullptr);
  EXPECT_EQ(rooms.state_of(1), GoalState::kAchieved);
}

TEST(Past, TasksThatWentAreNotCountedAgain) {
  TenGoals rooms;
  let_go_of_the_past(rooms.book, {8, 4});
  rooms.book.goals.at(GoalId{9}).state = GoalState::kAchieved;

  let_go_of_the_past(rooms.book, {8, 4});

  EXPECT_NE(rooms.book.find(TaskId{500}), nullptr);  // five have tasks, and a quarter may be more
}

TEST(Past, TasksOfWhatSomethingOpenIsBoundToStay) {
  TenGoals rooms;
  rooms.book.goals.at(GoalId{9}).task.after = {
      {GoalId{1}, true, Duration(), Duration::seconds(60)}};
  rooms.entry(1000).task.dependences.push_back({mission::DependenceKind::kEnded, TaskId{200}});

  let_go_of_the_past(rooms.book, {8, 2});

  EXPECT_NE(rooms.book.find(TaskId{100}), nullptr);
  EXPECT_NE(rooms.book.find(TaskId{200}), nullptr);
  EXPECT_EQ(rooms.book.find(TaskId{300}), nullptr);
}

TEST(Past, WhatTheExecutiveStillHasStays) {
  TenGoals rooms;
  std::vector<mission::ElementaryTask> more{TaskOf(301, "takeshot", 3)};
  rooms.book.enter(plan_of(std::move(more)));
  rooms.gave({301});

  let_go_of_the_past(rooms.book, {4, 4});

  EXPECT_THAT(rooms.book.order, Contains(GoalId{3}));
  EXPECT_THAT(rooms.book.order, Not(Contains(GoalId{2})));
}

}  // namespace
}  // namespace skein::supervisor
