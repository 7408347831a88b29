// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/lost_uav.hpp"

#include <gtest/gtest.h>

namespace skein::mission {
namespace {

TEST(LostUav, IsReadFromItsMessage) { EXPECT_EQ(uav_lost_in(lost_message("heliv")), "heliv"); }

TEST(LostUav, IsInNoOtherMessage) {
  for (const char* other :
       {"lost", "lost ", "heliv lost", "lostheliv", "member lost", "found heliv", ""})
    EXPECT_FALSE(uav_lost_in(other)) << other;
}

TEST(FoundUav, IsReadFromItsMessageAlone) {
  EXPECT_EQ(uav_found_in(found_message("heliv")), "heliv");
  for (const char* other : {"found", "found ", "lost heliv", "foundheliv", ""})
    EXPECT_FALSE(uav_found_in(other)) << other;
}

}  // namespace
}  // namespace skein::mission
