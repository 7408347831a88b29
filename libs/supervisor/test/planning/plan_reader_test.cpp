// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/plan_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/htn/syntax.hpp"

namespace skein::supervisor {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Steps as text, read as the planner would give them.
class PlanReaderTest : public ::testing::Test {
 protected:
  htn::Term term(const htn::Document& document, htn::NodeIndex at) {
    if (!document[at].list) return document[at].atom;
    std::vector<htn::Term> items;
    for (const htn::NodeIndex child : htn::children(document, at))
      items.push_back(term(document, child));
    return store_.list(items);
  }

  Result<mission::ElementaryPlan, Failure> read(const std::string& steps) {
    Diagnostics errors;
    const htn::Document document = htn::read_document("plan", steps, store_, errors);
    EXPECT_TRUE(errors.empty());
    htn::Plan plan;
    for (const htn::NodeIndex at : document.top) {
      const htn::Term action = term(document, at);
      const bool internal = store_.name(store_.car(action)).starts_with("!!");
      plan.steps.push_back({action, htn::integer(2), internal});
    }
    return read_plan(store_, plan, knowledge_, MissionTime::seconds(100));
  }

  std::string why(const std::string& steps) {
    const auto plan = read(steps);
    return plan ? "" : plan.error().why;
  }

  htn::TermStore store_;
  Knowledge knowledge_;
};

TEST_F(PlanReaderTest, ReadsEveryPartOfATask) {
  const auto plan = read(
      "(!task-gotoxyz 13 ((ended 12) (over 11) (running 10))"
      " ((type goto) (waypoints (loc 1 2 3) (loc 4.5 5 6)) (way (loc 0 0 3) (loc 1 2 3))"
      "  (energy 0.25)) ((num 240) (num 352.5)) ((num 88) (num unlimited))"
      " (10 20 30 40) 702)");

  ASSERT_TRUE(plan) << plan.error().why;
  const mission::ElementaryTask& task = plan->tasks.at(0);
  EXPECT_EQ(task.id, executive::TaskId(13));
  EXPECT_EQ(task.type, "goto");
  EXPECT_EQ(task.name, "task-gotoxyz");
  using mission::DependenceKind;
  EXPECT_THAT(task.dependences,
              ElementsAre(mission::Dependence{DependenceKind::kEnded, executive::TaskId(12)},
                          mission::Dependence{DependenceKind::kOver, executive::TaskId(11)},
                          mission::Dependence{DependenceKind::kRunning, executive::TaskId(10)}));
  EXPECT_THAT(task.parameters.find("waypoints")->numbers, ElementsAre(1, 2, 3, 4.5, 5, 6));
  EXPECT_EQ(task.parameters.all().size(), 1U);
  EXPECT_EQ(task.way.size(), 2U);
  EXPECT_EQ(task.start, (mission::Interval{Duration::seconds(240), Duration::seconds(352.5)}));
  EXPECT_EQ(task.duration, (mission::Interval{Duration::seconds(88), Duration::max()}));
  EXPECT_EQ(task.time,
            (mission::TimeConstraints{MissionTime::seconds(110), MissionTime::seconds(120),
                                      MissionTime::seconds(130), MissionTime::seconds(140)}));
  EXPECT_EQ(task.origin, mission::GoalId(702));
  EXPECT_DOUBLE_EQ(task.energy, 0.25);
  EXPECT_DOUBLE_EQ(task.cost, 2);
}

TEST_F(PlanReaderTest, AStopBecomesPartOfItsTask) {
  const auto plan = read(
      "(!task-wait 25 () ((type wait)) ((num 0) (num 0)) ((num 0) (num 0)) nil 1)"
      "(!stop-wait 25 ((ended 26)) () ((num 0) (num 9)) ((num 0) (num 0)) nil 1)");

  ASSERT_TRUE(plan) << plan.error().why;
  ASSERT_EQ(plan->tasks.size(), 1U);
  EXPECT_THAT(plan->tasks[0].stop, ElementsAre(mission::Dependence{mission::DependenceKind::kEnded,
                                                                   executive::TaskId(26)}));
}

TEST_F(PlanReaderTest, InternalStepsCostButAreNoTasks) {
  const auto plan = read("(!!lcompute-gotoxyz a b)");

  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan->tasks.empty());
  EXPECT_DOUBLE_EQ(plan->cost, 2);
}

TEST_F(PlanReaderTest, AJointTaskTakesAnyParameter) {
  const auto plan = read(
      "(!task-dance 1 () ((type \"joint:dance\") (steps 1 2) (with (A b)) (how 'slowly))"
      " ((num 0) (num 0)) ((num 0) (num 0)) nil 1)");

  ASSERT_TRUE(plan) << plan.error().why;
  const mission::ElementaryTask& task = plan->tasks.at(0);
  EXPECT_EQ(task.type, "joint:dance");
  EXPECT_THAT(task.parameters.find("steps")->numbers, ElementsAre(1, 2));
  EXPECT_EQ(task.parameters.find("with")->text, "a b");
  EXPECT_EQ(task.parameters.find("how")->text, "slowly");
}

TEST_F(PlanReaderTest, WhatATypeDoesNotAllowIsTold) {
  const std::string reasons =
      why("(!task-hover 1 () ((type wiat)) ((num 0) (num 0)) ((num 0) (num 0)) nil 1)"
          "(!task-wait 2 () ((type wait) (altitude 3)) ((num 0) (num 0)) ((num 0) (num 0)) nil 1)"
          "(!task-land 3 () ((type land) (open-ended)) ((num 0) (num 0)) ((num 0) (num 0)) nil 1)"
          "(!task-goto 4 () ((type goto)) ((num 0) (num 0)) ((num 0) (num 0)) nil 1)"
          "(!stop-goto 4 ((ended 1)) () ((num 0) (num 0)) ((num 0) (num 0)) nil 1)");

  EXPECT_THAT(reasons, HasSubstr("unknown type 'wiat'; did you mean 'wait'?"));
  EXPECT_THAT(reasons, HasSubstr("a task of type 'wait' takes no parameter 'altitude'"));
  EXPECT_THAT(reasons, HasSubstr("a task of type 'land' does not end by order"));
  EXPECT_THAT(reasons, HasSubstr("a task of type 'goto' cannot be stopped"));
}

TEST_F(PlanReaderTest, EveryStepOfAnotherShapeIsTold) {
  const std::string reasons =
      why("(!fly 1)"
          "(!task-wait x () ((type wait)) ((num 0) (num 0)) ((num 0) (num 0)) nil 1)"
          "(!task-wait 2 ((before 1)) ((type wait)) ((num 0) (num 0)) ((num 0) (num 0)) nil 1)"
          "(!task-wait 3 () ((type wait)) (0) ((num 0) (num 0)) nil 1)"
          "(!task-wait 4 () ((kind wait)) ((num 0) (num 0)) ((num 0) (num 0)) nil 1)"
          "(!task-wait 5 () ((type wait)) ((num 0) (num 0)) ((num 0) (num 0)) (1 2) 1)"
          "(!task-synchro 6 () ((type synchronise)) ((num 0) (num 0)) ((num 0) (num 0)) nil 1)"
          "(!stop-wait 99 ((ended 1)) () ((num 0) (num 0)) ((num 0) (num 0)) nil 1)");

  EXPECT_THAT(reasons, HasSubstr("(!fly 1): expected (!task-NAME"));
  EXPECT_THAT(reasons, HasSubstr("expected whole numbers as id and origin"));
  EXPECT_THAT(reasons, HasSubstr("expected dependences"));
  EXPECT_THAT(reasons, HasSubstr("expected start and duration"));
  EXPECT_THAT(reasons, HasSubstr("expected (type TYPE)"));
  EXPECT_THAT(reasons, HasSubstr("expected four time constraints"));
  EXPECT_THAT(reasons, HasSubstr("expected (sync ID SENDERS RECEIVERS)"));
  EXPECT_THAT(reasons, HasSubstr("expected the id of a task before it"));
}

}  // namespace
}  // namespace skein::supervisor
