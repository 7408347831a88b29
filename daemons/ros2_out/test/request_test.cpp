// SPDX-License-Identifier: Apache-2.0
// What a text of the topic skein/mission asks for.
#include <gtest/gtest.h>

#include "skein/ros2_out/ros2_out.hpp"

namespace skein::ros2_out {
namespace {

TEST(RosRequest, AListIsActions) {
  EXPECT_EQ(request_of("- abort: {uav: marvin}\n"), "- abort: {uav: marvin}\n");
  EXPECT_EQ(request_of(" [{finish: true}]"), " [{finish: true}]");
  EXPECT_EQ(request_of("# now\n- finish: true"), "# now\n- finish: true");
}

TEST(RosRequest, AnythingElseIsAMission) {
  EXPECT_EQ(request_of("uav: marvin\nid: 1"), "- mission:\n    uav: marvin\n    id: 1");
  EXPECT_EQ(request_of("{uav: marvin, id: 1}"), "- mission:\n    {uav: marvin, id: 1}");
}

}  // namespace
}  // namespace skein::ros2_out
