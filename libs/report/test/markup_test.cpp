// SPDX-License-Identifier: Apache-2.0
#include "markup.hpp"

#include <gtest/gtest.h>

#include "plot.hpp"

namespace skein::report {
namespace {

TEST(Markup, ElementsNestAndClose) {
  Markup out;

  out.open("g", {{"class", "a"}}).leaf("rect", {{"x", 1.5}, {"y", 2}}).title("t").close();

  EXPECT_EQ(out.take(), "<g class=\"a\"><rect x=\"1.5\" y=\"2\"/><title>t</title></g>");
}

TEST(Markup, TextAndValuesAreEscaped) {
  Markup out;

  out.element("p", {{"title", "\"><script>"}}, "a<b&c");

  EXPECT_EQ(out.take(), "<p title=\"&quot;&gt;&lt;script&gt;\">a&lt;b&amp;c</p>");
}

TEST(Markup, NumbersAreShort) {
  Markup out;

  out.leaf("circle", {{"r", 1.0 / 3.0}, {"n", std::size_t{7}}});

  EXPECT_EQ(out.take(), "<circle r=\"0.33\" n=\"7\"/>");
}

TEST(MarkupDeathTest, AnElementLeftOpenIsADefect) {
  EXPECT_DEATH(
      {
        Markup out;
        out.open("g");
        out.take();
      },
      "open_.empty");
}

TEST(MarkupDeathTest, ClosingNothingIsADefect) { EXPECT_DEATH(Markup().close(), "open_.empty"); }

TEST(PathData, MovesThenDrawsLines) {
  const std::vector<Point> points{{0, 0}, {1.25, 2}, {3, -4}};

  EXPECT_EQ(path_data(points), "M0 0L1.2 2L3 -4");
  EXPECT_EQ(path_data(points, 2), "M0 0L1.25 2L3 -4");
  EXPECT_EQ(path_data(std::vector<Point>{}), "");
}

}  // namespace
}  // namespace skein::report
