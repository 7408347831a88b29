// SPDX-License-Identifier: Apache-2.0
#include "story/deliberation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "page/views.hpp"
#include "plan_builders.hpp"
#include "skein/report/report.hpp"

namespace skein::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::Pair;

TEST(Deliberation, APromiseIsThatOfTheLastPlanBeforeTheTaskStarted) {
  const Journal journal = testing::deliberated();

  const Deliberation told = tell_deliberation(journal);

  const Promise& flown = told.promises.at({"karma", 101});
  EXPECT_EQ(flown.planned->revision, 1U);
  EXPECT_EQ(flown.started, 5.0);
  EXPECT_EQ(flown.over, 40.0);
  EXPECT_EQ(flown.outcome, "ended");
}

TEST(Deliberation, ATaskThatNeverStartedHasItsLastPlan) {
  Journal journal = testing::deliberated();
  journal.planned.push_back(testing::planned(40, 3, 102, 702, 45, 75));

  const Deliberation told = tell_deliberation(journal);

  EXPECT_EQ(told.promises.at({"karma", 102}).planned->revision, 3U);
  EXPECT_FALSE(told.promises.at({"karma", 102}).started.has_value());
}

TEST(Deliberation, TasksThatNoPlanEverHeldAreNotPromised) {
  Journal journal = testing::deliberated();
  journal.tasks.push_back(testing::task(50, "karma", 900, TaskState::kStarted));

  EXPECT_FALSE(tell_deliberation(journal).promises.contains({"karma", 900}));
}

TEST(Deliberation, AGoalTellsItsCourseAndTheLastReasonGiven) {
  const Journal journal = testing::deliberated();

  const Deliberation told = tell_deliberation(journal);

  ASSERT_EQ(told.goals.size(), 2U);
  EXPECT_THAT(told.goals[0].states, ElementsAre(Pair(1, "received"), Pair(2, "planned"),
                                                Pair(5, "under-way"), Pair(40, "achieved")));
  EXPECT_EQ(told.goal("karma", 702)->why, "no way to Z");
  EXPECT_EQ(told.goal("marvin", 702), nullptr);
}

TEST(DeliberationPage, ShowsGoalsDecisionsAndTasksPlannedAgainstDone) {
  const std::string page = html_report({}, testing::deliberated());

  EXPECT_THAT(page, HasSubstr("High-level tasks"));
  EXPECT_THAT(page, HasSubstr("6 repair: drop"));
  EXPECT_THAT(page, HasSubstr("Elementary tasks of karma"));
  EXPECT_THAT(page, HasSubstr("(10.0 late)"));  // ends at 40, at the latest 30 was planned
  EXPECT_THAT(page, HasSubstr("class=\"promise\""));
  EXPECT_THAT(page, HasSubstr("class=\"certain\""));
}

TEST(DeliberationPage, DrawsWaysThatWerePlannedAndMarksThoseNeverFlown) {
  const std::string page = html_report({}, testing::deliberated());

  EXPECT_EQ(testing::count(page, "class=\"planned u0\" d=\"M"), 1U);
  EXPECT_EQ(testing::count(page, "class=\"planned never u0\" d=\"M"), 1U);
}

TEST(DeliberationPage, SaysNothingWhereNothingWasPlanned) {
  Journal journal;
  journal.telemetry = {testing::telemetry(0, "a", {0, 0, 0}),
                       testing::telemetry(9, "a", {9, 0, 0})};

  const std::string page = html_report({}, journal);

  EXPECT_THAT(page, Not(HasSubstr("High-level tasks")));
  EXPECT_THAT(page, Not(HasSubstr("Decisions: why")));
  EXPECT_THAT(page, Not(HasSubstr("Elementary tasks of")));
}

TEST(DeliberationRecords, AreReadWithTheirOptionalFields) {
  const auto read = testing::salvage(
      R"({"at":2,"node":"karma","kind":"goal","uav":"karma","goal":701,"mission":7,"statement":"s","state":"planned","asked_by":"op"}
{"at":2,"node":"karma","kind":"plan","uav":"karma","revision":1,"tasks":1,"goals":1}
{"at":2,"node":"karma","kind":"planned","uav":"karma","revision":1,"task":100,"type":"goto","goal":701,"earliest_start":1,"earliest_end":2.5,"after":"","methods":"m","committed":true,"way":[0,0,1,2,2,3]}
{"at":2,"node":"karma","kind":"decision","uav":"karma","number":1,"operator":"1 insert","cause":"c","inputs":"i","outcome":"o","took":0.05})");

  EXPECT_THAT(to_text(read.errors), IsEmpty());
  ASSERT_EQ(read.journal.planned.size(), 1U);
  EXPECT_FALSE(read.journal.planned[0].latest_start.has_value());
  EXPECT_THAT(read.journal.planned[0].way, ElementsAre(Position{0, 0, 1}, Position{2, 2, 3}));
  EXPECT_EQ(read.journal.goals[0].asked_by, "op");
  EXPECT_EQ(read.journal.decisions[0].took, 0.05);
}

TEST(DeliberationRecords, EveryFaultOfALineIsTold) {
  const auto read = testing::salvage(
      R"({"at":2,"node":"karma","kind":"planned","uav":"karma","revision":1,"task":"x","type":"goto","goal":701,"earliest_start":1,"latest_start":"soon","earliest_end":2.5,"after":"","methods":"m","committed":true,"way":[0,0]})");

  EXPECT_EQ(read.errors.size(), 3U);
  EXPECT_THAT(read.journal.planned, IsEmpty());
}

}  // namespace
}  // namespace skein::report
