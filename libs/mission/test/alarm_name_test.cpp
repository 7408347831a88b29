// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/alarm_name.hpp"

#include <gtest/gtest.h>

namespace skein::mission {
namespace {

TEST(AlarmName, IsKnownAgain) {
  EXPECT_EQ(name_of_alarm(12), "alarm:12");
  EXPECT_TRUE(is_name_of_alarm(name_of_alarm(12)));
}

TEST(AlarmName, IsNothingElse) {
  for (const char* other : {"", "alarm", "alarm:", "alarm:x", "alarm:1b", "alarms:1", " alarm:1"})
    EXPECT_FALSE(is_name_of_alarm(other)) << other;
}

}  // namespace
}  // namespace skein::mission
