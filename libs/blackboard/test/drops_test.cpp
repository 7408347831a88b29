// SPDX-License-Identifier: Apache-2.0
#include "drops.hpp"

#include <gtest/gtest.h>

namespace skein::blackboard {
namespace {

const wire::Violation kViolation{"tasks[12].state", "no such state"};

Dropped dropped(Drops& drops, std::uint32_t origin, const wire::Violation& violation = kViolation,
                wire::Slot slot = wire::Slot::kPlanBoard) {
  wire::SampleHeader header;
  header.origin = origin;
  std::vector<Incoming> out;
  drops.tell(slot, header, violation, out);
  EXPECT_EQ(out.size(), 1U);
  return std::get<Dropped>(out.at(0));
}

TEST(Drops, SayWhatIsWrongWithWhoseSample) {
  Drops drops;
  const Dropped first = dropped(drops, 3);

  EXPECT_EQ(first.slot, wire::Slot::kPlanBoard);
  EXPECT_EQ(first.origin, NodeNumber(3));
  EXPECT_EQ(first.field, "tasks[12].state");
  EXPECT_EQ(first.why, "no such state");
  EXPECT_TRUE(first.first);
}

TEST(Drops, OfOneKindAreLoggedTheFirstTimeAndTheTenthWhicheverElementItWas) {
  Drops drops;
  EXPECT_TRUE(dropped(drops, 3).first);
  for (int times = 2; times < 10; ++times)
    EXPECT_FALSE(dropped(drops, 3, {"tasks[7].state", "no such state"}).first) << times;

  EXPECT_EQ(dropped(drops, 3).why, "no such state (10 times)");
}

TEST(Drops, OfAnotherOriginSlotOrFieldAreAnotherKind) {
  Drops drops;
  dropped(drops, 3);

  EXPECT_TRUE(dropped(drops, 4).first);
  EXPECT_TRUE(dropped(drops, 3, kViolation, wire::Slot::kTaskEvent).first);
  EXPECT_TRUE(dropped(drops, 3, {"tasks[12].id", "none"}).first);
  EXPECT_FALSE(dropped(drops, 3).first);
}

}  // namespace
}  // namespace skein::blackboard
