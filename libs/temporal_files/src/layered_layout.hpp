// SPDX-License-Identifier: Apache-2.0
// Places the nodes of a directed graph in layers from left to right, with room for a label on each
// edge.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace skein::temporal {

struct LayoutBox {
  double width = 0;
  double height = 0;
};

struct LayoutEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;  ///< not `from`; it comes right of `from` unless that would close a cycle
  LayoutBox label;
};

/// The edge runs level from x_in to x_out at this height; between stations it bends.
struct Station {
  double x_in = 0;
  double x_out = 0;
  double y = 0;
};

struct RoutedEdge {
  std::vector<Station> stations;  ///< from `from` to `to`, ends included
  std::size_t label = 0;          ///< the station whose level part is under the label
};

struct Layout {
  double width = 0;
  double height = 0;
  std::vector<Station> nodes;  ///< left and right side, middle
  std::vector<RoutedEdge> edges;
};

/// Longest-path layers, the first with the first node; crossings kept few by barycentres; labels
/// and nodes do not overlap. Deterministic. Nothing when the picture would have more than
/// `most_bends` bends. Source: Sugiyama, Tagawa, Toda 1981.
std::optional<Layout> lay_out(const std::vector<LayoutBox>& nodes,
                              const std::vector<LayoutEdge>& edges, std::size_t most_bends);

/// The values nearest to the wished ones (least squares) of which each is at least the separation
/// above the one before. Sizes: n wishes and weights, n - 1 separations.
std::vector<double> spread_apart(const std::vector<double>& wishes,
                                 const std::vector<double>& weights,
                                 const std::vector<double>& separations);

}  // namespace skein::temporal
