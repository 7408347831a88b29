// SPDX-License-Identifier: Apache-2.0
// Elementary tasks, and their text form in the seeds.
#include "skein/mission/elementary_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace skein::mission {
namespace {

Interval seconds(double least, double most) {
  return {Duration::seconds(least), Duration::seconds(most)};
}

ElementaryTask a_task(std::uint64_t id, std::string type, std::string name) {
  ElementaryTask task;
  task.id = executive::TaskId(id);
  task.type = std::move(type);
  task.name = std::move(name);
  return task;
}

Dependence ended(std::uint64_t id) { return {DependenceKind::kEnded, executive::TaskId(id)}; }
Dependence running(std::uint64_t id) { return {DependenceKind::kRunning, executive::TaskId(id)}; }

// Tasks 102 and 103 of Karma's plan (spec 3.5).
ElementaryTask karma_wait() {
  ElementaryTask wait = a_task(102, "wait", "task-wait");
  wait.start = seconds(5, 87);
  wait.duration = seconds(20, 20);
  wait.dependences = {ended(101)};
  wait.origin = GoalId(701);
  return wait;
}

ElementaryTask karma_takeshot() {
  ElementaryTask shot = a_task(103, "takeshot", "task-takeshot");
  shot.parameters.add({"device", "fire-sensor", {}});
  shot.start = seconds(5, 87);
  shot.dependences = {running(102)};
  shot.stop = {ended(102)};
  shot.origin = GoalId(701);
  return shot;
}

TEST(DependenceKind, IsReadBackFromItsWord) {
  for (const auto kind : {DependenceKind::kEnded, DependenceKind::kRunning, DependenceKind::kOver})
    EXPECT_EQ(dependence_kind_from(to_text(kind)), kind);
  EXPECT_EQ(dependence_kind_from("started"), std::nullopt);
}

TEST(ElementaryTask, MovesOrHoldsTheVehicleWhenItsTypeDoes) {
  for (const char* type : {"takeoff", "goto", "land", "wait", "perceive", "monitor", "rendezvous",
                           "joint:relay"})
    EXPECT_TRUE(holds_vehicle(a_task(1, type, ""))) << type;
  for (const char* type : {"takeshot", "synchronise", ""})
    EXPECT_FALSE(holds_vehicle(a_task(1, type, ""))) << type;
}

TEST(ElementaryTask, HasTheDevicesThatItsParametersName) {
  ElementaryTask look = a_task(1, "perceive", "");
  EXPECT_TRUE(devices_of(look).empty());
  look.parameters.add({"device", "visible", {}});
  EXPECT_EQ(devices_of(look), std::vector<std::string>{"visible"});
  look.type = "goto";
  EXPECT_TRUE(devices_of(look).empty());
}

// Source: spec 3.4 (the seeds' example, with fewer way-points).
TEST(Taskreq, IsTheTextOfTheSeeds) {
  ElementaryTask go = a_task(13, "goto", "task-gotoxyz");
  go.dependences = {ended(12), ended(11)};
  go.parameters.add({"waypoints", "", {1, 2, 30, 4, 5.5, 30}});
  go.start = seconds(240, 352);
  go.duration = seconds(88, 113.25);
  go.origin = GoalId(702);

  EXPECT_EQ(to_taskreq(go),
            "(TASKREQ TASK-GOTOXYZ 13 (DEPENDENCES ((ENDED 12) (ENDED 11))) "
            "(PARAMS (WPLIST ((TERM 1 2 30) (TERM 4 5.5 30)))) (START-TIME 240 352) "
            "(DURATION 88 113.25) (TIME-CONSTRAINTS NIL NIL NIL NIL) 702)");
}

TEST(Taskreq, WritesConstraintsInTheOrderOfTheSeedsAndUnboundedAsUnlimited) {
  ElementaryTask wait = a_task(25, "wait", "task-wait");
  wait.duration = {Duration(), Duration::max()};
  wait.time.start_before = MissionTime::seconds(1);
  wait.time.start_after = MissionTime::seconds(2);
  wait.time.end_before = MissionTime::seconds(3);
  wait.time.end_after = MissionTime::seconds(4);

  EXPECT_EQ(to_taskreq(wait),
            "(TASKREQ TASK-WAIT 25 (DEPENDENCES ()) (PARAMS) (START-TIME 0 0) "
            "(DURATION 0 UNLIMITED) (TIME-CONSTRAINTS 1 2 3 4) 0)");
}

TEST(Taskreq, WritesTheStopTaskAsALineOfItsOwn) {
  EXPECT_EQ(to_taskreq(karma_takeshot()),
            "(TASKREQ TASK-TAKESHOT 103 (DEPENDENCES ((RUNNING 102))) (PARAMS (DEVICE fire-sensor))"
            " (START-TIME 5 87) (DURATION 0 0) (TIME-CONSTRAINTS NIL NIL NIL NIL) 701)\n"
            "(TASKREQ TASK-STOP-TAKESHOT 103 (DEPENDENCES ((ENDED 102))) (PARAMS)"
            " (START-TIME 5 UNLIMITED) (DURATION 0 0) (TIME-CONSTRAINTS NIL NIL NIL NIL) 701)");
}

// Source: spec 3.5: the stop-task of 103 starts at 25–107, when 102 ends.
TEST(Taskreq, KnowsInAPlanWhenAStopTaskStarts) {
  ElementaryPlan plan;
  plan.tasks = {karma_wait(), karma_takeshot()};

  const std::string text = to_taskreq(plan);

  EXPECT_NE(text.find("(TASKREQ TASK-STOP-TAKESHOT 103 (DEPENDENCES ((ENDED 102))) (PARAMS)"
                      " (START-TIME 25 107)"),
            std::string::npos)
      << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}

TEST(Taskreq, AStopThatWaitsForSeveralTasksComesWithTheLastOfThem) {
  ElementaryPlan plan;
  ElementaryTask other = a_task(104, "synchronise", "task-synchro");
  other.start = seconds(0, 0);
  other.duration = seconds(30, 40);
  ElementaryTask shot = karma_takeshot();
  shot.stop = {ended(102), {DependenceKind::kOver, executive::TaskId(104)}, ended(99)};
  plan.tasks = {shot, karma_wait(), other};

  EXPECT_NE(to_taskreq(plan).find("STOP-TAKESHOT 103 (DEPENDENCES ((ENDED 102) (OVER 104) (ENDED "
                                  "99))) (PARAMS) (START-TIME 30 107)"),
            std::string::npos);
}

TEST(Taskreq, QuotesTextsThatAreNoSymbols) {
  ElementaryTask task = a_task(1, "joint:relay", "task-relay");
  task.parameters.add({"note", "a \"b\" (c)", {1}});
  task.parameters.add({"", "", {}});

  const std::string expected = R"raw((PARAMS (NOTE "a \"b\" (c)" 1) ("")))raw";

  EXPECT_NE(to_taskreq(task).find(expected), std::string::npos) << to_taskreq(task);
}

TEST(Taskreq, WritesWhomASynchronisationIsWith) {
  ElementaryTask task = a_task(26, "synchronise", "task-synchro");
  task.synchronisation =
      executive::Synchronisation{551, {"marvin", "heliv"}, {"marvin"}, MissionTime::seconds(90)};

  EXPECT_NE(to_taskreq(task).find("(PARAMS (SYNC-ID 551) (SENDERS marvin heliv) (RECEIVERS marvin)"
                                  " (DEADLINE 90))"),
            std::string::npos);
}

TEST(Taskreq, AnEmptyPlanHasNoText) { EXPECT_EQ(to_taskreq(ElementaryPlan{}), ""); }

}  // namespace
}  // namespace skein::mission
