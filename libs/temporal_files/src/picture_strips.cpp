// SPDX-License-Identifier: Apache-2.0
#include "picture_strips.hpp"

#include <algorithm>

namespace skein::temporal {

namespace {

// Where the picture may be cut: between what stands above each other, from left to right.
std::vector<double> cuts_of(const Layout& layout) {
  std::vector<Strip> whole;
  for (const Station& node : layout.nodes) whole.push_back({node.x_in, node.x_out});
  for (const RoutedEdge& edge : layout.edges) {
    const Station& label = edge.stations[edge.label];
    whole.push_back({std::min(label.x_in, label.x_out), std::max(label.x_in, label.x_out)});
  }
  std::sort(whole.begin(), whole.end(),
            [](const Strip& a, const Strip& b) { return a.begin < b.begin; });
  std::vector<double> cuts;
  double end = 0;
  for (const Strip& one : whole) {
    if (one.begin > end) cuts.push_back((end + one.begin) / 2);
    end = std::max(end, one.end);
  }
  return cuts;
}

}  // namespace

std::vector<Strip> strips_of(const Layout& layout, double widest) {
  std::vector<double> cuts = cuts_of(layout);
  cuts.push_back(layout.width);
  std::vector<Strip> strips;
  double begin = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i + 1] - begin <= widest || cuts[i] <= begin) continue;
    strips.push_back({begin, cuts[i]});
    begin = cuts[i];
  }
  strips.push_back({begin, layout.width});
  return strips;
}

}  // namespace skein::temporal
