// SPDX-License-Identifier: Apache-2.0
// Whether a result is still of use when it comes.
#include "jobs/premises.hpp"

#include <gmock/gmock.h>

#include <memory>

#include "testing/rooms.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// 701 is with the executive, 702 is planned.
struct Begun : Rooms {
  Begun() {
    goals({701, 702});
    plan({TaskOf(100, "takeoff", 701), TaskOf(101, "goto", 701).after(100),
          TaskOf(102, "goto", 702).after(101)});
    gave({100, 101});
  }
  Premises now() const { return premises_of(book, beliefs); }
  bool still(const Premises& then) const { return hold(then, now(), book); }
};

TEST(Premises, AreWhatStandsAndWhatIsFree) {
  const Begun rooms;
  EXPECT_EQ(rooms.now().standing, tasks_of({100, 101}));
  EXPECT_EQ(rooms.now().goals, goal_ids({702}));
}

TEST(Premises, HoldWhenWhatStoodHasEndedWell) {
  Begun rooms;
  const Premises then = rooms.now();
  rooms.started(100).ended(100);
  EXPECT_TRUE(rooms.still(then));
}

TEST(Premises, BreakWhenWhatStoodWasLost) {
  Begun rooms;
  const Premises then = rooms.now();
  rooms.started(100).lost(100);
  EXPECT_FALSE(rooms.still(then));
}

TEST(Premises, BreakWhenMoreIsGiven) {
  Begun rooms;
  const Premises then = rooms.now();
  rooms.gave({102});
  EXPECT_FALSE(rooms.still(then));
}

TEST(Premises, BreakWhenANumberWasUsed) {
  Begun rooms;
  const Premises then = rooms.now();
  rooms.book.add_loose("wait");
  EXPECT_FALSE(rooms.still(then));
}

TEST(Premises, BreakWithTheWorldAndWithDevices) {
  Begun rooms;
  const Premises before = rooms.now();
  mission::ChangeWorld change;
  change.place = mission::KnownPlace{"P", {1, 2, 3}, 0, std::nullopt};
  rooms.beliefs.learn(change);
  EXPECT_FALSE(rooms.still(before));

  const Premises then = rooms.now();
  rooms.beliefs.see(rooms.beliefs.vehicle(), {"camera"}, at(0));
  EXPECT_FALSE(rooms.still(then));
}

TEST(Premises, OfOneThatNothingMovesBreakWhenItIsMovedAway) {
  Rooms rooms;
  rooms.goals({701}).flies({0, 0, 40});
  const Premises then = premises_of(rooms.book, rooms.beliefs);

  rooms.flies({24, 0, 40});
  EXPECT_TRUE(hold(then, premises_of(rooms.book, rooms.beliefs), rooms.book));
  rooms.flies({26, 0, 40});
  EXPECT_FALSE(hold(then, premises_of(rooms.book, rooms.beliefs), rooms.book));
}

// Found over DDS, where a job takes its time: a plane that waited in the air for its plan was never
// where the plan had begun, and the plan was made again 285 times.
TEST(Premises, OfOneThatCirclesHoldAllAroundItsCircle) {
  Config config = config_for_tests();
  auto knowledge = std::make_shared<Knowledge>(*config.knowledge);
  knowledge->vehicle.hovers = false;
  knowledge->vehicle.orbit_radius = 40;
  config.knowledge = knowledge;
  Rooms rooms(config);
  rooms.goals({701}).flies({0, 0, 40});
  const Premises then = premises_of(rooms.book, rooms.beliefs);

  rooms.flies({80, 0, 40});
  EXPECT_TRUE(hold(then, premises_of(rooms.book, rooms.beliefs), rooms.book));
  rooms.flies({110, 0, 40});
  EXPECT_FALSE(hold(then, premises_of(rooms.book, rooms.beliefs), rooms.book));
}

TEST(Premises, AnUrgentMissionInterruptsWhatIsInHandButNoTakeoff) {
  Begun rooms;
  EXPECT_THAT(urgently_interrupted(rooms.book), ElementsAre(TaskId{100}, TaskId{101}));

  rooms.started(100);
  EXPECT_THAT(urgently_interrupted(rooms.book), IsEmpty());
}

TEST(Premises, WhatTheGroundDecidesOnIsNotInterrupted) {
  Begun rooms;
  rooms.book.goals.at(GoalId{701}).state = GoalState::kHandedOver;
  EXPECT_THAT(urgently_interrupted(rooms.book), IsEmpty());
}

TEST(Premises, WhatIsInterruptedIsPlannedAnewWithTheRest) {
  const Begun rooms;
  const Premises premises =
      premises_of(rooms.book, rooms.beliefs, urgently_interrupted(rooms.book));
  EXPECT_THAT(premises.standing, IsEmpty());
  EXPECT_EQ(premises.goals, goal_ids({701, 702}));
}

}  // namespace
}  // namespace skein::supervisor
