// SPDX-License-Identifier: Apache-2.0
// What a series came to is counted by law.
#include "skein/storm_tool/series.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace skein::storm_tool {
namespace {

TEST(Series, CountsMissionsByLaw) {
  Series series;
  Verdict broken;
  broken.violations = {
      {"energy", 1, "marvin", 0, ""}, {"energy", 2, "heliv", 0, ""}, {"held", 3, "heliv", 7, ""}};
  series.add({"1", "", ""}, broken);
  series.add({"2", "", ""}, {});

  EXPECT_EQ(series.missions, 2);
  EXPECT_EQ(series.broken, 1);
  EXPECT_EQ(series.rows.at("energy").missions, 1);
  EXPECT_EQ(series.rows.at("energy").violations, 2);
  EXPECT_THAT(series.rows.at("held").examples, ::testing::ElementsAre("1"));
}

TEST(Series, SaysADistanceOnlyWhereTwoWereInTheAir) {
  const auto said = [](double nearest) {
    Verdict verdict;
    verdict.nearest = nearest;
    Series series;
    series.add({"1", "", ""}, verdict);
    std::ostringstream out;
    print(out, series, 3);
    return out.str();
  };

  EXPECT_THAT(said(12.5), ::testing::HasSubstr("; least distance in the air 12.5 m; 0 missions"));
  EXPECT_THAT(said(-1), ::testing::HasSubstr("0 failed; 0 missions break a law"));
}

}  // namespace
}  // namespace skein::storm_tool
