// SPDX-License-Identifier: Apache-2.0
#include "skein/team_translation/meetings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::translation {
namespace {

TEST(PlanFrontier, ComesBackAsItWent) {
  const temporal::Frontier frontier{
      {{501, {"heliv", "marvin"}, {"marvin"}}},
      {{0, 2, 5, temporal::kInfinite, temporal::kMinusInfinite}, {2, 3, 1, 1, 1}},
      {{2, {{"heliv", 7}, {"marvin", 8}}}, {3, {{"heliv", 7}}}}};

  const wire::PlanFrontier sample = to_wire("marvin", frontier);

  EXPECT_EQ(sample.uav, "marvin");
  EXPECT_EQ(from_wire(sample), frontier);
}

TEST(PlanFrontier, ThatIsNoneIsRefusedWithTheReason) {
  wire::PlanFrontier sample;
  sample.arcs.push_back({0, 7000, 1, 1, 1});

  const auto read = from_wire(sample);

  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().why, ::testing::HasSubstr("names a node that is not there"));
}

}  // namespace
}  // namespace skein::translation
