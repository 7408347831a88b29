// SPDX-License-Identifier: Apache-2.0
#include "skein/elementary/parameter_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "skein/foundation/random.hpp"

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
            "unknown parameter 'spede'; did you mean 'speed'?; parameter 'device' is given twice; "
            "device must be a text; waypoints must be points of three finite numbers each; "
            "n must be one number");
}

TEST(ParameterReader, ReadsBackAnyPointsBitForBit) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    std::vector<world::Vector3> points(1 + random.below(20));
    for (world::Vector3& point : points)
      point = {random.normal() * 1e6, random.normal() * 1e-6, random.normal()};
    const Parameters parameters{points_parameter("way", points)};

    ParameterReader read(parameters);
    EXPECT_EQ(read.points("way"), points);
    EXPECT_FALSE(read.refused());
  }
}

TEST(ParameterReader, APointLessOrMoreACoordinateIsRefused) {
  for (const std::size_t count : {1U, 2U, 4U, 5U, 7U}) {
    const Parameters parameters = Parameters().add("way", std::vector<double>(count, 1.5));

    ParameterReader read(parameters);
    EXPECT_TRUE(read.points("way").empty());
    EXPECT_EQ(read.reasons(), "way must be points of three finite numbers each") << count;
  }
}

TEST(Figure, QuotesTheValueWhateverItsSize) {
  Random random(2);
  for (int i = 0; i < 10'000; ++i) {
    const double value = random.normal() * std::pow(10, random.uniform(-5, 300));
    const std::string text = figure(value);

    EXPECT_NEAR(std::strtod(text.c_str(), nullptr), value, 0.005 + 1e-5 * std::abs(value)) << text;
    EXPECT_LE(text.size(), 20U) << text;
    EXPECT_NE(text, "-0");
    EXPECT_NE(text.back(), '.') << text;
  }
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
