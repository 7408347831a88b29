// SPDX-License-Identifier: Apache-2.0
// Figures of many runs: how they are spread, and the picture of it.
#include "skein/report/distributions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace skein::report {
namespace {

using ::testing::HasSubstr;

TEST(SpreadOf, NothingCountsNothing) { EXPECT_EQ(spread_of({}).count, 0U); }

TEST(SpreadOf, OneFigureIsThatFigure) {
  const Spread spread = spread_of({7});

  EXPECT_EQ(spread.mean, 7);
  EXPECT_EQ(spread.deviation, 0);
  EXPECT_EQ(spread.p95, 7);
}

// Figures of R: quantile(c(1, 2, 4, 8, 16), c(.25, .5, .75, .95)), sd(c(1, 2, 4, 8, 16)).
TEST(SpreadOf, IsWhatStatisticiansSay) {
  const Spread spread = spread_of({16, 1, 8, 2, 4});

  EXPECT_EQ(spread.count, 5U);
  EXPECT_DOUBLE_EQ(spread.mean, 6.2);
  EXPECT_NEAR(spread.deviation, 6.09918, 1e-5);
  EXPECT_EQ(spread.minimum, 1);
  EXPECT_EQ(spread.lower_quartile, 2);
  EXPECT_EQ(spread.median, 4);
  EXPECT_EQ(spread.upper_quartile, 8);
  EXPECT_DOUBLE_EQ(spread.p95, 14.4);
  EXPECT_EQ(spread.maximum, 16);
}

RC_GTEST_PROP(SpreadOf, HalfTheFiguresAreOnEachSideOfTheMedian, (std::vector<short> given)) {
  RC_PRE(!given.empty());
  const std::vector<double> values(given.begin(), given.end());
  const Spread spread = spread_of(values);
  const auto below = static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [&](double v) { return v <= spread.median; }));
  const auto above = static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [&](double v) { return v >= spread.median; }));

  RC_ASSERT(2 * below >= values.size());
  RC_ASSERT(2 * above >= values.size());
  RC_ASSERT(spread.minimum <= spread.lower_quartile && spread.lower_quartile <= spread.median);
  RC_ASSERT(spread.median <= spread.upper_quartile && spread.upper_quartile <= spread.maximum);
  RC_ASSERT(spread.minimum - 1e-9 <= spread.mean && spread.mean <= spread.maximum + 1e-9);
}

TEST(DistributionsSvg, HasADotForEveryFigureAndABoxForEveryRow) {
  const std::string svg = distributions_svg(
      "batch", {{"mission-duration", "s", {{"confirmed", {700, 720, 790}}, {"infirmed", {950}}}}});
  const auto count = [&](const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = svg.find(what, at)) != std::string::npos; ++at) ++n;
    return n;
  };

  EXPECT_EQ(count("<circle"), 4U);
  EXPECT_EQ(count("fill=\"none\""), 2U);
  EXPECT_THAT(svg, HasSubstr(">confirmed<"));
  EXPECT_THAT(svg, HasSubstr(">n 3<"));
}

TEST(DistributionsSvg, EscapesNamesOfOthers) {
  const std::string svg = distributions_svg("<script>", {{"a&b", "", {{"\"<x>", {1}}}}});

  EXPECT_EQ(svg.find("<script>"), std::string::npos);
  EXPECT_THAT(svg, HasSubstr("a&amp;b"));
}

TEST(DistributionsSvg, IsAPictureAlsoOfNothing) {
  EXPECT_THAT(distributions_svg("none", {}), HasSubstr("</svg>"));
  EXPECT_THAT(distributions_svg("empty", {{"m", "", {{"r", {}}}}}), HasSubstr("n 0"));
}

}  // namespace
}  // namespace skein::report
