// SPDX-License-Identifier: Apache-2.0
// A vehicle that refuses again and again is asked more and more seldom, and its goals end.
#include "watch/refusals.hpp"
#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// ---- counting ----

TEST(Refusals, CountWhatIsRefusedInTheSameWordsButForFigures) {
  Refusals refusals;

  EXPECT_EQ(refusals.count("goto", "it takes 12.5 kJ, 3 kJ are left", at(1)), 1);
  EXPECT_EQ(refusals.count("goto", "it takes 14 kJ, 2.5 kJ are left", at(2)), 2);
  EXPECT_EQ(refusals.count("goto", "engine failure", at(3)), 1);
  EXPECT_EQ(refusals.count("land", "it takes 12.5 kJ, 3 kJ are left", at(3)), 1);
}

TEST(Refusals, ArePastOnceOneOfTheTypeIsDone) {
  Refusals refusals;
  refusals.count("goto", "no", at(1));
  refusals.count("land", "no", at(1));

  refusals.did("goto");

  EXPECT_EQ(refusals.count("goto", "no", at(2)), 1);
  EXPECT_EQ(refusals.count("land", "no", at(2)), 2);
}

TEST(Refusals, ArePastAfterALongTime) {
  Refusals refusals;
  refusals.count("goto", "no", at(1));
  refusals.count("goto", "no", at(120));

  EXPECT_EQ(refusals.count("goto", "no", at(240)), 3);
  EXPECT_EQ(refusals.count("goto", "no", at(600)), 1);
}

TEST(Refusals, AreFollowedByPausesThatGrowUpToAMinute) {
  std::vector<Duration> pauses;
  for (int times = 1; times <= 7; ++times) pauses.push_back(pause_after(times));

  EXPECT_THAT(pauses,
              ElementsAre(secs(0), secs(5), secs(10), secs(20), secs(40), secs(60), secs(60)));
  EXPECT_EQ(pause_after(1000), secs(60));
}

// ---- the supervisor ----

/// A goto that the vehicle refuses whenever it is asked for, planned again each time.
class Refused {
 public:
  explicit Refused(Config config = config_for_tests()) : desk(Desk::engaged(std::move(config))) {
    desk.flies();
    desk.add(a_mission(1, {701, 702}));
    desk.finish(inserted({701, 702}, plan()));
  }

  /// The goto is asked for and refused.
  void refuse() { desk.aborted(next_ - 2, "the way meets the ground at (12, 40)"); }
  /// The executive begins with it, and the vehicle refuses it.
  void begin_and_refuse() {
    desk.seen(next_ - 2, TaskState::kStarted);
    refuse();
  }
  /// What is planned from now on comes after the task that was refused last.
  void plan_behind_what_was_lost() { behind_ = true; }
  /// It is given up for want of air that others have, `times` times. Whether it was then planned
  /// again each time.
  bool lacks_air(int times, const std::vector<std::string>& others) {
    for (int i = 0; i < times; ++i) {
      const std::string& other = others[static_cast<std::size_t>(i) % others.size()];
      desk.at(360 * i);
      desk.aborted(next_ - 2, "it waits for " + other + " to leave", executive::AbortCause::kNoAir);
      if (!desk.job_started()) desk.at(360 * i + 60).give(Tick{});
      if (!desk.repair().refine_failed) return false;
      plan_again();
    }
    return true;
  }
  void plan_again() { desk.finish(repaired(RepairStep::kRefine, {701, 702}, plan())); }

  Desk desk;

 private:
  std::vector<mission::ElementaryTask> plan() {
    next_ = std::max<std::uint64_t>(next_ + 50, 100);
    const std::uint64_t lost = next_ - 52, first = next_;
    next_ += 2;
    const TaskOf then = TaskOf(first + 1, "goto", 702).after(first);
    if (behind_) return {TaskOf(first, "goto", 701).over(lost), then};
    return {TaskOf(first, "goto", 701), then};
  }
  std::uint64_t next_ = 0;
  bool behind_ = false;
};

TEST(SupervisorRefusals, TheFirstIsPlannedAgainAtOnce) {
  Refused one;

  one.refuse();

  EXPECT_TRUE(one.desk.job_started());
}

executive::Reply no_new_preconditions_for(std::uint64_t task) {
  return {executive::RequestKind::kUpdateConditions, TaskId{task}, false,
          "task " + std::to_string(task) + " is started: its preconditions no longer matter"};
}

TEST(SupervisorRefusals, OfNewPreconditionsDoNotMatterOnceTheTaskHasBegun) {
  Desk begun = Desk::engaged(), waiting = Desk::engaged();
  for (Desk* desk : {&begun, &waiting}) {
    desk->flies();
    desk->add(a_mission(1, {701}));
    desk->finish(inserted({701}, {TaskOf(100, "goto", 701).takes(10, 20)}));
  }
  begun.seen(100, TaskState::kStarted);

  begun.give(RequestAnswered{no_new_preconditions_for(100)});
  waiting.give(RequestAnswered{no_new_preconditions_for(100)});

  EXPECT_FALSE(begun.job_started());
  EXPECT_THAT(begun.requests(), ::testing::IsEmpty());
  EXPECT_TRUE(waiting.job_started());
}

TEST(SupervisorRefusals, ForWantOfAirItGoesBehindTheOthers) {
  Refused one;
  one.desk.aborted(100, "it waits for uav2 to leave", executive::AbortCause::kNoAir);

  ASSERT_TRUE(one.desk.job_started());
  EXPECT_EQ(one.desk.repair().failed->id, GoalId{701});
  EXPECT_TRUE(one.desk.repair().failed_goes_behind);
}

// Found by random missions (--sweepers --clean 993023): of three that swept the same air one after
// the other, the last failed 80 s before it was its turn.
TEST(SupervisorRefusals, ForWantOfAirThatOthersHaveThanBeforeDoNotCount) {
  Refused moves, stands;

  EXPECT_TRUE(moves.lacks_air(6, {"uav2", "uav3"}));
  EXPECT_FALSE(stands.lacks_air(6, {"uav2"}));
}

TEST(SupervisorRefusals, WordsDoNotMakeItOneForWantOfAir) {
  Refused one;
  one.desk.aborted(100, "others leave it no air: it waits for uav2 to leave");

  EXPECT_FALSE(one.desk.repair().failed_goes_behind);
}

TEST(SupervisorRefusals, ForOtherReasonsItKeepsItsTurn) {
  Refused one;
  one.refuse();

  EXPECT_FALSE(one.desk.repair().failed_goes_behind);
}

TEST(SupervisorRefusals, TheSecondAlikeAfterAPauseThatIsSaidByName) {
  Refused one;
  one.refuse();
  one.plan_again();

  one.desk.at(3);
  one.refuse();

  EXPECT_FALSE(one.desk.job_started());
  EXPECT_THAT(one.desk.notices(),
              Contains("goal 701 (go 1): its goto was refused 2 times alike (the way meets the "
                       "ground at (12, 40)); it is planned again in 5 s"));
  EXPECT_EQ(one.desk.supervisor.next_wakeup(), at(8));
  one.desk.at(7.9).give(Tick{});
  EXPECT_FALSE(one.desk.job_started());
  one.desk.at(8).give(Tick{});
  EXPECT_TRUE(one.desk.job_started());
}

// Found by a storm (karma/detection, seed 967): a vehicle that aborts each goto at once was asked
// six times a second.
TEST(SupervisorRefusals, CountTooWhenItWasPlannedBehindWhatWasRefusedBefore) {
  Refused one;
  one.begin_and_refuse();
  one.plan_behind_what_was_lost();
  one.plan_again();

  one.begin_and_refuse();

  EXPECT_FALSE(one.desk.job_started());
  EXPECT_THAT(one.desk.notices(), Contains(HasSubstr("was refused 2 times alike")));
}

TEST(SupervisorRefusals, ThePauseIsSpentInSafeModeAndEndsWithANewMission) {
  Refused one;
  one.refuse();
  one.plan_again();
  one.refuse();
  EXPECT_THAT(one.desk.notices(), Contains(HasSubstr("waits in safe mode")));

  one.desk.at(1).add(a_mission(2, {801}));

  EXPECT_TRUE(one.desk.job_started());
  EXPECT_EQ(one.desk.repair().failed->id, GoalId{701});
}

TEST(SupervisorRefusals, TheGoalFailsInTheEndAndItsReasonIsTheRefusal) {
  Refused one;
  for (double s = 0; s < 40; s += 10) {
    one.desk.at(s);
    one.refuse();
    if (!one.desk.job_started()) one.desk.at(s + 9).give(Tick{});
    if (!one.desk.repair().refine_failed) break;
    one.plan_again();
  }
  ASSERT_FALSE(one.desk.repair().refine_failed);

  RepairOutcome dropped = repaired(RepairStep::kDrop, {702}, {TaskOf(900, "goto", 702)});
  dropped.dropped.push_back({GoalId{701}, "failed, and was refined often enough"});
  one.desk.finish(dropped);

  EXPECT_EQ(one.desk.state_of(701), "failed");
  EXPECT_THAT(one.desk.why_of(701), HasSubstr("the way meets the ground at (12, 40)"));
  EXPECT_THAT(one.desk.why_of(701), HasSubstr("(3 times alike)"));
  EXPECT_EQ(one.desk.state_of(702), "planned");
}

TEST(SupervisorRefusals, OfASafeWaitAreRepeatedMoreAndMoreSeldom) {
  Desk desk = flying();
  desk.give(CancelMission{{}, "operator"});
  std::vector<Duration> pauses;
  desk.at(5);
  for (std::uint64_t id = 103; id < 108; ++id) {
    desk.seen(id, TaskState::kAborted, "energy too low for the wait", "wait");
    const auto again = desk.supervisor.next_wakeup();
    ASSERT_TRUE(again.has_value());
    pauses.push_back(*again - desk.now);
    desk.now = *again;
    desk.give(Tick{});
    EXPECT_THAT(desk.requests(), ElementsAre("START " + std::to_string(id + 1)));
  }

  EXPECT_THAT(pauses, ElementsAre(secs(5), secs(5), secs(10), secs(20), secs(40)));
}

// A plan that comes and is refused, too, is no reason to ask for a safe wait sooner.
TEST(SupervisorRefusals, OfASafeWaitAreRememberedOverWhatIsGivenMeanwhile) {
  Refused one;
  one.refuse();
  const std::uint64_t wait = 102;
  EXPECT_THAT(one.desk.requests(), Contains("START " + std::to_string(wait)));
  one.desk.seen(wait, TaskState::kAborted, "no", "wait");
  one.plan_again();

  one.desk.at(1);
  one.refuse();

  EXPECT_THAT(one.desk.requests(), Not(Contains(HasSubstr("START"))));
  EXPECT_THAT(one.desk.notices(), Contains(HasSubstr("its safe wait was refused")));
}

}  // namespace
}  // namespace skein::supervisor
