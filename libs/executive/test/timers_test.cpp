// SPDX-License-Identifier: Apache-2.0
// Timers, without an executive.
#include "timers.hpp"

#include <gtest/gtest.h>

namespace skein::executive {
namespace {

constexpr TaskId kOne{1}, kTwo{2};

Timer at(int second, TaskId id, Timer::Kind kind = Timer::Kind::kTimeout) {
  return Timer{MissionTime::seconds(second), kind, id};
}

TEST(Timers, TheEarliestExpiresFirst) {
  Timers timers;
  EXPECT_FALSE(timers.next());
  timers.set(at(9, kOne));
  timers.set(at(5, kTwo));

  EXPECT_EQ(timers.next(), MissionTime::seconds(5));
  EXPECT_EQ(timers.take(), at(5, kTwo));
  EXPECT_EQ(timers.take(), at(9, kOne));
  EXPECT_FALSE(timers.next());
}

TEST(Timers, OfOneInstantExpireByTheirKindsThenByTheirTasks) {
  Timers timers;
  timers.set(at(5, kOne, Timer::Kind::kSyncAgain));
  timers.set(at(5, TaskId{4}));
  timers.set(at(5, TaskId{3}));
  timers.set(at(5, kTwo, Timer::Kind::kUrgentWait));

  EXPECT_EQ(timers.take().id, kTwo);
  EXPECT_EQ(timers.take().id, TaskId{3});
  EXPECT_EQ(timers.take().id, TaskId{4});
  EXPECT_EQ(timers.take().id, kOne);
}

TEST(Timers, AnotherOneOfATaskVoidsTheFormerWhicheverIsEarlier) {
  Timers later, earlier;
  later.set(at(5, kOne));
  later.set(at(9, kOne));
  earlier.set(at(9, kOne));
  earlier.set(at(5, kOne));

  EXPECT_EQ(later.next(), MissionTime::seconds(9));
  later.take();
  EXPECT_FALSE(later.next());
  EXPECT_EQ(earlier.next(), MissionTime::seconds(5));
  earlier.take();
  EXPECT_FALSE(earlier.next());
}

TEST(Timers, OfAnotherKindForTheSameInstantVoidsTheFormerToo) {
  Timers timers;
  timers.set(at(5, kOne, Timer::Kind::kUrgentWait));
  timers.set(at(5, kOne, Timer::Kind::kTimeout));

  EXPECT_EQ(timers.take().kind, Timer::Kind::kTimeout);
  EXPECT_FALSE(timers.next());
}

TEST(Timers, ThatAreDroppedDoNotExpireButThoseOfOthersDo) {
  Timers timers;
  timers.set(at(5, kOne));
  timers.set(at(6, kTwo));
  timers.drop(kOne);
  timers.drop(TaskId{3});

  EXPECT_EQ(timers.next(), MissionTime::seconds(6));
  timers.set(at(7, kOne));
  EXPECT_EQ(timers.take(), at(6, kTwo));
  EXPECT_EQ(timers.take(), at(7, kOne));
  EXPECT_FALSE(timers.next());
}

TEST(Timers, SetTwiceExpireOnce) {
  Timers timers;
  timers.set(at(5, kOne));
  timers.set(at(5, kOne));

  timers.take();
  EXPECT_FALSE(timers.next());
}

}  // namespace
}  // namespace skein::executive
