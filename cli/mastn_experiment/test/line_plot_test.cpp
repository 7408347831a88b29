// SPDX-License-Identifier: Apache-2.0
#include "skein/mastn_experiment/line_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace skein::temporal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

LinePlot two_curves() {
  LinePlot plot;
  plot.title = "Messages";
  plot.x_label = "agents";
  plot.y_label = "messages per perturbation";
  plot.x_ticks = {2, 4, 8, 16};
  plot.series = {{"low", {{2, 1}, {4, 1}, {16, 1}}}, {"high", {{2, 3, 0.5}, {16, 12, 2}}}};
  return plot;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST(LinePlot, DrawsEveryCurveOnceAndOnceInTheLegend) {
  const std::string svg = to_svg(two_curves());

  EXPECT_EQ(count(svg, "<polyline"), 4U);
  EXPECT_EQ(count(svg, "<circle"), 3U + 1U) << "marks of the first series and of its legend";
  EXPECT_THAT(svg, HasSubstr(">messages per perturbation</text>"));
}

TEST(LinePlot, HasOneTickPerValueAskedFor) {
  const std::string svg = to_svg(two_curves());

  for (const char* tick : {">2<", ">4<", ">8<", ">16<"}) EXPECT_THAT(svg, HasSubstr(tick));
  EXPECT_THAT(svg, Not(HasSubstr(">6</text>\n<line x1=\"6")));
}

TEST(LinePlot, ListsTheCurveThatEndsHighestFirst) {
  const std::string svg = to_svg(two_curves());

  EXPECT_LT(svg.find(">high<"), svg.find(">low<"));
}

TEST(LinePlot, ScalesTheAxisToTheTopOfTheErrorBars) {
  const std::string svg = to_svg(two_curves());

  EXPECT_THAT(svg, HasSubstr(">15</text>")) << "12 + 2 in steps of 5";
  EXPECT_THAT(svg, Not(HasSubstr(">20</text>")));
}

TEST(LinePlot, EscapesWhatItIsGiven) {
  LinePlot plot = two_curves();
  plot.title = "a < b & \"c\"";

  EXPECT_THAT(to_svg(plot), HasSubstr("a &lt; b &amp; &quot;c&quot;"));
}

TEST(LinePlot, LeavesOutWhatIsNoNumber) {
  LinePlot plot = two_curves();
  plot.series[0].points.push_back({20, std::numeric_limits<double>::quiet_NaN()});
  plot.series[0].points.push_back({std::numeric_limits<double>::infinity(), 1});

  EXPECT_EQ(to_svg(plot), to_svg(two_curves()));
}

TEST(LinePlot, WithoutPointsIsStillAPicture) {
  const std::string svg = to_svg({});

  EXPECT_THAT(svg, HasSubstr("<svg"));
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace skein::temporal
