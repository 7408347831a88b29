// SPDX-License-Identifier: Apache-2.0
#include "skein/elementary/parameter_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace skein::elementary {
namespace {

using functional::Parameters;

TEST(ParameterReader, ReadsWhatIsThere) {
  const Parameters parameters =
      Parameters().add("speed", 5).add("device", "ir").add("waypoints", {1, 2, 3, 4, 5, 6});
  ParameterReader read(parameters);

  EXPECT_EQ(read.number("speed"), 5);
  EXPECT_EQ(read.text("device"), "ir");
  ASSERT_EQ(read.points("waypoints").size(), 2u);
  EXPECT_EQ(read.points("waypoints")[1], world::Vector3(4, 5, 6));
  EXPECT_FALSE(read.refused());
}

TEST(ParameterReader, ReadsPointsAsTheyWerePutIn) {
  const std::vector<world::Vector3> points{{1, 2, 3}, {4.5, -5, 6}};
  const Parameters parameters{points_parameter("waypoints", points)};

  EXPECT_EQ(parameters.find("waypoints")->numbers, (std::vector<double>{1, 2, 3, 4.5, -5, 6}));
  EXPECT_EQ(ParameterReader(parameters).points("waypoints"), points);
}

TEST(ParameterReader, WhatIsAbsentIsAbsentInSilence) {
  const Parameters none;
  ParameterReader read(none);

  EXPECT_EQ(read.number("n"), std::nullopt);
  EXPECT_EQ(read.text("t"), std::nullopt);
  EXPECT_TRUE(read.points("p").empty());
  EXPECT_FALSE(read.refused());
}

TEST(ParameterReader, CollectsEveryReason) {
  const Parameters parameters = Parameters()
                                    .add("spede", 5)
                                    .add("device", 3)
                                    .add("device", "ir")
                                    .add("waypoints", {1, 2})
                                    .add("n", std::nan(""));
  ParameterReader read(parameters);

  read.names({"speed", "device", "waypoints", "n"});
  read.text("device");
  read.points("waypoints");
  read.number("n");

  EXPECT_EQ(read.reasons(),
            "unknown parameter 'spede', did you mean 'speed'?; parameter 'device' is given twice; "
            "device must be a text; waypoints must be points of three finite numbers each; "
            "n must be one number");
}

TEST(Figure, IsShort) {
  EXPECT_EQ(figure(3), "3");
  EXPECT_EQ(figure(-0.001), "0");
  EXPECT_EQ(figure(2.5), "2.5");
  EXPECT_EQ(figure(1.237), "1.24");
  EXPECT_EQ(figure(100), "100");
}

}  // namespace
}  // namespace skein::elementary
