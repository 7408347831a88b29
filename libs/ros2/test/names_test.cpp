// SPDX-License-Identifier: Apache-2.0
#include "skein/ros2/names.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <regex>

#include "skein/ros2/messages.hpp"

namespace skein::ros2 {
namespace {

TEST(Names, ANameThatRosTakesStays) { EXPECT_EQ(token_of("heli_2"), "heli_2"); }

TEST(Names, WhatRosDoesNotTakeBecomesUnderscores) {
  EXPECT_EQ(token_of("uav-1"), "uav_1");
  EXPECT_EQ(token_of("a--b"), "a_b");
  EXPECT_EQ(token_of("2nd"), "uav_2nd");
  EXPECT_EQ(token_of(""), "uav_");
}

TEST(Names, TopicsAndTypesAreMangledAsTheMiddlewareOfRosDoes) {
  EXPECT_EQ(topic_of("skein/marvin/fix"), "rt/skein/marvin/fix");
  EXPECT_EQ(type_name<NavSatFix>(), "sensor_msgs::msg::dds_::NavSatFix_");
  EXPECT_EQ(type_name<DiagnosticArray>(), "diagnostic_msgs::msg::dds_::DiagnosticArray_");
}

RC_GTEST_PROP(NamesLaw, EveryTokenIsOneThatRosTakes, (const std::string& name)) {
  static const std::regex kToken("[A-Za-z_][A-Za-z0-9_]*");
  const std::string token = token_of(name);

  RC_ASSERT(std::regex_match(token, kToken));
  RC_ASSERT(token.find("__") == std::string::npos);
  RC_ASSERT(token_of(token) == token);
}

}  // namespace
}  // namespace skein::ros2
