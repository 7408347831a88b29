// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/lost_uav.hpp"

#include <gtest/gtest.h>

namespace skein::mission {
namespace {

TEST(LostUav, IsReadFromItsMessage) { EXPECT_EQ(uav_lost_in(lost_message("heliv")), "heliv"); }

TEST(LostUav, IsInNoOtherMessage) {
  for (const char* other : {"lost", "lost ", "heliv lost", "lostheliv", "member lost", ""})
    EXPECT_FALSE(uav_lost_in(other)) << other;
}

}  // namespace
}  // namespace skein::mission
