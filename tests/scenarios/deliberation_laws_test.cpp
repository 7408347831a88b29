// SPDX-License-Identifier: Apache-2.0
// The checker of logs with deliberation sees what it is there to see.
#include "testing/deliberation_laws.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::testing {
namespace {

using journal::Record;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Log = std::vector<Record>;

Record of(double seconds, const char* kind) {
  return Record(MissionTime::seconds(seconds), "karma", kind).with("uav", "karma");
}
Record goal(double seconds, int id, const char* state) {
  return of(seconds, "goal").with("goal", id).with("state", state);
}
Record plan(double seconds, int revision, int tasks) {
  return of(seconds, "plan").with("revision", revision).with("tasks", tasks);
}
Record planned(double seconds, int revision, int task, int goal, double start = 1, double end = 2) {
  return of(seconds, "planned")
      .with("revision", revision)
      .with("task", task)
      .with("goal", goal)
      .with("earliest_start", start)
      .with("earliest_end", end);
}
Record decision(double seconds, int number, const char* applied, const char* cause) {
  return of(seconds, "decision")
      .with("number", number)
      .with("operator", applied)
      .with("cause", cause);
}
Record degree(double seconds, int value) { return of(seconds, "degree").with("degree", value); }
Record flight(double seconds, bool airborne) {
  return of(seconds, "telemetry").with("airborne", airborne);
}
Record task(double seconds, int id, const char* type, const char* state) {
  return of(seconds, "task").with("task", id).with("type", type).with("state", state);
}

TEST(DeliberationLaws, AnOrdinaryLifeBreaksNone) {
  const Log log{degree(0, 4),
                goal(1, 701, "received"),
                decision(1, 1, "0", ""),
                goal(2, 701, "planned"),
                plan(2, 1, 2),
                planned(2, 1, 100, 701),
                planned(2, 1, 101, 701),
                goal(3, 701, "under-way"),
                task(3, 100, "goto", "scheduled"),
                flight(4, true),
                task(9, 100, "goto", "ended"),
                goal(9, 701, "achieved"),
                flight(10, false)};

  EXPECT_THAT(broken_deliberation_laws(log), IsEmpty());
}

TEST(DeliberationLaws, NothingFollowsASettledGoal) {
  const Log log{goal(1, 7, "received"), goal(2, 7, "failed"), goal(3, 7, "planned")};

  EXPECT_THAT(broken_deliberation_laws(log), ElementsAre(HasSubstr("from 'failed' to 'planned'")));
}

TEST(DeliberationLaws, ARevisionListsNoMoreTasksThanItHas) {
  const Log log{plan(1, 1, 2), planned(1, 1, 100, 7), plan(2, 2, 0), planned(2, 2, 101, 7)};

  EXPECT_THAT(broken_deliberation_laws(log), ElementsAre(HasSubstr("more planned tasks")));
}

TEST(DeliberationLaws, RevisionsAndDecisionsCountUpByOne) {
  const Log log{plan(1, 1, 0), plan(2, 3, 0), decision(3, 2, "0", "")};

  EXPECT_THAT(broken_deliberation_laws(log),
              ElementsAre(HasSubstr("revision 3"), HasSubstr("decision 2")));
}

TEST(DeliberationLaws, ATaskKeepsItsGoalAndItsDatesAreInOrder) {
  const Log log{plan(1, 1, 1), planned(1, 1, 100, 7), plan(2, 2, 1), planned(2, 2, 100, 8, 5, 4)};

  EXPECT_THAT(broken_deliberation_laws(log),
              ElementsAre(HasSubstr("changed its goal"), HasSubstr("ends before it starts")));
}

TEST(DeliberationLaws, ARepairNamesItsCause) {
  EXPECT_THAT(broken_deliberation_laws({decision(1, 1, "6 repair: shift", "")}),
              ElementsAre(HasSubstr("without cause")));
}

TEST(DeliberationLaws, NobodyFliesWithoutATaskUnlessItSaysSo) {
  Log log{degree(0, 4), task(1, 1, "goto", "started"), task(5, 1, "goto", "ended")};
  for (int second = 6; second < 20; ++second) log.push_back(flight(second, true));
  Log excused = log;
  excused.insert(excused.begin() + 3, of(5.5, "notice"));

  EXPECT_THAT(broken_deliberation_laws(log), ElementsAre(HasSubstr("flies without a task")));
  EXPECT_THAT(broken_deliberation_laws(excused), IsEmpty());
}

TEST(DeliberationLaws, BelowDegreeFourTheGroundMayLeaveItHovering) {
  Log log{degree(0, 3)};
  for (int second = 1; second < 20; ++second) log.push_back(flight(second, true));

  EXPECT_THAT(broken_deliberation_laws(log), IsEmpty());
}

}  // namespace
}  // namespace skein::testing
