// SPDX-License-Identifier: Apache-2.0
#include "layered_layout.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace skein::temporal {

namespace {

constexpr int kOrderSweeps = 24;
constexpr int kHeightSweeps = 48;
constexpr double kNodeGap = 18;      ///< between two boxes of a layer
constexpr double kBendGap = 7;       ///< beside an edge that passes
constexpr double kLayerGap = 16;     ///< between layers, for edges that run level
constexpr double kSteepness = 0.14;  ///< more room for edges that climb
constexpr double kWidestGap = 80;
constexpr double kPortGap = 7;

using Index = std::uint32_t;

/// A node, or the place of an edge in a layer that it crosses.
struct Item {
  std::size_t layer = 0;
  LayoutBox box;
  bool is_node = false;
  double x = 0;
  double y = 0;
  std::vector<Index> left;
  std::vector<Index> right;
};

class LayeredLayout {
 public:
  LayeredLayout(const std::vector<LayoutBox>& nodes, const std::vector<LayoutEdge>& edges)
      : boxes_(nodes), edges_(edges), reversed_(edges.size(), false), rank_(nodes.size(), 0) {}

  std::optional<Layout> run(std::size_t most_bends) {
    break_cycles();
    rank();
    if (bends() > most_bends) return std::nullopt;
    make_items();
    order();
    place_vertically();
    place_horizontally();
    return result();
  }

 private:
  Index left_end(std::size_t edge) const {
    return reversed_[edge] ? edges_[edge].to : edges_[edge].from;
  }
  Index right_end(std::size_t edge) const {
    return reversed_[edge] ? edges_[edge].from : edges_[edge].to;
  }

  std::vector<std::vector<std::size_t>> edges_from_nodes() const {
    std::vector<std::vector<std::size_t>> leaving(boxes_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) leaving[left_end(i)].push_back(i);
    return leaving;
  }

  // Depth first; an edge back to a node that is still open is turned round.
  void break_cycles() {
    enum class Visit { kNone, kOpen, kDone };
    const std::vector<std::vector<std::size_t>> leaving = edges_from_nodes();
    std::vector<Visit> visit(boxes_.size(), Visit::kNone);
    for (Index root = 0; root < boxes_.size(); ++root) {
      if (visit[root] != Visit::kNone) continue;
      std::vector<std::pair<Index, std::size_t>> path{{root, 0}};
      visit[root] = Visit::kOpen;
      while (!path.empty()) {
        auto& [node, next] = path.back();
        if (next == leaving[node].size()) {
          visit[node] = Visit::kDone;
          path.pop_back();
          continue;
        }
        const std::size_t edge = leaving[node][next++];
        const Index to = edges_[edge].to;
        if (visit[to] == Visit::kOpen) reversed_[edge] = true;
        if (visit[to] != Visit::kNone) continue;
        visit[to] = Visit::kOpen;
        path.emplace_back(to, 0);
      }
    }
  }

  // Longest paths; then nodes that nothing precedes go as near to what follows as they can.
  void rank() {
    const std::vector<std::vector<std::size_t>> leaving = edges_from_nodes();
    std::vector<std::size_t> waiting(boxes_.size(), 0);
    for (std::size_t i = 0; i < edges_.size(); ++i) ++waiting[right_end(i)];
    std::vector<Index> ready;
    for (Index node = 0; node < boxes_.size(); ++node) {
      if (waiting[node] == 0) ready.push_back(node);
    }
    const std::vector<Index> sources = ready;
    for (std::size_t i = 0; i < ready.size(); ++i) {
      for (const std::size_t edge : leaving[ready[i]]) {
        const Index to = right_end(edge);
        rank_[to] = std::max(rank_[to], rank_[ready[i]] + 1);
        if (--waiting[to] == 0) ready.push_back(to);
      }
    }
    for (const Index node : sources) {
      if (node == 0 || leaving[node].empty()) continue;
      std::size_t nearest = rank_[right_end(leaving[node].front())];
      for (const std::size_t edge : leaving[node])
        nearest = std::min(nearest, rank_[right_end(edge)]);
      rank_[node] = nearest - 1;
    }
  }

  std::size_t bends() const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      sum += 2 * (rank_[right_end(i)] - rank_[left_end(i)]) - 1;
    }
    return sum;
  }

  // Nodes stand in even layers, labels in odd ones.
  void make_items() {
    for (Index node = 0; node < boxes_.size(); ++node) {
      add_item({2 * rank_[node], boxes_[node], true, 0, 0, {}, {}});
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const std::size_t first = 2 * rank_[left_end(i)] + 1;
      const std::size_t last = 2 * rank_[right_end(i)] - 1;
      const std::size_t middle = first + (last - first) / 4 * 2;
      std::vector<Index>& chain = chains_.emplace_back();
      Index before = left_end(i);
      for (std::size_t layer = first; layer <= last; ++layer) {
        const LayoutBox box = layer == middle ? edges_[i].label : LayoutBox{};
        chain.push_back(add_item({layer, box, false, 0, 0, {}, {}}));
        join(before, chain.back());
        before = chain.back();
      }
      join(before, right_end(i));
      label_of_.push_back((middle - first));
    }
  }

  Index add_item(Item item) {
    if (layers_.size() <= item.layer) layers_.resize(item.layer + 1);
    const auto index = static_cast<Index>(items_.size());
    layers_[item.layer].push_back(index);
    items_.push_back(std::move(item));
    return index;
  }

  void join(Index left, Index right) {
    items_[left].right.push_back(right);
    items_[right].left.push_back(left);
  }

  // --- order within layers -----------------------------------------------------------------------

  void order() {
    std::vector<std::vector<Index>> best = layers_;
    std::size_t fewest = crossings();
    for (int sweep = 0; sweep < kOrderSweeps && fewest > 0; ++sweep) {
      const bool rightwards = sweep % 2 == 0;
      for (std::size_t i = 1; i < layers_.size(); ++i) {
        sort_layer(rightwards ? i : layers_.size() - 1 - i, rightwards);
      }
      const std::size_t now = crossings();
      if (now >= fewest) continue;
      fewest = now;
      best = layers_;
    }
    layers_ = std::move(best);
  }

  std::vector<std::size_t> positions() const {
    std::vector<std::size_t> position(items_.size(), 0);
    for (const std::vector<Index>& layer : layers_) {
      for (std::size_t i = 0; i < layer.size(); ++i) position[layer[i]] = i;
    }
    return position;
  }

  // By the mean position of the neighbours on the side that is settled.
  void sort_layer(std::size_t layer, bool by_left) {
    const std::vector<std::size_t> position = positions();
    std::vector<std::pair<double, Index>> keyed;
    for (const Index item : layers_[layer]) {
      const std::vector<Index>& neighbours = by_left ? items_[item].left : items_[item].right;
      double sum = 0;
      for (const Index neighbour : neighbours) sum += static_cast<double>(position[neighbour]);
      keyed.emplace_back(neighbours.empty() ? static_cast<double>(position[item])
                                            : sum / static_cast<double>(neighbours.size()),
                         item);
    }
    std::stable_sort(keyed.begin(), keyed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < keyed.size(); ++i) layers_[layer][i] = keyed[i].second;
  }

  std::size_t crossings() const {
    const std::vector<std::size_t> position = positions();
    std::size_t sum = 0;
    for (std::size_t layer = 0; layer + 1 < layers_.size(); ++layer) {
      std::vector<std::size_t> ends;
      for (const Index item : layers_[layer]) {
        const std::size_t begin = ends.size();
        for (const Index right : items_[item].right) ends.push_back(position[right]);
        std::sort(ends.begin() + static_cast<std::ptrdiff_t>(begin), ends.end());
      }
      sum += inversions(ends, layers_[layer + 1].size());
    }
    return sum;
  }

  // Pairs in the wrong order, by a tree of counts.
  static std::size_t inversions(const std::vector<std::size_t>& values, std::size_t size) {
    std::vector<std::size_t> tree(size + 1, 0);
    std::size_t sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      std::size_t not_greater = 0;
      for (std::size_t at = values[i] + 1; at > 0; at &= at - 1) not_greater += tree[at];
      sum += i - not_greater;
      for (std::size_t at = values[i] + 1; at <= size; at += at & (~at + 1)) ++tree[at];
    }
    return sum;
  }

  // --- coordinates -------------------------------------------------------------------------------

  void place_vertically() {
    for (const std::vector<Index>& layer : layers_) {
      double y = 0;
      for (std::size_t i = 0; i < layer.size(); ++i) {
        if (i > 0) y += separation(layer[i - 1], layer[i]);
        items_[layer[i]].y = y;
      }
      for (const Index item : layer) items_[item].y -= y / 2;
    }
    for (int sweep = 0; sweep < kHeightSweeps; ++sweep) {
      for (std::size_t i = 0; i < layers_.size(); ++i) {
        settle(layers_[sweep % 2 == 0 ? i : layers_.size() - 1 - i]);
      }
    }
  }

  double separation(Index above, Index below) const {
    const double gap = items_[above].is_node && items_[below].is_node ? kNodeGap : kBendGap;
    return (items_[above].box.height + items_[below].box.height) / 2 + gap;
  }

  // As near to the neighbours as the order of the layer lets.
  void settle(const std::vector<Index>& layer) {
    std::vector<double> wishes;
    std::vector<double> weights;
    std::vector<double> separations;
    for (std::size_t i = 0; i < layer.size(); ++i) {
      const Item& item = items_[layer[i]];
      double sum = 0;
      double weight = 0;
      for (const std::vector<Index>* side : {&item.left, &item.right}) {
        for (const Index neighbour : *side) {
          const double pull = items_[neighbour].is_node || item.is_node ? 1 : 3;
          sum += pull * items_[neighbour].y;
          weight += pull;
        }
      }
      wishes.push_back(weight > 0 ? sum / weight : item.y);
      weights.push_back(std::max(weight, 0.1));
      if (i > 0) separations.push_back(separation(layer[i - 1], layer[i]));
    }
    const std::vector<double> heights = spread_apart(wishes, weights, separations);
    for (std::size_t i = 0; i < layer.size(); ++i) items_[layer[i]].y = heights[i];
  }

  void place_horizontally() {
    double x = 0;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      double width = 0;
      double climb = 0;
      for (const Index item : layers_[i]) {
        width = std::max(width, items_[item].box.width);
        for (const Index left : items_[item].left) {
          climb = std::max(climb, std::abs(items_[left].y - items_[item].y));
        }
      }
      if (i > 0) x += std::min(kLayerGap + kSteepness * climb, kWidestGap);
      for (const Index item : layers_[i]) items_[item].x = x + width / 2;
      x += width;
    }
    width_ = x;
  }

  Layout result() {
    double top = 0;
    double bottom = 0;
    for (const Item& item : items_) {
      top = std::min(top, item.y - item.box.height / 2);
      bottom = std::max(bottom, item.y + item.box.height / 2);
    }
    for (Item& item : items_) item.y -= top;
    Layout layout;
    layout.width = width_;
    layout.height = bottom - top;
    for (Index node = 0; node < boxes_.size(); ++node) layout.nodes.push_back(station(node));
    for (std::size_t i = 0; i < edges_.size(); ++i) layout.edges.push_back(route(i));
    return layout;
  }

  Station station(Index item) const {
    const double half = items_[item].box.width / 2;
    return {items_[item].x - half, items_[item].x + half, items_[item].y};
  }

  // Edges that meet at one side of a node are a little apart, in the order of where they go.
  double port(Index node, Index towards, const std::vector<Index>& side) const {
    std::size_t above = 0;
    for (const Index other : side) above += items_[other].y < items_[towards].y ? 1 : 0;
    const auto count = static_cast<double>(side.size());
    const double gap = std::min(kPortGap, 0.7 * items_[node].box.height / count);
    return items_[node].y + (static_cast<double>(above) - (count - 1) / 2) * gap;
  }

  RoutedEdge route(std::size_t edge) const {
    const std::vector<Index>& chain = chains_[edge];
    const Index left = left_end(edge);
    const Index right = right_end(edge);
    RoutedEdge routed;
    routed.label = label_of_[edge] + 1;
    const double from_x = station(left).x_out;
    routed.stations.push_back({from_x, from_x, port(left, chain.front(), items_[left].right)});
    for (const Index item : chain) routed.stations.push_back(station(item));
    const double to_x = station(right).x_in;
    routed.stations.push_back({to_x, to_x, port(right, chain.back(), items_[right].left)});
    if (!reversed_[edge]) return routed;
    std::reverse(routed.stations.begin(), routed.stations.end());
    for (Station& one : routed.stations) std::swap(one.x_in, one.x_out);
    routed.label = routed.stations.size() - 1 - routed.label;
    return routed;
  }

  const std::vector<LayoutBox>& boxes_;
  const std::vector<LayoutEdge>& edges_;
  std::vector<bool> reversed_;
  std::vector<std::size_t> rank_;
  std::vector<Item> items_;  ///< the nodes first
  std::vector<std::vector<Index>> chains_;
  std::vector<std::size_t> label_of_;  ///< position in the chain
  std::vector<std::vector<Index>> layers_;
  double width_ = 0;
};

}  // namespace

std::optional<Layout> lay_out(const std::vector<LayoutBox>& nodes,
                              const std::vector<LayoutEdge>& edges, std::size_t most_bends) {
  return LayeredLayout(nodes, edges).run(most_bends);
}

// Neighbours that want the same room are pooled, until no two pools do.
std::vector<double> spread_apart(const std::vector<double>& wishes,
                                 const std::vector<double>& weights,
                                 const std::vector<double>& separations) {
  struct Pool {
    double mean;
    double weight;
    std::size_t size;
  };
  std::vector<double> offsets(wishes.size(), 0);
  for (std::size_t i = 1; i < wishes.size(); ++i) offsets[i] = offsets[i - 1] + separations[i - 1];
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    pools.push_back({wishes[i] - offsets[i], weights[i], 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean > pools.back().mean) {
      const Pool last = pools.back();
      pools.pop_back();
      Pool& pool = pools.back();
      pool.mean = (pool.mean * pool.weight + last.mean * last.weight) / (pool.weight + last.weight);
      pool.weight += last.weight;
      pool.size += last.size;
    }
  }
  std::vector<double> values;
  for (const Pool& pool : pools) {
    for (std::size_t i = 0; i < pool.size; ++i)
      values.push_back(pool.mean + offsets[values.size()]);
  }
  return values;
}

}  // namespace skein::temporal
