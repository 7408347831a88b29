// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/lateness.hpp"

#include <gtest/gtest.h>

#include "testing/road_team.hpp"

namespace skein::auction {
namespace {

TEST(Lateness, IsThatOfWhoeverBeginsNowOrWhenItMay) {
  const Task task = a_task(1).lasting(20).by(120);
  EXPECT_FALSE(is_too_late(task, at(100)));
  EXPECT_TRUE(is_too_late(task, at(100.5)));
  EXPECT_FALSE(is_too_late(a_task(1).lasting(20), at(1e6))) << "it has no deadline";

  // That what comes before it ended late has left it this window.
  const Task closed = a_task(1).lasting(20).from(110).by(120);
  EXPECT_TRUE(is_too_late(closed, at(0)));
}

TEST(Lateness, SaysTheWindow) {
  EXPECT_EQ(
      why_too_late(a_task(1).lasting(20).by(120)),
      "nobody can do it in time any more: its deadline is 120 s, and it had to begin by 100 s");
  EXPECT_EQ(
      why_too_late(a_task(1).lasting(20).from(110).by(120)),
      "nobody can do it in time any more: its deadline is 120 s, and it had to begin by 100 s, "
      "not before 110 s");
}

}  // namespace
}  // namespace skein::auction
