// SPDX-License-Identifier: Apache-2.0
// What was promised of dates, and what slips.
#include "schedule/dates.hpp"

#include <gmock/gmock.h>

#include "testing/rooms.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// From 0 s on: 100 takes 10 to 20 s, then 101 likewise.
struct TwoTasks : Rooms {
  TwoTasks() {
    at(0).goals({701, 702});
    plan({TaskOf(100, "goto", 701), TaskOf(101, "goto", 702).after(100)});
  }
  std::string slips_at(double s) {
    at(s);
    return dates.slips(out.now()).what;
  }
};

TEST(Dates, SayWhenThePlanEnds) {
  TwoTasks rooms;
  EXPECT_EQ(rooms.dates.extent(), "ends between 20 s and 40 s");

  rooms.plan({TaskOf(102, "wait", 702).after(101).until_orders()});
  EXPECT_EQ(rooms.dates.extent(), "ends from 20 s on");
}

TEST(Dates, PromisesHoldAsLongAsNothingComesLater) {
  TwoTasks rooms;
  rooms.gave({100}).started(100);
  EXPECT_TRUE(rooms.dates.keeps_promises(Duration()));

  rooms.at(15).dates.update(rooms.out.now());
  EXPECT_TRUE(rooms.dates.keeps_promises(Duration()));
  rooms.at(23).dates.update(rooms.out.now());
  EXPECT_FALSE(rooms.dates.keeps_promises(Duration()));
}

TEST(Dates, WhatIsPromisedAnewHolds) {
  TwoTasks rooms;
  rooms.gave({100}).started(100).at(23).dates.update(at(23));
  rooms.dates.promise();
  EXPECT_TRUE(rooms.dates.keeps_promises(Duration()));
}

TEST(Dates, ATaskThatTakesTooLongIsToldOnceAfterSomeGrace) {
  TwoTasks rooms;
  rooms.gave({100}).started(100);
  EXPECT_EQ(rooms.dates.next_slip(at(0)), at(21));

  EXPECT_EQ(rooms.slips_at(20.5), "");
  EXPECT_EQ(rooms.slips_at(21), "task 100 overdue by 1 s");
  EXPECT_EQ(rooms.slips_at(22), "");
}

TEST(Dates, ATaskThatDoesNotStartIsToldOnceUnlessItIsPromisedAnew) {
  TwoTasks rooms;
  rooms.gave({100});
  const Dates::Slips slips = rooms.at(3).dates.slips(at(3));
  EXPECT_EQ(slips.what, "task 100 late by 3 s");
  EXPECT_THAT(slips.late, ElementsAre(TaskId{100}));

  rooms.dates.promise();
  EXPECT_NE(rooms.dates.slips(at(3)).what, "");
  rooms.dates.promise();
  rooms.dates.keep_told(slips.late);
  EXPECT_EQ(rooms.dates.slips(at(3)).what, "");
}

TEST(Dates, WhatStartsLateBecauseAnotherIsOverdueIsNotBlamed) {
  TwoTasks rooms;
  rooms.gave({100}).started(100);
  const Dates::Slips slips = rooms.at(30).dates.slips(at(30));
  EXPECT_EQ(slips.what, "task 100 overdue by 10 s");
  EXPECT_THAT(slips.late, IsEmpty());
}

TEST(Dates, APlanFitsOrTheNetworkIsMadeAnew) {
  TwoTasks rooms;
  const auto at_once = TaskOf(102, "goto", 702).ends_before(5);
  EXPECT_FALSE(rooms.dates.fits(plan_of({at_once}), {}, at(0)));
  EXPECT_TRUE(rooms.dates.fits(plan_of({TaskOf(102, "goto", 702).ends_before(25)}), {}, at(0)));
}

TEST(Dates, AHoldOnWhatTheExecutiveDoesNotKnowHasNoDateYet) {
  Rooms rooms;
  // 101 must start while 100 runs, and waits for 102, of 10 to 100 s: 100 is held back.
  rooms.at(0).goals({701, 702});
  rooms.plan({TaskOf(102, "relay", 702).takes(10, 100), TaskOf(103, "wait", 701).takes(20, 20),
              TaskOf(104, "takeshot", 701).during(103).after(102).takes(5, 5)});

  ASSERT_EQ(rooms.dates.schedule().holds.count(TaskId{103}), 1U);
  EXPECT_THAT(rooms.dates.holds_of(TaskId{103}), ElementsAre(Hold{TaskId(), MissionTime::max()}));

  rooms.gave({102});
  EXPECT_EQ(rooms.dates.holds_of(TaskId{103}), rooms.dates.schedule().holds.at(TaskId{103}));
}

}  // namespace
}  // namespace skein::supervisor
