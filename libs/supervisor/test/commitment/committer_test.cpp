// SPDX-License-Identifier: Apache-2.0
// When high-level tasks go to the executive, and how they come back.
#include "commitment/committer.hpp"

#include <gmock/gmock.h>

#include "testing/rooms.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// 701 may start at once, 702 from 60 s on.
struct NowAndLater : Rooms {
  NowAndLater() {
    at(0).goals({701, 702});
    plan({TaskOf(100, "goto", 701), TaskOf(101, "goto", 702).after(100).starts_after(60)});
  }
};

TEST(Committer, GivesWhatMayStartWithinTheHorizon) {
  NowAndLater rooms;
  rooms.committer.commit();
  EXPECT_THAT(rooms.requests(), ElementsAre("START 100"));
  EXPECT_EQ(rooms.committer.next_to_give(), GoalId{702});
  EXPECT_EQ(rooms.committer.due(GoalId{702}), at(45));

  rooms.at(44).committer.commit();
  EXPECT_THAT(rooms.requests(), IsEmpty());
  rooms.at(45).committer.commit();
  EXPECT_THAT(rooms.requests(), ElementsAre("START 101"));
  EXPECT_FALSE(rooms.committer.next_to_give());
}

TEST(Committer, GivesNothingWhileThePlanIsToBeRepaired) {
  NowAndLater rooms;
  rooms.agenda.plan_anew(std::nullopt, false, "wind");
  rooms.committer.commit();
  EXPECT_THAT(rooms.requests(), IsEmpty());
  EXPECT_FALSE(rooms.committer.ever_gave());
}

TEST(Committer, TakesNothingEarlyFromAJobThatPlansIt) {
  NowAndLater rooms;
  Job job;
  job.mission = mission::MissionId{1};
  rooms.agenda.run(job, InsertionRequest{});
  EXPECT_EQ(rooms.committer.due(GoalId{702}), at(60));
}

TEST(Committer, WhatIsRetiredIsStoppedFromTheEnd) {
  NowAndLater rooms;
  rooms.gave({100, 101});
  rooms.committer.retire({GoalId{701}, GoalId{702}});
  EXPECT_THAT(rooms.requests(), ElementsAre("ABORT 101", "ABORT 100"));
  EXPECT_EQ(rooms.entry(100).stage(), Stage::kStopping);
}

TEST(Committer, OrdersEndTheWaitForThem) {
  Rooms rooms;
  rooms.at(0).goals({701, 702});
  rooms.plan({TaskOf(100, "wait", 701).until_orders(), TaskOf(101, "goto", 702).over(100)});
  rooms.committer.commit();
  EXPECT_THAT(rooms.requests(), ElementsAre("START 100"));
  EXPECT_FALSE(rooms.committer.due(GoalId{702}));

  rooms.at(2).started(100).committer.commit();

  EXPECT_THAT(rooms.requests(), ElementsAre("START 101", "ABORT 100"));
  EXPECT_TRUE(rooms.entry(100).ordered());
}

TEST(Committer, ASafeWaitEndsWhenWhatTheExecutiveHasMayBegin) {
  NowAndLater rooms;
  rooms.gave({100, 101}).started(100).ended(100);
  rooms.committer.start_safe_wait();
  rooms.committer.reschedule();
  ASSERT_TRUE(rooms.committer.end_of_safe_wait());
  EXPECT_LT(*rooms.committer.end_of_safe_wait(), at(60));
  EXPECT_GE(*rooms.committer.end_of_safe_wait(), at(55));
  rooms.requests();

  rooms.committer.stop_safe_waits();
  EXPECT_THAT(rooms.requests(), ElementsAre("ABORT 102"));
  rooms.committer.stop_safe_waits();
  EXPECT_THAT(rooms.requests(), IsEmpty());
}

TEST(Committer, WhatBeginsAfterAGoalThatIsToComeHasNoDate) {
  NowAndLater rooms;
  mission::GoalBound bound;
  bound.goal = GoalId{701};
  bound.least = Duration::seconds(10);
  rooms.book.goals.at(GoalId{702}).task.after = {bound};
  EXPECT_TRUE(rooms.committer.is_undated(GoalId{702}));

  rooms.book.goals.at(GoalId{701}).state = GoalState::kAchieved;
  EXPECT_FALSE(rooms.committer.is_undated(GoalId{702}));
}

// ---- joint tasks ----

/// 100 is asked for.
struct Asked : Rooms {
  Asked() {
    at(0).goals({701}).plan({TaskOf(100, "joint", 701)});
    gave({100});
    tasks().load(entry(100));
    out.close();
  }
  JointTasks& tasks() { return committer.joint_tasks(); }
  bool answered(bool loaded) {
    return tasks().answered({TaskId{100}, loaded, {secs(30), secs(40)}, "nobody is there"});
  }
};

TEST(JointTasks, ThatAreLoadedStartWhenItWasAgreed) {
  Asked rooms;
  EXPECT_TRUE(rooms.answered(true));
  EXPECT_EQ(rooms.entry(100).task.time.start_after, at(30));
  EXPECT_EQ(rooms.entry(100).task.time.start_before, at(40));

  rooms.tasks().due({TaskId{100}});
  EXPECT_THAT(rooms.requests(), IsEmpty());
}

TEST(JointTasks, ThatAreNotLoadedAreAbortedOnceTheyAreDue) {
  Asked rooms;
  EXPECT_FALSE(rooms.answered(false));
  EXPECT_THAT(rooms.requests(), IsEmpty());
  rooms.tasks().due({TaskId{100}});
  EXPECT_THAT(rooms.requests(), ElementsAre("STATUS 100"));
}

/// 100 is to start from 200 s on, long after the horizon.
struct PlannedJoint : Rooms {
  PlannedJoint() { at(0).goals({701}).plan({TaskOf(100, "joint:watch", 701).starts_after(200)}); }
  /// "100 from 200", "100 unwanted".
  std::vector<std::string> asked() {
    std::vector<std::string> all;
    committer.commit();
    for (const Effect& effect : out.close()) {
      const auto* load = std::get_if<LoadJointTask>(&effect);
      if (load == nullptr) continue;
      all.push_back(to_text(load->task.id) +
                    (load->preferences.empty()
                         ? " unwanted"
                         : " from " + to_text(load->preferences.front().least)));
    }
    return all;
  }
  void agreed(double when, double start) {
    at(when);
    committer.joint_tasks().answered({TaskId{100}, true, {secs(start), Duration::max()}, ""});
    dates.update(out.now());
  }
};

TEST(JointTasks, AreLoadedWhenTheyComeIntoThePlanLongBeforeTheyAreGiven) {
  PlannedJoint rooms;
  EXPECT_THAT(rooms.asked(), ElementsAre("100 from 200"));
  EXPECT_FALSE(rooms.entry(100).given());

  rooms.at(1);
  EXPECT_THAT(rooms.asked(), IsEmpty());
}

TEST(JointTasks, AreNegotiatedAgainWhenTheyCannotBeginAnyMoreWhenItWasAgreed) {
  PlannedJoint rooms;
  rooms.asked();
  rooms.agreed(1, 230);
  EXPECT_THAT(rooms.asked(), IsEmpty());

  rooms.at(2).entry(100).task.time.start_after = at(240);  // partners wait so long
  rooms.dates.update(at(2));
  EXPECT_THAT(rooms.asked(), IsEmpty());

  rooms.at(3).entry(100).task.time.start_after = at(260);
  rooms.dates.update(at(3));
  EXPECT_THAT(rooms.asked(), ElementsAre("100 from 260"));
}

// An earlier joint task was agreed on meanwhile, and lasts longer than had been thought.
TEST(JointTasks, AreAskedForAgainWhenTheyCannotBeginAnyMoreWhenItWasAskedFor) {
  PlannedJoint rooms;
  rooms.asked();
  rooms.at(2).entry(100).task.time.start_after = at(210);
  rooms.dates.update(at(2));
  EXPECT_THAT(rooms.asked(), IsEmpty());

  rooms.at(3).entry(100).task.time.start_after = at(260);
  rooms.dates.update(at(3));
  EXPECT_THAT(rooms.asked(), ElementsAre("100 from 260"));
  EXPECT_THAT(rooms.asked(), IsEmpty());
}

TEST(JointTasks, ThatLeaveThePlanAreNotWantedAnyMore) {
  PlannedJoint rooms;
  rooms.asked();
  rooms.at(1).book.withdraw({GoalId{701}});

  EXPECT_THAT(rooms.asked(), ElementsAre("100 unwanted"));
  rooms.at(2);
  EXPECT_THAT(rooms.asked(), IsEmpty());
}

TEST(JointTasks, ThatAreDueBeforeTheAnswerWaitForIt) {
  Asked rooms;
  rooms.tasks().due({TaskId{100}});
  EXPECT_THAT(rooms.requests(), IsEmpty());
  EXPECT_FALSE(rooms.answered(false));
  EXPECT_THAT(rooms.requests(), ElementsAre("STATUS 100"));
}

TEST(JointTasks, ThatNobodyKnowsAreAborted) {
  Asked rooms;
  rooms.tasks().due({TaskId{7}});
  EXPECT_THAT(rooms.requests(), ElementsAre("STATUS 7"));
}

}  // namespace
}  // namespace skein::supervisor
