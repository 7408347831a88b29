// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal_files/drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "skein/temporal_files/network_text.hpp"
#include "skein/temporal_lab/mastn_generator.hpp"
#include "xml_document.hpp"

namespace skein::temporal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr Ticks kSecond = kTicksPerSecond;

Stnu small() {
  return {{"v0", "start", "end \"<&>\\"},
          0,
          {{0, 1, 0, kInfinite}, {0, 2, kMinusInfinite, 5 * kSecond}},
          {{1, 2, 2 * kSecond, 7 * kSecond}}};
}

std::size_t count(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), expression), {}));
}

bool is_well_formed(const std::string& svg) {
  Problems problems("");
  return parse_xml(svg, problems).has_value();
}

TEST(BoundsText, IsShort) {
  EXPECT_EQ(bounds_text(kSecond, 3 * kSecond / 2), "[1, 1.5]");
  EXPECT_EQ(bounds_text(-kSecond, kInfinite), "≥ -1");
  EXPECT_EQ(bounds_text(kMinusInfinite, 0), "≤ 0");
  EXPECT_EQ(bounds_text(1, 1), "= 0.000000001");
  EXPECT_EQ(bounds_text(kMinusInfinite, kInfinite), "free");
}

TEST(DrawDot, HasANodeAndAnEdgeForEach) {
  const std::string dot = draw_dot(small(), {});

  EXPECT_EQ(count(dot, R"(\n  n\d+ \[)"), 3U);
  EXPECT_EQ(count(dot, R"( -> )"), 3U);
  EXPECT_THAT(dot, HasSubstr(R"(label="end \"<&>\\")"));
  EXPECT_THAT(dot, HasSubstr(R"(n1 -> n2 [label="[2, 7]")"));
  EXPECT_EQ(count(dot, "n1 -> n2.*style=dashed"), 1U);
  EXPECT_EQ(count(dot, "penwidth"), 0U);
}

TEST(DrawDot, ShowsTheConflictInRed) {
  DrawingOptions options;
  options.conflict = {{LinkKind::kRequirement, 1}, {LinkKind::kContingent, 0}};

  const std::string dot = draw_dot(small(), options);

  EXPECT_EQ(count(dot, "penwidth=2.5"), 2U);
  EXPECT_EQ(count(dot, "n0 -> n1.*#c8102e"), 0U);
}

TEST(DrawDot, DrawsALinkThatGoesBackwardsInTimeForwards) {
  const std::string dot = draw_dot({{"v0", "a"}, 0, {{1, 0, -2 * kSecond, -kSecond}}, {}}, {});

  EXPECT_THAT(dot, HasSubstr(R"(n0 -> n1 [label="[-2, -1]")"));
  EXPECT_THAT(dot, HasSubstr("dir=back"));
}

TEST(DrawSvg, IsWellFormedAndShowsEverything) {
  DrawingOptions options;
  options.title = "a <small> one";
  options.windows = {{0, 0}, {0, 3 * kSecond}, {2 * kSecond, kInfinite}};

  const std::string svg = draw_svg(small(), options).value();

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("a &lt;small&gt; one"));
  EXPECT_THAT(svg, HasSubstr("end &quot;&lt;&amp;&gt;\\"));
  EXPECT_THAT(svg, HasSubstr(">0 … 3<"));
  EXPECT_THAT(svg, HasSubstr(">2 … ∞<"));
  EXPECT_THAT(svg, HasSubstr(">≥ 0<"));
  EXPECT_THAT(svg, HasSubstr(">[2, 7]<"));
  EXPECT_THAT(svg, Not(HasSubstr("#c8102e")));
}

TEST(DrawSvg, DashesContingentLinksAndReddensTheConflict) {
  DrawingOptions options;
  options.conflict = {{LinkKind::kRequirement, 1}, {LinkKind::kContingent, 0}};

  const std::string svg = draw_svg(small(), options).value();

  // Both links and the legend; the links' arrows; their labels; the nodes they join.
  EXPECT_EQ(count(svg, "stroke=\"#c8102e\" stroke-width=\"2.4\""), 2U);
  EXPECT_EQ(count(svg, "Z\" fill=\"#c8102e\""), 2U);
  EXPECT_EQ(count(svg, "stroke=\"#c8102e\" stroke-width=\"2.2\""), 3U);
  EXPECT_THAT(svg, HasSubstr(">conflict<"));
  EXPECT_EQ(count(svg, "<path [^>]*stroke-width=\"2.4\" stroke-dasharray"), 1U);
}

TEST(DrawSvg, DrawsTheOriginFirstWhereverItIsInTheList) {
  const Stnu last{{"a", "b", "v0"}, 2, {{2, 0, 0, kSecond}, {0, 1, 0, kSecond}}, {}};

  const std::string svg = draw_svg(last, {}).value();

  const auto x_of = [&](const std::string& name) {
    std::smatch match;
    std::regex_search(svg, match, std::regex("x=\"([0-9.]+)\"[^>]*>" + name + "<"));
    return std::stod(match[1]);
  };
  EXPECT_LT(x_of("v0"), x_of("a"));
  EXPECT_LT(x_of("a"), x_of("b"));
}

TEST(DrawSvg, DrawsAnyShape) {
  EXPECT_TRUE(is_well_formed(draw_svg({{"v0"}, 0, {}, {}}, {}).value()));
  EXPECT_TRUE(is_well_formed(draw_svg({{"v0", "a", "b"}, 0, {}, {}}, {}).value()));
  const Stnu cycle{{"v0", "a", "b"}, 0, {{0, 1}, {1, 2}, {2, 0}, {1, 0}}, {{1, 2, 1, 2}}};
  EXPECT_TRUE(is_well_formed(draw_svg(cycle, {}).value()));
}

TEST(DrawSvg, DrawsHundredsOfNodesAndRefusesThousands) {
  const Stnu hundreds = without_agents(generate_mastn({8, 20, 10, 4}, 1));
  Stnu thousands = hundreds;
  for (int i = 0; i < 1000; ++i) thousands.nodes.push_back("extra" + std::to_string(i));

  EXPECT_TRUE(is_well_formed(draw_svg(hundreds, {}).value()));
  EXPECT_THAT(draw_svg(thousands, {}).error().why, HasSubstr("1161 nodes are too many"));
}

TEST(DrawSvg, RefusesATangle) {
  Stnu chain{{"v0"}, 0, {}, {}};
  for (NodeIndex i = 1; i < 400; ++i) {
    chain.nodes.push_back("n" + std::to_string(i));
    chain.arcs.push_back({i - 1, i, 0, kSecond});
    chain.arcs.push_back({0, i, 0, kInfinite});
  }

  EXPECT_THAT(draw_svg(chain, {}).error().why, HasSubstr("too many long links"));
}

TEST(DrawSvg, IsTheSameEachTime) {
  const Stnu network = without_agents(generate_mastn({3, 6, 4, 2}, 5));

  EXPECT_EQ(draw_svg(network, {}).value(), draw_svg(network, {}).value());
}

}  // namespace
}  // namespace skein::temporal
