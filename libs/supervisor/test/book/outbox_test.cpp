// SPDX-License-Identifier: Apache-2.0
// What others are told, and how often.
#include "book/outbox.hpp"

#include <gmock/gmock.h>

#include "testing/rooms.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::ElementsAre;
using ::testing::IsEmpty;

template <class One>
std::vector<One> of(const Effects& effects) {
  std::vector<One> result;
  for (const Effect& effect : effects) {
    if (const auto* one = std::get_if<One>(&effect)) result.push_back(*one);
  }
  return result;
}

TEST(Outbox, TellsOfAPlanOnlyWhenItIsAnother) {
  Rooms rooms;
  rooms.goals({701}).plan({TaskOf(100, "goto", 701)});

  EXPECT_EQ(of<PlanChanged>(rooms.out.close()).at(0).report.revision, 1U);
  EXPECT_THAT(of<PlanChanged>(rooms.out.close()), IsEmpty());

  rooms.book.withdraw({GoalId{701}});
  EXPECT_EQ(of<PlanChanged>(rooms.out.close()).at(0).report.revision, 2U);
}

TEST(Outbox, TellsAStateOnce) {
  Rooms rooms;
  rooms.goals({701});
  Goal& goal = rooms.book.goals.at(GoalId{701});

  rooms.out.set_state(goal, GoalState::kUnderWay);
  rooms.out.set_state(goal, GoalState::kUnderWay);

  EXPECT_EQ(of<GoalChanged>(rooms.out.close()).size(), 1U);
}

TEST(Outbox, AGoalThatIsSettledStaysAsItIs) {
  Rooms rooms;
  rooms.goals({701}).at(7);
  Goal& goal = rooms.book.goals.at(GoalId{701});

  rooms.out.set_state(goal, GoalState::kFailed, "no way");
  rooms.at(9).out.set_state(goal, GoalState::kAchieved);

  EXPECT_EQ(goal.state, GoalState::kFailed);
  EXPECT_EQ(goal.why, "no way");
  EXPECT_EQ(goal.settled, MissionTime::seconds(7));
}

TEST(Outbox, NumbersDecisionsAndSaysHowLongTheyTook) {
  Rooms rooms;
  rooms.at(5).out.decide({"6 repair", "wind", "plan", "none", MissionTime::seconds(2)});
  rooms.out.decide({"2 cancel", "user", "plan", "none", MissionTime::seconds(5)});

  const auto told = of<Decided>(rooms.out.close());
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].decision.number + 1, told[1].decision.number);
  EXPECT_EQ(told[0].decision.took, Duration::seconds(3));
}

TEST(Outbox, NamesTasksAndGoalsInReasons) {
  Rooms rooms;
  rooms.goals({701}).plan({TaskOf(100, "goto", 701)});

  EXPECT_EQ(rooms.out.in_words("task 100 late; goal 701 fails; goal 701 is over; task 9"),
            "the goto of goal 701 (go 1) late; goal 701 fails; goal 701 is over; task 9");
}

TEST(Outbox, ItsInstantNeverGoesBack) {
  Rooms rooms;
  rooms.at(5).at(3);
  EXPECT_EQ(rooms.out.now(), MissionTime::seconds(5));
}

}  // namespace
}  // namespace skein::supervisor
