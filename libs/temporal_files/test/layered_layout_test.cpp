// SPDX-License-Identifier: Apache-2.0
#include "layered_layout.hpp"

#include "picture_strips.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>

namespace skein::temporal {
namespace {

struct Graph {
  std::vector<LayoutBox> nodes;
  std::vector<LayoutEdge> edges;
};

Graph any_graph(bool cyclic) {
  Graph graph;
  const auto count = *rc::gen::inRange<std::uint32_t>(1, 12);
  for (std::uint32_t i = 0; i < count; ++i) {
    graph.nodes.push_back({static_cast<double>(*rc::gen::inRange(20, 120)), 30});
  }
  const int edges = *rc::gen::inRange(0, 25);
  for (int i = 0; i < edges && count > 1; ++i) {
    std::uint32_t from = *rc::gen::inRange<std::uint32_t>(0, count);
    std::uint32_t to = *rc::gen::inRange<std::uint32_t>(0, count);
    if (from == to) continue;
    if (!cyclic && from > to) std::swap(from, to);
    graph.edges.push_back({from, to, {50, 26}});
  }
  return graph;
}

struct Rectangle {
  double left, right, top, bottom;
};

Rectangle around(const Station& station, double height) {
  return {std::min(station.x_in, station.x_out), std::max(station.x_in, station.x_out),
          station.y - height / 2, station.y + height / 2};
}

bool overlap(const Rectangle& a, const Rectangle& b) {
  constexpr double kSlack = 1e-6;
  return a.left < b.right - kSlack && b.left < a.right - kSlack && a.top < b.bottom - kSlack &&
         b.top < a.bottom - kSlack;
}

RC_GTEST_PROP(PictureStrips, AreTheWholePictureAndCutNeitherNodesNorLabels, ()) {
  const Graph graph = any_graph(true);
  const Layout layout = lay_out(graph.nodes, graph.edges, 100'000).value();
  const double widest = *rc::gen::inRange(60, 900);

  const std::vector<Strip> strips = strips_of(layout, widest);

  RC_ASSERT(strips.front().begin == 0);
  RC_ASSERT(strips.back().end == layout.width);
  for (std::size_t i = 1; i < strips.size(); ++i) RC_ASSERT(strips[i].begin == strips[i - 1].end);
  std::vector<Rectangle> all;
  for (const Station& node : layout.nodes) all.push_back(around(node, 30));
  for (const RoutedEdge& edge : layout.edges) all.push_back(around(edge.stations[edge.label], 26));
  for (const Strip& strip : strips) {
    double widest_inside = 0;
    for (const Rectangle& one : all) {
      RC_ASSERT(one.right <= strip.begin || one.left >= strip.begin);
      const bool inside = one.left >= strip.begin && one.right <= strip.end;
      if (inside) widest_inside = std::max(widest_inside, one.right - one.left);
    }
    // Wider than asked for only for one column: there is no more than its gaps beside it.
    RC_ASSERT(strip.width() <= widest || strip.width() < widest_inside + 161);
  }
  if (layout.width <= widest) RC_ASSERT(strips.size() == 1U);
}

RC_GTEST_PROP(LayeredLayout, NoTwoNodesOrLabelsOverlapAndAllAreInThePicture, ()) {
  const Graph graph = any_graph(true);

  const std::optional<Layout> layout = lay_out(graph.nodes, graph.edges, 100'000);

  RC_ASSERT(layout.has_value());
  std::vector<Rectangle> all;
  for (const Station& node : layout->nodes) all.push_back(around(node, 30));
  for (const RoutedEdge& edge : layout->edges) {
    all.push_back(around(edge.stations[edge.label], 26));
    RC_ASSERT(std::abs(all.back().right - all.back().left - 50) < 1e-6);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    RC_ASSERT(all[i].left > -1e-6);
    RC_ASSERT(all[i].right < layout->width + 1e-6);
    RC_ASSERT(all[i].top > -1e-6);
    RC_ASSERT(all[i].bottom < layout->height + 1e-6);
    for (std::size_t j = 0; j < i; ++j) RC_ASSERT(!overlap(all[i], all[j]));
  }
}

RC_GTEST_PROP(LayeredLayout, EdgesOfAGraphWithoutCyclesGoRight, ()) {
  const Graph graph = any_graph(false);

  const Layout layout = lay_out(graph.nodes, graph.edges, 100'000).value();

  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    RC_ASSERT(layout.nodes[graph.edges[i].from].x_out < layout.nodes[graph.edges[i].to].x_in);
  }
}

RC_GTEST_PROP(LayeredLayout, AnEdgeBeginsAndEndsAtTheSidesOfItsNodes, ()) {
  const Graph graph = any_graph(true);

  const Layout layout = lay_out(graph.nodes, graph.edges, 100'000).value();

  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const Station& from = layout.nodes[graph.edges[i].from];
    const Station& to = layout.nodes[graph.edges[i].to];
    const Station& begin = layout.edges[i].stations.front();
    const Station& end = layout.edges[i].stations.back();
    RC_ASSERT(begin.x_out == from.x_out || begin.x_out == from.x_in);
    RC_ASSERT(end.x_in == to.x_in || end.x_in == to.x_out);
    RC_ASSERT(std::abs(begin.y - from.y) <= 15);
    RC_ASSERT(std::abs(end.y - to.y) <= 15);
  }
}

TEST(LayeredLayout, RefusesMoreBendsThanAsked) {
  const std::vector<LayoutBox> nodes(4, LayoutBox{20, 20});
  const std::vector<LayoutEdge> edges{{0, 1, {}}, {1, 2, {}}, {2, 3, {}}, {0, 3, {}}};

  EXPECT_TRUE(lay_out(nodes, edges, 8));
  EXPECT_FALSE(lay_out(nodes, edges, 7));
}

TEST(LayeredLayout, KeepsTwoParallelChainsFromCrossing) {
  const std::vector<LayoutBox> nodes(5, LayoutBox{20, 20});
  const std::vector<LayoutEdge> edges{{0, 1, {}}, {0, 2, {}}, {1, 4, {}}, {2, 3, {}}};

  const Layout layout = lay_out(nodes, edges, 100).value();

  EXPECT_EQ(layout.nodes[1].y < layout.nodes[2].y, layout.nodes[4].y < layout.nodes[3].y);
}

TEST(SpreadApart, LeavesWishesThatAreFarEnoughApart) {
  EXPECT_EQ(spread_apart({0, 10, 30}, {1, 1, 1}, {5, 5}), (std::vector<double>{0, 10, 30}));
}

TEST(SpreadApart, SharesRoomByWeight) {
  EXPECT_EQ(spread_apart({0, 0}, {1, 1}, {10}), (std::vector<double>{-5, 5}));
  EXPECT_EQ(spread_apart({0, 0}, {3, 1}, {8}), (std::vector<double>{-2, 6}));
}

RC_GTEST_PROP(SpreadApart, KeepsTheSeparations, ()) {
  const auto numbers = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-50, 50));
  std::vector<double> wishes(numbers.begin(), numbers.end());
  const std::vector<double> weights(wishes.size(), 1);
  const std::vector<double> separations(wishes.empty() ? 0 : wishes.size() - 1, 7);

  const std::vector<double> values = spread_apart(wishes, weights, separations);

  RC_ASSERT(values.size() == wishes.size());
  for (std::size_t i = 1; i < values.size(); ++i) {
    RC_ASSERT(values[i] - values[i - 1] > 7 - 1e-9);
  }
}

}  // namespace
}  // namespace skein::temporal
