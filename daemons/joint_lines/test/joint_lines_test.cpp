// SPDX-License-Identifier: Apache-2.0
#include "skein/joint_lines/joint_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace skein::joint_lines {
namespace {

using ::testing::HasSubstr;

std::string line_with(std::vector<double> numbers) {
  decision_node::NegotiationNoted noted;
  noted.rows = {{"heliv", "relay", std::move(numbers)}};
  return journal::to_json(line_of({MissionTime::seconds(1), "heliv"}, "heliv", noted));
}

TEST(LineOfANegotiation, HasItsNumbersToTheMillisecond) {
  EXPECT_THAT(line_with({12.5, -3.00049}), HasSubstr("heliv relay 12.5 -3"));
}

// Said by a foul offer.
TEST(LineOfANegotiation, CutsNumbersThatNoInstantHolds) {
  constexpr double kMost = std::numeric_limits<double>::max();
  EXPECT_THAT(line_with({kMost, -kMost}),
              HasSubstr("heliv relay 9223372036.854775807 -9223372036.854775808"));
  EXPECT_THAT(line_with({std::numeric_limits<double>::infinity(), std::nan("")}),
              HasSubstr("heliv relay 9223372036.854775807 not a number"));
}

}  // namespace
}  // namespace skein::joint_lines
