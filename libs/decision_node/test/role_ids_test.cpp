// SPDX-License-Identifier: Apache-2.0
#include "role_ids.hpp"

#include <gtest/gtest.h>

namespace skein::decision_node {
namespace {

using functional::TaskId;

TEST(RoleIds, AreThoseBetweenThePlansAndTheNodesOwn) {
  EXPECT_FALSE(is_of_role(TaskId{12}));
  EXPECT_TRUE(is_of_role(functional::kFirstPlayedId));
  EXPECT_TRUE(is_of_role(functional::kFirstRoleId));
  EXPECT_FALSE(is_of_role(functional::kFirstOwnId));
  EXPECT_FALSE(is_of_role(functional::kFirstAsideId));
  EXPECT_FALSE(is_of_role(functional::kFirstBackgroundId));
}

}  // namespace
}  // namespace skein::decision_node
